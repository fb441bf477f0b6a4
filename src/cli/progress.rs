//! A progress bar on a terminal, silence in a pipe, and Ctrl-C.

use crate::error::Error;
use indicatif::{ProgressBar, ProgressStyle};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Counts poses on standard error; hidden when that is not a terminal.
pub(super) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar of `poses` steps. From here on Ctrl-C ends the work at the next pose instead of the process.
    pub fn start(poses: usize) -> Progress {
        // A second call in one process finds the handler in place: that is as good.
        let _ = ctrlc::set_handler(|| INTERRUPTED.store(true, Ordering::Relaxed));
        let bar = ProgressBar::new(poses as u64);
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} poses, {eta} left") {
            bar.set_style(style);
        }
        Progress { bar }
    }

    /// A sign of life for work whose length is not known beforehand, with what is being done.
    pub fn working() -> Progress {
        let _ = ctrlc::set_handler(|| INTERRUPTED.store(true, Ordering::Relaxed));
        let bar = ProgressBar::new_spinner();
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress { bar }
    }

    /// Says what is being done now; an error when the user wants to stop.
    pub fn now(&self, doing: &str) -> Result<(), Error> {
        self.bar.set_message(doing.to_owned());
        match self.tick() {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Error::Interrupted),
        }
    }

    /// One pose begun; a break when the user wants to stop.
    pub fn tick(&self) -> ControlFlow<()> {
        self.bar.inc(1);
        if INTERRUPTED.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Takes the bar away.
    ///
    /// # Errors
    /// [`Error::Interrupted`] when Ctrl-C came during the last pose.
    pub fn finish(&self) -> Result<(), Error> {
        self.bar.finish_and_clear();
        match self.tick() {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Error::Interrupted),
        }
    }
}

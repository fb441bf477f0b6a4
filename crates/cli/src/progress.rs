//! A progress bar on a terminal; nothing in a pipe.

use super::console::is_quiet;
use crate::error::Error;
use gearlash::analysis::{self, Analysis, Plan};
use indicatif::{ProgressBar, ProgressStyle};
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// The bar on screen, for the thread that ends the process.
static SHOWN: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Removes the bar from the screen.
pub(super) fn clear() {
    let shown = SHOWN.lock().unwrap_or_else(PoisonError::into_inner).take();
    if let Some(bar) = shown {
        bar.finish_and_clear();
    }
}

/// Counts steps on standard error; hidden without a terminal. Dropping it removes the bar.
pub(super) struct Progress(ProgressBar);

impl Progress {
    /// No bar: for a terminal that shows the growing result, or with --quiet.
    pub fn none() -> Progress {
        Progress(ProgressBar::hidden())
    }

    /// A bar for `steps`, which are called `named`. The current work appears beside it where there is room.
    pub fn of(steps: u64, named: &str) -> Progress {
        if is_quiet() {
            return Progress::none();
        }
        Progress::shown(ProgressBar::new(steps), &with_estimate(named))
    }

    /// A spinner for work of unknown length, with the current work beside it.
    pub fn working() -> Progress {
        if is_quiet() {
            return Progress::none();
        }
        let bar = ProgressBar::new_spinner();
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress::shown(bar, "{spinner} {msg}")
    }

    fn shown(bar: ProgressBar, template: &str) -> Progress {
        *SHOWN.lock().unwrap_or_else(PoisonError::into_inner) = Some(bar.clone());
        let progress = Progress(bar);
        progress.set_template(template);
        progress
    }

    fn set_template(&self, template: &str) {
        if let Ok(style) = ProgressStyle::with_template(template) {
            self.0.set_style(style);
        }
    }

    /// Shows the current work.
    pub fn now(&self, doing: &str) {
        self.0.set_message(doing.to_owned());
    }

    /// Does `work` whose steps take very different times, as searches of a mesh cycle do. The time since the start is shown meanwhile.
    pub fn searching<T>(&self, work: impl FnOnce() -> T) -> T {
        self.show_estimate(false);
        let found = work();
        self.show_estimate(true);
        found
    }

    /// Shows the remaining time, or that since the start.
    fn show_estimate(&self, estimates: bool) {
        if estimates {
            self.set_template(&with_estimate("steps"));
        } else {
            self.0.enable_steady_tick(Duration::from_secs(1));
            self.set_template("{bar:40} {pos}/{len} steps, {elapsed} {wide_msg}");
        }
        self.0.reset_eta();
    }

    /// Adds steps that turned out to be needed.
    pub fn more(&self, steps: usize) {
        self.0.inc_length(steps as u64);
    }

    /// Counts `steps`. It never breaks the work: a signal ends the process from a thread of its own.
    pub fn tick(&self, steps: u64) -> ControlFlow<()> {
        self.0.inc(steps);
        ControlFlow::Continue(())
    }
}

/// Template of a bar with the remaining time at the current speed.
fn with_estimate(named: &str) -> String {
    format!("{{bar:40}} {{pos}}/{{len}} {named}, {{eta}} left {{wide_msg}}")
}

/// Does the work of `plan` under a bar of its length.
pub(super) fn run_under_bar<'a>(plan: &Plan<'a>) -> Result<Analysis<'a>, Error> {
    let bar = Progress::of(plan.steps()?, "steps");
    let mut stage = |doing: &str| {
        bar.show_estimate(false);
        bar.now(doing);
    };
    let tick = |steps| bar.tick(steps);
    let mut progress = analysis::Progress {
        stage: &mut stage,
        tick: &tick,
    };
    Ok(Analysis::run(plan, &mut progress)?)
}

impl Drop for Progress {
    fn drop(&mut self) {
        clear();
    }
}

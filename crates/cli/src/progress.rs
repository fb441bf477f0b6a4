//! A progress bar on a terminal, silence in a pipe.

use super::console::is_quiet;
use crate::error::Error;
use gearlash::analysis::{self, Analysis, Plan};
use indicatif::{ProgressBar, ProgressStyle};
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// The bar that is shown, for whoever ends the process.
static SHOWN: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Takes the bar that is shown away.
pub(super) fn clear() {
    let shown = SHOWN.lock().unwrap_or_else(PoisonError::into_inner).take();
    if let Some(bar) = shown {
        bar.finish_and_clear();
    }
}

/// Counts steps on standard error; hidden when that is not a terminal. Dropped, it is gone.
pub(super) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar of so many `poses`.
    pub fn start(poses: u64) -> Progress {
        Progress::of(poses, "poses")
    }

    /// No bar: for a terminal on which the result itself appears, or with --quiet.
    pub fn none() -> Progress {
        Progress {
            bar: ProgressBar::hidden(),
        }
    }

    /// A bar of so many `steps`, and what a step is called; beside it, as far as there is room, what is being done.
    pub fn of(steps: u64, named: &str) -> Progress {
        if is_quiet() {
            return Progress::none();
        }
        let bar = ProgressBar::new(steps);
        Progress::shown(bar, &with_estimate(named))
    }

    /// A sign of life for work whose length is not known beforehand, with what is being done.
    pub fn working() -> Progress {
        if is_quiet() {
            return Progress::none();
        }
        let bar = ProgressBar::new_spinner();
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress::shown(bar, "{spinner} {msg}")
    }

    fn shown(bar: ProgressBar, template: &str) -> Progress {
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        *SHOWN.lock().unwrap_or_else(PoisonError::into_inner) = Some(bar.clone());
        Progress { bar }
    }

    /// Says what is being done now.
    pub fn now(&self, doing: &str) {
        self.bar.set_message(doing.to_owned());
    }

    /// Does `work` whose steps take unlike times, as searches of a mesh cycle do: no time is promised meanwhile.
    pub fn searching<T>(&self, work: impl FnOnce() -> T) -> T {
        self.promises(false);
        let found = work();
        self.promises(true);
        found
    }

    /// Whether the time that is left is said.
    fn promises(&self, estimates: bool) {
        let template = match estimates {
            true => with_estimate("steps"),
            false => "{bar:40} {pos}/{len} steps {wide_msg}".to_owned(),
        };
        if let Ok(style) = ProgressStyle::with_template(&template) {
            self.bar.set_style(style);
            self.bar.reset_eta();
        }
    }

    /// So many steps more have turned out to be needed.
    pub fn more(&self, steps: usize) {
        self.bar.inc_length(steps as u64);
    }

    /// One step begun. Nothing here ever wants to stop: a signal ends the process from a thread of its own.
    pub fn tick(&self) -> ControlFlow<()> {
        self.bar.inc(1);
        ControlFlow::Continue(())
    }
}

/// How far steps have come, and how long the rest takes if it goes on like that.
fn with_estimate(named: &str) -> String {
    format!("{{bar:40}} {{pos}}/{{len}} {named}, {{eta}} left {{wide_msg}}")
}

/// Does the work of `plan` under a bar of its length.
pub(super) fn run_under_bar<'a>(plan: &Plan<'a>) -> Result<Analysis<'a>, Error> {
    let bar = Progress::of(plan.steps()?, "steps");
    let mut stage = |doing: &str| {
        bar.promises(doing != analysis::MESH_CYCLE);
        bar.now(doing);
    };
    let tick = || bar.tick();
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

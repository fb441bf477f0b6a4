//! Work without the interpreter's lock, which Ctrl-C ends.

use crate::error::Outcome;
use gearlash::analysis::{Analysis, Plan, Progress};
use gearlash::error::{Error, Tick};
use pyo3::prelude::*;
use rayon::ThreadPoolBuilder;
use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Interval at which the interpreter is asked for signals: imperceptible to people, and no load.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(50);

/// One more than the most threads of a call: the largest machines have some hundred cores.
const TOO_MANY_THREADS: usize = 1025;

/// The analysis of `plan`, as [`work`].
pub fn analysed<'a>(
    py: Python<'_>,
    threads: Option<usize>,
    plan: &Plan<'a>,
) -> Outcome<Analysis<'a>> {
    work(py, threads, |tick| {
        let mut progress = Progress {
            stage: &mut |_| (),
            tick,
        };
        Analysis::run(plan, &mut progress)
    })
}

/// Does `work` with the lock released, on `threads` threads of its own; without a number, on those shared by all calls.
///
/// If a signal handler raises meanwhile, as Python's own does for Ctrl-C, the work is stopped and that exception is raised.
pub fn work<T: Send>(
    py: Python<'_>,
    threads: Option<usize>,
    work: impl FnOnce(&Tick) -> Result<T, Error> + Send,
) -> Outcome<T> {
    let stop = AtomicBool::new(false);
    let tick = |_| {
        if stop.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let pool = match threads {
        None => None,
        Some(threads @ (0 | TOO_MANY_THREADS..)) => {
            let most = TOO_MANY_THREADS - 1;
            let reason = format!("threads = {threads}: allowed is 1 … {most}, or None");
            return Err(reason.into());
        }
        Some(threads) => {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build();
            Some(pool.map_err(|reason| format!("threads = {threads}: {reason}"))?)
        }
    };
    let (done, raised) = py.detach(|| {
        thread::scope(|scope| {
            let (ended, wait) = channel();
            let (tick, pool) = (&tick, &pool);
            let worker = scope.spawn(move || {
                let done = match pool {
                    Some(pool) => pool.install(|| work(tick)),
                    None => work(tick),
                };
                // The receiver is gone only if this thread panics.
                let _ = ended.send(());
                done
            });
            let mut raised = None;
            while let Err(RecvTimeoutError::Timeout) = wait.recv_timeout(SIGNAL_INTERVAL) {
                if raised.is_none() {
                    raised = Python::attach(|py| py.check_signals()).err();
                    stop.store(raised.is_some(), Ordering::Relaxed);
                }
            }
            (
                worker.join().unwrap_or_else(|panic| resume_unwind(panic)),
                raised,
            )
        })
    });
    match raised {
        Some(raised) => Err(raised.into()),
        None => Ok(done?),
    }
}

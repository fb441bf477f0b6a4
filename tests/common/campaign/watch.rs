//! A watch over poses that take too long: names the pose and ends the process, which nothing else could do.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// No pose may take more than 0.1 s; a machine may be a hundred times slower, or busy.
pub const LONGEST: Duration = Duration::from_secs(60);

type Running = Arc<Mutex<BTreeMap<u64, Instant>>>;

/// Poses that are being run.
pub struct Watch {
    running: Running,
}

/// One of them; ends when dropped.
pub struct Run {
    index: u64,
    running: Running,
}

impl Watch {
    pub fn new(seed: u64, longest: Duration) -> Watch {
        let running = Running::default();
        let seen = Arc::downgrade(&running);
        std::thread::spawn(move || {
            while let Some(running) = seen.upgrade() {
                let now = lock(&running)
                    .iter()
                    .find_map(|(&index, since)| (since.elapsed() > longest).then_some(index));
                if let Some(index) = now {
                    eprintln!(
                        "pose {index} of seed {seed} runs on and on: given up, and all with it"
                    );
                    std::process::exit(1);
                }
                drop(running);
                std::thread::sleep(Duration::from_millis(200));
            }
        });
        Watch { running }
    }

    pub fn running(&self, index: u64) -> Run {
        lock(&self.running).insert(index, Instant::now());
        Run {
            index,
            running: Arc::clone(&self.running),
        }
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        lock(&self.running).remove(&self.index);
    }
}

fn lock(running: &Running) -> std::sync::MutexGuard<'_, BTreeMap<u64, Instant>> {
    running.lock().unwrap_or_else(PoisonError::into_inner)
}

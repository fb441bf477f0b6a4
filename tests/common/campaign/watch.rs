//! A watch over poses that take too long: names the pose and ends the process, which nothing else could do.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// No pose may take more than 0.1 s; a machine may be a hundred times slower, or busy.
const LONGEST: Duration = Duration::from_secs(60);

/// Poses that are being run, each with its start.
pub struct Watch(Arc<Mutex<BTreeMap<u64, Instant>>>);

impl Watch {
    pub fn new(seed: u64) -> Watch {
        let running = Arc::default();
        let seen = Arc::downgrade(&running);
        std::thread::spawn(move || {
            while let Some(running) = seen.upgrade() {
                let over = |(index, since): (&u64, &Instant)| {
                    (since.elapsed() > LONGEST).then_some(*index)
                };
                if let Some(index) = lock(&running).iter().find_map(over) {
                    eprintln!(
                        "pose {index} of seed {seed} runs on and on: given up, and all with it"
                    );
                    std::process::exit(1);
                }
                drop(running);
                std::thread::sleep(Duration::from_millis(200));
            }
        });
        Watch(running)
    }

    /// Runs pose `index`.
    pub fn run<T>(&self, index: u64, pose: impl FnOnce() -> T) -> T {
        lock(&self.0).insert(index, Instant::now());
        let found = pose();
        lock(&self.0).remove(&index);
        found
    }
}

fn lock(running: &Mutex<BTreeMap<u64, Instant>>) -> MutexGuard<'_, BTreeMap<u64, Instant>> {
    running.lock().unwrap_or_else(PoisonError::into_inner)
}

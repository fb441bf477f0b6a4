//! The message of a test that this machine cannot run.

use std::io::Write;
use std::sync::atomic::{AtomicUsize, Ordering};

static SKIPPED: AtomicUsize = AtomicUsize::new(0);

/// Prints past the harness that the running test is skipped, the reason, and how many of this binary are by now.
pub fn skip(why: &str) {
    let count = 1 + SKIPPED.fetch_add(1, Ordering::Relaxed);
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("a test");
    let line = format!("SKIPPED ({count} in this binary): {test}: {why}\n");
    let _ = std::io::stderr().write_all(line.as_bytes());
}

//! What must be taken away when the process ends in the middle of its work, as after Ctrl-C.
//!
//! One list for the process, as a signal is one for the process. Whoever makes something temporary holds the list
//! while it does; so once [`abandon`] holds it, nothing more is made.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

static UNFINISHED: Mutex<Unfinished> = Mutex::new(Unfinished {
    temporary: Vec::new(),
    made: Vec::new(),
    written: false,
});

/// What is unfinished.
pub(super) struct Unfinished {
    /// Folders to remove with all they hold.
    temporary: Vec<PathBuf>,
    /// Folders made for results, to remove where they are still empty, innermost last.
    made: Vec<PathBuf>,
    /// Whether something has been written for good.
    written: bool,
}

impl Unfinished {
    /// Adds a temporary folder.
    pub fn add_temporary(&mut self, path: &Path) {
        self.temporary.push(path.to_path_buf());
    }

    /// A temporary folder is gone.
    pub fn drop_temporary(&mut self, path: &Path) {
        self.temporary.retain(|other| other != path);
    }

    /// Adds a folder made for results.
    pub fn add_made(&mut self, path: &Path) {
        self.made.push(path.to_path_buf());
    }

    /// A folder made for results is gone, or there to stay.
    pub fn drop_made(&mut self, path: &Path) {
        self.made.retain(|other| other != path);
    }

    /// Something is in its place.
    pub fn set_written(&mut self) {
        self.written = true;
    }
}

/// The list, for as long as something is made, put in its place or removed.
pub(super) fn unfinished() -> MutexGuard<'static, Unfinished> {
    // The list is whole after each of its methods, whatever a thread did that held it.
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Nothing unfinished is left, and none is begun while this lives.
pub struct Ended {
    held: MutexGuard<'static, Unfinished>,
}

impl Ended {
    /// Whether results had been written for good before.
    pub fn written(&self) -> bool {
        self.held.written
    }
}

/// Removes whatever this process has begun to write; waits for results that are just being put in their place.
///
/// Made for the thread that takes signals, which ends the process next: any other thread that writes waits for ever.
pub fn abandon() -> Ended {
    let mut held = unfinished();
    for path in std::mem::take(&mut held.temporary) {
        // What cannot be removed is cleared by the next run.
        let _ = std::fs::remove_dir_all(path);
    }
    for path in std::mem::take(&mut held.made).iter().rev() {
        // Fails, rightly, where something else has come to stand in it.
        let _ = std::fs::remove_dir(path);
    }
    Ended { held }
}

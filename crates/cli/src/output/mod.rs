//! Writing results: each file whole or not at all, and never over a file that was read.
//!
//! A place is tried before the work begins, so that a typing mistake does not cost hours. Each file is written under a temporary
//! name beside its target and then renamed; `result.json` is renamed last. An error and a signal remove the temporary files. A
//! killed process leaves them; a later run in the same folder removes them, because their lock is free.

mod file;
mod folder;
mod made;

pub use file::{NewFile, OutputFile};
pub use folder::OutputFolder;

use crate::error::Error;
use gearlash_files::Sources;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

static UNFINISHED: Mutex<Unfinished> = Mutex::new(Unfinished {
    temporary: Vec::new(),
    made: Vec::new(),
    written: false,
});

/// Temporary files and new folders of the process. A thread that creates or renames one holds the lock.
struct Unfinished {
    temporary: Vec<PathBuf>,
    /// Folders created for results, innermost last.
    made: Vec<PathBuf>,
    /// Whether a file has been renamed to its target.
    written: bool,
}

fn unfinished() -> MutexGuard<'static, Unfinished> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A lock: while it is held, nothing is unfinished and nothing new begins.
pub struct EndLock {
    held: MutexGuard<'static, Unfinished>,
}

impl EndLock {
    /// Whether a file had been renamed to its target.
    pub fn written(&self) -> bool {
        self.held.written
    }
}

/// Removes everything unfinished, for the thread that ends the process. Other threads that write wait until then.
pub fn remove_unfinished() -> EndLock {
    let mut held = unfinished();
    for path in std::mem::take(&mut held.temporary) {
        let _ = std::fs::remove_file(path);
    }
    for path in std::mem::take(&mut held.made).iter().rev() {
        // Fails for a folder with files, which must stay.
        let _ = std::fs::remove_dir(path);
    }
    EndLock { held }
}

fn failed(path: &Path) -> impl Fn(std::io::Error) -> Error {
    move |source| Error::Output {
        path: path.to_path_buf(),
        source,
    }
}

/// An error where the file at `path` is one of `sources`.
fn check_not_input(sources: &Sources, path: &Path) -> Result<(), Error> {
    match sources.named(path) {
        None => Ok(()),
        Some(input) => Err(Error::OverInput {
            output: path.to_path_buf(),
            input: input.to_path_buf(),
        }),
    }
}

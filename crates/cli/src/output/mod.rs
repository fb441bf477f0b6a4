//! Writing results: the whole set of a run or nothing, and never over a file that was read.
//!
//! A place is tried before the work begins, so that hours of it are not lost to a typing mistake. Everything is then
//! written into temporary folders on the same file system (`temporary`), large results as they grow, and put in its place in one of two ways:
//!
//! - `exchange`: the temporary folder, with links to whatever else the folder holds, changes places with the folder in one
//!   step of the system. A reader sees the old set or the new one.
//! - `replace`: where that cannot be done, file by file, a manifest with their hashes last; undone after a failure, and by
//!   the next run after a kill.
//!
//! Temporary folders are called `.gearlash-….tmp` and locked by the run they belong to; what a killed run left is
//! recognised by its free lock and cleared by the next run in the same place.

mod ending;
mod exchange;
mod file;
mod folder;
mod replace;
mod temporary;

pub use ending::abandon;
pub use file::OutputFile;
pub use folder::OutputFolder;
pub use temporary::NewFile;

use crate::error::Error;
use std::path::Path;

fn failed(path: &Path) -> impl Fn(std::io::Error) -> Error {
    move |source| Error::Output {
        path: path.to_path_buf(),
        source,
    }
}

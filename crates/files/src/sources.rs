//! The files that were read, recognised under any name of an output.
//!
//! Only ordinary files are kept: writing to a pipe or a device that was read does no harm.

use std::fs::{File, Metadata};
use std::path::{Path, PathBuf};

/// Every file of a study: the pair file, its tables, protocols, workbooks and measured rows.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    read: Vec<(PathBuf, Identity)>,
}

/// Any two are equal: the origin of a study is not part of its content.
impl PartialEq for Sources {
    fn eq(&self, _: &Sources) -> bool {
        true
    }
}

/// Device and inode, which all names of one file share.
#[cfg(unix)]
type Identity = (u64, u64);
/// The path itself, its links followed.
#[cfg(not(unix))]
type Identity = PathBuf;

impl Sources {
    /// No files.
    pub fn new() -> Sources {
        Sources::default()
    }

    /// Records the file at `path` if it is an ordinary one.
    pub fn add(&mut self, path: &Path) {
        let identity = std::fs::metadata(path)
            .ok()
            .and_then(|metadata| identity(path, &metadata));
        if let Some(identity) = identity {
            self.read.push((path.to_path_buf(), identity));
        }
    }

    /// Records the files of `others`.
    pub fn extend(&mut self, others: &Sources) {
        self.read.extend_from_slice(&others.read);
    }

    /// The names under which files were read.
    pub fn names(&self) -> impl Iterator<Item = &Path> {
        self.read.iter().map(|(path, _)| path.as_path())
    }

    /// The name under which the file at `path` was read; `None` where it was not read or does not exist.
    pub fn named(&self, path: &Path) -> Option<&Path> {
        self.find(path, &std::fs::metadata(path).ok()?)
    }

    /// The name under which `file`, open at `path`, was read.
    pub fn named_open(&self, path: &Path, file: &File) -> Option<&Path> {
        self.find(path, &file.metadata().ok()?)
    }

    fn find(&self, path: &Path, metadata: &Metadata) -> Option<&Path> {
        let wanted = identity(path, metadata)?;
        let mut read = self.read.iter();
        read.find(|(_, identity)| *identity == wanted)
            .map(|(path, _)| path.as_path())
    }
}

#[cfg(unix)]
fn identity(_: &Path, metadata: &Metadata) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    metadata.is_file().then(|| (metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path, metadata: &Metadata) -> Option<Identity> {
    path.canonicalize().ok().filter(|_| metadata.is_file())
}

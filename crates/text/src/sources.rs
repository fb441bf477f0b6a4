//! The files that were read, recognised under any name of an output; and files by name and bytes, for a caller without a file system.
//!
//! Only ordinary files are kept: writing to a pipe or a device that was read does no harm.

use crate::error::Problem;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::{File, Metadata};
use std::path::{Component, Path, PathBuf};

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
    pub fn read_as(&self, path: &Path) -> Option<&Path> {
        self.find(path, &std::fs::metadata(path).ok()?)
    }

    /// The name under which `file`, open at `path`, was read.
    pub fn file_read_as(&self, path: &Path, file: &File) -> Option<&Path> {
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

/// Files by name and bytes, in place of a folder. A name is relative to that folder, such as `wheel.csv` or `data/wheel.csv`.
#[derive(Debug, Clone, Default)]
pub struct Files {
    each: BTreeMap<String, Vec<u8>>,
    asked: RefCell<Vec<String>>,
}

impl Files {
    /// Adds a file, in place of one with the same name.
    pub fn add(&mut self, name: &str, bytes: Vec<u8>) {
        self.each.insert(plain_name(Path::new(name)), bytes);
    }

    /// Takes a file out; whether there was one.
    pub fn remove(&mut self, name: &str) -> bool {
        self.each.remove(&plain_name(Path::new(name))).is_some()
    }

    /// The bytes of the file with this name.
    pub fn get(&self, name: &str) -> Option<&[u8]> {
        let bytes = self.each.get(&plain_name(Path::new(name)));
        bytes.map(Vec::as_slice)
    }

    /// The names, sorted.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.each.keys().map(String::as_str)
    }

    /// The names that [`Files::bytes`] was asked for, without their folders: the pair file first, a file read twice twice.
    pub fn asked(&self) -> Vec<String> {
        self.asked.borrow().clone()
    }

    /// The bytes of the file called `path`. A file that was given without its folder counts, also in capital letters.
    /// Errors: a problem where there is no such file.
    pub fn bytes(&self, path: &Path) -> Result<Vec<u8>, Problem> {
        let name = plain_name(path);
        let last = name.rsplit('/').next().unwrap_or(&name);
        self.asked.borrow_mut().push(last.to_owned());
        let is_last = |own: &&String| own.eq_ignore_ascii_case(last);
        let alike = || self.each.get(self.each.keys().find(is_last)?);
        let found = self.each.get(&name).or_else(|| self.each.get(last));
        found
            .or_else(alike)
            .cloned()
            .ok_or_else(|| Problem::of_file("not here yet", "drop it, or add it to the files"))
    }
}

/// `path` with `/` between its parts and without `.`.
fn plain_name(path: &Path) -> String {
    let text = path.to_string_lossy().replace('\\', "/");
    let parts = Path::new(&text)
        .components()
        .filter(|part| !matches!(part, Component::CurDir | Component::RootDir));
    let parts = parts.map(|part| part.as_os_str().to_string_lossy().into_owned());
    parts.collect::<Vec<_>>().join("/")
}

//! Folders for files that are not complete yet.

use super::ending::unfinished;
use std::ffi::OsStr;
use std::fs::{File, TryLockError};
use std::io::{Error, ErrorKind, Write};
use std::path::{Path, PathBuf};

const PREFIX: &str = ".gearlash-";
const SUFFIX: &str = ".tmp";
/// Attempts at a folder of one's own: each fails only where another run clears it before it is locked.
const ATTEMPTS: usize = 16;
/// Bytes written and brought to the disk at a time: a process can end only between such steps (tuned: some 20 ms on a
/// slow disk).
pub(super) const PIECE: usize = 2 << 20;

/// A folder of this run, removed with all it holds when it is dropped.
#[derive(Debug)]
pub(super) struct Temporary {
    path: PathBuf,
    /// Says to other runs that this one lives. `None` where the file system has no locks.
    _lock: Option<File>,
}

impl Temporary {
    /// Makes one in `folder`.
    pub fn new_in(folder: &Path) -> std::io::Result<Temporary> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX).suffix(SUFFIX);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The process's umask still applies.
            builder.permissions(std::fs::Permissions::from_mode(0o777));
        }
        for _ in 0..ATTEMPTS {
            let mut list = unfinished();
            let path = builder.tempdir_in(folder)?.keep();
            list.add_temporary(&path);
            match lock(&path) {
                Lock::Held(file) => {
                    return Ok(Temporary {
                        path,
                        _lock: Some(file),
                    });
                }
                Lock::Unknown => return Ok(Temporary { path, _lock: None }),
                // Another run took it for a dead one's.
                Lock::Taken | Lock::Gone => list.drop_temporary(&path),
            }
        }
        Err(Error::new(
            ErrorKind::ResourceBusy,
            "other runs keep clearing the folder",
        ))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Makes the folder called `name` in it.
    pub fn add_folder(&self, name: &str) -> std::io::Result<PathBuf> {
        let path = self.path.join(name);
        let _list = unfinished();
        std::fs::create_dir(&path)?;
        Ok(path)
    }

    /// Moves the file called `name` from `other`, on the same file system, into the folder `place` in this one.
    pub fn take(&self, other: &Temporary, name: &str, place: &str) -> std::io::Result<()> {
        let _list = unfinished();
        let [from, to] = [other.path.clone(), self.path.join(place)].map(|path| path.join(name));
        std::fs::rename(from, to)
    }

    /// Begins the file called `name` in it.
    pub fn create(&self, name: impl AsRef<Path>) -> std::io::Result<NewFile> {
        let _list = unfinished();
        Ok(NewFile {
            file: File::create_new(self.path.join(name))?,
            piece: Vec::new(),
        })
    }

    /// Writes the file called `name` in it, down to the disk.
    pub fn write(&self, name: impl AsRef<Path>, content: &[u8]) -> std::io::Result<()> {
        let mut file = self.create(name)?;
        file.write_all(content)?;
        file.flush()
    }
}

/// A file that grows in a temporary folder.
pub struct NewFile {
    file: File,
    /// What is not written yet.
    piece: Vec<u8>,
}

impl Write for NewFile {
    fn write(&mut self, content: &[u8]) -> std::io::Result<usize> {
        let taken = content.len().min(PIECE - self.piece.len());
        self.piece.extend_from_slice(&content[..taken]);
        if self.piece.len() == PIECE {
            self.flush()?;
        }
        Ok(taken)
    }

    /// Writes what has come together, down to the disk.
    fn flush(&mut self) -> std::io::Result<()> {
        if !self.piece.is_empty() {
            self.file.write_all(&self.piece)?;
            self.file.sync_data()?;
            self.piece.clear();
        }
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let mut list = unfinished();
        // What cannot be removed is cleared by the next run.
        let _ = std::fs::remove_dir_all(&self.path);
        list.drop_temporary(&self.path);
    }
}

/// Brings the names in `folder` to the disk, where the system can.
pub(super) fn sync_folder(folder: &Path) -> std::io::Result<()> {
    match cfg!(unix) {
        true => File::open(folder)?.sync_all(),
        false => Ok(()),
    }
}

/// What came of locking a folder.
pub(super) enum Lock {
    /// It is ours for as long as the file is open.
    Held(File),
    /// It is another run's.
    Taken,
    /// The folder is no longer there, or another stands in its place.
    Gone,
    /// This file system or this folder cannot be locked.
    Unknown,
}

/// Locks the folder at `path`.
pub(super) fn lock(path: &Path) -> Lock {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == ErrorKind::NotFound => return Lock::Gone,
        Err(_) => return Lock::Unknown,
    };
    match file.try_lock() {
        Ok(()) if same(&file, path) => Lock::Held(file),
        Ok(()) => Lock::Gone,
        Err(TryLockError::WouldBlock) => Lock::Taken,
        Err(TryLockError::Error(_)) => Lock::Unknown,
    }
}

/// Whether `file`, opened at `path`, still stands there.
#[cfg(unix)]
pub(super) fn same(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |metadata: std::fs::Metadata| (metadata.dev(), metadata.ino());
    let [open, there] = [file.metadata(), std::fs::metadata(path)].map(|found| found.map(identity));
    matches!((open, there), (Ok(open), Ok(there)) if open == there)
}

/// Whether something stands there.
#[cfg(not(unix))]
pub(super) fn same(_: &File, path: &Path) -> bool {
    path.exists()
}

/// Whether a temporary folder may be called that.
pub(super) fn is_temporary(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    name.strip_prefix(PREFIX)
        .and_then(|rest| rest.strip_suffix(SUFFIX))
        .is_some_and(|random| {
            !random.is_empty() && random.chars().all(|c| c.is_ascii_alphanumeric())
        })
}

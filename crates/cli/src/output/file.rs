//! One file of results.

use super::made::CreatedFolders;
use super::{check_not_input, failed, unfinished};
use crate::error::Error;
use gearlash_files::Sources;
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

const PREFIX: &str = ".gearlash-";
const SUFFIX: &str = ".tmp";
/// Bytes written to the disk at a time. A signal waits for one piece (tuned: 20 ms on a slow disk).
const PIECE: usize = 2 << 20;
/// A younger temporary file may still lack its lock.
const ORPHAN_AFTER: Duration = Duration::from_secs(60);

/// A temporary file in the folder of its target, removed when dropped.
#[derive(Debug)]
pub(super) struct Temporary {
    path: PathBuf,
    /// Locked while the run is alive.
    file: File,
}

impl Temporary {
    /// Creates one in `folder`.
    pub fn new_in(folder: &Path) -> std::io::Result<Temporary> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX).suffix(SUFFIX);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The umask of the process applies.
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        let mut list = unfinished();
        let (file, path) = builder.tempfile_in(folder)?.keep()?;
        list.temporary.push(path.clone());
        // On file systems without locks, files of killed runs stay.
        let _ = file.try_lock();
        Ok(Temporary { path, file })
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// A writer to it.
    pub fn writer(&self) -> std::io::Result<NewFile> {
        Ok(NewFile {
            file: self.file.try_clone()?,
            piece: Vec::new(),
        })
    }

    /// Renames it to its target.
    pub fn rename(&self, target: &Path) -> std::io::Result<()> {
        let mut list = unfinished();
        std::fs::rename(&self.path, target)?;
        list.temporary.retain(|other| *other != self.path);
        list.written = true;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let mut list = unfinished();
        if list.temporary.contains(&self.path) {
            let _ = std::fs::remove_file(&self.path);
            list.temporary.retain(|other| *other != self.path);
        }
    }
}

/// Removes the temporary files that killed runs left in `folder`.
pub(super) fn remove_orphans(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if !is_file || !name.starts_with(PREFIX) || !name.ends_with(SUFFIX) {
            continue;
        }
        let changed = entry.metadata().and_then(|metadata| metadata.modified());
        let age = changed.ok().and_then(|time| time.elapsed().ok());
        let is_old = age.is_some_and(|age| age > ORPHAN_AFTER);
        if is_old && File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// A file that grows; [`Write::flush`] writes it to the disk.
#[derive(Debug)]
pub struct NewFile {
    file: File,
    /// Content that is not written yet.
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

    fn flush(&mut self) -> std::io::Result<()> {
        if !self.piece.is_empty() {
            self.file.write_all(&self.piece)?;
            self.file.sync_data()?;
            self.piece.clear();
        }
        Ok(())
    }
}

/// A file that can be written.
pub struct OutputFile {
    /// The path as the user named it.
    named: PathBuf,
    /// The temporary file and the target of an ordinary file; `None`: a pipe or a device, which is written to.
    place: Option<(Temporary, PathBuf)>,
    made: CreatedFolders,
}

impl OutputFile {
    /// Creates the folder of `named` where it is missing and tries to write there. A link is followed.
    ///
    /// # Errors
    /// [`Error::Usage`] for a path that names no file or a folder, and for a link that leads nowhere; [`Error::OverInput`];
    /// [`Error::Output`].
    pub fn prepare(named: &Path, sources: &Sources) -> Result<OutputFile, Error> {
        let wrong = |reason| Error::Usage(format!("{}: {reason}", named.display()));
        let failed = failed(named);
        if named.file_name().is_none() {
            return Err(wrong("this names no file"));
        }
        check_not_input(sources, named)?;
        let (target, made) = match std::fs::metadata(named) {
            Ok(found) if found.is_dir() => {
                return Err(wrong("this is a folder, name a file in it"));
            }
            Ok(found) if found.is_file() => (
                Some(named.canonicalize().map_err(&failed)?),
                CreatedFolders::default(),
            ),
            Ok(_) => (None, CreatedFolders::default()),
            Err(_) if named.is_symlink() => {
                return Err(wrong(
                    "this is a link to a file that is not there; name that file",
                ));
            }
            Err(error) if error.kind() == ErrorKind::NotFound => (
                Some(named.to_path_buf()),
                CreatedFolders::folder(folder_of(named))?,
            ),
            Err(error) => return Err(failed(error)),
        };
        let place = match target {
            None => None,
            Some(target) => {
                remove_orphans(folder_of(&target));
                let temporary = Temporary::new_in(folder_of(&target)).map_err(&failed)?;
                Some((temporary, target))
            }
        };
        Ok(OutputFile {
            named: named.to_path_buf(),
            place,
            made,
        })
    }

    /// Writes `content` in one piece.
    ///
    /// # Errors
    /// [`Error::Output`]; an older file is kept.
    pub fn write(mut self, content: &str) -> Result<(), Error> {
        let write = || -> std::io::Result<()> {
            let Some((temporary, target)) = &self.place else {
                return open_special(&self.named)?.write_all(content.as_bytes());
            };
            let mut file = temporary.writer()?;
            file.write_all(content.as_bytes())?;
            file.flush()?;
            temporary.rename(target)
        };
        write().map_err(failed(&self.named))?;
        self.made.keep();
        Ok(())
    }
}

/// Opens a pipe or a device. A pipe without a reader is an error, not a wait.
fn open_special(path: &Path) -> std::io::Result<File> {
    let mut options = std::fs::OpenOptions::new();
    options.write(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(rustix::fs::OFlags::NONBLOCK.bits() as i32);
        let file = options.open(path)?;
        rustix::io::ioctl_fionbio(&file, false)?;
        Ok(file)
    }
    #[cfg(not(unix))]
    options.open(path)
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

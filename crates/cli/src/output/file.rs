//! One file of results.

use super::ending::unfinished;
use super::failed;
use super::folder::{Made, guard};
use super::replace::clear_dead;
use super::temporary::Temporary;
use crate::error::Error;
use gearlash_files::Sources;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// What a file is called until it is in its place.
const NEW: &str = "new";

/// A file that can be written.
pub struct OutputFile {
    /// As the user calls it.
    named: PathBuf,
    place: Place,
}

enum Place {
    /// In a folder: replaced in one step.
    File { path: PathBuf, made: Made },
    /// A pipe or a device, which is written to.
    Special(PathBuf),
}

impl OutputFile {
    /// Makes the folder of `path` where it is missing, clears what killed runs left in it and tries to write there.
    ///
    /// A link is followed, as `cp` follows it: the file it points to will be replaced.
    ///
    /// # Errors
    /// [`Error::Usage`] for a path that names no file or a folder, and a link that leads nowhere; [`Error::OverInput`];
    /// [`Error::Output`].
    pub fn prepare(named: &Path, sources: &Sources) -> Result<OutputFile, Error> {
        let wrong = |reason| Error::Usage(format!("{}: {reason}", named.display()));
        let failed = failed(named);
        if named.file_name().is_none() {
            return Err(wrong("this names no file"));
        }
        guard(sources, named, named)?;
        let place = match std::fs::metadata(named) {
            Ok(found) if found.is_dir() => {
                return Err(wrong("this is a folder, name a file in it"));
            }
            Ok(found) if found.is_file() => Place::File {
                path: named.canonicalize().map_err(&failed)?,
                made: Made::none(),
            },
            Ok(_) => Place::Special(named.to_path_buf()),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                if named.is_symlink() {
                    return Err(wrong(
                        "this is a link to a file that is not there; name that file",
                    ));
                }
                Place::File {
                    path: named.to_path_buf(),
                    made: Made::folder(folder_of(named))?,
                }
            }
            Err(error) => return Err(failed(error)),
        };
        if let Place::File { path, .. } = &place {
            clear_dead(folder_of(path));
            Temporary::new_in(folder_of(path)).map_err(&failed)?;
        }
        Ok(OutputFile {
            named: named.to_path_buf(),
            place,
        })
    }

    /// Writes `content` in one piece.
    ///
    /// # Errors
    /// [`Error::Output`]; what was there stays.
    pub fn write(self, content: &str) -> Result<(), Error> {
        let failed = failed(&self.named);
        match self.place {
            Place::File { path, mut made } => {
                let temporary = Temporary::new_in(folder_of(&path)).map_err(&failed)?;
                temporary.write(NEW, content.as_bytes()).map_err(&failed)?;
                let mut list = unfinished();
                std::fs::rename(temporary.path().join(NEW), &path).map_err(&failed)?;
                list.set_written();
                drop(list);
                made.keep();
                Ok(())
            }
            Place::Special(path) => special(&path)
                .and_then(|mut file| file.write_all(content.as_bytes()))
                .map_err(&failed),
        }
    }
}

/// A pipe that nobody reads is an error, not a wait.
fn special(path: &Path) -> std::io::Result<std::fs::File> {
    let mut options = OpenOptions::new();
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

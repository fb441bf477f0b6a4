//! A folder of results.

use super::ending::unfinished;
use super::exchange::Exchange;
use super::failed;
use super::replace::{MANIFEST, New, clear_dead, replace};
use super::temporary::{Lock, NewFile, Temporary, is_temporary, lock, same};
use crate::error::Error;
use gearlash_files::Sources;
use gearlash_files::characters::plain;
use std::ffi::OsStr;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

/// A folder that can be written to, and that no other run writes to.
pub struct OutputFolder {
    /// The files written so far and their names; dropped before the folder they stand in.
    new: Option<New>,
    /// As the user calls it.
    named: PathBuf,
    /// Where it is, links followed.
    path: PathBuf,
    made: Made,
    own: Box<dyn Fn(&str) -> bool>,
    sources: Sources,
    /// `None` where the file system has no locks.
    lock: Option<File>,
}

impl OutputFolder {
    /// Makes the folder where it is missing, keeps other runs from it, clears what killed ones left, and tries to write in it.
    ///
    /// `own` are the names of files that this run may write, and that replace or remove those of an earlier run; none of
    /// them may be one of `sources`.
    ///
    /// # Errors
    /// [`Error::Output`] with the system's reason; [`Error::OverInput`]; [`Error::Busy`].
    pub fn prepare(
        path: &Path,
        sources: &Sources,
        own: impl Fn(&str) -> bool + 'static,
    ) -> Result<OutputFolder, Error> {
        let mut made = Made::folder(path)?;
        let failed = failed(path);
        let real = path.canonicalize().map_err(&failed)?;
        let held = hold(path).inspect_err(|error| {
            if let Error::Busy { .. } = error {
                // Empty still, but another run's by now.
                made.keep();
            }
        });
        let folder = OutputFolder {
            new: None,
            named: path.to_path_buf(),
            made,
            own: Box::new(own),
            sources: sources.clone(),
            lock: held?,
            path: real,
        };
        for cleared in [folder.path.parent(), Some(&folder.path)]
            .into_iter()
            .flatten()
        {
            clear_dead(cleared);
        }
        for name in folder.present(|name| (folder.own)(name)).map_err(&failed)? {
            folder.guard(&name)?;
        }
        Temporary::new_in(&folder.path).map_err(&failed)?;
        Ok(folder)
    }

    /// Begins a file of the set, written down to the disk when it is flushed. Until [`OutputFolder::write`] nobody sees it.
    ///
    /// # Errors
    /// [`Error::Output`], [`Error::OverInput`].
    pub fn create(&mut self, name: &str) -> Result<NewFile, Error> {
        self.guard(name)?;
        let file = self.gathered().and_then(|new| {
            let file = new.temporary.create(name)?;
            new.names.push(name.to_owned());
            Ok(file)
        });
        file.map_err(self.failed(name))
    }

    /// Adds a file with this `content` to the set.
    ///
    /// # Errors
    /// As [`OutputFolder::create`].
    pub fn add(&mut self, name: &str, content: &str) -> Result<(), Error> {
        let mut file = self.create(name)?;
        let written = file.write_all(content.as_bytes());
        let written = written.and_then(|()| file.flush());
        written.map_err(self.failed(name))
    }

    /// Opens a file that [`OutputFolder::create`] began, from its beginning.
    ///
    /// # Errors
    /// [`Error::Output`].
    pub fn open(&mut self, name: &str) -> Result<File, Error> {
        let opened = self.gathered();
        let opened = opened.and_then(|new| File::open(new.temporary.path().join(name)));
        opened.map_err(self.failed(name))
    }

    /// What became of the file called `name` of the set.
    pub fn failed(&self, name: &str) -> impl Fn(std::io::Error) -> Error + use<> {
        let path = self.named.join(name);
        move |source| failed(&path)(source)
    }

    fn gathered(&mut self) -> std::io::Result<&mut New> {
        let new = match self.new.take() {
            Some(new) => new,
            None => New {
                temporary: Temporary::new_in(&self.path)?,
                names: Vec::new(),
            },
        };
        Ok(self.new.insert(new))
    }

    /// Puts the files begun so far and all `files` (name and content) in the place of the run's own files, as one set, and
    /// says in a line what was written and where.
    ///
    /// # Errors
    /// [`Error::Output`], [`Error::OverInput`], [`Error::Busy`]: the folder is as it was.
    pub fn write(mut self, files: &[(String, String)]) -> Result<String, Error> {
        if self
            .lock
            .as_ref()
            .is_some_and(|lock| !same(lock, &self.path))
        {
            // Moved away meanwhile; what stands there now may be another run's.
            return Err(Error::Busy { folder: self.named });
        }
        for (name, content) in files {
            self.add(name, content)?;
        }
        let named = self.named.clone();
        self.gathered().map_err(failed(&named))?;
        let Some(new) = self.new.take() else {
            return Ok(described(&self.named, &[]));
        };
        let put = |name: &str| new.names.iter().any(|other| other == name);
        for name in &new.names {
            self.guard(name)?;
        }
        let replaced = |name: &OsStr| {
            name.to_str()
                .is_some_and(|name| (self.own)(name) || put(name) || name == MANIFEST)
        };
        let beside = new.temporary.path();
        match Exchange::begin(&self.path, &replaced, &self.sources, beside) {
            Some(exchange) => {
                for name in &new.names {
                    let moved = exchange.temporary().take(&new.temporary, name, "");
                    moved.map_err(self.failed(name))?;
                }
                drop(new.temporary);
                exchange.finish(&self.path)?;
            }
            None => {
                let stale = self.present(|name| (self.own)(name) && !put(name));
                let mut stale = stale.map_err(failed(&self.named))?;
                // Folders and links stay.
                let ordinary = |name: &String| {
                    let found = self.path.join(name).symlink_metadata();
                    found.is_ok_and(|found| found.is_file())
                };
                stale.retain(ordinary);
                replace(&self.path, &new, &stale)?;
            }
        }
        self.made.keep();
        Ok(described(&self.named, &new.names))
    }

    /// The names in the folder that are `wanted`.
    fn present(&self, wanted: impl Fn(&str) -> bool) -> std::io::Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in std::fs::read_dir(&self.path)? {
            let name = entry?.file_name();
            let name = name.to_str().filter(|name| wanted(name));
            names.extend(
                name.filter(|name| !is_temporary(name.as_ref()))
                    .map(str::to_owned),
            );
        }
        names.sort();
        Ok(names)
    }

    /// An error where the file called `name` was read.
    fn guard(&self, name: &str) -> Result<(), Error> {
        guard(&self.sources, &self.path.join(name), &self.named.join(name))
    }
}

/// Files that are named one by one (tuned: a line of a terminal).
const MOST_NAMED: usize = 3;

/// What was written to `folder`, on one line.
fn described(folder: &Path, names: &[String]) -> String {
    let shown = names.iter().take(MOST_NAMED).map(String::as_str);
    let mut list = match names.is_empty() {
        true => "nothing".to_owned(),
        false => shown.collect::<Vec<_>>().join(", "),
    };
    if names.len() > MOST_NAMED {
        list += &format!(" and {} more", names.len() - MOST_NAMED);
    }
    plain(&format!("Written to {}: {list}", folder.display()))
}

/// An error where the file at `path`, called `named`, is one of `sources`.
pub(super) fn guard(sources: &Sources, path: &Path, named: &Path) -> Result<(), Error> {
    match sources.named(path) {
        None => Ok(()),
        Some(input) => Err(Error::OverInput {
            output: named.to_path_buf(),
            input: input.to_path_buf(),
        }),
    }
}

/// Keeps other runs from the folder at `path`.
fn hold(path: &Path) -> Result<Option<File>, Error> {
    loop {
        match lock(path) {
            Lock::Held(file) => return Ok(Some(file)),
            Lock::Unknown => return Ok(None),
            Lock::Taken => {
                return Err(Error::Busy {
                    folder: path.to_path_buf(),
                });
            }
            // Another run has just put a new folder in its place.
            Lock::Gone if path.is_dir() => {}
            Lock::Gone => {
                return Err(failed(path)(std::io::ErrorKind::NotFound.into()));
            }
        }
    }
}

/// Folders made for results: taken away again when nothing is written.
pub(super) struct Made {
    /// Innermost last.
    folders: Vec<PathBuf>,
}

impl Made {
    /// None.
    pub fn none() -> Made {
        Made {
            folders: Vec::new(),
        }
    }

    /// Makes the folder at `path` and those above it that are missing.
    pub fn folder(path: &Path) -> Result<Made, Error> {
        let missing = path
            .ancestors()
            .take_while(|p| !p.as_os_str().is_empty() && !p.exists());
        let mut folders: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
        folders.reverse();
        let mut list = unfinished();
        for folder in &folders {
            list.add_made(folder);
        }
        let made = Made { folders };
        let result = std::fs::create_dir_all(path).map_err(failed(path));
        drop(list);
        result.map(|()| made)
    }

    /// There is something in them.
    pub fn keep(&mut self) {
        let mut list = unfinished();
        for folder in self.folders.drain(..) {
            list.drop_made(&folder);
        }
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        let mut list = unfinished();
        for folder in self.folders.iter().rev() {
            // Fails, rightly, where something else has come to stand in it.
            let _ = std::fs::remove_dir(folder);
            list.drop_made(folder);
        }
    }
}

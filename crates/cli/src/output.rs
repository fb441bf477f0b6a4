//! Writing results: each file whole or not at all, and never over a file that was read.
//!
//! A place is tried before the work begins, so that a typing mistake does not cost hours. Each file is written under a temporary
//! name beside its target and then renamed; `result.json` is renamed last. An error and a signal remove the temporary files. A
//! killed process leaves them; a later run in the same folder removes them, because their lock is free.

use crate::console::{print, print_note};
use crate::error::Error;
use gearlash_input::{TABLE_EXTENSIONS, is_rexs};
use gearlash_text::characters::{first_of, plain};
use gearlash_text::{Sources, has_extension};
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use tempfile::NamedTempFile;

static UNFINISHED: Mutex<Unfinished> = Mutex::new(Unfinished {
    temporary: Vec::new(),
    made: Vec::new(),
    written: false,
});

/// Temporary files and new folders of the process. A thread that creates or renames one holds the lock.
pub(super) struct Unfinished {
    temporary: Vec<PathBuf>,
    /// Folders created for results, innermost last.
    made: Vec<PathBuf>,
    /// Whether a file has been renamed to its target.
    pub(super) written: bool,
}

fn unfinished() -> MutexGuard<'static, Unfinished> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes everything unfinished, at the end of a command or for the thread that ends the process. While the lock is held, nothing
/// new begins.
pub(super) fn remove_unfinished() -> MutexGuard<'static, Unfinished> {
    let mut held = unfinished();
    for path in std::mem::take(&mut held.temporary) {
        let _ = std::fs::remove_file(path);
    }
    for path in std::mem::take(&mut held.made).iter().rev() {
        // Fails for a folder with files, which must stay.
        let _ = std::fs::remove_dir(path);
    }
    held
}

/// The error of the file or folder at `path`, unless the error names its own.
fn failed(path: &Path) -> impl Fn(std::io::Error) -> Error {
    move |error| {
        let of_path = |source| Error::Output {
            path: path.to_path_buf(),
            source,
        };
        error.downcast().unwrap_or_else(of_path)
    }
}

/// An error where the file at `path` is one of `sources`.
pub(super) fn check_not_input(sources: &Sources, path: &Path) -> Result<(), Error> {
    match sources.read_as(path) {
        None => Ok(()),
        Some(input) => Err(Error::over_input(path, input)),
    }
}

/// Creates the folder at `path` and the missing ones above it. The end of the command removes those that stay empty.
fn create_folder(path: &Path) -> Result<(), Error> {
    let missing = path
        .ancestors()
        .take_while(|p| !p.as_os_str().is_empty() && !p.exists());
    let mut folders: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
    folders.reverse();
    let mut list = unfinished();
    list.made.append(&mut folders);
    std::fs::create_dir_all(path).map_err(failed(path))
}

const PREFIX: &str = ".gearlash-";
const SUFFIX: &str = ".tmp";
/// Bytes written to the disk at a time. A signal waits for one piece (tuned: 20 ms on a slow disk).
const PIECE: usize = 2 << 20;
/// A younger temporary file may still lack its lock.
const ORPHAN_AFTER: Duration = Duration::from_secs(60);

/// A temporary file in `folder`, locked while the run is alive and removed when dropped.
fn temporary_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // The umask of the process applies.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut list = unfinished();
    let temporary = builder.tempfile_in(folder)?;
    list.temporary.push(temporary.path().to_path_buf());
    // On file systems without locks, files of killed runs stay.
    let _ = temporary.as_file().try_lock();
    Ok(temporary)
}

/// Renames a temporary file to its target. Where that fails, nothing of the file stays.
fn rename(temporary: NamedTempFile, target: &Path) -> std::io::Result<()> {
    let mut list = unfinished();
    // On Windows this needs the file under its old name. The open file stays locked until it has its new one.
    let (_file, path) = temporary.keep()?;
    std::fs::rename(&path, target).inspect_err(|_| {
        let _ = std::fs::remove_file(&path);
    })?;
    list.written = true;
    Ok(())
}

/// Removes the temporary files that killed runs left in `folder`.
fn remove_orphans(folder: &Path) {
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
    target: PathBuf,
}

impl NewFile {
    /// Writes to the `temporary` file of `target`, which its errors name.
    fn new(temporary: &NamedTempFile, target: &Path) -> std::io::Result<NewFile> {
        Ok(NewFile {
            file: temporary.as_file().try_clone()?,
            piece: Vec::new(),
            target: target.to_path_buf(),
        })
    }

    /// Writes `content` and ends the file.
    fn complete(mut self, content: &str) -> std::io::Result<()> {
        self.write_all(content.as_bytes())?;
        self.flush()
    }
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
            let written = self.file.write_all(&self.piece);
            let written = written.and_then(|()| self.file.sync_data());
            let named = |error| std::io::Error::other(failed(&self.target)(error));
            written.map_err(named)?;
            self.piece.clear();
        }
        Ok(())
    }
}

/// The place of one file, tried before the work begins.
pub(super) struct Target {
    /// As the user named it.
    path: PathBuf,
    place: Place,
}

enum Place {
    StandardOutput,
    /// A pipe or a device, which is written to.
    Special,
    /// The temporary file and the target of an ordinary file.
    File(NamedTempFile, PathBuf),
}

impl Place {
    /// An error for a path that names no file or a folder, and for a link that leads nowhere.
    fn of(named: &Path, sources: &Sources) -> Result<Place, Error> {
        let wrong = |reason| Error::Usage(format!("{}: {reason}", named.display()));
        let failed = failed(named);
        if named.file_name().is_none() {
            return Err(wrong("this names no file"));
        }
        check_not_input(sources, named)?;
        let target = match std::fs::metadata(named) {
            Ok(found) if found.is_dir() => {
                return Err(wrong("this is a folder, name a file in it"));
            }
            Ok(found) if found.is_file() => named.canonicalize().map_err(&failed)?,
            Ok(_) => return Ok(Place::Special),
            Err(_) if named.is_symlink() => {
                return Err(wrong(
                    "this is a link to a file that is not there; name that file",
                ));
            }
            Err(error) if error.kind() == ErrorKind::NotFound => {
                create_folder(folder_of(named))?;
                named.to_path_buf()
            }
            Err(error) => return Err(failed(error)),
        };
        remove_orphans(folder_of(&target));
        let temporary = temporary_in(folder_of(&target)).map_err(&failed)?;
        Ok(Place::File(temporary, target))
    }
}

impl Target {
    /// As [`Target::prepare`], for a page, a picture or Markdown. It never overwrites a pair file or table, read or not.
    pub(super) fn prepare_beside(path: PathBuf, sources: &Sources) -> Result<Target, Error> {
        if has_extension(&path, &["png", "jpg", "jpeg", "gif", "webp", "pdf"]) {
            return Err(Error::Usage(format!(
                "{}: no file of this kind is written; name a picture .svg and a page .html",
                path.display()
            )));
        }
        let is_pair_file = has_extension(&path, &["toml", "json"]);
        if is_pair_file || has_extension(&path, &TABLE_EXTENSIONS) || is_rexs(&path) {
            return Err(Error::Usage(format!(
                "{}: this is the place of a pair file or a table, which would be lost; name another file",
                path.display()
            )));
        }
        Target::prepare(path, sources)
    }

    /// As [`Target::prepare_beside`], for an optional `path`.
    pub(super) fn prepare_given(
        path: Option<&PathBuf>,
        sources: &Sources,
    ) -> Result<Option<Target>, Error> {
        path.map(|path| Target::prepare_beside(path.clone(), sources))
            .transpose()
    }

    /// The place that was `given`, else that of the file `name` in the folder of results of an input with this `stem`.
    pub(super) fn given_or_own(
        given: Option<Target>,
        stem: &str,
        name: &str,
        sources: &Sources,
    ) -> Result<Target, Error> {
        given.map_or_else(|| Target::prepare(own_folder(stem).join(name), sources), Ok)
    }

    /// As [`Target::prepare`], but never over an existing file. `command` is named in the error.
    pub(super) fn prepare_new(
        path: &Path,
        sources: &Sources,
        command: &str,
    ) -> Result<Target, Error> {
        let exists = path.exists();
        let target = Target::prepare(path.to_path_buf(), sources)?;
        if exists {
            return Err(Error::Usage(format!(
                "{}: already exists, and {command} never overwrites; name another, or remove it",
                path.display()
            )));
        }
        Ok(target)
    }

    /// Creates the folder of `path` where it is missing and tries to write in it. It never overwrites one of `sources`. A link is
    /// followed.
    pub(super) fn prepare(path: PathBuf, sources: &Sources) -> Result<Target, Error> {
        let place = if path == Path::new("-") {
            Place::StandardOutput
        } else {
            Place::of(&path, sources)?
        };
        Ok(Target { path, place })
    }

    /// Writes `content` in one piece and prints its path. Where that fails, an older file is kept.
    pub(super) fn write(self, content: &str) -> Result<(), Error> {
        let shown = match self.place {
            Place::StandardOutput => String::new(),
            _ => format!("{}\n", plain(&self.path.display().to_string())),
        };
        self.write_silently(content)?;
        print_note(&shown)
    }

    /// Writes `content` without printing its path, for a command whose standard output is its result.
    pub(super) fn write_silently(self, content: &str) -> Result<(), Error> {
        let written = match self.place {
            Place::StandardOutput => return print(content),
            Place::Special => {
                let file = open_special(&self.path);
                file.and_then(|mut file| file.write_all(content.as_bytes()))
            }
            Place::File(temporary, target) => {
                let written = NewFile::new(&temporary, &self.path);
                let written = written.and_then(|file| file.complete(content));
                written.and_then(|()| rename(temporary, &target))
            }
        };
        written.map_err(failed(&self.path))
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

/// The folder of the file at `path`.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// The folder of results of an input with this `stem`.
pub(super) fn own_folder(stem: impl AsRef<Path>) -> PathBuf {
    Path::new("out").join(stem)
}

/// Most files that are listed by name (tuned: a line of a terminal).
const MAX_NAMED: usize = 3;

/// A folder that can be written to.
pub struct OutputFolder {
    /// The files begun so far, by name.
    new: Vec<(String, NamedTempFile)>,
    /// The path as the user named it.
    path: PathBuf,
    own: Box<dyn Fn(&str) -> bool>,
    sources: Sources,
}

impl OutputFolder {
    /// Creates the folder where it is missing and tries to write in it.
    ///
    /// `own` are the names of files that this run may write. Own files of an earlier run are replaced or removed. None of them may be one
    /// of `sources`.
    pub fn prepare(
        path: &Path,
        sources: &Sources,
        own: impl Fn(&str) -> bool + 'static,
    ) -> Result<OutputFolder, Error> {
        create_folder(path)?;
        let folder = OutputFolder {
            new: Vec::new(),
            path: path.to_path_buf(),
            own: Box::new(own),
            sources: sources.clone(),
        };
        remove_orphans(path);
        for name in folder.present().map_err(failed(path))? {
            check_not_input(sources, &path.join(&name))?;
        }
        temporary_in(path).map_err(failed(path))?;
        Ok(folder)
    }

    /// Begins a file. [`OutputFolder::write`] gives it its name.
    pub fn create(&mut self, name: &str) -> Result<NewFile, Error> {
        let target = self.path.join(name);
        check_not_input(&self.sources, &target)?;
        let failed = failed(&target);
        if target.symlink_metadata().is_ok_and(|found| found.is_dir()) {
            return Err(failed(ErrorKind::IsADirectory.into()));
        }
        let temporary = temporary_in(&self.path).map_err(&failed)?;
        let file = NewFile::new(&temporary, &target).map_err(&failed)?;
        self.new.push((name.to_owned(), temporary));
        Ok(file)
    }

    /// Adds a file with this `content`.
    pub fn add(&mut self, name: &str, content: &str) -> Result<(), Error> {
        let written = self.create(name)?.complete(content);
        written.map_err(failed(&self.path))
    }

    /// Opens a file from its beginning; [`OutputFolder::create`] began it.
    pub fn open(&self, name: &str) -> Result<File, Error> {
        let mut new = self.new.iter();
        let opened = match new.find(|(other, _)| other == name) {
            Some((_, temporary)) => File::open(temporary.path()),
            None => Err(ErrorKind::NotFound.into()),
        };
        opened.map_err(failed(&self.path.join(name)))
    }

    /// Adds `files` (name and content) and renames all begun files, `result.json` last. Removes the own files of an earlier run
    /// that this run does not write. Returns a line that names the files and the folder.
    pub fn write(mut self, files: &[(String, String)]) -> Result<String, Error> {
        for (name, content) in files {
            self.add(name, content)?;
        }
        for (name, _) in &self.new {
            check_not_input(&self.sources, &self.path.join(name))?;
        }
        let is_new = |name: &String| self.new.iter().any(|(other, _)| other == name);
        for name in self.present().map_err(failed(&self.path))? {
            let path = self.path.join(&name);
            let is_file = path.symlink_metadata().is_ok_and(|found| found.is_file());
            if !is_new(&name) && is_file {
                std::fs::remove_file(&path).map_err(failed(&path))?;
            }
        }
        let described = self.described();
        // Sorting keeps the order of the others.
        self.new.sort_by_key(|(name, _)| name == "result.json");
        for (name, temporary) in self.new {
            let target = self.path.join(name);
            rename(temporary, &target).map_err(failed(&target))?;
        }
        unfinished().made.clear();
        Ok(described)
    }

    /// The own files in the folder, by name.
    fn present(&self) -> std::io::Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in std::fs::read_dir(&self.path)? {
            let name = entry?.file_name().into_string().ok();
            names.extend(name.filter(|name| (self.own)(name)));
        }
        names.sort();
        Ok(names)
    }

    /// The written files, on one line.
    fn described(&self) -> String {
        let mut list = first_of(self.new.iter().map(|(name, _)| name.clone()), MAX_NAMED);
        if self.new.is_empty() {
            list += "nothing";
        }
        plain(&format!("Written to {}: {list}", self.path.display()))
    }
}

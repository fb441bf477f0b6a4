//! A folder of results.

use super::file::{NewFile, Temporary, remove_orphans};
use super::made::CreatedFolders;
use super::{check_not_input, failed};
use crate::error::Error;
use gearlash_files::Sources;
use gearlash_files::characters::plain;
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// The file that is renamed last.
const LAST: &str = "result.json";
/// Most files that are listed by name (tuned: a line of a terminal).
const MAX_NAMED: usize = 3;

/// A folder that can be written to.
pub struct OutputFolder {
    /// The files begun so far, by name.
    new: Vec<(String, Temporary)>,
    /// The path as the user named it.
    path: PathBuf,
    made: CreatedFolders,
    own: Box<dyn Fn(&str) -> bool>,
    sources: Sources,
}

impl OutputFolder {
    /// Creates the folder where it is missing and tries to write in it.
    ///
    /// `own` are the names of files that this run may write. Own files of an earlier run are replaced or removed. None of them may be one
    /// of `sources`.
    ///
    /// # Errors
    /// [`Error::Output`] with the system's reason; [`Error::OverInput`].
    pub fn prepare(
        path: &Path,
        sources: &Sources,
        own: impl Fn(&str) -> bool + 'static,
    ) -> Result<OutputFolder, Error> {
        let folder = OutputFolder {
            new: Vec::new(),
            made: CreatedFolders::folder(path)?,
            path: path.to_path_buf(),
            own: Box::new(own),
            sources: sources.clone(),
        };
        remove_orphans(path);
        for name in folder.present().map_err(failed(path))? {
            check_not_input(sources, &path.join(&name))?;
        }
        Temporary::new_in(path).map_err(failed(path))?;
        Ok(folder)
    }

    /// Begins a file. [`OutputFolder::write`] gives it its name.
    ///
    /// # Errors
    /// [`Error::Output`], [`Error::OverInput`].
    pub fn create(&mut self, name: &str) -> Result<NewFile, Error> {
        let target = self.path.join(name);
        check_not_input(&self.sources, &target)?;
        let failed = failed(&target);
        if target.symlink_metadata().is_ok_and(|found| found.is_dir()) {
            return Err(failed(ErrorKind::IsADirectory.into()));
        }
        let temporary = Temporary::new_in(&self.path).map_err(&failed)?;
        let file = temporary.writer().map_err(&failed)?;
        self.new.push((name.to_owned(), temporary));
        Ok(file)
    }

    /// Adds a file with this `content`.
    ///
    /// # Errors
    /// As [`OutputFolder::create`].
    pub fn add(&mut self, name: &str, content: &str) -> Result<(), Error> {
        let mut file = self.create(name)?;
        let written = file.write_all(content.as_bytes());
        let written = written.and_then(|()| file.flush());
        written.map_err(self.failed(name))
    }

    /// Opens a file from its beginning; [`OutputFolder::create`] began it.
    ///
    /// # Errors
    /// [`Error::Output`].
    pub fn open(&self, name: &str) -> Result<File, Error> {
        let mut new = self.new.iter();
        let opened = match new.find(|(other, _)| other == name) {
            Some((_, temporary)) => File::open(temporary.path()),
            None => Err(ErrorKind::NotFound.into()),
        };
        opened.map_err(self.failed(name))
    }

    /// The error of the file called `name`.
    pub fn failed(&self, name: &str) -> impl Fn(std::io::Error) -> Error + use<> {
        let path = self.path.join(name);
        move |source| failed(&path)(source)
    }

    /// Adds `files` (name and content) and renames all begun files, `result.json` last. Removes the own files of an earlier run
    /// that this run does not write. Returns a line that names the files and the folder.
    ///
    /// # Errors
    /// [`Error::Output`], [`Error::OverInput`]; each file is then either the old or the new one.
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
        let (last, first): (Vec<_>, Vec<_>) = self.new.iter().partition(|(name, _)| name == LAST);
        for (name, temporary) in first.into_iter().chain(last) {
            let renamed = temporary.rename(&self.path.join(name));
            renamed.map_err(self.failed(name))?;
        }
        self.made.keep();
        Ok(self.described())
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
        let shown = self.new.iter().take(MAX_NAMED).map(|(name, _)| &name[..]);
        let mut list = shown.collect::<Vec<_>>().join(", ");
        if self.new.is_empty() {
            list += "nothing";
        }
        if self.new.len() > MAX_NAMED {
            list += &format!(" and {} more", self.new.len() - MAX_NAMED);
        }
        plain(&format!("Written to {}: {list}", self.path.display()))
    }
}

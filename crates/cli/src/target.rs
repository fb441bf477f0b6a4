//! The target of one file: `-o FILE`, or `-` for standard output.

use super::console::{print, print_note};
use crate::error::Error;
use crate::output::OutputFile;
use gearlash_files::Sources;
use gearlash_files::characters::plain;
use std::path::{Path, PathBuf};

/// The place of one file, tried before the work begins.
pub(super) struct Target {
    path: PathBuf,
    /// `None`: standard output.
    place: Option<OutputFile>,
}

/// Extensions of input files: pair files, tables, protocols and gearbox models.
const READ: [&str; 12] = [
    "toml", "json", "csv", "tsv", "xlsx", "xlsm", "xls", "mka", "mew", "rexs", "rexsj", "rexsz",
];

impl Target {
    /// As [`Target::prepare`], for a page, a picture or Markdown. It never overwrites a pair file or table, read or not.
    ///
    /// # Errors
    /// [`Error::Usage`] for such places; else as [`Target::prepare`].
    pub(super) fn prepare_beside(path: PathBuf, sources: &Sources) -> Result<Target, Error> {
        let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
        if ending.is_some_and(|ending| READ.iter().any(|read| ending == *read)) {
            return Err(Error::Usage(format!(
                "{}: this is the place of a pair file or a table, which would be lost; name another file",
                path.display()
            )));
        }
        Target::prepare(path, sources)
    }

    /// As [`Target::prepare_beside`], for an optional `path`.
    ///
    /// # Errors
    /// As [`Target::prepare_beside`].
    pub(super) fn prepare_given(
        path: Option<&PathBuf>,
        sources: &Sources,
    ) -> Result<Option<Target>, Error> {
        path.map(|path| Target::prepare_beside(path.clone(), sources))
            .transpose()
    }

    /// The place of the file `name` in `out/STEM`, the folder of results of an input with this `stem`.
    ///
    /// # Errors
    /// As [`Target::prepare`].
    pub(super) fn prepare_own(
        stem: &str,
        name: impl AsRef<Path>,
        sources: &Sources,
    ) -> Result<Target, Error> {
        Target::prepare(Path::new("out").join(stem).join(name), sources)
    }

    /// As [`Target::prepare`], but never over an existing file. `command` is named in the error.
    ///
    /// # Errors
    /// [`Error::Usage`] where the file exists; else as [`Target::prepare`].
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

    /// Creates the folder of `path` where it is missing and tries to write in it. It never overwrites one of `sources`.
    ///
    /// # Errors
    /// As [`OutputFile::prepare`].
    pub(super) fn prepare(path: PathBuf, sources: &Sources) -> Result<Target, Error> {
        let place = if path == Path::new("-") {
            None
        } else {
            Some(OutputFile::prepare(&path, sources)?)
        };
        Ok(Target { path, place })
    }

    /// Writes `content` in one piece and prints its path.
    ///
    /// # Errors
    /// [`Error::Output`]; an older file is kept. [`Error::Printing`].
    pub(super) fn write(self, content: &str) -> Result<(), Error> {
        let shown = match self.place {
            Some(_) => format!("{}\n", plain(&self.path.display().to_string())),
            None => String::new(),
        };
        self.write_silently(content)?;
        print_note(&shown)
    }

    /// Writes `content` without printing its path, for a command whose standard output is its result.
    ///
    /// # Errors
    /// As [`Target::write`].
    pub(super) fn write_silently(self, content: &str) -> Result<(), Error> {
        match self.place {
            None => print(content),
            Some(file) => file.write(content),
        }
    }
}

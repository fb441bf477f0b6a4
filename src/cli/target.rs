//! Where one file goes: `-o FILE`, or `-` for standard output.

use super::print;
use crate::characters::plain;
use crate::error::Error;
use crate::output::OutputFolder;
use std::path::{Path, PathBuf};

/// A place for one file, tried before the work begins.
pub(super) struct Target {
    path: PathBuf,
    /// `None`: standard output.
    place: Option<(OutputFolder, String)>,
}

/// Endings of what gearlash reads: pair files and tables.
const READ: [&str; 7] = ["toml", "json", "csv", "tsv", "xlsx", "xlsm", "xls"];

impl Target {
    /// As [`Target::prepare`], for a page, a picture or Markdown: never in the place of `inputs`, or of any other
    /// pair file or table.
    ///
    /// # Errors
    /// [`Error::Usage`] for these places; else as [`Target::prepare`].
    pub(super) fn prepare_beside(path: PathBuf, inputs: &[PathBuf]) -> Result<Target, Error> {
        let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
        let read = ending.is_some_and(|ending| READ.iter().any(|read| ending == *read));
        let real = path.canonicalize().ok();
        let input = |input: &PathBuf| real.is_some() && input.canonicalize().ok() == real;
        if read || inputs.iter().any(input) {
            return Err(Error::Usage(format!(
                "{}: this is the place of a pair file or a table, which would be lost; name another file",
                path.display()
            )));
        }
        Target::prepare(path)
    }

    /// Makes the folder of `path` where it is missing and tries to write in it.
    ///
    /// # Errors
    /// [`Error::Usage`] for a path that names no file or a folder; [`Error::Output`].
    pub(super) fn prepare(path: PathBuf) -> Result<Target, Error> {
        if path == Path::new("-") {
            return Ok(Target { path, place: None });
        }
        let wrong = |reason| Error::Usage(format!("{}: {reason}", path.display()));
        let file = path
            .file_name()
            .ok_or_else(|| wrong("this names no file"))?;
        if path.is_dir() {
            return Err(wrong("this is a folder, name a file in it"));
        }
        let name = file.to_str();
        let name = name.ok_or_else(|| wrong("the name is not Unicode"))?;
        let name = name.to_owned();
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let place = Some((OutputFolder::prepare(folder)?, name));
        Ok(Target { path, place })
    }

    /// Writes `content` in one piece and prints where it is.
    ///
    /// # Errors
    /// [`Error::Output`]; what was there stays.
    pub(super) fn write(self, content: String) -> Result<(), Error> {
        let shown = self
            .place
            .is_some()
            .then(|| format!("{}\n", plain(&self.path.display().to_string())));
        self.write_silently(content)?;
        print(&shown.unwrap_or_default());
        Ok(())
    }

    /// The same, for a command whose standard output is its outcome.
    ///
    /// # Errors
    /// As [`Target::write`].
    pub(super) fn write_silently(self, content: String) -> Result<(), Error> {
        match self.place {
            None => print(&content),
            Some((folder, name)) => {
                folder.write(&[(name, content)])?;
            }
        }
        Ok(())
    }
}

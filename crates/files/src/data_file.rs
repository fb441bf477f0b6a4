//! A data file that a pair file names under `file`.

use super::node::{LONGEST, Node};
use super::source;
use super::table::Table;
use crate::characters::cut;
use crate::error::Problem;
use std::path::{Path, PathBuf};

/// Where it is, and what to call it in a message.
#[derive(Debug, Clone, PartialEq)]
pub struct DataFile {
    /// Dotted path of the key that names it.
    key: String,
    /// As written in the pair file.
    name: String,
    /// Where that is.
    path: PathBuf,
    /// Whether that is outside the pair file's folder, by its real place.
    outside: bool,
}

/// In place of what stands in a file outside the pair file's folder. Such a file is read: engineers have network folders. But
/// whoever writes a pair file and sees the messages must not read by them whatever file the program may read.
const NOT_SHOWN: &str = "(not shown: the file is outside the pair file's folder)";
/// Characters of a path that a message shows: as long as Linux allows.
const LONGEST_PATH: usize = 4096;

impl DataFile {
    /// The file that `table` names under `file`; a relative path starts at the pair file's folder.
    pub fn of(table: &Table) -> Option<DataFile> {
        let Some(Node::Text(name)) = table.get("file") else {
            return None;
        };
        let path = table.place().file(name);
        Some(DataFile {
            key: table.path_of("file"),
            name: name.to_owned(),
            outside: is_outside(&path, table.place().folder()),
            path,
        })
    }

    /// The dotted path of the key that names it.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// As written in the pair file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Its bytes.
    ///
    /// # Errors
    /// Those of [`source::bytes`].
    pub fn bytes(&self) -> Result<Vec<u8>, Problem> {
        source::bytes(&self.path).map_err(|problem| self.problem(problem.reason, problem.help))
    }

    /// `text` of the file for a message, in quotes.
    pub fn quote(&self, text: &str) -> String {
        match self.outside {
            true => NOT_SHOWN.to_owned(),
            false => Node::Text(text.to_owned()).shown(),
        }
    }

    /// `text` of the file for a message, as it stands.
    pub fn bare(&self, text: &str) -> String {
        match self.outside {
            true => NOT_SHOWN.to_owned(),
            false => cut(text, LONGEST),
        }
    }

    /// What was found in the file, in words that may hold names from it and have been cut already.
    pub fn found(&self, words: String) -> String {
        match self.outside {
            true => NOT_SHOWN.to_owned(),
            false => words,
        }
    }

    /// A problem in the file. What the reason says of its content has been through [`DataFile::quote`] or [`DataFile::bare`].
    pub fn problem(&self, reason: impl std::fmt::Display, help: impl Into<String>) -> Problem {
        Problem {
            key: self.key.clone(),
            value: Some(Node::Text(self.name.clone()).shown()),
            reason: format!(
                "{}: {reason}",
                cut(&self.path.display().to_string(), LONGEST_PATH)
            ),
            help: help.into(),
        }
    }

    /// A problem of one line.
    pub fn problem_at(
        &self,
        line: u64,
        reason: impl std::fmt::Display,
        help: impl Into<String>,
    ) -> Problem {
        self.problem(format!("line {line}: {reason}"), help)
    }
}

/// Whether the real place of `path`, links followed, is not below `folder`. Of one that is not there nothing is read.
fn is_outside(path: &Path, folder: &Path) -> bool {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    match (path.canonicalize(), folder.canonicalize()) {
        (Ok(path), Ok(folder)) => !path.starts_with(folder),
        _ => true,
    }
}

/// The line on which a record stands; its position is that of the blank lines before it.
pub fn line_of(text: &str, start: &csv::Position) -> u64 {
    let rest = text.get(start.byte() as usize..).unwrap_or_default();
    let blank = rest.bytes().take_while(|&b| b == b'\r' || b == b'\n');
    start.line() + blank.filter(|&b| b == b'\n').count() as u64
}

//! A data file that a pair file names under `file`.

use super::problems::Problems;
use super::source;
use super::table::Table;
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
}

impl DataFile {
    /// The file that `table` names under `file`; a relative path starts at the pair file's folder.
    pub fn of(table: &Table, needed: &str, problems: &mut Problems) -> Option<DataFile> {
        let entry = table.need("file", needed, problems)?;
        let name = problems.keep(entry.text(&format!("give {needed}")))?;
        Some(DataFile {
            key: table.path_of("file"),
            name: name.to_owned(),
            path: table.place().file(name),
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

    /// Its text.
    ///
    /// # Errors
    /// Those of [`source::text`].
    pub fn text(&self) -> Result<String, Problem> {
        source::text(&self.path).map_err(|problem| self.problem(problem.reason, problem.way_out))
    }

    /// Its bytes.
    ///
    /// # Errors
    /// Those of [`source::bytes`].
    pub fn bytes(&self) -> Result<Vec<u8>, Problem> {
        source::bytes(&self.path).map_err(|problem| self.problem(problem.reason, problem.way_out))
    }

    /// A problem in the file.
    pub fn problem(&self, reason: impl std::fmt::Display, way_out: impl Into<String>) -> Problem {
        Problem {
            key: self.key.clone(),
            value: Some(format!("{:?}", self.name)),
            reason: format!("{}: {reason}", self.path.display()),
            way_out: way_out.into(),
        }
    }

    /// A problem of one line.
    pub fn problem_at(
        &self,
        line: u64,
        reason: impl std::fmt::Display,
        way_out: impl Into<String>,
    ) -> Problem {
        self.problem(format!("line {line}: {reason}"), way_out)
    }
}

/// The line on which a record stands; its position is that of the blank lines before it.
pub fn line_of(text: &str, start: &csv::Position) -> u64 {
    let rest = text.get(start.byte() as usize..).unwrap_or_default();
    let blank = rest.bytes().take_while(|&b| b == b'\r' || b == b'\n');
    start.line() + blank.filter(|&b| b == b'\n').count() as u64
}

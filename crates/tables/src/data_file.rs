//! A data file that a pair file names under `file`.

use gearlash_text::characters::cut;
use gearlash_text::node::LONGEST;
use gearlash_text::{Node, Problem, Reading, Table, source};
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// A data file: its path, and its name in messages.
#[derive(Debug, Clone)]
pub struct DataFile {
    reading: Rc<Reading>,
    /// Dotted path of the key that names it.
    key: String,
    name: String,
    path: PathBuf,
    /// Whether its real place is outside the pair file's folder.
    outside: bool,
}

/// Replaces text of a file outside the pair file's folder. The file is read, because engineers have network folders.
/// Messages must not show the content of such a file to whoever wrote the pair file.
const NOT_SHOWN: &str = "(not shown: the file is outside the pair file's folder)";
/// Characters of a path that a message shows: as long as Linux allows.
const LONGEST_PATH: usize = 4096;

impl DataFile {
    /// The file that `table` names under `file`; a relative path starts at the pair file's folder.
    pub fn of(table: &Table) -> Option<DataFile> {
        let Some(Node::Text(name)) = table.get("file") else {
            return None;
        };
        let reading = table.reading();
        let path = reading.file(name);
        Some(DataFile {
            reading: Rc::clone(reading),
            key: table.path_of("file"),
            name: name.to_owned(),
            outside: reading.is_outside(&path),
            path,
        })
    }

    /// The dotted path of the key that names it.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The name that the pair file states.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Its bytes; `None` where they cannot be read.
    pub fn bytes(&self) -> Option<Vec<u8>> {
        let bytes = match self.reading.files() {
            Some(files) => files.bytes(&self.path),
            None => source::bytes(&self.path),
        };
        let bytes = bytes.map_err(|problem| self.problem(problem.reason, problem.help));
        self.reading.keep(bytes)
    }

    /// `text` of the file for a message, in quotes.
    pub fn quote(&self, text: &str) -> String {
        if self.outside {
            NOT_SHOWN.to_owned()
        } else {
            Node::Text(text.to_owned()).shown()
        }
    }

    /// `text` of the file for a message, as written.
    pub fn bare(&self, text: &str) -> String {
        if self.outside {
            NOT_SHOWN.to_owned()
        } else {
            cut(text, LONGEST)
        }
    }

    /// `words` about content of the file. Names from it in them are already cut to length.
    pub fn found(&self, words: String) -> String {
        if self.outside {
            NOT_SHOWN.to_owned()
        } else {
            words
        }
    }

    /// The reading of the pair file.
    pub fn reading(&self) -> &Reading {
        &self.reading
    }

    /// A problem in the file. The caller passes its content through [`DataFile::quote`] or [`DataFile::bare`].
    pub fn problem(&self, reason: impl Display, help: impl Display) -> Problem {
        let path = cut(&self.path.display().to_string(), LONGEST_PATH);
        Problem {
            key: self.key.clone(),
            value: Some(Node::Text(self.name.clone()).shown()),
            reason: format!("{path}: {reason}"),
            help: help.to_string(),
        }
    }

    /// A problem in one line.
    pub fn problem_at(&self, line: u64, reason: impl Display, help: impl Display) -> Problem {
        self.problem(format!("line {line}: {reason}"), help)
    }

    /// Adds a problem.
    pub fn add(&self, reason: impl Display, help: impl Display) {
        self.reading.add(self.problem(reason, help));
    }

    /// Adds a problem in one line.
    pub fn add_at(&self, line: u64, reason: impl Display, help: impl Display) {
        self.reading.add(self.problem_at(line, reason, help));
    }

    /// Adds a problem; always `None`.
    pub fn refuse<T>(&self, reason: impl Display, help: impl Display) -> Option<T> {
        self.reading.refuse(self.problem(reason, help))
    }

    /// Adds a problem of one line; always `None`.
    pub fn refuse_at<T>(&self, line: u64, reason: impl Display, help: impl Display) -> Option<T> {
        self.reading.refuse(self.problem_at(line, reason, help))
    }

    /// The result of `read`; `None` where it adds a problem. Only the first dozen are reported.
    pub fn list<T>(&self, read: impl FnOnce() -> Option<T>) -> Option<T> {
        self.reading.list(&self.key, read)
    }
}

/// The line of a record. `start` counts from the blank lines before it.
pub fn line_of(text: &str, start: &csv::Position) -> u64 {
    let rest = text.get(start.byte() as usize..).unwrap_or_default();
    let blank = rest.bytes().take_while(|&b| b == b'\r' || b == b'\n');
    start.line() + blank.filter(|&b| b == b'\n').count() as u64
}

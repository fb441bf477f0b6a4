//! Errors of an input file: every problem at once, each with its key and a remedy.

use crate::{characters, location};
use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// One thing wrong with one value of a pair file.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// Dotted path of the key, such as `wheel.runout.high_tooth`; empty for the whole file.
    pub key: String,
    /// The value as written, where there is one.
    pub value: Option<String>,
    /// The fault, and the allowed values.
    pub reason: String,
    /// The remedy.
    pub help: String,
}

impl Problem {
    /// A fault of the whole file.
    pub fn of_file(reason: impl fmt::Display, help: impl fmt::Display) -> Problem {
        Problem::at("", reason, help)
    }

    /// A fault at a key, without its value.
    pub fn at(
        key: impl Into<String>,
        reason: impl fmt::Display,
        help: impl fmt::Display,
    ) -> Problem {
        Problem {
            key: key.into(),
            value: None,
            reason: reason.to_string(),
            help: help.to_string(),
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.key.is_empty() {
            write!(f, "{}", self.key)?;
            if let Some(value) = &self.value {
                write!(f, " = {value}")?;
            }
            write!(f, ": ")?;
        }
        write!(f, "{}; {}", self.reason, self.help)
    }
}

/// An input file that cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", self.lines().join("\n"))]
pub struct InputError {
    /// The file.
    pub file: PathBuf,
    /// At least one.
    pub problems: Vec<Problem>,
    /// The text of a TOML file; empty for other formats.
    pub text: String,
}

impl InputError {
    /// The error of a file, without its text.
    pub fn of(file: &Path, problems: Vec<Problem>) -> InputError {
        InputError {
            file: file.to_path_buf(),
            problems,
            text: String::new(),
        }
    }

    /// The lines of the message: one per problem, prefixed by the file. Text of the file breaks no line and acts on no terminal
    /// or log.
    pub fn lines(&self) -> Vec<String> {
        let problems = self.problems.iter();
        let line = |problem| characters::line(&format!("{}: {problem}", self.file.display()));
        problems.map(line).collect()
    }

    /// The line of each problem in a TOML file, from 1, where its place is known.
    pub fn lines_of_problems(&self) -> Vec<Option<usize>> {
        let keys = self.problems.iter().map(|problem| problem.key.as_str());
        location::lines_of_keys(&self.text, keys)
    }

    /// The place of each problem in a TOML file, in bytes of its text; `None` for a problem without one, and in JSON.
    pub fn spans(&self) -> Vec<Option<Range<usize>>> {
        let keys = self.problems.iter().map(|problem| problem.key.as_str());
        location::of_keys(&self.text, keys)
    }
}

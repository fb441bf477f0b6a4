//! The keys and values of one table of a checked file, by their dotted paths.

use super::location::below;
use super::node::Node;
use super::reading::Reading;
use crate::error::Problem;
use serde::de::DeserializeOwned;
use std::fmt::Display;
use std::rc::Rc;

/// A table and its dotted path, which is empty for the whole file.
#[derive(Debug, Clone)]
pub struct Table<'a> {
    path: String,
    reading: &'a Rc<Reading>,
    entries: &'a [(String, Node)],
}

impl<'a> Table<'a> {
    /// The table at `path` of a file.
    pub fn new(path: &str, reading: &'a Rc<Reading>, entries: &'a [(String, Node)]) -> Table<'a> {
        Table {
            path: path.to_owned(),
            reading,
            entries,
        }
    }

    /// The table at the dotted `path` below this one; empty where it is absent.
    pub fn below(&self, path: &str) -> Table<'a> {
        let entries = self.get(path).map_or(&[][..], Node::entries);
        Table::new(&self.path_of(path), self.reading, entries)
    }

    /// The reading of its file.
    pub fn reading(&self) -> &'a Rc<Reading> {
        self.reading
    }

    /// Its keys and values.
    pub fn entries(&self) -> &'a [(String, Node)] {
        self.entries
    }

    /// The dotted `path` below this table as a path of the file.
    pub fn path_of(&self, path: &str) -> String {
        below(&self.path, path)
    }

    /// The value at the dotted `path` below this table, where there is one.
    pub fn get(&self, path: &str) -> Option<&'a Node> {
        let mut entries = self.entries;
        let mut found = None;
        for name in path.split('.') {
            let (_, node) = entries.iter().find(|(key, _)| key == name)?;
            entries = node.entries();
            found = Some(node);
        }
        found
    }

    /// Whether there is a value at the dotted `path` below this table.
    pub fn has(&self, path: &str) -> bool {
        self.get(path).is_some()
    }

    /// Whether there is a value at the dotted `path` below this table, perhaps misspelt.
    pub fn means(&self, path: &str) -> bool {
        let path_in_file = self.path_of(path);
        self.has(path) || self.reading.has_bad(|bad| bad == path_in_file)
    }

    /// Whether neither the value at the dotted `path` below this table nor any in it is bad; an absent one is not.
    pub fn is_good(&self, path: &str) -> bool {
        let path = self.path_of(path);
        let below = |path: &str, above: &str| {
            let rest = path.strip_prefix(above);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        let is_part = |bad: &str| path.is_empty() || below(bad, &path) || below(&path, bad);
        !self.reading.has_bad(is_part)
    }

    /// The value at the dotted `path` below this table of a checked file: `None` where it is bad, `Some(None)` where it is absent.
    pub fn read<T: DeserializeOwned>(&self, path: &str) -> Option<Option<T>> {
        self.is_good(path).then_some(())?;
        let Some(node) = self.get(path) else {
            return Some(None);
        };
        // The schema allows nothing that serde refuses.
        self.keep(path, node.to::<T>().map(Some), "correct it")
    }

    /// A problem with the value at the dotted `path` below this table, present or not.
    pub fn problem(&self, path: &str, reason: impl Display, help: impl Display) -> Problem {
        Problem {
            key: self.path_of(path),
            value: self.get(path).map(Node::shown),
            reason: reason.to_string(),
            help: help.to_string(),
        }
    }

    /// Adds [`Table::problem`].
    pub fn add(&self, path: &str, reason: impl Display, help: impl Display) {
        self.reading.add(self.problem(path, reason, help));
    }

    /// Adds [`Table::problem`]; always `None`.
    pub fn refuse<T>(&self, path: &str, reason: impl Display, help: impl Display) -> Option<T> {
        self.reading.refuse(self.problem(path, reason, help))
    }

    /// The value; for an error `None`, with [`Table::problem`] added.
    pub fn keep<T, E: Display>(
        &self,
        path: &str,
        result: Result<T, E>,
        help: impl Display,
    ) -> Option<T> {
        let added = |error: E| self.add(path, error, help);
        result.map_err(added).ok()
    }
}

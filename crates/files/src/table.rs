//! The keys and values of one table of a checked file, by their dotted paths.

use super::node::Node;
use super::place::Place;
use crate::error::Problem;

/// A table and the dotted path it stands under, empty for the whole file.
#[derive(Debug, Clone)]
pub struct Table<'a> {
    path: String,
    /// The pair file's: where the files it names are.
    place: &'a Place,
    entries: &'a [(String, Node)],
}

impl<'a> Table<'a> {
    /// The table at `path` of a pair file in `place`.
    pub fn new(path: &str, place: &'a Place, entries: &'a [(String, Node)]) -> Table<'a> {
        Table {
            path: path.to_owned(),
            place,
            entries,
        }
    }

    /// The table at the dotted `path` below this one, empty where it is not there.
    pub fn below(&self, path: &str) -> Table<'a> {
        let entries = self.get(path).map_or(&[][..], Node::entries);
        Table::new(&self.path_of(path), self.place, entries)
    }

    /// Where the pair file lies.
    pub fn place(&self) -> &'a Place {
        self.place
    }

    /// Keys and values.
    pub fn entries(&self) -> &'a [(String, Node)] {
        self.entries
    }

    /// The dotted `path` below this table, seen from the file.
    pub fn path_of(&self, path: &str) -> String {
        if self.path.is_empty() {
            path.to_owned()
        } else {
            format!("{}.{path}", self.path)
        }
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

    /// A problem with the value at the dotted `path` below this table, given or not.
    pub fn problem(
        &self,
        path: &str,
        reason: impl Into<String>,
        help: impl Into<String>,
    ) -> Problem {
        Problem {
            key: self.path_of(path),
            value: self.get(path).map(Node::shown),
            reason: reason.into(),
            help: help.into(),
        }
    }
}

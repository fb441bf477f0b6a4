//! One table of a pair file: its keys checked against the known ones, its values read by type.
//!
//! Every reading method adds what is wrong to the [`Problems`] and returns
//! `None`; a caller that only reads on what is `Some` reports no problem that
//! merely follows from another.

use super::entry::{Entry, Limits, quoted, whole_in};
use super::nearest::{is_slip, nearest};
use super::node::Node;
use super::place::Place;
use super::problems::Problems;
use super::synonyms::synonym;
use super::unmodelled;
use crate::error::Problem;
use std::ops::RangeInclusive;

/// A table and the dotted path it stands under, empty for the whole file.
#[derive(Debug, Clone)]
pub struct Table<'a> {
    path: String,
    /// The pair file's: where the files it names are.
    place: &'a Place,
    entries: &'a [(String, Node)],
    /// Known keys that an unknown one almost spells: not missing, but mistyped.
    mistyped: Vec<&'static str>,
}

impl<'a> Table<'a> {
    /// The table at `path` of a pair file in `place`; every key that is not `known` is a problem.
    pub fn new(
        path: &str,
        place: &'a Place,
        entries: &'a [(String, Node)],
        known: &'static [&'static str],
        problems: &mut Problems,
    ) -> Table<'a> {
        let mut table = Table {
            path: path.to_owned(),
            place,
            entries,
            mistyped: Vec::new(),
        };
        let mut unknown = Problems::of_list();
        for (name, node) in entries {
            if known.contains(&name.as_str()) {
                continue;
            }
            if unknown.is_full() {
                unknown.count_one();
                continue;
            }
            let path = table.path_of(&printable(name));
            if let Some((reason, help)) = unmodelled::gone(&path) {
                unknown.add(Problem {
                    key: path,
                    value: Some(node.shown()),
                    reason: reason.to_owned(),
                    help: help.to_owned(),
                });
                continue;
            }
            let unmodelled = unmodelled::why(name);
            let help = match nearest(name, known) {
                _ if unmodelled.is_some() => "remove it".to_owned(),
                Some((nearest, distance)) if is_slip(name, distance) => {
                    table.mistyped.push(nearest);
                    format!("did you mean `{nearest}`? If not, remove it")
                }
                _ => match synonym(name, known) {
                    Some(key) => {
                        table.mistyped.push(key);
                        format!("did you mean `{key}`? If not, remove it")
                    }
                    None => "remove it".to_owned(),
                },
            };
            unknown.add(Problem {
                key: path,
                value: Some(node.shown()),
                reason: unmodelled.map_or_else(
                    || format!("unknown key, expected {}", quoted(known, "`")),
                    str::to_owned,
                ),
                help,
            });
        }
        problems.add_list(path, unknown);
        table
    }

    /// Where the pair file lies.
    pub fn place(&self) -> &'a Place {
        self.place
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
    pub fn get(&self, path: &str) -> Option<Entry<'a>> {
        let mut entries = self.entries;
        let (tables, name) = path.rsplit_once('.').unwrap_or(("", path));
        for table in tables.split('.').filter(|table| !table.is_empty()) {
            match entries.iter().find(|(key, _)| key == table) {
                Some((_, Node::Table(inner))) => entries = inner,
                _ => return None,
            }
        }
        let (_, node) = entries.iter().find(|(key, _)| key == name)?;
        Some(Entry::new(self.path_of(path), node))
    }

    /// Whether there is a value of `name`.
    pub fn has(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    /// Whether an unknown key almost spells `name`.
    pub fn is_mistyped(&self, name: &str) -> bool {
        self.mistyped.contains(&name)
    }

    /// The value of `name`: `Some(None)` when it is not there, `None` when it is mistyped.
    pub fn optional(&self, name: &str) -> Option<Option<Entry<'a>>> {
        let entry = self.get(name);
        (entry.is_some() || !self.is_mistyped(name)).then_some(entry)
    }

    /// What `read` makes of the value of `name`: `Some(None)` when it is not there, `None` when it is mistyped or wrong.
    pub fn optional_as<T>(
        &self,
        name: &str,
        problems: &mut Problems,
        read: impl FnOnce(&Entry<'a>) -> Result<T, Problem>,
    ) -> Option<Option<T>> {
        match self.optional(name)? {
            Some(entry) => problems.keep(read(&entry)).map(Some),
            None => Some(None),
        }
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
            value: self.get(path).map(|entry| entry.node().shown()),
            reason: reason.into(),
            help: help.into(),
        }
    }

    /// `name` stands beside none of `others`, or it is a problem; `allowed` says what may be.
    pub fn alone(
        &self,
        name: &str,
        others: &[&str],
        allowed: &str,
        problems: &mut Problems,
    ) -> Option<()> {
        let Some(second) = others.iter().find(|other| self.has(other)) else {
            return Some(());
        };
        problems.add(self.problem(
            name,
            format!("given together with {second}, allowed is {allowed}"),
            "remove one or the other",
        ));
        None
    }

    /// The value of `name`; missing is a problem.
    pub fn need(&self, name: &str, needed: &str, problems: &mut Problems) -> Option<Entry<'a>> {
        let entry = self.get(name);
        if entry.is_none() && !self.is_mistyped(name) {
            let place = if self.path.is_empty() {
                "the file".to_owned()
            } else {
                format!("[{}]", self.path)
            };
            problems.add(self.problem(
                name,
                format!("missing, expected {needed}"),
                format!("add `{name}` to {place}"),
            ));
        }
        entry
    }

    /// A number that must be there.
    pub fn number(&self, name: &str, limits: &Limits, problems: &mut Problems) -> Option<f64> {
        let entry = self.need(name, limits.allowed, problems)?;
        problems.keep(entry.number(limits))
    }

    /// A number, or `default` when it is not there.
    pub fn number_or(
        &self,
        name: &str,
        default: f64,
        limits: &Limits,
        problems: &mut Problems,
    ) -> Option<f64> {
        match self.optional(name)? {
            Some(entry) => problems.keep(entry.number(limits)),
            None => Some(default),
        }
    }

    /// A whole number that must be there.
    pub fn whole(
        &self,
        name: &str,
        range: RangeInclusive<u32>,
        help: &str,
        problems: &mut Problems,
    ) -> Option<u32> {
        let entry = self.need(name, &whole_in(&range), problems)?;
        problems.keep(entry.whole(range, help))
    }

    /// One of `names`, the first when it is not there.
    pub fn choice_or_first<T: Copy>(
        &self,
        name: &str,
        names: &[(&'static str, T)],
        problems: &mut Problems,
    ) -> Option<T> {
        match self.optional(name)? {
            Some(entry) => problems.keep(entry.choice(names)),
            None => names.first().map(|&(_, choice)| choice),
        }
    }

    /// A list of numbers, empty when it is not there.
    pub fn numbers(
        &self,
        name: &str,
        limits: &Limits,
        problems: &mut Problems,
    ) -> Option<Vec<f64>> {
        match self.optional(name)? {
            Some(entry) => entry.numbers(limits, problems),
            None => Some(Vec::new()),
        }
    }

    /// The table `name`, empty when it is not there; `None` when it is mistyped or no table.
    pub fn table(
        &self,
        name: &str,
        known: &'static [&'static str],
        problems: &mut Problems,
    ) -> Option<Table<'a>> {
        let entries = match self.optional(name)? {
            None => &[],
            Some(entry) => match entry.node() {
                Node::Table(entries) => entries.as_slice(),
                _ => {
                    let allowed = format!("a table of {}", quoted(known, "`"));
                    let help = format!("write [{}] and its keys below", self.path_of(name));
                    problems.add(entry.wrong_type(&allowed, help));
                    return None;
                }
            },
        };
        let path = self.path_of(name);
        Some(Table::new(&path, self.place, entries, known, problems))
    }
}

/// An unknown key for a message: as it stands, in quotes when it is no bare TOML key.
fn printable(name: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.len() <= 64 && name.chars().all(bare) {
        name.to_owned()
    } else {
        Node::Text(name.to_owned()).shown()
    }
}

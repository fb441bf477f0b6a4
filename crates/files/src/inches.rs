//! Lengths in inches: a key `_in` in place of `_mm`, turned into mm before the file is checked.

use crate::check::below;
use crate::error::Problem;
use crate::node::Node;
use crate::numbers::rounded;
use crate::reading::Reading;
use std::collections::{HashMap, HashSet};

/// Length of an inch, mm.
pub const MM_PER_INCH: f64 = 25.4;

/// Keys in inches that are remembered: a pair file has some dozens. Problems of others name the key in mm.
const MOST_REMEMBERED: usize = 1000;

/// The keys in inches of a file, by their dotted paths in mm: path and value as they stand in the file.
#[derive(Debug, Default)]
pub struct Inches(HashMap<String, (String, String)>);

impl Inches {
    fn add(&mut self, in_mm: String, stated: &str, node: &Node) {
        if self.0.len() < MOST_REMEMBERED {
            self.0.insert(in_mm, (stated.to_owned(), node.shown()));
        }
    }

    /// Puts the key and the value of `problem` as they stand in the file.
    pub fn restore(&self, problem: &mut Problem) {
        let key = &problem.key;
        let inner = key.match_indices(['.', '[']).map(|(at, _)| at);
        let ends = [key.len()].into_iter().chain(inner.rev());
        let mut found = ends.filter_map(|end| Some((end, self.0.get(&key[..end])?)));
        let Some((end, (stated, value))) = found.next() else {
            return;
        };
        if end == key.len() && problem.value.is_some() {
            problem.value = Some(value.clone());
        }
        problem.key = format!("{stated}{}", &key[end..]);
    }
}

/// Turns all lengths of a file into mm.
pub fn to_mm(entries: &mut Vec<(String, Node)>, reading: &Reading) {
    entries_to_mm(entries, ["", ""], false, reading);
}

/// The name in mm of a key in inches.
fn name_in_mm((key, node): &(String, Node)) -> Option<String> {
    let name = key.strip_suffix("in")?;
    let is_length = (name.is_empty() || name.ends_with('_')) && !matches!(node, Node::Text(_));
    is_length.then(|| format!("{name}mm"))
}

/// Entries at a path in mm and at the path as it stands in the file; `in_inches`: the key above states the unit.
fn entries_to_mm(
    entries: &mut Vec<(String, Node)>,
    paths: [&str; 2],
    in_inches: bool,
    reading: &Reading,
) {
    let keys: HashSet<&str> = entries.iter().map(|(key, _)| &key[..]).collect();
    let names = entries.iter().filter_map(name_in_mm);
    let twice: HashSet<String> = names.filter(|name| keys.contains(&name[..])).collect();
    entries.retain(|entry| {
        let in_mm = name_in_mm(entry).filter(|name| twice.contains(name));
        if let Some(in_mm) = &in_mm {
            reading.add(Problem {
                key: below(paths[1], &entry.0),
                value: Some(entry.1.shown()),
                reason: format!("given together with {in_mm}, allowed is one of them"),
                help: "remove one or the other".to_owned(),
            });
        }
        in_mm.is_none()
    });
    for entry in entries {
        let stated = below(paths[1], &entry.0);
        let in_mm = name_in_mm(entry);
        let has_unit = ["mm", "um", "deg"]
            .iter()
            .any(|unit| entry.0.ends_with(unit));
        let in_inches = in_mm.is_some() || in_inches && !has_unit;
        if let Some(in_mm) = in_mm {
            let path = below(paths[0], &in_mm);
            reading.inches().add(path, &stated, &entry.1);
            entry.0 = in_mm;
        }
        let path = below(paths[0], &entry.0);
        value_to_mm(&mut entry.1, [&path, &stated], in_inches, reading);
    }
}

fn value_to_mm(node: &mut Node, paths: [&str; 2], in_inches: bool, reading: &Reading) {
    // A millionth of a nm: 1.5 in is the f64 of 38.1.
    let length = |inches: f64| Node::Number(rounded(inches * MM_PER_INCH, 12));
    match node {
        Node::Whole(inches) if in_inches => *node = length(*inches as f64),
        Node::Number(inches) if in_inches => *node = length(*inches),
        Node::List(list) => {
            for (place, node) in (1..).zip(list) {
                if node.entries().is_empty() {
                    value_to_mm(node, paths, in_inches, reading);
                } else {
                    let [in_mm, stated] = paths.map(|path| format!("{path}[{place}]"));
                    value_to_mm(node, [&in_mm, &stated], in_inches, reading);
                }
            }
        }
        Node::Table(entries) => entries_to_mm(entries, paths, in_inches, reading),
        _ => {}
    }
}

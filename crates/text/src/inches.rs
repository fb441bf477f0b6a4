//! Lengths in inches: a key `_in` in place of `_mm`, or of `_um` in a band, turned into it before the file is checked.

use crate::error::Problem;
use crate::location::below;
use crate::node::Node;
use crate::numbers::rounded;
use std::collections::{HashMap, HashSet};

/// Length of an inch, mm.
pub const MM_PER_INCH: f64 = 25.4;

/// Keys in inches that are remembered: a pair file has some dozens. Problems of others name the key in mm.
const MAX_REMEMBERED: usize = 1000;

/// The keys in inches of a file by their dotted paths in mm, each with path and value as written.
#[derive(Debug, Default)]
pub struct Inches {
    stated: HashMap<String, (String, String)>,
    /// The problems of keys that are given in both units.
    pub in_both_units: Vec<Problem>,
}

/// The name in mm or µm of a key in inches.
fn name_in_mm((key, node): &(String, Node)) -> Option<String> {
    let name = key.strip_suffix("in")?;
    let is_length = (name.is_empty() || name.ends_with('_')) && !matches!(node, Node::Text(_));
    let of_band = ["tolerance_", "upper_", "lower_"].contains(&name);
    is_length.then(|| format!("{name}{}", if of_band { "um" } else { "mm" }))
}

impl Inches {
    /// Converts all lengths of a file to mm.
    pub fn to_mm(entries: &mut Vec<(String, Node)>) -> Inches {
        let mut inches = Inches::default();
        inches.entries(entries, ["", ""], None);
        inches
    }

    /// Puts key and value of `problem` as written in the file.
    pub fn restore(&self, problem: &mut Problem) {
        let key = &problem.key;
        let inner = key.match_indices(['.', '[']).map(|(at, _)| at);
        let ends = [key.len()].into_iter().chain(inner.rev());
        let mut found = ends.filter_map(|end| Some((end, self.stated.get(&key[..end])?)));
        let Some((end, (stated, value))) = found.next() else {
            return;
        };
        if end == key.len() && problem.value.is_some() {
            problem.value = Some(value.clone());
        }
        problem.key = format!("{stated}{}", &key[end..]);
    }

    /// Converts entries. `paths` are the path in mm and as written; `unit`: the inch of the key above.
    fn entries(&mut self, entries: &mut Vec<(String, Node)>, paths: [&str; 2], unit: Option<f64>) {
        let keys: HashSet<&str> = entries.iter().map(|(key, _)| &key[..]).collect();
        let names = entries.iter().filter_map(name_in_mm);
        let in_both_units: HashSet<String> =
            names.filter(|name| keys.contains(&name[..])).collect();
        entries.retain(|entry| {
            let in_mm = name_in_mm(entry).filter(|name| in_both_units.contains(name));
            let reported = in_mm
                .as_ref()
                .filter(|_| self.in_both_units.len() < MAX_REMEMBERED);
            self.in_both_units.extend(reported.map(|in_mm| Problem {
                key: below(paths[1], &entry.0),
                value: Some(entry.1.shown()),
                reason: format!("given together with {in_mm}, allowed is one of them"),
                help: "remove one or the other".to_owned(),
            }));
            in_mm.is_none()
        });
        for entry in entries {
            let stated = below(paths[1], &entry.0);
            let in_mm = name_in_mm(entry);
            let has_unit = ["mm", "um", "deg"]
                .iter()
                .any(|unit| entry.0.ends_with(unit));
            let unit = match &in_mm {
                Some(name) if name.ends_with("um") => Some(1e3 * MM_PER_INCH),
                Some(_) => Some(MM_PER_INCH),
                None => unit.filter(|_| !has_unit),
            };
            if let Some(in_mm) = in_mm {
                if self.stated.len() < MAX_REMEMBERED {
                    let written = (stated.clone(), entry.1.shown());
                    self.stated.insert(below(paths[0], &in_mm), written);
                }
                entry.0 = in_mm;
            }
            let path = below(paths[0], &entry.0);
            self.value(&mut entry.1, [&path, &stated], unit);
        }
    }

    fn value(&mut self, node: &mut Node, paths: [&str; 2], unit: Option<f64>) {
        // Rounded to a millionth of a nm: 1.5 in is then exactly the f64 of 38.1.
        let length = |inches: f64, unit: f64| Node::Number(rounded(inches * unit, 12));
        match (&mut *node, unit) {
            (Node::Whole(inches), Some(unit)) => *node = length(*inches as f64, unit),
            (Node::Number(inches), Some(unit)) => *node = length(*inches, unit),
            (Node::List(list), _) => {
                for (place, node) in (1..).zip(list) {
                    if node.entries().is_empty() {
                        self.value(node, paths, unit);
                    } else {
                        let [in_mm, stated] = paths.map(|path| format!("{path}[{place}]"));
                        self.value(node, [&in_mm, &stated], unit);
                    }
                }
            }
            (Node::Table(entries), _) => self.entries(entries, paths, unit),
            _ => {}
        }
    }
}

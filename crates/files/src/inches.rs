//! Lengths in inches: a key `_in` in place of `_mm`, turned into mm before the file is checked.

use crate::error::Problem;
use crate::node::Node;
use crate::numbers::rounded;
use crate::reading::Reading;

/// Length of an inch, mm.
pub const MM_PER_INCH: f64 = 25.4;

/// A key in inches.
#[derive(Debug)]
pub struct Inches {
    /// Its dotted path in mm.
    in_mm: String,
    /// Its dotted path and its value as they stand in the file.
    stated: String,
    value: String,
}

impl Inches {
    /// Puts the key and the value of `problem` as they stand in the file.
    pub fn restore(all: &[Inches], problem: &mut Problem) {
        let rest = |one: &Inches| {
            let rest = problem.key.strip_prefix(&one.in_mm)?;
            (rest.is_empty() || rest.starts_with(['.', '['])).then(|| rest.to_owned())
        };
        let found = all.iter().filter_map(|one| Some((one, rest(one)?)));
        let Some((inches, rest)) = found.max_by_key(|(one, _)| one.in_mm.len()) else {
            return;
        };
        if rest.is_empty() && problem.value.is_some() {
            problem.value = Some(inches.value.clone());
        }
        problem.key = inches.stated.clone() + &rest;
    }
}

/// The keys and values of a file with all lengths in mm.
pub fn in_mm(entries: Vec<(String, Node)>, reading: &Reading) -> Vec<(String, Node)> {
    entries_in_mm(entries, ["", ""], false, reading)
}

/// The name in mm of a key in inches.
fn name_in_mm(key: &str) -> Option<String> {
    let name = key.strip_suffix("in")?;
    (name.is_empty() || name.ends_with('_')).then(|| format!("{name}mm"))
}

/// Entries at a path in mm and the path as it stands in the file; `in_inches`: the key above states the unit.
fn entries_in_mm(
    entries: Vec<(String, Node)>,
    paths: [&str; 2],
    in_inches: bool,
    reading: &Reading,
) -> Vec<(String, Node)> {
    let below = |path: &str, key: &str| match path {
        "" => key.to_owned(),
        _ => format!("{path}.{key}"),
    };
    let keys: Vec<String> = entries.iter().map(|(key, _)| key.clone()).collect();
    let each = entries.into_iter().filter_map(|(key, node)| {
        let stated = below(paths[1], &key);
        let in_mm = name_in_mm(&key).filter(|_| !matches!(node, Node::Text(_)));
        let Some(in_mm) = in_mm else {
            let has_unit = ["_mm", "_um", "_deg"]
                .iter()
                .any(|unit| key.ends_with(unit));
            let (path, in_inches) = (below(paths[0], &key), in_inches && !has_unit && key != "mm");
            let value = value_in_mm(node, [&path, &stated], in_inches, reading);
            return Some((key, value));
        };
        if keys.contains(&in_mm) {
            return reading.refuse(Problem {
                key: stated,
                value: Some(node.shown()),
                reason: format!("given together with {in_mm}, allowed is one of them"),
                help: "remove one or the other".to_owned(),
            });
        }
        let path = below(paths[0], &in_mm);
        reading.add_inches(Inches {
            in_mm: path.clone(),
            stated: stated.clone(),
            value: node.shown(),
        });
        Some((in_mm, value_in_mm(node, [&path, &stated], true, reading)))
    });
    each.collect()
}

fn value_in_mm(node: Node, paths: [&str; 2], in_inches: bool, reading: &Reading) -> Node {
    // A millionth of a nm: 1.5 in is the f64 of 38.1.
    let length = |inches: f64| Node::Number(rounded(inches * MM_PER_INCH, 12));
    match node {
        Node::Whole(inches) if in_inches => length(inches as f64),
        Node::Number(inches) if in_inches => length(inches),
        Node::List(list) => {
            let places = (1..).zip(list);
            let each = places.map(|(place, node)| match node {
                Node::Table(_) => {
                    let [in_mm, stated] = paths.map(|path| format!("{path}[{place}]"));
                    value_in_mm(node, [&in_mm, &stated], in_inches, reading)
                }
                _ => value_in_mm(node, paths, in_inches, reading),
            });
            Node::List(each.collect())
        }
        Node::Table(entries) => Node::Table(entries_in_mm(entries, paths, in_inches, reading)),
        other => other,
    }
}

//! Example values, with every key explained by the description in the schema: the template files of `init`.

use super::PAIR;
use gearlash_text::below;
use serde_json::Value;
use std::collections::HashSet;

/// Column at which an explanation starts behind a short value.
const COLUMN: usize = 31;
/// Column at which a line of explanation ends.
const WIDTH: usize = 132;
/// Longest explanation that shares a line with another, bytes.
const SHORT: usize = 40;

/// `examples` as a pair file in which each key is explained at its first place.
///
/// The examples are TOML without explanations: a preface in comments, then tables and values. A key can have several values; values that are only examples are behind a `#`. Explanations, choices and defaults come from the schema (`pair_schema`); keys that it does not have are left out.
pub fn explained(examples: &str) -> String {
    let (preface, examples) = examples.split_once("\n\n").unwrap_or(("", examples));
    let mut words = Words {
        schema: &PAIR,
        used: HashSet::new(),
    };
    let mut text = format!("{preface}\n\n");
    let mut table = "";
    for line in examples.lines().filter(|line| !line.is_empty()) {
        let (stated, mark) = match line.strip_prefix("# ") {
            Some(stated) => (stated, "#"),
            None => (line, ""),
        };
        let (path, value, gap) = if let Some(name) = stated.strip_prefix('[') {
            table = name.trim_end_matches(']');
            (table.to_owned(), Value::Null, "\n")
        } else {
            let (key, _) = stated.split_once(" = ").unwrap_or_default();
            (below(table, key), value(stated, key), "")
        };
        if let Some((name, node)) = words.at(&path) {
            let words = words.of(name, node, &value);
            text.push_str(gap);
            add_line(&mut text, (line, mark), &words);
        }
    }
    text
}

/// The value of the dotted `key` that a line states.
fn value(line: &str, key: &str) -> Value {
    let file: toml::Table = line.parse().unwrap_or_default();
    let file = serde_json::to_value(file).unwrap_or_default();
    key.split('.').fold(&file, |value, key| &value[key]).clone()
}

/// Appends a line and its explanation. The explanations of its inner keys follow below, behind a `mark`.
fn add_line(text: &mut String, (line, mark): (&str, &str), words: &[String]) {
    let mut start = line;
    let length = start.chars().count();
    for (row, words) in words.iter().enumerate() {
        let fits = length + 3 + words.chars().count() <= WIDTH;
        let column = match row {
            0 if words.is_empty() => continue,
            0 if fits => COLUMN.max(length + 2),
            _ => COLUMN,
        };
        if row == 0 && column < length + 2 || row == 1 && start == line {
            text.push_str(start);
            text.push('\n');
            start = mark;
        }
        let width = textwrap::Options::new(WIDTH - column - 2)
            .word_splitter(textwrap::WordSplitter::NoHyphenation);
        for part in textwrap::wrap(words, width) {
            text.push_str(&format!("{start:<column$}# {part}\n"));
            start = mark;
        }
    }
    if start == line {
        text.push_str(start);
        text.push('\n');
    }
}

/// The descriptions of a schema, each used once.
struct Words<'s> {
    schema: &'s Value,
    used: HashSet<String>,
}

impl<'s> Words<'s> {
    /// The meaning of `value` under the key `name`; then, each in a row of its own, the meanings of its inner keys.
    fn of(&mut self, name: &str, node: &'s Value, value: &Value) -> Vec<String> {
        let mut words = Vec::new();
        for node in self.meant(node, value) {
            let description = node["description"].as_str().unwrap_or_default();
            if !self.used.insert(format!("{name}: {description}")) {
                continue;
            }
            let default = node.get("default");
            let is_default = default == Some(value);
            let clause = as_clause(description);
            words.push(if is_default && !clause.is_empty() {
                format!("(default) {clause}")
            } else {
                clause
            });
            let choices: Vec<(&str, &str)> = members(node, "oneOf")
                .filter_map(|one| Some((one["const"].as_str()?, one["description"].as_str()?)))
                .collect();
            let is_included = choices
                .iter()
                .all(|(choice, _)| description.contains(choice));
            if choices.len() > 1 && !is_included {
                let each = choices.iter();
                words.extend(
                    each.map(|(choice, meaning)| format!("\"{choice}\": {}", as_clause(meaning))),
                );
            }
            if let Some(default) = default.filter(|default| !is_default && !default.is_object()) {
                words.push(format!("default: {default}"));
            }
        }
        words.retain(|words| !words.is_empty());
        let mut rows = vec![words.join("; ")];
        rows.extend(join_short_rows(self.of_keys(node, value)));
        rows
    }

    /// The meanings of the keys in a value: each with its name, followed by those of its inner keys.
    fn of_keys(&mut self, node: &'s Value, value: &Value) -> Vec<String> {
        let mut rows = Vec::new();
        let tables = || value.as_array().into_iter().flatten().chain([value]);
        for (key, node) in self.keys(node) {
            for value in tables().filter_map(|table| table.get(key)) {
                let mut words = self.of(key, node, value);
                if !words[0].is_empty() {
                    words[0].insert_str(0, &format!("{key}: "));
                }
                rows.extend(words.into_iter().filter(|words| !words.is_empty()));
            }
        }
        rows
    }

    /// The last key of the dotted `path`, and its node; `None` where the schema has no such key.
    fn at<'p>(&self, path: &'p str) -> Option<(&'p str, &'s Value)> {
        path.split('.')
            .try_fold(("", self.schema), |(_, node), name| {
                let mut keys = self.keys(node).into_iter();
                let (_, node) = keys.find(|(known, _)| *known == name)?;
                Some((name, node))
            })
    }

    /// `node`, and the alternative of it that matches `value`.
    fn meant(&self, node: &'s Value, value: &Value) -> Vec<&'s Value> {
        let mut meant = vec![node];
        if node.get("anyOf").is_some() {
            let alternative = self.inner(node).find(|inner| self.fits(inner, value));
            meant.extend(
                alternative
                    .into_iter()
                    .flat_map(|inner| self.meant(inner, value)),
            );
        }
        meant
    }

    /// Whether `value` is of the kind of `node`.
    fn fits(&self, node: &Value, value: &Value) -> bool {
        let is = |name: &str| node["type"] == name;
        let has = |key: &String| node["properties"].get(key).is_some();
        let own = match value {
            Value::Number(_) => is("number") || is("integer"),
            Value::String(_) => {
                is("string") || members(node, "oneOf").any(|one| one["const"] == *value)
            }
            Value::Array(_) => is("array"),
            Value::Object(table) => is("object") && table.keys().all(has),
            _ => false,
        };
        own || self.inner(node).any(|inner| self.fits(inner, value))
    }

    /// The keys of a table, or of a list of tables, in order.
    fn keys(&self, node: &'s Value) -> Vec<(&'s str, &'s Value)> {
        let mut keys = Vec::new();
        let own = node["properties"].as_object().into_iter().flatten();
        keys.extend(own.map(|(key, node)| (&key[..], node)));
        for inner in self.inner(node).chain(node.get("items")) {
            for (key, node) in self.keys(inner) {
                if keys.iter().all(|(known, _)| *known != key) {
                    keys.push((key, node));
                }
            }
        }
        keys
    }

    /// The node that `node` refers to, and its alternatives.
    fn inner(&self, node: &'s Value) -> impl Iterator<Item = &'s Value> {
        let named = node["$ref"]
            .as_str()
            .map(|name| name.trim_start_matches('#'));
        let named = named.and_then(|name| self.schema.pointer(name));
        named
            .into_iter()
            .chain(members(node, "allOf"))
            .chain(members(node, "anyOf"))
    }
}

pub(crate) fn members<'s>(node: &'s Value, list: &str) -> impl Iterator<Item = &'s Value> {
    node[list].as_array().into_iter().flatten()
}

/// Joins short rows that follow each other.
fn join_short_rows(words: Vec<String>) -> Vec<String> {
    let mut rows: Vec<String> = Vec::new();
    let mut was_short = false;
    for words in words {
        let is_short = words.len() < SHORT && !words.contains(';');
        match rows.last_mut() {
            Some(last) if was_short && is_short => last.push_str(&format!("; {words}")),
            _ => rows.push(words),
        }
        was_short = is_short;
    }
    rows
}

/// A sentence as part of a row.
pub(crate) fn as_clause(sentence: &str) -> String {
    let sentence = sentence.trim_end_matches('.');
    let word = sentence.split([' ', ':', ',']).next().unwrap_or_default();
    let plain = word == "A" || word.len() > 1 && word.chars().skip(1).all(char::is_lowercase);
    if plain {
        sentence
            .chars()
            .next()
            .into_iter()
            .flat_map(char::to_lowercase)
            .chain(sentence.chars().skip(1))
            .collect()
    } else {
        sentence.to_owned()
    }
}

//! The files of `init` explain every key of the schema, and run.

use super::schema::{gearlash, schema, tables, value};
use serde_json::Value;
use std::collections::BTreeSet;

/// The keys in a file of `init`: path, value, and explanation; commented lines count.
fn explained(text: &str) -> Vec<(String, Value, String)> {
    let mut table = String::new();
    let mut found = Vec::new();
    for line in text.lines() {
        let line = line.strip_prefix("# ").unwrap_or(line);
        let (said, words) = line.split_once(" # ").unwrap_or((line, ""));
        if let Some(name) = said
            .trim()
            .strip_prefix('[')
            .and_then(|s| s.strip_suffix(']'))
        {
            table = format!("{name}.");
            continue;
        }
        let key = said.split_once(" = ").map_or("", |(key, _)| key);
        if key.is_empty() || !key.chars().all(|c| c.is_ascii_lowercase() || c == '_') {
            continue;
        }
        found.push((
            format!("{table}{key}"),
            value(said)[key].clone(),
            words.to_owned(),
        ));
    }
    found
}

/// The schema of the value at the dotted `path`, with all it refers to.
fn schema_at(schema: &Value, path: &str) -> Option<Value> {
    fn below<'a>(schema: &'a Value, node: &'a Value, key: &str) -> Option<&'a Value> {
        if let Some(Value::String(target)) = node.get("$ref") {
            return below(schema, schema.pointer(target.trim_start_matches('#'))?, key);
        }
        let alternatives = ["anyOf", "allOf"].map(|choice| node[choice].as_array());
        let alternatives = || alternatives.into_iter().flatten().flatten();
        let own = node["properties"].get(key);
        own.or_else(|| alternatives().find_map(|inner| below(schema, inner, key)))
    }
    let mut node = schema;
    for key in path.split('.') {
        node = below(schema, node, key)?;
    }
    let mut node = node.clone();
    node["definitions"] = schema["definitions"].clone();
    Some(node)
}

/// `init` says that it explains every key; what it writes behind a # must be right, too.
#[test]
fn init_explains_every_key_of_the_schema() {
    let schema = schema(&[]);
    let folder = tempfile::tempdir().unwrap();
    let output = gearlash(folder.path(), &["init", "-"]).output().unwrap();
    let explained = explained(&String::from_utf8(output.stdout).unwrap());
    let mut names = BTreeSet::new();
    for (path, value, words) in &explained {
        let node = schema_at(&schema, path).unwrap_or_else(|| panic!("{path}: no such key"));
        let validator = jsonschema::validator_for(&node).unwrap();
        assert!(validator.is_valid(value), "{path} = {value}");
        let inner = value.as_object().into_iter().flatten();
        names.extend(inner.map(|(key, _)| key.clone()));
        names.extend(path.split('.').map(str::to_owned));
        // A comment that names a unit names that of the key.
        for (unit, suffix) in [("µm", "_um"), (" mm", "_mm"), ("degrees", "_deg")] {
            let other = ["_um", "_mm", "_deg"]
                .iter()
                .find(|end| path.ends_with(**end));
            assert!(
                !words.contains(unit) || other.is_none_or(|end| *end == suffix),
                "{path}: {words}"
            );
        }
    }
    let mut found = Vec::new();
    tables(&schema, &schema, "", &mut found);
    for (path, keys) in found {
        for key in &keys {
            assert!(names.contains(key), "{path}.{key}");
        }
    }
}

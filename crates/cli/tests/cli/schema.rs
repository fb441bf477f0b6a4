//! `gearlash schema` and `gearlash init`: the schema for editors matches the reader.

use super::*;
use jsonschema::{Validator, validator_for};
use std::collections::BTreeSet;
use std::fs;

/// The output of `gearlash schema` with these further arguments.
fn schema(files: &[&str]) -> Value {
    let folder = empty_folder();
    let mut command = gearlash(folder.path());
    serde_json::from_str(&output(command.arg("schema").args(files))).unwrap()
}

fn validator(files: &[&str]) -> Validator {
    validator_for(&schema(files)).unwrap()
}

/// The pair file of `init`.
fn init() -> String {
    let folder = empty_folder();
    output(gearlash(folder.path()).args(["init", "-"]))
}

/// A TOML file as the JSON value an editor checks.
fn value(toml: &str) -> Value {
    let table: toml::Table = toml.parse().unwrap();
    serde_json::to_value(table).unwrap()
}

/// Every place of the schema where keys are named: path from the top, keys. `wheel` stands for both gears.
fn tables(schema: &Value, node: &Value, path: &str, found: &mut Vec<(String, BTreeSet<String>)>) {
    if let Some(Value::String(target)) = node.get("$ref") {
        let target = schema.pointer(target.trim_start_matches('#')).unwrap();
        return tables(schema, target, path, found);
    }
    // Draft 07 describes what it refers to in an `allOf` of one.
    for choice in ["anyOf", "allOf"] {
        for alternative in node[choice].as_array().into_iter().flatten() {
            tables(schema, alternative, path, found);
        }
    }
    if let Some(Value::Object(keys)) = node.get("properties") {
        found.push((path.to_owned(), keys.keys().cloned().collect()));
        for (key, inner) in keys.iter().filter(|(key, _)| *key != "pinion") {
            let below = match path {
                "" => key.clone(),
                _ => format!("{path}.{key}"),
            };
            tables(schema, inner, &below, found);
        }
    }
}

/// The smallest pair file.
fn smallest() -> Value {
    let gear = json!({ "teeth": 20, "module_mm": 2.0, "pressure_angle_deg": 20.0 });
    json!({ "wheel": gear, "pinion": gear, "assembly": { "center_distance_mm": 40.3 } })
}

/// The reader names the keys it allows when it meets one it does not know: those of the schema, everywhere.
fn reader_allows(schema: &Value, smallest: &Value, command: &[&str]) {
    let mut found = Vec::new();
    tables(schema, schema, "", &mut found);
    assert!(found.len() > 12, "{found:?}");
    let folder = empty_folder();
    for (path, keys) in found {
        let mut pair = smallest.clone();
        // The other spelling is already present, and both together are not allowed.
        if path == "assembly.centre_distance_mm" {
            pair["assembly"] = json!({});
        }
        // An outline replaces the gear's data.
        if let Some((gear, _)) = path.split_once('.').or(Some((&path, "")))
            && (path.contains(".outline")
                || keys.contains("outline")
                || keys.iter().eq(["flank_offset_mm"]))
        {
            pair[gear] = json!({ "outline": {} });
        }
        let mut place = &mut pair;
        for key in path.split('.').filter(|key| !key.is_empty()) {
            place = &mut place[key];
            if place.is_number() {
                *place = Value::Null;
            }
        }
        // One of two tables that are allowed here.
        if keys.contains("ends_mm") {
            place["ends_mm"] = json!([[0, 40.3], [10, 40.3]]);
        }
        place["qqqqqqqqqqqq"] = json!(1);
        fs::write(folder.path().join("pair.json"), pair.to_string()).unwrap();
        let (code, _, errors) = run(folder.path(), command);
        assert_eq!(code, Some(2), "{path}");
        let line = errors.lines().find(|line| line.contains("qqqqqqqqqqqq"));
        let allowed = line
            .and_then(|line| line.split_once("unknown key, expected "))
            .expect(&errors);
        let allowed = allowed.1.split(';').next().unwrap();
        let allowed = allowed.split('`').skip(1).step_by(2);
        let allowed: BTreeSet<String> = allowed.map(str::to_owned).collect();
        assert_eq!(allowed, keys, "{path}: the reader's, the schema's");
    }
}

#[test]
fn the_schema_has_the_keys_the_reader_allows() {
    let simulate = ["simulate", "pair.json", "--format", "json"];
    assert_eq!(schema(&[]), schema(&["pair"]));
    reader_allows(&schema(&[]), &smallest(), &simulate);
    let gear = json!({ "gear": smallest()["wheel"] });
    let gauge = ["gauge", "pair.json", "--format", "json"];
    reader_allows(&schema(&["gear"]), &gear, &gauge);
}

/// A gear file is no pair file, and a pair file no gear file.
#[test]
fn the_gear_schema_is_that_of_gear_files() {
    let gears = validator(&["gear"]);
    let wheel = &smallest()["wheel"];
    assert!(gears.is_valid(&json!({ "gear": wheel, "title": "Wheel" })));
    assert!(gears.is_valid(&json!({ "gear": { "outline": { "file": "gear.dxf" } } })));
    let mut few = wheel.clone();
    few["teeth"] = json!(2);
    let [few, none] = [json!({ "gear": few }), json!({ "title": "Wheel" })];
    for fault in [few, none, smallest()] {
        assert!(!gears.is_valid(&fault), "{fault}");
    }
    let pairs = validator(&[]);
    assert!(!pairs.is_valid(&json!({ "gear": wheel })));
}

/// Every pair file of the repository, and the one `init` writes.
#[test]
fn the_schema_accepts_good_pair_files() {
    let validator = validator(&[]);
    let mut count = 0;
    for folder in ["", "reference/lost_motion", "sheets"] {
        for entry in fs::read_dir(fixture(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "toml") {
                let pair = value(&fs::read_to_string(&path).unwrap());
                let faults = validator.iter_errors(&pair);
                let faults: Vec<String> = faults.map(|fault| fault.to_string()).collect();
                assert!(faults.is_empty(), "{}: {faults:?}", path.display());
                count += 1;
            }
        }
    }
    assert!(count >= 20, "{count}");
    assert!(validator.is_valid(&value(&init())));
}

/// `schema_cases.json` changes one value of the smallest pair file: a pointer and the value. An independent validator and the reader agree.
#[test]
fn the_schema_refuses_and_accepts_what_the_reader_does() {
    let validator = validator(&[]);
    let cases: Value = serde_json::from_str(include_str!("schema_cases.json")).unwrap();
    let folder = empty_folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("s.csv", "tooth;span\n1;15,310\n2;15,310\n");
    for (list, code) in [("refused", 2), ("accepted", 0)] {
        let list = cases[list].as_array().unwrap();
        assert!(list.len() > 10);
        for case in list {
            let mut pair = smallest();
            let (parent, key) = case[0].as_str().unwrap().rsplit_once('/').unwrap();
            pair.pointer_mut(parent).unwrap()[key] = case[1].clone();
            assert_eq!(validator.is_valid(&pair), code == 0, "{case}");
            write("pair.json", &pair.to_string());
            let simulate = ["simulate", "pair.json", "--format", "json"];
            let (found, _, errors) = run(folder.path(), &simulate);
            assert_eq!(found, Some(code), "{case}: {errors}");
        }
    }
}

/// The keys in a file of `init`: path, value, and explanation; commented lines count.
fn explained(text: &str) -> Vec<(String, Value, String)> {
    let mut table = String::new();
    let mut found = Vec::new();
    for line in text.lines() {
        let line = line.strip_prefix("# ").unwrap_or(line);
        let (said, words) = line.split_once(" # ").unwrap_or((line, ""));
        let inner = said.trim().strip_prefix('[');
        if let Some(name) = inner.and_then(|inner| inner.strip_suffix(']')) {
            table = format!("{name}.");
            continue;
        }
        let key = said.split_once(" = ").map_or("", |(key, _)| key);
        if key.is_empty() || !key.chars().all(|c| c.is_ascii_lowercase() || c == '_') {
            continue;
        }
        let value = value(said)[key].clone();
        found.push((format!("{table}{key}"), value, words.to_owned()));
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
    let explained = explained(&init());
    let mut names = BTreeSet::new();
    for (path, value, words) in &explained {
        let node = schema_at(&schema, path).unwrap_or_else(|| panic!("{path}: no such key"));
        let validator = validator_for(&node).unwrap();
        assert!(validator.is_valid(value), "{path} = {value}");
        let inner = value.as_object().into_iter().flatten();
        names.extend(inner.map(|(key, _)| key.clone()));
        names.extend(path.split('.').map(str::to_owned));
        // A comment that names a unit names that of the key.
        for (unit, suffix) in [("µm", "_um"), (" mm", "_mm"), ("degrees", "_deg")] {
            let mut suffixes = ["_um", "_mm", "_deg"].iter();
            let other = suffixes.find(|end| path.ends_with(**end));
            let is_own = !words.contains(unit) || other.is_none_or(|end| *end == suffix);
            assert!(is_own, "{path}: {words}");
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

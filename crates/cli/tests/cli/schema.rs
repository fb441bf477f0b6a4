//! `gearlash schema` and `gearlash init`: the schema for editors matches the reader.

use assert_cmd::Command;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;

pub(super) fn gearlash(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder).args(arguments);
    command
}

/// The output of `gearlash schema` with these further arguments.
pub(super) fn schema(files: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [&["schema"], files].concat();
    let output = gearlash(folder.path(), &arguments).output().unwrap();
    assert!(output.status.success());
    serde_json::from_slice(&output.stdout).unwrap()
}

/// A TOML file as the JSON value an editor checks.
pub(super) fn value(toml: &str) -> Value {
    let table: toml::Table = toml.parse().unwrap();
    serde_json::to_value(table).unwrap()
}

/// Every place of the schema where keys are named: path from the top, keys. `wheel` stands for both gears.
pub(super) fn tables(
    schema: &Value,
    node: &Value,
    path: &str,
    found: &mut Vec<(String, BTreeSet<String>)>,
) {
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
pub(super) fn smallest() -> Value {
    let gear = json!({ "teeth": 20, "module_mm": 2.0, "pressure_angle_deg": 20.0 });
    json!({ "wheel": gear, "pinion": gear, "assembly": { "center_distance_mm": 40.3 } })
}

/// The reader names the keys it allows when it meets one it does not know: those of the schema, everywhere.
fn reader_allows(schema: &Value, smallest: &Value, command: &[&str]) {
    let mut found = Vec::new();
    tables(schema, schema, "", &mut found);
    assert!(found.len() > 12, "{found:?}");
    let folder = tempfile::tempdir().unwrap();
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
        let file = folder.path().join("pair.json");
        std::fs::write(&file, pair.to_string()).unwrap();
        let output = gearlash(folder.path(), command).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{path}");
        let errors = String::from_utf8(output.stderr).unwrap();
        let line = errors.lines().find(|line| line.contains("qqqqqqqqqqqq"));
        let allowed = line
            .and_then(|line| line.split_once("unknown key, expected "))
            .expect(&errors);
        let allowed = allowed.1.split(';').next().unwrap();
        let allowed: BTreeSet<String> = allowed
            .split('`')
            .skip(1)
            .step_by(2)
            .map(str::to_owned)
            .collect();
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
    let gears = jsonschema::validator_for(&schema(&["gear"])).unwrap();
    let wheel = &smallest()["wheel"];
    assert!(gears.is_valid(&json!({ "gear": wheel, "title": "Wheel" })));
    assert!(gears.is_valid(&json!({ "gear": { "outline": { "file": "gear.dxf" } } })));
    let mut few = wheel.clone();
    few["teeth"] = json!(2);
    for fault in [
        json!({ "gear": few }),
        json!({ "title": "Wheel" }),
        smallest(),
    ] {
        assert!(!gears.is_valid(&fault), "{fault}");
    }
    let pairs = jsonschema::validator_for(&schema(&[])).unwrap();
    assert!(!pairs.is_valid(&json!({ "gear": wheel })));
}

/// Every pair file of the repository, and the one `init` writes.
#[test]
fn the_schema_accepts_good_pair_files() {
    let validator = jsonschema::validator_for(&schema(&[])).unwrap();
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures"));
    let mut count = 0;
    for folder in [
        root.to_path_buf(),
        root.join("reference/lost_motion"),
        root.join("sheets"),
    ] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path
                .extension()
                .is_some_and(|extension| extension == "toml")
            {
                let pair = value(&std::fs::read_to_string(&path).unwrap());
                let faults: Vec<String> = validator
                    .iter_errors(&pair)
                    .map(|fault| fault.to_string())
                    .collect();
                assert!(faults.is_empty(), "{}: {faults:?}", path.display());
                count += 1;
            }
        }
    }
    assert!(count >= 20, "{count}");
    let folder = tempfile::tempdir().unwrap();
    let output = gearlash(folder.path(), &["init", "-"]).output().unwrap();
    assert!(validator.is_valid(&value(&String::from_utf8(output.stdout).unwrap())));
}

/// `schema_cases.json` changes one value of the smallest pair file: a pointer and the value. An independent validator and the reader agree.
#[test]
fn the_schema_refuses_and_accepts_what_the_reader_does() {
    let validator = jsonschema::validator_for(&schema(&[])).unwrap();
    let cases: Value = serde_json::from_str(include_str!("schema_cases.json")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
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
            let output = gearlash(folder.path(), &simulate).output().unwrap();
            let errors = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(code), "{case}: {errors}");
        }
    }
}

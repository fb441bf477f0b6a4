//! `gearlash schema`: the reader has the keys and limits of the schema for editors.

use super::*;
use std::collections::BTreeSet;
use std::fs;

/// The output of `gearlash schema` with these further arguments.
fn schema(files: &[&str]) -> Value {
    let folder = empty_folder();
    let mut command = gearlash(folder.path());
    serde_json::from_str(&output(command.arg("schema").args(files))).unwrap()
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

/// `schema_cases.json` changes one value of the smallest pair file: a pointer and the value. Python's tests ask an independent validator.
#[test]
fn the_reader_refuses_and_accepts_the_cases_of_the_schema() {
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
            write("pair.json", &pair.to_string());
            let simulate = ["simulate", "pair.json", "--format", "json"];
            let (found, _, errors) = run(folder.path(), &simulate);
            assert_eq!(found, Some(code), "{case}: {errors}");
        }
    }
}

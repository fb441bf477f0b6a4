//! The JSON Schema of the files, for editors to complete and check them.

#[cfg(not(target_family = "wasm"))]
use super::derived::schema;
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// The schema of pair files.
pub(crate) static PAIR: LazyLock<Value> = LazyLock::new(|| schema("pair"));
/// The schema of two drawings of one gear.
pub(crate) static DRAWINGS: LazyLock<Value> = LazyLock::new(|| schema("drawings"));
/// The schema of a single table.
pub(crate) static TABLE: LazyLock<Value> = LazyLock::new(|| schema("table"));
/// The schema of gear files.
pub(crate) static GEAR: LazyLock<Value> = LazyLock::new(|| schema("gear"));

/// The schema as `schemas.json` has it: the code that derives it would be 50 kB of the page in the browser, by gzip.
#[cfg(target_family = "wasm")]
fn schema(of: &str) -> Value {
    let stored = serde_json::from_str(include_str!("schemas.json"));
    let mut stored: Value = stored.unwrap_or_default();
    let mut schema = stored[of].take();
    schema["definitions"] = stored["definitions"].take();
    schema
}

/// Every schema by its name in `schemas.json`.
#[doc(hidden)]
pub fn schemas() -> [(&'static str, &'static Value); 4] {
    [
        ("pair", &PAIR),
        ("drawings", &DRAWINGS),
        ("table", &TABLE),
        ("gear", &GEAR),
    ]
}

/// The JSON Schema (draft 07) of pair files, as text: every key with type and range, and allowed combinations.
///
/// [`read`](crate::read) checks more than a schema can express.
pub fn pair_schema() -> String {
    printed(&PAIR)
}

/// The JSON Schema of gear files, `title` and one `[gear]`.
pub fn gear_schema() -> String {
    printed(&GEAR)
}

fn printed(schema: &Value) -> String {
    let mut schema = schema.clone();
    allow_inches(&mut schema);
    format!("{schema:#}\n")
}

/// Allows a key `_in` wherever one `_mm` is allowed or needed. The check itself sees no such key: lengths are converted before it.
fn allow_inches(schema: &mut Value) {
    let in_inches = |key: &str| {
        let name = key.strip_suffix("mm")?;
        (name.is_empty() || name.ends_with('_')).then(|| format!("{name}in"))
    };
    match schema {
        Value::Array(list) => list.iter_mut().for_each(allow_inches),
        Value::Object(node) => {
            node.values_mut().for_each(allow_inches);
            let properties = node.get("properties").and_then(Value::as_object);
            let mut keys = properties.into_iter().flat_map(Map::keys);
            if node.contains_key("additionalProperties") && keys.any(|key| in_inches(key).is_some())
            {
                node.insert("patternProperties".to_owned(), json!({ "(^|_)in$": {} }));
            }
            if let Some(Value::Object(dependencies)) = node.get_mut("dependencies") {
                let both = dependencies
                    .iter()
                    .filter_map(|(key, condition)| Some((in_inches(key)?, condition.clone())));
                let both: Vec<(String, Value)> = both.collect();
                dependencies.extend(both);
            }
            if let Some(Value::Array(needed)) = node.get_mut("required") {
                let mut either = Vec::new();
                needed.retain(|key| {
                    let inches = key.as_str().and_then(in_inches);
                    let each = |inches| json!({ "anyOf": [{ "required": [key] }, { "required": [inches] }] });
                    either.extend(inches.map(each));
                    either.last().is_none_or(|last| last["anyOf"][0]["required"][0] != *key)
                });
                if !either.is_empty() {
                    let all = node.entry("allOf").or_insert_with(|| json!([]));
                    all.as_array_mut()
                        .into_iter()
                        .for_each(|all| all.append(&mut either));
                }
            }
        }
        _ => {}
    }
}

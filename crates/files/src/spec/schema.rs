//! The JSON Schema of the files, for editors to complete and check them.

use super::pair::TwoDrawingsSpec;
use super::rules::is_type;
use super::value::AnyTableSpec;
use super::{GearFileSpec, PairSpec};
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// The schema of pair files.
pub(crate) static PAIR: LazyLock<Value> = LazyLock::new(ordered::<PairSpec>);
/// The schema of two drawings of one gear.
pub(crate) static DRAWINGS: LazyLock<Value> = LazyLock::new(ordered::<TwoDrawingsSpec>);
/// The schema of a single table.
pub(crate) static TABLE: LazyLock<Value> = LazyLock::new(ordered::<AnyTableSpec>);
/// The schema of gear files.
pub(crate) static GEAR: LazyLock<Value> = LazyLock::new(ordered::<GearFileSpec>);

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

fn ordered<T: JsonSchema>() -> Value {
    let mut settings = SchemaSettings::draft07();
    // Runs before `$ref` gets a place of its own, which draft 07 needs.
    let own: [fn(&mut Schema); 4] = [without_null, without_format, without_default, closed];
    for (place, transform) in own.into_iter().enumerate() {
        let everywhere = Box::new(RecursiveTransform(transform));
        settings.transforms.insert(place, everywhere);
    }
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    // Readers see the description first.
    let mut ordered = Map::new();
    for key in ["$schema", "title", "description"] {
        ordered.extend(schema.ensure_object().shift_remove_entry(key));
    }
    let definitions = schema.ensure_object().shift_remove_entry("definitions");
    ordered.append(schema.ensure_object());
    ordered.extend(definitions);
    Value::Object(ordered)
}

/// Removes `null`: an optional key is left out, it has no null value.
fn without_null(schema: &mut Schema) {
    let Some(object) = schema.as_object_mut() else {
        return;
    };
    if let Some(Value::Array(types)) = object.get_mut("type") {
        types.retain(|name| name != "null");
        if let [only] = &types[..] {
            let only = only.clone();
            object.insert("type".to_owned(), only);
        }
    }
    if let Some(Value::Array(values)) = object.get_mut("enum") {
        values.retain(|value| !value.is_null());
    }
    if let Some(Value::Array(alternatives)) = object.get_mut("anyOf") {
        alternatives.retain(|alternative| alternative["type"] != "null");
        if let [Value::Object(only)] = &alternatives[..] {
            let only = only.clone();
            object.shift_remove("anyOf");
            for (key, value) in only {
                object.entry(key).or_insert(value);
            }
        }
    }
}

/// Removes the format: the width of a number in memory does not concern the file.
fn without_format(schema: &mut Schema) {
    if let Some(object) = schema.as_object_mut() {
        object.shift_remove("format");
    }
}

/// Removes defaults of several values; the description of the key states them.
fn without_default(schema: &mut Schema) {
    if let Some(Value::Object(_) | Value::Array(_) | Value::Null) = schema.get("default") {
        schema.remove("default");
    }
}

/// Forbids keys that a table does not list.
fn closed(schema: &mut Schema) {
    if is_type(schema, "object") && schema.get("properties").is_some() {
        schema.insert("additionalProperties".to_owned(), false.into());
    }
}

//! The schemas as they follow from the types.

use super::rules::is_type;
use super::{GearFileSpec, OutlineGearSpec, PairSpec};
use gearlash_tables::Choice;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde::Serialize;
use serde_json::{Map, Value};

/// Two drawings of one gear.
#[derive(Serialize, JsonSchema)]
struct TwoDrawingsSpec {
    /// The reference drawing.
    a: OutlineGearSpec,
    /// The drawing that is compared with it.
    b: OutlineGearSpec,
}

/// The schema `of` one kind of files, by its name in `schemas.json`.
pub(super) fn schema(of: &str) -> Value {
    match of {
        "pair" => ordered::<PairSpec>(),
        "drawings" => ordered::<TwoDrawingsSpec>(),
        "table" => ordered::<Choice>(),
        _ => ordered::<GearFileSpec>(),
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

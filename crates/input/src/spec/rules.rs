//! Rules of a schema for numbers, lists and combinations of keys, which types cannot express.
//!
//! Rules for values are attributes of the fields; rules for keys are functions.

use schemars::Schema;
use schemars::transform::{RecursiveTransform, Transform};
use serde_json::{Value, json};

/// Every number of the value, in lists, tables and alternatives too, is `least` … `most`, unless it has bounds of its own.
pub fn within(least: f64, most: f64) -> impl Fn(&mut Schema) {
    bounds(
        "number",
        json!({ "minimum": number(least), "maximum": number(most) }),
    )
}

/// Every number is `least` or more, unless it has bounds of its own.
pub fn at_least(least: f64) -> impl Fn(&mut Schema) {
    bounds("number", json!({ "minimum": number(least) }))
}

/// Every number is above 0 and at most `most`, unless it has bounds of its own.
pub fn above_zero(most: f64) -> impl Fn(&mut Schema) {
    bounds(
        "number",
        json!({ "exclusiveMinimum": 0, "maximum": number(most) }),
    )
}

/// A length, mm: up to twenty times the largest possible pair. The squares of larger lengths would lose the gears by rounding.
pub fn length() -> impl Fn(&mut Schema) {
    above_zero(1e9)
}

/// A deviation of a length, µm.
pub fn deviation() -> impl Fn(&mut Schema) {
    within(-1e7, 1e7)
}

/// Every whole number of the value is `least` … `most`.
pub fn whole(least: u32, most: u32) -> impl Fn(&mut Schema) {
    bounds("integer", json!({ "minimum": least, "maximum": most }))
}

/// A list has at least `least` and at most `most` elements.
pub fn list_length(least: usize, most: Option<usize>) -> impl Fn(&mut Schema) {
    bounds(
        "array",
        match most {
            Some(most) => json!({ "minItems": least, "maxItems": most }),
            None => json!({ "minItems": least }),
        },
    )
}

/// Exactly one of the groups of keys is given. Both keys of a pair are.
pub fn exactly_one(schema: &mut Schema, groups: &[&[&str]]) {
    let each: Vec<Value> = groups.iter().map(|keys| required(keys)).collect();
    schema.insert("oneOf".to_owned(), json!(each));
    for group in groups {
        if let [one, other] = group {
            beside(schema, one, &[&[other]]);
            beside(schema, other, &[&[one]]);
        }
    }
}

/// At most one of the groups of keys is given.
pub fn at_most_one(schema: &mut Schema, groups: &[&[&str]]) {
    let mut pairs = Vec::new();
    for (index, one) in groups.iter().enumerate() {
        let others = groups.iter().skip(index + 1);
        pairs.extend(others.map(|other| required(&[one, *other].concat())));
    }
    schema.insert("not".to_owned(), json!({ "anyOf": pairs }));
}

/// `key` is allowed only beside one of the groups of keys.
pub fn beside(schema: &mut Schema, key: &str, groups: &[&[&str]]) {
    depend(
        schema,
        key,
        any_of(groups.iter().map(|keys| required(keys))),
    );
}

/// `key` is allowed only where `list` holds a list, or beside one of `others`.
pub fn beside_list(schema: &mut Schema, key: &str, list: &str, others: &[&str]) {
    let is_list = json!({ "required": [list], "properties": { list: { "type": "array" } } });
    let others = others.iter().map(|other| required(&[other]));
    depend(schema, key, any_of([is_list].into_iter().chain(others)));
}

/// A list at one of `keys` requires `places`.
pub fn beside_places(schema: &mut Schema, keys: &[&str], places: &str) {
    for key in keys {
        let is_list = json!({ "required": [key], "properties": { *key: { "type": "array" } } });
        also(
            schema,
            json!({ "if": is_list, "then": { "required": [key, places] } }),
        );
    }
}

/// `key` is not allowed beside any of `others`.
pub fn not_beside(schema: &mut Schema, key: &str, others: &[&str]) {
    let others = any_of(others.iter().map(|other| required(&[other])));
    depend(schema, key, json!({ "not": others }));
}

/// `key` is not allowed.
pub fn without(schema: &mut Schema, key: &str) {
    for place in ["properties", "dependencies"] {
        if let Some(Value::Object(keys)) = schema.get_mut(place) {
            keys.shift_remove(key);
        }
    }
}

/// Removes the default of `key`, which differs from the meaning of its absence.
pub fn no_default(schema: &mut Schema, key: &str) {
    if let Some(Value::Object(keys)) = schema.get_mut("properties")
        && let Some(Value::Object(own)) = keys.get_mut(key)
    {
        own.shift_remove("default");
    }
}

/// A `list` with values requires values in `other`, and `key`.
pub fn values_need(schema: &mut Schema, list: &str, other: &str, key: &str) {
    let has_values =
        |list: &str| json!({ "required": [list], "properties": { list: { "minItems": 1 } } });
    let mut needed = has_values(other);
    needed["required"] = json!([key, other]);
    also(schema, json!({ "if": has_values(list), "then": needed }));
}

/// Appends the columns of the table to the description of `file`.
pub fn columns(words: &str) -> impl Fn(&mut Schema) {
    move |schema| {
        let append = |schema: &mut Schema| {
            let description = schema.pointer_mut("/properties/file/description");
            if let Some(Value::String(text)) = description {
                *text = format!("{}, columns {words}", text.trim_end_matches('.'));
            }
        };
        RecursiveTransform(append).transform(schema);
    }
}

fn required(keys: &[&str]) -> Value {
    json!({ "required": keys })
}

fn any_of(conditions: impl Iterator<Item = Value>) -> Value {
    let conditions: Vec<Value> = conditions.collect();
    match &conditions[..] {
        [only] => only.clone(),
        _ => json!({ "anyOf": conditions }),
    }
}

/// Adds `condition` for the presence of `key` to the existing ones.
fn depend(schema: &mut Schema, key: &str, condition: Value) {
    let dependencies = schema.ensure_object().entry("dependencies");
    if let Value::Object(all) = dependencies.or_insert_with(|| json!({})) {
        let both = match all.remove(key) {
            Some(other) => json!({ "allOf": [other, condition] }),
            None => condition,
        };
        all.insert(key.to_owned(), both);
    }
}

/// Adds `rule` to the existing ones.
fn also(schema: &mut Schema, rule: Value) {
    let rules = schema.ensure_object().entry("allOf");
    if let Value::Array(rules) = rules.or_insert_with(|| json!([])) {
        rules.push(rule);
    }
}

/// A JSON number; whole numbers have no point.
fn number(number: f64) -> Value {
    if number.fract() == 0.0 {
        // Every whole limit is below 2^53.
        json!(number as i64)
    } else {
        json!(number)
    }
}

/// Adds `more` to the schema and to all inner ones of type `name`. Numbers that have bounds keep them.
fn bounds(name: &'static str, more: Value) -> impl Fn(&mut Schema) {
    move |schema| {
        let add = |schema: &mut Schema| {
            let mut least = ["minimum", "exclusiveMinimum"].iter();
            let is_bounded = name == "number" && least.any(|key| schema.get(*key).is_some());
            let is_open = is_type(schema, name) && !is_bounded;
            if let (true, Value::Object(more)) = (is_open, &more) {
                schema.ensure_object().extend(more.clone());
            }
        };
        RecursiveTransform(add).transform(schema);
    }
}

/// Whether a value of type `name` is allowed. Optional keys allow `null` beside it until the schema is complete.
pub fn is_type(schema: &Schema, name: &str) -> bool {
    match schema.get("type") {
        Some(Value::Array(names)) => names.iter().any(|one| one == name),
        Some(only) => only == name,
        None => false,
    }
}

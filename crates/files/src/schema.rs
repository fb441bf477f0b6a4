//! What an editor needs to complete and check the files.

use serde_json::{Value, json};

/// The JSON Schema (draft 07) of pair files: every key, its type and range, and which go together. [`read`](super::read) checks more than it can say.
pub const PAIR_SCHEMA: &str = include_str!("pair_schema.json");

/// The same of gear files, `title` and one `[gear]`, from the definitions of [`PAIR_SCHEMA`].
pub fn gear_schema() -> Value {
    let pair: Value = serde_json::from_str(PAIR_SCHEMA).unwrap_or_default();
    json!({
        "$schema": pair["$schema"],
        "title": "gearlash gear file",
        "type": "object",
        "description": "One spur gear and what was measured on it",
        "additionalProperties": false,
        "properties": { "title": pair["properties"]["title"], "gear": pair["properties"]["wheel"] },
        "required": ["gear"],
        "definitions": pair["definitions"],
    })
}

//! REXS as JSON: `{ "model": { "relations": […], "components": […] } }`, each value under the name of its type.
//!
//! Facts of the format: the public reader and writer of FVA's Java API and the JSON schema of REXSapi (both Apache-2.0).

use super::document::{Attribute, Component, Document, EXPORT_AGAIN, Relation, shown, text_of};
use gearlash_text::Problem;
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Number;

#[derive(Deserialize)]
struct File {
    model: Model,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Model {
    version: String,
    #[serde(default)]
    application_id: String,
    #[serde(default)]
    relations: Vec<JsonRelation>,
    #[serde(default)]
    components: Vec<JsonComponent>,
    #[serde(rename = "load_spectrum")]
    load_spectrum: Option<IgnoredAny>,
}

#[derive(Deserialize)]
struct JsonRelation {
    id: i32,
    #[serde(rename = "type")]
    kind: String,
    refs: Vec<JsonRef>,
}

#[derive(Deserialize)]
struct JsonRef {
    id: i32,
    role: String,
}

#[derive(Deserialize)]
struct JsonComponent {
    id: i32,
    #[serde(rename = "type")]
    kind: String,
    name: Option<String>,
    attributes: Vec<JsonAttribute>,
}

/// The single values; arrays and matrices are not read.
#[derive(Deserialize)]
struct JsonAttribute {
    id: String,
    unit: Option<String>,
    floating_point: Option<Number>,
    integer: Option<Number>,
    reference_component: Option<Number>,
    boolean: Option<bool>,
    string: Option<String>,
    #[serde(rename = "enum")]
    choice: Option<String>,
}

/// Parses `text`.
/// Errors: the fault and its line.
pub fn read(text: &str) -> Result<Document, Problem> {
    let file: File = serde_json::from_str(text).map_err(|error| {
        let place = format!("line {} column {}", error.line(), error.column());
        let reason = error.to_string();
        let reason = reason.split(" at line ").next().unwrap_or_default();
        let reason = format!("not REXS: {}", shown(reason));
        Problem::at(&place, reason, EXPORT_AGAIN)
    })?;
    let model = file.model;
    let reference = |each: &JsonRef| (text_of(&each.role), each.id);
    let relations = model.relations.into_iter().map(|relation| Relation {
        id: relation.id,
        kind: text_of(&relation.kind),
        refs: relation.refs.iter().map(reference).collect(),
    });
    let components = model.components.into_iter();
    let others = model.load_spectrum.map(|_| "load_spectrum".to_owned());
    Ok(Document {
        version: shown(&model.version),
        application: shown(&model.application_id),
        relations: relations.collect(),
        components: components.map(component).collect::<Result<_, _>>()?,
        others: others.into_iter().collect(),
    })
}

fn component(each: JsonComponent) -> Result<Component, Problem> {
    let attributes = each.attributes.into_iter().map(|read| {
        let numbers = [read.floating_point, read.integer, read.reference_component];
        let boolean = read.boolean.map(|b| b.to_string());
        let texts = [read.string, read.choice, boolean];
        let numbers = numbers.into_iter().flatten().map(|n| n.to_string());
        let mut values = numbers.chain(texts.into_iter().flatten());
        let value = values.next().map(|value| text_of(&value));
        if values.next().is_some() {
            let place = format!("component {}, {}", each.id, shown(&read.id));
            let help = "leave one of them";
            return Err(Problem::at(&place, "has several values", help));
        }
        Ok(Attribute {
            id: text_of(&read.id),
            unit: read.unit.as_deref().map(text_of),
            value: value.filter(|value| !value.is_empty()),
        })
    });
    Ok(Component {
        id: each.id,
        kind: text_of(&each.kind),
        name: shown(each.name.as_deref().unwrap_or_default()),
        attributes: attributes.collect::<Result<_, _>>()?,
    })
}

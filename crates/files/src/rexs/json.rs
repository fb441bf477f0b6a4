//! REXS as JSON: `{ "model": { "relations": […], "components": […] } }`, each value under the name of its type.
//!
//! Facts of the format: the public reader and writer of FVA's Java API and the JSON schema of REXSapi (both Apache-2.0).

use super::document::{Attribute, Component, Document, Relation, problem, shown, text_of};
use crate::error::Problem;
use crate::source::line_and_column;
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Number;
use serde_json::value::RawValue;
use std::ops::Range;

#[derive(Deserialize)]
struct File<'a> {
    #[serde(borrow)]
    model: Model<'a>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Model<'a> {
    version: String,
    #[serde(default)]
    application_id: String,
    #[serde(default)]
    relations: Vec<JsonRelation>,
    #[serde(borrow, default)]
    components: Vec<JsonComponent<'a>>,
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
struct JsonComponent<'a> {
    id: i32,
    #[serde(rename = "type")]
    kind: String,
    name: Option<String>,
    #[serde(borrow)]
    attributes: &'a RawValue,
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

/// The file that `text` is.
///
/// # Errors
/// What is wrong and in which line.
pub fn read(text: &str) -> Result<Document, Problem> {
    let body = text.strip_prefix('\u{feff}').unwrap_or(text);
    let file: File = serde_json::from_str(body).map_err(|error| {
        let place = format!("line {} column {}", error.line(), error.column());
        wrong(place, &error)
    })?;
    let model = file.model;
    let relations = model.relations.into_iter().map(|relation| Relation {
        id: relation.id,
        kind: text_of(&relation.kind),
        refs: relation
            .refs
            .into_iter()
            .map(|each| (text_of(&each.role), each.id))
            .collect(),
    });
    let components = model.components.iter();
    Ok(Document {
        version: shown(&model.version),
        application: shown(&model.application_id),
        relations: relations.collect(),
        components: components
            .map(|each| component(text, each))
            .collect::<Result<_, _>>()?,
        others: model
            .load_spectrum
            .map(|_| "load_spectrum".to_owned())
            .into_iter()
            .collect(),
    })
}

fn component(text: &str, each: &JsonComponent) -> Result<Component, Problem> {
    let list: Vec<&RawValue> = inner(text, each.attributes)?;
    let attributes = list.into_iter().map(|raw| {
        let read: JsonAttribute = inner(text, raw)?;
        let numbers = [read.floating_point, read.integer, read.reference_component];
        let texts = [
            read.string,
            read.choice,
            read.boolean.map(|b| b.to_string()),
        ];
        let numbers = numbers.into_iter().flatten().map(|n| n.to_string());
        let mut values = numbers.chain(texts.into_iter().flatten());
        let value = values.next().map(|value| text_of(&value));
        if values.next().is_some() {
            let place = format!("component {}, {}", each.id, shown(&read.id));
            return Err(problem(&place, "has several values", "leave one of them"));
        }
        Ok(Attribute {
            id: text_of(&read.id),
            unit: read.unit.as_deref().map(text_of),
            value: value.filter(|value| !value.is_empty()),
            range: range_in(text, raw.get()),
        })
    });
    let whole = range_in(text, each.attributes.get());
    Ok(Component {
        id: each.id,
        kind: text_of(&each.kind),
        name: shown(each.name.as_deref().unwrap_or_default()),
        attributes: attributes.collect::<Result<_, _>>()?,
        range: whole.start + 1..whole.end - 1,
    })
}

/// Replaces what `edits` names, adding what has no place yet at the end of the attributes of `component`.
pub fn edited(
    text: &str,
    component: &Component,
    values: &[(&str, f64)],
    edits: &mut Vec<(Range<usize>, String)>,
) {
    let last = component.attributes.last();
    let mut added: Vec<String> = Vec::new();
    for (id, mm) in values {
        let object = format!("{{\"id\": \"{id}\", \"unit\": \"mm\", \"floating_point\": {mm:?}}}");
        match component.attribute(id) {
            Some(there) => edits.push((there.range.clone(), object)),
            None => added.push(match last {
                Some(last) => {
                    let before = &text[..last.range.start];
                    format!(",{}{object}", &before[before.trim_end().len()..])
                }
                None => object,
            }),
        }
    }
    if !added.is_empty() {
        edits.push(match last {
            Some(last) => (last.range.end..last.range.end, added.concat()),
            None => (
                component.range.start..component.range.start,
                added.join(", "),
            ),
        });
    }
}

/// What `raw` holds, a part of `text` that is JSON by itself.
fn inner<'a, T: Deserialize<'a>>(text: &str, raw: &'a RawValue) -> Result<T, Problem> {
    serde_json::from_str(raw.get()).map_err(|error| {
        let (line, column) = line_and_column(text, range_in(text, raw.get()).start);
        wrong(format!("line {line} column {column}"), &error)
    })
}

/// Where `part` of `text` stands in it, in bytes.
fn range_in(text: &str, part: &str) -> Range<usize> {
    let start = part.as_ptr() as usize - text.as_ptr() as usize;
    start..start + part.len()
}

fn wrong(place: String, error: &serde_json::Error) -> Problem {
    let reason = error.to_string();
    let reason = reason.split(" at line ").next().unwrap_or_default();
    problem(
        &place,
        format!("not REXS: {}", shown(reason)),
        "export the file again",
    )
}

//! REXS as XML: `model` with `relations` and `components`.
//!
//! Facts of the format: the public schema `rexs-file.xsd` of FVA's Java API (Apache-2.0). No entity and no other file is read.

use super::document::{Attribute, Component, Document, EXPORT_AGAIN, Relation, shown, text_of};
use gearlash_text::{Problem, xml};
use roxmltree::Node;
use std::str::FromStr;

/// Parses `text`.
/// Errors: the fault and its line.
pub fn read(text: &str) -> Result<Document, Problem> {
    let parsed = xml::parse(text).map_err(|fault| {
        let place = format!("line {} column {}", fault.line, fault.column);
        let reason = format!("not XML: {}", shown(&fault.reason));
        Problem::at(&place, reason, EXPORT_AGAIN)
    })?;
    let model = parsed.root_element();
    if model.tag_name().name() != "model" {
        return Err(wrong(model, "not REXS: the root element is not model"));
    }
    let mut document = Document {
        version: text_of(need(model, "version")?),
        application: shown(model.attribute("applicationId").unwrap_or_default()),
        ..Document::default()
    };
    for part in elements(model) {
        let seen = |is_empty: bool| {
            if is_empty {
                Ok(())
            } else {
                Err(wrong(part, "this part stands twice"))
            }
        };
        match part.tag_name().name() {
            "relations" => {
                seen(document.relations.is_empty())?;
                document.relations = children_named(part, "relation", relation)?;
            }
            "components" => {
                seen(document.components.is_empty())?;
                document.components = children_named(part, "component", component)?;
            }
            "load_spectrum" => document.others.push("load_spectrum".to_owned()),
            _ => {
                let reason = "expected relations, components or load_spectrum";
                return Err(wrong(part, reason));
            }
        }
    }
    Ok(document)
}

fn component(node: Node) -> Result<Component, Problem> {
    Ok(Component {
        id: id(node)?,
        kind: text_of(need(node, "type")?),
        name: shown(node.attribute("name").unwrap_or_default()),
        attributes: children_named(node, "attribute", attribute)?,
    })
}

fn attribute(node: Node) -> Result<Attribute, Problem> {
    let text: String = node
        .children()
        .filter_map(|child| child.is_text().then(|| child.text()).flatten())
        .collect();
    let is_single = elements(node).next().is_none() && !text.trim().is_empty();
    Ok(Attribute {
        id: text_of(need(node, "id")?),
        unit: node.attribute("unit").map(text_of),
        value: is_single.then(|| text_of(&text)),
    })
}

fn relation(node: Node) -> Result<Relation, Problem> {
    Ok(Relation {
        id: id(node)?,
        kind: text_of(need(node, "type")?),
        refs: children_named(node, "ref", |node| {
            Ok((text_of(need(node, "role")?), id(node)?))
        })?,
    })
}

/// Each child of `parent`; all must be called `name`.
fn children_named<T>(
    parent: Node,
    name: &str,
    read: impl Fn(Node) -> Result<T, Problem>,
) -> Result<Vec<T>, Problem> {
    let each = elements(parent).map(|child| {
        if child.tag_name().name() == name {
            read(child)
        } else {
            Err(wrong(child, &format!("expected {name}")))
        }
    });
    each.collect()
}

fn elements<'a, 'i: 'a>(node: Node<'a, 'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(Node::is_element)
}

fn id(node: Node) -> Result<i32, Problem> {
    let text = need(node, "id")?;
    i32::from_str(text.trim())
        .map_err(|_| wrong(node, &format!("id {} is not a whole number", shown(text))))
}

fn need<'a>(node: Node<'a, '_>, name: &str) -> Result<&'a str, Problem> {
    let found = node.attribute(name);
    found.ok_or_else(|| wrong(node, &format!("has no {name}")))
}

fn wrong(node: Node, reason: &str) -> Problem {
    let at = node.document().text_pos_at(node.range().start);
    let place = format!("line {} column {}", at.row, at.col);
    let reason = format!("{}: {reason}", shown(node.tag_name().name()));
    Problem::at(&place, reason, EXPORT_AGAIN)
}

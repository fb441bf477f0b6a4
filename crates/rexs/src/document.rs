//! The content of a REXS file, XML or JSON: components with attributes, and relations between them.

use gearlash_text::Problem;
use gearlash_text::characters::{cut, plain};
use gearlash_text::node::LONGEST;
use std::collections::{BTreeMap, HashSet};

/// The remedy for a file that breaks the format.
pub const EXPORT_AGAIN: &str = "export the file again";

#[derive(Debug, Clone, Default)]
pub struct Document {
    /// Version of the format: "1.4".
    pub version: String,
    pub application: String,
    pub components: Vec<Component>,
    pub relations: Vec<Relation>,
    /// Parts other than components and relations, such as a load spectrum.
    pub others: Vec<String>,
}

/// A part of the gearbox, or data of one.
#[derive(Debug, Clone)]
pub struct Component {
    pub id: i32,
    pub kind: String,
    pub name: String,
    pub attributes: Vec<Attribute>,
}

#[derive(Debug, Clone)]
pub struct Attribute {
    pub id: String,
    pub unit: Option<String>,
    /// `None`: no value, or several.
    pub value: Option<String>,
}

#[derive(Debug, Clone)]
pub struct Relation {
    pub id: i32,
    pub kind: String,
    pub refs: Vec<(String, i32)>,
}

impl Document {
    /// Checks the assumptions of every reader of the document.
    /// Errors: an unknown version, or a duplicate id.
    pub fn check(&self) -> Result<(), Problem> {
        let mut parts = self.version.split('.');
        let known = match (parts.next(), parts.next()) {
            (Some("1"), Some(minor)) => ["0", "1", "2", "3", "4", "5", "6", "7"].contains(&minor),
            (Some("2"), minor) => minor == Some("0"),
            _ => false,
        };
        if !known {
            let reason = "unknown, known are 1.0 to 1.7 and 2.0";
            let help = "export the file in one of these versions";
            return Err(Problem {
                value: Some(shown(&self.version)),
                ..Problem::at("model version", reason, help)
            });
        }
        let mut seen = HashSet::new();
        for component in &self.components {
            if !seen.insert(component.id) {
                return Err(duplicate(&component.place()));
            }
            let mut seen = HashSet::new();
            for attribute in &component.attributes {
                if !seen.insert(&attribute.id) {
                    return Err(duplicate(&component.place_of(&attribute.id)));
                }
            }
        }
        Ok(())
    }

    /// The component with an id.
    /// Errors: it does not exist.
    pub fn component(&self, id: i32, relation: &Relation) -> Result<&Component, String> {
        let found = self.components.iter().find(|component| component.id == id);
        found.ok_or_else(|| {
            relation.problem(format!(
                "names component {id}, which the file does not have"
            ))
        })
    }

    /// The relations of a kind in which a component has a role.
    pub fn relations(&self, kind: &str, role: &str, id: i32) -> impl Iterator<Item = &Relation> {
        let relations = self.relations.iter();
        relations.filter(move |relation| {
            relation.kind == kind && relation.refs.iter().any(|(r, i)| r == role && *i == id)
        })
    }

    /// The number of components of each kind, without those in `read`.
    pub fn kinds_beside(&self, read: &[i32]) -> Vec<(String, usize)> {
        let mut kinds = BTreeMap::new();
        let rest = self.components.iter().filter(|c| !read.contains(&c.id));
        for component in rest {
            *kinds.entry(cut(&component.kind, LONGEST)).or_insert(0) += 1;
        }
        kinds.into_iter().collect()
    }
}

impl Component {
    pub fn place(&self) -> String {
        format!("{} {}", cut(&self.kind, LONGEST), self.id)
    }

    /// The name of an attribute in messages.
    pub fn place_of(&self, attribute: &str) -> String {
        format!("{}, {}", self.place(), cut(attribute, LONGEST))
    }

    pub fn attribute(&self, id: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|attribute| attribute.id == id)
    }
}

impl Relation {
    /// The component in a role.
    /// Errors: no component has it, or several do.
    pub fn one(&self, role: &str) -> Result<i32, String> {
        let mut all = self.refs.iter().filter(|(r, _)| r == role);
        match (all.next(), all.next()) {
            (Some((_, id)), None) => Ok(*id),
            (found, _) => {
                let count = found.map_or("no", |_| "more than one");
                Err(self.problem(format!("has {count} component as {role}, expected one")))
            }
        }
    }

    fn problem(&self, reason: String) -> String {
        Problem::at(format!("relation {}", self.id), reason, EXPORT_AGAIN).to_string()
    }
}

/// Text of a file, for comparison.
pub fn text_of(text: &str) -> String {
    plain(text.trim())
}

/// Text of a file, for display.
pub fn shown(text: &str) -> String {
    cut(&plain(text.trim()), LONGEST)
}

fn duplicate(place: &str) -> Problem {
    let help = "remove one of them, or export the file again";
    Problem::at(place, "stands twice", help)
}

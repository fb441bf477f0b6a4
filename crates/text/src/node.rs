//! A pair file as a tree of values, the same for TOML and JSON.

use crate::characters::cut;
use serde::de::{
    Deserialize, DeserializeOwned, Deserializer, Error, MapAccess, SeqAccess, Visitor,
};
use serde_json::Value;
use std::collections::HashSet;
use std::fmt;

/// Characters of a value or a cell that a message shows. Tuned: they fit a line of a terminal beside the reason.
pub const LONGEST: usize = 60;

/// Most keys of one table: a hundred times the known ones. Further keys cannot be meaningful.
const MAX_KEYS: usize = 1000;

/// A value as written in the file.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// `true` or `false`.
    Flag(bool),
    /// A whole number.
    Whole(i64),
    /// Any other number; TOML can write `nan` and `inf`.
    Number(f64),
    /// A text.
    Text(String),
    /// A list.
    List(Vec<Node>),
    /// A table or object, its keys distinct.
    Table(Vec<(String, Node)>),
    /// JSON's `null`.
    Null,
    /// A TOML date or time, as written.
    Date(String),
}

impl Node {
    /// Its kind, with the article.
    pub fn kind(&self) -> &'static str {
        match self {
            Node::Flag(_) => "a boolean",
            Node::Whole(_) | Node::Number(_) => "a number",
            Node::Text(_) => "a string",
            Node::List(_) => "a list",
            Node::Table(_) => "a table",
            Node::Null => "null",
            Node::Date(_) => "a date or time",
        }
    }

    /// The keys and values of a table; empty for other kinds.
    pub fn entries(&self) -> &[(String, Node)] {
        match self {
            Node::Table(entries) => entries,
            _ => &[],
        }
    }

    /// The elements of a list; empty for other kinds.
    pub fn list(&self) -> &[Node] {
        match self {
            Node::List(list) => list,
            _ => &[],
        }
    }

    /// The value for a message: as written, long ones cut.
    pub fn shown(&self) -> String {
        let mut text = String::new();
        self.write(&mut text, LONGEST);
        cut(&text, LONGEST)
    }

    /// The value as a spec that its schema allows.
    pub fn to<T: DeserializeOwned>(&self) -> serde_json::Result<T> {
        serde_json::from_value(self.into())
    }

    /// Appends the value, and stops adding elements once `text` is longer than `enough`.
    fn write(&self, text: &mut String, enough: usize) {
        match self {
            Node::Flag(flag) => text.push_str(&flag.to_string()),
            Node::Whole(whole) => text.push_str(&whole.to_string()),
            Node::Number(number) => text.push_str(&format!("{number:?}")),
            Node::Text(string) => {
                let start: String = string.chars().take(enough + 1).collect();
                text.push_str(&format!("{start:?}"));
            }
            Node::List(list) => {
                text.push('[');
                for (i, element) in list.iter().enumerate() {
                    if text.len() > enough {
                        break;
                    }
                    text.push_str(if i > 0 { ", " } else { "" });
                    element.write(text, enough);
                }
                text.push(']');
            }
            Node::Table(entries) => {
                text.push('{');
                for (i, (key, value)) in entries.iter().enumerate() {
                    if text.len() > enough {
                        break;
                    }
                    text.push_str(if i > 0 { ", " } else { " " });
                    text.push_str(key);
                    text.push_str(" = ");
                    value.write(text, enough);
                }
                text.push_str(" }");
            }
            Node::Null => text.push_str("null"),
            Node::Date(date) => text.push_str(date),
        }
    }
}

impl From<toml::Value> for Node {
    fn from(value: toml::Value) -> Node {
        match value {
            toml::Value::Boolean(flag) => Node::Flag(flag),
            toml::Value::Integer(whole) => Node::Whole(whole),
            toml::Value::Float(number) => Node::Number(number),
            toml::Value::String(text) => Node::Text(text),
            toml::Value::Array(list) => Node::List(list.into_iter().map(Node::from).collect()),
            toml::Value::Table(table) => Node::Table(
                table
                    .into_iter()
                    .map(|(key, value)| (key, Node::from(value)))
                    .collect(),
            ),
            toml::Value::Datetime(date) => Node::Date(date.to_string()),
        }
    }
}

impl From<&Node> for Value {
    fn from(node: &Node) -> Value {
        match node {
            Node::Flag(flag) => (*flag).into(),
            Node::Whole(whole) => (*whole).into(),
            // JSON writers like to print whole numbers with a point; −0.0 keeps its sign.
            Node::Number(number)
                if number.fract() == 0.0
                    && number.abs() < 9e15
                    && (*number != 0.0 || number.is_sign_positive()) =>
            {
                (*number as i64).into()
            }
            Node::Number(number) => (*number).into(),
            Node::Text(text) | Node::Date(text) => text.as_str().into(),
            Node::List(list) => list.iter().map(Value::from).collect(),
            Node::Table(entries) => {
                let entries = entries.iter();
                let entries = entries.map(|(key, node)| (key.clone(), Value::from(node)));
                Value::Object(entries.collect())
            }
            Node::Null => Value::Null,
        }
    }
}

/// `serde_json::Value` would silently keep the last of two equal keys; here they are an error.
impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Node, D::Error> {
        deserializer.deserialize_any(NodeVisitor)
    }
}

struct NodeVisitor;

impl<'de> Visitor<'de> for NodeVisitor {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_bool<E>(self, flag: bool) -> Result<Node, E> {
        Ok(Node::Flag(flag))
    }

    fn visit_i64<E>(self, whole: i64) -> Result<Node, E> {
        Ok(Node::Whole(whole))
    }

    fn visit_u64<E>(self, whole: u64) -> Result<Node, E> {
        // Only lengths could exceed i64, and no length has as many digits.
        Ok(i64::try_from(whole).map_or(Node::Number(whole as f64), Node::Whole))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Node, E> {
        Ok(Node::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Node, E> {
        Ok(Node::Text(text.to_owned()))
    }

    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::Null)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Node, A::Error> {
        let mut list = Vec::new();
        while let Some(element) = seq.next_element()? {
            list.push(element);
        }
        Ok(Node::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Node, A::Error> {
        let mut seen = HashSet::new();
        let mut entries = Vec::new();
        while let Some((key, value)) = map.next_entry::<String, Node>()? {
            if !seen.insert(key.clone()) {
                let key = cut(&key, LONGEST);
                return Err(A::Error::custom(format!("key `{key}` is given twice")));
            }
            entries.push((key, value));
            if entries.len() > MAX_KEYS {
                return Err(A::Error::custom(format!(
                    "more than {MAX_KEYS} keys in one table, at most a dozen are known"
                )));
            }
        }
        Ok(Node::Table(entries))
    }
}

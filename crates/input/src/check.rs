//! Checks a file against the schema of its spec. It reports every problem at once, with key, value, allowed values and remedy.
//!
//! The schema holds type, range and description of each key, and which keys go together ([`crate::spec`]). Serde then reads the
//! spec. Values of two tables and the geometry are checked where they are used.

use crate::spec::{self, members};
use crate::unknown_key::{is_slip, key_reason, nearest, synonym, teeth_reason};
use gearlash_text::characters::listed;
use gearlash_text::numbers::shortest;
use gearlash_text::{Node, Problem, Reading, Table, below};
use serde_json::Value;

/// Units at the end of a key's name.
const UNITS: [(&str, &str); 6] = [
    ("mm", "mm"),
    ("um", "µm"),
    ("deg", "degrees"),
    ("arcmin", "minutes of arc"),
    ("c", "°C"),
    ("per_k", "1/K"),
];
/// Pairs of keys; the first must not exceed the second.
const ORDERED: [[&str; 2]; 4] = [
    ["min", "max"],
    ["min_mm", "max_mm"],
    ["lower", "upper"],
    ["lower_um", "upper_um"],
];

/// Checks the `file` against `schema`; its good values can be read then.
pub fn check(schema: &'static Value, file: &Table) {
    let mut walk = SchemaCheck {
        root: schema,
        reading: file.reading(),
        enclosing: Vec::new(),
    };
    walk.table("", "", file.entries(), schema, &[]);
}

struct SchemaCheck<'a> {
    root: &'static Value,
    reading: &'a Reading,
    /// The tables round the value that is checked, by their paths.
    enclosing: Vec<(String, &'static Value)>,
}

/// A value's key, unit, schema and place.
#[derive(Clone, Copy)]
struct ValuePlace<'k> {
    key: &'k str,
    unit: &'static str,
    schema: &'k Value,
    /// Its place in a list, from 1.
    place: Option<usize>,
}

impl SchemaCheck<'_> {
    fn add(&self, key: String, value: Option<&Node>, reason: String, help: String) {
        self.reading.add(Problem {
            value: value.map(Node::shown),
            key: key.clone(),
            reason,
            help,
        });
        self.reading.mark_bad(key);
    }

    fn wrong(&self, at: ValuePlace, node: &Node, reason: String, help: impl Into<String>) {
        if self.reading.count_if_full() {
            return;
        }
        let reason = match at.place {
            Some(place) => format!("value {place} of the list: {reason}"),
            None => reason,
        };
        self.add(at.key.to_owned(), Some(node), reason, help.into());
    }

    /// The alternatives of a schema, with nested ones resolved.
    fn options<'s>(&self, schema: &'s Value) -> Vec<&'s Value> {
        let mut named = schema["$ref"].as_str();
        if let Some([only]) = schema["allOf"].as_array().map(Vec::as_slice) {
            named = named.or(only["$ref"].as_str());
        }
        if let Some(name) = named {
            let found = self.root.pointer(name.trim_start_matches('#'));
            return found
                .into_iter()
                .flat_map(|found| self.options(found))
                .collect();
        }
        match schema["anyOf"].as_array() {
            Some(each) => each.iter().flat_map(|one| self.options(one)).collect(),
            None => vec![schema],
        }
    }

    fn value(&mut self, at: ValuePlace, node: &Node, schema: &'static Value) {
        let options = self.options(schema);
        let mut fitting = options
            .iter()
            .copied()
            .filter(|option| Kind::of(option).fits(node));
        let Some(mut option) = fitting.next() else {
            let reason = format!(
                "{}, allowed is {}",
                node.kind(),
                self.allowed(schema, at.unit)
            );
            let only = match &options[..] {
                [only] => Some(Kind::of(only)),
                _ => None,
            };
            let help = match only {
                Some(Kind::Table) if !at.key.ends_with(']') => {
                    format!("write [{}] and its keys below", at.key)
                }
                Some(Kind::Word) => "write one of these, in quotes".to_owned(),
                Some(Kind::Text) => "write it in quotes".to_owned(),
                Some(Kind::Flag) => "write it without quotes".to_owned(),
                _ => self.description(at.schema),
            };
            return self.wrong(at, node, reason, help);
        };
        match node {
            Node::Table(entries) => {
                // A later table counts where its needed keys are there.
                let has_all = |option: &&Value| {
                    let mut needed = strings(&option["required"]);
                    needed.all(|name| entries.iter().any(|(key, _)| key == name))
                };
                option = fitting.rfind(has_all).unwrap_or(option);
                let others = options
                    .iter()
                    .filter(|other| !std::ptr::eq(**other, option));
                self.table(
                    at.key,
                    at.unit,
                    entries,
                    option,
                    &others.copied().collect::<Vec<_>>(),
                );
            }
            Node::List(list) => self.list(at, node, list, option),
            Node::Text(text) if Kind::of(option) == Kind::Word => {
                self.word(at, node, text, option);
            }
            Node::Text(text) => {
                if let Some(reason) = spec::designation_fault(option, text) {
                    self.wrong(
                        at,
                        node,
                        reason,
                        "copy it from the drawing, or give numbers",
                    );
                }
            }
            Node::Whole(whole) => self.number(at, node, *whole as f64, option),
            Node::Number(number) => self.number(at, node, *number, option),
            Node::Flag(_) | Node::Null | Node::Date(_) => {}
        }
    }

    fn number(&self, at: ValuePlace, node: &Node, number: f64, schema: &Value) {
        let bound = |name: &str| schema[name].as_f64();
        if let Some(reason) = teeth_reason(at.key, node) {
            return self.wrong(at, node, reason.to_owned(), "give an external pair");
        }
        let wrong = if !number.is_finite() {
            "not finite"
        } else if Kind::of(schema) == Kind::Whole && number.fract() != 0.0 {
            "not whole"
        } else if bound("minimum").is_some_and(|least| number < least)
            || bound("exclusiveMinimum").is_some_and(|least| number <= least)
            || bound("maximum").is_some_and(|most| number > most)
        {
            "out of range"
        } else {
            return;
        };
        let reason = format!("{wrong}, allowed is {}", self.allowed(schema, at.unit));
        self.wrong(at, node, reason, self.description(at.schema));
    }

    fn word(&self, at: ValuePlace, node: &Node, text: &str, schema: &Value) {
        let words = allowed_words(schema);
        if words.contains(&text) {
            return;
        }
        let help = match nearest(text, &words) {
            Some((word, distance)) if is_slip(text, distance) => {
                format!("did you mean \"{word}\"?")
            }
            _ => "write one of these".to_owned(),
        };
        let reason = format!("unknown, allowed is {}", quoted(&words, "\""));
        self.wrong(at, node, reason, help);
    }

    fn list(&mut self, at: ValuePlace, node: &Node, list: &[Node], schema: &'static Value) {
        let length = |name: &str| schema[name].as_u64();
        let (least, most) = (length("minItems").unwrap_or(0), length("maxItems"));
        let count = list.len() as u64;
        if count < least || most.is_some_and(|most| count > most) {
            let reason = match most {
                Some(most) if most == least => format!("length {count}, expected {least}"),
                Some(most) if count > most => {
                    format!("length {count}, allowed are up to {}", grouped(most as f64))
                }
                _ if count == 0 => "an empty list, expected at least one value".to_owned(),
                _ => format!("length {count}, expected at least {least}"),
            };
            return self.wrong(at, node, reason, self.description(at.schema));
        }
        let items = &schema["items"];
        let kinds: Vec<Kind> = self.options(items).into_iter().map(Kind::of).collect();
        self.reading.list(at.key, || {
            for (place, element) in (1..).zip(list) {
                if kinds == [Kind::Table] {
                    let key = format!("{}[{place}]", at.key);
                    let at = ValuePlace { key: &key, ..at };
                    self.value(at, element, items);
                } else if let (Node::List(_), [Kind::List]) = (element, &kinds[..]) {
                    self.list_in_list(at, place, element, items);
                } else {
                    let place = Some(place);
                    self.value(ValuePlace { place, ..at }, element, items);
                }
            }
            Some(())
        });
    }

    /// Merges all problems of an inner list into one problem of it.
    fn list_in_list(&mut self, at: ValuePlace, place: usize, node: &Node, schema: &'static Value) {
        let ((), inner) = self
            .reading
            .capture_problems(|| self.value(at, node, schema));
        let inner = inner.into_list();
        if !inner.is_empty() {
            let reasons: Vec<String> = inner.into_iter().map(|problem| problem.reason).collect();
            let place = Some(place);
            let words = self.description(at.schema);
            self.wrong(ValuePlace { place, ..at }, node, reasons.join("; "), words);
        }
    }

    fn table(
        &mut self,
        path: &str,
        unit: &'static str,
        entries: &[(String, Node)],
        schema: &'static Value,
        others: &[&Value],
    ) {
        let properties = schema["properties"].as_object();
        let known = names(schema);
        let mut table = Keys {
            path,
            entries,
            mistyped: Vec::new(),
        };
        self.enclosing.push((path.to_owned(), schema));
        self.check_unknown(&mut table, &known, schema, others);
        for (name, inner) in properties.into_iter().flatten() {
            let key = below(path, name);
            let Some(node) = table.get(name) else {
                let mut needed = strings(&schema["required"]);
                if needed.any(|needed| needed == name) && !table.means(name) {
                    let allowed = self.allowed(inner, unit_of(name).unwrap_or(unit));
                    self.missing(&table, name, &allowed);
                }
                continue;
            };
            let at = ValuePlace {
                key: &key,
                unit: unit_of(name).unwrap_or(unit),
                schema: inner,
                place: None,
            };
            self.value(at, node, inner);
        }
        self.enclosing.pop();
        self.check_combinations(&table, schema);
        for [low, high] in ORDERED {
            if let (Some(least), Some(most)) = (table.number(low), table.number(high))
                && least > most
                && known.contains(&low)
            {
                let reason = format!("greater than {high} = {most:?}, allowed is up to {high}");
                self.add(
                    below(path, low),
                    table.get(low),
                    reason,
                    "swap the two".to_owned(),
                );
            }
        }
    }

    /// Keys that are not known, and those that they mean.
    fn check_unknown<'t>(
        &self,
        table: &mut Keys<'t>,
        known: &[&'t str],
        schema: &Value,
        others: &[&Value],
    ) {
        self.reading.list(table.path, || {
            for (name, node) in table.entries {
                if known.contains(&name.as_str()) {
                    continue;
                }
                let key = below(table.path, &printable(name));
                self.reading.mark_bad(key.clone());
                if self.reading.count_if_full() {
                    continue;
                }
                let in_place_of = |other: &&Value| other["properties"].get(name).is_some();
                let beside = strings(&schema["required"]).next();
                let beside = beside.filter(|_| others.iter().any(in_place_of));
                let (reason, help) = if let Some(beside) = beside {
                    (
                        format!("given together with {beside}, which stands in its place"),
                        "remove one or the other".to_owned(),
                    )
                } else if let Some((reason, help)) = key_reason(&key, name, node) {
                    (reason.to_owned(), help.to_owned())
                } else {
                    let near =
                        nearest(name, known).filter(|(_, distance)| is_slip(name, *distance));
                    let meant = near.map(|(key, _)| key).or_else(|| synonym(name, known));
                    let help = if let Some(meant) = meant {
                        table.mistyped.push(meant);
                        self.reading.mark_bad(below(table.path, meant));
                        let stem = name.strip_suffix("_in");
                        if stem.is_some() && stem == meant.strip_suffix("_mm") {
                            format!("`_in` takes numbers alone; write `{meant}` in mm")
                        } else {
                            format!("did you mean `{meant}`? If not, remove it")
                        }
                    } else {
                        match &self.tables_with(name, node)[..] {
                            [] => "remove it".to_owned(),
                            places => format!("write it {}", listed(places, "or")),
                        }
                    };
                    let reason = format!("unknown key, expected {}", quoted(known, "`"));
                    (reason, help)
                };
                self.reading.add(Problem {
                    key,
                    value: Some(node.shown()),
                    reason,
                    help,
                });
            }
            Some(())
        });
    }

    /// The nearest table round the present one that has a key `name` for `node`, else those inside it, or inside the one round it.
    fn tables_with(&self, name: &str, node: &Node) -> Vec<String> {
        const MOST: usize = 3;
        let has = |table: &Value| {
            let key = table["properties"].get(name);
            let mut options = key.into_iter().flat_map(|key| self.options(key));
            options.any(|option| Kind::of(option).fits(node))
        };
        let mut round = self.enclosing.iter().rev().skip(1);
        match round.find(|(_, table)| has(table)) {
            Some((path, _)) if path.is_empty() => {
                return vec!["before the first [table]".to_owned()];
            }
            Some((path, _)) => return vec![format!("in [{path}]")],
            None => {}
        }
        let inside = self.enclosing.iter().rev().take(2).map(|(path, table)| {
            let keys = table["properties"].as_object().into_iter().flatten();
            let with = keys.filter(|(_, schema)| self.options(schema).into_iter().any(has));
            with.map(|(key, _)| format!("in [{}]", below(path, key)))
                .collect()
        });
        let found = inside
            .into_iter()
            .find(|places: &Vec<String>| !places.is_empty());
        found
            .filter(|places| places.len() <= MOST)
            .unwrap_or_default()
    }

    fn missing(&self, table: &Keys, name: &str, allowed: &str) {
        let place = match table.path {
            "" => "the file".to_owned(),
            path => format!("[{path}]"),
        };
        let reason = format!("missing, expected {allowed}");
        let help = format!("add `{name}` to {place}");
        self.add(below(table.path, name), None, reason, help);
    }

    fn check_combinations(&self, table: &Keys, schema: &Value) {
        let wrong = |key: &str, reason: String, help: String| {
            self.add(below(table.path, key), table.get(key), reason, help);
        };
        let conflict = |keys: &[&str], allowed: &str| {
            let [one, others @ ..] = keys else { return };
            let others = others.join(", ");
            let reason = format!("given together with {others}, allowed is {allowed}");
            wrong(one, reason, "remove one or the other".to_owned());
        };
        for pair in schema.get("not").into_iter().flat_map(alternatives) {
            let keys: Vec<&str> = strings(&pair["required"]).collect();
            if keys.iter().all(|key| table.means(key)) {
                return conflict(&keys, "one of them");
            }
        }
        let groups = members(schema, "oneOf").map(|group| strings(&group["required"]));
        let groups: Vec<Vec<&str>> = groups.map(Iterator::collect).collect();
        let given: Vec<&str> = groups
            .iter()
            .filter_map(|group| group.iter().copied().find(|key| table.means(key)))
            .collect();
        let each = groups
            .iter()
            .map(|group| format!("`{}`", group.join("` and `")));
        let allowed = format!("one of {}", listed(&each.collect::<Vec<_>>(), "or"));
        if given.len() > 1 {
            return conflict(&given, &allowed);
        }
        let mut depends = false;
        for (key, condition) in schema["dependencies"].as_object().into_iter().flatten() {
            let unmet = table.get(key).and_then(|_| table.unmet(key, condition));
            if let Some((reason, help)) = unmet {
                wrong(key, reason, help);
                depends = true;
            }
        }
        if let (true, false, Some(group)) = (given.is_empty(), depends, groups.first()) {
            self.missing(table, group[0], &allowed);
        }
        let needed: Vec<&str> = strings(&schema["required"]).collect();
        let least = schema["minProperties"].as_u64().unwrap_or(0);
        if (table.entries.len() as u64) < least && needed.iter().all(|key| table.means(key)) {
            let mut names = names(schema);
            names.retain(|name| !needed.contains(name));
            let reason = format!(
                "says nothing, expected at least one of {}",
                quoted(&names, "`")
            );
            let help = "add one of them, or remove it".to_owned();
            self.add(table.path.to_owned(), None, reason, help);
        }
    }

    /// The meaning of a key, as a part of a sentence.
    fn description(&self, schema: &Value) -> String {
        let options = self.options(schema);
        let each = [schema].into_iter().chain(options.into_iter().take(1));
        let mut descriptions = each.filter_map(|one| one["description"].as_str());
        let words = spec::as_clause(descriptions.next().unwrap_or("correct it"));
        match schema["default"].as_f64() {
            Some(default) => format!("{words}; {} by default", grouped(default)),
            None => words,
        }
    }

    /// The allowed values, in words.
    fn allowed(&self, schema: &Value, unit: &str) -> String {
        let options = self.options(schema);
        let each: Vec<String> = options
            .iter()
            .map(|option| match Kind::of(option) {
                Kind::Flag => "true or false".to_owned(),
                Kind::Word => quoted(&allowed_words(option), "\""),
                Kind::Text if option.get("pattern").is_some() => "a designation".to_owned(),
                Kind::Text => "a string".to_owned(),
                Kind::Whole => format!("a whole number{}", range(option)),
                Kind::Number if unit.is_empty() => format!("a number{}", range(option)),
                Kind::Number => format!("a number of {unit}{}", range(option)),
                Kind::List => self.elements(option),
                Kind::Table if options.len() > 1 => {
                    let needed = strings(&option["required"]);
                    let first = members(option, "oneOf").next();
                    let chosen = first
                        .into_iter()
                        .flat_map(|group| strings(&group["required"]));
                    let keys: Vec<String> = needed
                        .chain(chosen)
                        .map(|key| format!("{key} = …"))
                        .collect();
                    format!("{{ {} }}", keys.join(", "))
                }
                Kind::Table => {
                    format!("a table of {}", quoted(&names(option), "`"))
                }
            })
            .collect();
        each.join(", or ")
    }

    fn elements(&self, list: &Value) -> String {
        let items = self.options(&list["items"]).into_iter();
        let name = match items.map(Kind::of).next() {
            Some(Kind::Number) => "numbers",
            Some(Kind::Whole) => "whole numbers",
            Some(Kind::Text | Kind::Word) => "strings",
            Some(Kind::List) => "lists",
            _ => "tables",
        };
        match (list["minItems"].as_u64(), list["maxItems"].as_u64()) {
            (Some(least), Some(most)) if least == most => format!("a list of {least} {name}"),
            _ => format!("a list of {name}"),
        }
    }
}

struct Keys<'t> {
    path: &'t str,
    entries: &'t [(String, Node)],
    /// Known keys that unknown ones mean: not missing, but mistyped.
    mistyped: Vec<&'t str>,
}

impl<'t> Keys<'t> {
    fn get(&self, name: &str) -> Option<&'t Node> {
        let found = self.entries.iter().find(|(key, _)| key == name);
        found.map(|(_, node)| node)
    }

    fn means(&self, name: &str) -> bool {
        self.mistyped.contains(&name) || self.get(name).is_some()
    }

    fn number(&self, name: &str) -> Option<f64> {
        match self.get(name)? {
            Node::Whole(whole) => Some(*whole as f64),
            Node::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// The fault of `key` where its `condition` does not hold.
    fn unmet(&self, key: &str, condition: &Value) -> Option<(String, String)> {
        if let Some(all) = condition["allOf"].as_array() {
            return all.iter().find_map(|one| self.unmet(key, one));
        }
        if let Some(not) = condition.get("not") {
            let each = alternatives(not).flat_map(|one| strings(&one["required"]));
            let other = each.into_iter().find(|name| self.means(name))?;
            return Some((
                format!("given together with {other}, allowed is one of them"),
                "remove one or the other".to_owned(),
            ));
        }
        let is_list = |one: &Value, name: &str| {
            one.get("properties").is_none() || matches!(self.get(name), Some(Node::List(_)))
        };
        let mut lacking = Vec::new();
        for one in alternatives(condition) {
            let lacks = |name: &&str| !(self.means(name) && is_list(one, name));
            let name = strings(&one["required"]).find(lacks)?;
            lacking.push(match one.get("properties") {
                Some(_) => format!("{name} = [ … ]"),
                None => name.to_owned(),
            });
        }
        let words = listed(&lacking, "or");
        Some((
            format!("given without {words}, allowed only with it"),
            format!("add `{}`, or remove {key}", lacking.first()?),
        ))
    }
}

/// The kind of value that a schema without alternatives allows.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Flag,
    Number,
    Whole,
    Word,
    Text,
    List,
    Table,
}

impl Kind {
    fn of(schema: &Value) -> Kind {
        match schema["type"].as_str() {
            Some("object") => Kind::Table,
            Some("array") => Kind::List,
            Some("boolean") => Kind::Flag,
            Some("number") => Kind::Number,
            Some("integer") => Kind::Whole,
            _ if !allowed_words(schema).is_empty() => Kind::Word,
            _ => Kind::Text,
        }
    }

    fn fits(self, node: &Node) -> bool {
        match node {
            Node::Flag(_) => self == Kind::Flag,
            Node::Whole(_) | Node::Number(_) => matches!(self, Kind::Number | Kind::Whole),
            Node::Text(_) => matches!(self, Kind::Word | Kind::Text),
            Node::List(_) => self == Kind::List,
            Node::Table(_) => self == Kind::Table,
            Node::Null | Node::Date(_) => false,
        }
    }
}

fn allowed_words(schema: &Value) -> Vec<&str> {
    let described = members(schema, "oneOf").filter_map(|one| one["const"].as_str());
    strings(&schema["enum"]).chain(described).collect()
}

fn names(schema: &Value) -> Vec<&str> {
    let keys = schema["properties"].as_object().into_iter().flatten();
    keys.map(|(key, _)| key.as_str()).collect()
}

/// The members of `anyOf`, or the condition itself.
fn alternatives(condition: &Value) -> impl Iterator<Item = &Value> {
    let alone = condition.get("anyOf").is_none().then_some(condition);
    members(condition, "anyOf").chain(alone)
}

fn strings(list: &Value) -> impl Iterator<Item = &str> {
    list.as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
}

fn unit_of(key: &str) -> Option<&'static str> {
    let ends = |unit: &str| {
        key.strip_suffix(unit)
            .is_some_and(|name| name.is_empty() && unit.len() == 2 || name.ends_with('_'))
    };
    UNITS
        .into_iter()
        .find(|(end, _)| ends(end))
        .map(|(_, unit)| unit)
}

/// ", 0.01 … 1000" of a number's schema; " above 0 and up to 10".
fn range(schema: &Value) -> String {
    let bound = |name: &str| schema[name].as_f64().map(grouped);
    match (
        bound("minimum"),
        bound("exclusiveMinimum"),
        bound("maximum"),
    ) {
        (Some(least), _, Some(most)) => format!(", {least} … {most}"),
        (Some(least), _, None) => format!(", {least} or more"),
        (None, Some(least), Some(most)) => format!(" above {least} and up to {most}"),
        _ => String::new(),
    }
}

/// A bound: `10 000`, `1e7`.
fn grouped(bound: f64) -> String {
    let size = bound.abs();
    if size >= 1e6 && size.log10().fract() == 0.0 {
        return format!("{}1e{}", if bound < 0.0 { "−" } else { "" }, size.log10());
    }
    if size > 0.0 && size < 1e-3 {
        return format!("{bound:e}");
    }
    let text = shortest(bound);
    match text.len() {
        5..=6 if bound.fract() == 0.0 && bound > 0.0 => {
            let (thousands, rest) = text.split_at(text.len() - 3);
            format!("{thousands} {rest}")
        }
        _ => text,
    }
}

/// "`a`, `b` or `c`", each between `mark`s.
pub fn quoted(words: &[&str], mark: &str) -> String {
    let marked: Vec<String> = words.iter().map(|w| format!("{mark}{w}{mark}")).collect();
    listed(&marked, "or")
}

/// An unknown key for a message: as written, in quotes where it is no bare TOML key.
fn printable(name: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.len() <= 64 && name.chars().all(bare) {
        name.to_owned()
    } else {
        Node::Text(name.to_owned()).shown()
    }
}

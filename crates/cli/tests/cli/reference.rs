//! The lists of docs/reference: those that the program knows are written by it, the others are complete. So are the schemas that the page in the
//! browser reads.
//!
//! `GEARLASH_DOCS=write cargo test --release -p gearlash-cli --test cli reference` stores the lists anew.

use super::{docs::docs, empty_folder, fixture, gearlash};
use clap::{Arg, ArgAction, Command};
use serde_json::{Map, Value};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::path::Path;

/// Keys of any table of readings, which the page explains once.
const OF_TABLES: [&str; 5] = ["sheet", "header_row", "tooth_column", "column", "decimal"];

/// Fails unless the file at `path` holds `text`, which is stored where that is asked for.
fn assert_stored(path: &Path, text: &str) {
    if std::env::var("GEARLASH_DOCS").is_ok_and(|value| value == "write") {
        fs::write(path, text).unwrap();
    }
    let is_stored = fs::read_to_string(path).is_ok_and(|stored| stored == text);
    let store = "GEARLASH_DOCS=write cargo test --release -p gearlash-cli --test cli reference";
    assert!(is_stored, "{path:?} is out of date; store it by\n{store}");
}

/// Compares what stands between the marks `name` of a page with `list`, or stores it.
fn assert_written(page: &str, name: &str, list: &str) {
    let path = docs().join("reference").join(page);
    let text = fs::read_to_string(&path).unwrap();
    let begin = format!("<!-- {name}: written by the tests -->\n");
    let end = format!("<!-- end of {name} -->");
    let (before, rest) = text.split_once(&begin).unwrap();
    let (_, after) = rest.split_once(&end).unwrap();
    let list = format!("\n{}\n\n", list.trim());
    assert_stored(&path, &format!("{before}{begin}{list}{end}{after}"));
}

#[test]
fn the_reference_has_every_key_of_the_pair_file() {
    let schema: Value = serde_json::from_str(&gearlash_input::pair_schema()).unwrap();
    let mut keys = Keys {
        schema: &schema,
        text: String::new(),
        listed: HashMap::new(),
        tables: HashMap::new(),
    };
    keys.table("", &schema);
    assert_written("pair-file.md", "keys", &keys.text);
}

/// The keys of the pair file as a list in Markdown, a section for each table.
struct Keys<'s> {
    schema: &'s Value,
    text: String,
    /// The table that explains a key with these words.
    listed: HashMap<(&'s str, &'s str), String>,
    /// The first table that has these keys.
    tables: HashMap<Vec<&'s String>, String>,
}

impl<'s> Keys<'s> {
    /// The schema that `node` refers to.
    fn resolved(&self, node: &'s Value) -> &'s Value {
        if let Some(target) = node["$ref"].as_str() {
            return self.resolved(self.schema.pointer(&target[1..]).unwrap());
        }
        match node["allOf"].as_array().map(Vec::as_slice) {
            Some([only]) if node.get("properties").is_none() => self.resolved(only),
            _ => node,
        }
    }

    /// The alternatives of a schema, none of which has others.
    fn options(&self, node: &'s Value) -> Vec<&'s Value> {
        let node = self.resolved(node);
        match node["anyOf"].as_array() {
            Some(any) if node.get("properties").is_none() => {
                any.iter().flat_map(|option| self.options(option)).collect()
            }
            _ => vec![node],
        }
    }

    /// Whether no key of a table is a table.
    fn is_flat(&self, table: &'s Value) -> bool {
        own_keys(table).all(|(_, node)| self.resolved(node).get("properties").is_none())
    }

    fn table(&mut self, path: &str, table: &'s Value) {
        if !path.is_empty() {
            let heading = format!("### `[{path}]`");
            let is_again = self.text.contains(&heading);
            let again = if is_again { ", drawn" } else { "" };
            self.text += &format!("\n{heading}{again}\n\n");
        }
        let mut as_elsewhere: BTreeMap<String, Vec<String>> = BTreeMap::new();
        let mut below = Vec::new();
        for (key, node) in own_keys(table) {
            let words = node["description"].as_str();
            let words = words
                .or(self.resolved(node)["description"].as_str())
                .unwrap_or("");
            let words = words.trim_end_matches('.');
            if let Some(elsewhere) = self.listed.get(&(key.as_str(), words)) {
                let keys = as_elsewhere.entry(elsewhere.clone()).or_default();
                keys.push(format!("`{key}`"));
                continue;
            }
            self.listed.insert((key.as_str(), words), path.to_owned());
            let options = self.options(node);
            let mut allowed: Vec<String> = Vec::new();
            let mut like = String::new();
            for option in &options {
                let inner = match option["items"].get("anyOf") {
                    None => self.resolved(&option["items"]),
                    Some(_) => &Value::Null,
                };
                for table in [*option, inner] {
                    let names: Vec<&String> = own_keys(table).map(|(key, _)| key).collect();
                    let place = [path, key.as_str()].join(".").trim_matches('.').to_owned();
                    if names.is_empty() {
                    } else if names == ["file"]
                        || options.len() > 1 && names.len() <= 4 && self.is_flat(table)
                    {
                        let names: Vec<&str> = names.iter().map(|name| name.as_str()).collect();
                        allowed.push(format!("{{{}}}", names.join(",")));
                    } else if let Some(first) = self.tables.get(&names) {
                        if *first != place {
                            like = format!(" Keys: `[{first}]`.");
                        }
                    } else {
                        self.tables.insert(names, place.clone());
                        below.push((place, table));
                    }
                }
                allowed.extend(range(option));
            }
            if let Some(default) = node.get("default") {
                allowed.push(format!("={default}"));
            }
            // A number without bounds has a unit in its name.
            if matches!(&allowed[..], [only] if only == "number" || only == "text") {
                allowed.clear();
            }
            let mut once = BTreeSet::new();
            allowed.retain(|each| once.insert(each.clone()));
            let allowed = if allowed.is_empty() {
                String::new()
            } else {
                format!(" ({})", allowed.join(", "))
            };
            self.text += &format!("- `{key}`{allowed}: {words}.{like}\n");
        }
        for (place, keys) in as_elsewhere {
            self.text += &format!("- {}: as in `[{place}]`.\n", keys.join(", "));
        }
        for (place, table) in below {
            self.table(&place, table);
        }
    }
}

fn own_keys(table: &Value) -> impl Iterator<Item = (&String, &Value)> {
    let keys = table["properties"].as_object().into_iter().flatten();
    keys.filter(|(key, _)| !OF_TABLES.contains(&key.as_str()))
}

/// The values that a schema without alternatives allows; `None` for a table.
fn range(schema: &Value) -> Option<String> {
    if let Some(words) = schema["oneOf"].as_array() {
        let words: Option<Vec<String>> = words
            .iter()
            .map(|word| Some(word.get("const")?.to_string()))
            .collect();
        if let Some(words) = words {
            return Some(words.join("/"));
        }
    }
    let bound = |name: &str| schema[name].as_f64().filter(|bound| bound.abs() < 1e6);
    match schema["type"].as_str()? {
        "object" => None,
        "array" => Some("list".to_owned()),
        "boolean" => Some("true/false".to_owned()),
        "string" => Some("text".to_owned()),
        _ => Some(
            match ["minimum", "exclusiveMinimum", "maximum"].map(bound) {
                [Some(least), _, Some(most)] => format!("{least}…{most}"),
                [None, Some(above), Some(most)] => format!(">{above}…{most}"),
                [Some(least), _, None] => format!("≥{least}"),
                [None, Some(above), None] => format!(">{above}"),
                [None, None, Some(most)] => format!("≤{most}"),
                [None, None, None] => "number".to_owned(),
            },
        ),
    }
}

/// The schemas for the page in the browser: each without its definitions, which are the same in all, then those.
#[test]
fn the_stored_schemas_are_those_of_the_types() {
    let mut definitions = Map::new();
    let mut line = |name, schema: &Value| {
        let mut schema = schema.clone();
        let own = schema.as_object_mut().unwrap();
        if let Some(Value::Object(own)) = own.shift_remove("definitions") {
            for (name, definition) in own {
                let before = definitions.insert(name, definition.clone());
                assert!(before.is_none_or(|before| before == definition));
            }
        }
        format!("\"{name}\": {schema}")
    };
    let mut lines: Vec<String> = gearlash_input::schemas()
        .map(|(name, schema)| line(name, schema))
        .into();
    let each = definitions
        .iter()
        .map(|(name, definition)| format!("\"{name}\": {definition}"));
    let definitions = each.collect::<Vec<_>>().join(",\n");
    lines.push(format!("\"definitions\": {{\n{definitions}\n}}"));
    let path = docs().join("../crates/input/src/spec/schemas.json");
    assert_stored(&path, &format!("{{\n{}\n}}\n", lines.join(",\n")));
}

#[test]
fn the_reference_has_every_option() {
    let program = gearlash_cli::command_line();
    let commands: Vec<&Command> = program
        .get_subcommands()
        .filter(|command| command.get_name() != "help")
        .collect();
    let mut uses: BTreeMap<String, usize> = BTreeMap::new();
    for argument in commands.iter().flat_map(|command| arguments(command)) {
        *uses.entry(explained(argument)).or_default() += 1;
    }
    let is_shared = |argument: &Arg| uses[&explained(argument)] > 1;
    let mut text = String::new();
    let mut shared = Vec::new();
    for command in &commands {
        let about = command.get_about().unwrap().to_string();
        text += &format!("### `gearlash {}`\n\n{about}.\n\n", command.get_name());
        for argument in arguments(command).filter(|argument| !is_shared(argument)) {
            text += &format!("- {}\n", explained(argument));
        }
        let of_all = |argument: &&Arg| is_shared(argument) && !argument.is_global_set();
        let also: Vec<&Arg> = arguments(command).filter(of_all).collect();
        let names: Vec<String> = also.iter().map(|argument| name(argument)).collect();
        if !names.is_empty() {
            text += &format!("- Shared: {}\n", names.join(", "));
        }
        text += "\n";
        for argument in arguments(command).filter(|argument| is_shared(argument)) {
            let line = format!("- {}\n", explained(argument));
            if !shared.contains(&line) {
                shared.push(line);
            }
        }
    }
    text += "### Shared by several commands\n\n";
    text += &shared.concat();
    assert_written("command-line.md", "commands", &text);
}

/// The arguments of a command, without those of clap itself and those that are gone.
fn arguments(command: &Command) -> impl Iterator<Item = &Arg> {
    let own = |argument: &&Arg| {
        !argument.is_hide_set() && !matches!(argument.get_id().as_str(), "help" | "version")
    };
    command.get_arguments().filter(own)
}

fn name(argument: &Arg) -> String {
    match argument.get_long() {
        Some(long) => format!("`--{long}`"),
        None => format!("`{}`", argument.get_value_names().unwrap()[0]),
    }
}

fn explained(argument: &Arg) -> String {
    let mut name = match argument.get_short() {
        Some(short) => format!("-{short}, "),
        None => String::new(),
    };
    let takes_value = matches!(argument.get_action(), ArgAction::Set | ArgAction::Append);
    let choices: Vec<String> = argument
        .get_possible_values()
        .iter()
        .filter(|_| takes_value)
        .map(|choice| choice.get_name().to_owned())
        .collect();
    let choices = if choices.is_empty() {
        String::new()
    } else {
        format!(" ({})", choices.join("/"))
    };
    let value = argument.get_value_names().filter(|_| takes_value);
    let value = value.map_or("", |names| names[0].as_str());
    name += &match argument.get_long() {
        Some(long) if choices.is_empty() => format!("--{long} {value}"),
        Some(long) => format!("--{long}"),
        None => value.to_owned(),
    };
    // Markdown takes <…> for HTML.
    let help = argument.get_help().unwrap().to_string();
    let help = help.replace('<', "\\<").replace("[default: ", "[");
    let default = match argument.get_default_values() {
        [default] if takes_value && !argument.is_hide_default_value_set() => {
            format!(" [{}]", default.to_string_lossy())
        }
        _ => String::new(),
    };
    format!("`{}`{choices}: {help}{default}.", name.trim_end())
}

/// The page explains each key of each row, and no key that no result has.
#[test]
fn the_reference_explains_every_key_of_results() {
    let page = fs::read_to_string(docs().join("reference/results.md")).unwrap();
    let explained: BTreeSet<&str> = page
        .lines()
        .filter_map(|line| {
            line.strip_prefix("- `")?
                .split_once("`: ")
                .map(|(keys, _)| keys)
        })
        .flat_map(|keys| keys.split("`, `"))
        .flat_map(|key| key.split('.'))
        .collect();
    let segments: BTreeSet<&str> = gearlash_results::keys()
        .flat_map(|key| key.split('.'))
        .filter(|segment| segment.parse::<usize>().is_err())
        .collect();
    let missing: Vec<&&str> = segments.difference(&explained).collect();
    assert!(missing.is_empty(), "not explained: {missing:?}");

    let mut written = BTreeSet::new();
    let folder = empty_folder();
    for (name, file) in [
        ("simulate", "../docs/files/drawing.toml"),
        ("check", "../docs/files/jams.toml"),
        ("check", "../docs/files/lead.toml"),
        ("compare", "../docs/files/jams.toml"),
    ] {
        let mut command = gearlash(folder.path());
        command.args([name, "--format", "json"]);
        let output = command.arg(fixture(file)).output().unwrap();
        let result = serde_json::from_slice(&output.stdout).unwrap();
        collect(&result, &mut written);
    }
    let unknown: Vec<&&str> = explained
        .iter()
        .filter(|key| !segments.contains(*key) && !written.contains(**key))
        .collect();
    assert!(unknown.is_empty(), "in no result: {unknown:?}");
}

/// The keys of a JSON value.
fn collect(value: &Value, keys: &mut BTreeSet<String>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                keys.insert(key.clone());
                collect(value, keys);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| collect(value, keys)),
        _ => {}
    }
}

/// The page explains each check by its id and title.
#[test]
fn the_reference_explains_every_check() {
    let mut checks = BTreeSet::new();
    for file in ["jams", "lead_helical", "shafts"] {
        let folder = empty_folder();
        let mut command = gearlash(folder.path());
        command.args(["check", "--format", "json"]);
        command.arg(fixture(&format!("../docs/files/{file}.toml")));
        let output = command.output().unwrap();
        let checked: Value = serde_json::from_slice(&output.stdout).unwrap();
        let own = checked["files"][0]["checks"].as_array().unwrap();
        checks.extend(own.iter().map(|check| {
            let [id, title] = ["id", "title"].map(|key| check[key].as_str().unwrap());
            format!("| `{id}` | {title} |")
        }));
    }
    let page = fs::read_to_string(docs().join("reference/checks.md")).unwrap();
    let rows = page.lines().filter(|line| line.starts_with("| `"));
    let explained: BTreeSet<String> = rows
        .map(|row| {
            let cells: Vec<&str> = row.split('|').collect();
            format!("|{}|{}|", cells[1], cells[2])
        })
        .collect();
    assert_eq!(explained, checks);
}

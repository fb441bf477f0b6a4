//! Text from files never acts: not on a terminal, not in a CI log, not in a page, a picture or a table.

use super::*;
use std::fs;

/// Titles that act somewhere: on terminals (ECMA-48 controls), on the order of text (UAX #9), in the logs of GitHub, Azure and
/// TeamCity (workflow commands), in XML, HTML, Markdown, spreadsheets and JSON.
fn titles() -> Vec<String> {
    serde_json::from_str(include_str!("titles.json")).unwrap()
}

/// The kind of text printed or written.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Text,
    Json,
    Csv,
    Xml,
    Page,
    Markdown,
    /// Workflow commands of GitHub.
    Commands,
}

use Kind::{Commands, Csv, Json, Markdown, Page, Text, Xml};

/// The commands, each with what it prints.
const COMMANDS: [(&str, Kind); 15] = [
    ("simulate PAIR -o written", Text),
    ("simulate PAIR --format json", Json),
    ("simulate PAIR --format csv", Csv),
    ("compare PAIR", Text),
    ("compare PAIR --format json", Json),
    ("compare PAIR --format junit", Xml),
    ("check PAIR --format github", Commands),
    ("compare PAIR --format markdown", Text),
    ("check PAIR", Text),
    ("check PAIR --format json", Json),
    ("snapshot PAIR --worst -o -", Xml),
    ("chart PAIR --kind inspection -o -", Xml),
    ("gauge PAIR --gear pinion -o written", Text),
    ("gauge PAIR --gear pinion --format json", Json),
    ("report PAIR -o -", Page),
];

/// Controls but line ends, `Bidi_Control` of PropList.txt, separators, noncharacters.
fn acts(c: char) -> bool {
    c.is_control() && c != '\n'
        || "\u{61c}\u{200e}\u{200f}\u{2028}\u{2029}\u{202a}\u{202b}\u{202c}\u{202d}\u{202e}\u{2066}\u{2067}\u{2068}\u{2069}\u{ffff}\u{fffe}\u{fdd0}\u{1ffff}"
            .contains(c)
}

/// No character of `text` acts, and no line is a command of a CI log.
fn harmless(text: &str, what: &str) {
    assert!(!text.contains(acts), "{what}: {text:?}");
    for line in text.lines() {
        let command = line.trim_start().starts_with("::")
            || line.contains("##[")
            || line.contains("##vso[")
            || line.contains("##teamcity[");
        assert!(!command, "{what}: {line:?}");
    }
}

/// Nothing acts in a `text` of a kind, which a parser takes; JSON reads back the very title.
fn check(text: &str, kind: Kind, title: &str, what: &str) {
    match kind {
        Page => {
            assert!(!text.contains(acts), "{what}");
            assert!(!text.contains("<script>alert") && !text.contains("<svg onload"));
        }
        Commands => {
            assert!(!text.contains(acts), "{what}: {text:?}");
            let own = ["::error file=", "::warning file="];
            let is_own = |line: &str| own.iter().any(|start| line.starts_with(start));
            assert!(text.lines().all(is_own), "{what}: {text}");
        }
        _ => harmless(text, what),
    }
    match kind {
        Json => {
            let read: Value = serde_json::from_str(text).unwrap();
            let places = ["/pair/title", "/files/0/pair/title", "/title"];
            let mut titles = places.iter().filter_map(|place| read.pointer(place));
            assert!(titles.any(|read| read == title), "{what}: {read}");
        }
        Xml => {
            let parsed = roxmltree::Document::parse(text);
            parsed.unwrap_or_else(|error| panic!("{what}: {error}\n{text}"));
        }
        Markdown => {
            let rows = text.lines().filter(|line| line.starts_with('|'));
            assert_eq!(rows.count(), 3, "{what}: {text}");
            let is_plain = !text.replace(r"\]", "").contains("](") && !text.contains("<!--");
            assert!(is_plain, "{text}");
        }
        _ => {}
    }
}

fn gear(teeth: u32) -> Value {
    json!({ "teeth": teeth, "module_mm": 2.0, "pressure_angle_deg": 20.0 })
}

fn good(title: &str) -> Value {
    json!({
        "title": title,
        "wheel": gear(20),
        "pinion": gear(17),
        "assembly": { "center_distance_mm": 37.1 },
        "sweep": { "mating": [[1, 1]] },
    })
}

fn write(folder: &Path, name: &str, pair: &Value) {
    fs::write(folder.join(name), pair.to_string()).unwrap();
}

/// Standard output and standard error, in which nothing acts.
fn run(folder: &Path, command: &str, pair: &str) -> (String, String) {
    let words = command
        .split(' ')
        .map(|word| if word == "PAIR" { pair } else { word });
    let words: Vec<&str> = words.collect();
    let (_, printed, told) = super::run(folder, &words);
    harmless(&told, &format!("{command} of {pair:?}"));
    (printed, told)
}

/// 30 titles in 15 commands: no table of numbers has text of the file in it, so none of its cells is a formula.
#[test]
fn hostile_titles() {
    let folder = empty_folder();
    let folder = folder.path();
    let mut first = Vec::new();
    for title in &titles() {
        write(folder, "pair.json", &good(title));
        let mut numbers = Vec::new();
        for (command, kind) in COMMANDS {
            let (text, _) = run(folder, command, "pair.json");
            check(&text, kind, title, &format!("{command} of {title:?}"));
            if kind == Csv {
                numbers.push(text);
            }
        }
        let written = folder.join("written");
        let entries = fs::read_dir(&written).unwrap();
        let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        files.sort();
        for file in files {
            let text = fs::read_to_string(&file).unwrap();
            let kind = match file.extension().unwrap().to_str() {
                Some("svg") => Xml,
                Some("json") => Json,
                Some("csv") => Csv,
                Some("md") => Markdown,
                _ => Text,
            };
            check(&text, kind, title, &format!("{file:?} of {title:?}"));
            if kind == Csv {
                numbers.push(text);
            }
        }
        fs::remove_dir_all(&written).unwrap();
        if first.is_empty() {
            first.clone_from(&numbers);
        }
        assert_eq!(numbers, first, "a title stands in a table");
    }
}

/// A file name is printed on one line and does not act, whether the file can be read or not.
#[cfg(unix)]
#[test]
fn hostile_file_names() {
    for name in [
        "a\n::error::pwned.json",
        "::error::pwned.json",
        "##[error]pwned.json",
        "\u{1b}[31mred\u{7}.json",
        "c1\u{9b}2J.json",
        "\u{202e}nosj.json",
        "-\u{1b}x.json",
    ] {
        let folder = empty_folder();
        let folder = folder.path();
        for (command, kind) in COMMANDS {
            let (printed, told) = run(folder, command, name);
            let what = format!("{command} of {name:?}");
            // A name that looks like an option is a usage error, which clap words.
            let is_option = name.starts_with('-');
            assert!(is_option || told.lines().count() == 1, "{what}: {told}");
            // `check` and `compare` list a file that cannot be read.
            if !command.contains("--format") || !command.starts_with('c') {
                assert_eq!(printed, "", "{what}");
            } else if kind == Commands {
                check(&printed, kind, "x", &what);
            } else {
                harmless(&printed, &what);
            }
            if is_option {
                continue;
            }
            write(folder, name, &good("x"));
            let (printed, _) = run(folder, command, name);
            check(&printed, kind, "x", &what);
            fs::remove_file(folder.join(name)).unwrap();
        }
    }
}

/// Content of a bad file is quoted on one line, escaped: keys, values, cells, headers, sheet names.
#[test]
fn hostile_contents_of_bad_files() {
    let folder = empty_folder();
    let folder = folder.path();
    for hostile in &titles() {
        let table = json!({ "file": "table.csv" });
        let locked = json!({ "center_distance_mm": 37.1, "locked": hostile });
        let mut pitch = gear(20);
        pitch["pitch"] = json!({ "kind": "single", "file": "table.csv" });
        // `#` stands for the text in the table.
        for (key, value, beside) in [
            ("assembly", json!({ hostile.as_str(): 1 }), ""),
            ("assembly", json!({ "center_distance_mm": hostile }), ""),
            ("assembly", locked, ""),
            ("measured", json!({ "file": hostile }), ""),
            ("measured", table.clone(), "#"),
            ("measured", table, "#,center_distance_mm\n#,1\n"),
            ("wheel", pitch.clone(), "tooth,left,right,#\n1,#,1,1\n"),
            ("wheel", pitch, "tooth,left,right\n1,#,1\n"),
        ] {
            let mut pair = good("x");
            pair[key] = value;
            write(folder, "pair.json", &pair);
            fs::write(folder.join("table.csv"), beside.replace('#', hostile)).unwrap();
            let (printed, told) = run(folder, "simulate PAIR --format json", "pair.json");
            assert_eq!(printed, "");
            let is_error = |line: &str| line.starts_with("error: pair.json: ");
            assert!(!told.is_empty() && told.lines().all(is_error), "{told}");
        }
    }
}

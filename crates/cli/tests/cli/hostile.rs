//! Text from files never acts: not on a terminal, not in a CI log, not in a page, a picture or a table.

use super::*;
use std::fs;

/// Titles that act somewhere: on terminals (ECMA-48 controls), on the order of text (UAX #9), in the logs of GitHub, Azure and
/// TeamCity (workflow commands), in XML, HTML, Markdown, spreadsheets and JSON.
const TITLES: [&str; 30] = [
    "x\n::error::pwned",
    "x\r\n::set-output name=a::b",
    "::error::pwned",
    " \t::stop-commands::x",
    "x ##[error]pwned",
    "##vso[task.setvariable variable=a]b",
    "##teamcity[buildStatus status='SUCCESS']",
    "x%0A::error::pwned",
    "x%0D%0A::error file=a::b",
    "\u{1b}[2J\u{1b}[31mred\u{1b}]0;title\u{7}",
    "bell\u{7} back\u{8}\u{8}\u{8}\u{8} form\u{c}feed",
    "nul\u{0}inside",
    "\u{9b}2J C1 \u{90}q\u{9c} \u{9d}0;x\u{9c}",
    "del\u{7f}\u{7f} next\u{85}line",
    "evil\u{202e}lmot.exe\u{202c}",
    "\u{2066}isolate\u{2069} \u{200f}mark \u{61c}x",
    "line\u{2028}separator\u{2029}paragraph",
    "\u{ffff}\u{fffe}\u{fdd0}\u{1ffff}",
    "\u{1}\u{2}\u{3}\u{4}\u{5}\u{6}\u{e}\u{f}\u{10}\u{1f}",
    "]]></system-out><failure/>",
    "</title><script>alert(1)</script>",
    "\"><svg onload=alert(1)>",
    "<!-- --> <!DOCTYPE x> <?xml?>",
    "&#x1b; &lt; &unknown;",
    "=cmd|' /C calc'!A0",
    "| a | b |\n| - | - |",
    "[x](javascript:alert(1)) ![y](http://z)",
    "\\\"}, {\"passed\": true",
    "back\u{8}\r over\rwritten",
    "",
];

/// The commands, each with what it prints.
const COMMANDS: [(&str, Printed); 15] = [
    ("simulate PAIR -o written", Printed::Text),
    ("simulate PAIR --format json", Printed::Json),
    ("simulate PAIR --format csv", Printed::Csv),
    ("compare PAIR", Printed::Text),
    ("compare PAIR --format json", Printed::Json),
    ("compare PAIR --format junit", Printed::Xml),
    ("check PAIR --format github", Printed::Commands),
    ("compare PAIR --format markdown", Printed::Text),
    ("check PAIR", Printed::Text),
    ("check PAIR --format json", Printed::Json),
    ("snapshot PAIR --worst -o -", Printed::Xml),
    ("chart PAIR --kind inspection -o -", Printed::Xml),
    ("gauge PAIR --gear pinion -o written", Printed::Text),
    ("gauge PAIR --gear pinion --format json", Printed::Json),
    ("report PAIR -o -", Printed::Page),
];

#[derive(Clone, Copy, PartialEq)]
enum Printed {
    Text,
    Json,
    Csv,
    Xml,
    Page,
    /// Workflow commands of GitHub.
    Commands,
}

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

fn pair(folder: &Path, title: &str) {
    let gear = |teeth: u32| json!({ "teeth": teeth, "module_mm": 2.0, "pressure_angle_deg": 20.0 });
    let pair = json!({
        "title": title,
        "wheel": gear(20),
        "pinion": gear(17),
        "assembly": { "center_distance_mm": 37.1 },
        "sweep": { "mating": [[1, 1]] },
    });
    fs::write(folder.join("pair.json"), pair.to_string()).unwrap();
}

fn run(folder: &Path, command: &str, pair: &str) -> (String, String) {
    let words = command.split(' ').map(|word| match word {
        "PAIR" => pair,
        word => word,
    });
    let output = gearlash(folder)
        .args(words)
        .env("SOURCE_DATE_EPOCH", "0")
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr))
}

/// 30 titles in 15 commands: nothing acts in what is printed; JSON reads back the very title; XML parses; no table of numbers has
/// text of the file in it, so none of its cells is a formula.
#[test]
fn hostile_titles() {
    let folder = empty_folder();
    let folder = folder.path();
    let mut numbers = Vec::new();
    for title in TITLES {
        pair(folder, title);
        for (command, printed) in COMMANDS {
            let what = format!("{command} of {title:?}");
            let (stdout, stderr) = run(folder, command, "pair.json");
            harmless(&stderr, &what);
            match printed {
                Printed::Commands => {
                    assert!(!stdout.contains(acts), "{what}: {stdout:?}");
                    assert!(stdout.lines().all(is_annotation), "{what}: {stdout}");
                }
                Printed::Page => {
                    assert!(!stdout.contains(acts), "{what}");
                    assert!(!stdout.contains("<script>alert") && !stdout.contains("<svg onload"));
                }
                _ => harmless(&stdout, &what),
            }
            match printed {
                Printed::Json => {
                    let read: Value = serde_json::from_str(&stdout).unwrap();
                    let read = [
                        &read["pair"]["title"],
                        &read["files"][0]["pair"]["title"],
                        &read["title"],
                    ];
                    assert!(read.contains(&&json!(title)), "{what}: {read:?}");
                }
                Printed::Xml => {
                    let parsed = roxmltree::Document::parse(&stdout);
                    parsed.unwrap_or_else(|error| panic!("{what}: {error}\n{stdout}"));
                }
                Printed::Csv => numbers.push(stdout),
                _ => {}
            }
        }
        let written = folder.join("written");
        for name in files(&written) {
            let text = fs::read_to_string(written.join(&name)).unwrap();
            let what = format!("{name} of {title:?}");
            match Path::new(&name)
                .extension()
                .and_then(|ending| ending.to_str())
            {
                Some("svg") => {
                    harmless(&text, &what);
                    roxmltree::Document::parse(&text).unwrap();
                }
                Some("json") => {
                    let read: Value = serde_json::from_str(&text).unwrap();
                    assert_eq!(read["pair"]["title"], title);
                    harmless(&text, &what);
                }
                Some("csv") => numbers.push(text),
                Some("md") => {
                    harmless(&text, &what);
                    let rows = text.lines().filter(|line| line.starts_with('|'));
                    assert_eq!(rows.count(), 3, "{what}: {text}");
                    assert!(
                        !text.replace(r"\]", "").contains("](") && !text.contains("<!--"),
                        "{text}"
                    );
                }
                _ => harmless(&text, &what),
            }
        }
        fs::remove_dir_all(&written).unwrap();
    }
    let each = numbers.len() / TITLES.len();
    for tables in numbers.chunks(each) {
        assert_eq!(tables, &numbers[..each], "a title stands in a table");
    }
}

/// Whether a line of a CI log is an annotation of the program's own.
fn is_annotation(line: &str) -> bool {
    line.starts_with("::error file=") || line.starts_with("::warning file=")
}

/// A file name is printed on one line and does not act, whether the file can be read or not.
#[cfg(unix)]
#[test]
fn hostile_file_names() {
    let names = [
        "a\n::error::pwned.json",
        "::error::pwned.json",
        "##[error]pwned.json",
        "\u{1b}[31mred\u{7}.json",
        "c1\u{9b}2J.json",
        "\u{202e}nosj.json",
        "-\u{1b}x.json",
    ];
    for name in names {
        let folder = empty_folder();
        let folder = folder.path();
        for (command, printed) in COMMANDS {
            let (stdout, stderr) = run(folder, command, name);
            let what = format!("{command} of no {name:?}: {stderr}");
            harmless(&stderr, &what);
            // `check` and `compare` list a file that cannot be read.
            match printed {
                _ if !command.contains("--format") || !command.starts_with('c') => {
                    assert_eq!(stdout, "", "{what}");
                }
                Printed::Commands => assert!(stdout.lines().all(is_annotation), "{stdout}"),
                _ => harmless(&stdout, &what),
            }
            // A name that looks like an option is a usage error, which clap words.
            let is_option = name.starts_with('-');
            assert!(is_option || stderr.lines().count() == 1, "{what}");
            if is_option {
                continue;
            }
            pair(folder, "x");
            fs::rename(folder.join("pair.json"), folder.join(name)).unwrap();
            let (stdout, stderr) = run(folder, command, name);
            let what = format!("{command} of {name:?}: {stderr}");
            harmless(&stderr, &what);
            match printed {
                Printed::Commands => assert!(stdout.lines().all(is_annotation), "{stdout}"),
                Printed::Page => assert!(!stdout.contains(acts), "{what}"),
                _ => harmless(&stdout, &what),
            }
            fs::remove_file(folder.join(name)).unwrap();
        }
    }
}

/// Content of a bad file is quoted on one line, escaped: keys, values, cells, headers, sheet names.
#[test]
fn hostile_contents_of_bad_files() {
    for hostile in TITLES {
        let folder = empty_folder();
        let folder = folder.path();
        let mut faults = 0;
        let mut bad = |pair: Value, beside: &str| {
            fs::write(folder.join("pair.json"), pair.to_string()).unwrap();
            fs::write(folder.join("table.csv"), beside).unwrap();
            let (stdout, stderr) = run(folder, "simulate PAIR --format json", "pair.json");
            harmless(&stderr, &stderr);
            assert_eq!(stdout, "");
            assert!(
                stderr
                    .lines()
                    .all(|line| line.starts_with("error: pair.json: ")),
                "{stderr}"
            );
            faults += 1;
        };
        let gear =
            |teeth: u32| json!({ "teeth": teeth, "module_mm": 2.0, "pressure_angle_deg": 20.0 });
        let good = json!({ "wheel": gear(20), "pinion": gear(17), "assembly": { "center_distance_mm": 37.1 } });
        let with = |key: &str, value: Value| {
            let mut pair = good.clone();
            pair[key] = value;
            pair
        };
        bad(with("assembly", json!({ hostile: 1 })), "");
        bad(
            with("assembly", json!({ "center_distance_mm": hostile })),
            "",
        );
        bad(
            with(
                "assembly",
                json!({ "center_distance_mm": 37.1, "locked": hostile }),
            ),
            "",
        );
        bad(with("measured", json!({ "file": hostile })), "");
        let table = json!({ "file": "table.csv" });
        bad(with("measured", table.clone()), hostile);
        bad(
            with("measured", table.clone()),
            &format!("{hostile},center_distance_mm\n{hostile},1\n"),
        );
        let mut wheel = gear(20);
        wheel["pitch"] = json!({ "kind": "single", "file": "table.csv" });
        bad(
            with("wheel", wheel.clone()),
            &format!("tooth,left,right,{hostile}\n1,{hostile},1,1\n"),
        );
        bad(
            with("wheel", wheel),
            &format!("tooth,left,right\n1,{hostile},1\n"),
        );
        assert_eq!(faults, 8);
    }
}

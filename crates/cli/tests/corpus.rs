//! The corpus: the built program over the cases of `tests/corpus/`, compared with the output stored there.
//!
//! `GEARLASH_CORPUS=write` stores today's output; a number, such as `GEARLASH_CORPUS=1e-9`, compares numbers within it.
//! `GEARLASH_CORPUS_CASES=helical` runs the cases whose name contains the word. `tests/corpus/README.md` says more.

use data_encoding::HEXLOWER;
use rayon::prelude::*;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// A list or a text longer than its limit is stored by its first and last element and by every 37th between, or by five.
const STEP: usize = 37;
/// Lists that are stored whole up to `LONG_LIST` elements.
const WHOLE: [&str; 4] = ["checks", "each", "pairs", "runs"];
const LONG_LIST: usize = 60;
const LIST: usize = 12;
const TEXT_LINES: usize = 40;
/// Characters that are stored of a line of text.
const LINE: usize = 1000;
/// Keys whose values every command repeats: they are stored of `check`.
const REPEATED: [&str; 2] = ["pair", "extremes"];
/// Differences that are shown of one case.
const SHOWN: usize = 8;

struct Case {
    name: String,
    args: Vec<String>,
}

/// How stored and actual output are compared.
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Write,
    /// Text must be equal; numbers may differ by this much of the greater one, or of 1 where both are less.
    Within(f64),
}

fn root() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).to_owned()
}

/// Other platforms have other sines and cosines, which move the last digits.
fn mode() -> Mode {
    match env::var("GEARLASH_CORPUS").ok().as_deref() {
        Some("write") => Mode::Write,
        Some(number) => Mode::Within(number.parse().expect("`write` or a number")),
        None if cfg!(all(target_os = "linux", target_arch = "x86_64")) => Mode::Within(0.0),
        None => Mode::Within(1e-9),
    }
}

/// The command line of one word of a pair's line.
fn arguments(word: &str, file: &str) -> String {
    match word {
        "csv" => format!("-q simulate {file} --format csv"),
        "check" => format!("check {file} --format json"),
        "gauge-csv" => format!("-q gauge {file} --format csv"),
        "dxf" | "svg" | "outline" => {
            let format = word.replace("outline", "csv");
            format!("-q outline {file} --gear wheel --format {format} -o -")
        }
        "tolerance-csv" => format!("-q tolerance {file} --format csv"),
        command => format!("-q {command} {file} --format json"),
    }
}

fn cases() -> Vec<Case> {
    let corpus = root().join("tests/corpus");
    let list = fs::read_to_string(corpus.join("cases.txt")).unwrap();
    let mut cases = Vec::new();
    let mut add = |name: String, line: &str| {
        let args = line.split_whitespace().map(str::to_owned).collect();
        cases.push(Case { name, args });
    };
    for line in list.lines().filter(|line| !line.starts_with('#')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            [] => {}
            ["pair", file, ref commands @ ..] => {
                let stem = Path::new(file).file_stem().unwrap().to_str().unwrap();
                for word in commands {
                    add(format!("{stem}.{word}"), &arguments(word, file));
                }
            }
            ["run", name, ref rest @ ..] => add(name.to_owned(), &rest.join(" ")),
            _ => panic!("cases.txt: {line:?}: a line begins with `pair`, `run` or `#`"),
        }
    }
    for entry in fs::read_dir(corpus.join("bad")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if !name.ends_with(".csv") {
            let words = format!("check tests/corpus/bad/{name}");
            add(format!("bad/{name}"), &words);
        }
    }
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    let only = env::var("GEARLASH_CORPUS_CASES").unwrap_or_default();
    cases.retain(|case| case.name.contains(&only));
    for pair in cases.windows(2) {
        assert_ne!(pair[0].name, pair[1].name, "two cases of one name");
    }
    cases
}

fn kept(index: usize, count: usize, limit: usize) -> bool {
    count <= limit || index + 1 == count || index.is_multiple_of(STEP.max(count / 6))
}

/// One line for each value: its path and its text. Keys of `skipped` are left out.
fn flatten(value: &Value, path: &str, skipped: &[&str], out: &mut String) {
    match value {
        Value::Object(map) if !map.is_empty() => {
            let kept = map
                .iter()
                .filter(|(key, _)| !skipped.contains(&key.as_str()));
            for (key, value) in kept {
                let dot = if path.is_empty() { "" } else { "." };
                flatten(value, &format!("{path}{dot}{key}"), skipped, out);
            }
        }
        Value::Array(list) if !list.is_empty() => {
            let name = path.rsplit('.').next().unwrap();
            let is_whole = WHOLE.contains(&name);
            let limit = if is_whole { LONG_LIST } else { LIST };
            let mut seen = BTreeMap::new();
            for (index, value) in list.iter().enumerate() {
                // Checks go by their id, so that a new one does not renumber the others.
                let label = match (value["id"].as_str(), value["gear"].as_str()) {
                    (Some(id), gear) => {
                        let id = [id, gear.unwrap_or("")].join(" ").trim_end().to_owned();
                        let count = seen.entry(id.clone()).or_insert(0);
                        *count += 1;
                        format!("{id} {count}")
                    }
                    _ => index.to_string(),
                };
                if kept(index, list.len(), limit) {
                    flatten(value, &format!("{path}[{label}]"), skipped, out);
                }
            }
        }
        scalar => writeln!(out, "{path} = {scalar}").unwrap(),
    }
}

/// The output of one case in the form in which it is stored.
fn output(case: &Case) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gearlash"));
    command.current_dir(root()).env("RAYON_NUM_THREADS", "1");
    let found = command.args(&case.args).output().unwrap();
    let text = String::from_utf8(found.stdout).expect(&case.name);
    let warnings = String::from_utf8(found.stderr).expect(&case.name);
    let mut out = format!("# gearlash {}\n", case.args.join(" "));
    writeln!(out, "exit = {}", found.status.code().expect(&case.name)).unwrap();
    let hash = HEXLOWER.encode(&Sha256::digest(&text));
    writeln!(out, "sha256 = {hash}").unwrap();
    for (index, line) in warnings.lines().enumerate() {
        writeln!(out, "stderr {} = {line}", index + 1).unwrap();
    }
    let has = |word: &str| case.args.iter().any(|arg| arg == word);
    if let (true, Ok(json)) = (has("json"), serde_json::from_str::<Value>(&text)) {
        let repeats = has("simulate") || has("compare");
        let skipped = if repeats { &REPEATED[..] } else { &[] };
        // A list of one file is stored as that file.
        let only = json.get("files").and_then(Value::as_array);
        let only = only.filter(|files| files.len() == 1).map(|files| &files[0]);
        flatten(only.unwrap_or(&json), "", skipped, &mut out);
    } else {
        let count = text.lines().count();
        let lines = text.lines().enumerate();
        for (index, line) in lines.filter(|(index, _)| kept(*index, count, TEXT_LINES)) {
            let stored: String = line.chars().take(LINE).collect();
            writeln!(out, "line {} = {stored}", index + 1).unwrap();
        }
    }
    out
}

/// A text cut into numbers and what stands between them.
fn tokens(text: &str) -> Vec<Result<f64, &str>> {
    let of_number = |c: char| c.is_ascii_digit() || ".+-eE".contains(c);
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let inside = of_number(first);
        let end = rest.find(|c| of_number(c) != inside).unwrap_or(rest.len());
        let (token, after) = rest.split_at(end);
        tokens.push(token.parse().map_err(|_| token));
        rest = after;
    }
    tokens
}

/// The largest difference between the numbers of two texts, of the greater one or of 1; none where the texts differ otherwise.
fn difference(stored: &str, actual: &str) -> Option<f64> {
    if stored == actual {
        return Some(0.0);
    }
    let (stored, actual) = (tokens(stored), tokens(actual));
    let mut largest = 0.0_f64;
    for (stored, actual) in stored.iter().zip(&actual) {
        match (stored, actual) {
            (Ok(a), Ok(b)) => largest = largest.max((a - b).abs() / a.abs().max(b.abs()).max(1.0)),
            (Err(a), Err(b)) if a == b => {}
            _ => return None,
        }
    }
    (stored.len() == actual.len()).then_some(largest)
}

fn by_path(text: &str) -> BTreeMap<&str, &str> {
    text.lines()
        .filter_map(|line| line.split_once(" = "))
        .collect()
}

/// The differences beyond `tolerance`, a line each, and the largest difference of numbers with its path.
fn compare(stored: &str, actual: &str, tolerance: f64) -> (Vec<String>, f64, String) {
    let (old, new) = (by_path(stored), by_path(actual));
    let (mut lines, mut largest, mut place) = (Vec::new(), 0.0, String::new());
    for (path, old) in &old {
        let Some(new) = new.get(path) else {
            lines.push(format!("- {path} = {old}"));
            continue;
        };
        if *path == "sha256" {
            continue;
        }
        let by = difference(old, new);
        if let Some(by) = by.filter(|by| *by > largest) {
            (largest, place) = (by, (*path).to_owned());
        }
        if old != new && by.is_none_or(|by| tolerance == 0.0 || by > tolerance) {
            lines.push(format!("~ {path} = {old} → {new}"));
        }
    }
    let added = new.iter().filter(|(path, _)| !old.contains_key(*path));
    lines.extend(added.map(|(path, new)| format!("+ {path} = {new}")));
    if lines.is_empty() && tolerance == 0.0 && stored != actual {
        lines.push("~ values that are not stored here, their order or their form".to_owned());
    }
    (lines, largest, place)
}

fn stored_file(name: &str) -> PathBuf {
    let expected = root().join("tests/corpus/expected");
    expected.join(format!("{name}.txt"))
}

#[test]
fn every_command_writes_what_is_stored() {
    let (mode, cases) = (mode(), cases());
    let work = |case: &Case| {
        let file = stored_file(&case.name);
        let actual = output(case);
        match mode {
            Mode::Write => {
                fs::write(file, actual).unwrap();
                None
            }
            Mode::Within(tolerance) => {
                let stored = fs::read_to_string(file).unwrap_or_default();
                Some((case.name.clone(), compare(&stored, &actual, tolerance)))
            }
        }
    };
    let mut found: Vec<_> = cases.par_iter().filter_map(work).collect();
    if let Some((name, (_, by, place))) = found.iter().max_by(|a, b| a.1.1.total_cmp(&b.1.1)) {
        println!("largest difference of a number: {by:e} in {name}, {place}");
    }
    let mut report = String::new();
    found.retain(|(_, (lines, ..))| !lines.is_empty());
    for (name, (lines, ..)) in found.iter().take(40) {
        writeln!(report, "{name}: {} differences", lines.len()).unwrap();
        for line in lines.iter().take(SHOWN) {
            writeln!(report, "  {line}").unwrap();
        }
    }
    let (differ, all) = (found.len(), cases.len());
    let summary = format!("{report}{differ} of {all} cases differ; see tests/corpus/README.md");
    assert!(differ == 0, "{summary}");
}

/// No stored output is left of a case that went away.
#[test]
fn every_stored_output_has_its_case() {
    let names: Vec<PathBuf> = cases().iter().map(|case| stored_file(&case.name)).collect();
    if env::var_os("GEARLASH_CORPUS_CASES").is_some() {
        return;
    }
    let expected = root().join("tests/corpus/expected");
    for folder in [expected.join("bad"), expected] {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() && !names.contains(&path) {
                assert!(mode() == Mode::Write, "{}: no case", path.display());
                fs::remove_file(path).unwrap();
            }
        }
    }
}

#[test]
fn a_changed_number_is_seen_and_measured() {
    let stored = "exit = 0\nj_wt_um = 23.18\ntext = \"least 23.18 µm\"\n";
    let moved = stored.replace("23.18", "23.180001");
    assert_eq!(compare(stored, &moved, 0.0).0.len(), 2);
    let (lines, largest, _) = compare(stored, &moved, 1e-6);
    assert!(lines.is_empty() && (largest - 1e-6 / 23.180001).abs() < 1e-12);
    assert_eq!(compare(stored, &moved, 1e-9).0.len(), 2);
    let reworded = stored.replace("least", "lowest");
    assert_eq!(compare(stored, &reworded, 1.0).0.len(), 1);
    assert_eq!(compare(stored, "exit = 0\n", 1.0).0.len(), 2);
}

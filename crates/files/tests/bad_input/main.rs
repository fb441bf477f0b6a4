//! Bad pair files, case by case: each gets a message with key, value, what is allowed and what to do.
//!
//! Ranges are those of the pair file's documentation; diameters were computed apart from the
//! program (involute function of 20°, solved by bisection).

mod deviations;
mod file;
mod keys;
mod measured;
mod numbers;
mod pair;
mod profile;
mod sweep;
mod teeth;
mod thickness;
mod types;

use gearlash_files::read;
use gearlash_files::{InputError, Problem};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

const GOOD: &str = r#"
[wheel]
teeth = 20
module_mm = 3.0
pressure_angle_deg = 20.0

[pinion]
teeth = 30
module_mm = 3.0
pressure_angle_deg = 20.0

[assembly]
center_distance_mm = 75.2
"#;

const ROWS: &str = "center_distance_mm,wheel_tooth,pinion_tooth,measured_right_um,\
measured_left_um,predicted_min_um,predicted_max_um,source\n75.2,1,1,150,155,140,160,rig\n";

/// `text` with `from`, which stands there once, replaced by `to`.
fn put(text: &str, from: &str, to: &str) -> String {
    assert_eq!(text.matches(from).count(), 1, "{from:?} in {text}");
    text.replace(from, to)
}

/// The good file with `keys` added to `[wheel]`.
fn wheel(keys: &str) -> String {
    put(GOOD, "teeth = 20\n", &format!("teeth = 20\n{keys}\n"))
}

/// The good file with `tables` added below.
fn and(tables: &str) -> String {
    format!("{GOOD}\n{tables}\n")
}

/// A list of `count` values.
fn list(count: usize, value: &str) -> String {
    format!("[{}]", vec![value; count].join(", "))
}

/// What is expected of one problem: its key, and words of value, reason and way out.
struct Expected<'a> {
    key: &'a str,
    value: &'a str,
    reason: &'a [&'a str],
    help: &'a str,
}

fn problem<'a>(key: &'a str, value: &'a str, reason: &'a [&'a str], help: &'a str) -> Expected<'a> {
    Expected {
        key,
        value,
        reason,
        help,
    }
}

fn problems_of(path: &Path) -> Vec<Problem> {
    match read(path) {
        Ok(_) => Vec::new(),
        Err(InputError { file, problems, .. }) => {
            assert_eq!(file, path);
            assert!(!problems.is_empty());
            problems
        }
    }
}

/// Reads `text` as `name` and expects exactly these problems; those of one key in their order.
fn expect_as(name: &str, text: &str, expected: &[Expected]) {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("rows.csv"), ROWS).unwrap();
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    check(&problems_of(&path), expected);
}

fn check(problems: &[Problem], expected: &[Expected]) {
    let all: Vec<String> = problems.iter().map(Problem::to_string).collect();
    assert_eq!(problems.len(), expected.len(), "{all:#?}");
    let mut problems: Vec<&Problem> = problems.iter().collect();
    problems.sort_by_key(|problem| problem.key.clone());
    let mut expected: Vec<&Expected> = expected.iter().collect();
    expected.sort_by_key(|expected| expected.key);
    for (problem, expected) in problems.into_iter().zip(expected) {
        assert_eq!(problem.key, expected.key, "{problem}");
        let value = problem.value.as_deref().unwrap_or("");
        assert!(value.contains(expected.value), "{problem}");
        for words in expected.reason {
            assert!(problem.reason.contains(words), "{words:?} in {problem}");
        }
        assert!(problem.help.contains(expected.help), "{problem}");
        let message = problem.to_string();
        for part in [&problem.key, value, &problem.reason, &problem.help] {
            assert!(message.contains(part), "{part:?} in {message}");
        }
    }
}

fn expect(text: &str, expected: &[Expected]) {
    expect_as("pair.toml", text, expected);
}

#[test]
fn the_file_they_are_made_of_is_good() {
    expect(GOOD, &[]);
}

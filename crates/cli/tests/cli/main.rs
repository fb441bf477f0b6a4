//! The built binary, as a user and as a script runs it.

#[cfg(unix)]
mod bombs;
mod docs;
mod hostile;
mod outline;
#[path = "../../../../tests/common/pair_with_table.rs"]
mod pair_with_table;
mod reference;
mod remedies;
mod results;
mod schema;
mod tolerance;

use assert_cmd::Command;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

fn gearlash(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder);
    command
}

fn fixture(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("fixtures")
        .join(name)
}

fn output(command: &mut Command) -> String {
    String::from_utf8(command.assert().success().get_output().stdout.clone()).unwrap()
}

/// The output of `simulate` with these further arguments, as JSON.
fn simulated(folder: &Path, arguments: &[&str]) -> Value {
    let mut command = gearlash(folder);
    command.arg("simulate").args(arguments);
    let text = output(command.args(["--format", "json"]));
    serde_json::from_str(&text).unwrap()
}

/// The JSON that a command of words separated by blanks prints, whatever its verdict.
fn json_of(folder: &Path, words: &str) -> Value {
    let words: Vec<&str> = words.split(' ').chain(["--format", "json"]).collect();
    let (_, text, message) = run(folder, &words);
    serde_json::from_str(&text).unwrap_or_else(|_| panic!("{words:?}: {message}"))
}

/// Asserts that two values in µm agree within `most`.
fn assert_near(found: &Value, expected: &Value, most: f64, what: &str) {
    let [one, other] = [found, expected].map(|value| value.as_f64().unwrap());
    assert!((one - other).abs() < most, "{what}: {one} {other}");
}

/// Runs with these arguments: exit code, standard output, standard error.
fn run(folder: &Path, args: &[&str]) -> (Option<i32>, String, String) {
    let output = gearlash(folder).args(args).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

fn empty_folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

fn files(folder: &Path) -> Vec<String> {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

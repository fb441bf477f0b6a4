//! Tables as shops write them, the whole way: the file beside a pair file, `gearlash check`, and `gearlash import` with its lines pasted.
//!
//! Each is read at the first run, or its one message names the key that makes the second succeed. Expected values are those the test
//! wrote into the table, listed in a pair file.

mod books;
mod command;
#[path = "../../../../tests/common/pair_with_table.rs"]
mod pair_with_table;
mod texts;

use assert_cmd::Command;
use pair_with_table::pair;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

const TEETH: u32 = 17;

/// Cumulative pitch of a flank, µm, in tenths.
fn cumulative(flank: u32) -> Vec<f64> {
    let tooth = |tooth: u32| (f64::from((tooth * (6 + flank)) % 31) - 15.0) / 10.0;
    (1..=TEETH).map(tooth).collect()
}

/// Single pitch of the same, rounded to tenths as a sheet prints it.
fn single(flank: u32) -> Vec<f64> {
    let values = cumulative(flank);
    let before = values.iter().cycle().skip(values.len() - 1);
    let steps = values.iter().zip(before);
    steps
        .map(|(now, before)| ((now - before) * 10.0).round() / 10.0)
        .collect()
}

const LEFT: u32 = 0;
const RIGHT: u32 = 1;

/// The lists that a pair file would have.
fn listed(kind: &str) -> String {
    let of = match kind {
        "single" => single,
        _ => cumulative,
    };
    format!(
        "pitch = {{ kind = {kind:?}, left_um = {:?}, right_um = {:?} }}",
        of(LEFT),
        of(RIGHT)
    )
}

fn gearlash(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder);
    command
}

/// The lines of `import` that are in comments for want of a key, with the line `added` in its place.
fn completed(toml: &str, added: &str) -> String {
    let (_, lines) = toml.split_once("remove their #:\n").unwrap();
    let lines = lines.lines().map(|line| line.strip_prefix("# ").unwrap());
    let completed = lines.map(|line| if line.contains("= …") { added } else { line });
    completed.collect::<Vec<_>>().join("\n")
}

/// A table in a folder of its own.
struct Shop {
    folder: TempDir,
    name: &'static str,
}

impl Shop {
    fn new(name: &'static str, bytes: impl AsRef<[u8]>) -> Shop {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join(name), bytes).unwrap();
        Shop { folder, name }
    }

    /// The findings of `check` for the pair with `keys` in the wheel's table and `below` after the other tables, and its warnings
    /// on the files; else the errors.
    fn check(&self, keys: &str, below: &str) -> Result<(Value, String), String> {
        let text = pair(TEETH, keys) + below;
        fs::write(self.folder.path().join("pair.toml"), text).unwrap();
        let mut command = gearlash(self.folder.path());
        let output = command
            .args(["check", "pair.toml", "--format", "json", "--verbose"])
            .output()
            .unwrap();
        let told = String::from_utf8(output.stderr).unwrap();
        match output.status.code() {
            Some(0 | 1) => {
                let mut found: Value = serde_json::from_slice(&output.stdout).unwrap();
                // They name the file.
                for key in ["warnings", "remarks"] {
                    found["files"][0].as_object_mut().unwrap().remove(key);
                }
                Ok((found, told))
            }
            _ => Err(told),
        }
    }

    /// The one message of a run that fails.
    fn refused(&self, keys: &str) -> String {
        let told = self.check(keys, "").unwrap_err();
        assert_eq!(told.matches("error: ").count(), 1, "{told}");
        told
    }

    /// Checks that the table gives what `expected` lists, and that what `import` prints with `options`, pasted, gives the same; what
    /// was reported of the table.
    fn is(&self, keys: &str, expected: &str, options: &[&str], added: &str) -> String {
        let (found, told) = self.check(keys, "").unwrap_or_else(|told| panic!("{told}"));
        let (listed, _) = self.check(expected, "").unwrap();
        assert!(found == listed, "{keys}");
        let toml = self.import(options)["toml"].as_str().unwrap().to_owned();
        let pasted = if added.is_empty() {
            toml.clone()
        } else {
            completed(&toml, added)
        };
        let (pasted, _) = self
            .check("", &pasted)
            .unwrap_or_else(|told| panic!("{toml}{told}"));
        assert!(pasted == listed, "{toml}");
        told
    }

    /// The output of `import --format json`.
    fn import(&self, options: &[&str]) -> Value {
        let mut command = gearlash(self.folder.path());
        command
            .args(["import", self.name, "--format", "json"])
            .args(options);
        let output = command.assert().success().get_output().stdout.clone();
        serde_json::from_slice(&output).unwrap()
    }
}

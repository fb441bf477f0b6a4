//! The built binary, as a user and as a script runs it.

#[cfg(unix)]
mod action;
#[cfg(unix)]
mod bombs;
mod docs;
mod hostile;
mod large;
mod leaks;
mod live_page;
mod matching;
mod matching_warnings;
mod outline;
#[path = "../../../../tests/common/pair_with_table.rs"]
mod pair_with_table;
mod pictures;
mod reference;
mod remedies;
mod rexs;
mod schema;
mod schema_init;
mod simulate;
#[path = "../../../../tests/common/skip.rs"]
mod skip;
mod small;
#[cfg(target_os = "linux")]
mod terminal;
mod tolerance;
mod tolerance_earlier;
mod tolerance_helical;
mod tolerance_rows;
mod units;
mod verdict;

use assert_cmd::Command;
use predicates::prelude::*;
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

/// A small pair that runs in no time: eccentric wheel, shifted pinion, two materials, two centre distances.
const SMALL: &str = r#"
title = "small"
[wheel]
teeth = 20
module_mm = 2.0
pressure_angle_deg = 20.0
[wheel.thickness]
allowance_um = { min = -60.0, max = -40.0 }
[wheel.runout]
total_um = 12.0
high_tooth = 3.5
[pinion]
teeth = 17
module_mm = 2.0
pressure_angle_deg = 20.0
profile_shift = 0.1
reference_face = "back"
[assembly]
center_distance_mm = [37.3, 37.35]
bearing_clearance_mm = 0.004
[sweep]
mating = [[1, 1], [7, 12]]
fraction = [0.0, 0.5]
"#;

fn small(folder: &Path) -> PathBuf {
    let file = folder.join("small.toml");
    std::fs::write(&file, SMALL).unwrap();
    file
}

/// The output of `simulate FILE --format json`, as text and parsed.
fn simulated(folder: &Path, arguments: &[&str]) -> (String, Value) {
    let text = output(
        gearlash(folder)
            .arg("simulate")
            .args(arguments)
            .args(["--format", "json"]),
    );
    let result = serde_json::from_str(&text).unwrap();
    (text, result)
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

#[test]
fn help_names_every_command_and_the_exit_codes() {
    let folder = empty_folder();
    let help = output(gearlash(folder.path()).arg("--help"));
    let commands = [
        "simulate", "compare", "check", "snapshot", "gauge", "outline", "chart", "report", "init",
        "schema",
    ];
    for word in commands.into_iter().chain(["Exit codes", "Example"]) {
        assert!(help.contains(word), "{word} in {help}");
    }
    for command in commands {
        let help = output(gearlash(folder.path()).args([command, "--help"]));
        assert!(help.to_lowercase().contains("pair file"), "{help}");
        // The long help, with its second paragraph, was lost behind the list's one line.
        let long = help.split("Usage:").next().unwrap().trim();
        assert!(long.contains("\n\n"), "{help}");
        let page = output(gearlash(folder.path()).args(["man", command]));
        assert!(
            page.contains(&format!("gearlash\\-{command} \\-")),
            "{page}"
        );
    }
}

/// Both are made from the command line's own definition: every command and its options are there.
#[cfg(unix)]
#[test]
fn completions_are_a_script_that_knows_every_option() {
    let folder = empty_folder();
    let script = output(gearlash(folder.path()).args(["completions", "bash"]));
    assert!(script.contains("--steps-per-pitch") && script.contains("--no-certify"));
    let file = folder.path().join("gearlash.bash");
    std::fs::write(&file, script).unwrap();
    // bash itself reads it and completes `gearlash sim`.
    let completed = "source gearlash.bash; COMP_WORDS=(gearlash sim); COMP_CWORD=1; \
                     _gearlash gearlash sim gearlash; echo \"${COMPREPLY[@]}\"";
    let mut bash = Command::new("bash");
    let bash = bash.current_dir(folder.path()).args(["-c", completed]);
    assert_eq!(output(bash), "simulate\n");
}

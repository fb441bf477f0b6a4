//! The built binary, as a user and as a script runs it.

#[cfg(unix)]
mod bombs;
mod docs;
mod hostile;
mod outline;
#[path = "../../../../tests/common/pair_with_table.rs"]
mod pair_with_table;
mod reference;
mod results;
mod schema;

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

/// Runs with these arguments: exit code, standard output, standard error.
fn run(folder: &Path, args: &[&str]) -> (Option<i32>, String, String) {
    let output = gearlash(folder).args(args).output().unwrap();
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    let [out, errors] = text;
    (output.status.code(), out, errors)
}

fn empty_folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

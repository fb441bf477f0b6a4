//! The virtual gauge, `gearlash gauge`. `tests/sessions/gauge*.txt` holds what it prints, refuses and writes.

#[path = "../../../../tests/common/made_up.rs"]
mod made_up;
mod readings;
mod round_trip;

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

/// The output of `gearlash` in `folder`; blanks separate its arguments.
fn printed(folder: &Path, words: &str) -> String {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder).args(words.split(' '));
    String::from_utf8(command.assert().success().get_output().stdout.clone()).unwrap()
}

/// The readings of `gearlash gauge` with these words.
fn read(folder: &Path, words: &str) -> Value {
    let text = printed(folder, &format!("gauge {words} --format json"));
    serde_json::from_str(&text).unwrap()
}

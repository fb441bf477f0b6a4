//! `gearlash report`: a page that parsers accept, that says what it should, of bounded size.

mod page;
mod size;

use assert_cmd::Command;
use std::path::Path;

/// A small pair with every kind of deviation, two materials and bearing clearance; its title is to be escaped.
const SMALL: &str = include_str!("small.toml");

/// The page of the pair file `text`, made with `arguments`.
fn page(text: &str, arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    std::fs::write(&file, text).unwrap();
    page_of(&file, arguments)
}

/// The page of a pair file.
fn page_of(file: &Path, arguments: &[&str]) -> String {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    // 14 November 2023 in UTC, by GNU date.
    command.env("SOURCE_DATE_EPOCH", "1700000000");
    command.arg("report").arg(file).args(["-o", "-"]);
    let output = command.args(arguments).assert().success();
    String::from_utf8(output.get_output().stdout.clone()).unwrap()
}

//! Good tables: the study of the same numbers written inline.

use super::*;
use oracle::{column, delimited, protocol};

fn fixture(name: &str) -> Vec<u8> {
    fs::read(format!("../../fixtures/sheets/{name}")).unwrap()
}

const FLANKS: [[&str; 2]; 2] = [["right", "rechts"], ["left", "links"]];

/// The pair of the made sheets with their wheel's pitch as the tests' own reading has it.
fn inline(kind: &str, right: &[f64], left: &[f64]) -> PairFile {
    let keys = format!("pitch = {{ kind = \"{kind}\", right_um = {right:?}, left_um = {left:?} }}");
    super::good("unused", b"", &pair(44, &keys))
}

fn from_file(name: &str, table: &[u8], kind: &str) -> PairFile {
    let keys = format!("pitch = {{ kind = \"{kind}\", file = \"{name}\" }}");
    super::good(name, table, &pair(44, &keys))
}

#[test]
fn pitch_of_every_layout_is_that_of_the_lists() {
    let rows = delimited(&fixture("pitch.csv"), 44, &FLANKS).unwrap();
    let expected = inline("cumulative", &column(&rows, 0), &column(&rows, 1));
    for name in "pitch.csv pitch_german.csv pitch.xlsx protocol.txt".split(' ') {
        let found = from_file(name, &fixture(name), "cumulative");
        assert!(is_same(&found, &expected), "{name}");
    }
    let [left, right] = protocol(&fixture("protocol.txt"), 44, 1).unwrap();
    let expected = inline("single", &column(&right, 0), &column(&left, 0));
    let found = from_file("protocol.txt", &fixture("protocol.txt"), "single");
    assert!(is_same(&found, &expected));
}

/// The pair of the fixtures: its echo, without any file, gives the same study.
#[test]
fn the_echo_of_tables_read_back_gives_the_same_study() {
    let study = read_pair(Path::new("../../fixtures/sheets/inspected_44x44.toml")).unwrap();
    assert_eq!(study.warnings.len(), 2, "{:#?}", study.warnings);
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("inspected_44x44.json");
    fs::write(&path, echo(&study).to_string()).unwrap();
    let mut again = read_pair(&path).unwrap();
    again.warnings.clone_from(&study.warnings);
    assert!(is_same(&again, &study));
}

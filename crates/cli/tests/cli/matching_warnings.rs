//! Warnings of the gear files of `gearlash match`, and names of gears. `tests/sessions/matching.txt` holds what is refused.

use super::matching::{MATCH, gear, matched, pair};
use super::*;
use std::fs;

/// A gear file name becomes a cell: it acts on no terminal, log or spreadsheet.
#[cfg(unix)]
#[test]
fn names_of_gears_act_on_no_terminal_log_or_spreadsheet() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for name in ["=1+1.toml", "::error::x.toml", "\u{1b}[31mred.toml"] {
        gear(&here.join("w"), name, 40.0, 0.0);
    }
    gear(&here.join("p"), "@p.toml", 40.0, 0.0);
    pair(here, "");
    // Two wheels are left over, which have no mate: exit 0.
    matched(here).success();
    let matrix = fs::read_to_string(here.join("out/matrix.csv")).unwrap();
    let words = MATCH.split(' ').chain(["--format", "csv"]);
    let printed = gearlash(here).args(words).output().unwrap();
    assert_eq!(printed.stdout, matrix.as_bytes());
    let cells: Vec<&str> = matrix.lines().skip(1).collect();
    assert!(cells[0].starts_with(" [31mred,'@p,"), "{matrix}");
    assert!(cells[1].starts_with(": :error::x,'@p,"), "{matrix}");
    assert!(cells[2].starts_with("'=1+1,'@p,"), "{matrix}");
}

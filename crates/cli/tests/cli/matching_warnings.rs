//! Warnings of the gear files of `gearlash match`, and names of gears. `tests/sessions/matching.txt` holds what is refused.

use super::matching::{MATCH, gear, matched, pair};
use super::*;
use std::fs;

/// Warnings of the gears' own files, as `gauge` prints them, one line for equal ones: single pitches that do not close.
#[test]
fn warnings_of_the_gear_files_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let values = format!("[9{}]", ", 0".repeat(43));
    let text = format!(
        "[gear]\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\n\
         pitch = {{ kind = \"single\", right_um = {values}, left_um = {values} }}\n"
    );
    for (kind, names) in [("w", ["1.toml", "2.toml"]), ("p", ["1.toml", "2.toml"])] {
        fs::create_dir_all(here.join(kind)).unwrap();
        for name in names {
            fs::write(here.join(kind).join(name), &text).unwrap();
        }
    }
    pair(here, "");
    let alone = gearlash(here)
        .args(["gauge", "w/1.toml", "--format", "json", "-o", "g"])
        .output()
        .unwrap();
    let alone = String::from_utf8(alone.stderr).unwrap();
    let warned: Vec<&str> = alone
        .lines()
        .filter_map(|line| line.strip_prefix("warning: w/1.toml: "))
        .collect();
    assert!(!warned.is_empty(), "{alone}");
    let output = matched(here);
    let message = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    for text in warned {
        let line = format!("warning: w/1.toml and 3 more: {text}");
        assert!(
            message.lines().any(|message| message == line),
            "{line}: {message}"
        );
    }
    // Gears that are drawn as a whole have them, too.
    let pair = fs::read_to_string(here.join("pair.toml")).unwrap();
    let drawn = "[tolerance]\nassemblies = 20\n[tolerance.wheel]\ngears = \"w/*.toml\"\n";
    fs::write(here.join("drawn.toml"), pair + drawn).unwrap();
    let output = gearlash(here)
        .args(["tolerance", "drawn.toml", "-o", "t"])
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    let wanted = "warning: drawn.toml: tolerance.wheel.gears: w/1.toml and 1 more: gear.pitch";
    assert!(message.contains(wanted), "{message}");
}

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

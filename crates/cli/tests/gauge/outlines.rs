//! `gearlash gauge` on outlines: drawings, and files of which a gear is one.

use crate::command::{folder, gauge, stdout};
use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

/// The readings of `gauge`, as JSON.
fn json(folder: &Path, arguments: &[&str]) -> Value {
    let all = [arguments, &["--format", "json"]].concat();
    serde_json::from_str(&stdout(&mut gauge(folder, &all))).unwrap()
}

/// The readings of the first gear: tooth, mm.
fn read(all: &Value, gauge: &str, list: &str) -> Vec<(u64, f64)> {
    let rows = all["gears"][0][gauge][list].as_array().unwrap();
    let row = |row: &Value| (row["tooth"].as_u64().unwrap(), row["mm"].as_f64().unwrap());
    rows.iter().map(row).collect()
}

/// The gear of `one.toml` (21 teeth, runout) drawn within 0.1 µm as `name`.
fn draw(folder: &Path, name: &str) {
    let (_, ending) = name.rsplit_once('.').unwrap();
    let mut command = Command::cargo_bin("gearlash").unwrap();
    let words = format!("outline one.toml --tolerance-um 0.1 --format {ending} -o {name}");
    command.current_dir(folder).args(words.split(' '));
    command.assert().success();
}

/// Source: the gauge on the gear itself. Each anvil and each flank of a space moves by 0.1 µm at most. A pin touches flanks at
/// some 20° on both sides of its path, and moves by 1/sin 20° as much.
#[test]
fn a_drawing_reads_as_the_gear_it_was_drawn_from() {
    const TOLERANCE: f64 = 1e-4;
    let folder = folder();
    let words = "one.toml --steps-per-pitch 1 --span-teeth 3 --pin-mm 5.25 --material most";
    let gear = json(folder.path(), &words.split(' ').collect::<Vec<_>>());
    for name in ["drawn.dxf", "drawn.svg", "drawn.csv"] {
        draw(folder.path(), name);
        let mut arguments = vec![name, "--span", "3", "--pin", "5.25"];
        if name.ends_with("csv") {
            arguments.extend(["--units", "mm"]);
        }
        let outline = json(folder.path(), &arguments);
        for (gauge, list, share) in [
            ("spans", "readings", 2.0),
            ("pins", "two", 6.0),
            ("pins", "three", 6.0),
        ] {
            let (found, expected) = (read(&outline, gauge, list), read(&gear, gauge, list));
            assert_eq!(found.len(), 21, "{name} {list}");
            for (one, other) in found.iter().zip(&expected) {
                let off = (one.1 - other.1).abs();
                assert!(
                    one.0 == other.0 && off <= share * TOLERANCE,
                    "{name} {list}: {one:?} {other:?}"
                );
            }
        }
        let touched = &outline["gears"][0]["spans"]["readings"][0]["touched"][0];
        assert_eq!(touched["curve"], "flank");
    }
}

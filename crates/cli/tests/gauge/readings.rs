//! The readings of gears, of their drawings and of the gear files that the gauge writes.

use super::{printed, read};
use serde_json::Value;
use std::path::Path;

const PROFILED: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../fixtures/profiled_44x44.toml"
);

/// The numbers of a list: themselves, or their `mm`.
fn numbers(list: &Value) -> Vec<f64> {
    let number = |value: &Value| value["mm"].as_f64().or(value.as_f64()).unwrap();
    list.as_array().unwrap().iter().map(number).collect()
}

/// Source: the gauge on the gear itself. Each anvil and each flank of a space moves by 0.1 µm at most. A pin touches flanks at
/// some 20° on both sides of its path, and moves by 1/sin 20° as much.
#[test]
fn a_drawing_reads_as_the_gear_it_was_drawn_from() {
    const TOLERANCE: f64 = 1e-4;
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let text = "[gear]\nteeth = 21\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
                thickness.over_pins = { pin_mm = 5.25, min_mm = 70.1, max_mm = 70.171 }\n\
                runout = { total_um = 12.0, high_tooth = 3.5 }\n";
    std::fs::write(folder.join("one.toml"), text).unwrap();
    let words = "one.toml --steps-per-pitch 1 --span-teeth 3 --pin-mm 5.25 --material most";
    let gear = read(folder, words);
    for (format, units) in [("dxf", ""), ("svg", ""), ("csv", " --units mm")] {
        let name = format!("drawn.{format}");
        let words = format!("outline one.toml --tolerance-um 0.1 --format {format} -o {name}");
        printed(folder, &words);
        let outline = read(folder, &format!("{name} --span 3 --pin 5.25{units}"));
        for (path, share) in [
            ("/gears/0/spans/readings", 2.0),
            ("/gears/0/pins/two", 6.0),
            ("/gears/0/pins/three", 6.0),
        ] {
            let [found, expected] = [&outline, &gear].map(|read| read.pointer(path).unwrap());
            let teeth = |list: &Value| -> Vec<Value> {
                let rows = list.as_array().unwrap().iter();
                rows.map(|row| row["tooth"].clone()).collect()
            };
            assert_eq!(teeth(found), teeth(expected), "{name} {path}");
            let (found, expected) = (numbers(found), numbers(expected));
            assert_eq!(found.len(), 21, "{name} {path}");
            for (one, other) in found.iter().zip(&expected) {
                let off = (one - other).abs();
                assert!(off <= share * TOLERANCE, "{name} {path}: {one} {other}");
            }
        }
        let touched = &outline["gears"][0]["spans"]["readings"][0]["touched"][0];
        assert_eq!(touched["curve"], "flank");
    }
}

/// The spans are those of the fixture. The slope of the wheel's right flanks is 3 µm more than that of its left ones. The
/// pinion's traces agree with the table, tooth by tooth.
#[test]
fn the_gauge_reads_what_the_file_states() {
    let folder = tempfile::tempdir().unwrap();
    let read = read(folder.path(), &format!("{PROFILED} --steps-per-pitch 1"));
    let [wheel, pinion] = [0, 1].map(|gear| &read["gears"][gear]);
    for span in numbers(&wheel["spans"]["readings"]) {
        assert!((span - 50.555).abs() < 1e-10, "{span}");
    }
    let mean = numbers(&pinion["spans"]["readings"]).iter().sum::<f64>() / 44.0;
    assert!((mean - 50.563).abs() < 1e-10, "{mean}");
    let um = |flank: &str, key: &str| numbers(&wheel["profile"][flank][key]);
    // Least squares take sums as they are: by the slope that was added.
    for (key, more) in [("slope_um", 3.0), ("form_um", 0.0)] {
        for tooth in [0, 43] {
            let found = um("right", key)[tooth] - um("left", key)[tooth];
            assert!((found - more).abs() < 1e-6, "{key}: {found}");
        }
    }
    // 12 µm less at the tip circle, of which the range has the part up to 137.5 mm; crowning is 0 there.
    let [from, at, tip] = [135.5f64, 137.5, 138.0].map(|d| {
        let base = 132.0 * 20f64.to_radians().cos();
        (d * d - base * base).sqrt()
    });
    let relieved = 12.0 * (at - from) / (tip - from);
    let total = um("left", "total_um")[0];
    assert!((total - 4.0 - relieved).abs() < 0.01, "{total} {relieved}");
    let right = &pinion["profile"]["right"];
    assert_eq!(right["curves"].as_array().unwrap().len(), 5);
    let table = std::fs::read_to_string(PROFILED.replace(".toml", "_trace.csv")).unwrap();
    let mut seen = 0;
    for row in table.lines().skip(1) {
        let row: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let (length, um) = (row[1], row[2]);
        let curve = &right["curve_of_tooth"][row[0] as usize - 1];
        let curve = &right["curves"][curve.as_u64().unwrap() as usize];
        let lengths = numbers(&curve["roll_length_mm"]);
        let found = numbers(&curve["deviation_um"]);
        let mut stretches = lengths.windows(2);
        let Some(k) = stretches.position(|w| w[0] <= length && length <= w[1]) else {
            continue;
        };
        let part = (length - lengths[k]) / (lengths[k + 1] - lengths[k]);
        let there = found[k] + part * (found[k + 1] - found[k]);
        assert!((there - um).abs() < 0.02, "{row:?}: {there}");
        seen += 1;
    }
    assert!(seen > 80, "{seen}");
}

/// The gear files give equal readings: spans, thickness, pitch and profile. `tests/sessions/gauge_files.txt` holds charts and tables.
#[test]
fn what_was_gauged_gauges_alike() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let words = format!("gauge {PROFILED} --steps-per-pitch 1 -o out");
    printed(folder, &words);
    let gauged = |file: &str| read(folder, &format!("{file} --steps-per-pitch 1"));
    let before = gauged(PROFILED);
    for (gear, name) in [(0, "wheel"), (1, "pinion")] {
        let after = gauged(&format!("out/gauge_{name}.toml"));
        for (path, most) in [
            ("/spans/readings", 1e-7),
            ("/thickness/arc_mm", 1e-7),
            ("/pitch_own/right/cumulative_um", 1e-4),
            ("/pitch_own/left/cumulative_um", 1e-4),
            ("/profile/right/total_um", 1e-4),
            ("/profile/left/slope_um", 1e-4),
        ] {
            let old = numbers(before["gears"][gear].pointer(path).unwrap());
            let new = numbers(after["gears"][0].pointer(path).unwrap());
            assert_eq!((old.len(), new.len()), (44, 44), "{path}");
            for (old, new) in old.iter().zip(&new) {
                assert!((old - new).abs() < most, "{name} {path}: {old} {new}");
            }
        }
    }
}

/// A gear file with deviations is read alone, and gives equal readings in every column: tooth, span, pins, runout, pitches and thickness.
#[test]
fn a_gauged_gear_gauges_alike() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("one.toml");
    let gear = super::round_trip::table("gear", 21, "back", 5, -7.0, true);
    std::fs::write(&file, gear).unwrap();
    let gauged = |file: &str, out: &str| -> Vec<Vec<f64>> {
        let words = format!("gauge {file} -o {out} --steps-per-pitch 1");
        printed(folder.path(), &words);
        let path: &Path = &folder.path().join(out).join("gauge_gear.csv");
        let table = std::fs::read_to_string(path).unwrap();
        let numbers = |row: &str| {
            row.split(',')
                .filter_map(|cell| cell.parse().ok())
                .collect()
        };
        table.lines().skip(1).map(numbers).collect()
    };
    let before = gauged("one.toml", "first");
    let after = gauged("first/gauge_gear.toml", "second");
    assert_eq!((before.len(), after.len()), (21, 21));
    for (before, after) in before.iter().zip(&after) {
        assert!(before.len() >= 14 && before.len() == after.len());
        for (a, b) in before.iter().zip(after) {
            // mm or µm: 1e-6 µm is the coarser.
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
    }
}

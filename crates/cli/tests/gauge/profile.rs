//! Gears whose profiles deviate, as a user checks and gauges them.

use super::command::{gauge, stdout};
use serde_json::Value;
use std::path::Path;

const FIXTURE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../fixtures/profiled_44x44.toml"
);

fn json(folder: &Path, file: &str) -> Value {
    let text = stdout(&mut gauge(
        folder,
        &[file, "--steps-per-pitch", "1", "--format", "json"],
    ));
    serde_json::from_str(&text).unwrap()
}

/// The spans are those of the fixture. The slope of the wheel's right flanks is 3 µm more than that of its left ones. The
/// pinion's traces agree with the table, tooth by tooth.
#[test]
fn the_gauge_reads_what_the_file_states() {
    let folder = tempfile::tempdir().unwrap();
    let read = json(folder.path(), FIXTURE);
    let [wheel, pinion] = [0, 1].map(|gear| &read["gears"][gear]);
    for span in wheel["spans"]["readings"].as_array().unwrap() {
        assert!(
            (span["mm"].as_f64().unwrap() - 50.555).abs() < 1e-10,
            "{span}"
        );
    }
    let spans = pinion["spans"]["readings"].as_array().unwrap();
    let sum: f64 = spans.iter().map(|span| span["mm"].as_f64().unwrap()).sum();
    assert!((sum / 44.0 - 50.563).abs() < 1e-10, "{sum}");
    let um = |flank: &str, key: &str, tooth: usize| {
        wheel["profile"][flank][key][tooth].as_f64().unwrap()
    };
    // Least squares take sums as they are: by the slope that was added.
    for tooth in [0, 43] {
        let more = um("right", "slope_um", tooth) - um("left", "slope_um", tooth);
        assert!((more - 3.0).abs() < 1e-6, "{more}");
        let off = um("right", "form_um", tooth) - um("left", "form_um", tooth);
        assert!(off.abs() < 1e-6, "{off}");
    }
    // 12 µm less at the tip circle, of which the range has the part up to 137.5 mm; crowning is 0 there.
    let [from, at, tip] = [135.5f64, 137.5, 138.0].map(|d| {
        let base = 132.0 * 20f64.to_radians().cos();
        (d * d - base * base).sqrt()
    });
    let relieved = 12.0 * (at - from) / (tip - from);
    assert!(
        (um("left", "total_um", 0) - 4.0 - relieved).abs() < 0.01,
        "{relieved}"
    );
    let right = &pinion["profile"]["right"];
    assert_eq!(right["curves"].as_array().unwrap().len(), 5);
    let table = std::fs::read_to_string(FIXTURE.replace(".toml", "_trace.csv")).unwrap();
    let mut seen = 0;
    for row in table.lines().skip(1) {
        let row: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let [tooth, length, um] = row[..] else {
            panic!("{row:?}")
        };
        let curve = right["curve_of_tooth"][tooth as usize - 1]
            .as_u64()
            .unwrap();
        let curve = &right["curves"][curve as usize];
        let list = |key: &str| -> Vec<f64> {
            let list = curve[key].as_array().unwrap().iter();
            list.map(|value| value.as_f64().unwrap()).collect()
        };
        let (lengths, found) = (list("roll_length_mm"), list("deviation_um"));
        let Some(k) = lengths
            .windows(2)
            .position(|w| w[0] <= length && length <= w[1])
        else {
            continue;
        };
        let part = (length - lengths[k]) / (lengths[k + 1] - lengths[k]);
        let there = found[k] + part * (found[k + 1] - found[k]);
        assert!(
            (there - um).abs() < 0.02,
            "tooth {tooth} at {length}: {there} {um}"
        );
        seen += 1;
    }
    assert!(seen > 80, "{seen}");
}

/// Charts, a table, and a gear file that gives equal readings: spans, thickness, pitch and profile.
#[test]
fn what_was_gauged_gauges_alike() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [FIXTURE, "--steps-per-pitch", "1", "-o", "out"];
    let text = stdout(&mut gauge(folder.path(), &arguments));
    for words in [
        "profile, right flanks: f_Hα",
        "at tooth 23",
        "d 127.500 to 137.500 mm",
    ] {
        assert!(text.contains(words), "{words} in {text}");
    }
    let chart = std::fs::read_to_string(folder.path().join("out/gauge_wheel_profile.svg")).unwrap();
    assert!(chart.contains("evaluation range") && chart.contains("roll length, mm"));
    let table = std::fs::read_to_string(folder.path().join("out/gauge_pinion.csv")).unwrap();
    assert!(table.contains("profile_slope_left_um"), "{table}");
    assert_eq!(table.lines().count(), 45);
    let before = json(folder.path(), FIXTURE);
    for (gear, name) in [(0, "wheel"), (1, "pinion")] {
        let after = json(folder.path(), &format!("out/gauge_{name}.toml"));
        let numbers = |read: &Value, path: &str| -> Vec<f64> {
            let list = read.pointer(path).unwrap().as_array().unwrap();
            let number = |value: &Value| value["mm"].as_f64().or(value.as_f64()).unwrap();
            list.iter().map(number).collect()
        };
        for path in [
            "/spans/readings",
            "/thickness/arc_mm",
            "/pitch_own/right/cumulative_um",
            "/pitch_own/left/cumulative_um",
            "/profile/right/total_um",
            "/profile/left/slope_um",
        ] {
            let old = numbers(&before["gears"][gear], path);
            let new = numbers(&after["gears"][0], path);
            assert_eq!(old.len(), 44, "{path}");
            for (old, new) in old.iter().zip(&new) {
                // 0.1 nm in mm, and in µm.
                let most = if path.ends_with("um") { 1e-4 } else { 1e-7 };
                assert!((old - new).abs() < most, "{name} {path}: {old} {new}");
            }
        }
    }
}

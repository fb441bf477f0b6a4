//! `gearlash gauge` as a user and as a script runs it.

use crate::skip::skip;
use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

const GEAR: &str = "\
title = \"a <gear>\"
[gear]
teeth = 21
module_mm = 3.0
pressure_angle_deg = 20.0
thickness.over_pins = { pin_mm = 5.25, min_mm = 70.1, max_mm = 70.171 }
runout = { total_um = 12.0, high_tooth = 3.5 }
";

pub fn gauge(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder).arg("gauge").args(arguments);
    command
}

pub fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("one.toml"), GEAR).unwrap();
    let pair = GEAR.replace("[gear]", "[wheel]")
        + "[pinion]\nteeth = 20\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nreference_face = \"back\"\n[assembly]\ncenter_distance_mm = 61.6\n";
    std::fs::write(folder.path().join("pair.toml"), pair).unwrap();
    folder
}

pub fn stdout(command: &mut Command) -> String {
    String::from_utf8(command.assert().success().get_output().stdout.clone()).unwrap()
}

/// It ended with 0 and a line among others. Pins at the ends of the range touch involutes alone, a pin 2 % beyond the greatest does not.
#[test]
fn a_pin_that_fits_no_space_is_refused_with_those_that_fit() {
    let folder = folder();
    let run = |pin: &str| {
        let words =
            format!("one.toml --material most --pin-mm {pin} --steps-per-pitch 1 --format json");
        let arguments: Vec<&str> = words.split(' ').collect();
        let assert = gauge(folder.path(), &arguments).assert();
        let output = assert.get_output();
        let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
        (
            output.status.code(),
            text(&output.stdout),
            text(&output.stderr),
        )
    };
    let (code, _, message) = run("100000");
    assert_eq!(code, Some(2), "{message}");
    let words = "--pin-mm 100000: gear: a ball of 100000 mm finds no rest in the space after tooth 1; pins of ";
    let (_, fit) = message
        .split_once(words)
        .unwrap_or_else(|| panic!("{message}"));
    let mut numbers = fit.split(' ').filter_map(|word| word.parse::<f64>().ok());
    let [least, greatest] = [0; 2].map(|_| numbers.next().unwrap());
    let touches_involutes = |pin: f64| {
        let (code, text, message) = run(&pin.to_string());
        assert_eq!(code, Some(0), "{pin}: {message}");
        let json: Value = serde_json::from_str(&text).unwrap();
        // The ball of the runout is the pin.
        let seats = json["gears"][0]["runout"]["readings"].as_array().unwrap();
        let mut touched = seats
            .iter()
            .flat_map(|seat| seat["touched"].as_array().unwrap());
        touched.all(|touch| touch["curve"] == "involute")
    };
    assert!(touches_involutes(least) && touches_involutes(greatest));
    assert!(!touches_involutes(1.02 * greatest));
}

/// Issue 5, item 6, at m = 3, z = 40 (d = 120). Grade 5: f_pT = 0.12 + 1.2 + 5 = 6.32, F_pT = 0.24 + 0.55 √120 + 2.1 + 12 =
/// 20.36. Grade 6: 8.94 → 9.0, 28.80 → 29, F_rT = 25.92 → 26 µm. Grade 11: f_pT = 6.32 · 8 = 50.56 → 51, F_pT = 162.9 → 163 µm.
#[test]
fn grades_pitch_and_runout() {
    let folder = folder();
    let graded = |teeth: u32, module: f64, step: f64, total: f64| -> Value {
        // The flanks of one tooth are displaced by `step`: f_p and F_p equal it, about any axis.
        let curve = (1..=teeth)
            .map(|i| if i == 7 { step } else { 0.0 })
            .collect::<Vec<_>>();
        let file = format!(
            "title = \"graded\"\n[gear]\nteeth = {teeth}\nmodule_mm = {module:?}\npressure_angle_deg = 20.0\n\
             runout = {{ total_um = {total:?}, high_tooth = 1.5 }}\n\
             pitch = {{ kind = \"cumulative\", right_um = {curve:?}, left_um = {curve:?} }}\n"
        );
        std::fs::write(folder.path().join("graded.toml"), file).unwrap();
        let quick = ["graded.toml", "--format", "json", "--steps-per-pitch", "1"];
        let all: Value = serde_json::from_str(&stdout(&mut gauge(folder.path(), &quick))).unwrap();
        all["gears"][0]["grades"].clone()
    };
    let row = |grades: &Value, symbol: &str, axis: Value, flank: Value| -> Value {
        let values = grades["values"].as_array().unwrap();
        let is = |v: &&Value| v["symbol"] == symbol && v["axis"] == axis && v["flank"] == flank;
        values.iter().find(is).unwrap().clone()
    };
    // On the tolerance itself, above it, and beyond the last grade.
    for (step, single, total) in [
        (9.0, (Some(6), 9.0), (Some(3), 10.0)),
        (9.01, (Some(7), 13.0), (Some(3), 10.0)),
        (29.0, (Some(10), 36.0), (Some(6), 29.0)),
        (60.0, (None, 51.0), (Some(9), 81.0)),
        (170.0, (None, 51.0), (None, 163.0)),
    ] {
        let grades = graded(40, 3.0, step, 0.0);
        assert_eq!(
            grades["source"],
            "after ISO 1328-1:2013, formulas as published in several open implementations, standard not consulted"
        );
        for (axis, flank) in [
            ("datum", "right"),
            ("datum", "left"),
            ("own", "right"),
            ("own", "left"),
        ] {
            for (symbol, (grade, tolerance)) in [("f_p", single), ("F_p", total)] {
                let row = row(&grades, symbol, axis.into(), flank.into());
                assert!((row["measured_um"].as_f64().unwrap() - step).abs() < 1e-6);
                assert_eq!(row["grade"].as_u64(), grade, "{symbol} {step}");
                assert!((row["tolerance_um"].as_f64().unwrap() - tolerance).abs() < 1e-9);
            }
        }
    }
    // An eccentricity towards a space, z even: F_r = 2 e.
    let grades = graded(40, 3.0, 0.0, 25.9);
    let runout = row(&grades, "F_r", Value::Null, Value::Null);
    assert!((runout["measured_um"].as_f64().unwrap() - 25.9).abs() < 1e-3);
    assert_eq!(runout["grade"], 6);
    assert!((runout["tolerance_um"].as_f64().unwrap() - 26.0).abs() < 1e-9);
    // Outside the formulas' range the reason is printed.
    let none = graded(40, 0.4, 0.0, 0.0);
    let reason = none["not_measured"].as_str().unwrap();
    assert!(reason.contains("0.5 … 70 mm"), "{reason}");
}

/// On a terminal (as `script` is one) a bar shows the number of poses and the remaining time; a pipe gets nothing.
#[cfg(target_os = "linux")]
#[test]
fn a_bar_tells_how_long_it_will_take() {
    let folder = folder();
    let words = ["one.toml", "--steps-per-pitch", "200", "--material", "most"];
    let piped = gauge(folder.path(), &words).assert().success();
    assert!(piped.get_output().stderr.is_empty());
    let line = format!(
        "{} gauge {}",
        assert_cmd::cargo::cargo_bin("gearlash").display(),
        words.join(" ")
    );
    let mut script = std::process::Command::new("script");
    script
        .args(["-qec", &line, "/dev/null"])
        .current_dir(folder.path());
    let Ok(output) = script.stdin(std::process::Stdio::null()).output() else {
        skip("there is no `script`");
        return;
    };
    let shown = String::from_utf8_lossy(&output.stdout);
    // 21 teeth of 200 poses.
    assert!(
        shown.contains("/4200 poses, ") && shown.contains(" left"),
        "{shown}"
    );
}

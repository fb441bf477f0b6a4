//! Pairs of outlines: pair files with drawings, and two drawings by themselves.

use crate::{fixture, run};
use serde_json::Value;
use std::path::PathBuf;

pub(super) fn drawn() -> PathBuf {
    fixture("outlines")
}

pub(super) fn copied() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir(drawn()).unwrap() {
        let path = entry.unwrap().path();
        std::fs::copy(&path, folder.path().join(path.file_name().unwrap())).unwrap();
    }
    folder
}

/// The seventh tooth of the wheel is 180 µm thicker than the others (`wheel_20.toml`): it binds, and nothing else.
#[test]
fn check_names_the_tooth_that_binds() {
    let folder = copied();
    let (code, text, notes) = run(folder.path(), &["check", "drawn_20x20.toml", "--verbose"]);
    assert_eq!(code, Some(1));
    insta::assert_snapshot!(text);
    assert!(notes.contains("20 teeth between diameters"), "{notes}");
}

/// Two drawings and a centre distance say the same as the pair file.
#[test]
fn two_drawings_need_no_pair_file() {
    let folder = copied();
    let drawings = [
        "check",
        "wheel_20.dxf",
        "pinion_20.svg",
        "--center-distance",
        "40.05",
    ];
    let (code, text, _) = run(folder.path(), &drawings);
    let (_, of_file, _) = run(folder.path(), &["check", "drawn_20x20.toml"]);
    let after_title = |text: &str| text.split_once("\n\n").unwrap().1.to_owned();
    assert_eq!((code, after_title(&text)), (Some(1), after_title(&of_file)));
    // `fit` finds their axes by the tips, which are on circles about 0,0.
    let fitted = [&drawings[..], &["--center", "fit", "--verbose"]].concat();
    let (code, text, notes) = run(folder.path(), &fitted);
    assert!(
        code == Some(1) && text.contains("Does not assemble at a = 40.050 mm."),
        "{text}"
    );
    assert!(
        notes.contains("centre fitted to the tips: (0.00"),
        "{notes}"
    );
    // Where every tooth has room it turns: exit code 0.
    let apart = [&drawings[..4], &["40.2"]].concat();
    let (code, text, _) = run(folder.path(), &apart);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("Assembles at a = 40.200 mm."), "{text}");
}

/// Without a centre distance, the gears mesh without play at the one that is taken, and interfere 0.01 mm below it.
/// Backlash grows by 2 tan α a mm, about 0.7 µm a µm: rounded up by 1 µm, the least is below 10 µm.
#[test]
fn the_distance_without_play_is_found() {
    let folder = copied();
    let drawings = ["check", "wheel_20.dxf", "pinion_20.svg"];
    let check = |more: &[&str]| {
        let (code, text, notes) = run(folder.path(), &[&drawings[..], more].concat());
        (code, text, notes)
    };
    let (code, text, notes) = check(&[]);
    assert_eq!(code, Some(0), "{text}{notes}");
    let taken = notes.split_once("at ").unwrap().1;
    let taken: f64 = taken.split_once(" mm").unwrap().0.parse().unwrap();
    assert!(
        text.contains(&format!("Assembles at a = {taken:.3} mm.")),
        "{text}"
    );
    let least = text.lines().find(|line| line.trim().starts_with("least"));
    let least: f64 = least
        .unwrap()
        .split_whitespace()
        .nth(1)
        .unwrap()
        .parse()
        .unwrap();
    assert!((0.0..10.0).contains(&least), "{text}");
    let nearer = format!("{:.3}", taken - 0.01);
    let (code, text, _) = check(&["--center-distance", &nearer]);
    assert_eq!(code, Some(1), "{text}");
    assert!(text.contains("Does not assemble"), "{text}");
}

/// The least backlash of the drawn pair is that of the gears they were drawn from, within both tolerances of 20 µm.
#[test]
fn simulate_writes_what_it_found() {
    let folder = copied();
    let (code, _, _) = run(
        folder.path(),
        &["simulate", "drawn_20x20.toml", "-o", "out"],
    );
    assert_eq!(code, Some(0));
    let out = folder.path().join("out");
    let result = std::fs::read_to_string(out.join("result.json")).unwrap();
    let result: Value = serde_json::from_str(&result).unwrap();
    let run_of = &result["runs"][0];
    assert_eq!(result["verdict"]["assembles"], false);
    assert_eq!(run_of["poses"].as_array().unwrap().len(), 320);
    let least = &result["extremes"][0]["least"];
    assert_eq!(least["pose"]["right"]["wheel_tooth"], 7);
    let pair = "[wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n[wheel.thickness]\nallowance_um = -60.0\n\
                per_tooth_um = [0, 0, 0, 0, 0, 0, 180, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n\
                [pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n[pinion.thickness]\nallowance_um = -60.0\n\
                [assembly]\ncenter_distance_mm = 40.05\n";
    std::fs::write(folder.path().join("data.toml"), pair).unwrap();
    let (_, json, _) = run(
        folder.path(),
        &["simulate", "data.toml", "--format", "json"],
    );
    let data: Value = serde_json::from_str(&json).unwrap();
    let known = data["extremes"][0]["least"]["j_wt_um"]
        .as_array()
        .map_or_else(
            || data["extremes"][0]["least"]["j_wt_um"].as_f64().unwrap(),
            |bracket| bracket[0].as_f64().unwrap(),
        );
    let found = least["found_j_wt_um"].as_f64().unwrap();
    // Chords cut off metal: two flanks of two gears, each along its normal by up to 20 µm.
    assert!(
        found >= known - 0.01 && found <= known + 4.0 * 20.0 / 20f64.to_radians().cos(),
        "{known} {found}"
    );
    let csv = std::fs::read_to_string(out.join("result.csv")).unwrap();
    assert_eq!(csv.lines().count(), 321);
    let picture = std::fs::read_to_string(out.join("worst.svg")).unwrap();
    assert!(
        picture.contains("wheel 7 tip on pinion 15 flank"),
        "{picture}"
    );
}

/// An outline drawn from a gear gets its involute: module, pressure angle, and the shift of its allowance, −60 µm / (2 m tan
/// 20°). A gear of module 1.9 matches no standard one and gets its m cos 20°. A gear by its data is not fitted.
#[test]
fn an_outline_looks_like_what_it_was_drawn_from() {
    let folder = tempfile::tempdir().unwrap();
    let angle = 20f64.to_radians();
    for (name, module) in [("two", "2.0"), ("odd", "1.9")] {
        let gear = format!(
            "[gear]\nteeth = 20\nmodule_mm = {module}\npressure_angle_deg = 20.0\n[gear.thickness]\nallowance_um = -60.0\n"
        );
        std::fs::write(folder.path().join("gear.toml"), gear).unwrap();
        let file = format!("{name}.csv");
        let draw = ["outline", "gear.toml", "--format", "csv", "-o", &file];
        assert_eq!(run(folder.path(), &draw).0, Some(0));
    }
    let pair = "[wheel.outline]\nfile = \"two.csv\"\n[pinion.outline]\nfile = \"odd.csv\"\n[assembly]\ncenter_distance_mm = 39.5\n";
    std::fs::write(folder.path().join("pair.toml"), pair).unwrap();
    let (_, json, said) = run(
        folder.path(),
        &["simulate", "pair.toml", "--format", "json"],
    );
    let result: Value = serde_json::from_str(&json).unwrap_or_else(|_| panic!("{said}"));
    let [two, odd] = &result["fitted_involutes"].as_array().unwrap()[..] else {
        panic!("{result}");
    };
    let standard = &two["standard"][0];
    assert_eq!(
        (&standard["module_mm"], &standard["pressure_angle_deg"]),
        (&2.0.into(), &20.0.into())
    );
    let shift = standard["generating_shift"].as_f64().unwrap();
    assert!((shift + 0.06 / (4.0 * angle.tan())).abs() < 1e-6, "{shift}");
    assert_eq!(odd["standard"], Value::Array(Vec::new()));
    let found = odd["module_times_cos_mm"].as_f64().unwrap();
    assert!((found - 1.9 * angle.cos()).abs() < 1e-6, "{found}");
    let (_, text, _) = run(folder.path(), &["check", "pair.toml"]);
    assert!(
        text.contains("the wheel looks like module 2.0 mm, 20°, 20 teeth, x = −0.041"),
        "{text}"
    );
    let data = "[wheel.outline]\nfile = \"two.csv\"\n[pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n[assembly]\ncenter_distance_mm = 40.1\n";
    std::fs::write(folder.path().join("pair.toml"), data).unwrap();
    let (_, text, _) = run(folder.path(), &["check", "pair.toml"]);
    assert!(
        text.contains("the wheel looks like") && !text.contains("the pinion looks like"),
        "{text}"
    );
}

/// Polygons confirm every pose, and can be switched off: the numbers are equal.
#[test]
fn polygons_bear_out_every_pose() {
    let folder = copied();
    let simulate = ["simulate", "drawn_20x20.toml", "--format", "json"];
    let [certified, plain] = [&[][..], &["--no-certify"]].map(|more| {
        let (code, json, said) = run(folder.path(), &[&simulate[..], more].concat());
        assert_eq!(code, Some(0), "{said}");
        serde_json::from_str::<Value>(&json).unwrap()
    });
    let poses = |result: &Value| result["runs"][0]["poses"].clone();
    assert_eq!(poses(&certified), poses(&plain));
    let checked = |result: &Value| result["runs"][0]["summary"]["polygon_checked"].clone();
    assert_eq!(
        (checked(&certified), checked(&plain)),
        (320.into(), 0.into())
    );
    assert_eq!(certified["runs"][0]["summary"]["unproven"], 0);
}

//! `compare` of two drawings of one gear.

use crate::{fixture, run};
use serde_json::Value;
use std::path::Path;

/// The outline of a gear of 20 teeth and module 2 with these lines more, within 0.01 µm.
fn draw(folder: &Path, name: &str, format: &str, lines: &str) {
    let gear = format!("[gear]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n{lines}");
    std::fs::write(folder.join("gear.toml"), gear).unwrap();
    let args = [
        "outline",
        "gear.toml",
        "--tolerance-um",
        "0.01",
        "--format",
        format,
        "-o",
        name,
    ];
    let (code, _, said) = run(folder, &args);
    assert_eq!(code, Some(0), "{said}");
}

const PLAIN: &str = "[gear.thickness]\nallowance_um = -60.0\n";
/// Tooth 7 is 180 µm thicker on the reference circle.
const THICK: &str = "[gear.thickness]\nallowance_um = -60.0\nper_tooth_um = [0, 0, 0, 0, 0, 0, 180, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n";

/// Both flanks of tooth 7 are displaced by 90 µm on the reference circle: along their normals by 90 µm cos 20° = 84.57 µm. (An
/// involute that is turned by φ moves by φ r_b.)
#[test]
fn a_thicker_tooth_is_found_with_its_size() {
    let folder = tempfile::tempdir().unwrap();
    draw(folder.path(), "plain.svg", "svg", PLAIN);
    draw(folder.path(), "thick.csv", "csv", THICK);
    let known = 90.0 * 20f64.to_radians().cos();
    let compare = ["compare", "plain.svg", "thick.csv", "--format", "json"];
    let (code, json, said) = run(folder.path(), &compare);
    assert_eq!(code, Some(0), "{said}");
    let found: Value = serde_json::from_str(&json).unwrap();
    let off = found["greatest"]["deviation_um"].as_f64().unwrap() - known;
    let bound = found["error_bound_um"].as_f64().unwrap();
    // Both outlines are within 0.01 µm of the curves.
    assert!(off.abs() <= bound + 0.02 && bound < 0.1, "{off} {bound}");
    assert!(found["least"]["deviation_um"].as_f64().unwrap() > -0.1);
    assert_eq!(found["greatest"]["a_tooth"], 7);
    assert_eq!(
        (&found["a"]["teeth"], &found["b"]["teeth"]),
        (&20.into(), &20.into())
    );
    // The other way round it has less material.
    let back = ["compare", "thick.csv", "plain.svg", "--format", "json"];
    let (_, json, _) = run(folder.path(), &back);
    let found: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(found["least"]["a_tooth"], 7);
    assert!(found["least"]["deviation_um"].as_f64().unwrap() < -known + 0.1);
    // A tolerance decides as it does between simulation and formula: beyond it is exit code 1.
    for (tolerance, expected) in [("84", 1), ("85", 0)] {
        let args = [
            "compare",
            "plain.svg",
            "thick.csv",
            "--tolerance-um",
            tolerance,
        ];
        let (code, text, _) = run(folder.path(), &args);
        assert_eq!(code, Some(expected), "{text}");
        let word = if expected == 0 {
            "Agree within"
        } else {
            "DIFFER by more than"
        };
        assert!(text.contains(word), "{text}");
    }
}

/// Source: the closed form of `a_thicker_tooth_is_found_with_its_size`, and the JSON of the same comparison.
#[test]
fn every_place_along_a_is_a_row() {
    let folder = tempfile::tempdir().unwrap();
    draw(folder.path(), "plain.svg", "svg", PLAIN);
    draw(folder.path(), "thick.csv", "csv", THICK);
    let compare = ["compare", "plain.svg", "thick.csv", "--format", "csv"];
    let (code, csv, said) = run(folder.path(), &compare);
    assert_eq!(code, Some(0), "{said}");
    let mut lines = csv.lines();
    assert_eq!(
        lines.next(),
        Some("a_tooth,x_mm,y_mm,radius_mm,normal_x,normal_y,deviation_um")
    );
    let rows: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    let known = 90.0 * 20f64.to_radians().cos();
    for row in &rows {
        assert!((row[1].hypot(row[2]) - row[3]).abs() < 1e-9);
        assert!((row[4].hypot(row[5]) - 1.0).abs() < 1e-9);
        // Well within the flanks of tooth 7, whose normals are those of involutes: at d 38.5 … 42.
        if row[0] == 7.0 && (19.25..21.0).contains(&row[3]) {
            assert!((row[6] - known).abs() < 0.1, "{row:?}");
        } else if row[0] != 7.0 {
            assert!(row[6].abs() < 0.1, "{row:?}");
        }
    }
    let json = ["compare", "plain.svg", "thick.csv", "--format", "json"];
    let found: Value = serde_json::from_str(&run(folder.path(), &json).1).unwrap();
    let greatest = rows
        .iter()
        .map(|row| row[6])
        .fold(f64::NEG_INFINITY, f64::max);
    // The greatest itself may lie between two places.
    let short = found["greatest"]["deviation_um"].as_f64().unwrap() - greatest;
    assert!((0.0..0.01).contains(&short), "{short}");
    // A pair file has no such rows.
    let pair = fixture("karba_44x44.toml");
    let (code, _, said) = run(
        folder.path(),
        &["compare", pair.to_str().unwrap(), "--format", "csv"],
    );
    assert!(
        code == Some(2) && said.contains("belong to two drawings"),
        "{said}"
    );
}

/// The wheel of the fixtures is thicker at tooth 7 than the pinion.
#[test]
fn the_picture_of_two_drawings() {
    let folder = tempfile::tempdir().unwrap();
    let drawn = |name: &str| fixture("outlines").join(name).display().to_string();
    for name in ["wheel_20.dxf", "pinion_20.svg"] {
        std::fs::copy(drawn(name), folder.path().join(name)).unwrap();
    }
    let picture = [
        "compare",
        "wheel_20.dxf",
        "pinion_20.svg",
        "--svg",
        "out/difference.svg",
    ];
    assert_eq!(run(folder.path(), &picture).0, Some(0));
    let svg = std::fs::read_to_string(folder.path().join("out/difference.svg")).unwrap();
    roxmltree::Document::parse(&svg).unwrap();
    assert!(svg.contains("deviations × 10: B is not to scale") && svg.contains("tooth 7"));
}

/// An eccentricity of 15 µm towards tooth 1, which points up: tips of the other are 15 µm lower there and higher on the other side. With
/// both centres fitted nothing is left of it.
#[test]
fn an_eccentricity_is_seen_unless_centres_are_fitted() {
    let folder = tempfile::tempdir().unwrap();
    let runout = format!("{PLAIN}[gear.runout]\ntotal_um = 30.0\nhigh_tooth = 1.0\n");
    draw(folder.path(), "off.dxf", "dxf", &runout);
    draw(folder.path(), "plain.dxf", "dxf", PLAIN);
    let found = |more: &[&str]| -> [f64; 3] {
        let args = [
            &["compare", "off.dxf", "plain.dxf", "--format", "json"],
            more,
        ]
        .concat();
        let (_, json, said) = run(folder.path(), &args);
        let found: Value = serde_json::from_str(&json).unwrap_or_else(|_| panic!("{said}"));
        let value = |value: &Value| value.as_f64().unwrap();
        [
            value(&found["least"]["deviation_um"]),
            value(&found["greatest"]["deviation_um"]),
            value(&found["root_mean_square_um"]),
        ]
    };
    let [least, greatest, _] = found(&[]);
    assert!(
        (least + 15.0).abs() < 0.1 && (greatest - 15.0).abs() < 0.1,
        "{least} {greatest}"
    );
    let [least, greatest, rms] = found(&["--center", "fit"]);
    assert!(
        least > -0.1 && greatest < 0.1 && rms < 0.05,
        "{least} {greatest} {rms}"
    );
}

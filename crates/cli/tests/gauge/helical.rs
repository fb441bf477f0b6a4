//! `gearlash gauge` on helical gears.

use super::command::{gauge, stdout};
use serde_json::Value;

/// FVA Workbench's 27 teeth (example 1-3): over two balls and over two pins of the nominal gear.
const GEAR: &str = "\
title = \"helical\"
[gear]
teeth = 27
module_mm = 4.5
pressure_angle_deg = 20.0
helix_angle_deg = 21
hand = \"right\"
face_width_mm = 50
profile_shift = 0.3
rack.root_radius = 0.25
";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("one.toml"), GEAR).unwrap();
    let short = GEAR.replace("= 50", "= 15");
    std::fs::write(folder.path().join("short.toml"), short).unwrap();
    folder
}

fn near(value: &Value, expected: f64) -> bool {
    (value.as_f64().unwrap() - expected).abs() < 1e-9
}

#[test]
fn json_has_balls_pins_and_both_sections() {
    let folder = folder();
    let mut command = gauge(
        folder.path(),
        &["one.toml", "--pin", "9", "--span", "4", "--format", "json"],
    );
    let all: Value = serde_json::from_str(&stdout(&mut command)).unwrap();
    let gear = &all["gears"][0];
    assert_eq!(gear["helix_angle_deg"], 21.0);
    assert_eq!(
        (&gear["hand"], &gear["face_mm"][0]),
        (&"right".into(), &(-25.0).into())
    );
    let pins = &gear["pins"];
    assert_eq!(pins["two_and_three_are"], "balls");
    for (list, formula, expected) in [
        ("two", "formula_two_mm", 147.07716569057362),
        ("lying", "formula_lying_mm", 147.3111662932581),
    ] {
        let readings = pins[list].as_array().unwrap();
        assert_eq!(readings.len(), 27);
        assert!(
            readings.iter().all(|one| near(&one["mm"], expected)),
            "{list}"
        );
        assert!(near(&pins[formula], expected));
    }
    // W_4 = m_n cos α_n (3.5 π + z inv α_t) + 2 x m_n sin α_n.
    let (alpha, beta) = (20f64.to_radians(), 21f64.to_radians());
    let alpha_t = (alpha.tan() / beta.cos()).atan();
    let inv = alpha_t.tan() - alpha_t;
    let span = 4.5 * alpha.cos() * (3.5 * std::f64::consts::PI + 27.0 * inv) + 2.7 * alpha.sin();
    assert!(near(&gear["spans"]["readings"][5]["mm"], span));
    assert_eq!(gear["spans"]["direction"], "normal");
    let normal = 4.5 * (std::f64::consts::FRAC_PI_2 + 0.6 * alpha.tan());
    assert!(near(&gear["thickness"]["normal_mm"][3], normal));
    assert!(near(&gear["thickness"]["arc_mm"][3], normal / beta.cos()));
    assert_eq!(gear["thickness"]["section"], "transverse");
}

/// Text, sheets and gear file; the warning of a face that is too short for the span.
#[test]
fn text_and_files_say_what_is_over_balls() {
    let folder = folder();
    let text = stdout(&mut gauge(
        folder.path(),
        &["one.toml", "--pin", "9", "-o", "out"],
    ));
    for words in [
        "gear, 27 teeth, module 4.5 mm, β 21° right",
        "M_dK, two balls 9 mm",
        "M_dR, two lying pins 9 mm  147.311166",
        "thickness s_n, normal",
        "Span: along the normal",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let table = std::fs::read_to_string(folder.path().join("out/gauge_gear.csv"));
    assert!(table.unwrap().contains(",147.3111662"));
    let again = stdout(&mut gauge(
        folder.path(),
        &["out/gauge_gear.toml", "--pin", "9"],
    ));
    assert!(
        again.contains("M_dR, two lying pins 9 mm  147.311166"),
        "{again}"
    );
    let csv = stdout(&mut gauge(folder.path(), &["one.toml", "--format", "csv"]));
    assert!(
        csv.lines().next().unwrap().contains(",over_lying_pins_mm,"),
        "{csv}"
    );

    let short = gauge(folder.path(), &["short.toml", "--span", "4"])
        .assert()
        .success();
    let message = String::from_utf8(short.get_output().stderr.clone()).unwrap();
    assert!(
        message.contains("gear.face_mm: a span over 4 teeth needs a face of 18.63 mm"),
        "{message}"
    );
}

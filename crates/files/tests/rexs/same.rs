//! Which pair files are those of a stage.

use super::*;
use gearlash_files::spec::PairSpec;

/// What is said of a pair file by a stage of the fixture.
fn is_of(stage: i32, change: impl Fn(&str) -> String) -> Result<(), String> {
    let file = read(&fixture("gearbox.rexs")).unwrap();
    let stage = file.stage(stage).unwrap();
    let text = change(&stage.pair.as_ref().unwrap().pair_file);
    stage.is_of(&spec(&text))
}

fn spec(text: &str) -> PairSpec {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pair.toml");
    std::fs::write(&path, text).unwrap();
    gearlash_files::read(&path).unwrap().spec
}

/// What is said of its own pair file in which `from` is `to`.
fn told(stage: i32, from: &str, to: &str) -> Result<(), String> {
    is_of(stage, |text| {
        assert!(text.contains(from), "{from}: {text}");
        text.replacen(from, to, 1)
    })
}

#[test]
fn a_pair_file_of_another_pair_is_reported_with_both_values() {
    // DIN 3967, d = 68 mm: 25c is −85/−125 µm. ISO 286: 78 js7 is ±15 µm.
    for (stage, from, to, expected) in [
        (
            10,
            "\"78 js7\"",
            "78.4",
            "has centre distance 77.985…78.015 mm, the pair file 78.4 mm",
        ),
        (
            10,
            "profile_shift = 0.0",
            "profile_shift = 0.1",
            "has profile shift 0 of the gear of 17 teeth, the pair file 0.1",
        ),
        (
            10,
            "designation = \"25c\"",
            "designation = \"22e\"",
            "has thickness 25c (−85.0 / −125.0 µm) of the gear of 17 teeth, the pair file 22e (",
        ),
        (
            10,
            "designation = \"25c\"",
            "allowance_um = -60.0",
            "has thickness 25c (−85.0 / −125.0 µm) of the gear of 17 teeth, the pair file −60.0 / −60.0 µm",
        ),
        (
            20,
            "teeth = 20",
            "teeth = 21",
            "has 20/40 teeth, m 1, the pair file 21/40 teeth, m 1",
        ),
    ] {
        let found = told(stage, from, to).unwrap_err();
        assert!(found.starts_with(expected), "{expected}: {found}");
    }
}

#[test]
fn another_pressure_angle_is_reported() {
    let found = is_of(20, |text| {
        text.replace("pressure_angle_deg = 20.0", "pressure_angle_deg = 19.0")
    })
    .unwrap_err();
    assert_eq!(
        found,
        "has pressure angle 20° of the gear of 20 teeth, the pair file 19°"
    );
}

#[test]
fn a_pair_file_within_the_tolerances_is_that_of_the_stage() {
    for (stage, from, to) in [
        (10, "", ""),
        (20, "", ""),
        (10, "\"78 js7\"", "78.01"),
        (10, "designation = \"25c\"", "allowance_um = -100.0"),
    ] {
        assert_eq!(told(stage, from, to), Ok(()), "{stage}, {from}: {to}");
    }
    for stage in [10, 20] {
        assert_eq!(turned(stage), Ok(()));
    }
}

/// Of its own with wheel and pinion exchanged.
fn turned(stage: i32) -> Result<(), String> {
    is_of(stage, |text| {
        let text = text.replace("[wheel]", "[other]");
        let text = text.replace("[pinion]", "[wheel]");
        text.replace("[other]", "[pinion]")
    })
}

#[test]
fn a_stage_that_is_left_out_has_no_pair_file() {
    let text = fixture("gearbox.rexs").replacen(">78.0<", ">78,0<", 1);
    let file = read(&text).unwrap();
    let other = read(&fixture("gearbox.rexs")).unwrap();
    let pair = other.stage(10).unwrap().pair.as_ref().unwrap();
    let spec = spec(&pair.pair_file);
    let told = |stage: i32| file.stage(stage).unwrap().is_of(&spec).unwrap_err();
    assert!(told(10).starts_with("is left out: cylindrical_stage 10, center_distance = 78,0"));
    assert!(told(30).starts_with(
        "is left out: the flanks of cylindrical_gear 31 have no normal_pressure_angle"
    ));
    assert!(
        told(44).starts_with("has no two external cylindrical gears: ring_gear 43 is internal")
    );
    assert!(told(20).starts_with("has 20/40 teeth, m 1, the pair file 17/22 teeth, m 4"));
}

//! `gearlash match`.

use super::*;
use std::fs;
use std::path::Path;

/// A gear file of 44 teeth, its thickness less by `less_um`, with a runout `F_r`, its high tooth 7.
fn gear(folder: &Path, name: &str, less_um: f64, runout_um: f64) {
    fs::create_dir_all(folder).unwrap();
    let text = format!(
        "[gear]\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = {}\nrunout.total_um = {runout_um}\nrunout.high_tooth = 7\n",
        -less_um
    );
    fs::write(folder.join(name), text).unwrap();
}

fn pair(folder: &Path, require: &str) {
    let gear =
        "teeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\n";
    let text = format!(
        "title = \"rig\"\n[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.0\n{require}"
    );
    fs::write(folder.join("pair.toml"), text).unwrap();
}

fn matched(folder: &Path) -> assert_cmd::assert::Assert {
    let words = [
        "match",
        "pair.toml",
        "--wheels",
        "w",
        "--pinions",
        "p",
        "-o",
        "out",
    ];
    gearlash(folder).args(words).assert()
}

/// At the reference centre distance perfect gears have the backlash that their teeth are thinner: 40 + 80 µm of a thick and a thin one.
#[test]
fn thick_teeth_go_with_thin_ones() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for kind in ["w", "p"] {
        gear(&here.join(kind), "thick.toml", 40.0, 0.0);
        gear(&here.join(kind), "thin.toml", 80.0, 0.0);
    }
    pair(here, "[require]\nj_wt_um = { min = 115, max = 125 }\n");
    matched(here).success().stdout(predicates::str::starts_with(
        "2 of 2 pairs keep 115 … 125 µm; to be expected 1.0 at random, 2.0 with 2 thickness classes.",
    ));
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(here.join("out/match.json")).unwrap()).unwrap();
    let names: Vec<[&str; 2]> = json["pairs"]
        .as_array()
        .unwrap()
        .iter()
        .map(|pair| ["wheel", "pinion"].map(|kind| pair[kind].as_str().unwrap()))
        .collect();
    assert_eq!(names, [["thick", "thin"], ["thin", "thick"]]);
    for pair in json["pairs"].as_array().unwrap() {
        for end in ["least_um", "greatest_um"] {
            assert!((pair[end].as_f64().unwrap() - 120.0).abs() < 1e-3, "{pair}");
        }
    }
}

/// Two eccentric gears of one number of teeth have, with their high places together, twice the spread; marked, none but that of rounding:
/// the backlash of their phase is what `simulate` finds where the teeth that are marked meet.
#[test]
fn marked_teeth_have_the_backlash_that_simulate_finds() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for kind in ["w", "p"] {
        gear(&here.join(kind), "one.toml", 60.0, 30.0);
    }
    pair(here, "[require]\nj_wt_um = { min = 110 }\n");
    matched(here).success();
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(here.join("out/match.json")).unwrap()).unwrap();
    let found = &json["pairs"][0];
    let gear = |start: &str| {
        format!(
            "{start}\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\nrunout.total_um = 30\nrunout.high_tooth = 7\n"
        )
    };
    let text = format!(
        "{}{}[assembly]\ncenter_distance_mm = 132.0\n[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 8\nstart = [1, {}]\n",
        gear("[wheel]"),
        gear("[pinion]"),
        found["pinion_tooth"]
    );
    fs::write(here.join("phase.toml"), text).unwrap();
    let output = gearlash(here)
        .args(["simulate", "phase.toml", "--no-files", "--format", "json"])
        .output()
        .unwrap();
    let simulated: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let extremes = &simulated["extremes"][0];
    for (end, at) in [("least", 0), ("greatest", 1)] {
        let bracket = extremes[end]["j_wt_um"][at].as_f64().unwrap();
        let here = found[format!("{end}_um")].as_f64().unwrap();
        assert!((bracket - here).abs() < 2e-3, "{end}: {bracket} {here}");
    }
    // All phases together spread by twice both runouts' share; the marked one by less than a tenth.
    let spread = found["greatest_um"].as_f64().unwrap() - found["least_um"].as_f64().unwrap();
    assert!(spread < 3.0, "{spread}");
}

/// All that is wrong is told at once, and nothing is written.
#[test]
fn what_cannot_be_matched_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    gear(&here.join("w"), "good.toml", 40.0, 0.0);
    fs::write(here.join("w/bad.toml"), "[gear]\nteeth = 44\n").unwrap();
    fs::write(
        here.join("w/other.toml"),
        "[gear]\nteeth = 43\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n",
    )
    .unwrap();
    fs::create_dir_all(here.join("p")).unwrap();
    pair(here, "");
    matched(here)
        .code(2)
        .stderr(predicates::str::contains("bad.toml: gear.module_mm"))
        .stderr(predicates::str::contains(
            "other.toml: 43 teeth, the pair file's wheel has 44",
        ))
        .stderr(predicates::str::contains("p: holds no gear file"));
    assert!(!here.join("out").exists());
}

/// A gear without a mate is left over: exit code 1.
#[test]
fn a_gear_without_a_mate_is_left_over() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    gear(&here.join("w"), "thick.toml", 40.0, 0.0);
    gear(&here.join("w"), "fat.toml", -300.0, 0.0);
    gear(&here.join("p"), "a.toml", 40.0, 0.0);
    gear(&here.join("p"), "b.toml", 40.0, 0.0);
    pair(here, "");
    matched(here)
        .code(1)
        .stdout(predicates::str::starts_with("1 of 2 pairs assemble"))
        .stdout(predicates::str::contains("Wheels left over: fat."));
}

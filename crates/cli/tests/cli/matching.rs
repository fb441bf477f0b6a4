//! `gearlash match`.

use super::*;
use std::fs;
use std::path::Path;

/// The command of the folders `w` and `p`.
pub(super) const MATCH: &str = "match pair.toml --wheels w --pinions p";

/// A gear file of 44 teeth, its thickness less by `less_um`, with a runout `F_r`, its high tooth 7.
pub(super) fn gear(folder: &Path, name: &str, less_um: f64, runout_um: f64) {
    fs::create_dir_all(folder).unwrap();
    let text = format!(
        "[gear]\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = {}\nrunout.total_um = {runout_um}\nrunout.high_tooth = 7\n",
        -less_um
    );
    fs::write(folder.join(name), text).unwrap();
}

pub(super) fn pair(folder: &Path, require: &str) {
    let gear =
        "teeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\n";
    let text = format!(
        "title = \"rig\"\n[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.0\n{require}"
    );
    fs::write(folder.join("pair.toml"), text).unwrap();
}

pub(super) fn matched(folder: &Path) -> assert_cmd::assert::Assert {
    let mut command = gearlash(folder);
    command.args(MATCH.split(' ')).args(["-o", "out"]).assert()
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

/// A gear whose reference face is at the back has its teeth numbered the other way, what was right on it is left: matched so it is the gear
/// with its sheet turned over by hand, tooth `t` being tooth `22 - t` of 20, and a place along ascending numbers one against them.
#[test]
fn a_gear_seen_from_behind_is_its_sheet_turned_over() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let basic = "teeth = 20\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n";
    let sheet = |tooth: f64, right: &[f64], left: &[f64]| {
        format!(
            "[gear]\n{basic}thickness.allowance_um = -60\nrunout = {{ total_um = 30, high_tooth = {tooth} }}\n\
             pitch = {{ kind = \"cumulative\", right_um = {right:?}, left_um = {left:?} }}\n"
        )
    };
    let wave = |lag: f64| -> Vec<f64> {
        (0..20)
            .map(|k| (8.0 * (0.3 * f64::from(k * k) + lag).sin()).round())
            .collect()
    };
    let (right, left) = (wave(0.0), wave(1.0));
    let turned = |list: &[f64]| -> Vec<f64> { (0..20).map(|k| -list[(20 - k) % 20]).collect() };
    for kind in ["w", "asis", "turned"] {
        fs::create_dir_all(here.join(kind)).unwrap();
    }
    fs::write(here.join("w/1.toml"), sheet(4.0, &left, &right)).unwrap();
    fs::write(here.join("asis/1.toml"), sheet(7.0, &right, &left)).unwrap();
    let over = sheet(15.0, &turned(&left), &turned(&right));
    fs::write(here.join("turned/1.toml"), over).unwrap();
    let matched = |pinions: &str, face: &str| -> serde_json::Value {
        let text = format!(
            "[wheel]\n{basic}[pinion]\n{basic}reference_face = \"{face}\"\n[assembly]\ncenter_distance_mm = 60.0\n[require]\nj_wt_um.min = 0\n"
        );
        fs::write(here.join("pair.toml"), text).unwrap();
        let words = ["match", "pair.toml", "--wheels", "w", "--pinions", pinions];
        let output = gearlash(here)
            .args(words)
            .args(["--format", "json", "-o", "out"])
            .output()
            .unwrap();
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        json["pairs"][0].clone()
    };
    let (behind, by_hand) = (matched("asis", "back"), matched("turned", "front"));
    for end in ["least_um", "greatest_um"] {
        let ends = [&behind, &by_hand].map(|pair| pair[end].as_f64().unwrap());
        assert!((ends[0] - ends[1]).abs() < 1e-3, "{end}: {ends:?}");
    }
    let tooth = |pair: &serde_json::Value| pair["pinion_tooth"].as_u64().unwrap();
    assert_eq!(tooth(&behind), (21 - tooth(&by_hand)) % 20 + 1);
    assert_ne!(matched("asis", "front")["least_um"], behind["least_um"]);
}

/// On any number of threads, printed and written.
#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for (kind, count) in [("w", 5u32), ("p", 4)] {
        for k in 0..count {
            let (less, runout) = (40.0 + 9.0 * f64::from(k), 7.0 * f64::from(k % 3));
            gear(&here.join(kind), &format!("g{k}.toml"), less, runout);
        }
    }
    pair(here, "[require]\nj_wt_um = { min = 100, max = 130 }\n");
    let on = |threads: &str| {
        let mut command = gearlash(here);
        command.env("RAYON_NUM_THREADS", threads);
        command
            .args(MATCH.split(' '))
            .args(["-o", "out", "--format", "json"]);
        let printed = command.output().unwrap().stdout;
        assert_eq!(printed, fs::read(here.join("out/match.json")).unwrap());
        ["match.json", "matrix.csv", "match.svg"]
            .map(|name| fs::read(here.join("out").join(name)).unwrap())
    };
    let wanted = on("1");
    assert!(on("2") == wanted && on("7") == wanted);
}

//! An as-built pair, gauged, its tables fed back: the same lost motion.

use super::*;
use assert_cmd::Command;
use gearlash::input;
use gearlash::mesh::Method;
use gearlash::simulate::simulate;
use gearlash::study::Study;
use std::path::Path;

fn um_list(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|mm| format!("{:?}", mm * 1e3)).collect();
    format!("[{}]", values.join(", "))
}

/// `[name]` with pitch of both flanks, zero-mean thickness by tooth, and eccentricity.
fn table(name: &str, teeth: u32, face: &str, seed: u64) -> String {
    let list = |n, by| um_list(&scaled(&made_up(teeth, seed + n), by));
    format!(
        "[{name}]\nteeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nprofile_shift = 0.05\nreference_face = \"{face}\"\n\
         [{name}.thickness]\nallowance_um = -35.0\nper_tooth_um = {}\n\
         [{name}.runout]\ntotal_um = 31.7\nhigh_tooth = 7.3\n\
         [{name}.pitch]\nkind = \"cumulative\"\nright_um = {}\nleft_um = {}\n",
        list(0, 6e-3),
        list(1, 11e-3),
        list(2, 9e-3)
    )
}

const ASSEMBLY: &str = "[assembly]\ncenter_distance_mm = [97.9, 97.75]\n[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 16\n";

fn backlash(study: &Study) -> Vec<f64> {
    let go_on = || ControlFlow::Continue(());
    let runs = simulate(study, Method::Exact { certify: false }, &go_on).unwrap();
    let poses = runs.iter().flat_map(|run| &run.poses);
    poses.map(|pose| pose.backlash.unwrap()).collect()
}

/// A written gear file as the table `[name]` of a pair file.
fn as_table(folder: &Path, name: &str) -> String {
    let text = std::fs::read_to_string(folder.join(format!("out/gauge_{name}.toml"))).unwrap();
    let from = text.find("[gear]").unwrap();
    text[from..].replace("[gear", &format!("[{name}"))
}

/// Issue 5: the same within 1e-4 µm at every pose. Inside interference as well as outside.
#[test]
fn what_was_gauged_simulates_alike() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    let pair = [
        table("wheel", 44, "front", 1),
        table("pinion", 21, "back", 11),
        ASSEMBLY.to_owned(),
    ];
    std::fs::write(&file, pair.concat()).unwrap();
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder.path());
    command
        .args(["gauge", "pair.toml", "-o", "out", "--steps-per-pitch", "1"])
        .assert()
        .success();

    let back = [
        as_table(folder.path(), "wheel"),
        as_table(folder.path(), "pinion"),
        ASSEMBLY.to_owned(),
    ];
    // Beside the readings it names.
    let again = folder.path().join("out/again.toml");
    std::fs::write(&again, back.concat()).unwrap();
    let (before, after) = (input::read(&file).unwrap(), input::read(&again).unwrap());
    let (before, after) = (backlash(&before), backlash(&after));
    assert_eq!(before.len(), 2 * 16 * 44);
    assert!(before.iter().any(|j_wt| *j_wt < 0.0) && before.iter().any(|j_wt| *j_wt > 0.0));
    let off = before.iter().zip(&after).map(|(a, b)| (a - b).abs());
    let off_um = 1e3 * off.fold(0.0, f64::max);
    assert!(off_um < 1e-4, "{off_um} µm");
    // It is bounded by the gauge, not by luck: picometres.
    assert!(off_um < 1e-6, "{off_um} µm");
}

/// A gear file is read by itself, and reads the same again.
#[test]
fn a_gauged_gear_gauges_alike() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("one.toml");
    std::fs::write(&file, table("gear", 21, "back", 5)).unwrap();
    let gauge = |file: &str, out: &str| {
        let mut command = Command::cargo_bin("gearlash").unwrap();
        command.current_dir(folder.path());
        command
            .args(["gauge", file, "-o", out, "--steps-per-pitch", "1"])
            .assert()
            .success();
        let csv = |name: &str| -> Vec<f64> {
            let path = folder
                .path()
                .join(out)
                .join(format!("gauge_gear_{name}.csv"));
            let mut reader = csv::Reader::from_path(path).unwrap();
            let rows = reader.records().map(|row| row.unwrap());
            rows.flat_map(|row| row.iter().map(|v| v.parse().unwrap()).collect::<Vec<f64>>())
                .collect()
        };
        [
            "spans",
            "pins",
            "three_pins",
            "runout",
            "pitch_own",
            "pitch_datum",
            "thickness",
        ]
        .map(csv)
    };
    let before = gauge("one.toml", "first");
    let after = gauge("first/gauge_gear.toml", "second");
    for (before, after) in before.iter().zip(&after) {
        assert!(before.len() >= 2 * 21);
        for (a, b) in before.iter().zip(after) {
            // mm or µm: 1e-6 µm is the coarser.
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
    }
}

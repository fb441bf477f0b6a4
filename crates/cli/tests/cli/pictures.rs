//! `gearlash snapshot`: the worst pose, exaggerated deviations, turning gears, from the command line.

use assert_cmd::Command;
use predicates::prelude::*;
use std::path::Path;
use tempfile::TempDir;

/// The first of several equal poses counts, as perfect gears have mirrored ones.
///
/// Issue 4: 86/21, m 3, nominal, 24 phases of a pitch, at a = 160.2 the worst has −238.948 µm.
fn pair_file(folder: &Path) -> String {
    let fractions: Vec<String> = (0..24)
        .map(|i| format!("{:?}", f64::from(i) / 24.0))
        .collect();
    let gear = |name: &str, teeth: u32| {
        format!("[{name}]\nteeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n")
    };
    let text = format!(
        "{}{}[assembly]\ncenter_distance_mm = [160.2, 160.3]\n[sweep]\nmating = [[1, 1]]\nfraction = [{}]\n",
        gear("wheel", 86),
        gear("pinion", 21),
        fractions.join(", ")
    );
    let file = folder.join("pair.toml");
    std::fs::write(&file, text).unwrap();
    file.to_str().unwrap().to_owned()
}

fn snapshot(folder: &TempDir, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command
        .current_dir(folder.path())
        .arg("snapshot")
        .args(arguments);
    command
}

#[test]
fn the_worst_pose_is_found_and_named() {
    let folder = TempDir::new().unwrap();
    let pair = pair_file(folder.path());
    snapshot(&folder, &[&pair, "--worst"])
        .assert()
        .success()
        .stdout("out/pair/worst_a160.2_as-measured.svg\n")
        // The least of the 24 phases of the file is −238.948; between them it falls a little lower.
        .stderr(predicate::str::contains(
            "Does not assemble at both distances.",
        ))
        .stderr(predicate::str::contains("  least      −238.96 µm "));
    let svg = std::fs::read_to_string(folder.path().join("out/pair/worst_a160.2_as-measured.svg"));
    let svg = svg.unwrap();
    assert!(svg.contains(" tip on pinion ") && svg.contains(" fillet<"));
    // At 160.3 nothing is lost.
    snapshot(
        &folder,
        &[&pair, "--worst", "--center-distance", "160.3", "-o", "-"],
    )
    .assert()
    .success()
    .stderr(predicate::str::contains(
        "Does not assemble at a = 160.300 mm.",
    ))
    .stderr(predicate::str::contains(
        "  constant   −144.72 µm   every pose",
    ));
    // Any jam is worse than any overlap.
    snapshot(
        &folder,
        &[&pair, "--worst", "--center-distance", "158", "-o", "-"],
    )
    .assert()
    .success()
    .stderr(predicate::str::contains("Jammed at a = 158.000 mm"));
}

#[test]
fn pictures_of_one_pose() {
    let folder = TempDir::new().unwrap();
    let rig = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../fixtures/karba_44x44.toml"
    );
    let pose = [rig, "--mating", "11,11", "--flank", "left", "-o", "-"];
    snapshot(&folder, &[&pose[..], &["--exaggerate", "200"]].concat())
        .assert()
        .success()
        .stdout(predicate::str::contains("deviations × 200: not to scale"));
    snapshot(&folder, &[&pose[..], &["--animate"]].concat())
        .assert()
        .success()
        .stdout(predicate::str::contains("<animateTransform"));
}

/// The pair of issue 14: the pinion of 8 teeth is undercut, and its edge touches for a part of the pitch.
fn undercut(folder: &Path, steps: &str) -> String {
    let gear = |name: &str, teeth: u32| {
        format!(
            "[{name}]\nteeth = {teeth}\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nthickness = {{ allowance_um = -60 }}\n"
        )
    };
    let rest = format!(
        "[assembly]\ncenter_distance_mm = 32.0\n[sweep]\nmating = [[1, 1]]\nfraction = [{steps}]\n"
    );
    let file = folder.join("undercut.toml");
    std::fs::write(&file, gear("wheel", 24) + &gear("pinion", 8) + &rest).unwrap();
    file.to_str().unwrap().to_owned()
}

/// Words of an SVG without its marks.
fn words(svg: &[u8]) -> String {
    let svg = String::from_utf8(svg.to_vec()).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let texts = document.descendants().filter(|node| node.is_text());
    let words: String = texts.filter_map(|node| node.text()).collect();
    words
}

/// The headline told the first frame's backlash while the dot moved, and no frame stood at the extreme. Expected: the
/// greatest of 4001 poses of the same pitch, by `simulate`.
#[test]
fn an_animation_states_the_extremes_of_what_it_shows() {
    let folder = TempDir::new().unwrap();
    let steps: Vec<String> = (0..=4000)
        .map(|i| format!("{:?}", f64::from(i) / 4000.0))
        .collect();
    let pair = undercut(folder.path(), &steps.join(", "));
    let mut simulate = Command::cargo_bin("gearlash").unwrap();
    let simulate = simulate
        .args(["simulate", &pair, "--format", "json"])
        .assert();
    let result: serde_json::Value = serde_json::from_slice(&simulate.get_output().stdout).unwrap();
    let poses = result["runs"][0]["poses"].as_array().unwrap().iter();
    let greatest = poses
        .filter_map(|pose| pose["j_wt_um"].as_f64())
        .fold(0.0, f64::max);
    let pose = [
        &*pair,
        "--mating",
        "1,1",
        "--flank",
        "right",
        "--animate",
        "-o",
        "-",
    ];
    let drawn = snapshot(&folder, &pose).assert().success();
    let words = words(&drawn.get_output().stdout);
    let (_, message) = words.split_once("greatest ").unwrap();
    let (message, _) = message.split_once(" µm").unwrap();
    let message: f64 = message.parse().unwrap();
    // Half a digit, and no lower than what 4001 poses find.
    assert!(
        message > greatest - 0.005 && message < greatest + 0.02,
        "{message} {greatest}"
    );
    assert!(words.contains("least\u{a0}jwt120.00 µm"), "{words}");
}

/// A snapshot said “involute on involute” where `simulate` says undercut-edge.
#[test]
fn a_snapshot_names_the_undercut_edge() {
    let folder = TempDir::new().unwrap();
    let pair = undercut(folder.path(), "0.6875");
    let pose = [
        &*pair,
        "--mating",
        "1,1",
        "--flank",
        "right",
        "--fraction",
        "0.6875",
        "-o",
        "-",
    ];
    let drawn = snapshot(&folder, &pose).assert().success();
    let words = words(&drawn.get_output().stdout);
    assert!(
        words.contains("wheel 2 involute on pinion 8 undercut edge"),
        "{words}"
    );
    assert!(words.contains("wheel 1 with pinion 1 at the right flank, 0.6875 pitch beyond"));
}

#[test]
fn what_does_not_go_together_ends_with_2() {
    let folder = TempDir::new().unwrap();
    let pair = pair_file(folder.path());
    let pins = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../fixtures/karba_86x21.toml"
    );
    let rig = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../fixtures/karba_44x44.toml"
    );
    for (arguments, says) in [
        (vec![&*pair], "--worst"),
        (vec![&*pair, "--mating", "1,1"], "--flank"),
        (vec![&*pair, "--worst", "--mating", "1,1"], "--mating"),
        (vec![&*pair, "--worst", "--flank", "left"], "--flank"),
        (vec![&*pair, "--worst", "--fraction", "0.5"], "--fraction"),
        (vec![&*pair, "--worst", "--material", "most"], "--material"),
        (
            vec![&*pair, "--worst", "--center-distance", "100"],
            "base circles",
        ),
        (
            vec![&*pair, "--worst", "--center-distance", "170"],
            "in mesh",
        ),
        (
            vec![&*pair, "--worst", "--animate", "--exaggerate", "9"],
            "--exaggerate",
        ),
        (vec![&*pair, "--worst", "--exaggerate", "0"], "between 1"),
        (vec![&*pair, "--worst", "--exaggerate", "nan"], "between 1"),
        (vec![pins, "--worst", "--exaggerate", "1000"], "50 would do"),
        (
            vec![rig, "--worst", "--center-distance", "132.5"],
            "[measured]",
        ),
    ] {
        snapshot(&folder, &arguments)
            .assert()
            .code(2)
            .stderr(predicate::str::contains(says));
    }
    assert!(!folder.path().join("out").exists());
}

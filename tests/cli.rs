//! The built binary, as a user and as a script runs it.

use assert_cmd::Command;
use predicates::prelude::*;
use serde_json::Value;
use std::path::{Path, PathBuf};

fn gearlash(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder);
    command
}

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("fixtures")
        .join(name)
}

fn output(command: &mut Command) -> String {
    String::from_utf8(command.assert().success().get_output().stdout.clone()).unwrap()
}

/// A small pair that runs in no time: eccentric pinion, pitch deviation, two materials.
const SMALL: &str = r#"
title = "small"
[wheel]
teeth = 20
module_mm = 2.0
pressure_angle_deg = 20.0
[wheel.thickness]
allowance_um = { min = -60.0, max = -40.0 }
[wheel.runout]
total_um = 12.0
high_tooth = 3.5
[pinion]
teeth = 17
module_mm = 2.0
pressure_angle_deg = 20.0
profile_shift = 0.1
reference_face = "back"
[assembly]
center_distance_mm = [37.3, 37.35]
bearing_clearance_mm = 0.004
[sweep]
mating = [[1, 1], [7, 12]]
fraction = [0.0, 0.5]
"#;

fn small(folder: &Path) -> PathBuf {
    let file = folder.join("small.toml");
    std::fs::write(&file, SMALL).unwrap();
    file
}

/// What `simulate FILE --format json` prints, and the same parsed.
fn simulated(folder: &Path, arguments: &[&str]) -> (String, Value) {
    let text = output(
        gearlash(folder)
            .arg("simulate")
            .args(arguments)
            .args(["--format", "json"]),
    );
    let result = serde_json::from_str(&text).unwrap();
    (text, result)
}

fn empty_folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

fn files(folder: &Path) -> Vec<String> {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn help_names_every_command_and_the_exit_codes() {
    let folder = empty_folder();
    let help = output(gearlash(folder.path()).arg("--help"));
    for word in [
        "simulate",
        "compare",
        "check",
        "snapshot",
        "chart",
        "Exit codes",
        "Example",
    ] {
        assert!(help.contains(word), "{word} in {help}");
    }
    for command in ["simulate", "compare", "check", "snapshot", "chart"] {
        let help = output(gearlash(folder.path()).args([command, "--help"]));
        assert!(help.contains("pair file"), "{help}");
    }
}

#[test]
fn the_main_job_prints_tables_5_and_6() {
    let folder = empty_folder();
    let text = output(
        gearlash(folder.path())
            .arg("simulate")
            .arg(fixture("karba_44x44.toml")),
    );
    assert!(text.contains(
        "63 of 72 measured values lie inside the predicted band: 9 below it (↓), 0 above it (↑)."
    ));
    assert!(text.contains("72 of 72 lie inside the simulated band"));
    insta::assert_snapshot!("karba_44x44", text);
    let written = files(&folder.path().join("out/karba_44x44"));
    // Five centre distances, two materials, least and greatest pose; JSON and CSV.
    assert_eq!(written.len(), 5 * 2 * 2 + 2, "{written:?}");
    for name in written.iter().filter(|name| name.ends_with(".svg")) {
        let svg =
            std::fs::read_to_string(folder.path().join("out/karba_44x44").join(name)).unwrap();
        roxmltree::Document::parse(&svg).unwrap();
    }
}

#[test]
fn table_2_as_text() {
    let folder = empty_folder();
    let text = output(
        gearlash(folder.path())
            .arg("simulate")
            .arg(fixture("karba_86x21.toml")),
    );
    insta::assert_snapshot!("karba_86x21", text);
}

#[test]
fn json_goes_to_standard_output_alone_and_writes_nothing() {
    let folder = empty_folder();
    small(folder.path());
    let (_, result) = simulated(folder.path(), &["small.toml"]);
    assert_eq!(result["gearlash"], env!("CARGO_PKG_VERSION"));
    // Two centre distances and two materials; two matings, two flanks, two fractions.
    assert_eq!(result["runs"].as_array().unwrap().len(), 4);
    assert_eq!(result["runs"][0]["poses"].as_array().unwrap().len(), 8);
    assert_eq!(files(folder.path()), ["small.toml"]);
    insta::assert_snapshot!("small_json", rounded(&result));
}

/// Pretty JSON with every number to 9 significant digits: the last bits are the mathematics library's.
fn rounded(value: &Value) -> String {
    fn round(value: &mut Value) {
        match value {
            Value::Number(number) if number.is_f64() => {
                let short: f64 = format!("{:.8e}", number.as_f64().unwrap()).parse().unwrap();
                *value = Value::from(short);
            }
            Value::Array(values) => values.iter_mut().for_each(round),
            Value::Object(map) => map.values_mut().for_each(round),
            _ => {}
        }
    }
    let mut value = value.clone();
    round(&mut value);
    serde_json::to_string_pretty(&value).unwrap()
}

#[test]
fn csv_has_a_row_a_pose() {
    let folder = empty_folder();
    small(folder.path());
    let (_, result) = simulated(folder.path(), &["small.toml"]);
    for run in result["runs"].as_array().unwrap() {
        let a = run["center_distance_mm"].as_f64().unwrap();
        for pose in run["poses"].as_array().unwrap() {
            let number = |key: &str| pose[key].as_f64().unwrap();
            let phi = number("lost_motion_rad");
            assert!((number("left_rad") - number("right_rad") - phi).abs() < 1e-15);
            assert!((-std::f64::consts::PI..=std::f64::consts::PI).contains(&number("right_rad")));
            let reference = 17.0; // m z / 2 of the pinion
            assert!((number("j_t_um") - phi * reference * 1e3).abs() < 1e-9);
            let base = reference * 20f64.to_radians().cos();
            assert!((number("j_bn_um") - phi * base * 1e3).abs() < 1e-9);
            // r_w2 = a z_2/(z_1 + z_2).
            assert!((number("j_wt_um") - phi * a * 17.0 / 37.0 * 1e3).abs() < 1e-9);
            let range = pose["j_wt_range_um"].as_array().unwrap();
            assert!(range[0].as_f64().unwrap() < number("j_wt_um"));
            assert!(range[1].as_f64().unwrap() > number("j_wt_um"));
        }
    }
}

#[test]
fn the_same_bytes_on_one_and_on_many_threads() {
    let folder = empty_folder();
    let file = small(folder.path());
    let with = |threads: &str| {
        output(
            gearlash(folder.path())
                .env("RAYON_NUM_THREADS", threads)
                .arg("simulate")
                .arg(&file)
                .args(["--format", "json"]),
        )
    };
    assert_eq!(with("1"), with("7"));
}

#[test]
fn compare_agrees_on_both_fixtures() {
    let folder = empty_folder();
    let pairs = [fixture("karba_44x44.toml"), fixture("karba_86x21.toml")];
    gearlash(folder.path())
        .arg("compare")
        .args(&pairs)
        .assert()
        .code(0)
        .stdout(predicate::str::contains("agree within 0.1 µm + error bound").count(2));
    assert!(files(folder.path()).is_empty());
}

/// The study's 86/21 pair at nominal thickness and 0.15 m tip clearance: the wheel's tips stand on the pinion's
/// fillets (issue 4 gives −216.426 by formula and −238.948 µm measured at the worst pose). The formula is wrong about it.
const ON_THE_FILLET: &str = r#"
[wheel]
teeth = 86
module_mm = 3.0
pressure_angle_deg = 20.0
[pinion]
teeth = 21
module_mm = 3.0
pressure_angle_deg = 20.0
reference_face = "back"
[assembly]
center_distance_mm = 160.2
[sweep]
mating = [[1, 1]]
fraction = [0.0, 0.25, 0.5, 0.75]
"#;

#[test]
fn compare_fails_on_contact_off_the_line_unless_allowed() {
    let folder = empty_folder();
    let file = folder.path().join("fillet.toml");
    std::fs::write(&file, ON_THE_FILLET).unwrap();
    gearlash(folder.path())
        .args(["compare", "fillet.toml"])
        .assert()
        .code(1)
        .stdout(predicate::str::contains("off-line contact"));
    std::fs::write(
        &file,
        format!("{ON_THE_FILLET}[compare]\nallow_off_line_contact = true\n"),
    )
    .unwrap();
    gearlash(folder.path())
        .args(["compare", "fillet.toml"])
        .assert()
        .code(0)
        .stdout(predicate::str::contains("allowed by the pair file"));
}

#[test]
fn compare_speaks_json_junit_and_github() {
    let folder = empty_folder();
    std::fs::write(folder.path().join("fillet.toml"), ON_THE_FILLET).unwrap();
    small(folder.path());
    let run = |format: &str| {
        let assert = gearlash(folder.path())
            .args(["compare", "small.toml", "fillet.toml", "--format", format])
            .assert()
            .code(1);
        String::from_utf8(assert.get_output().stdout.clone()).unwrap()
    };
    let json: Value = serde_json::from_str(&run("json")).unwrap();
    assert_eq!(json["passed"], false);
    assert_eq!(json["pairs"][0]["passed"], true);
    assert_eq!(json["pairs"][1]["passed"], false);
    let junit = run("junit");
    let document = roxmltree::Document::parse(&junit).unwrap();
    let count = |name: &str| {
        document
            .descendants()
            .filter(|node| node.has_tag_name(name))
            .count()
    };
    assert_eq!(
        (count("testsuite"), count("testcase"), count("failure")),
        (2, 5, 1)
    );
    let github = run("github");
    assert!(github.contains("::notice file=small.toml,title=gearlash compare::"));
    assert!(github.contains(
        "::error file=fillet.toml,title=gearlash compare%3A a = 160.200 mm%2C as-measured::"
    ));
}

#[test]
fn a_tolerance_on_the_command_line_wins() {
    let folder = empty_folder();
    std::fs::write(folder.path().join("fillet.toml"), ON_THE_FILLET).unwrap();
    gearlash(folder.path())
        .args(["compare", "fillet.toml", "--tolerance-um", "100"])
        .assert()
        .code(0);
    gearlash(folder.path())
        .args(["compare", "fillet.toml", "--tolerance-um", "-1"])
        .assert()
        .code(2);
}

#[test]
fn snapshot_of_a_named_mating() {
    let folder = empty_folder();
    let draw = |extra: &[&str]| {
        let mut command = gearlash(folder.path());
        command.arg("snapshot").arg(fixture("karba_44x44.toml"));
        output(
            command
                .args(["--mating", "11,11", "--flank", "right"])
                .args(extra),
        )
    };
    let printed = draw(&[]);
    let svg = std::fs::read_to_string(folder.path().join(printed.trim())).unwrap();
    roxmltree::Document::parse(&svg).unwrap();
    for words in ["Test rig pair 44/44", "132.210", "right", "11"] {
        assert!(svg.contains(words), "{words}");
    }
    // To a file of one's own, and to standard output.
    draw(&["-o", "mine.svg"]);
    assert_eq!(
        std::fs::read_to_string(folder.path().join("mine.svg")).unwrap(),
        svg
    );
    assert_eq!(draw(&["-o", "-"]), svg);
    assert_ne!(
        draw(&[
            "-o",
            "-",
            "--material",
            "least",
            "--center-distance",
            "132.04"
        ]),
        svg
    );
}

#[test]
fn bad_usage_ends_with_2_and_writes_nothing() {
    let folder = empty_folder();
    let pair = fixture("karba_86x21.toml");
    let pair = pair.to_str().unwrap();
    for (arguments, says) in [
        (
            vec!["snapshot", pair, "--mating", "87,1", "--flank", "right"],
            "1 … 86",
        ),
        (
            vec!["snapshot", pair, "--mating", "1", "--flank", "right"],
            "wheel,pinion",
        ),
        (
            vec!["snapshot", pair, "--mating", "1,1", "--flank", "top"],
            "right",
        ),
        (
            vec![
                "snapshot",
                pair,
                "--mating",
                "1,1",
                "--flank",
                "left",
                "--material",
                "most",
            ],
            "--material",
        ),
        (
            vec![
                "snapshot",
                pair,
                "--mating",
                "1,1",
                "--flank",
                "left",
                "--center-distance",
                "100",
            ],
            "base circles",
        ),
        (
            vec![
                "snapshot",
                pair,
                "--mating",
                "1,1",
                "--flank",
                "left",
                "--fraction",
                "nan",
            ],
            "--fraction",
        ),
        (vec!["simulate", "nowhere.toml"], "nowhere.toml"),
        (vec!["simulate"], "PAIR"),
        (vec!["compare"], "PAIRS"),
        (vec!["measure"], "measure"),
    ] {
        gearlash(folder.path())
            .args(&arguments)
            .assert()
            .code(2)
            .stdout(predicate::str::is_empty())
            .stderr(predicate::str::contains(says));
        assert!(files(folder.path()).is_empty(), "{arguments:?}");
    }
}

#[test]
fn all_problems_of_a_file_come_at_once_and_nothing_is_written() {
    let folder = empty_folder();
    let bad = SMALL
        .replace("teeth = 20", "teeth = 2")
        .replace("total_um = 12.0", "totl_um = 12.0");
    std::fs::write(folder.path().join("bad.toml"), bad).unwrap();
    gearlash(folder.path())
        .args(["simulate", "bad.toml"])
        .assert()
        .code(2)
        .stdout(predicate::str::is_empty())
        .stderr(predicate::str::contains("wheel.teeth"))
        .stderr(predicate::str::contains("total_um"));
    assert_eq!(files(folder.path()), ["bad.toml"]);
}

/// Found out before the simulation: a file stands where the folder should be.
#[test]
fn an_output_folder_that_cannot_be_written() {
    let folder = empty_folder();
    small(folder.path());
    std::fs::write(folder.path().join("taken"), "mine").unwrap();
    gearlash(folder.path())
        .args(["simulate", "small.toml", "-o", "taken/results"])
        .assert()
        .code(2)
        .stdout(predicate::str::is_empty())
        .stderr(predicate::str::contains("cannot be written").and(predicate::str::contains("-o")));
    assert_eq!(
        std::fs::read_to_string(folder.path().join("taken")).unwrap(),
        "mine"
    );
    assert_eq!(files(folder.path()), ["small.toml", "taken"]);
}

/// A failed run leaves earlier results alone, and no empty folder of its own.
#[test]
fn a_failed_run_overwrites_nothing() {
    let folder = empty_folder();
    small(folder.path());
    output(gearlash(folder.path()).args(["simulate", "small.toml", "-o", "results"]));
    let before = std::fs::read_to_string(folder.path().join("results/result.json")).unwrap();
    std::fs::write(
        folder.path().join("small.toml"),
        SMALL.replace("teeth = 17", "teeth = -17"),
    )
    .unwrap();
    gearlash(folder.path())
        .args(["simulate", "small.toml", "-o", "results"])
        .assert()
        .code(2);
    let after = std::fs::read_to_string(folder.path().join("results/result.json")).unwrap();
    assert_eq!(before, after);
    gearlash(folder.path())
        .args(["simulate", "small.toml", "-o", "new/results"])
        .assert()
        .code(2);
    assert!(!folder.path().join("new").exists());
}

/// Tips in roots and gears out of mesh are results: null numbers, exit 0.
#[test]
fn jammed_and_out_of_mesh_are_results() {
    let folder = empty_folder();
    for (a, status) in [(158.0, "jammed"), (170.0, "no_contact")] {
        let text = ON_THE_FILLET
            .replace("160.2", &a.to_string())
            .replace("[0.0, 0.25, 0.5, 0.75]", "[0.0]");
        std::fs::write(folder.path().join("pair.toml"), text).unwrap();
        let text =
            output(gearlash(folder.path()).args(["simulate", "pair.toml", "--format", "json"]));
        let result: Value = serde_json::from_str(&text).unwrap();
        for pose in result["runs"][0]["poses"].as_array().unwrap() {
            assert_eq!(pose["status"], status, "at {a}");
            for key in [
                "right_rad",
                "left_rad",
                "lost_motion_rad",
                "j_wt_um",
                "j_t_um",
                "j_bn_um",
                "error_bound_um",
            ] {
                assert!(pose[key].is_null(), "{key} at {a}");
            }
        }
        output(gearlash(folder.path()).args(["simulate", "pair.toml"]));
    }
}

/// Issue 3: a scan over centre distance; without play the backlash rises by 2 tan α_wt a millimetre and more.
#[test]
fn a_scan_over_centre_distance() {
    let folder = empty_folder();
    small(folder.path());
    let mut command = gearlash(folder.path());
    command.args(["simulate", "small.toml", "--format", "json"]);
    let text = output(command.args(["--center-distance", "37.3..37.4:0.05"]));
    let result: Value = serde_json::from_str(&text).unwrap();
    let runs = result["runs"].as_array().unwrap();
    let distances: Vec<f64> = runs
        .iter()
        .map(|run| run["center_distance_mm"].as_f64().unwrap())
        .collect();
    assert_eq!(distances, [37.3, 37.3, 37.35, 37.35, 37.4, 37.4]);
    let least = |i: usize| runs[i]["summary"]["min_j_wt_um"].as_f64().unwrap();
    assert!(least(0) < least(2) && least(2) < least(4));
    assert_eq!(
        result["pair"]["assembly"]["center_distance_mm"],
        serde_json::json!([37.3, 37.35, 37.4])
    );
    // Measured rows have distances of their own; base circles must stay apart.
    gearlash(folder.path())
        .arg("simulate")
        .arg(fixture("karba_44x44.toml"))
        .args(["--center-distance", "132.0..132.1:0.1"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("--center-distance"));
    gearlash(folder.path())
        .args(["simulate", "small.toml", "--center-distance", "30..40:1"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("base circles"));
    assert_eq!(files(folder.path()), ["small.toml"]);
}

/// Issue 3: both methods on one study; the largest difference is printed and decides.
#[test]
fn both_methods_agree_to_a_picometre() {
    let folder = empty_folder();
    small(folder.path());
    for arguments in [
        vec!["simulate", "small.toml", "--format", "json"],
        vec!["compare", "small.toml"],
    ] {
        gearlash(folder.path())
            .args(arguments)
            .args(["--method", "both"])
            .assert()
            .code(0)
            .stderr(predicate::str::contains("exact and polygon method agree"));
    }
}

/// Design section 6: gcd(z_1, z_2) assembly phases; coprime pairs have one.
#[test]
fn assembly_phases_are_run_apart() {
    let folder = empty_folder();
    let phases = |wheel: u32, pinion: u32| {
        let text = format!(
            "[wheel]\nteeth = {wheel}\nmodule_mm = 2\npressure_angle_deg = 20\nrunout = {{ total_um = 30, high_tooth = 2 }}\n\
             [pinion]\nteeth = {pinion}\nmodule_mm = 2\npressure_angle_deg = 20\nrunout = {{ total_um = 20, high_tooth = 5 }}\n\
             [assembly]\ncenter_distance_mm = {}\n[sweep]\nphases = \"all\"\nsteps_per_pitch = 2\n",
            f64::from(wheel + pinion) + 0.1
        );
        std::fs::write(folder.path().join("phases.toml"), text).unwrap();
        let text = output(gearlash(folder.path()).args(["simulate", "phases.toml"]));
        let json =
            output(gearlash(folder.path()).args(["simulate", "phases.toml", "--format", "json"]));
        (text, serde_json::from_str::<Value>(&json).unwrap())
    };
    let (text, result) = phases(18, 12);
    let runs = result["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 6);
    for (i, run) in runs.iter().enumerate() {
        assert_eq!(run["phase"]["pinion_tooth"], i + 1);
        // lcm(18, 12) pitches of two steps.
        assert_eq!(run["poses"].as_array().unwrap().len(), 72);
    }
    assert!(
        text.contains("Best phase 1,") && text.contains("mark wheel tooth 1 and pinion tooth"),
        "{text}"
    );
    // JSON, CSV, and two snapshots a phase.
    assert_eq!(files(&folder.path().join("out/phases")).len(), 14);
    let (text, result) = phases(18, 13);
    assert_eq!(result["runs"].as_array().unwrap().len(), 1);
    assert!(text.contains("only one assembly phase"), "{text}");
}

//! `gearlash chart`, as a user runs it.

use assert_cmd::Command;
use predicates::prelude::*;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn fixture(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("fixtures")
        .join(name)
}

fn chart(folder: &TempDir, file: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command
        .current_dir(folder.path())
        .arg("chart")
        .arg(file)
        .args(arguments);
    command
}

#[test]
fn each_kind_has_its_file() {
    let folder = TempDir::new().unwrap();
    let pair = fixture("karba_44x44.toml");
    for (arguments, file) in [
        (
            &["--kind", "revolution"][..],
            "chart_revolution_a132.04.svg",
        ),
        (
            &[
                "--kind",
                "difference",
                "--center-distance",
                "132.0",
                "--material",
                "most",
            ],
            "chart_difference_a132_most.svg",
        ),
        (
            &["--kind", "distance", "--mating", "44,33"],
            "chart_distance_44_33.svg",
        ),
        // The mating that binds, where none is asked for.
        (&["--kind", "distance"], "chart_distance_33_33.svg"),
        (&["--kind", "inspection"], "chart_inspection_wheel.svg"),
        (
            &["--kind", "inspection", "--gear", "pinion"],
            "chart_inspection_pinion.svg",
        ),
    ] {
        let path = format!("out/karba_44x44/{file}");
        chart(&folder, &pair, arguments)
            .assert()
            .success()
            .stdout(format!("{path}\n"));
        let svg = std::fs::read_to_string(folder.path().join(path)).unwrap();
        assert!(roxmltree::Document::parse(&svg).is_ok());
        // The chart goes to another file, and once more to standard output.
        chart(&folder, &pair, arguments)
            .args(["-o", "new/chart.svg"])
            .assert()
            .success();
        assert_eq!(
            std::fs::read_to_string(folder.path().join("new/chart.svg")).unwrap(),
            svg
        );
        chart(&folder, &pair, arguments)
            .args(["-o", "-"])
            .assert()
            .success()
            .stdout(svg);
    }
}

#[test]
fn the_least_of_several_distances_is_drawn_and_said() {
    let folder = TempDir::new().unwrap();
    chart(
        &folder,
        &fixture("karba_44x44.toml"),
        &["--kind", "revolution", "-o", "-"],
    )
    .assert()
    .success()
    .stdout(predicate::str::contains(
        "a = 132.040 mm · one wheel revolution from mating 1·1 on",
    ))
    .stderr(predicate::str::contains(
        "note: at the least of 5 centre distances",
    ));
}

/// `--method both` is judged for curves over the distance, too.
#[test]
fn both_methods_are_compared() {
    let folder = TempDir::new().unwrap();
    let arguments = ["--kind", "distance", "--method", "both", "-o", "c.svg"];
    chart(&folder, &fixture("karba_86x21.toml"), &arguments)
        .assert()
        .success()
        .stderr(predicate::str::contains("exact and polygon method agree"));
}

/// Issue 6: the synthetic values say so in title and chart.
#[test]
fn synthetic_pitch_is_named_in_the_chart() {
    let folder = TempDir::new().unwrap();
    for kind in ["revolution", "inspection"] {
        chart(
            &folder,
            &fixture("karba_44x44_pitch.toml"),
            &["--kind", kind, "-o", "-"],
        )
        .assert()
        .success()
        .stdout(predicate::str::contains("with synthetic pitch deviations"));
    }
}

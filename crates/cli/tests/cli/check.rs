//! `check`: classes of contact, and the map.

use super::pair_86_21::{pair_86_21, written};
use super::*;

fn gearlash(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder);
    command
}

/// A simulation's summary counts the same classes.
#[test]
fn a_simulation_counts_classes_too() {
    let (folder, file) = written(&pair_86_21(160.2));
    let assert = gearlash(folder.path())
        .args(["simulate", "--format", "json"])
        .arg(&file)
        .assert()
        .success();
    let json: Value = serde_json::from_slice(&assert.get_output().stdout).unwrap();
    let run = &json["runs"][0];
    let poses = run["poses"].as_array().unwrap();
    let counted = run["summary"]["contact"]["classes"].as_object().unwrap();
    for (class, count) in counted {
        let of_class = poses.iter().filter(|pose| pose["class"] == class.as_str());
        assert_eq!(of_class.count() as u64, count.as_u64().unwrap(), "{class}");
    }
    let worst = &run["summary"]["contact"]["worst"];
    assert_eq!(worst["contact"]["tip_gear"], "wheel");
    assert!(worst["contact"]["wheel_tooth"].is_u64());
}

#[test]
fn the_map_is_a_picture_and_a_table() {
    let (folder, file) = written(&pair_86_21(160.2));
    gearlash(folder.path())
        .args(["check", "--map", "-o", "map"])
        .arg(&file)
        .assert()
        .code(1);
    let read = |name: &str| std::fs::read_to_string(folder.path().join("map").join(name)).unwrap();
    let svg = read("map_as-measured.svg");
    let picture = roxmltree::Document::parse(&svg).unwrap();
    let texts: Vec<&str> = picture
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .filter_map(|node| node.text())
        .collect();
    for limit in [
        "K (17)",
        "K (8)",
        "form circle",
        "0.15 m",
        "0.25 m",
        "a of the pair",
    ] {
        assert!(
            texts.iter().any(|text| text.contains(limit)),
            "{limit}: {texts:?}"
        );
    }
    let csv = read("map_as-measured.csv");
    let mut rows = csv.lines();
    assert_eq!(
        rows.next(),
        Some("center_distance_mm,fraction,class,j_wt_um")
    );
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 60 * 60);
    // Far apart involutes touch, K (17) says with play; near enough all is jammed.
    assert!(
        rows.iter()
            .any(|row| row[2] == "jammed" && row[3].is_empty())
    );
    for row in rows {
        let distance: f64 = row[0].parse().unwrap();
        if distance > 160.5 {
            assert_eq!(row[2], "involute-involute");
            assert!(row[3].parse::<f64>().unwrap() > 0.0);
        }
    }
}

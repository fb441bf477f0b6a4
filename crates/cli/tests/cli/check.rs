//! The command line: exit codes, JSON, the map.

use super::pair_86_21::{pair_86_21, written};
use super::*;

fn gearlash(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder);
    command
}

#[test]
fn exit_codes_and_json_of_the_command() {
    let (folder, file) = written(&pair_86_21(160.2));
    let assert = gearlash(folder.path())
        .args(["check", "--format", "json"])
        .arg(&file)
        .assert()
        .code(1);
    let json: Value = serde_json::from_slice(&assert.get_output().stdout).unwrap();
    let json = &json["files"][0];
    let checks = json["checks"].as_array().unwrap();
    for (id, gears) in [
        ("radial_clearance", 2),
        ("non_involute_k8", 2),
        ("non_involute_form", 2),
        ("zero_backlash_distance", 1),
        ("backlash_condition", 1),
        ("undercut", 2),
        ("contact_ratio", 1),
        ("tip_thickness", 2),
        ("off_line_contact", 1),
    ] {
        let of_id: Vec<&Value> = checks.iter().filter(|check| check["id"] == id).collect();
        assert_eq!(of_id.len(), gears, "{id}");
        for check in of_id {
            for key in ["formula", "outlines", "limit", "margin"] {
                assert!(check[key].is_number(), "{id} {key}: {check}");
            }
            assert_eq!(check["gear"].is_string(), gears == 2);
            assert!(["pass", "warn", "fail"].contains(&check["verdict"].as_str().unwrap()));
        }
    }
    let contact = &json["contact"];
    let classes = contact["classes"].as_object().unwrap();
    let poses: u64 = classes.values().map(|n| n.as_u64().unwrap()).sum();
    assert_eq!(poses, 48);
    assert!(classes["tip-fillet"].as_u64().unwrap() > 0);
    assert!((contact["worst_loss_um"].as_f64().unwrap() - 22.522).abs() <= 5e-4);
    assert_eq!(contact["worst"]["contact"]["pinion_curve"], "fillet");

    gearlash(folder.path())
        .arg("check")
        .arg(fixture("karba_44x44.toml"))
        .assert()
        .code(0);
    gearlash(folder.path())
        .args(["check", "missing.toml"])
        .assert()
        .code(2);
    assert!(!folder.path().join("out").exists());
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

/// K's limits of 0.15 and 0.25 modules: 160.2 − 132 − 27.75 mm is 0.15 of 3 mm, 0.2 mm more 0.2167 of it. A bare m would
/// read as metres.
#[test]
fn radial_clearance_is_reported_in_modules_with_the_limit_it_misses() {
    for (a, note) in [
        (160.1, "0.1167 module, below the limit of 0.15;"),
        (
            160.2,
            "0.1500 module, below the 0.25 recommended (0.7500 mm);",
        ),
        (160.6, "0.2833 module;"),
    ] {
        let (folder, file) = written(&pair_86_21(a));
        let assert = gearlash(folder.path()).args(["check"]).arg(&file).assert();
        let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
        assert!(text.contains(note), "{a}: {text}");
    }
}

/// "Lost motion the formula does not see: most 0.000 µm (formula 12.2, found 12.2)" and its teeth, where nothing is lost.
#[test]
fn no_loss_has_no_place() {
    let folder = empty_folder();
    std::fs::write(folder.path().join("undercut.toml"), UNDERCUT).unwrap();
    let check = gearlash(folder.path())
        .args(["check", "undercut.toml"])
        .output()
        .unwrap();
    let text = String::from_utf8(check.stdout).unwrap();
    assert!(
        text.contains("greatest 0.000 µm.\n") && !text.contains("Largest loss"),
        "{text}"
    );
    assert!(text.contains(" of 10 checks fail: "), "{text}");
}

//! `gearlash tolerance`: the worst assemblies as pair files.

use super::*;

/// 44/44 as of the lib's tests, with all that can scatter.
pub const PAIR: &str = r#"
title = "with tolerances"
[wheel]
teeth = 20
module_mm = 2.0
pressure_angle_deg = 20.0
thickness = { allowance_um = { min = -60, max = -20 } }
[pinion]
teeth = 30
module_mm = 2.0
pressure_angle_deg = 20.0
reference_face = "back"
runout = { total_um = 12.0 }
[assembly]
center_distance_mm = { nominal_mm = 50.1, tolerance_um = 20 }
bearing_clearance_mm = 0.004
[require]
j_wt_um = { min = 40, max = 150 }
[tolerance]
assemblies = 300
seed = 7
contribution_rows = 64
center_distance = { scatter = "normal", cpk = 1 }
[tolerance.wheel]
thickness = { scatter = "uniform" }
runout = { scatter = "rayleigh", upper_um = 30 }
pitch = { grade = 7 }
per_tooth = { scatter = "triangular", lower_um = -3, upper_um = 3 }
"#;

pub fn pair(folder: &Path) {
    std::fs::write(folder.join("pair.toml"), PAIR).unwrap();
}

pub fn tolerance(folder: &Path, args: &str) -> (Option<i32>, String, String) {
    let words: Vec<&str> = args.split_whitespace().collect();
    let mut command = gearlash(folder);
    // The page is dated.
    command.env("SOURCE_DATE_EPOCH", "1700000000").args(words);
    let output = command.output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

/// `simulate` finds the least and the greatest of each worst assembly as its run did: to a nanometre, the width of its brackets.
#[test]
fn the_worst_assemblies_are_pair_files_that_reproduce_them() {
    let folder = empty_folder();
    pair(folder.path());
    let (_, text, _) = tolerance(folder.path(), "tolerance pair.toml -o o --format json");
    let result: Value = serde_json::from_str(&text).unwrap();
    check_worst(folder.path(), &result);
}

/// `simulate` finds the ten worst assemblies of the folder `o` as the run did.
pub fn check_worst(folder: &Path, result: &Value) {
    let worst = result["worst"].as_array().unwrap();
    assert_eq!(worst.len(), 10);
    for one in worst {
        let file = format!("o/{}", one["file"].as_str().unwrap());
        // Exit 1: it does not meet the requirement.
        let (_, text, _) = run(folder, &["simulate", &file, "--format", "json"]);
        let simulated: Value = serde_json::from_str(&text).unwrap();
        // With play in the bearings: pressed together, and pulled apart.
        let found = &simulated["extremes"][0]["with_bearing_clearance"];
        for (key, end) in [("least_um", "least"), ("greatest_um", "greatest")] {
            let value = found[end]["pose"]["j_wt_um"].as_f64().unwrap();
            let wanted = one[key].as_f64().unwrap();
            assert!(
                (value - wanted).abs() < 2e-3,
                "{file} {key}: {value} {wanted}"
            );
        }
    }
}

//! Tolerance fields, limits and temperatures of a drawing, from file to verdict.

use super::{empty_folder, run};
use serde_json::Value;
use std::fs;
use std::path::Path;

fn pair(keys: [&str; 2], assembly: &str) -> String {
    let gear = |name: &str, teeth: u32, keys: &str| {
        format!("[{name}]\nteeth = {teeth}\nmodule_mm = 1\npressure_angle_deg = 20\n{keys}\n")
    };
    let [wheel, pinion] = [gear("wheel", 20, keys[0]), gear("pinion", 40, keys[1])];
    format!("{wheel}{pinion}[assembly]\n{assembly}\n")
}

fn check(folder: &Path, text: &str) -> (Value, String) {
    fs::write(folder.join("pair.toml"), text).unwrap();
    let words = ["check", "pair.toml", "--format", "json", "--verbose"];
    let (_, json, notes) = run(folder, &words);
    let json: Value = serde_json::from_str(&json).expect(&notes);
    (json["files"][0].clone(), notes)
}

/// Least and greatest `j_wt` over all distances and materials, µm, each proven.
fn extremes(result: &Value) -> [f64; 2] {
    let all = |end: &str| -> Vec<f64> {
        let runs = result["extremes"].as_array().unwrap().iter();
        let of_run = |run: &Value| {
            assert_eq!(run[end]["proven"], true, "{run}");
            run[end]["j_wt_um"][0].as_f64().unwrap()
        };
        runs.map(of_run).collect()
    };
    [
        all("least").into_iter().fold(f64::INFINITY, f64::min),
        all("greatest")
            .into_iter()
            .fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// m 1, 20/40, 25cd both, 30 ± 0.0105: 100.3 … 175.7 µm was found by hand with three centre distances.
#[test]
fn a_drawing_of_ten_lines_has_its_band() {
    let folder = empty_folder();
    let field = "thickness.designation = \"25cd\"";
    let limits = "thickness.allowance_um = { upper = -54, lower = -84 }";
    for (gear, distance) in [
        (field, "center_distance_mm = \"30 js7\""),
        (
            limits,
            "center_distance_mm = { nominal_mm = 30, tolerance_um = 10.5 }",
        ),
    ] {
        let text = pair([gear; 2], distance);
        let (result, notes) = check(folder.path(), &text);
        let [least, greatest] = extremes(&result);
        assert!((least - 100.3).abs() < 0.05, "{least}");
        assert!((greatest - 175.7).abs() < 0.05, "{greatest}");
        assert_eq!(
            gear == field,
            notes.contains("are -54 and -84 µm"),
            "{notes}"
        );
        assert_eq!(
            gear == field,
            notes.contains("30 js7 is 30 ± 0.0105 mm"),
            "{notes}"
        );
    }
}

/// The echo has the stated values, and is a pair file again.
#[test]
fn the_echo_says_what_was_stated() {
    let folder = empty_folder();
    let text = pair(
        [
            "thickness.designation = \"cd 25\"\nexpansion_per_k = 11.5e-6",
            "expansion_per_k = 11.5e-6",
        ],
        "center_distance_mm = \"30js7\"\ntemperature_c = 60\nhousing_expansion_per_k = 23e-6",
    );
    let (result, _) = check(folder.path(), &text);
    let input = &result["pair"];
    assert_eq!(input["wheel"]["thickness"]["designation"], "25cd");
    assert_eq!(input["assembly"]["center_distance_mm"], "30 js7");
    fs::write(folder.path().join("echo.json"), input.to_string()).unwrap();
    let (_, json, _) = run(folder.path(), &["check", "echo.json", "--format", "json"]);
    let again: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(again["files"][0]["verdict"], result["verdict"]);
}

/// Source: gears and housing with one scale turn as before; a cold pair at the distance of the warm housing in lengths of the
/// warm gears is the same picture.
#[test]
fn a_warm_pair_is_a_cold_one_at_another_distance() {
    let folder = empty_folder();
    let (steel, aluminium, warmer) = (11.5e-6, 23e-6, 60.0);
    let gear = format!("thickness.allowance_um = -40\nexpansion_per_k = {steel}");
    let text = pair(
        [&gear; 2],
        &format!(
            "center_distance_mm = 30\ntemperature_c = {}\nhousing_expansion_per_k = {aluminium}",
            20.0 + warmer
        ),
    );
    let (warm, notes) = check(folder.path(), &text);
    assert!(notes.contains("× 1.0006900"), "{notes}");
    let [gears, housing] = [steel, aluminium].map(|expansion| 1.0 + expansion * warmer);
    let text = pair(
        ["thickness.allowance_um = -40"; 2],
        &format!("center_distance_mm = {:?}", 30.0 * housing / gears),
    );
    let (cold, _) = check(folder.path(), &text);
    let [warm, cold] = [warm, cold].map(|result| extremes(&result));
    for (warm, cold) in warm.into_iter().zip(cold) {
        // Brackets are 0.001 µm wide.
        assert!((warm - cold * gears).abs() < 2e-3, "{warm} {cold}");
    }
}

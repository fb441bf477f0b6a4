//! What a drawing states, from file to verdict; files to start from.

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

/// What was stated stands in the echo, which is a pair file again.
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

/// Source: gears and housing scaled alike turn alike; a cold pair at the distance of the warm housing in lengths of the warm gears is the same picture.
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

#[test]
fn what_a_drawing_cannot_say_is_refused_with_the_way_out() {
    let folder = empty_folder();
    let plain = "center_distance_mm = 30";
    let none = "profile_shift = 0";
    let cases = [
        (
            "thickness.designation = \"25 cdx\"",
            plain,
            "wheel.thickness.designation = \"25 cdx\": no tolerance field of DIN 3967",
        ),
        (
            "thickness = { designation = \"25cd\", allowance_um = 0 }",
            plain,
            "allowance_um",
        ),
        (
            "thickness.allowance_um = { upper = -84, lower = -54 }",
            plain,
            "greater than upper",
        ),
        (
            "thickness.allowance_um = { upper = -54 }",
            plain,
            "given without lower",
        ),
        ("thickness.flank_offset_mm = 200", plain, "−100 … 100"),
        (
            none,
            "center_distance_mm = \"30 h11\"",
            "such as \"30 js7\"",
        ),
        (none, "center_distance_mm = \"600 js7\"", "up to 500 mm"),
        (
            none,
            "center_distance_mm = 30\ntemperature_c = 60",
            "wheel.expansion_per_k, pinion.expansion_per_k, assembly.housing_expansion_per_k",
        ),
        (
            none,
            "center_distance_mm = 30\ntemperature_c = 900",
            "−200 … 400",
        ),
    ];
    for (gear, assembly, told) in cases {
        fs::write(
            folder.path().join("pair.toml"),
            pair([gear, none], assembly),
        )
        .unwrap();
        let (code, _, errors) = run(folder.path(), &["check", "pair.toml"]);
        assert_eq!(code, Some(2), "{gear} {assembly}");
        let errors = errors.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(errors.contains(told), "{told}: {errors}");
    }
}

/// Modules that heat lets grow too far apart, whichever gear is the plastic one: (0.024 − 0.0008)/1.024 of the greater.
#[test]
fn heat_that_parts_the_modules_is_refused() {
    let folder = empty_folder();
    let mut gears = ["expansion_per_k = 3e-4", "expansion_per_k = 1e-5"];
    for _ in 0..2 {
        let warm = "center_distance_mm = 31\ntemperature_c = 100\nhousing_expansion_per_k = 1e-5";
        fs::write(folder.path().join("pair.toml"), pair(gears, warm)).unwrap();
        let (code, _, errors) = run(folder.path(), &["check", "pair.toml"]);
        assert_eq!(code, Some(2));
        let errors = errors.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            errors.contains("differ by 2.27 %, allowed is up to 2 %"),
            "{errors}"
        );
        gears.reverse();
    }
}

/// The short files: a verdict at the first run; that of outlines once the drawings it names are there.
#[test]
fn short_files_to_start_from_end_in_a_verdict() {
    let folder = empty_folder();
    for from in ["--drawing", "--measured"] {
        let name = format!("{}.toml", &from[2..]);
        assert_eq!(run(folder.path(), &["init", from, &name]).0, Some(0));
        let (code, text, notes) = run(folder.path(), &["check", &name]);
        assert_eq!(code, Some(0), "{text}{notes}");
        assert!(text.contains("Assembles"), "{text}");
    }
    assert_eq!(
        run(folder.path(), &["init", "--outline", "drawn.toml"]).0,
        Some(0)
    );
    let (code, _, errors) = run(folder.path(), &["check", "drawn.toml"]);
    assert_eq!(code, Some(2));
    assert!(errors.contains("wheel.dxf"), "{errors}");
    for (name, face) in [("wheel", "front"), ("pinion", "back")] {
        let gear = format!(
            "[gear]\nteeth = 20\nmodule_mm = 2\npressure_angle_deg = 20\nreference_face = \"{face}\"\nthickness.allowance_um = -60\n"
        );
        fs::write(folder.path().join("gear.toml"), gear).unwrap();
        let drawing = format!("{name}.dxf");
        let (code, _, errors) = run(
            folder.path(),
            &["outline", "gear.toml", "--format", "dxf", "-o", &drawing],
        );
        assert_eq!(code, Some(0), "{errors}");
    }
    let (code, text, errors) = run(folder.path(), &["check", "drawn.toml"]);
    assert_eq!(code, Some(0), "{errors}");
    assert!(text.contains("Assembles at"), "{text}");
    let both = run(
        folder.path(),
        &["init", "--drawing", "--outline", "both.toml"],
    );
    assert_eq!(both.0, Some(2));
}

//! `gearlash tolerance`: its exit code, the worst assemblies as pair files, and what is wrong with its table.

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
    let worst = result["worst"].as_array().unwrap();
    assert_eq!(worst.len(), 10);
    for one in worst {
        let file = format!("o/{}", one["file"].as_str().unwrap());
        // Exit 1: it does not meet the requirement.
        let (_, text, _) = run(folder.path(), &["simulate", &file, "--format", "json"]);
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

/// The share that may miss the requirement is exit 1; the sentence is the first line.
#[test]
fn a_share_beyond_what_is_allowed_is_exit_1() {
    let folder = empty_folder();
    let allowed = |ppm: &str| {
        let text = PAIR.replace("seed = 7", &format!("seed = 7\nmax_ppm = {ppm}"));
        let text = text.replace("min = 40", "min = 85");
        std::fs::write(folder.path().join("pair.toml"), text).unwrap();
        tolerance(folder.path(), "tolerance pair.toml --quiet")
    };
    let (code, printed, _) = allowed("10");
    assert_eq!(code, Some(1), "{printed}");
    let first = printed.split(".\n").next().unwrap().replace('\n', " ");
    assert!(first.contains("ppm below 85 µm ["), "{first}");
    assert!(first.contains("% of the scatter from the "), "{first}");
    assert!(
        first.ends_with("does not meet the 10 ppm allowed"),
        "{first}"
    );
    let (code, printed, _) = allowed("999999");
    assert_eq!(code, Some(0), "{printed}");
}

/// Teeth of 3 mm more: nothing is left of the involute. Never dropped silently.
#[test]
fn draws_of_no_gear_stop_the_run() {
    let folder = empty_folder();
    let scatter = "thickness = { scatter = \"table\", values_um = [0, 0, 0, 3000] }";
    let text = PAIR.replace("thickness = { scatter = \"uniform\" }", scatter);
    std::fs::write(folder.path().join("pair.toml"), &text).unwrap();
    let (code, _, told) = tolerance(folder.path(), "tolerance pair.toml -o o");
    assert_eq!(code, Some(2));
    assert!(
        told.contains("draws are of no gear") && told.contains("0.001"),
        "{told}"
    );
    assert!(
        told.contains("assembly 4: nothing is left of the involute"),
        "{told}"
    );
    let allowed = text.replace("seed = 7", "seed = 7\nmax_impossible = 0.5");
    std::fs::write(folder.path().join("pair.toml"), allowed).unwrap();
    let (code, printed, _) = tolerance(folder.path(), "tolerance pair.toml -o o");
    assert_eq!(code, Some(0));
    assert!(
        printed.replace('\n', " ").contains("of no gear"),
        "{printed}"
    );
}

/// Wheels measured one by one, by a name with a star: each drawn whole.
#[test]
fn measured_gears_are_drawn_whole() {
    let folder = empty_folder();
    std::fs::create_dir(folder.path().join("wheels")).unwrap();
    for (number, allowance) in [-60, -40, -20].iter().enumerate() {
        let text = format!(
            "title = \"w\"\n[gear]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n\
             thickness = {{ allowance_um = {allowance} }}\nrunout = {{ total_um = 9, high_tooth = 4 }}\n"
        );
        std::fs::write(folder.path().join(format!("wheels/{number}.toml")), text).unwrap();
    }
    let own = PAIR.split("[tolerance.wheel]").next().unwrap();
    let text = format!("{own}[tolerance.wheel]\ngears = \"wheels/*.toml\"\n");
    std::fs::write(folder.path().join("pair.toml"), &text).unwrap();
    let (code, printed, told) =
        tolerance(folder.path(), "tolerance pair.toml -o o --rows o/rows.csv");
    assert_eq!(code, Some(0), "{told}");
    assert!(
        printed.contains("which wheel") && printed.contains("No worst case"),
        "{printed}"
    );
    let rows = std::fs::read_to_string(folder.path().join("o/rows.csv")).unwrap();
    assert_eq!(rows.lines().count(), 302);
    let worst = std::fs::read_to_string(folder.path().join("o/worst_01.toml")).unwrap();
    assert!(
        worst.contains("total_um = 9.0") && worst.contains("high_tooth = 4.0"),
        "{worst}"
    );
    // Another number of teeth, a file that is none, a name that nothing has.
    let bad = folder.path().join("wheels/3.toml");
    std::fs::write(
        &bad,
        "title = \"w\"\n[gear]\nteeth = 21\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n",
    )
    .unwrap();
    let refused = |wanted: &str| {
        let (code, _, told) = tolerance(folder.path(), "tolerance pair.toml -o o");
        assert_eq!(code, Some(2));
        assert!(told.contains(wanted), "{told}");
    };
    refused("gear 4 of the list has teeth 21, not 20");
    std::fs::write(&bad, "teeth = \"a secret\"").unwrap();
    refused("3.toml: this is no gear file that can be read");
    // A wheel of a pair file that stands in the warm.
    let warm = text.replace("wheels/*", "wheels/1.toml");
    let assembly = "[assembly]\ntemperature_c = 60\nhousing_expansion_per_k = 1e-5";
    let warm = warm.replace("[assembly]", assembly);
    let warm = warm.replace("\nteeth", "\nexpansion_per_k = 1e-5\nteeth");
    std::fs::write(&bad, warm).unwrap();
    refused("stands at 60 °C");
    std::fs::write(
        folder.path().join("pair.toml"),
        text.replace("wheels/*", "none/*"),
    )
    .unwrap();
    refused("there is no such file");
}

/// All that is wrong with the table at once, each with its key and the way out.
#[test]
fn each_wrong_key_is_reported() {
    let folder = empty_folder();
    let text = PAIR.split("[tolerance]").next().unwrap().to_owned()
        + r#"
[tolerance]
assemblies = 0
max_ppm = -1
sede = 3
phase = "some"
thickness_correlation = 2
center_distance = { scatter = "normal", sigma_um = 3, cpk = 1 }
bearing_play = { scatter = "uniform", lower_um = 5 }
[tolerance.wheel]
thickness = { scatter = "gauss" }
runout = { scatter = "rayleigh" }
pitch = { grade = 6, sigma_um = 2 }
per_tooth = { scatter = "fixed", sigma_um = 2 }
[tolerance.pinion]
gears = []
"#;
    std::fs::write(folder.path().join("pair.toml"), text).unwrap();
    for command in ["tolerance pair.toml", "check pair.toml"] {
        let (code, _, told) = tolerance(folder.path(), command);
        assert_eq!(code, Some(2));
        for wanted in [
            "tolerance.assemblies",
            "tolerance.max_ppm",
            "did you mean `seed`",
            "tolerance.phase",
            "tolerance.thickness_correlation",
            "sigma_um stands beside limits or cpk",
            "has one limit, expected lower_um and upper_um",
            "tolerance.wheel.thickness.scatter",
            "expected either scale_um or upper_um",
            "given together with grade",
            "no key of this distribution, expected value_um",
            "tolerance.pinion.gears",
        ] {
            assert!(told.contains(wanted), "{wanted}: {told}");
        }
    }
    for (from, to, wanted) in [
        (
            "runout = { scatter = \"rayleigh\", upper_um = 30 }",
            "runout = { scatter = \"normal\", sigma_um = 3 }",
            "cannot be below 0",
        ),
        (
            "seed = 7",
            "seed = 7\nthickness_correlation = 0.5",
            "one at least does not scatter",
        ),
        (
            "runout = { scatter = \"rayleigh\", upper_um = 30 }",
            "runout = { scatter = \"uniform\" }",
            "states no band",
        ),
        (
            "bearing_clearance_mm = 0.004",
            "temperature_c = 60",
            "temperature_c",
        ),
        (
            "{ nominal_mm = 50.1, tolerance_um = 20 }",
            "[50.1, 50.2]",
            "several distances",
        ),
        ("upper_um = 3 }", "upper_um = -9 }", "greater than upper_um"),
    ] {
        assert!(PAIR.contains(from), "{from}");
        std::fs::write(folder.path().join("pair.toml"), PAIR.replace(from, to)).unwrap();
        let (code, _, told) = tolerance(folder.path(), "tolerance pair.toml -o o");
        assert_eq!(code, Some(2), "{to}: {told}");
        assert!(told.contains(wanted), "{to}: {told}");
    }
    let without = PAIR.split("[tolerance]").next().unwrap();
    std::fs::write(folder.path().join("pair.toml"), without).unwrap();
    let (code, _, told) = tolerance(folder.path(), "tolerance pair.toml");
    assert!(
        code == Some(2) && told.contains("add [tolerance]"),
        "{told}"
    );
}

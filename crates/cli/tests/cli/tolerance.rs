//! `gearlash tolerance` and helical `match`: each assembly as `simulate` finds it, over the same face, and spur pairs where the helix angle goes to 0.

use super::*;
use std::fs;

/// 20/30 with all that can scatter.
const PAIR: &str = r#"
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

const HELIX: &str = "helix_angle_deg = 21\nhand = \"right\"\nface_mm = [-20, 30]\n";

fn gear(name: &str, further: &str) -> String {
    let (teeth, shift, hand) = match name {
        "pinion" => (51, 0.1628301985916763, "left"),
        _ => (27, 0.3, "right"),
    };
    let helix = HELIX.replace("right", hand);
    format!(
        "[{name}]\nteeth = {teeth}\nmodule_mm = 4.5\npressure_angle_deg = 20\nprofile_shift = {shift}\nrack.root_radius = 0.25\n{helix}{further}"
    )
}

/// 27/51, the pair of docs/explanation/helical-gears.md, with its measuring planes apart and all that can scatter of helical gears.
fn helical() -> String {
    let deviations = |total_um: u32, tooth: u32| {
        format!(
            "thickness.designation = \"25cd\"\nrunout = {{ total_um = {total_um}, high_tooth = {tooth} }}\n"
        )
    };
    let wheel = gear("wheel", &deviations(30, 4));
    let pinion = gear("pinion", &deviations(40, 17));
    format!(
        "title = \"helical\"\n{wheel}{pinion}reference_face = \"back\"\n[assembly]\ncenter_distance_mm = \"190 js7\"\nface_offset_mm = 3\nbearing_clearance_mm = 0.01\n\
         [require]\nj_wt_um = {{ min = 250, max = 300 }}\n\
         [tolerance]\nassemblies = 12\ncontribution_rows = 0\ncenter_distance = {{ scatter = \"normal\" }}\n\
         [tolerance.wheel]\nthickness = {{ scatter = \"normal\" }}\nrunout = {{ scatter = \"rayleigh\", upper_um = 40 }}\n\
         per_tooth = {{ scatter = \"uniform\", lower_um = -3, upper_um = 3 }}\n\
         [tolerance.pinion]\nthickness = {{ scatter = \"uniform\" }}\npitch = {{ sigma_um = 4 }}\n"
    )
}

/// The population of a pair file, its worst assemblies in a folder of its `name`.
fn population(folder: &Path, name: &str, text: &str) -> Value {
    fs::write(folder.join(format!("{name}.toml")), text).unwrap();
    json_of(folder, &format!("tolerance {name}.toml -o {name}"))
}

/// `simulate` finds the least and the greatest of each worst assembly as its run did, to the width of a bracket: of spur gears, and of helical ones with
/// thickness and tooth thickness in the normal section, pitch in the transverse one, high teeth in each gear's own measuring plane.
#[test]
fn the_worst_assemblies_are_pair_files_that_reproduce_them() {
    for (name, text) in [("spur", PAIR), ("helical", &helical())] {
        let folder = empty_folder();
        let result = population(folder.path(), name, text);
        if name == "helical" {
            assert_eq!(result["outcomes"]["clear"], 12, "{result}");
        }
        let worst = result["worst"].as_array().unwrap();
        assert_eq!(worst.len(), 10);
        for one in worst {
            let file = format!("{name}/{}", one["file"].as_str().unwrap());
            // Exit 1: it does not meet the requirement.
            let simulated = json_of(folder.path(), &format!("simulate {file}"));
            // With play in the bearings: pressed together, and pulled apart.
            let found = &simulated["extremes"][0]["with_bearing_clearance"];
            for end in ["least", "greatest"] {
                let value = &found[end]["pose"]["j_wt_um"];
                assert_near(value, &one[format!("{end}_um")], 2e-3, &file);
            }
        }
    }
}

/// The worst case of a helical pair with runout: no drawn assembly lies beyond it, and between perfect flanks it is that of any face. Source: between
/// involutes without pitch deviations the lost motion does not depend on where along the face they touch.
#[test]
fn helical_runout_has_a_worst_case() {
    let folder = empty_folder();
    let worst = |name: &str, text: &str| -> [Value; 2] {
        let result = population(folder.path(), name, text);
        let ends = ["least_um", "greatest_um"];
        let worst = ends.map(|end| result["limits"]["worst_case"][end].clone());
        for one in result["worst"].as_array().unwrap() {
            let [least, greatest] = ends.map(|end| one[end].as_f64().unwrap());
            let is_inside = worst[0].as_f64() <= Some(least) && Some(greatest) <= worst[1].as_f64();
            assert!(is_inside, "{one} {worst:?}");
        }
        worst
    };
    let uniform = "{ scatter = \"uniform\" }";
    let bounded = helical()
        .replace("\"rayleigh\",", "\"uniform\", lower_um = 0,")
        .replace("{ scatter = \"normal\" }", uniform)
        .replace("pitch = { sigma_um = 4 }\n", "");
    let wide = worst("wide", &bounded);
    let narrow = worst("narrow", &bounded.replace("[-20, 30]", "[-1, 3]"));
    for (wide, narrow) in wide.iter().zip(&narrow) {
        assert_near(wide, narrow, 2e-3, "worst case");
    }
}

/// A helix angle of 0 is a spur pair, byte for byte; one of 1e-9 degrees has the same worst assemblies, each to the width of its bracket, 0.001 µm (pose by
/// pose it is 1e-9 µm: the library's tests).
#[test]
fn a_helix_angle_that_goes_to_0_gives_the_spur_population() {
    let folder = empty_folder();
    let offset = "face_offset_mm = 3\n";
    let wound = helical().replace("190 js7", "177.5 js7");
    let of_angle = |name: &str, angle: &str, offset: &str| {
        let text = wound.replace(
            "helix_angle_deg = 21",
            &format!("helix_angle_deg = {angle}"),
        );
        let text = text.replace("face_offset_mm = 3\n", offset);
        population(folder.path(), name, &text)
    };
    let mut spur = wound.replace(offset, "");
    for hand in ["right", "left"] {
        spur = spur.replace(&HELIX.replace("right", hand), "");
    }
    let none = population(folder.path(), "none", &spur);
    assert_eq!(none["outcomes"]["clear"], 12);
    let zero = of_angle("zero", "0", "");
    for key in ["outcomes", "outside", "least", "greatest", "worst"] {
        assert_eq!(none[key], zero[key], "{key}");
    }
    let tiny = of_angle("tiny", "1e-9", offset);
    let [none, tiny] = [&none, &tiny].map(|result| result["worst"].as_array().unwrap());
    for (spur, helical) in none.iter().zip(tiny) {
        assert_eq!(spur["assembly"], helical["assembly"]);
        for key in ["least_um", "greatest_um"] {
            assert_near(&spur[key], &helical[key], 1e-3, key);
        }
    }
}

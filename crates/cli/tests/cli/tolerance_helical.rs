//! Helical pairs in `gearlash tolerance` and `match`: each assembly as `simulate` finds it over the same face, and spur pairs where the helix angle
//! goes to 0.

use super::tolerance::{check_worst, tolerance};
use super::*;

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
fn pair() -> String {
    let wheel = gear(
        "wheel",
        "thickness.designation = \"25cd\"\nrunout = { total_um = 30, high_tooth = 4 }\n",
    );
    let pinion = gear(
        "pinion",
        "reference_face = \"back\"\nthickness.designation = \"25cd\"\nrunout = { total_um = 40, high_tooth = 17 }\n",
    );
    format!(
        "title = \"helical\"\n{wheel}{pinion}[assembly]\ncenter_distance_mm = \"190 js7\"\nface_offset_mm = 3\nbearing_clearance_mm = 0.01\n\
         [require]\nj_wt_um = {{ min = 250, max = 300 }}\n\
         [tolerance]\nassemblies = 12\ncontribution_rows = 0\ncenter_distance = {{ scatter = \"normal\" }}\n\
         [tolerance.wheel]\nthickness = {{ scatter = \"normal\" }}\nrunout = {{ scatter = \"rayleigh\", upper_um = 40 }}\n\
         per_tooth = {{ scatter = \"uniform\", lower_um = -3, upper_um = 3 }}\n\
         [tolerance.pinion]\nthickness = {{ scatter = \"uniform\" }}\npitch = {{ sigma_um = 4 }}\n"
    )
}

fn um(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// Ten assemblies of twelve as pair files, thickness and tooth thickness in the normal section, pitch in the transverse one, high teeth in each gear's
/// own measuring plane: `simulate` finds what the run found, to the width of a bracket.
#[test]
fn a_helical_population_is_what_simulate_finds_pair_by_pair() {
    let folder = empty_folder();
    let here = folder.path();
    std::fs::write(here.join("pair.toml"), pair()).unwrap();
    let (code, text, message) = tolerance(here, "tolerance pair.toml -o o --format json");
    assert_eq!(code, Some(0), "{message}");
    let result: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(result["outcomes"]["clear"], 12, "{result}");
    check_worst(here, &result);
}

/// The worst case of a helical pair with runout: no drawn assembly lies beyond it, and between perfect flanks it is that of any face. Source: between
/// involutes without pitch deviations the lost motion does not depend on where along the face they touch.
#[test]
fn helical_runout_has_a_worst_case() {
    let folder = empty_folder();
    let here = folder.path();
    let worst = |name: &str, text: String| -> [f64; 2] {
        std::fs::write(here.join(format!("{name}.toml")), text).unwrap();
        let args = format!("tolerance {name}.toml -o {name} --format json");
        let (code, text, message) = tolerance(here, &args);
        assert_eq!(code, Some(0), "{message}");
        let result: Value = serde_json::from_str(&text).unwrap();
        let worst =
            [0, 1].map(|end| um(&result["limits"]["worst_case"][["least_um", "greatest_um"][end]]));
        for one in result["worst"].as_array().unwrap() {
            let (least, greatest) = (um(&one["least_um"]), um(&one["greatest_um"]));
            assert!(worst[0] <= least && greatest <= worst[1], "{one} {worst:?}");
        }
        worst
    };
    let bounded = pair()
        .replace(
            "{ scatter = \"rayleigh\", upper_um = 40 }",
            "{ scatter = \"uniform\", lower_um = 0, upper_um = 40 }",
        )
        .replace(
            "center_distance = { scatter = \"normal\" }",
            "center_distance = { scatter = \"uniform\" }",
        )
        .replace(
            "thickness = { scatter = \"normal\" }",
            "thickness = { scatter = \"uniform\" }",
        )
        .replace("pitch = { sigma_um = 4 }\n", "");
    let wide = worst("wide", bounded.clone());
    let narrow = worst("narrow", bounded.replace("[-20, 30]", "[-1, 3]"));
    for (wide, narrow) in wide.into_iter().zip(narrow) {
        assert!((wide - narrow).abs() < 2e-3, "{wide} {narrow}");
    }
}

/// A helix angle of 0 is a spur pair, byte for byte; one of 1e-9 degrees has the same worst assemblies, each to the width of its bracket, 0.001 µm (pose by
/// pose it is 1e-9 µm: the library's tests).
#[test]
fn a_helix_angle_that_goes_to_0_gives_the_spur_population() {
    let folder = empty_folder();
    let here = folder.path();
    let spur = pair().replace("190 js7", "177.5 js7");
    let offset = "face_offset_mm = 3\n";
    let of = |name: &str, helix: &dyn Fn(&str) -> String, offset: &str| -> Value {
        let mut text = spur.replace("face_offset_mm = 3\n", offset);
        for hand in ["right", "left"] {
            let own = HELIX.replace("right", hand);
            text = text.replace(&own, &helix(&own));
        }
        std::fs::write(here.join(format!("{name}.toml")), text).unwrap();
        let args = format!("tolerance {name}.toml --format json");
        let (code, text, message) = tolerance(here, &args);
        assert_eq!(code, Some(0), "{name}: {message}");
        serde_json::from_str(&text).unwrap()
    };
    let none = of("none", &|_| String::new(), "");
    assert_eq!(none["outcomes"]["clear"], 12);
    let zero = of("zero", &|own| own.replace("= 21", "= 0"), "");
    for key in ["outcomes", "outside", "least", "greatest", "worst"] {
        assert_eq!(none[key], zero[key], "{key}");
    }
    let tiny = of("tiny", &|own| own.replace("= 21", "= 1e-9"), offset);
    for (spur, helical) in none["worst"]
        .as_array()
        .unwrap()
        .iter()
        .zip(tiny["worst"].as_array().unwrap())
    {
        assert_eq!(spur["assembly"], helical["assembly"]);
        for key in ["least_um", "greatest_um"] {
            let (spur, helical) = (um(&spur[key]), um(&helical[key]));
            assert!((spur - helical).abs() < 1e-3, "{key}: {spur} {helical}");
        }
    }
}

/// Two wheels and two pinions: the marked phase as `simulate` finds it. `tests/sessions/along_face.txt` has gears of another hand or face.
#[test]
fn helical_gears_are_matched_over_their_face() {
    let folder = empty_folder();
    let here = folder.path();
    let own = |um: f64, high: f64| {
        format!(
            "thickness.allowance_um = {um}\nrunout = {{ total_um = 30, high_tooth = {high} }}\n"
        )
    };
    let [w, p] = ["w", "p"].map(|kind| {
        let kind = here.join(kind);
        std::fs::create_dir(&kind).unwrap();
        kind
    });
    let file = |member: &str, further: &str| {
        gear(member, further).replace(&format!("[{member}]"), "[gear]")
    };
    for (name, thickness, high) in [("1", -100.0, 3.0), ("2", -130.0, 9.5)] {
        std::fs::write(
            w.join(format!("{name}.toml")),
            file("wheel", &own(thickness, high)),
        )
        .unwrap();
        let pinion = own(thickness, 2.0 * high) + "reference_face = \"back\"\n";
        std::fs::write(p.join(format!("{name}.toml")), file("pinion", &pinion)).unwrap();
    }
    let rest = |further: &str| {
        format!("[assembly]\ncenter_distance_mm = 190\nface_offset_mm = 3\n{further}")
    };
    let back = "reference_face = \"back\"\n";
    let text =
        gear("wheel", "") + &gear("pinion", back) + &rest("[require]\nj_wt_um = { min = 100 }\n");
    std::fs::write(here.join("pair.toml"), text).unwrap();
    let words = super::matching::MATCH.split(' ');
    let words: Vec<&str> = words.chain(["--format", "json", "-o", "out"]).collect();
    let (code, printed, message) = run(here, &words);
    assert_eq!(code, Some(0), "{message}");
    let result: Value = serde_json::from_str(&printed).unwrap();
    let pairs = result["pairs"].as_array().unwrap();
    assert_eq!((pairs.len(), &result["phases"]), (2, &json!(3)));
    let data = |name: &Value| match name.as_str() {
        Some("1") => (-100.0, 3.0),
        _ => (-130.0, 9.5),
    };
    for pair in pairs {
        let ((wheel_um, wheel_high), (pinion_um, pinion_high)) =
            (data(&pair["wheel"]), data(&pair["pinion"]));
        let sweep = format!(
            "[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 1\nstart = [1, {}]\n",
            pair["pinion_tooth"]
        );
        let pinion = own(pinion_um, 2.0 * pinion_high) + back;
        let text =
            gear("wheel", &own(wheel_um, wheel_high)) + &gear("pinion", &pinion) + &rest(&sweep);
        std::fs::write(here.join("phase.toml"), text).unwrap();
        let (_, text, message) = run(
            here,
            &["simulate", "phase.toml", "--no-files", "--format", "json"],
        );
        let simulated: Value = serde_json::from_str(&text).expect(&message);
        for (key, end) in [("least_um", "least"), ("greatest_um", "greatest")] {
            let value = um(&simulated["extremes"][0][end]["pose"]["j_wt_um"]);
            assert!(
                (value - um(&pair[key])).abs() < 2e-3,
                "{key}: {value} {pair}"
            );
        }
    }
}

//! What `gearlash tolerance` must not pass over: bands, gears, requirements.

use super::tolerance::{PAIR, pair, tolerance};
use super::*;

fn with(folder: &Path, edits: &[(&str, &str)]) {
    let mut text = PAIR.to_owned();
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    std::fs::write(folder.join("pair.toml"), text).unwrap();
}

#[test]
fn a_band_that_nothing_is_drawn_from_is_reported() {
    let folder = empty_folder();
    pair(folder.path());
    let run = || tolerance(folder.path(), "tolerance pair.toml -o o --assemblies 50");
    let (code, _, told) = run();
    assert!(code.is_some() && !told.contains("states a band"), "{told}");
    let distance = ("center_distance = { scatter = \"normal\", cpk = 1 }\n", "");
    let thickness = ("thickness = { scatter = \"uniform\" }\n", "");
    with(folder.path(), &[distance, thickness]);
    let (_, _, told) = run();
    let told = told.replace('\n', " ");
    for wanted in [
        "wheel.thickness: states a band",
        "write thickness = { scatter = \"normal\" } in [tolerance.wheel]",
        "assembly.center_distance_mm: states a band",
        "write center_distance = { scatter = \"normal\" } in [tolerance]",
    ] {
        assert!(told.contains(wanted), "{wanted}: {told}");
    }
}

fn measured(folder: &Path, name: &str, thickness: &str) {
    let text = format!(
        "[gear]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nthickness = {{ {thickness} }}\n"
    );
    std::fs::write(folder.join("wheels").join(name), text).unwrap();
}

/// Links that lead nowhere and two files of one gear are refused; folders, other capitals and bands are reported.
#[test]
fn what_stands_among_measured_gears_is_reported() {
    let folder = empty_folder();
    let path = folder.path();
    std::fs::create_dir_all(path.join("wheels/old.toml")).unwrap();
    measured(path, "1.toml", "allowance_um = -40");
    measured(path, "2.toml", "allowance_um = { min = -50, max = -30 }");
    measured(path, "P3.TOML", "allowance_um = -30");
    let own = PAIR.split("[tolerance.wheel]").next().unwrap();
    let text = format!("{own}[tolerance.wheel]\ngears = \"wheels/*.toml\"\n");
    std::fs::write(path.join("pair.toml"), text).unwrap();
    let run = || {
        let (code, _, told) = tolerance(path, "tolerance pair.toml -o o --assemblies 50");
        (code, told.replace('\n', " "))
    };
    let (code, told) = run();
    assert!(code.is_some_and(|code| code < 2), "{told}");
    for wanted in [
        "wheels/P3.TOML: is as \"wheels/*.toml\" but for capital letters, and is left out",
        "wheels/old.toml: is a folder, and is left out",
        "wheels/2.toml: states a band of thickness",
    ] {
        assert!(told.contains(wanted), "{wanted}: {told}");
    }
    #[cfg(unix)]
    {
        let link = path.join("wheels/4.toml");
        std::os::unix::fs::symlink("nowhere.toml", &link).unwrap();
        let (code, told) = run();
        let wanted = "wheels/4.toml: this is a link to a file that is not there";
        assert!(code == Some(2) && told.contains(wanted), "{told}");
        std::fs::remove_file(link).unwrap();
    }
    std::fs::rename(path.join("wheels/P3.TOML"), path.join("wheels/1.json")).unwrap();
    let text = std::fs::read_to_string(path.join("pair.toml")).unwrap();
    std::fs::write(path.join("pair.toml"), text.replace("*.toml", "[0-9].*")).unwrap();
    let (code, told) = run();
    assert_eq!(code, Some(2), "{told}");
    assert!(told.contains("1.json and "), "{told}");
    assert!(told.contains("1.toml: two files of one gear"), "{told}");
}

/// `check` of a pair judges `j_bn`, lost motion and radial clearance, and so does a population: at one centre distance of spur gears a limit of
/// `j_bn = j_wt cos α_wt` is one of `j_wt`. It was a warning, and all assemblies met it.
#[test]
fn every_requirement_of_a_pair_file_is_judged() {
    let folder = empty_folder();
    let result = |require: &str| -> Value {
        let at = ("{ nominal_mm = 50.1, tolerance_um = 20 }", "50.1");
        let distance = ("center_distance = { scatter = \"normal\", cpk = 1 }\n", "");
        let play = ("bearing_clearance_mm = 0.004\n", "");
        let own = ("j_wt_um = { min = 40, max = 150 }", require);
        with(folder.path(), &[at, distance, play, own]);
        let args = "tolerance pair.toml -o o --format json";
        let (code, printed, told) = tolerance(folder.path(), args);
        assert_eq!(code, Some(0), "{told}");
        assert!(!told.contains("looked at"), "{told}");
        serde_json::from_str(&printed).unwrap()
    };
    let counts = |result: &Value| {
        ["below", "above", "outside"].map(|key| result[key]["count"].as_u64().unwrap())
    };
    let own = result("j_wt_um = { min = 100, max = 128 }");
    let wanted = counts(&own);
    assert!(
        wanted.iter().all(|count| (1..300).contains(count)),
        "{wanted:?}"
    );
    // cos α_wt = 50 cos 20°/50.1, ISO 21771.
    let per = 50.0 * 20f64.to_radians().cos() / 50.1;
    let [min, max] = [100.0, 128.0].map(|um| um * per);
    let found = result(&format!("j_bn_um = {{ min = {min}, max = {max} }}"));
    assert_eq!(counts(&found), wanted);
    assert_eq!(found["requirement"]["others"][0]["quantity"], "j_bn");
    let sentence = found["sentence"].as_str().unwrap();
    assert!(
        sentence.contains("ppm below j_bn 93.") && sentence.contains("above j_bn 120."),
        "{sentence}"
    );
    let worst = std::fs::read_to_string(folder.path().join("o/worst_01.toml")).unwrap();
    assert!(worst.contains("[require.j_bn_um]"), "{worst}");
    // An arc of r_w1 = 50.1 · 20/50 mm.
    let arcmin = |um: f64| (1e-3 * um / (50.1 * 0.4)).to_degrees() * 60.0;
    let [min, max] = [100.0, 128.0].map(arcmin);
    let found = result(&format!(
        "lost_motion_arcmin = {{ min = {min}, max = {max}, at = \"wheel\" }}"
    ));
    assert_eq!(counts(&found), wanted);
    // The wheel's eccentricity, 0.015 mm at 99.73 % of the draws, and the pinion's, 0.006 mm, off 0.25 m and 0.1 mm.
    let found = result("radial_clearance_mm = { min = 0.1, max = 0.7 }");
    assert_eq!(counts(&found), [0, 0, 0]);
    let found = result("radial_clearance_mm = { min = 0.7 }");
    assert_eq!(counts(&found), [300, 0, 300]);
}

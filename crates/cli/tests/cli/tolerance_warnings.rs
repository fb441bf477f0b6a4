//! Requirements of a pair file in `gearlash tolerance`.

use super::tolerance::{PAIR, tolerance};
use super::*;

fn with(folder: &Path, edits: &[(&str, &str)]) {
    let mut text = PAIR.to_owned();
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    std::fs::write(folder.join("pair.toml"), text).unwrap();
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
        let (code, printed, message) = tolerance(folder.path(), args);
        assert_eq!(code, Some(0), "{message}");
        assert!(!message.contains("looked at"), "{message}");
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

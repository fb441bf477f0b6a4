//! `gearlash snapshot --animate`: the extremes that a picture states.

use super::{empty_folder, gearlash, output};

/// The headline told the first frame's backlash while the dot moved, and no frame stood at the extreme. Expected: the
/// greatest of 4001 poses of the same pitch, by `simulate`.
#[test]
fn an_animation_states_the_extremes_of_what_it_shows() {
    let folder = empty_folder();
    let steps: Vec<String> = (0..=4000)
        .map(|i| format!("{:?}", f64::from(i) / 4000.0))
        .collect();
    let gear = |name: &str, teeth: u32| {
        format!(
            "[{name}]\nteeth = {teeth}\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nthickness = {{ allowance_um = -60 }}\n"
        )
    };
    let rest = format!(
        "[assembly]\ncenter_distance_mm = 32.0\n[sweep]\nmating = [[1, 1]]\nfraction = [{}]\n",
        steps.join(", ")
    );
    let pair = gear("wheel", 24) + &gear("pinion", 8) + &rest;
    std::fs::write(folder.path().join("pair.toml"), pair).unwrap();
    let said = |words: &str| output(gearlash(folder.path()).args(words.split(' ')));
    let result = said("simulate pair.toml --format json --no-certify");
    let result: serde_json::Value = serde_json::from_str(&result).unwrap();
    let greatest = result["runs"][0]["summary"]["max_j_wt_um"]
        .as_f64()
        .unwrap();
    let svg = said("snapshot pair.toml --mating 1,1 --flank right --animate -o -");
    let document = roxmltree::Document::parse(&svg).unwrap();
    let texts = document.descendants().filter(|node| node.is_text());
    let words: String = texts.filter_map(|node| node.text()).collect();
    let (_, drawn) = words.split_once("greatest ").unwrap();
    let drawn: f64 = drawn.split_once(" µm").unwrap().0.parse().unwrap();
    // Half a digit, and no lower than what 4001 poses find.
    assert!(
        drawn > greatest - 0.005 && drawn < greatest + 0.02,
        "{drawn} {greatest}"
    );
}

//! `gearlash match`: the marked phase of a pair against `simulate`. `tests/sessions/matching.txt` holds what it prints and refuses.

use super::*;
use std::fs;

/// Two eccentric gears of one number of teeth have, with their high places together, twice the spread; marked, none but that of rounding:
/// the backlash of their phase is what `simulate` finds where the teeth that are marked meet.
#[test]
fn marked_teeth_have_the_backlash_that_simulate_finds() {
    let folder = empty_folder();
    let here = folder.path();
    let plain =
        "teeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\n";
    let eccentric = format!("{plain}runout = {{ total_um = 30, high_tooth = 7 }}\n");
    for kind in ["w", "p"] {
        fs::create_dir(here.join(kind)).unwrap();
        fs::write(
            here.join(kind).join("one.toml"),
            format!("[gear]\n{eccentric}"),
        )
        .unwrap();
    }
    let pair = |gear: &str, rest: &str| {
        format!("[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.0\n{rest}")
    };
    let required = pair(plain, "[require]\nj_wt_um = { min = 110 }\n");
    fs::write(here.join("pair.toml"), required).unwrap();
    let found = &json_of(here, "match pair.toml --wheels w --pinions p -o out")["pairs"][0];
    let sweep = format!(
        "[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 8\nstart = [1, {}]\n",
        found["pinion_tooth"]
    );
    fs::write(here.join("phase.toml"), pair(&eccentric, &sweep)).unwrap();
    let simulated = json_of(here, "simulate phase.toml --no-files");
    for (end, at) in [("least", 0), ("greatest", 1)] {
        let bracket = &simulated["extremes"][0][end]["j_wt_um"][at];
        assert_near(bracket, &found[format!("{end}_um")], 2e-3, end);
    }
    // All phases together spread by twice both runouts' share; the marked one by less than a tenth.
    let [least, greatest] = ["least_um", "greatest_um"].map(|key| found[key].as_f64().unwrap());
    assert!(greatest - least < 3.0, "{found}");
}

/// A gear whose reference face is at the back has its teeth numbered the other way, what was right on it is left: matched so it is the gear
/// with its sheet turned over by hand, tooth `t` being tooth `22 - t` of 20, and a place along ascending numbers one against them.
#[test]
fn a_gear_seen_from_behind_is_its_sheet_turned_over() {
    let folder = empty_folder();
    let here = folder.path();
    let basic = "teeth = 20\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n";
    let sheet = |kind: &str, tooth: f64, right: &[f64], left: &[f64]| {
        let text = format!(
            "[gear]\n{basic}thickness.allowance_um = -60\nrunout = {{ total_um = 30, high_tooth = {tooth} }}\n\
             pitch = {{ kind = \"cumulative\", right_um = {right:?}, left_um = {left:?} }}\n"
        );
        fs::create_dir(here.join(kind)).unwrap();
        fs::write(here.join(kind).join("1.toml"), text).unwrap();
    };
    let wave = |lag: f64| -> Vec<f64> {
        (0..20)
            .map(|k| (8.0 * (0.3 * f64::from(k * k) + lag).sin()).round())
            .collect()
    };
    let (right, left) = (wave(0.0), wave(1.0));
    let turned = |list: &[f64]| -> Vec<f64> { (0..20).map(|k| -list[(20 - k) % 20]).collect() };
    sheet("w", 4.0, &left, &right);
    sheet("asis", 7.0, &right, &left);
    sheet("turned", 15.0, &turned(&left), &turned(&right));
    let matched = |pinions: &str, face: &str| -> Value {
        let text = format!(
            "[wheel]\n{basic}[pinion]\n{basic}reference_face = \"{face}\"\n[assembly]\ncenter_distance_mm = 60.0\n[require]\nj_wt_um.min = 0\n"
        );
        fs::write(here.join("pair.toml"), text).unwrap();
        let words = format!("match pair.toml --wheels w --pinions {pinions} -o out");
        json_of(here, &words)["pairs"][0].clone()
    };
    let (behind, by_hand) = (matched("asis", "back"), matched("turned", "front"));
    for end in ["least_um", "greatest_um"] {
        assert_near(&behind[end], &by_hand[end], 1e-3, end);
    }
    let [behind_tooth, by_hand_tooth] =
        [&behind, &by_hand].map(|pair| pair["pinion_tooth"].as_u64().unwrap());
    assert_eq!(behind_tooth, (21 - by_hand_tooth) % 20 + 1);
    assert_ne!(matched("asis", "front")["least_um"], behind["least_um"]);
}

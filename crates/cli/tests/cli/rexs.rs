//! Backlash of imported gearbox models (REXS) against closed forms.

use super::*;
use std::f64::consts::PI;

fn model() -> String {
    std::fs::read_to_string(fixture("rexs/gearbox.rexs")).unwrap()
}

/// Normal and transverse backlash of two gears of this helix angle and allowance of the thickness at a centre distance, mm: the involute by hand,
/// of 20° and a module in the normal section.
fn by_hand(normal: f64, beta: f64, teeth: [f64; 2], allowance: f64, a: f64) -> [f64; 2] {
    let alpha = (20f64.to_radians().tan() / beta.cos()).atan();
    let (module, allowance) = (normal / beta.cos(), allowance / beta.cos());
    let inv = |angle: f64| angle.tan() - angle;
    let sum = teeth[0] + teeth[1];
    let working = (0.5 * module * sum * alpha.cos() / a).acos();
    let thickness: f64 = teeth
        .map(|z| {
            let half = (0.5 * PI * module + allowance) / (module * z) + inv(alpha) - inv(working);
            2.0 * a * z / sum * half
        })
        .iter()
        .sum();
    let j_wt = 2.0 * PI * a / sum - thickness;
    let j_bt = j_wt * working.cos();
    let base = (beta.sin() * 20f64.to_radians().cos()).asin();
    [j_bt * base.cos(), j_bt / alpha.cos()]
}

/// Imports stage 10 of `model` and compares the least and greatest backlash of the pair file with those by hand, mm.
fn check_backlash(model: &str, least: [f64; 2], greatest: [f64; 2]) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("box.rexs"), model).unwrap();
    gearlash(folder.path())
        .args(["import", "box.rexs", "--stage", "10", "-o", "new/pair.toml"])
        .assert()
        .success();
    let simulate = ["simulate", "new/pair.toml", "--format", "json"];
    let found = output(gearlash(folder.path()).args(simulate));
    let found: serde_json::Value = serde_json::from_str(&found).unwrap();
    let extremes = found["extremes"].as_array().unwrap();
    let of = |key: &str, extreme: &str| {
        let poses = extremes.iter().map(|each| &each[extreme]["pose"]);
        let values: Vec<f64> = poses.map(|pose| pose[key].as_f64().unwrap()).collect();
        (
            values.iter().copied().fold(f64::INFINITY, f64::min),
            values.iter().copied().fold(0.0, f64::max),
        )
    };
    for (k, key) in ["j_bn_um", "j_t_um"].into_iter().enumerate() {
        for (found, expected) in [
            (of(key, "least").0, 1e3 * least[k]),
            (of(key, "greatest").1, 1e3 * greatest[k]),
        ] {
            println!("{key}: {found}, by hand {expected}");
            assert!((found - expected).abs() < 1e-3, "{key}: {found} {expected}");
        }
    }
}

#[test]
fn the_backlash_of_a_spur_stage_is_that_by_hand() {
    // Sun and planet of FVA's public planetary sample (REXS 1.1) as an external pair: 17/22, m 4, no helix, a 78 js7, both c25.
    // DIN 3967, d = 68 and 88 mm: −85/−125 µm. ISO 286, 78 mm: ± 15 µm.
    let least = by_hand(4.0, 0.0, [17.0, 22.0], -0.085, 77.985);
    let greatest = by_hand(4.0, 0.0, [17.0, 22.0], -0.125, 78.015);
    check_backlash(&model(), least, greatest);
}

#[test]
fn the_backlash_of_a_helical_stage_is_that_by_hand() {
    // The same stage wound by 15°: a 80.8 js7 is ± 17.5 µm (ISO 286), c25 the same (DIN 3967, d = 70.4 and 91.1 mm).
    let wound = model()
        .replacen("unit=\"deg\">-0.0<", "unit=\"deg\">15.0<", 1)
        .replacen("unit=\"deg\">0.0<", "unit=\"deg\">-15.0<", 1)
        .replacen(">78.0<", ">80.8<", 1);
    let beta = f64::to_radians(15.0);
    let least = by_hand(4.0, beta, [17.0, 22.0], -0.085, 80.7825);
    let greatest = by_hand(4.0, beta, [17.0, 22.0], -0.125, 80.8175);
    check_backlash(&wound, least, greatest);
}

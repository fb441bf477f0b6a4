//! Runout, pitch and per-tooth thickness: each flank goes where the sheet says.

use super::*;
use gearlash::gear::{AsBuilt, Side};

/// Rotations of a gear's front-right and front-left flanks, times the reference radius, µm.
fn flanks_um(gear: &AsBuilt, side: Side) -> Vec<f64> {
    let basic_data = gear.gear().basic_data();
    (1..=basic_data.teeth())
        .map(|tooth| 1000.0 * basic_data.reference_radius() * gear.flank_offset(side, tooth))
        .collect()
}

fn five(keys: &str) -> AsBuilt {
    let text = PAIR
        .replace(
            "teeth = 20",
            &format!("teeth = 5\nprofile_shift = 0.5\nrack = {{ addendum = 0.6, dedendum = 0.8 }}\n{keys}"),
        )
        .replace("75.2", "55");
    study(&text).study.materials[0].1.clone()
}

fn close(found: &[f64], expected: [f64; 5]) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

/// Design section 3: half to each side, the mean not removed.
#[test]
fn thickness_per_tooth() {
    let gear = five("thickness.per_tooth_um = [2, 4, 0, 0, -6]");
    close(&flanks_um(&gear, Side::Left), [1.0, 2.0, 0.0, 0.0, -3.0]);
    close(&flanks_um(&gear, Side::Right), [-1.0, -2.0, 0.0, 0.0, 3.0]);
}

/// On the front face numbers ascend clockwise, which is negative; each flank counts about its mean.
#[test]
fn cumulative_pitch() {
    let gear = five(
        "pitch = { kind = \"cumulative\", right_um = [1, 2, 3, 4, 5], left_um = [5, 5, 5, 5, 0] }",
    );
    close(&flanks_um(&gear, Side::Right), [2.0, 1.0, 0.0, -1.0, -2.0]);
    close(&flanks_um(&gear, Side::Left), [-1.0, -1.0, -1.0, -1.0, 4.0]);
}

/// f_i = F_i − F_{i−1} of the curves above.
#[test]
fn single_pitch_is_the_difference_of_cumulative() {
    let cumulative = five(
        "pitch = { kind = \"cumulative\", right_um = [1, 2, 3, 4, 5], left_um = [5, 5, 5, 5, 0] }",
    );
    let single = five(
        "pitch = { kind = \"single\", right_um = [-4, 1, 1, 1, 1], left_um = [5, 0, 0, 0, -5] }",
    );
    for side in Side::BOTH {
        let expected: [f64; 5] = flanks_um(&cumulative, side).try_into().unwrap();
        close(&flanks_um(&single, side), expected);
    }
}

/// Plus material on both flanks: along the numbers on right flanks, against them on left flanks.
#[test]
fn pitch_as_plus_material() {
    let numbers = five(
        "pitch = { kind = \"cumulative\", right_um = [1, 2, 3, 4, 5], left_um = [-1, 0, 1, 0, 0] }",
    );
    let material = five(
        "pitch = { kind = \"cumulative\", sense = \"material\", right_um = [1, 2, 3, 4, 5], left_um = [1, 0, -1, 0, 0] }",
    );
    assert_eq!(numbers, material);
}

#[test]
fn empty_lists_are_absent() {
    let perfect = five("");
    for keys in [
        "pitch = { right_um = [], left_um = [] }",
        "pitch = { kind = \"single\", axis = \"datum\" }",
        "thickness.per_tooth_um = []",
        "runout = { total_um = 0 }",
        "runout = { total_um = 0, high_tooth = 1 }",
    ] {
        assert_eq!(five(keys), perfect, "{keys}");
    }
}

#[test]
fn runout_is_twice_the_eccentricity() {
    let gear = five("runout = { total_um = 10, high_tooth = 5.9 }");
    assert_eq!(gear.eccentricity(), 0.005);
    assert_eq!(gear.high_tooth(), 5.9);
}

/// Issue 5: pitch about the datum axis contains the eccentricity. First order (design section 6):
/// F_R = −e sin(ψ − α)/cos α, F_L = −e sin(ψ + α)/cos α, ψ from the high tooth to the flank.
#[test]
fn eccentricity_is_found_in_datum_axis_pitch() {
    let (teeth, e_um, high): (u32, f64, f64) = (44, 20.0, 12.5);
    let pitch_angle = std::f64::consts::TAU / f64::from(teeth);
    let alpha = 20f64.to_radians();
    // Half a nominal tooth: a quarter of the pitch.
    let flank = |ahead: f64| -> Vec<f64> {
        let place =
            |tooth: u32| (f64::from(tooth) - high) * pitch_angle + ahead * pitch_angle / 4.0;
        (1..=teeth)
            .map(|tooth| -e_um * (place(tooth) - ahead * alpha).sin() / alpha.cos())
            .collect()
    };
    let gear = format!(
        "teeth = {teeth}\nmodule_mm = 3\npressure_angle_deg = 20\npitch = {{ kind = \"cumulative\", axis = \"datum\", right_um = {:?}, left_um = {:?} }}",
        flank(1.0),
        flank(-1.0)
    );
    let text = format!(
        "[wheel]\n{gear}\n[pinion]\nteeth = 44\nmodule_mm = 3\npressure_angle_deg = 20\n[assembly]\ncenter_distance_mm = 132.2\n"
    );
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("datum.toml");
    std::fs::write(&file, text).unwrap();
    let study = gearlash_files::read(&file).unwrap();
    let wheel = &study.study.materials[0].1;
    // Second order: e²/r = 6e-3 µm.
    assert!(
        (wheel.eccentricity() * 1e3 - e_um).abs() < 0.01,
        "{}",
        wheel.eccentricity()
    );
    assert!(
        (wheel.high_tooth() - high).abs() < 0.01,
        "{}",
        wheel.high_tooth()
    );
    for tooth in 1..=teeth {
        let own_um = wheel.flank_offset(gearlash::gear::Side::Right, tooth) * 66.0 * 1e3;
        assert!(own_um.abs() < 0.01, "tooth {tooth}: {own_um} µm left");
    }
    assert!(
        study
            .warnings
            .iter()
            .any(|warning| warning.contains("eccentricity of 20.0"))
    );
}

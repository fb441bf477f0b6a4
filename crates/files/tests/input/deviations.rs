//! Runout, pitch and per-tooth thickness: each flank goes where the sheet says. `all_round/datum.rs` has pitch about the datum axis.

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

/// Thickness goes half to each side, the mean not removed (design section 3). On the front face numbers ascend clockwise, which is negative; each
/// flank counts about its mean. Single pitch is `f_i = F_i − F_{i−1}`. Plus material is along the numbers on right flanks, against them on left ones.
#[test]
fn each_flank_goes_where_the_sheet_says() {
    let pitched = ([2.0, 1.0, 0.0, -1.0, -2.0], [-1.0, -1.0, -1.0, -1.0, 4.0]);
    for (keys, (right, left)) in [
        (
            "thickness.per_tooth_um = [2, 4, 0, 0, -6]",
            ([-1.0, -2.0, 0.0, 0.0, 3.0], [1.0, 2.0, 0.0, 0.0, -3.0]),
        ),
        (
            "pitch = { kind = \"cumulative\", right_um = [1, 2, 3, 4, 5], left_um = [5, 5, 5, 5, 0] }",
            pitched,
        ),
        (
            "pitch = { kind = \"single\", right_um = [-4, 1, 1, 1, 1], left_um = [5, 0, 0, 0, -5] }",
            pitched,
        ),
        (
            "pitch = { kind = \"cumulative\", sense = \"material\", right_um = [1, 2, 3, 4, 5], left_um = [-5, -5, -5, -5, 0] }",
            pitched,
        ),
    ] {
        let gear = five(keys);
        for (side, expected) in [(Side::Right, right), (Side::Left, left)] {
            for (found, expected) in flanks_um(&gear, side).into_iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-9,
                    "{keys}: {found} {expected}"
                );
            }
        }
    }
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
    assert_eq!((gear.eccentricity(), gear.high_tooth()), (0.005, 5.9));
}

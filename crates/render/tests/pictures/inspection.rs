//! The deviations of a gear come back from its inspection.

use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Flank, Gear, GearDesign, Inspection, Pitch,
};
use std::f64::consts::TAU;

fn gear(face: Face, deviations: &Deviations) -> AsBuilt {
    let design = GearDesign {
        basic_data: BasicGearData::new(12, 3.0, 20f64.to_radians()).unwrap(),
        profile_shift: 0.2,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    };
    AsBuilt::new(Gear::nominal(design).unwrap(), face, deviations).unwrap()
}

/// Rounding of some ulps of the radius, mm.
const ROUNDING: f64 = 1e-14;

#[test]
fn pitch_of_either_face_comes_back() {
    let wave = |phase: f64| -> Vec<f64> {
        let tooth = |i| 1e-3 * f64::sin(phase + TAU * 2.0 * f64::from(i) / 12.0);
        (0..12).map(tooth).collect()
    };
    let curves = [wave(0.3), wave(1.9)];
    for face in [Face::Front, Face::Back] {
        let pitch = Pitch::from_cumulative(&curves[0], &curves[1]);
        let built = gear(
            face,
            &Deviations {
                pitch: Some(pitch),
                ..Deviations::default()
            },
        );
        let found = Inspection::of(&built);
        for (side, curve) in Flank::BOTH.into_iter().zip(&curves) {
            for (i, f) in curve.iter().enumerate() {
                assert!((found.cumulative(side)[i] - f).abs() < ROUNDING);
                let before = curve[(i + 11) % 12];
                assert!((found.single(side)[i] - (f - before)).abs() < 2.0 * ROUNDING);
            }
            let range = curve.iter().fold(f64::MIN, |a, b| a.max(*b))
                - curve.iter().fold(f64::MAX, |a, b| a.min(*b));
            assert!((found.total_cumulative(side) - range).abs() < 2.0 * ROUNDING);
        }
        // A right flank ahead of its left one, along ascending numbers, is thickness.
        let ahead = curves[0].iter().zip(&curves[1]);
        for (thicker, (right, left)) in found.thickness().iter().zip(ahead) {
            assert!((thicker - (right - left)).abs() < 2.0 * ROUNDING);
        }
    }
}

/// A tooth thicker by δ moves its right flank by δ/2 along ascending numbers and its left flank back.
#[test]
fn thickness_comes_back_and_shows_in_the_pitch() {
    let mut per_tooth = vec![0.0; 12];
    per_tooth[4] = 6e-3;
    for face in [Face::Front, Face::Back] {
        let per_tooth = per_tooth.clone();
        let found = Inspection::of(&gear(
            face,
            &Deviations {
                per_tooth,
                ..Deviations::default()
            },
        ));
        assert!((found.thickness()[4] - 6e-3).abs() < ROUNDING);
        assert!(found.thickness()[5].abs() < ROUNDING);
        assert!((found.single(Flank::Right)[4] - 3e-3).abs() < ROUNDING);
        assert!((found.single(Flank::Left)[4] + 3e-3).abs() < ROUNDING);
        assert!((found.largest_single(Flank::Right) - 3e-3).abs() < ROUNDING);
    }
}

#[test]
fn runout_is_a_cosine_from_the_high_tooth() {
    let deviations = Deviations {
        eccentricity: 5e-3,
        high_tooth: 4.0,
        ..Deviations::default()
    };
    let found = Inspection::of(&gear(Face::Back, &deviations));
    // cos 0, 60°, 90°, 180°.
    for (tooth, value) in [(4, 5e-3), (6, 2.5e-3), (7, 0.0), (10, -5e-3), (2, 2.5e-3)] {
        assert!(
            (found.runout()[tooth - 1] - value).abs() < ROUNDING,
            "{tooth}"
        );
    }
}

//! The deviations of a gear come back from its inspection.

use super::design::design;
use super::drawn::ends;
use gearlash::gear::{AsBuilt, Deviations, Face, Flank, Gear, GearDesign, Inspection, Pitch};
use std::f64::consts::TAU;

fn found(face: Face, deviations: Deviations) -> Inspection {
    let design = GearDesign {
        profile_shift: 0.2,
        ..design(12, 3.0)
    };
    let gear = Gear::nominal(design).unwrap();
    Inspection::of(&AsBuilt::new(gear, face, &deviations).unwrap())
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
        let deviations = Deviations {
            pitch: Some(Pitch::from_cumulative(&curves[0], &curves[1])),
            ..Deviations::default()
        };
        let found = found(face, deviations);
        for (side, curve) in Flank::BOTH.into_iter().zip(&curves) {
            for (i, f) in curve.iter().enumerate() {
                assert!((found.pitch.flank(side)[i] - f).abs() < ROUNDING);
                let before = curve[(i + 11) % 12];
                assert!((found.pitch.single(side)[i] - (f - before)).abs() < 2.0 * ROUNDING);
            }
            let [low, high] = ends(curve.iter().copied());
            assert!((found.pitch.total(side) - (high - low)).abs() < 2.0 * ROUNDING);
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
        let deviations = Deviations {
            per_tooth: per_tooth.clone(),
            ..Deviations::default()
        };
        let found = found(face, deviations);
        for (value, expected) in [
            (found.thickness()[4], 6e-3),
            (found.thickness()[5], 0.0),
            (found.pitch.single(Flank::Right)[4], 3e-3),
            (found.pitch.single(Flank::Left)[4], -3e-3),
            (found.pitch.greatest_single(Flank::Right), 3e-3),
        ] {
            assert!((value - expected).abs() < ROUNDING, "{value} {expected}");
        }
    }
}

#[test]
fn runout_is_a_cosine_from_the_high_tooth() {
    let deviations = Deviations {
        eccentricity: 5e-3,
        high_tooth: 4.0,
        ..Deviations::default()
    };
    let found = found(Face::Back, deviations);
    // cos 0, 60°, 90°, 180°.
    for (tooth, value) in [(4, 5e-3), (6, 2.5e-3), (7, 0.0), (10, -5e-3), (2, 2.5e-3)] {
        let off = found.runout()[tooth - 1] - value;
        assert!(off.abs() < ROUNDING, "{tooth}");
    }
}

//! Double-flank roll test.

use super::*;
use gearlash::analytic::InvolutePair;
use gearlash::mesh::{ContactKind, PoseClass};

fn eccentric(eccentricity: f64) -> AsBuilt {
    let deviations = Deviations {
        eccentricity,
        high_tooth: 1.0,
        ..Deviations::default()
    };
    let gear = Gear::nominal(blank(44, 3.0, 20.0, 0.0)).unwrap();
    AsBuilt::new(gear, Face::Front, &deviations).unwrap()
}

/// A perfect gear rolls at the distance of model 2 with zero play (closed form), and does not move.
#[test]
fn a_perfect_gear_does_not_move() {
    for (teeth, shift, thinner) in [
        (44, 0.0, 0.0),
        (21, 0.0, 0.02),
        (12, 0.4, 0.01),
        (86, -0.2, 0.03),
    ] {
        let blank = blank(teeth, 3.0, 20.0, shift);
        let gear = Gear::new(blank, blank.nominal_base_thickness() - thinner).unwrap();
        let part = AsBuilt::perfect(gear.clone(), Face::Front);
        let roll = measure(&part, Settings::default()).roll.unwrap();
        assert_eq!(roll.poses.len(), 16 * teeth as usize);
        let expected = InvolutePair::new(&gear, &roll.master)
            .center_distance(0.0)
            .unwrap();
        for pose in &roll.poses {
            assert_eq!(
                pose.class,
                PoseClass::Contact(ContactKind::Involute),
                "z {teeth}"
            );
            assert!(
                (pose.distance - expected).abs() <= pose.error,
                "z {teeth}: {} {expected}",
                pose.distance
            );
            assert!(pose.error < 2e-10);
        }
        assert!(roll.total() <= roll.error() && roll.tooth_to_tooth() <= roll.error());
    }
}

/// F_i'' ≈ 2 e of a pure eccentricity. Tight mesh keeps the distance of both centres at a_0, so
/// a'' = e cos χ + √(a_0² − e² sin² χ) about the axis: 2 e exactly between χ = 0 and π, and in between
/// −e² sin² χ/(2 a_0) below the cosine.
#[test]
fn an_eccentric_gear_moves_by_twice_its_eccentricity() {
    for e in [0.005, 0.02, 0.08] {
        let part = eccentric(e);
        let roll = measure(&part, Settings::default()).roll.unwrap();
        let a_0 = InvolutePair::new(part.gear(), &roll.master)
            .center_distance(0.0)
            .unwrap();
        for pose in &roll.poses {
            let chi = pose.rotation;
            let expected = e * chi.cos() + (a_0 * a_0 - (e * chi.sin()).powi(2)).sqrt();
            assert!(
                (pose.distance - expected).abs() < 1e-9,
                "{e} {chi}: {} {expected}",
                pose.distance
            );
        }
        assert!(
            (roll.total() - 2.0 * e).abs() < 2.0 * e * 1e-4,
            "{e}: {}",
            roll.total()
        );
        assert!(roll.tooth_to_tooth() < roll.total());
    }
}

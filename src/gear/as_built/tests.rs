//! Root lands, and gears that are made and varied.

use super::*;
use crate::gear::{GearDesign, Profile, Side};
use std::f64::consts::TAU;

/// Both half teeth of a space end in the same direction, on either face, whatever the deviations; the land
/// widens and narrows with the space, and a space closed at its root leaves none.
#[test]
fn root_lands_meet_in_the_middle_of_the_space() {
    let design = GearDesign::plain(20, 2.0);
    let gear = design.gear();
    let mut right = vec![0.0; 20];
    (right[4], right[9]) = (0.9, -0.9);
    let deviations = Deviations {
        per_tooth: (0..20).map(|k| 0.01 * f64::from(k % 3)).collect(),
        ..Deviations::default().with_pitch(&right, &[0.0; 20])
    };
    let (start, middle) = Profile::new(&gear).range(ProfilePart::Root);
    for face in [Face::Front, Face::Back] {
        let built = design.built(face, &deviations);
        let end = |side: Side, tooth: u32| {
            let turned = built.tooth_angle(f64::from(tooth)) + built.flank_offset(side, tooth);
            turned + side.sense() * built.root_end(side, tooth)
        };
        for tooth in 1..=20 {
            let next = built.counter_clockwise(tooth, 1);
            let apart = end(Side::Left, tooth) - end(Side::Right, next);
            let closed = built.root_end(Side::Left, tooth) == start;
            let whole = apart - TAU * (apart / TAU).round();
            assert!(closed || whole.abs() < 1e-14, "{whole} at tooth {tooth}");
        }
        let ends = (1..=20).map(|tooth| built.root_end(Side::Right, tooth));
        let (least, most) = ends.fold((middle, middle), |(l, m), e| (l.min(e), m.max(e)));
        assert!(least == start && most > middle + 0.02);
    }
}

/// In two steps as in one.
#[test]
fn a_gear_varied_is_the_gear_made_so() {
    let design = GearDesign::plain(30, 2.0);
    let deviations = |thick: f64, phase: f64| {
        let wave = |phase: f64| -> Vec<f64> {
            let each = 0..30;
            each.map(|k| 0.004 * (f64::from(k) + phase).sin()).collect()
        };
        Deviations {
            per_tooth: vec![thick; 30],
            ..Deviations::off_axis(0.01, 3.0).with_pitch(&wave(phase), &wave(2.0 * phase))
        }
    };
    let (own, further) = (deviations(0.0, 1.0), deviations(0.002, 0.3));
    for (face, turned) in [(Face::Front, Face::Back), (Face::Back, Face::Front)] {
        let varied = design.built(face, &own).varied(-0.05, &further).unwrap();
        let base = design.nominal_base_thickness() - 0.05 * 20f64.to_radians().cos();
        let gear = Gear::new(design, base).unwrap();
        let built = |face, stated| AsBuilt::new(gear.clone(), face, stated).unwrap();
        let (own, other) = (built(face, &own), built(face, &further));
        assert_eq!(other.facing(turned), built(turned, &further));
        assert_eq!(varied.gear(), own.gear());
        assert_eq!((varied.eccentricity(), varied.high_tooth()), (0.01, 3.0));
        for (side, tooth) in (1..=30).flat_map(|tooth| Side::BOTH.map(|side| (side, tooth))) {
            let sum = own.flank_offset(side, tooth) + other.flank_offset(side, tooth);
            assert!((varied.flank_offset(side, tooth) - sum).abs() < 1e-16);
        }
    }
}

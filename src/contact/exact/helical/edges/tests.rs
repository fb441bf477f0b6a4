use super::super::turning::tests::{pair, posed};
use super::*;
use crate::gear::Side;
use crate::pair::Member;

/// At either rotation the circles touch: the centres of the outlines are as far apart as the sum of both radii. Source:
/// the distance of the centres over 3600 rotations.
#[test]
fn circles_about_both_centres_touch_at_the_tangent_rotations() {
    for (eccentricity, locked) in [
        ([0.3, 0.5], Member::Wheel),
        ([0.5, 0.2], Member::Pinion),
        ([0.0, 0.4], Member::Wheel),
    ] {
        let pair = pair([19, 14], 20.0, eccentricity, 0.3, locked);
        for side in Side::BOTH {
            let problem = FlankProblem::new(&pair, side);
            let here = posed(&pair, &problem, 0.45);
            let apart = |rotation: f64| (here.free_centre_at(rotation) - here.centre).norm();
            let all = || (0..3600).map(|k| apart(f64::from(k) * PI / 1800.0));
            let (least, most) = (all().fold(f64::MAX, f64::min), all().fold(0.0, f64::max));
            for k in -2..=12 {
                let sum = least + (most - least) * (f64::from(k) + 0.5) / 11.0;
                let found = tangent_rotations(&here, sum);
                assert_eq!(found.is_some(), sum > least && sum < most, "{k}");
                let Some([one, other]) = found else { continue };
                assert!((apart(one) - sum).abs() < 1e-12 && (apart(other) - sum).abs() < 1e-12);
                assert!(reduced(one - other).abs() > 1e-3);
            }
        }
    }
}

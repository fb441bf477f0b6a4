//! Hard pairs: extremes end within their counted effort, and say so.

use super::ExactKernel;
use super::extremes::{End, cycle_extremes, cycle_extremes_within};
use crate::contact::effort::Effort;
use crate::error::go_on;
use crate::gear::{AsBuilt, Deviations, Face, GearDesign, Hand};
use crate::pair::{GearPair, Mating};

/// Pairs of 7/31 and 40/61 teeth, β 45°, whose poses and extremes had no end (killed after 40 s and 280 s). The bracket
/// states what is known when the effort ends.
#[test]
fn extremes_of_wild_helical_pairs_end_by_their_effort() {
    for (teeth, face, runout, pitch, farther) in [
        ([7, 31], 200.0, 0.06, 0.015, 0.2),
        ([7, 31], 20.0, 1.5, 0.3, 0.2),
        ([40, 61], 200.0, 1.5, 0.3, 3.4),
    ] {
        // A multiplicative pseudo-random sequence, equal on every machine.
        let mut state = 7u64;
        let mut drawn = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            pitch * (2.0 * (state >> 11) as f64 / (1u64 << 53) as f64 - 1.0)
        };
        let mut gear = |teeth: u32, hand, face| -> AsBuilt {
            let design = GearDesign::plain(teeth, 2.0).helical(45.0, hand);
            let mut curve = || -> Vec<f64> { (0..teeth).map(|_| drawn()).collect() };
            let deviations = Deviations::off_axis(0.5 * runout, 2.0).with_pitch(&curve(), &curve());
            design.shifted(0.3).built(face, &deviations)
        };
        let wheel = gear(teeth[0], Hand::Right, Face::Front);
        let pinion = gear(teeth[1], Hand::Left, Face::Back);
        let radii = [&wheel, &pinion].map(|gear| gear.gear().basic_data().reference_radius());
        let pair = GearPair::new(wheel, pinion, radii[0] + radii[1] + farther).unwrap();
        let pair = pair.with_face([0.0, face]).unwrap();
        let kernel = ExactKernel::new(&pair);
        let effort = Effort::of_extremes(&pair, &go_on);
        let matings = u64::from(teeth[0] * teeth[1]);
        let over = (Mating::FIRST, matings);
        let found = cycle_extremes_within(&kernel, &pair, over, 1e-6, &effort, &End::BOTH);
        let found = found.unwrap();
        let used = effort.used();
        assert!(2 * effort.left() >= used, "{teeth:?}: {used}");
        for extreme in [found.least, found.greatest].into_iter().flatten() {
            assert!(extreme.low <= extreme.high, "{teeth:?}: {extreme:?}");
        }
        // An interrupted search is also reproducible.
        let again = cycle_extremes(&kernel, &pair, over.0, matings, 1e-6).unwrap();
        assert_eq!(found, again);
    }
}

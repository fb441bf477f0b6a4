//! Pairs of unit tests.

use super::{GearPair, Member};
use crate::gear::{Deviations, Face, GearDesign};

impl GearPair {
    /// Plain gears of module 2 with these eccentricities.
    pub(crate) fn plain(
        teeth: [u32; 2],
        eccentricities: [f64; 2],
        distance: f64,
        locked: Member,
    ) -> GearPair {
        let gear = |kind: usize, face| {
            let deviations = Deviations::off_axis(eccentricities[kind], 2.5);
            GearDesign::plain(teeth[kind], 2.0).built(face, &deviations)
        };
        let (wheel, pinion) = (gear(0, Face::Front), gear(1, Face::Back));
        GearPair::with_locked(wheel, pinion, distance, locked).unwrap()
    }
}

//! Poses all over a mesh cycle.

use gearlash::gear::Side;
use gearlash::pair::{GearPair, Mating, Member, Pose, SweepPlan};

/// Where a cycle begins.
pub const FIRST: Mating = Mating {
    wheel_tooth: 1,
    pinion_tooth: 1,
    flank: Side::Right,
    fraction: 0.0,
};

/// Matings of the cycle.
pub fn matings(pair: &GearPair) -> u64 {
    let teeth = |member| pair.gear(member).gear().basic_data().teeth();
    SweepPlan::hunting_pitches(teeth(Member::Wheel), teeth(Member::Pinion))
}

/// `count` poses spread over it by the golden ratio.
pub fn spread(pair: &GearPair, count: u32) -> impl Iterator<Item = Pose> {
    let cycle = matings(pair) as f64;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    (0..count).map(move |k| {
        let pitches = cycle * (f64::from(k) * golden).fract();
        Pose::new(pair, FIRST.onward(pair, pitches))
    })
}

//! Poses all over a mesh cycle.

use gearlash::pair::{GearPair, Mating, Member, Pose, SweepPlan};

/// Matings of the cycle.
pub fn matings(pair: &GearPair) -> u64 {
    let [wheel, pinion] = Member::BOTH.map(|member| pair.teeth(member));
    SweepPlan::hunting_pitches(wheel, pinion)
}

/// `count` poses spread over it by the golden ratio.
pub fn spread(pair: &GearPair, count: u32) -> impl Iterator<Item = Pose> {
    let cycle = matings(pair) as f64;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    (0..count).map(move |k| {
        let pitches = cycle * (f64::from(k) * golden).fract();
        Pose::new(pair, Mating::FIRST.onward(pair, pitches))
    })
}

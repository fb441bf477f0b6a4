//! Helical pairs that tests are about: one of a prototype, and others drawn at random.

use super::*;
use crate::random::{Random, either};

/// A gear with random pitch deviations.
fn rough(gear: Make, pitch_um: f64, rng: &mut Random) -> Make {
    if pitch_um == 0.0 {
        return gear;
    }
    let teeth = gear.design.basic_data.teeth();
    let mut curve = || Vec::from_iter((0..teeth).map(|_| rng.within(-1.7e-3, 1.7e-3) * pitch_um));
    let [right, left] = [curve(), curve()];
    gear.pitch(&right, &left)
}

/// A pair that a slow program of slices was tried on: 27/51, m_n 4.5, β 21°, a 190 mm, −140 µm each; runout and pitch as given, µm.
pub fn pair_of_the_prototype(
    runouts: [f64; 2],
    pitch_um: [f64; 2],
    hand: Hand,
    seed: u64,
) -> GearPair {
    let mut rng = Random(seed);
    let mut one = |z, shift, hand, k: usize| {
        let gear = spur(z, 4.5).rack(1.0, 1.25, 0.25).helix(21.0, hand);
        let gear = gear.shift(shift).allowance(-0.14);
        let gear = gear.runout(runouts[k] * 1e-3 / 2.0, [4.0, 17.0][k]);
        rough(gear, pitch_um[k], &mut rng).front()
    };
    let wheel = one(27, 0.3, hand, 0);
    let pinion = one(51, 0.162_830_198_591_676_3, hand.mate(), 1);
    GearPair::new(wheel, pinion, 190.0).unwrap()
}

/// The next pair of [`try_drawn`] that exists; `warm` ones have base pitches that differ by up to 1 %.
pub fn drawn(rng: &mut Random, warm: bool) -> GearPair {
    loop {
        let mut pair = try_drawn(rng);
        if warm {
            let factors = [0, 1].map(|_| 1.0 + rng.within(-5e-3, 5e-3));
            pair = pair.and_then(|pair| expanded(&pair, factors));
        }
        if let Some(pair) = pair {
            return pair;
        }
    }
}

/// `pair` with the lengths of its gears multiplied by `factors`; centre distance and face stay.
pub fn expanded(pair: &GearPair, factors: [f64; 2]) -> Option<GearPair> {
    let [wheel, pinion] = [0, 1].map(|k| pair.gear(Member::BOTH[k]).expanded(factors[k]).ok());
    let (distance, locked) = (pair.center_distance(), pair.locked());
    let warm = GearPair::with_locked(wheel?, pinion?, distance, locked).ok()?;
    warm.with_face(pair.face()).ok()
}

fn play_free(wheel: &AsBuilt, pinion: &AsBuilt) -> f64 {
    let near = [wheel, pinion].map(|gear| gear.gear().basic_data().reference_radius());
    let pair = InvolutePair::new(wheel.gear(), pinion.gear());
    pair.center_distance(0.0).unwrap_or(near[0] + near[1])
}

/// A pair drawn from beyond what anybody makes, and its face; `None` where no such pair exists.
pub fn try_drawn(rng: &mut Random) -> Option<GearPair> {
    let beta = f64::to_radians(rng.within(1.0, 45.0));
    let alpha = f64::to_radians(rng.within(14.0, 28.0));
    let module = 2.0;
    let lengths = [(0.7, 1.35), (1.2, 1.5), (0.0, 0.3)];
    let [addendum, dedendum, round] = lengths.map(|(least, most)| rng.within(least, most));
    let rack = BasicRack::new(addendum, dedendum, round).ok()?;
    let mut one = |hand| {
        let z = rng.within(7.0, 70.0) as u32;
        let data = BasicGearData::new(z, module, alpha).ok()?;
        let mut gear = Make::of(GearDesign::standard(data.with_helix(beta, hand).ok()?));
        gear.design.rack = rack;
        let gear = gear.shift(rng.within(-0.5, 0.6));
        let gear = gear.allowance(rng.within(-0.1, 0.0));
        let eccentricity = rng.within(0.0, 0.06) / 2.0;
        let gear = gear.runout(eccentricity, rng.within(1.0, f64::from(z)));
        let pitch_um = rng.within(0.0, 8.0);
        let face = either(rng, [Face::Front, Face::Back]);
        rough(gear, pitch_um, rng).try_built(face)
    };
    let (wheel, pinion) = (one(Hand::Right)?, one(Hand::Left)?);
    let distance = play_free(&wheel, &pinion) + rng.within(-0.1, 0.4) * module;
    let locked = either(rng, Member::BOTH);
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let (from, width) = (rng.within(-40.0, 20.0), rng.within(0.0, 60.0));
    pair.with_face([from, from + width]).ok()
}

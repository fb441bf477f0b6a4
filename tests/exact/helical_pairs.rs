//! Helical pairs that tests are about: one of a prototype, and others drawn at random.

use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Pitch, thickness,
};
use gearlash::pair::{GearPair, Member};
use std::ops::Range;

/// SplitMix64 (Steele, Lea, Flood 2014).
pub struct Draws(pub u64);

impl Draws {
    pub fn within(&mut self, range: Range<f64>) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64;
        range.start + (range.end - range.start) * unit
    }

    pub fn whole(&mut self, range: Range<u32>) -> u32 {
        self.within(f64::from(range.start)..f64::from(range.end)) as u32
    }

    pub fn coin(&mut self) -> bool {
        self.within(0.0..1.0) < 0.5
    }
}

/// The data of a test's gear.
#[derive(Clone, Copy)]
pub(super) struct Made {
    pub z: u32,
    pub shift: f64,
    pub allowance: f64,
    pub runout: f64,
    pub high_tooth: f64,
    pub pitch_um: f64,
}

pub(super) fn gear(
    made: Made,
    data: BasicGearData,
    rack: BasicRack,
    face: Face,
    rng: &mut Draws,
) -> Option<AsBuilt> {
    let design = GearDesign {
        profile_shift: made.shift,
        rack,
        ..GearDesign::standard(data)
    };
    let base =
        thickness::base_from_allowance(&data, design.nominal_base_thickness(), made.allowance);
    let mut curve = || -> Vec<f64> {
        (0..made.z)
            .map(|_| rng.within(-1.7e-3..1.7e-3) * made.pitch_um)
            .collect()
    };
    let deviations = Deviations {
        pitch: (made.pitch_um > 0.0).then(|| Pitch::from_cumulative(&curve(), &curve())),
        eccentricity: made.runout / 2.0,
        high_tooth: made.high_tooth,
        ..Deviations::default()
    };
    AsBuilt::new(Gear::new(design, base).ok()?, face, &deviations).ok()
}

/// A pair that a slow program of slices was tried on: 27/51, m_n 4.5, β 21°, a 190 mm, −140 µm each; runout and pitch as given, µm.
pub fn pair_of_the_prototype(
    runouts: [f64; 2],
    pitch_um: [f64; 2],
    hand: Hand,
    seed: u64,
) -> GearPair {
    let mut rng = Draws(seed);
    let mut one = |z, shift, hand, index: usize| {
        let data = BasicGearData::new(z, 4.5, 20f64.to_radians()).unwrap();
        let data = data.with_helix(21f64.to_radians(), hand).unwrap();
        let made = Made {
            z,
            shift,
            allowance: -0.14,
            runout: runouts[index] * 1e-3,
            high_tooth: [4.0, 17.0][index],
            pitch_um: pitch_um[index],
        };
        gear(
            made,
            data,
            BasicRack::new(1.0, 1.25, 0.25).unwrap(),
            Face::Front,
            &mut rng,
        )
        .unwrap()
    };
    let (wheel, pinion) = (
        one(27, 0.3, hand, 0),
        one(51, 0.162_830_198_591_676_3, hand.mate(), 1),
    );
    GearPair::new(wheel, pinion, 190.0).unwrap()
}

/// A pair drawn from beyond what anybody makes, its face, and poses of it; `None` where no such pair exists.
pub fn drawn(rng: &mut Draws) -> Option<GearPair> {
    let beta = f64::to_radians(rng.within(1.0..45.0));
    let alpha = f64::to_radians(rng.within(14.0..28.0));
    let module = 2.0;
    let rack = BasicRack::new(
        rng.within(0.7..1.35),
        rng.within(1.2..1.5),
        rng.within(0.0..0.3),
    )
    .ok()?;
    let mut one = |hand| {
        let z = rng.whole(7..70);
        let data = BasicGearData::new(z, module, alpha)
            .ok()?
            .with_helix(beta, hand)
            .ok()?;
        let made = Made {
            z,
            shift: rng.within(-0.5..0.6),
            allowance: rng.within(-0.1..0.0),
            runout: rng.within(0.0..0.06),
            high_tooth: rng.within(1.0..f64::from(z)),
            pitch_um: rng.within(0.0..8.0),
        };
        let face = if rng.coin() { Face::Front } else { Face::Back };
        gear(made, data, rack, face, rng)
    };
    let (wheel, pinion) = (one(Hand::Right)?, one(Hand::Left)?);
    let zero = {
        let near = wheel.gear().basic_data().reference_radius()
            + pinion.gear().basic_data().reference_radius();
        let pair = gearlash::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
        pair.center_distance(0.0).unwrap_or(near)
    };
    let distance = zero + rng.within(-0.1..0.4) * module;
    let locked = if rng.coin() {
        Member::Wheel
    } else {
        Member::Pinion
    };
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let (from, width) = (rng.within(-40.0..20.0), rng.within(0.0..60.0));
    pair.with_face([from, from + width]).ok()
}

/// A pair drawn from far beyond that: stub, long and sharp racks, 3 to 400 teeth, runout of 1.5 modules, tips that hardly reach each other; its face.
pub(super) fn drawn_wide(rng: &mut Draws) -> Option<GearPair> {
    let beta = f64::to_radians(rng.within(0.5..50.0));
    let alpha = f64::to_radians(rng.within(14.5..30.0));
    let module = 2.0;
    let stub = (
        rng.within(0.5..0.8),
        rng.within(0.7..1.0),
        rng.within(0.0..0.3),
    );
    let any = (
        rng.within(0.7..1.3),
        rng.within(1.0..1.5),
        rng.within(0.0..0.4),
    );
    let (addendum, dedendum, round) = match rng.whole(0..5) {
        0 => stub,
        1 => (1.3, 1.5, rng.within(0.0..0.2)),
        2 => (1.0, 1.25, 0.0),
        _ => any,
    };
    let rack = BasicRack::new(addendum, dedendum, round).ok()?;
    let mut one = |hand| {
        let z = match rng.whole(0..4) {
            0 => rng.whole(3..12),
            1 => rng.whole(100..400),
            _ => rng.whole(7..80),
        };
        let data = BasicGearData::new(z, module, alpha).ok()?;
        let data = data.with_helix(beta, hand).ok()?;
        let rough = rng.coin();
        let made = Made {
            z,
            shift: rng.within(-0.6..1.2),
            allowance: if rough {
                rng.within(-0.3..0.25) * module
            } else {
                rng.within(-0.1..0.0)
            },
            runout: if rng.coin() {
                rng.within(0.0..1.5) * module
            } else {
                rng.within(0.0..0.06)
            },
            high_tooth: rng.within(1.0..f64::from(z)),
            pitch_um: if rough {
                rng.within(0.0..600.0)
            } else {
                rng.within(0.0..8.0)
            },
        };
        let face = if rng.coin() { Face::Front } else { Face::Back };
        gear(made, data, rack, face, rng)
    };
    let (wheel, pinion) = (one(Hand::Right)?, one(Hand::Left)?);
    let near = wheel.gear().basic_data().reference_radius()
        + pinion.gear().basic_data().reference_radius();
    let formula = gearlash::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
    let zero = formula.center_distance(0.0).unwrap_or(near);
    let farther = if rng.coin() {
        rng.within(-0.1..0.4)
    } else {
        rng.within(-0.5..2.0)
    };
    let locked = if rng.coin() {
        Member::Wheel
    } else {
        Member::Pinion
    };
    let distance = zero + farther * module;
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let from = rng.within(-40.0..20.0);
    let width = if rng.coin() {
        rng.within(0.0..60.0)
    } else {
        rng.within(0.0..10.0)
    };
    pair.with_face([from, from + width]).ok()
}

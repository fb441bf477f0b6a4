//! Helical pairs that tests are about: one of a prototype, and others drawn at random.

use crate::random::{Random, either};
use gearlash::analytic::InvolutePair;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Pitch, thickness,
};
use gearlash::pair::{GearPair, Member};

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
    rng: &mut Random,
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
            .map(|_| rng.within(-1.7e-3, 1.7e-3) * made.pitch_um)
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
    let mut rng = Random(seed);
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

/// The next pair of [`try_drawn`] that exists; `warm` ones have base pitches that differ by up to 1 %.
pub fn drawn(rng: &mut Random, warm: bool) -> GearPair {
    loop {
        let pair = try_drawn(rng);
        let drawn = if warm {
            let factors = [0, 1].map(|_| 1.0 + rng.within(-5e-3, 5e-3));
            pair.and_then(|pair| expanded(&pair, factors))
        } else {
            pair
        };
        if let Some(drawn) = drawn {
            return drawn;
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
    let rack = BasicRack::new(
        rng.within(0.7, 1.35),
        rng.within(1.2, 1.5),
        rng.within(0.0, 0.3),
    )
    .ok()?;
    let mut one = |hand| {
        let z = rng.within(7.0, 70.0) as u32;
        let data = BasicGearData::new(z, module, alpha)
            .ok()?
            .with_helix(beta, hand)
            .ok()?;
        let made = Made {
            z,
            shift: rng.within(-0.5, 0.6),
            allowance: rng.within(-0.1, 0.0),
            runout: rng.within(0.0, 0.06),
            high_tooth: rng.within(1.0, f64::from(z)),
            pitch_um: rng.within(0.0, 8.0),
        };
        let face = either(rng, [Face::Front, Face::Back]);
        gear(made, data, rack, face, rng)
    };
    let (wheel, pinion) = (one(Hand::Right)?, one(Hand::Left)?);
    let distance = play_free(&wheel, &pinion) + rng.within(-0.1, 0.4) * module;
    let locked = either(rng, Member::BOTH);
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let (from, width) = (rng.within(-40.0, 20.0), rng.within(0.0, 60.0));
    pair.with_face([from, from + width]).ok()
}

/// A pair drawn from far beyond that: stub, long and sharp racks, 3 to 400 teeth, runout of 1.5 modules, tips that hardly reach each other; its face.
pub fn drawn_wide(rng: &mut Random) -> Option<GearPair> {
    let beta = f64::to_radians(rng.within(0.5, 50.0));
    let alpha = f64::to_radians(rng.within(14.5, 30.0));
    let module = 2.0;
    let stub = (
        rng.within(0.5, 0.8),
        rng.within(0.7, 1.0),
        rng.within(0.0, 0.3),
    );
    let any = (
        rng.within(0.7, 1.3),
        rng.within(1.0, 1.5),
        rng.within(0.0, 0.4),
    );
    let (addendum, dedendum, round) = match rng.within(0.0, 5.0) as u32 {
        0 => stub,
        1 => (1.3, 1.5, rng.within(0.0, 0.2)),
        2 => (1.0, 1.25, 0.0),
        _ => any,
    };
    let rack = BasicRack::new(addendum, dedendum, round).ok()?;
    let mut one = |hand| {
        let z = match rng.within(0.0, 4.0) as u32 {
            0 => rng.within(3.0, 12.0) as u32,
            1 => rng.within(100.0, 400.0) as u32,
            _ => rng.within(7.0, 80.0) as u32,
        };
        let data = BasicGearData::new(z, module, alpha).ok()?;
        let data = data.with_helix(beta, hand).ok()?;
        let rough = rng.chance(0.5);
        let made = Made {
            z,
            shift: rng.within(-0.6, 1.2),
            allowance: if rough {
                rng.within(-0.3, 0.25) * module
            } else {
                rng.within(-0.1, 0.0)
            },
            runout: if rng.chance(0.5) {
                rng.within(0.0, 1.5) * module
            } else {
                rng.within(0.0, 0.06)
            },
            high_tooth: rng.within(1.0, f64::from(z)),
            pitch_um: if rough {
                rng.within(0.0, 600.0)
            } else {
                rng.within(0.0, 8.0)
            },
        };
        let face = either(rng, [Face::Front, Face::Back]);
        gear(made, data, rack, face, rng)
    };
    let (wheel, pinion) = (one(Hand::Right)?, one(Hand::Left)?);
    let zero = play_free(&wheel, &pinion);
    let farther = if rng.chance(0.5) {
        rng.within(-0.1, 0.4)
    } else {
        rng.within(-0.5, 2.0)
    };
    let locked = either(rng, Member::BOTH);
    let distance = zero + farther * module;
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let from = rng.within(-40.0, 20.0);
    let width = if rng.chance(0.5) {
        rng.within(0.0, 60.0)
    } else {
        rng.within(0.0, 10.0)
    };
    pair.with_face([from, from + width]).ok()
}

//! Gears whose flanks have dense measured traces: bounds of how far flanks stand out against the search of all their pieces.

use crate::random::Random;
use gearlash::contact::{ExactKernel, OutlineKernel, Status};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Modification, Pitch,
    Side, Trace,
};
use gearlash::outline::{OutlineGear, OutlinePair};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// A trace of 30 to 500 points: two waves, noise of up to 1.5 µm from point to point, at times a step or nothing of all that.
fn trace(random: &mut Random, gear: &Gear, tooth: Option<u32>) -> Trace {
    let um = 1e-3;
    let count = 30 + random.bits() % 470;
    let waves = [0, 1].map(|_| {
        let amount = um * random.within(0.0, 6.0);
        (amount, random.within(1.0, 40.0), random.within(0.0, TAU))
    });
    let noise = um * random.decades(0.001, 1.5);
    let step = if random.chance(0.2) {
        (random.within(0.0, 1.0), um * random.within(-5.0, 5.0))
    } else {
        (2.0, 0.0)
    };
    let (from, to) = (gear.form_roll().max(1e-4), gear.tip_roll());
    let point = |k: u64| {
        let share = k as f64 / (count - 1) as f64;
        let wave = |(amount, times, phase): (f64, f64, f64)| amount * (times * share + phase).sin();
        let rough = noise * random.within(-1.0, 1.0);
        let stepped = if share > step.0 { step.1 } else { 0.0 };
        (
            from + (to - from) * share,
            waves.into_iter().map(wave).sum::<f64>() + rough + stepped,
        )
    };
    Trace {
        tooth,
        points: (0..count).map(point).collect(),
    }
}

/// A gear of 18 to 60 teeth, eccentric, pitches off by up to 10 µm, with traces of one, some or all teeth, of one side or both.
fn gear(random: &mut Random, module: f64, face: Face) -> Option<AsBuilt> {
    let teeth = 18 + (random.bits() % 43) as u32;
    let gear = Gear::nominal(GearDesign {
        basic_data: BasicGearData::new(teeth, module, 20f64.to_radians()).ok()?,
        profile_shift: random.within(-0.1, 0.5),
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    })
    .ok()?;
    let mut profile = |gear: &Gear| {
        let traces = match random.bits() % 4 {
            0 => Vec::new(),
            1 => vec![trace(random, gear, None)],
            2 => vec![trace(random, gear, Some(1)), trace(random, gear, Some(4))],
            _ => {
                let each = (1..=teeth).map(|tooth| trace(random, gear, Some(tooth)));
                each.collect()
            }
        };
        Modification {
            traces,
            slope: 1e-3 * random.within(-5.0, 5.0),
            crowning: 1e-3 * random.within(0.0, 6.0),
            ..Modification::default()
        }
    };
    let profiles = [profile(&gear), profile(&gear)];
    let mut places = || -> Vec<f64> {
        (0..teeth)
            .map(|_| 0.010 * random.within(-1.0, 1.0))
            .collect()
    };
    let pitch = Some(Pitch::from_cumulative(&places(), &places()));
    let eccentricity = if random.chance(0.3) {
        0.0
    } else {
        0.01 * module * random.within(0.0, 1.0)
    };
    let deviations = Deviations {
        pitch,
        eccentricity,
        high_tooth: 1.0 + random.within(0.0, 0.99) * f64::from(teeth),
        profiles,
        ..Deviations::default()
    };
    AsBuilt::new(gear, face, &deviations).ok()
}

fn pair(random: &mut Random) -> Option<GearPair> {
    let module = random.decades(0.5, 6.0);
    let (wheel, pinion) = (
        gear(random, module, Face::Front)?,
        gear(random, module, Face::Back)?,
    );
    let radius = |gear: &AsBuilt| {
        let gear = gear.gear();
        gear.basic_data().reference_radius() + module * gear.design().profile_shift
    };
    let distance = radius(&wheel) + radius(&pinion) + module * random.within(-0.06, 0.25);
    let locked = if random.chance(0.5) {
        Member::Wheel
    } else {
        Member::Pinion
    };
    GearPair::with_locked(wheel, pinion, distance, locked).ok()
}

/// Four poses of a random pair against the search over all pieces of its outlines: the same contacts within both bounds.
fn compare(seed: u64) -> Option<Vec<Status>> {
    let mut random = Random(seed ^ 0x7ace_d000);
    let pair = pair(&mut random)?;
    let gear = |member| OutlineGear::from(pair.gear(member));
    let (wheel, pinion) = (gear(Member::Wheel), gear(Member::Pinion));
    let outlines = OutlinePair::new(wheel, pinion, pair.center_distance(), pair.locked()).unwrap();
    let search = OutlineKernel::new(&outlines);
    let exact = ExactKernel::new(&pair);
    let locked = pair.gear(pair.locked());
    let onward = -locked.face().ascending() / locked.gear().basic_data().angular_pitch();
    let met = (0..4).map(|_| {
        let mating = Mating {
            wheel_tooth: random.tooth(18),
            pinion_tooth: random.tooth(18),
            flank: if random.chance(0.5) {
                Side::Right
            } else {
                Side::Left
            },
            fraction: random.within(-0.5, 0.5),
        };
        // Outlines have another zero of their rotation.
        let off =
            outlines.rotation(pair.locked(), &mating) - Pose::new(&pair, mating).locked_rotation();
        let pose = Pose::new(&pair, mating.onward(&pair, onward * off));
        let found = exact.lost_motion(&pose).unwrap();
        let witness = search.lost_motion(&mating).unwrap();
        for (one, other) in [(found.right, witness.right), (found.left, witness.left)] {
            assert_eq!(one.is_some(), other.is_some(), "{seed}");
            let Some((one, other)) = one.zip(other) else {
                continue;
            };
            let off = (one.rotation - other.rotation) / TAU;
            let off = TAU * (off - off.round()).abs();
            // The last term is what both rotations of the locked gear differ by.
            let bound = one.error + other.error + 1e-13;
            assert!(
                off <= bound,
                "{seed}: {off:e} above {bound:e}: {one:?} {other:?}"
            );
        }
        found.status()
    });
    Some(met.collect())
}

/// Source: the search over pairs of pieces of outlines, which uses nothing of base circles, rolls or heights.
#[test]
fn dense_traces_touch_where_the_search_finds_them_to() {
    let met: Vec<Status> = (0..SEEDS)
        .into_par_iter()
        .filter_map(compare)
        .flatten()
        .collect();
    let count = |status| met.iter().filter(|met| **met == status).count();
    let found = [Status::Clear, Status::Interference].map(count);
    println!("{} poses, {found:?}", met.len());
    assert!(
        met.len() as u64 > 3 * SEEDS && found.iter().all(|&count| count > 20),
        "{found:?}"
    );
}

/// Pairs drawn.
const SEEDS: u64 = 120;

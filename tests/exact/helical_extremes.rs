//! Proven extremes of helical pairs against poses of the exact method over the same face, which know nothing of their bounds.

use crate::extremes::cycle::{matings, spread};
use crate::helical_pairs::{Draws, drawn, pair_of_the_prototype};
use gearlash::contact::{Doubt, ExactKernel, Extremes};
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign, Hand};
use gearlash::pair::{GearPair, Mating, Pose};
use std::f64::consts::TAU;

/// Width of a bracket, mm.
const WIDTH: f64 = 1e-6;

/// Values of one pose are known to 1e-10 mm at the very worst (rounding).
const ROUNDING: f64 = 1e-10;

/// The extremes of `pair`, after `count` poses of its cycle were found within them.
pub fn held(pair: &GearPair, count: u32) -> Extremes {
    let kernel = ExactKernel::new(pair);
    let found = kernel
        .extremes(pair, Mating::FIRST, matings(pair), WIDTH)
        .unwrap();
    let radius = pair.operating_pitch_radius(pair.free());
    for pose in spread(pair, count) {
        let Some(angle) = kernel.lost_motion(&pose).unwrap().angle() else {
            continue;
        };
        let j = angle * radius;
        if let Some(least) = found.least.filter(|e| e.low.is_finite()) {
            assert!(j >= least.low - ROUNDING, "{j} below {least:?}");
        }
        if let Some(most) = found
            .greatest
            .filter(|one| one.is_proven() || one.doubt == Some(Doubt::Effort))
        {
            assert!(j <= most.high + ROUNDING, "{j} above {most:?}");
        }
    }
    found
}

/// The prototype's pair, of six curves of pitch each: proven both ways at any width, and the least no greater of the wider.
#[test]
fn ordinary_helical_pairs_are_proven_and_hold() {
    for seed in 0..6 {
        let mut last = [f64::INFINITY; 2];
        for width in [0.0, 1.0, 12.5, 25.0, 50.0, 100.0] {
            let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, seed);
            let pair = pair.with_face([-0.5 * width, 0.5 * width]).unwrap();
            let found = held(&pair, 300);
            let ends = [found.least, found.greatest].map(Option::unwrap);
            for (end, last) in ends.iter().zip(&mut last) {
                assert!(end.is_proven() && end.high - end.low <= WIDTH + ROUNDING);
                assert!(end.low <= *last + WIDTH, "{width} {seed}: {end:?} {last}");
                *last = end.low;
            }
        }
    }
}

/// Pairs from far beyond any shop, tips on fillets among them: most are proven, and what is not says so.
#[test]
fn helical_pairs_hold_or_are_doubted() {
    let mut rng = Draws(9);
    let (mut proven, mut brackets) = (0, 0);
    for _ in 0..60 {
        let Some(pair) = drawn(&mut rng) else {
            continue;
        };
        let found = held(&pair, 150);
        for end in [found.least, found.greatest].into_iter().flatten() {
            proven += u32::from(end.is_proven());
            brackets += 1;
        }
    }
    println!("{proven} of {brackets} proven");
    assert!(proven * 10 > brackets * 9, "{proven} of {brackets}");
}

/// The lost motion, mm, that perfect gears have on a face of an overlap ratio above 1: both sides touch wherever along the face they do so
/// tightest, each in a phase of its own. The last is what neighbouring phases differ by there, so what sampled phases can miss.
fn tightest_of_all_phases(plane: &GearPair) -> (f64, f64) {
    let kernel = ExactKernel::new(plane);
    let radius = plane.operating_pitch_radius(plane.free());
    let phases = 4000;
    let at = |k: i32| {
        let pose = Pose::new(
            plane,
            Mating::FIRST.onward(plane, f64::from(k) / f64::from(phases)),
        );
        let lost = kernel.lost_motion(&pose).unwrap();
        [lost.left.unwrap(), lost.right.unwrap()].map(|contact| {
            let beyond = contact.rotation - pose.free_rotation();
            (beyond - TAU * (beyond / TAU).round()) * radius
        })
    };
    let found: Vec<[f64; 2]> = (0..phases).map(at).collect();
    let signed = |side: usize, [left, right]: [f64; 2]| [left, -right][side];
    let mut missed = 0.0;
    let sides = [0, 1].map(|side| {
        let room = |k: usize| signed(side, found[k % found.len()]);
        let least = (0..found.len())
            .min_by(|&a, &b| room(a).total_cmp(&room(b)))
            .unwrap();
        let near = [least + 1, least + found.len() - 1].map(|k| room(k) - room(least));
        missed += near[0].max(near[1]);
        room(least)
    });
    (sides[0] + sides[1], missed)
}

/// Perfect gears whose tips touch fillets, on a face of an overlap ratio above 1: at every rotation one backlash, that of the tightest phases of
/// the measuring plane alone, a spur pair. Source: poses of that.
#[test]
fn perfect_gears_whose_tips_touch_fillets_have_one_backlash() {
    let build = |z, hand| {
        let data = BasicGearData::new(z, 2.0, 20f64.to_radians()).unwrap();
        let design = GearDesign {
            rack: BasicRack::new(1.2, 1.35, 0.2).unwrap(),
            ..GearDesign::standard(data.with_helix(15f64.to_radians(), hand).unwrap())
        };
        AsBuilt::perfect(Gear::nominal(design).unwrap(), Face::Front)
    };
    let (wheel, pinion) = (build(70, Hand::Right), build(25, Hand::Left));
    let distance = 95.0 / 15f64.to_radians().cos();
    let mut touched = 0;
    for closer in [0.15, 0.19, 0.22] {
        let plane = GearPair::new(wheel.clone(), pinion.clone(), distance - closer).unwrap();
        let (one, missed) = tightest_of_all_phases(&plane);
        let wide = plane.with_face([-20.0, 20.0]).unwrap();
        let found = held(&wide, 150);
        let [least, greatest] = [found.least.unwrap(), found.greatest.unwrap()];
        touched += u32::from(missed > 1e-9);
        for end in [least, greatest] {
            assert!(end.low <= one + ROUNDING && end.high >= one - missed - ROUNDING);
        }
    }
    assert_eq!(touched, 1);
}

//! The distance of no play, and that of other contact, against poses all round.

#[path = "../exact/random.rs"]
#[allow(dead_code)] // the exact method's tests use the rest
mod drawn;

use super::*;
use drawn::{Kind, Random};
use gearlash::contact::Contact;
use gearlash::error::go_on;

/// Drawn pairs that tell the program from one with a small mistake in it (a mutant: `tests/README.md`).
const PLAY_FREE: [u64; 9] = [0, 2, 4, 7, 8, 9, 10, 11, 13];
const ONSET: [u64; 3] = [0, 7, 17];

/// A small pair from far beyond any shop, and `per_pitch` matings a pitch of a revolution of its locked gear.
fn pair(seed: u64, per_pitch: u32) -> (GearPair, Vec<Mating>) {
    let mut random = Random(seed.wrapping_mul(91) ^ 0x2e0);
    let least = if seed.is_multiple_of(3) { 7.0 } else { 15.0 };
    let kind = Kind {
        teeth: (least, 40.0),
        deviation: [0.0, 1.0, 4.0][seed as usize % 3],
        shift: (-0.2, 0.3),
    };
    let pair = drawn::pair(&mut random, kind);
    let first = Mating {
        fraction: 0.0,
        ..drawn::mating(&mut random, &pair)
    };
    let all = 0..pair.teeth(pair.locked()) * per_pitch;
    let on = |k: u32| first.onward(&pair, f64::from(k) / f64::from(per_pitch));
    let matings = all.map(on).collect();
    (pair, matings)
}

/// `φ_j r_b`, mm, at a distance; −∞ when jammed.
fn plays(pair: &GearPair, distance: f64, matings: &[Mating]) -> Vec<f64> {
    let pair = pair.at(distance).unwrap();
    let kernel = ExactKernel::new(&pair);
    let base = pair.gear(pair.free()).gear().base_radius();
    let of = |mating: &Mating| {
        let found = kernel.lost_motion(&Pose::new(&pair, *mating)).unwrap();
        match (found.angle(), found.status()) {
            (Some(angle), _) => angle * base,
            (None, Status::Jammed) => f64::NEG_INFINITY,
            (None, _) => f64::INFINITY,
        }
    };
    matings.iter().map(of).collect()
}

fn least(plays: Vec<f64>) -> f64 {
    ends(plays)[0]
}

/// At `a_0` the pose named has no play, and no other has less: none of 256 a pitch `all` round or within half a pitch, of 4096 within a 64th, and of those
/// given. Source: those poses, by the exact method.
fn has_no_play(seed: u64, per_pitch: u32, all: bool) {
    let (pair, matings) = pair(seed, per_pitch);
    let found = zero_distance(&pair, &matings, &go_on).unwrap().unwrap();
    let case = format!("{seed}: {found:?}");
    let [low, high] = found.bracket;
    assert!(high - low <= 1.001e-10, "{case}");
    assert!((low..=high).contains(&found.distance), "{case}");
    let here = [found.mating];
    // Play changes by less than the distance does; the rest is rounding.
    assert!(plays(&pair, low - 1e-10, &here)[0] < 0.0, "{case}");
    assert!(plays(&pair, high + 1e-10, &here)[0] > 0.0, "{case}");
    let beyond = high + 1e-9;
    let pitches = if all { pair.teeth(pair.locked()) } else { 1 };
    let half = 128 * pitches as i32;
    let on = |k: i32, per_pitch: f64| found.mating.onward(&pair, f64::from(k) / per_pitch);
    let all = (-half..=half).map(|k| on(k, 256.0));
    let beside = (-64..=64).map(|k| on(k, 4096.0));
    let all: Vec<Mating> = all.chain(beside).chain(matings.iter().copied()).collect();
    let less = least(plays(&pair, beyond, &all));
    assert!(less > -1e-9, "{less:e} mm, {case}");
    let there = pair.at(high).unwrap();
    let lost = ExactKernel::new(&there).lost_motion(&Pose::new(&there, found.mating));
    let lost = lost.unwrap();
    let teeth = |contact: Contact| (contact.wheel.tooth, contact.pinion.tooth);
    let teeth = [lost.right, lost.left].map(|contact| contact.map_or((0, 0), teeth));
    assert_eq!(teeth, found.teeth, "{case}");
    // For the given poses.
    let [below, above] = [-1e-9, 1e-9].map(|off| plays(&pair, found.of_poses + off, &matings));
    let worst = matings.iter().position(|mating| *mating == found.pose);
    assert!(below[worst.unwrap()] < 0.0 && least(above) > 0.0, "{case}");
}

/// Source: poses all round, by the exact method.
#[test]
fn no_pose_has_less_play_than_none() {
    for seed in PLAY_FREE {
        has_no_play(seed, [1, 2, 4][seed as usize % 3], true);
    }
}

/// Tips that jam in roots before flanks lose their play: the first rotation of a stretch counted as the worst, and `a_0` was 3 µm small at m 0.115.
#[test]
fn the_worst_of_a_stretch_that_jams_is_found() {
    has_no_play(1, 2, false);
    has_no_play(58, 16, true);
}

/// Below the onset the pose named touches what it says, above it none of those given does. Source: the class of those poses.
#[test]
fn no_pose_touches_off_the_involutes_above_the_onset() {
    for seed in ONSET {
        let (pair, matings) = pair(seed, [1, 2, 4][seed as usize % 3]);
        let found = non_involute_onset(&pair, &matings, &go_on)
            .unwrap()
            .unwrap();
        let class = |distance: f64, mating: &Mating| {
            let pair = pair.at(distance).unwrap();
            let pose = Pose::new(&pair, *mating);
            PoseClass::of(&pair, &ExactKernel::new(&pair).lost_motion(&pose).unwrap())
        };
        let [low, high] = found.bracket;
        assert!(high - low <= 1.000_001e-6, "{seed}: {found:?}");
        let there = class(low, &found.mating);
        assert!(there.is_non_involute(), "{seed}: {found:?}");
        assert_eq!(there, found.class, "{seed}");
        for distance in [0.0, 0.01, 0.1].map(|farther| high + farther) {
            let touches = |mating: &&Mating| class(distance, mating).is_non_involute();
            let still = matings.iter().find(touches);
            assert_eq!(still, None, "{seed}: at {distance}");
        }
        let beside = (-8..=8).map(|k| found.mating.onward(&pair, f64::from(k) / 64.0));
        for mating in beside {
            let there = class(high + 1e-3, &mating);
            assert!(!there.is_non_involute(), "{seed}: {mating:?} {there:?}");
        }
    }
}

//! Outlines of drawn pairs that tell the program from one with a small mistake in it, as `witnesses` does of gears.

use crate::random::{self, Random};
use crate::wide::drawn::{Depth, Pair};
use gearlash::contact::{Contact, ExactKernel, LostMotion, OutlineCertifier, OutlineKernel};
use gearlash::gear::Placed;
use gearlash::outline::{OutlineGear, OutlinePair};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::TAU;

/// Pairs of the campaign's seed 77.
const OUTLINED: [u64; 9] = [0, 1, 2, 3, 5, 11, 25, 54, 122];

fn outlines(pair: &GearPair) -> OutlinePair {
    let gear = |member| OutlineGear::from(pair.gear(member));
    let (wheel, pinion) = (gear(Member::Wheel), gear(Member::Pinion));
    OutlinePair::new(wheel, pinion, pair.center_distance(), pair.locked()).unwrap()
}

/// The same rotation of the locked gear, which an outline counts from elsewhere.
fn same(pair: &GearPair, outlines: &OutlinePair, mating: Mating) -> Mating {
    let locked = pair.gear(pair.locked());
    let pitch = locked.gear().basic_data().angular_pitch();
    let there = outlines.rotation(pair.locked(), &mating);
    let off = there - Pose::new(pair, mating).locked_rotation();
    mating.onward(pair, -locked.face().ascending() * off / pitch)
}

/// Whether a point of the locked outline is within the free gear's root circle at every rotation of that gear; `None` if that is uncertain.
fn stands_in_the_body(pair: &GearPair, pose: &Pose) -> Option<bool> {
    let (locked, free) = (pair.locked(), pair.gear(pair.free()));
    let turned = pair.mate_direction(locked) + pose.locked_rotation();
    let placed = Placed::new(pair.gear(locked), pair.axis(locked), turned);
    let (axis, module) = (pair.axis(pair.free()), free.gear().basic_data().module());
    let points = placed.outline_near(axis, 2.0 * pair.center_distance(), 1e-4 * module);
    let radii = points.iter().map(|point| (point - axis).norm());
    let nearest = radii.fold(f64::INFINITY, f64::min);
    let over = nearest - (free.gear().root_radius() - free.eccentricity());
    (over.abs() > 1e-3 * module).then_some(over < 0.0)
}

/// The contacts found, moved slightly to either side, and missing, each with whether it must be confirmed.
fn claims(found: &LostMotion, pitch: f64) -> Vec<(LostMotion, bool)> {
    let mut claims = vec![(*found, true)];
    for (right, contact) in [(true, found.right), (false, found.left)] {
        let Some(contact) = contact else { continue };
        let off = |sign: f64| -> Option<Contact> {
            let rotation = contact.rotation + sign * (1e-6 + 3.0 * contact.error);
            Some(Contact {
                rotation,
                ..contact
            })
        };
        // A contact hardly known anywhere is not refused anywhere.
        let off = (contact.error <= 1e-3 * pitch).then(|| [off(1.0), off(-1.0)]);
        for wrong in off.into_iter().flatten().chain([None]) {
            let mut claimed = *found;
            if right {
                claimed.right = wrong
            } else {
                claimed.left = wrong
            }
            claims.push((claimed, claimed.solid));
        }
    }
    claims
}

/// Source: the exact method, which knows what each curve is; and which claims are right.
#[test]
fn outlines_and_their_certificate_hold_against_the_exact_method() {
    for number in OUTLINED {
        let pair = Pair::new(77, number).pose(0, Some(Depth::Any)).assembly;
        let mut random = Random(number ^ 0x0717);
        let mating = random::mating(&mut random, &pair);
        let mating = Mating {
            fraction: 0.3,
            ..mating
        };
        let outlines = outlines(&pair);
        let pose = Pose::new(&pair, same(&pair, &outlines, mating));
        let exact = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let kernel = OutlineKernel::new(&outlines);
        let found = kernel.lost_motion(&mating).unwrap();
        for (exact, found) in [(exact.right, found.right), (exact.left, found.left)] {
            assert_eq!(exact.is_some(), found.is_some(), "pair {number}");
            let Some((exact, found)) = exact.zip(found) else {
                continue;
            };
            let turns = (exact.rotation - found.rotation) / TAU;
            let off = (turns - turns.round()).abs() * TAU;
            // The last term is what the two rotations of the locked gear differ by.
            let bound = exact.error + found.error + 1e-12;
            assert!(off <= bound, "pair {number}: {off:e} above {bound:e}");
        }
        let overlap = found.right.zip(found.left);
        let overlap = overlap.map_or(0.0, |(right, left)| right.rotation - left.rotation);
        let gear = pair.gear(pair.free()).gear();
        // Nearer than the points are to the curves nothing is said.
        if let Some(deep) = stands_in_the_body(&pair, &pose) {
            let solid = overlap >= gear.basic_data().angular_pitch() || deep;
            assert_eq!(found.solid, solid, "pair {number}");
        }
        let certifier = OutlineCertifier::new(&kernel);
        let pitch = gear.basic_data().angular_pitch();
        for (claimed, borne) in claims(&found, pitch) {
            let seen = certifier.check(&mating, &claimed);
            assert_eq!(
                seen.is_ok(),
                borne,
                "pair {number}: {seen:?} of {claimed:?}"
            );
        }
    }
}

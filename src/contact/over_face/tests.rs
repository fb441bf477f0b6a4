//! The combination of sections, with contacts put together by hand. Expected values follow from their rotations.

use super::OverFace;
use crate::contact::{Contact, LostMotion, Status, ToothPlace, Touch};
use crate::gear::Side;
use crate::pair::{GearPair, Mating, Member, Pose};
use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// Error bound of a contact, rad.
const ERROR: f64 = 1e-9;

/// A pose some pitches beyond tooth 1.
fn pose(pitches: f64) -> Pose {
    let pair = GearPair::plain([20, 30], [0.0; 2], 50.1, Member::Wheel);
    let mating = Mating {
        fraction: pitches,
        ..Mating::FIRST
    };
    Pose::new(&pair, mating)
}

/// Both contacts `beyond` the nominal rotation of a pose, rad, each counted some turns on.
fn found(pose: &Pose, beyond: [Option<f64>; 2], turns: f64) -> LostMotion {
    let touch = Touch {
        tooth: 1,
        curve: ToothPlace::Involute,
        radius: 20.0,
    };
    let contact = |beyond| Contact {
        rotation: pose.free_rotation() + beyond + TAU * turns,
        error: ERROR,
        wheel: touch,
        pinion: touch,
        point: Point2::origin(),
        normal: Vector2::x(),
        section: 0.0,
    };
    let [right, left] = beyond.map(|beyond| beyond.map(contact));
    LostMotion {
        right,
        left,
        solid: false,
    }
}

/// Both contacts of a section that is jammed.
fn jammed(pose: &Pose, beyond: [f64; 2]) -> LostMotion {
    LostMotion {
        solid: true,
        ..found(pose, beyond.map(Some), 0.0)
    }
}

/// The sections 1, 2, … with these contacts at one pose.
fn over(sections: &[[Option<f64>; 2]]) -> OverFace {
    let here = pose(0.3);
    let mut over = OverFace::default();
    for (beyond, b) in sections.iter().zip(1..) {
        over.add(f64::from(b), &here, found(&here, *beyond, 0.0));
    }
    over
}

fn sections(found: &LostMotion) -> [f64; 2] {
    [found.right, found.left].map(|contact| contact.unwrap().section)
}

/// Equality of rotations to within the rounding of a few turns.
fn is_near(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-12
}

/// Each side is that of the section that is tightest there, wherever the rotations of the sections start to count.
#[test]
fn each_side_stops_where_its_tightest_section_does() {
    let mut over = OverFace::default();
    assert_eq!(Side::BOTH.map(|side| over.beyond(side)), [None; 2]);
    for (b, pitches, beyond, turns) in [
        (1.0, 0.3, [0.1, 0.4], 0.0),
        (2.0, 7.6, [0.2, 0.5], 2.0),
        (3.0, -9.1, [-0.3, 0.3], -3.0),
        (4.0, 2.2, [0.15, 0.45], 1.0),
    ] {
        let here = pose(pitches);
        over.add(b, &here, found(&here, beyond.map(Some), turns));
    }
    assert!(!over.is_solid());
    assert!(is_near(over.beyond(Side::Right).unwrap(), 0.2));
    assert!(is_near(over.beyond(Side::Left).unwrap(), 0.3));
    let all = over.found(0.7, 0.2);
    let found = all.lost_motion;
    assert!(is_near(found.right.unwrap().rotation, 0.9), "{found:?}");
    assert!(is_near(found.left.unwrap().rotation, 1.0), "{found:?}");
    assert_eq!(sections(&found), [2.0, 3.0]);
    assert!(all.jam.is_none() && found.status() == Status::Clear);
}

/// In gears of few teeth the left contact can be more than half a turn from the nominal rotation. It keeps its distance from the right one.
#[test]
fn the_left_side_counts_on_from_the_right_one() {
    let both = over(&[[Some(2.9), Some(3.5)]]);
    assert!(is_near(both.beyond(Side::Right).unwrap(), 2.9));
    assert!(is_near(both.beyond(Side::Left).unwrap(), 3.5));
    // Without a right contact it is the nearer way round.
    let left = over(&[[None, Some(3.5)]]);
    assert!(is_near(left.beyond(Side::Left).unwrap(), 3.5 - TAU));
    let all = left.found(0.0, 0.2).lost_motion;
    assert!(all.right.is_none() && !all.solid);
    assert!(is_near(all.left.unwrap().rotation, 3.5 - TAU));
    assert_eq!(all.status(), Status::NoContact);
}

/// A section that is tighter by less than the error bound changes nothing: the first one remains.
#[test]
fn the_first_of_equally_tight_sections_is_reported() {
    let within = 0.5 * ERROR;
    let offs = [0.0, within, -within];
    let all = over(&offs.map(|off| [Some(0.1 + off), Some(0.4 - off)]));
    assert_eq!(sections(&all.found(0.0, 0.2).lost_motion), [1.0, 1.0]);
}

/// The twist of a section is rounded like the rotations to which it is added. A few ulps of both, and of a turn,
/// increase the contact's own bound.
#[test]
fn a_bound_grows_by_the_rounding_of_both_rotations() {
    for pitches in [0.0, 3e5] {
        let here = pose(pitches);
        let mut over = OverFace::default();
        over.add(1.0, &here, found(&here, [Some(0.1), Some(0.4)], 0.0));
        let all = over.found(0.0, 0.2).lost_motion;
        let rotations = here.locked_rotation().abs() + here.free_rotation().abs();
        let ulps = f64::EPSILON * (rotations + TAU);
        for contact in [all.right, all.left] {
            let beside = (contact.unwrap().error - ERROR) / ulps;
            assert!((4.0..=16.0).contains(&beside), "{beside}");
        }
    }
}

/// A jammed section is the only result, whatever touches before or after it.
#[test]
fn a_section_that_jams_is_reported_alone() {
    let here = pose(0.3);
    // Clear, both behind the nominal rotation, and on either side of it.
    for beyond in [[0.3, 0.1], [-0.1, -0.3], [0.1, -0.1]] {
        let mut over = over(&[[Some(0.35), Some(0.4)]]);
        over.add(2.0, &here, jammed(&here, beyond));
        assert!(over.is_solid());
        over.add(3.0, &here, found(&here, [Some(0.38), Some(-0.4)], 0.0));
        let all = over.found(0.0, 1.0);
        let found = all.lost_motion;
        assert_eq!((all.jam, sections(&found)), (Some(2.0), [2.0; 2]));
        for (contact, beyond) in [found.right, found.left].into_iter().zip(beyond) {
            assert!(is_near(contact.unwrap().rotation, beyond));
        }
        assert_eq!(found.status(), Status::Jammed);
    }
    let mut over = over(&[[Some(0.1), Some(0.4)]]);
    over.add(2.0, &here, LostMotion::JAMMED);
    let all = over.found(0.0, 1.0);
    assert_eq!((all.jam, all.lost_motion), (Some(2.0), LostMotion::JAMMED));
}

/// An overlap within its own bound may be none. Further sections count, and the first of them is reported if none is certainly jammed.
#[test]
fn an_overlap_within_its_bound_only_seems_to_jam() {
    let here = pose(0.3);
    let mut over = OverFace::default();
    for b in [1.0, 2.0] {
        over.add(b, &here, jammed(&here, [0.2 + ERROR, 0.2]));
        assert!(!over.is_solid());
    }
    over.add(3.0, &here, found(&here, [Some(0.3), Some(0.1)], 0.0));
    let all = over.found(0.0, 1.0);
    let found = all.lost_motion;
    assert_eq!((all.jam, sections(&found)), (Some(1.0), [3.0; 2]));
    assert_eq!(found.status(), Status::Jammed);
}

/// The limits for further sections: tighter contacts, and if one may jam, all that two sides this close could hide.
#[test]
fn known_limits_hold_for_both_sides() {
    let open = [f64::NEG_INFINITY, f64::INFINITY];
    for (beyond, expected) in [
        ([None, None], [open; 2]),
        ([Some(0.1), None], [open; 2]),
        ([None, Some(0.4)], [open; 2]),
        ([Some(0.1), Some(0.4)], [[0.1, 0.4]; 2]),
        ([Some(0.4), Some(0.1)], [[0.4, 0.1], [0.1, 0.4]]),
    ] {
        for (may_jam, expected) in [false, true].into_iter().zip(expected) {
            let known = over(&[beyond]).known(may_jam);
            let is_known = known == expected || (0..2).all(|k| is_near(known[k], expected[k]));
            assert!(is_known, "{beyond:?} {may_jam}: {known:?}");
        }
    }
}

/// A section in which only contacts tighter than `known` were requested: its other contacts are on the far side of that.
#[test]
fn unrequested_contacts_may_overlap_with_found_ones() {
    let known = [0.0, 0.3];
    for (beyond, expected) in [
        // No contact tighter than the known ones.
        ([None, None], false),
        ([Some(0.1), None], false),
        ([None, Some(0.2)], false),
        // On the other side of the left contact.
        ([Some(0.4), None], true),
        ([None, Some(-0.1)], true),
        // No tighter than the known one, so the tightest may be another.
        ([Some(-0.2), Some(-0.1)], true),
        ([Some(0.4), Some(0.5)], true),
        ([Some(-0.2), Some(0.2)], false),
        // Both are the tightest there, with or without overlap: nothing is open.
        ([Some(0.4), Some(0.2)], false),
        ([Some(0.1), Some(0.2)], false),
    ] {
        for (pitches, turns) in [(0.3, 0.0), (7.6, 2.0), (-9.1, -3.0)] {
            let here = pose(pitches);
            let there = found(&here, beyond, turns);
            let may = OverFace::may_overlap(&here, &there, known);
            assert_eq!(may, expected, "{beyond:?}");
        }
    }
}

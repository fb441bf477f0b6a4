//! The combination of sections, with contacts put together by hand. Expected values follow from their rotations.

use super::OverFace;
use crate::contact::{Contact, LostMotion, Status, ToothPlace, Touch};
use crate::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign, Side};
use crate::pair::{GearPair, Mating, Pose};
use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// Error bound of a contact, rad.
const ERROR: f64 = 1e-9;

/// A pose some pitches beyond tooth 1.
fn pose(pitches: f64) -> Pose {
    let gear = |teeth| {
        let data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
        AsBuilt::perfect(
            Gear::nominal(GearDesign::standard(data)).unwrap(),
            Face::Front,
        )
    };
    let pair = GearPair::new(gear(20), gear(30), 50.1).unwrap();
    let mating = Mating {
        fraction: pitches,
        ..Mating::FIRST
    };
    Pose::new(&pair, mating)
}

/// A contact `beyond` the nominal rotation of `pose`, rad, counted some turns on.
fn contact(pose: &Pose, beyond: f64, turns: f64) -> Contact {
    let touch = Touch {
        tooth: 1,
        curve: ToothPlace::Involute,
        radius: 20.0,
    };
    Contact {
        rotation: pose.free_rotation() + beyond + TAU * turns,
        error: ERROR,
        wheel: touch,
        pinion: touch,
        point: Point2::origin(),
        normal: Vector2::x(),
        section: 0.0,
    }
}

/// Both contacts `beyond` the nominal rotation, each counted some turns on.
fn found(pose: &Pose, beyond: [Option<f64>; 2], turns: f64) -> LostMotion {
    let [right, left] = beyond.map(|beyond| beyond.map(|beyond| contact(pose, beyond, turns)));
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

/// Equality of rotations to within the rounding of a few turns.
fn is_near(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-12
}

/// Each side is that of the section that is tightest there, wherever the rotations of the sections start to count.
#[test]
fn each_side_stops_where_its_tightest_section_does() {
    let mut over = OverFace::default();
    assert_eq!(over.beyond(Side::Right), None);
    assert_eq!(over.beyond(Side::Left), None);
    let sections = [
        (1.0, 0.3, [0.1, 0.4], 0.0),
        (2.0, 7.6, [0.2, 0.5], 2.0),
        (3.0, -9.1, [-0.3, 0.3], -3.0),
        (4.0, 2.2, [0.15, 0.45], 1.0),
    ];
    for (b, pitches, beyond, turns) in sections {
        let here = pose(pitches);
        over.take(b, &here, found(&here, beyond.map(Some), turns));
    }
    assert!(!over.is_solid());
    assert!(is_near(over.beyond(Side::Right).unwrap(), 0.2));
    assert!(is_near(over.beyond(Side::Left).unwrap(), 0.3));
    let all = over.found(0.7, 0.2);
    let (right, left) = (
        all.lost_motion.right.unwrap(),
        all.lost_motion.left.unwrap(),
    );
    assert!(is_near(right.rotation, 0.9), "{right:?}");
    assert!(is_near(left.rotation, 1.0), "{left:?}");
    assert_eq!([right.section, left.section], [2.0, 3.0]);
    assert!(all.jam.is_none() && all.lost_motion.status() == Status::Clear);
}

/// In gears of few teeth the left contact can be more than half a turn from the nominal rotation. It keeps its distance from the right one.
#[test]
fn the_left_side_counts_on_from_the_right_one() {
    let here = pose(0.3);
    let mut over = OverFace::default();
    over.take(1.0, &here, found(&here, [Some(2.9), Some(3.5)], 0.0));
    assert!(is_near(over.beyond(Side::Right).unwrap(), 2.9));
    assert!(is_near(over.beyond(Side::Left).unwrap(), 3.5));
    // Without a right contact it is the nearer way round.
    let mut over = OverFace::default();
    over.take(1.0, &here, found(&here, [None, Some(3.5)], 1.0));
    assert!(is_near(over.beyond(Side::Left).unwrap(), 3.5 - TAU));
    let all = over.found(0.0, 0.2).lost_motion;
    assert!(all.right.is_none() && !all.solid);
    assert!(is_near(all.left.unwrap().rotation, 3.5 - TAU));
    assert_eq!(all.status(), Status::NoContact);
}

/// A section that is tighter by less than the error bound changes nothing: the first one remains.
#[test]
fn the_first_of_equally_tight_sections_is_reported() {
    let here = pose(0.3);
    let mut over = OverFace::default();
    let within = 0.5 * ERROR;
    over.take(1.0, &here, found(&here, [Some(0.1), Some(0.4)], 0.0));
    over.take(
        2.0,
        &here,
        found(&here, [Some(0.1 + within), Some(0.4 - within)], 0.0),
    );
    over.take(
        3.0,
        &here,
        found(&here, [Some(0.1 - within), Some(0.4 + within)], 0.0),
    );
    let all = over.found(0.0, 0.2).lost_motion;
    let sections = [all.right, all.left].map(|contact| contact.unwrap().section);
    assert_eq!(sections, [1.0, 1.0]);
}

/// The twist of a section is rounded like the rotations to which it is added. A few ulps of both, and of a turn,
/// increase the contact's own bound.
#[test]
fn a_bound_grows_by_the_rounding_of_both_rotations() {
    for pitches in [0.0, 3e5] {
        let here = pose(pitches);
        let mut over = OverFace::default();
        over.take(1.0, &here, found(&here, [Some(0.1), Some(0.4)], 0.0));
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
    // Clear, both behind the nominal rotation, and on either side of it.
    for beyond in [[0.3, 0.1], [-0.1, -0.3], [0.1, -0.1]] {
        let here = pose(0.3);
        let mut over = OverFace::default();
        over.take(1.0, &here, found(&here, [Some(0.35), Some(0.4)], 0.0));
        over.take(2.0, &here, jammed(&here, beyond));
        assert!(over.is_solid());
        over.take(3.0, &here, found(&here, [Some(0.38), Some(-0.4)], 0.0));
        let all = over.found(0.0, 1.0);
        assert_eq!(all.jam, Some(2.0));
        let sides = [all.lost_motion.right, all.lost_motion.left].map(Option::unwrap);
        for (contact, beyond) in sides.into_iter().zip(beyond) {
            assert!(is_near(contact.rotation, beyond) && contact.section == 2.0);
        }
        assert_eq!(all.lost_motion.status(), Status::Jammed);
    }
    let here = pose(0.3);
    let mut over = OverFace::default();
    over.take(1.0, &here, found(&here, [Some(0.1), Some(0.4)], 0.0));
    over.take(2.0, &here, LostMotion::JAMMED);
    let all = over.found(0.0, 1.0);
    assert_eq!((all.jam, all.lost_motion), (Some(2.0), LostMotion::JAMMED));
}

/// An overlap within its own bound may be none. Further sections count, and the first of them is reported if none is certainly jammed.
#[test]
fn an_overlap_within_its_bound_only_seems_to_jam() {
    let here = pose(0.3);
    let mut over = OverFace::default();
    over.take(1.0, &here, jammed(&here, [0.2 + ERROR, 0.2]));
    assert!(!over.is_solid());
    over.take(2.0, &here, jammed(&here, [0.2 + ERROR, 0.2]));
    over.take(3.0, &here, found(&here, [Some(0.3), Some(0.1)], 0.0));
    let all = over.found(0.0, 1.0);
    assert_eq!(all.jam, Some(1.0));
    let sides = [all.lost_motion.right, all.lost_motion.left].map(|side| side.unwrap().section);
    assert_eq!(sides, [3.0, 3.0]);
    assert_eq!(all.lost_motion.status(), Status::Jammed);
}

/// The limits for further sections: tighter contacts, and if one may jam, all that two sides this close could hide.
#[test]
fn known_limits_hold_for_both_sides() {
    let here = pose(0.3);
    let taken = |beyond| {
        let mut over = OverFace::default();
        over.take(1.0, &here, found(&here, beyond, 0.0));
        over
    };
    let open = [f64::NEG_INFINITY, f64::INFINITY];
    let is_known = |over: OverFace, may_jam, expected: [f64; 2]| {
        let known = over.known(may_jam);
        (0..2).all(|k| is_near(known[k], expected[k]))
    };
    for may_jam in [false, true] {
        assert_eq!(OverFace::default().known(may_jam), open);
        assert_eq!(taken([Some(0.1), None]).known(may_jam), open);
        assert_eq!(taken([None, Some(0.4)]).known(may_jam), open);
        assert!(is_known(taken([Some(0.1), Some(0.4)]), may_jam, [0.1, 0.4]));
    }
    let overlapping = || taken([Some(0.4), Some(0.1)]);
    assert!(is_known(overlapping(), false, [0.4, 0.1]));
    assert!(is_known(overlapping(), true, [0.1, 0.4]));
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

//! The solution of a newcomer with parry and without gear theory, for comparison.

use gearlash::contact::ExactKernel;
use gearlash::gear::{AsBuilt, HalfTooth, Side};
use gearlash::pair::{GearPair, Member, Pose};
use nalgebra::{Isometry2, Point2, Vector2};
use parry2d_f64::math::{Pose2, Vector};
use parry2d_f64::query;
use parry2d_f64::shape::Polyline;
use std::time::Instant;

/// Chord of the newcomer's polygons, mm.
const NEWCOMER_CHORD: f64 = 1e-6;

/// The newcomer bisects until the bracket is this narrow, rad.
const NEWCOMER_WIDTH: f64 = 1e-9;

/// The whole outline of a gear as parry sees it, in the gear's own frame, tooth 1 on +x.
fn whole_gear(gear: &AsBuilt) -> Polyline {
    let mut points = Vec::new();
    let halves =
        Side::BOTH.map(|side| HalfTooth::new(&gear.profile(side, 1), side, NEWCOMER_CHORD));
    let teeth = gear.gear().basic_data().teeth();
    for step in 0..i64::from(teeth) {
        let tooth = gear.counter_clockwise(1, step);
        for (side, half) in Side::BOTH.into_iter().zip(&halves) {
            let turn = gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
            let frame = Isometry2::new(Vector2::zeros(), turn);
            let place = |point: &Point2<f64>| {
                let point = frame * point;
                Vector::new(point.x, point.y)
            };
            // Counter-clockwise: the right half from space to tip, the left one from tip to space.
            match side {
                Side::Right => points.extend(half.points().iter().rev().map(place)),
                Side::Left => points.extend(half.points().iter().map(place)),
            }
        }
    }
    Polyline::new(points, None)
}

/// Both rotations by bisection with parry's `distance` of whole gears, rad, and the time it took.
///
/// A rotation is free if the distance is positive.
pub(super) fn newcomer(assembly: &GearPair, pose: &Pose) -> (f64, f64) {
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| whole_gear(assembly.gear(m)));
    let frame = |member: Member, rotation: f64| {
        let tooth_1 = assembly.mate_direction(member) + rotation;
        let centre = assembly.axis(member) + assembly.gear(member).displacement(tooth_1);
        Pose2::from(Isometry2::new(centre.coords, tooth_1))
    };
    let locked = frame(Member::Wheel, pose.locked_rotation());
    let is_free = |rotation: f64| {
        let free = frame(Member::Pinion, rotation);
        query::distance(&locked, &wheel, &free, &pinion)
            .unwrap()
            .distance
            > 0.0
    };
    let start = Instant::now();
    let ends = [-1.0, 1.0].map(|sense| {
        // The bracket is given: clear in the middle of the play, closed 0.3° beyond.
        let middle = ExactKernel::new(assembly).lost_motion(pose).unwrap();
        let middle = (middle.right.unwrap().rotation + middle.left.unwrap().rotation) / 2.0;
        let (mut clear, mut closed) = (middle, middle + sense * 0.005);
        while (closed - clear).abs() > NEWCOMER_WIDTH {
            let rotation = 0.5 * (clear + closed);
            if is_free(rotation) {
                clear = rotation;
            } else {
                closed = rotation;
            }
        }
        clear
    });
    (ends[1] - ends[0], start.elapsed().as_secs_f64())
}

//! Drawn wheels whose play has a closed form, and overlap of polygons as the witness of any.

use super::*;
use crate::paths::{READING, closed_by_arcs, lines, polar, repeated, turned};
use gearlash::contact::Touch;
use nalgebra::Rotation2;

pub(super) fn gear(segments: &[PathSegment], bound: f64) -> OutlineGear {
    OutlineGear::new(segments, &OutlineReading { bound, ..READING }).unwrap()
}

/// A tooth with a round head of radius `head` about a point at `radius`, its sides straight down to `root`.
pub(super) fn pin(radius: f64, head: f64, root: f64) -> Vec<PathSegment> {
    let foot = (root * root - head * head).sqrt();
    let side = |x: f64| [Point2::new(x, foot), Point2::new(x, radius)];
    let [left, right] = [side(-head), side(head)];
    vec![
        PathSegment::Line(left),
        PathSegment::Arc {
            centre: Point2::new(0.0, radius),
            radius: head,
            start: PI,
            sweep: -PI,
        },
        PathSegment::Line([right[1], right[0]]),
    ]
}

/// Circular-arc wheels: round heads touch where their centres are two head radii apart, which the law of cosines gives about the free axis.
#[test]
fn round_heads_touch_two_radii_apart() {
    let (teeth, radius, head, distance) = ([24, 18], [48.0, 36.0], 2.4, 84.3);
    let wheel = |k: usize| {
        let tooth = pin(radius[k], head, radius[k] - 5.0);
        gear(&repeated(teeth[k], &tooth), 0.0)
    };
    let mut on_heads = 0;
    for locked in Member::BOTH {
        let pair = OutlinePair::new(wheel(0), wheel(1), distance, locked).unwrap();
        let kernel = OutlineKernel::new(&pair);
        let free = pair.free();
        let [still, turning] = [locked, free].map(|member| member as usize);
        for k in 0..40u32 {
            let mating = at(k % 24 + 1, k % 18 + 1, 0.13 * f64::from(k));
            let found = kernel.lost_motion(&mating).unwrap();
            // About the axis of either gear, tooth 1 towards the other at rotation 0.
            let head_of = |tooth: u32, rotation: f64, which: usize| {
                let angle = rotation - f64::from(tooth - 1) * TAU / f64::from(teeth[which]);
                Rotation2::new(angle) * Vector2::new(radius[which], 0.0)
            };
            let [rotation, nominal] = [locked, free].map(|member| pair.rotation(member, &mating));
            let (mut right, mut left) = (f64::NEG_INFINITY, f64::INFINITY);
            let pairs = (1..=teeth[still])
                .flat_map(|tooth| (1..=teeth[turning]).map(move |other| (tooth, other)));
            for (tooth, other) in pairs {
                let there = Vector2::new(distance, 0.0) - head_of(tooth, rotation, still);
                let (away, arm) = (there.norm(), radius[turning]);
                let cos = (away * away + arm * arm - 4.0 * head * head) / (2.0 * away * arm);
                let own = head_of(other, nominal, turning);
                let ahead = own.perp(&there).atan2(own.dot(&there));
                if cos > 1.0 || ahead.abs() >= TAU / f64::from(teeth[turning]) {
                    continue;
                }
                // The free head turned until it touches from either side.
                if ahead < 0.0 {
                    right = right.max(nominal + ahead + cos.acos());
                } else {
                    left = left.min(nominal + ahead - cos.acos());
                }
            }
            for (contact, expected, sense) in [
                (found.right.unwrap(), right, 1.0),
                (found.left.unwrap(), left, -1.0),
            ] {
                // Heads may not overlap; below them the straight sides may touch first.
                let off = sense * (contact.rotation - expected);
                assert!(off > -1e-12 - contact.error, "{contact:?} {expected}");
                let on_head = |touch: Touch, k: usize| touch.radius > radius[k].hypot(head);
                if on_head(contact.wheel, 0) && on_head(contact.pinion, 1) {
                    assert!(off < 1e-12 + contact.error, "{contact:?} {expected}");
                    on_heads += 1;
                }
            }
        }
    }
    assert!(on_heads > 50, "{on_heads}");
}

/// A flank of clockwork wheels: outside the pitch circle the epicycloid that a circle of `rolling` draws, inside it the radius; points from the
/// tip to the root, at angles past where it crosses the pitch circle. Epicycloid: `(R + r) e^{it} − r e^{it(R + r)/r}` (Camus 1733).
fn cycloidal(pitch: f64, rolling: f64, depth: [f64; 2], points: u32) -> Vec<Vector2<f64>> {
    let sum = pitch + rolling;
    let at = |t: f64| {
        let inner = t * sum / rolling;
        Vector2::new(
            sum * t.cos() - rolling * inner.cos(),
            sum * t.sin() - rolling * inner.sin(),
        )
    };
    let is_below = |t: f64| at(t).norm() < pitch + depth[0];
    let [tip, _] = halved(0.0, PI * rolling / pitch, 100, is_below);
    let above = (0..=points).map(|k| at(tip * f64::from(points - k) / f64::from(points)));
    above.chain([Vector2::new(pitch - depth[1], 0.0)]).collect()
}

/// Cycloidal wheels turn at one ratio: of teeth that leave `play` of the pitch circle free the lost motion is just that at every pose.
/// Each head is drawn by the circle of half the mate's pitch circle, whose hypocycloid is the mate's radial flank.
#[test]
fn cycloidal_wheels_have_one_play() {
    const POINTS: u32 = 400;
    let (teeth, pitch, play) = ([30u32, 12u32], [30.0, 12.0], 0.05);
    let wheel = |k: usize| {
        let angular = PI / f64::from(teeth[k]) - 0.5 * play / pitch[k];
        let points = cycloidal(pitch[k], 0.5 * pitch[1 - k], [0.9, 1.4], POINTS);
        // From the tooth's centre line: half its angle less what the flank is ahead.
        let side = |sense: f64| -> Vec<Point2<f64>> {
            let turn = Rotation2::new(FRAC_PI_2 - sense * 0.5 * angular);
            let mirrored = points.iter().map(|p| Vector2::new(p.x, sense * p.y));
            mirrored.map(|point| Point2::from(turn * point)).collect()
        };
        let mut walk = side(-1.0);
        walk.reverse();
        walk.extend(side(1.0));
        // Chords of 400 a flank of a millimetre, curved by less than 1/mm near the pitch circle, where points lie closest.
        gear(&repeated(teeth[k], &lines(&walk)), 1e-6)
    };
    let pair = OutlinePair::new(wheel(0), wheel(1), 42.0, Member::Wheel).unwrap();
    let kernel = OutlineKernel::new(&pair);
    for k in 0..60u32 {
        let mating = at(k % 30 + 1, k % 12 + 1, 0.07 * f64::from(k % 15));
        let found = kernel.lost_motion(&mating).unwrap();
        near(k, found.angle().unwrap() * pitch[1], play, 1e-5);
    }
}

/// Whether two polygons cross in the mesh.
pub(super) fn cross(pair: &OutlinePair, mating: &Mating, free_rotation: f64) -> bool {
    let outline = |member: Member| {
        let rotation = if member == pair.locked() {
            pair.rotation(member, mating)
        } else {
            free_rotation
        };
        let points = pair.outline(member, rotation, 1e-5);
        let mate = pair.gear(member.mate()).reach();
        let axis = pair.axis(member.mate());
        let next = points.iter().cycle().skip(1);
        let chords = points.iter().zip(next).map(|(a, b)| [*a, *b]);
        let near = chords.filter(|ends| ends.iter().any(|end| (end - axis).norm() < mate + 1.0));
        near.collect::<Vec<[Point2<f64>; 2]>>()
    };
    let [wheel, pinion] = Member::BOTH.map(outline);
    let side = |a: Point2<f64>, b: Point2<f64>, c: Point2<f64>| (b - a).perp(&(c - a));
    wheel.iter().any(|&[a, b]| {
        let (low, high) = (a.inf(&b), a.sup(&b));
        pinion.iter().any(|&[c, d]| {
            let apart = c.x.max(d.x) < low.x
                || c.x.min(d.x) > high.x
                || c.y.max(d.y) < low.y
                || c.y.min(d.y) > high.y;
            !apart && side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
        })
    })
}

/// Straight flanks that coincide all along, as those of two equal wheels do at the pitch point: the gap has no one greatest place, and the search
/// had no end.
#[test]
fn equal_straight_flanks_are_settled() {
    let pitch = TAU / 20.0;
    let walk = [(18.0, 0.3), (22.0, 0.12), (22.0, -0.12), (18.0, -0.3)];
    let walk = walk.map(|(radius, share)| polar(radius, FRAC_PI_2 + share * pitch));
    let wheel = || gear(&repeated(20, &lines(&walk)), 0.0);
    let pair = OutlinePair::new(wheel(), wheel(), 40.5, Member::Wheel).unwrap();
    let kernel = OutlineKernel::new(&pair);
    for k in 0..20 {
        let mating = at(k + 1, (20 - k) % 20 + 1, 0.0);
        let found = kernel.lost_motion(&mating).unwrap();
        let (right, left) = (found.right.unwrap(), found.left.unwrap());
        assert!(left.rotation > right.rotation && right.error < 1e-9);
        let middle = 0.5 * (left.rotation + right.rotation);
        assert!(!cross(&pair, &mating, middle));
    }
}

/// Teeth at uneven places: contact takes the tooth that faces another by its number, which holds up to half a pitch.
#[test]
fn teeth_half_a_pitch_off_their_places_are_refused() {
    let pitch = TAU / 24.0;
    let tooth = pin(24.0, 1.2, 21.0);
    // Twelve at four fifths of a pitch, twelve at six fifths: three pitches off in the middle.
    let mut angle = 0.0;
    let teeth = (0..24).flat_map(|k| {
        let there = turned(&tooth, -angle);
        angle += if k < 12 { 0.8 } else { 1.2 } * pitch;
        there
    });
    let closed = closed_by_arcs(&teeth.collect::<Vec<PathSegment>>());
    let refused = OutlineGear::new(&closed, &READING);
    assert!(matches!(refused, Err(OutlineError::Uneven { pitches, .. }) if pitches.abs() > 0.5));
}

//! Teeth outside any formula: excluded pairs of pieces do not touch, and polygons overlap just outside the play.

use super::drawn::{at, closed_by_arcs, cross, turned};
use crate::outlines::{drawn, measured};
use crate::random::Random;
use gearlash::analytic::InvolutePair;
use gearlash::contact::{Contact, OutlineKernel, Status};
use gearlash::gear::Face;
use gearlash::outline::{OutlineGear, OutlinePair, OutlineReading, PathSegment};
use gearlash::pair::Member;
use nalgebra::{Point2, Rotation2};
use std::f64::consts::{FRAC_PI_2, TAU};

/// An irregular tooth: from root to tip and back through points whose radii rise and fall, with straight or curved pieces between.
fn odd_tooth(random: &mut Random, teeth: u32, root: f64, tip: f64) -> Vec<PathSegment> {
    let pitch = TAU / f64::from(teeth);
    let at = |radius: f64, angle: f64| {
        let (sin, cos) = (FRAC_PI_2 - angle).sin_cos();
        Point2::new(radius * cos, radius * sin)
    };
    let steps = 1 + random.tooth(3);
    let side = |random: &mut Random, sign: f64| -> Vec<Point2<f64>> {
        let (foot, top) = (random.within(0.2, 0.38), random.within(0.03, 0.22));
        let point = |k: u32| {
            let share = f64::from(k) / f64::from(steps);
            // A slight additional variation.
            let odd = if k == 0 || k == steps {
                0.0
            } else {
                random.within(-0.03, 0.03)
            };
            let part = foot + (top - foot) * share + odd;
            at(root + (tip - root) * share, sign * part * pitch)
        };
        (0..=steps).map(point).collect()
    };
    let left = side(random, -1.0);
    let mut right = side(random, 1.0);
    right.reverse();
    let mut path: Vec<PathSegment> = Vec::new();
    let walk: Vec<Point2<f64>> = left.into_iter().chain(right).collect();
    for ends in walk.windows(2) {
        let [a, b] = [ends[0], ends[1]];
        path.push(match random.tooth(3) {
            1 => PathSegment::Line([a, b]),
            2 => {
                let across = Rotation2::new(FRAC_PI_2) * (b - a);
                let off = random.within(-0.12, 0.12);
                PathSegment::Cubic([
                    a,
                    a + (b - a) / 3.0 + across * off,
                    b - (b - a) / 3.0 - across * off,
                    b,
                ])
            }
            _ => {
                // Through a middle point a tenth of the chord beside it: tan(sweep/4) is twice that.
                let bulge = random.within(-0.2, 0.2);
                let left = Rotation2::new(FRAC_PI_2) * (b - a);
                let centre = a + (b - a) * 0.5 + left * ((1.0 - bulge * bulge) / (4.0 * bulge));
                let from = a - centre;
                PathSegment::Arc {
                    centre,
                    radius: from.norm(),
                    start: from.y.atan2(from.x),
                    sweep: 4.0 * bulge.atan(),
                }
            }
        });
    }
    path
}

/// A wheel of irregular, different teeth, its root radius and depth; `None` if curves cross.
fn odd_wheel(random: &mut Random) -> Option<(OutlineGear, f64, f64)> {
    let teeth = 5 + random.tooth(20);
    let root = 0.9 * f64::from(teeth);
    let depth = random.within(2.0, 3.5);
    let odd: Vec<PathSegment> = (0..teeth)
        .flat_map(|k| {
            let tooth = odd_tooth(random, teeth, root, root + depth);
            turned(&tooth, -TAU * f64::from(k) / f64::from(teeth))
        })
        .collect();
    let closed = closed_by_arcs(&odd);
    let reading = OutlineReading {
        centre: Point2::origin(),
        face: Face::Front,
        teeth: Some(teeth),
        first_tooth: None,
        bound: 0.0,
    };
    let gear = OutlineGear::new(&closed, &reading).ok()?;
    Some((gear, root, depth))
}

/// Rectangles around runs of pieces rule out no contact. Source: every pair of pieces.
#[test]
fn nothing_that_touches_is_ruled_out() {
    let mut compared = 0;
    for seed in 0..90u64 {
        let mut random = Random(1000 + seed);
        let locked = [Member::Wheel, Member::Pinion][seed as usize % 2];
        let pair = if seed % 3 == 0 {
            let [wheel, pinion] = [Face::Front, Face::Back].map(|face| measured(&mut random, face));
            let zero = InvolutePair::new(wheel.gear(), pinion.gear()).center_distance(0.0);
            let distance = zero.unwrap() + random.within(-0.2, 1.0);
            let chord = random.decades(1e-3, 3e-2);
            let [wheel, pinion] = [drawn(&wheel, chord), drawn(&pinion, chord)];
            OutlinePair::new(wheel, pinion, distance, locked).unwrap()
        } else {
            let wheels = (odd_wheel(&mut random), odd_wheel(&mut random));
            let (Some((wheel, a, b)), Some((pinion, c, d))) = wheels else {
                continue;
            };
            let eccentricity = random.within(0.0, 0.3);
            let wheel = wheel.with_runout(eccentricity, 2.5).unwrap();
            let distance = a + c + random.within(0.3, 0.98) * (b + d);
            OutlinePair::new(wheel, pinion, distance, locked).unwrap()
        };
        let kernel = OutlineKernel::new(&pair);
        for k in 0..8u32 {
            let mating = at(k % 5 + 1, (k + 1) % 5 + 1, random.within(-0.5, 0.5));
            let found = kernel.lost_motion(&mating).unwrap();
            let all = kernel.lost_motion_by_search(&mating).unwrap();
            assert_eq!(found.status(), all.status(), "{seed} {k}");
            // For solid poses an overlap of half a turn counts from either side.
            if found.solid {
                continue;
            }
            for (found, all) in [(found.right, all.right), (found.left, all.left)] {
                assert_eq!(found.is_some(), all.is_some(), "{seed} {k}");
                if let Some((found, all)) = found.zip(all) {
                    let off = (found.rotation - all.rotation).abs();
                    let bound = found.error + all.error;
                    assert!(off <= bound, "{seed} {k}: {found:?} {all:?}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 500, "{compared}");
}

/// Wheels of irregular, different teeth: polygons overlap just outside the play found, and not just inside it.
#[test]
fn odd_teeth_overlap_just_outside_the_play() {
    let (mut clear, mut tight) = (0, 0);
    for seed in 0..160u64 {
        let mut random = Random(seed);
        // Curves can cross; such an outline is no gear.
        let (Some((wheel, a, b)), Some((pinion, c, d))) =
            (odd_wheel(&mut random), odd_wheel(&mut random))
        else {
            continue;
        };
        let locked = [Member::Wheel, Member::Pinion][seed as usize % 2];
        let distance = a + c + random.within(0.5, 0.95) * (b + d);
        let pair = OutlinePair::new(wheel, pinion, distance, locked).unwrap();
        let kernel = OutlineKernel::new(&pair);
        for k in 0..6u32 {
            let mating = at(k % 5 + 1, (k + 1) % 5 + 1, 0.23 * f64::from(k));
            let found = kernel.lost_motion(&mating).unwrap();
            let Some((right, left)) = found.right.zip(found.left) else {
                continue;
            };
            let off = |contact: &Contact| contact.error + 2e-4;
            if found.status() == Status::Clear && left.rotation - right.rotation > 2e-3 {
                for inside in [
                    right.rotation + off(&right),
                    left.rotation - off(&left),
                    0.5 * (right.rotation + left.rotation),
                ] {
                    assert!(!cross(&pair, &mating, inside), "{seed} {k} {found:?}");
                }
                assert!(
                    cross(&pair, &mating, right.rotation - 4.0 * off(&right)),
                    "{seed} {k} {found:?}"
                );
                assert!(
                    cross(&pair, &mating, left.rotation + 4.0 * off(&left)),
                    "{seed} {k} {found:?}"
                );
                clear += 1;
            } else if found.status() == Status::Interference {
                for share in [0.0, 0.3, 0.7, 1.0] {
                    let between = left.rotation + share * (right.rotation - left.rotation);
                    assert!(
                        cross(&pair, &mating, between) || right.rotation - left.rotation < 1e-3,
                        "{seed} {k} {found:?}"
                    );
                }
                tight += 1;
            }
        }
    }
    assert!(clear > 400 && tight > 8, "{clear} {tight}");
}

use super::*;
use crate::contact::exact::flank_problem::FlankProblem;
use crate::contact::exact::shape::turn;
use crate::gear::{AsBuilt, BasicGearData, Deviations, Face, Gear, GearDesign, Hand, Pitch, Side};
use crate::pair::{Mating, Pose};

/// A helical pair with runout and pitch deviations.
pub(in crate::contact::exact::helical) fn pair(
    teeth: [u32; 2],
    helix_deg: f64,
    eccentricity: [f64; 2],
    beyond: f64,
    locked: Member,
) -> GearPair {
    let gear = |k: usize| {
        let hand = [Hand::Right, Hand::Left][k];
        let data = BasicGearData::new(teeth[k], 2.0, 20f64.to_radians()).unwrap();
        let design = GearDesign {
            basic_data: data.with_helix(helix_deg.to_radians(), hand).unwrap(),
            ..GearDesign::plain(teeth[k], 2.0)
        };
        let wave =
            |start: u32| (0..teeth[k]).map(move |k| 2e-5 * f64::from((k * 7919 + start) % 1000));
        let deviations = Deviations {
            pitch: Some(Pitch::from_cumulative(
                &wave(17).collect::<Vec<_>>(),
                &wave(443).collect::<Vec<_>>(),
            )),
            eccentricity: eccentricity[k],
            high_tooth: 2.7,
            ..Deviations::default()
        };
        let face = [Face::Front, Face::Back][k];
        AsBuilt::new(Gear::nominal(design).unwrap(), face, &deviations).unwrap()
    };
    let (wheel, pinion) = (gear(0), gear(1));
    let sum = wheel.gear().basic_data().reference_radius()
        + pinion.gear().basic_data().reference_radius();
    let pair = GearPair::with_locked(wheel, pinion, sum + beyond, locked).unwrap();
    pair.with_face([-9.0, 7.0]).unwrap()
}

/// A pose and the teeth of its sides.
pub(in crate::contact::exact::helical) fn posed<'a>(
    pair: &GearPair,
    problem: &'a FlankProblem,
    mating: Mating,
) -> PosedFlanks<'a> {
    let pose = Pose::new(pair, mating);
    let teeth = (mating.tooth(pair.locked()), mating.tooth(pair.free()));
    let rotation = reduced(pose.locked_rotation());
    problem.posed(&pose, teeth, rotation, turn(rotation))
}

fn pairs() -> [GearPair; 3] {
    [
        pair([31, 17], 25.0, [0.05, 0.3], 0.2, Member::Wheel),
        pair([12, 40], 8.0, [0.4, 0.0], 0.6, Member::Pinion),
        pair([23, 23], 35.0, [0.0, 0.02], -0.1, Member::Wheel),
    ]
}

fn near(one: f64, other: f64) -> bool {
    reduced(one - other).abs() < 1e-12
}

/// The directions of teeth along the face agree with their section. Source: the section's own pair and pose, tooth by tooth.
#[test]
fn teeth_have_the_directions_of_their_section() {
    for pair in pairs() {
        for side in Side::BOTH {
            let problem = FlankProblem::new(&pair, side);
            let mating = Mating {
                fraction: 0.3,
                ..Mating::FIRST
            };
            let here = posed(&pair, &problem, mating);
            let rotation = 0.37;
            let teeth = [
                TwistedTeeth::locked(&pair, &here),
                TwistedTeeth::free(&pair, &here, rotation),
            ];
            for b in [-9.0, -2.5, 0.0, 7.0] {
                let twist =
                    |member| -side.sense() * pair.gear(member).gear().basic_data().twist() * b;
                for step in -6..=6 {
                    let locked = here.locked(step).direction;
                    let free = here.free(step).direction * turn(rotation);
                    for (turning, stands) in teeth.iter().zip([
                        locked * turn(twist(pair.locked())),
                        free * turn(twist(pair.free())),
                    ]) {
                        let found = turning.direction(b, step);
                        assert!(
                            near(found, stands.arg()),
                            "{side:?} {b} {step}: {found} {stands}"
                        );
                        // And back: that direction has its place, except for whole turns.
                        let place = turning.place(found, step);
                        assert!(near(turning.direction(place, step), found));
                    }
                }
            }
        }
    }
}

/// The places of an edge with a given direction include those of every tooth on the face, on either side of an end.
/// Source: all teeth, one by one.
#[test]
fn no_place_on_the_face_is_left_out() {
    let mut count = 0;
    for pair in pairs() {
        let problem = FlankProblem::new(&pair, Side::Left);
        let here = posed(&pair, &problem, Mating::FIRST);
        for turning in [
            TwistedTeeth::locked(&pair, &here),
            TwistedTeeth::free(&pair, &here, -0.2),
        ] {
            for k in 0..40 {
                let direction = 0.17 * f64::from(k) - 3.3;
                let edge = Edge::corner(turn(0.06) * 20.0);
                let (mut found, mut ends) = (Vec::new(), Vec::new());
                ends.extend(turning.places(&edge, direction));
                let middle = Edge {
                    is_end: false,
                    ..edge
                };
                found.extend(turning.places(&middle, direction));
                let steps = turning.steps(direction - 0.06);
                let [from, to] = turning.face;
                let mut expected = Vec::new();
                for step in -60..=60 {
                    let off = reduced(direction - 0.06 - turning.ahead)
                        - step as f64 * turning.step
                        - (turning.offset)(step);
                    let b = off / turning.twist;
                    if b > from + 1e-9 && b < to - 1e-9 {
                        expected.push((step, b));
                        assert!(steps.contains(&step), "{step} {steps:?}");
                    }
                }
                count += expected.len();
                assert_eq!(found.len(), expected.len());
                assert!((2 * expected.len()..=2 * expected.len() + 1).contains(&ends.len()));
                let beside = BESIDE / turning.twist.abs();
                for (step, b) in expected {
                    for (places, off) in [(&found, 0.0), (&ends, -beside), (&ends, beside)] {
                        let is_there = places.iter().any(|place| {
                            place.step == step && (place.b - b - off).abs() < 0.1 * beside + 1e-14
                        });
                        assert!(is_there, "{b}: {places:?}");
                    }
                }
                let mut all = found.iter().chain(&ends);
                assert!(all.all(|place| (from..=to).contains(&place.b)));
            }
        }
    }
    assert!(count > 100, "{count}");
}

/// Both intersections of circles are on both circles. Circles that are apart, or one inside the other, have none.
#[test]
fn crossings_lie_on_both_circles() {
    let at = |x, y| C::new(x, y);
    let mut found = 0;
    for (one, other) in [
        ((at(1.0, 2.0), 5.0), (at(6.0, 3.0), 3.0)),
        ((at(-4.0, 0.5), 2.0), (at(-4.5, 2.0), 1.5)),
        ((at(0.0, 0.0), 2.0), (at(4.1, 0.0), 2.0)),
        ((at(0.0, 0.0), 2.0), (at(0.5, 0.0), 1.0)),
    ] {
        let distance = (other.0 - one.0).norm();
        let crosses = distance < one.1 + other.1 && distance > (one.1 - other.1).abs();
        let crossing = Crossing::new([one.0, other.0], [one.1, other.1]);
        assert_eq!(crossing.is_some(), crosses);
        let points = crossing.map(|crossing| {
            let from = |[ahead, behind]: [f64; 2]| {
                let points = [
                    one.0 + turn(ahead) * one.1,
                    other.0 + turn(behind) * other.1,
                ];
                assert!((points[0] - points[1]).norm() < 1e-14 * 10.0);
                points[0]
            };
            crossing.directions.map(from)
        });
        for point in points.into_iter().flatten() {
            assert!(((point - one.0).norm() - one.1).abs() < 1e-14 * 10.0);
            assert!(((point - other.0).norm() - other.1).abs() < 1e-14 * 10.0);
            found += 1;
        }
        if let Some([ahead, behind]) = points {
            // The first lies counter-clockwise of the line between the centres.
            let side = |point: C| ((other.0 - one.0).conj() * (point - one.0)).im;
            assert!(side(ahead) > 0.0 && side(behind) < 0.0);
        }
    }
    assert_eq!(found, 4);
}

/// Crossing edges of both gears meet in one point after the free gear turns there, and no crossing on the face is omitted. Source: every
/// locked tooth at 1000 places along the face, with the free gear turned to the direction of that point.
#[test]
fn edges_that_cross_are_at_one_point() {
    let mut count = 0;
    for (pair, fraction) in pairs()
        .into_iter()
        .flat_map(|pair| [0.1, 0.35, 0.6, 0.85].map(|fraction| (pair.clone(), fraction)))
    {
        for side in Side::BOTH {
            let problem = FlankProblem::new(&pair, side);
            let mating = Mating {
                fraction,
                ..Mating::FIRST
            };
            let here = posed(&pair, &problem, mating);
            let rotation = -problem.free.pitch * 0.13 - here.free_angle();
            let teeth = [
                TwistedTeeth::locked(&pair, &here),
                TwistedTeeth::free(&pair, &here, rotation),
            ];
            let corners = [
                problem.locked.shape.tip_corner(),
                problem.free.shape.tip_corner(),
            ];
            let edges = corners.map(Edge::corner);
            let effort = Effort::endless();
            let mut places = Vec::new();
            crossing_places(
                &here,
                &teeth,
                [&edges[0], &edges[1]],
                FreeGear {
                    rotation,
                    is_held: true,
                },
                (&mut places, &effort),
            );
            // Distance of the locked edge's point at `b` from the free edge's circle, and the turn of the free gear to it.
            let off = |b: f64, step: i64, mate: i64| {
                let direction = teeth[0].direction(b, step) + corners[0].arg();
                let point = here.centre + turn(direction) * edges[0].radius;
                let mut turned = 0.0;
                for _ in 0..12 {
                    let seen = (point - here.free_centre_at(rotation + turned)).arg();
                    turned = reduced(seen - corners[1].arg() - teeth[1].direction(b, mate));
                }
                (
                    (point - here.free_centre_at(rotation + turned)).norm() - edges[1].radius,
                    turned,
                )
            };
            let [from, to] = teeth[0].face;
            let mut crossed = Vec::new();
            let at = |k: u32| from + (to - from) * f64::from(k) / 1e3;
            for step in -14..=14 {
                // The free tooth that faces it, and its distance.
                let looked = |b: f64| (step, off(b, step, step).0);
                let mut before = looked(at(0));
                for k in 0..1000 {
                    let after = looked(at(k + 1));
                    if before.0 == after.0 && (before.1 < 0.0) != (after.1 < 0.0) {
                        let (mut low, mut high) = (at(k), at(k + 1));
                        for _ in 0..60 {
                            let middle = 0.5 * (low + high);
                            let same = (off(middle, step, before.0).0 < 0.0) == (before.1 < 0.0);
                            if same { low = middle } else { high = middle }
                        }
                        crossed.push((low, off(low, step, before.0).1));
                    }
                    before = after;
                }
            }
            for &(b, turned) in &crossed {
                let found = places.iter().any(|place| (place.b - b).abs() < 1e-8);
                // A turn of more than a pitch starts from another place than the source.
                let clear = turned.abs() < problem.free.pitch && turned.abs() > 1e-6;
                assert!(
                    !clear || found == (turned > 0.0),
                    "{side:?} {b} {turned}: {places:?}"
                );
                count += usize::from(found);
            }
            for place in &places {
                let known = crossed.iter().any(|(b, _)| (place.b - b).abs() < 1e-8);
                assert!(
                    known || place.b - from < 1e-8 || to - place.b < 1e-8,
                    "{place:?}: {crossed:?}"
                );
            }
        }
    }
    assert!(count > 10, "{count}");
}

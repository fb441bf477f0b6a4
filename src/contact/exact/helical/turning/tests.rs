use super::*;
use crate::contact::exact::flank_problem::FlankProblem;
use crate::contact::exact::shape::turn;
use crate::gear::{Deviations, Face, GearDesign, Hand, Side};
use crate::pair::{Mating, Member, Pose};

/// A helical pair with runout and pitch deviations.
pub(in crate::contact::exact::helical) fn pair(
    teeth: [u32; 2],
    helix_deg: f64,
    eccentricity: [f64; 2],
    beyond: f64,
    locked: Member,
) -> GearPair {
    let gear = |k: usize, hand, face| {
        let design = GearDesign::plain(teeth[k], 2.0).helical(helix_deg, hand);
        let wave = |start: u32| -> Vec<f64> {
            let each = 0..teeth[k];
            each.map(|k| 2e-5 * f64::from((k * 7919 + start) % 1000))
                .collect()
        };
        let deviations = Deviations::off_axis(eccentricity[k], 2.7);
        design.built(face, &deviations.with_pitch(&wave(17), &wave(443)))
    };
    let wheel = gear(0, Hand::Right, Face::Front);
    let pinion = gear(1, Hand::Left, Face::Back);
    let radii = [&wheel, &pinion].map(|gear| gear.gear().basic_data().reference_radius());
    let pair = GearPair::with_locked(wheel, pinion, radii[0] + radii[1] + beyond, locked);
    pair.unwrap().with_face([-9.0, 7.0]).unwrap()
}

/// The teeth of a side, this fraction of a pitch after the first pose.
pub(in crate::contact::exact::helical) fn posed<'a>(
    pair: &GearPair,
    problem: &'a FlankProblem,
    fraction: f64,
) -> PosedFlanks<'a> {
    let mating = Mating {
        fraction,
        ..Mating::FIRST
    };
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

/// The directions of teeth along the face agree with their section. Source: the section's own pair and pose, tooth by tooth.
#[test]
fn teeth_have_the_directions_of_their_section() {
    let near = |one: f64, other: f64| reduced(one - other).abs() < 1e-12;
    for (pair, side) in pairs()
        .iter()
        .flat_map(|pair| Side::BOTH.map(|side| (pair, side)))
    {
        let problem = FlankProblem::new(pair, side);
        let here = posed(pair, &problem, 0.3);
        let rotation = 0.37;
        let teeth = [
            TwistedTeeth::locked(pair, &here),
            TwistedTeeth::free(pair, &here, rotation),
        ];
        for b in [-9.0, -2.5, 0.0, 7.0] {
            let twisted =
                |member| turn(-side.sense() * pair.gear(member).gear().basic_data().twist() * b);
            for step in -6..=6 {
                let locked = here.locked(step).direction;
                let free = here.free(step).direction * turn(rotation);
                let stand = [locked * twisted(pair.locked()), free * twisted(pair.free())];
                for (turning, stands) in teeth.iter().zip(stand) {
                    let found = turning.direction(b, step);
                    assert!(near(found, stands.arg()), "{side:?} {b} {step}: {found}");
                    // And back: that direction has its place, except for whole turns.
                    let place = turning.place(found, step);
                    assert!(near(turning.direction(place, step), found));
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
        let here = posed(&pair, &problem, 0.0);
        for turning in [
            TwistedTeeth::locked(&pair, &here),
            TwistedTeeth::free(&pair, &here, -0.2),
        ] {
            for direction in (0..40).map(|k| 0.17 * f64::from(k) - 3.3) {
                let [ends, found] = [true, false].map(|is_end| -> Vec<Place> {
                    let edge = Edge {
                        is_end,
                        ..Edge::corner(turn(0.06) * 20.0)
                    };
                    turning.places(&edge, direction).collect()
                });
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
    for (centres, radii, crosses) in [
        ([at(1.0, 2.0), at(6.0, 3.0)], [5.0, 3.0], true),
        ([at(-4.0, 0.5), at(-4.5, 2.0)], [2.0, 1.5], true),
        ([at(0.0, 0.0), at(4.1, 0.0)], [2.0, 2.0], false),
        ([at(0.0, 0.0), at(0.5, 0.0)], [2.0, 1.0], false),
    ] {
        let crossing = Crossing::new(centres, radii);
        assert_eq!(crossing.is_some(), crosses);
        // The first lies counter-clockwise of the line between the centres.
        for (directions, sense) in crossing
            .iter()
            .flat_map(|crossing| crossing.directions.into_iter().zip([1.0, -1.0]))
        {
            let points = [0, 1].map(|k| centres[k] + turn(directions[k]) * radii[k]);
            assert!((points[0] - points[1]).norm() < 1e-13);
            let side = (centres[1] - centres[0]).conj() * (points[0] - centres[0]);
            assert!(sense * side.im > 0.0);
        }
    }
}

//! Outlines against the exact method, which knows what each curve of a gear is and where it can touch.

use crate::extremes::random_pair::rough_case;
use crate::random::Random;
use crate::straight_sided::straight;
use crate::wide::drawn::{Depth, Drawn, Pair};
use gearlash::analytic::InvolutePair;
use gearlash::contact::{ExactKernel, LostMotion, OutlineCertifier, OutlineKernel, Status};
use gearlash::gear::{
    AsBuilt, BasicGearData, Deviations, Face, Gear, GearDesign, Pitch, Placed, Side,
};
use gearlash::outline::{OutlineGear, OutlinePair, OutlineReading, PathSegment};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use nalgebra::Point2;
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;

fn outlines(pair: &GearPair) -> OutlinePair {
    let gear = |member| OutlineGear::from(pair.gear(member));
    let (wheel, pinion) = (gear(Member::Wheel), gear(Member::Pinion));
    OutlinePair::new(wheel, pinion, pair.center_distance(), pair.locked()).unwrap()
}

/// Both methods at one rotation of the locked gear, near `mating`; polygons confirm the result.
fn both(pair: &GearPair, mating: Mating) -> (LostMotion, LostMotion) {
    let outlines = outlines(pair);
    let pose = Pose::new(pair, mating);
    let locked = pair.gear(pair.locked());
    let pitch = locked.gear().basic_data().angular_pitch();
    let off = outlines.rotation(pair.locked(), &mating) - pose.locked_rotation();
    let same = mating.onward(pair, -locked.face().ascending() * off / pitch);
    let exact = ExactKernel::new(pair).lost_motion(&Pose::new(pair, same));
    let kernel = OutlineKernel::new(&outlines);
    let found = kernel.lost_motion(&mating).unwrap();
    let seen = OutlineCertifier::new(&kernel).check(&mating, &found);
    assert_eq!(seen, Ok(()), "{mating:?} {found:?}");
    (exact.unwrap(), found)
}

/// The same contacts, within both bounds and what the two rotations differ by rounding.
fn agree(pair: &GearPair, mating: Mating) -> Result<Status, TestCaseError> {
    let (exact, found) = both(pair, mating);
    for (exact, found) in [(exact.right, found.right), (exact.left, found.left)] {
        prop_assert_eq!(exact.is_some(), found.is_some());
        let Some((exact, found)) = exact.zip(found) else {
            continue;
        };
        let off = exact.rotation - found.rotation;
        let off = off - std::f64::consts::TAU * (off / std::f64::consts::TAU).round();
        let bound = exact.error + found.error + 1e-12;
        prop_assert!(off.abs() <= bound, "{off} rad: {exact:?} {found:?}");
    }
    if let (Some(angle), Some(other)) = (exact.angle(), found.angle()) {
        let bound = exact.error().unwrap() + found.error().unwrap() + 1e-12;
        prop_assert!((angle - other).abs() <= bound, "{angle} {other}");
    }
    Ok(exact.status())
}

fn mating(pair: &GearPair, [wheel, pinion]: [u32; 2], flank: Side, fraction: f64) -> Mating {
    let teeth = |member| pair.gear(member).gear().basic_data().teeth();
    Mating {
        wheel_tooth: wheel % teeth(Member::Wheel) + 1,
        pinion_tooth: pinion % teeth(Member::Pinion) + 1,
        flank,
        fraction,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn of_measured_gears_they_have_the_same_lost_motion(
        case in rough_case(),
        teeth in [any::<u16>(), any::<u16>()],
        left in any::<bool>(),
        fraction in -0.5..0.5f64,
    ) {
        if let Ok(pair) = case.try_assemble(1.0) {
            let flank = if left { Side::Left } else { Side::Right };
            agree(&pair, mating(&pair, teeth.map(u32::from), flank, fraction))?;
        }
    }
}

/// From far beyond any shop: undercut, three teeth, jams, tips in fillets and roots.
#[test]
fn of_wide_pairs_they_have_the_same_contacts() {
    let mut seen = std::collections::HashMap::new();
    for number in 0..400 {
        let drawn = Pair::new(77, number).pose(0, Some(Depth::Any));
        let pair = &drawn.assembly;
        let reach =
            |member: Member| pair.gear(member).reach() + pair.gear(member.mate()).eccentricity();
        if reach(Member::Wheel).max(reach(Member::Pinion)) >= pair.center_distance() {
            continue;
        }
        let status = agree(
            pair,
            mating(
                pair,
                [number as u32 * 7, number as u32 * 11],
                Side::Right,
                0.3,
            ),
        );
        *seen
            .entry(status.unwrap_or_else(|error| panic!("pair {number}: {error}")))
            .or_insert(0) += 1;
    }
    assert!(
        [Status::Clear, Status::Interference, Status::Jammed]
            .iter()
            .all(|status| seen[status] > 10),
        "{seen:?}"
    );
}

/// The outline of a gear as someone draws its reference face: a polygon of chords within `chord` mm of its curves.
pub fn drawn(built: &AsBuilt, chord: f64) -> OutlineGear {
    let placed = Placed::new(built, Point2::origin(), FRAC_PI_2);
    let points = placed.outline_near(Point2::origin(), 2.0 * built.reach(), chord);
    let mirror = -built.face().ascending();
    let points: Vec<Point2<f64>> = points
        .iter()
        .map(|point| Point2::new(mirror * point.x, point.y))
        .collect();
    let next = points.iter().cycle().skip(1);
    let lines = points.iter().zip(next);
    let lines: Vec<PathSegment> = lines
        .map(|(from, to)| PathSegment::Line([*from, *to]))
        .collect();
    let reading = OutlineReading {
        centre: Point2::new(mirror * placed.centre().x, placed.centre().y),
        face: built.face(),
        teeth: Some(built.gear().basic_data().teeth()),
        first_tooth: Some(FRAC_PI_2),
        bound: chord,
    };
    let gear = OutlineGear::new(&lines, &reading).unwrap();
    gear.with_runout(built.eccentricity(), built.high_tooth())
        .unwrap()
}

/// A gear of module 2 with deviations of a few hundredths of a module.
pub fn measured(random: &mut Random, face: Face) -> AsBuilt {
    let teeth = 11 + random.tooth(49);
    let base = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
    let design = GearDesign {
        profile_shift: random.within(0.0, 0.4),
        ..GearDesign::standard(base)
    };
    let mut list = || -> Vec<f64> { (0..teeth).map(|_| random.within(-0.02, 0.02)).collect() };
    let deviations = Deviations {
        per_tooth: list(),
        pitch: Some(Pitch::from_cumulative(&list(), &list())),
        eccentricity: 0.03,
        high_tooth: 4.5,
        ..Deviations::default()
    };
    AsBuilt::new(Gear::nominal(design).unwrap(), face, &deviations).unwrap()
}

/// Polygons of measured gears, right and left halves numbered as their data are: the lost motion of their curves, within the chords' error.
#[test]
fn polygons_of_measured_gears_have_their_lost_motion() {
    const CHORD: f64 = 1e-4;
    let mut random = Random(15);
    let mut compared = 0;
    for number in 0..12 {
        let [front, back] = [Face::Front, Face::Back].map(|face| measured(&mut random, face));
        let (wheel, pinion) = if number % 2 == 0 {
            (front, back)
        } else {
            (back, front)
        };
        let zero = InvolutePair::new(wheel.gear(), pinion.gear()).center_distance(0.0);
        let distance = zero.unwrap() + random.within(-0.1, 0.3);
        let locked = [Member::Wheel, Member::Pinion][number / 2 % 2];
        let pair = GearPair::with_locked(wheel, pinion, distance, locked).unwrap();
        let [wheel, pinion] =
            [Member::Wheel, Member::Pinion].map(|member| drawn(pair.gear(member), CHORD));
        let outlines = OutlinePair::new(wheel, pinion, distance, locked).unwrap();
        let (kernel, exact) = (OutlineKernel::new(&outlines), ExactKernel::new(&pair));
        let certifier = OutlineCertifier::new(&kernel);
        let locked = pair.gear(pair.locked());
        for k in 0..8 {
            let flank = Side::BOTH[k as usize % 2];
            let mating = mating(&pair, [3 * k, 5 * k], flank, 0.1 * f64::from(k));
            // A drawing counts from where its tooth 1 stands.
            let beside = Side::BOTH.map(|side| locked.flank_offset(side, 1));
            let rotation =
                outlines.rotation(pair.locked(), &mating) - 0.5 * (beside[0] + beside[1]);
            let off = rotation - Pose::new(&pair, mating).locked_rotation();
            let pitch = locked.gear().basic_data().angular_pitch();
            let same = mating.onward(&pair, -locked.face().ascending() * off / pitch);
            let exact = exact.lost_motion(&Pose::new(&pair, same)).unwrap();
            let found = kernel.lost_motion(&mating).unwrap();
            refuses_any_other(&certifier, &mating, &found);
            let Some((angle, other)) = exact.angle().zip(found.angle()) else {
                continue;
            };
            let bound = exact.error().unwrap() + found.error().unwrap();
            assert!(
                (angle - other).abs() <= bound,
                "{angle} {other} {bound} {found:?}"
            );
            // Chords cut off metal, so there is only more room.
            assert!(other - angle > -1e-9, "{angle} {other}");
            compared += 1;
        }
    }
    assert!(compared > 80, "{compared}");
}

/// Polygons confirm `found`, and no rotation slightly to either side: before it nothing touches, after it something overlaps.
fn refuses_any_other(certifier: &OutlineCertifier, mating: &Mating, found: &LostMotion) {
    assert_eq!(certifier.check(mating, found), Ok(()), "{found:?}");
    let Some((right, left)) = found.right.zip(found.left).filter(|_| !found.solid) else {
        return;
    };
    // Contacts of drawn gears are known within what was drawn.
    let little = 1e-6 + 3.0 * right.error.max(left.error);
    for off in [-little, little] {
        let (mut one, mut other) = (*found, *found);
        one.right.as_mut().unwrap().rotation += off;
        other.left.as_mut().unwrap().rotation += off;
        for (wrong, flank) in [(one, "right"), (other, "left")] {
            let seen = certifier.check(mating, &wrong);
            assert!(seen.is_err_and(|seen| seen.flank == flank), "{seen:?}");
        }
    }
    let none = LostMotion {
        right: None,
        ..*found
    };
    assert!(certifier.check(mating, &none).is_err());
}

/// Straight-sided teeth, drawn: two racks' worth of trapezoids, whose play [`crate::straight_sided`] works out by hand.
#[test]
fn trapezoids_have_the_play_worked_out_by_hand() {
    let wheel = straight(20, [0.55, 1.25], Face::Front, Vec::new());
    let pinion = straight(33, [0.6, 1.2], Face::Back, Vec::new());
    let pair = GearPair::new(wheel, pinion, 80.5).unwrap();
    let [wheel, pinion] =
        [Member::Wheel, Member::Pinion].map(|member| drawn(pair.gear(member), 1e-6));
    let outlines = OutlinePair::new(wheel, pinion, 80.5, Member::Wheel).unwrap();
    let (kernel, exact) = (OutlineKernel::new(&outlines), ExactKernel::new(&pair));
    for k in 0..24 {
        let mating = mating(&pair, [k, 2 * k], Side::Left, 0.21 * f64::from(k));
        let off =
            outlines.rotation(Member::Wheel, &mating) - Pose::new(&pair, mating).locked_rotation();
        let pitch = pair.gear(Member::Wheel).gear().basic_data().angular_pitch();
        let same = mating.onward(&pair, off / pitch);
        let exact = exact.lost_motion(&Pose::new(&pair, same)).unwrap();
        let found = kernel.lost_motion(&mating).unwrap();
        let (angle, other) = (exact.angle().unwrap(), found.angle().unwrap());
        // Lands are chords within the drawing's bound.
        assert!((angle - other).abs() < 1e-9, "{angle} {other}");
    }
}

/// The same drawn in arcs that bulge by a hundredth of their length: every one of them is a curve.
fn drawn_in_arcs(built: &AsBuilt, chord: f64) -> OutlineGear {
    let placed = Placed::new(built, Point2::origin(), FRAC_PI_2);
    let points = placed.outline_near(Point2::origin(), 2.0 * built.reach(), chord);
    let next = points.iter().cycle().skip(1);
    let arcs = points.iter().zip(next).map(|(from, to)| {
        let along = to - from;
        let out = nalgebra::Vector2::new(along.y, -along.x) * 0.01;
        let thirds = [1.0, 2.0].map(|k| from + along * (k / 3.0) + out);
        PathSegment::Cubic([*from, thirds[0], thirds[1], *to])
    });
    let reading = OutlineReading {
        centre: Point2::origin(),
        face: built.face(),
        teeth: None,
        first_tooth: None,
        bound: 0.0,
    };
    OutlineGear::new(&arcs.collect::<Vec<_>>(), &reading).unwrap()
}

/// Outlines of thousands of curves a tooth whose tips just miss each other, or just meet: either is borne out within the effort of a side. Source: a
/// distance above the sum of both reaches, and one below.
#[test]
fn polygons_bear_out_that_dense_tips_miss_each_other() {
    let base = BasicGearData::new(12, 2.0, 20f64.to_radians()).unwrap();
    let gear = Gear::nominal(GearDesign::standard(base)).unwrap();
    let gears =
        [Face::Front; 2].map(|face| drawn_in_arcs(&AsBuilt::perfect(gear.clone(), face), 1e-6));
    let pieces = gears[0].points(0.0, 1.0).len();
    assert!(pieces > 10_000, "{pieces}");
    let reach = gears[0].reach() + gears[1].reach();
    let [wheel, pinion] = gears;
    for (apart, touches) in [(1e-6, false), (-0.5, true)] {
        let pair = OutlinePair::new(wheel.clone(), pinion.clone(), reach + apart, Member::Wheel);
        let pair = pair.unwrap();
        let kernel = OutlineKernel::new(&pair);
        let found = kernel.lost_motion(&Mating::FIRST).unwrap();
        assert_eq!(found.right.is_some(), touches);
        let certifier = OutlineCertifier::new(&kernel);
        assert_eq!(certifier.check(&Mating::FIRST, &found), Ok(()), "{apart}");
    }
}

/// Three free teeth, turned by more than half a turn from where they face the mate (the same pose as in `both_methods`).
#[test]
fn a_gap_of_more_than_half_a_turn_is_the_greatest() {
    let drawn = Drawn::new(None, 29, 637_932);
    let status = agree(&drawn.assembly, drawn.mating).unwrap();
    assert_eq!(status, Status::Jammed);
}

//! Teeth with straight flanks, a line in the place of the involute: two racks' worth of trapezoids. Expected values are worked out by
//! hand: two straight flanks touch where a tip corner of one lies on the other, and where a circle about the free axis meets a line.

use crate::design::design;
use crate::methods::{turned, with_contact, without_turns};
use gearlash::contact::{Certifier, CutPair, ExactKernel};
use gearlash::gear::{AsBuilt, Deviations, Face, Gear, Side};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use nalgebra::{Rotation2, Vector2};
use std::f64::consts::PI;

/// `teeth` of module 3, straight-sided: parts of a quarter pitch that half a tooth spans at the tip and at the root circle.
fn straight(teeth: u32, [tip, root]: [f64; 2], face: Face, per_tooth: Vec<f64>) -> AsBuilt {
    let quarter = PI / (2.0 * f64::from(teeth));
    let gear = Gear::nominal(design(teeth, 3.0)).unwrap();
    let gear = gear
        .with_straight_flanks(tip * quarter, root * quarter)
        .unwrap();
    assert!(!gear.is_generated());
    let deviations = Deviations {
        per_tooth,
        ..Deviations::default()
    };
    AsBuilt::new(gear, face, &deviations).unwrap()
}

/// Half a tooth has a width at the tip, no less at the root, and leaves a space.
#[test]
fn straight_flanks_that_leave_no_tooth_or_space_are_refused() {
    let gear = Gear::nominal(design(20, 3.0)).unwrap();
    let half_pitch = PI / 20.0;
    for (tip, root) in [
        (0.0, 0.1),
        (-0.01, 0.1),
        (0.08, 0.07),
        (0.08, half_pitch),
        (f64::NAN, 0.1),
        (0.05, f64::NAN),
    ] {
        assert!(
            gear.with_straight_flanks(tip, root).is_err(),
            "{tip} {root}"
        );
    }
    assert!(gear.with_straight_flanks(0.05, 0.999 * half_pitch).is_ok());
}

/// Drawn larger, the deviations of straight-sided teeth leave them straight-sided.
#[test]
fn exaggerated_straight_flanks_stay_straight() {
    let uneven = (0..20).map(|k| 0.001 * f64::from(k % 3)).collect();
    let built = straight(20, [0.55, 1.25], Face::Front, uneven);
    let large = built.exaggerated(30.0).unwrap();
    assert_eq!(large.gear(), built.gear());
    let (small, large) = [&built, &large]
        .map(|gear| gear.flank_offset(Side::Left, 3))
        .into();
    assert!((large - 30.0 * small).abs() < 1e-15 && small > 0.0);
}

/// Tip corner and root corner of a flank, the gear's axis at `axis`, its tooth 1 turned to `tooth_1`.
fn flank(
    gear: &AsBuilt,
    half: [f64; 2],
    axis: Vector2<f64>,
    tooth_1: f64,
    tooth: u32,
    side: Side,
) -> [Vector2<f64>; 2] {
    let quarter = PI / (2.0 * f64::from(gear.gear().basic_data().teeth()));
    let middle = tooth_1 + gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
    let radii = [gear.gear().tip_radius(), gear.gear().root_radius()];
    [0, 1].map(|end| {
        let turn = Rotation2::new(middle + side.sense() * half[end] * quarter);
        axis + turn * Vector2::new(radii[end], 0.0)
    })
}

/// Where the circle of radius `rho` about `axis` meets the line through both ends of a flank, between them: at the foot of the
/// perpendicular, `h` away, and `√(ρ² − h²)` along the line to either side of it.
fn on_circle(
    [tip, root]: [Vector2<f64>; 2],
    axis: Vector2<f64>,
    rho: f64,
) -> impl Iterator<Item = Vector2<f64>> {
    let length = (root - tip).norm();
    let along = (root - tip) / length;
    let from = axis - tip;
    let (foot, h) = (from.dot(&along), from.perp(&along));
    let half = (rho * rho - h * h).sqrt();
    let places = [foot - half, foot + half].into_iter();
    places
        .filter(move |s| (0.0..=length).contains(s))
        .map(move |s| tip + s * along)
}

/// The free pinion's rotations beyond nominal at which a flank of one side touches: clockwise it can turn down to the greatest one of the right
/// flanks, counter-clockwise up to the least one of the left flanks.
fn by_hand(pair: &GearPair, halves: [[f64; 2]; 2], pose: &Pose) -> [f64; 2] {
    let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member));
    let axes = [Vector2::zeros(), Vector2::new(pair.center_distance(), 0.0)];
    let turn = |from: Vector2<f64>, to: Vector2<f64>| {
        let [from, to] = [from, to].map(|point| point - axes[1]);
        from.perp(&to).atan2(from.dot(&to))
    };
    Side::BOTH.map(|side| {
        let mut rotations = Vec::new();
        for ours in 1..=pair.teeth(Member::Wheel) {
            let turned = pose.locked_rotation();
            let locked = flank(wheel, halves[0], axes[0], turned, ours, side);
            for theirs in 1..=pair.teeth(Member::Pinion) {
                // At rotation 0 tooth 1 of the pinion points at the wheel.
                let free = flank(pinion, halves[1], axes[1], PI, theirs, side);
                // The wheel's tip corner on the pinion's flank, the pinion's tip corner on the wheel's.
                let met = on_circle(free, axes[1], (locked[0] - axes[1]).norm());
                rotations.extend(met.map(|met| turn(met, locked[0])));
                let met = on_circle(locked, axes[1], (free[0] - axes[1]).norm());
                rotations.extend(met.map(|met| turn(free[0], met)));
            }
        }
        let beyond = rotations
            .iter()
            .map(|rotation| without_turns(rotation - pose.free_rotation()));
        // Other teeth of the same side would touch a pitch on.
        let pitch = pinion.gear().basic_data().angular_pitch();
        let near = beyond.filter(|off| off.abs() < pitch / 2.0);
        match side {
            Side::Right => near.fold(f64::NEG_INFINITY, f64::max),
            Side::Left => near.fold(f64::INFINITY, f64::min),
        }
    })
}

/// Lost motion at every phase, by the exact method, its search, polygons, and certified; contacts at a tip corner each.
#[test]
fn straight_flanks_touch_where_lines_and_circles_meet() {
    let mut met = [0; 2];
    for (teeth, halves, distance) in [
        ([20, 30], [[0.55, 1.25], [0.6, 1.2]], 75.3),
        ([24, 24], [[0.7, 1.1], [0.5, 1.3]], 72.2),
        ([40, 16], [[0.6, 1.3], [0.75, 1.15]], 84.1),
    ] {
        let uneven = |count: u32| (0..count).map(|k| 0.02 * f64::from(k % 5)).collect();
        let wheel = straight(teeth[0], halves[0], Face::Front, uneven(teeth[0]));
        let pinion = straight(teeth[1], halves[1], Face::Back, Vec::new());
        let cut = CutPair::for_certificates(&wheel, &pinion);
        let pair = GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap();
        let kernel = ExactKernel::new(&pair);
        assert!(!kernel.is_direct());
        let (refined, certifier) = (cut.refined_kernel(&pair), Certifier::new(cut.kernel(&pair)));
        for k in 0..40 {
            let mating = Mating {
                fraction: f64::from(k) / 40.0,
                ..Mating::at(1 + k % 7, 1, Side::BOTH[k as usize % 2])
            };
            let pose = Pose::new(&pair, mating);
            let [right, left] = by_hand(&pair, halves, &pose);
            let expected = left - right;
            let exact = kernel.lost_motion(&pose).unwrap();
            for found in [
                exact,
                kernel.lost_motion_by_search(&pose).unwrap(),
                refined.lost_motion(&pose).unwrap(),
            ] {
                let (angle, error) = (found.angle().unwrap(), found.error().unwrap());
                let what = format!("{teeth:?} {k}: {angle} for {expected}, {error}");
                assert!(error < 1e-11, "{what}");
                assert!((angle - expected).abs() < error + 1e-14, "{what}");
            }
            certifier.check(&pose, &exact).unwrap();
            for by in [1e-8, -1e-8] {
                let right = exact.right.map(|contact| turned(contact, by));
                let wrong = with_contact(&exact, Side::Right, right);
                assert!(certifier.check(&pose, &wrong).is_err());
            }
            met[usize::from(expected < 0.0)] += 1;
        }
    }
    println!("{met:?}");
    assert!(met.iter().all(|&count| count >= 10), "{met:?}");
}

/// A straight-sided gear against an involute one, off its axis too: no closed form, but polygons find what the exact method finds.
#[test]
fn a_straight_flank_meets_an_involute() {
    for (eccentricity, distance) in [(0.0, 66.3), (0.08, 66.4), (0.08, 65.9)] {
        let gear = Gear::nominal(design(20, 3.0)).unwrap();
        let gear = gear.with_straight_flanks(0.045, 0.11).unwrap();
        let deviations = Deviations {
            eccentricity,
            high_tooth: 4.5,
            ..Deviations::default()
        };
        let wheel = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
        let mate = Gear::nominal(design(24, 3.0)).unwrap();
        let pinion = AsBuilt::perfect(mate, Face::Back);
        let cut = CutPair::for_certificates(&wheel, &pinion);
        for locked in [Member::Wheel, Member::Pinion] {
            let pair =
                GearPair::with_locked(wheel.clone(), pinion.clone(), distance, locked).unwrap();
            let (kernel, refined) = (ExactKernel::new(&pair), cut.refined_kernel(&pair));
            let certifier = Certifier::new(cut.kernel(&pair));
            for k in 0..25 {
                let mating = Mating {
                    fraction: 0.04 * f64::from(k),
                    ..Mating::at(1 + k % 20, 1, Side::Right)
                };
                let pose = Pose::new(&pair, mating);
                let exact = kernel.lost_motion(&pose).unwrap();
                let polygon = refined.lost_motion(&pose).unwrap();
                let off = exact.angle().unwrap() - polygon.angle().unwrap();
                let bounds = exact.error().unwrap() + polygon.error().unwrap();
                assert!(off.abs() <= bounds && bounds < 1e-10, "{k}: {off} {bounds}");
                certifier.check(&pose, &exact).unwrap();
            }
        }
    }
}

//! Double-flank roll test.

use super::*;
use gearlash::analytic::InvolutePair;
use gearlash::contact::{ContactKind, CutPair, PoseClass};
use gearlash::gauge::RollPose;
use gearlash::pair::{GearPair, Member, Pose};

fn eccentric(eccentricity: f64) -> AsBuilt {
    let deviations = Deviations {
        eccentricity,
        high_tooth: 1.0,
        ..Deviations::default()
    };
    let gear = Gear::nominal(design(44, 3.0, 20.0, 0.0)).unwrap();
    AsBuilt::new(gear, Face::Front, &deviations).unwrap()
}

/// A perfect gear rolls at the distance of model 2 with zero play (closed form), and does not move.
#[test]
fn a_perfect_gear_does_not_move() {
    for (teeth, shift, thinner) in [
        (44, 0.0, 0.0),
        (21, 0.0, 0.02),
        (12, 0.4, 0.01),
        (86, -0.2, 0.03),
    ] {
        let design = design(teeth, 3.0, 20.0, shift);
        let gear = Gear::new(design, design.nominal_base_thickness() - thinner).unwrap();
        let part = AsBuilt::perfect(gear.clone(), Face::Front);
        let roll = measure(&part, Settings::default()).roll.unwrap();
        assert_eq!(roll.poses.len(), 16 * teeth as usize);
        let expected = InvolutePair::new(&gear, &roll.master)
            .center_distance(0.0)
            .unwrap();
        for pose in &roll.poses {
            assert_eq!(
                pose.class,
                PoseClass::Contact(ContactKind::Involute),
                "z {teeth}"
            );
            assert!(
                (pose.distance - expected).abs() <= pose.error,
                "z {teeth}: {} {expected}",
                pose.distance
            );
            assert!(pose.error < 2e-10);
        }
        for range in [roll.total(), roll.tooth_to_tooth()] {
            assert!(
                range.found + range.missed <= 4.0 * roll.reading_error(),
                "{range:?}"
            );
        }
    }
}

/// F_i'' ≈ 2 e of a pure eccentricity. Tight mesh keeps the distance of both centres at a_0, so
/// a'' = e cos χ + √(a_0² − e² sin² χ) about the axis: 2 e exactly between χ = 0 and π, and in between
/// −e² sin² χ/(2 a_0) below the cosine.
#[test]
fn an_eccentric_gear_moves_by_twice_its_eccentricity() {
    for e in [0.005, 0.02, 0.08] {
        let part = eccentric(e);
        let roll = measure(&part, Settings::default()).roll.unwrap();
        let a_0 = InvolutePair::new(part.gear(), &roll.master)
            .center_distance(0.0)
            .unwrap();
        for pose in roll.poses.iter().chain(&roll.between) {
            let chi = pose.rotation;
            let expected = e * chi.cos() + (a_0 * a_0 - (e * chi.sin()).powi(2)).sqrt();
            assert!(
                (pose.distance - expected).abs() < 1e-9,
                "{e} {chi}: {} {expected}",
                pose.distance
            );
        }
        assert!(
            (roll.total().found - 2.0 * e).abs()
                <= roll.total().missed + 2.0 * roll.reading_error(),
            "{e}: {:?}",
            roll.total()
        );
        // e cos χ is steepest at χ = π/2: e (cos(π/2 − τ/2) − cos(π/2 + τ/2)) within τ = 2π/z; the second order,
        // −e² sin² χ/(2 a_0), is the same at both ends of that window.
        let within = 2.0 * e * (std::f64::consts::PI / 44.0).sin();
        let found = roll.tooth_to_tooth();
        let slack = 2.0 * roll.reading_error() + e * e / (2.0 * a_0) * 0.01;
        assert!(
            found.found <= within + slack && within <= found.found + found.missed + slack,
            "{e}: {found:?} {within}"
        );
    }
}

/// The extremes lie between even poses: sixteen a pitch found 12.694 µm where there are 12.740. Many more even poses
/// find nothing beyond the bracket.
#[test]
fn extremes_between_poses_are_bracketed() {
    for (teeth, shift, e) in [(9, 0.4, 0.0), (9, 0.4, 0.006), (23, 0.0, 0.01)] {
        let wave = |seed| scaled(&made_up(teeth, seed), 6e-3);
        let deviations = Deviations {
            per_tooth: wave(1),
            pitch: Some(Pitch::from_cumulative(&wave(2), &wave(3))),
            eccentricity: e,
            high_tooth: 2.3,
            ..Deviations::default()
        };
        let gear = Gear::nominal(design(teeth, 2.0, 20.0, shift)).unwrap();
        let part = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
        let roll = |steps_per_pitch| {
            let settings = Settings {
                steps_per_pitch,
                ..Settings::default()
            };
            measure(&part, settings).roll.unwrap()
        };
        let (few, many) = (roll(16), roll(16 * 5));
        let error = 2.0 * few.reading_error();
        // Over the even poses alone, which share nothing with the search.
        let ends = |poses: &[RollPose]| {
            poses
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], pose| {
                    [least.min(pose.distance), most.max(pose.distance)]
                })
        };
        let [least, most] = ends(&many.poses);
        let total = few.total();
        assert!(
            most - least <= total.found + total.missed + error,
            "z {teeth}: {total:?}"
        );
        assert!(total.missed <= 1e-6, "z {teeth}: {total:?}");
        let count = many.poses.len();
        let within = (0..count)
            .map(|first| {
                let window: Vec<RollPose> = (first..=first + 16 * 5)
                    .map(|i| many.poses[i % count])
                    .collect();
                let [least, most] = ends(&window);
                most - least
            })
            .fold(0.0, f64::max);
        let single = few.tooth_to_tooth();
        assert!(
            within <= single.found + single.missed + error,
            "z {teeth}: {within} {single:?}"
        );
        assert!(
            within >= single.found - 1e-4,
            "z {teeth}: {within} {single:?}"
        );
        assert!(single.missed <= 2e-5, "z {teeth}: {single:?}");
        // The even sixteen alone fall short by more than is allowed now, which is what is tested.
        let [least, most] = ends(&few.poses);
        assert!(total.found > most - least + 1e-6 || e == 0.0);
    }
}

/// Every pose by the polygon method, a pair put together for each: below `a''` the teeth overlap, above it there is play.
/// It shares nothing with the exact kernel, nor with what that keeps from one distance to the next.
#[test]
fn polygons_close_at_every_distance_of_a_deviated_eccentric_gear() {
    const BESIDE: f64 = 1e-7;
    let wave = |seed| scaled(&made_up(23, seed), 8e-3);
    let deviations = Deviations {
        pitch: Some(Pitch::from_cumulative(&wave(4), &wave(5))),
        eccentricity: 0.02,
        high_tooth: 3.4,
        ..Deviations::default()
    };
    let gear = Gear::nominal(design(23, 2.0, 20.0, 0.0)).unwrap();
    let part = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
    let settings = Settings {
        steps_per_pitch: 3,
        ..Settings::default()
    };
    let roll = measure(&part, settings).roll.unwrap();
    let master = AsBuilt::perfect(roll.master.clone(), Face::Back);
    let cut = CutPair::new(&part, &master, 1e-3);
    let pitch = part.gear().basic_data().angular_pitch();
    assert!(roll.poses.len() == 69 && !roll.between.is_empty());
    for pose in roll.poses.iter().chain(&roll.between) {
        let play = |distance: f64| {
            let pair = GearPair::with_locked(part.clone(), master.clone(), distance, Member::Wheel);
            let pair = pair.unwrap();
            // The mating at this distance that turns the gear as the pose has it.
            let turned = pose.rotation - Pose::new(&pair, pose.mating).locked_rotation();
            let turned = turned - std::f64::consts::TAU * (turned / std::f64::consts::TAU).round();
            let onward = -part.face().ascending() * turned / pitch;
            let there = Pose::new(&pair, pose.mating.onward(&pair, onward));
            let found = cut.refined_kernel(&pair).lost_motion(&there).unwrap();
            found.angle().unwrap() * pair.gear(Member::Pinion).gear().base_radius()
        };
        let plays = [-BESIDE, BESIDE].map(|by| play(pose.distance + by));
        assert!(plays[0] < 0.0 && plays[1] > 0.0, "{pose:?}: {plays:?}");
    }
}

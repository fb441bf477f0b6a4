//! Limits of distance and clearance beside their formulas.

use super::*;
use gearlash::analysis::diagnosis::{map, pitch_count};
use std::sync::atomic::{AtomicUsize, Ordering};

/// K (17) is exact for perfect gears.
#[test]
fn zero_backlash_distance_of_perfect_gears_is_k_17() {
    let mut assemblies: Vec<GearPair> = ["clear_1", "clear_2", "clear_3"]
        .iter()
        .map(|name| reference_pair(name).assembly)
        .collect();
    assemblies.push(eccentric(132.3, [(0.0, 1.0), (0.0, 1.0)], 44));
    for assembly in assemblies {
        let plan = SweepPlan::Revolution {
            pitches: 5,
            steps_per_pitch: 16,
            start: (1, 1),
        };
        let found = zero_distance(&assembly, &plan.matings(&assembly)).unwrap();
        let found = found.unwrap();
        let expected = limits::zero_backlash_distance(&assembly).unwrap();
        let off = (found.distance - expected).abs();
        assert!(off <= 1e-9, "{off:e} at {expected}");
        assert!(found.bracket[0] <= found.bracket[1]);
    }
}

/// The rig pair at most material. At the distance found, model 3 has no backlash at the pose found. The worst pose of
/// the sweep is also the worst of model 3, and no rotation of the phase has less.
#[test]
fn zero_backlash_distance_of_the_rig_agrees_with_model_3() {
    let study = input::read(&fixture("karba_44x44.toml")).unwrap().study;
    let found = diagnosed(&study);
    let group = &found.groups[0];
    assert_eq!(group.material.name(), "most");
    let zero = group.zero.clone().unwrap().unwrap();
    let model_3 = |distance: f64, mating: Mating| {
        let assembly = group.assembly.at(distance).unwrap();
        let pose = Pose::new(&assembly, mating);
        LineOfAction::new(&assembly, &pose)
            .backlash(&assembly)
            .unwrap()
    };
    println!("{zero:?}");
    let at = model_3(zero.distance, zero.mating);
    assert!(at.abs() <= 1e-6, "{at:e}");
    for step in 0..44 * 40 {
        let turned = zero.mating.onward(&group.assembly, f64::from(step) / 40.0);
        let play = model_3(zero.distance, turned);
        assert!(play >= -1e-6, "{play:e} at {turned:?}");
    }
    let runs = study.runs().unwrap();
    let most = runs.iter().filter(|run| run.material == group.material);
    let plays = most
        .flat_map(|run| run.matings.iter().copied())
        .map(|mating| model_3(zero.of_poses, mating));
    let least = plays.fold(f64::INFINITY, f64::min);
    assert!(least.abs() <= 1e-6, "{least:e}");
    assert!(zero.of_poses <= zero.distance + 1e-9);
    assert!(zero.teeth.iter().all(|teeth| teeth.0 > 0 && teeth.1 > 0));
}

/// Wheel tooth 5 and the pinion's space 9|10 both on the line of centres, both gears displaced towards it.
#[test]
fn radial_clearance_of_eccentric_gears_where_the_phases_allow_it() {
    for (pinion, distance) in [(44, 132.4), (31, 113.0)] {
        let assembly = eccentric(distance, [(0.04, 5.0), (0.03, 9.5)], pinion);
        // Tooth 5 reaches the line of centres three quarters of a pitch beyond mating 4,9: half a tooth short of 5,10.
        let found = radial_clearance(&assembly, Member::Wheel, &[mating(4, 9)]).unwrap();
        let expected = assembly.radial_clearance(Member::Wheel) - 0.04 - 0.03;
        let off = (found.distance - expected).abs();
        assert!(off <= 1e-6, "{off:e}: {found:?}");
        assert_eq!((found.tip_tooth, found.root_tooth), (5, 9));
        // Phases that do not allow it leave more, but never less than with the high teeth apart.
        let other = radial_clearance(&assembly, Member::Wheel, &[mating(1, 20)]).unwrap();
        if pinion == 44 {
            assert!(other.distance > expected + 1e-3, "{other:?}");
        }
        assert!(other.distance >= expected - 1e-9);
    }
    // And the pinion's tooth in the wheel's space.
    let assembly = eccentric(132.4, [(0.04, 5.5), (0.03, 9.0)], 44);
    let found = radial_clearance(&assembly, Member::Pinion, &[mating(5, 9)]).unwrap();
    let expected = assembly.radial_clearance(Member::Pinion) - 0.07;
    assert!((found.distance - expected).abs() <= 1e-6, "{found:?}");
    // With tips in the roots as well: 130 − 69 − 62.25 mm, less both displacements.
    let jammed = eccentric(130.0, [(0.04, 5.0), (0.03, 9.5)], 44);
    let found = radial_clearance(&jammed, Member::Wheel, &[mating(4, 9)]).unwrap();
    assert!((found.distance - (-1.25 - 0.07)).abs() <= 1e-6, "{found:?}");
    let jammed = eccentric(130.0, [(0.0, 1.0), (0.0, 1.0)], 44);
    let found = radial_clearance(&jammed, Member::Pinion, &[mating(1, 1)]).unwrap();
    assert!((found.distance - -1.25).abs() <= 1e-12, "{found:?}");
    // Perfect gears: the formula.
    let perfect = eccentric(132.4, [(0.0, 1.0), (0.0, 1.0)], 44);
    let found = radial_clearance(&perfect, Member::Wheel, &[mating(1, 1)]).unwrap();
    assert!((found.distance - perfect.radial_clearance(Member::Wheel)).abs() <= 1e-12);
}

/// The announced number of ticks equals the actual one.
#[test]
fn each_pitch_of_the_clearance_ticks_once() {
    let study = input::read(&fixture("karba_44x44.toml")).unwrap().study;
    let exact = Method::Exact { certify: true };
    let runs = simulate(&study, exact, &|| ControlFlow::Continue(())).unwrap();
    let runs = compare(runs, study.tolerance_um);
    let ticks = AtomicUsize::new(0);
    diagnose(&study, &runs, &Default::default(), &mut |_| Ok(()), &|| {
        ticks.fetch_add(1, Ordering::Relaxed);
        ControlFlow::Continue(())
    })
    .unwrap();
    let expected = pitch_count(&study.runs().unwrap());
    assert_eq!(ticks.into_inner(), expected);
    assert!(expected > 1);
}

/// `ε_α = (√(r_a1² − r_b1²) + √(r_a2² − r_b2²) − a sin α_wt)/(π m cos α)` of 31/17 teeth: fails from where it is below 1 on.
#[test]
fn a_contact_ratio_below_one_fails() {
    let gear = |teeth, face| AsBuilt::perfect(Gear::nominal(design(teeth, 2.0)).unwrap(), face);
    let cos = 20f64.to_radians().cos();
    let mut verdicts = [0, 0];
    for step in 0..8 {
        let distance = 48.4 + 0.3 * f64::from(step);
        let pair = GearPair::new(gear(31, Face::Front), gear(17, Face::Back), distance).unwrap();
        let found = diagnosed(&Study::of_pair("contact ratio", &pair, 1));
        let found = check(&found, "contact_ratio", None);
        let path = |teeth: f64| ((teeth + 2.0).powi(2) - (teeth * cos).powi(2)).sqrt();
        let sin = (1.0 - (48.0 * cos / distance).powi(2)).sqrt();
        let ratio = (path(31.0) + path(17.0) - distance * sin) / (2.0 * std::f64::consts::PI * cos);
        assert!(
            (found.formula.unwrap() - ratio).abs() < 1e-9,
            "{ratio} at {distance}"
        );
        assert!(
            (found.margin.unwrap() - (ratio - 1.0)).abs() < 1e-9,
            "{ratio} at {distance}"
        );
        let fails = ratio < 1.0;
        assert_eq!(
            found.verdict == Verdict::Fail,
            fails,
            "{ratio} at {distance}"
        );
        verdicts[usize::from(fails)] += 1;
    }
    assert!(verdicts[0] > 0 && verdicts[1] > 0, "{verdicts:?}");
}

/// Rows of a map are evenly spaced about the limits that they are drawn for; a cell has the backlash of a pair that stands there.
#[test]
fn rows_of_a_map_are_even() {
    let pair = eccentric(132.3, [(0.01, 1.0), (0.02, 3.0)], 44);
    let found = diagnosed(&Study::of_pair("map", &pair, 1));
    let map = map(
        &found.groups[0],
        mating(1, 1),
        &|| ControlFlow::Continue(()),
    )
    .unwrap();
    let rows = map.distances.len();
    let step = (map.distances[rows - 1] - map.distances[0]) / (rows - 1) as f64;
    for (row, distance) in map.distances.iter().enumerate() {
        let even = map.distances[0] + step * row as f64;
        assert!(
            step > 0.0 && (distance - even).abs() < 1e-9,
            "row {row}: {distance}, {even}"
        );
    }
    for row in [0, rows / 2, rows - 1] {
        let there = pair.at(map.distances[row]).unwrap();
        let columns = map.fractions.len();
        let column = columns / 3;
        let pose = Pose::new(&there, mating(1, 1).onward(&there, map.fractions[column]));
        let angle = ExactKernel::new(&there).lost_motion(&pose).unwrap().angle();
        let expected = angle.map(|angle| angle * there.operating_pitch_radius(there.free()));
        let cell = map.cells[row * columns + column].backlash;
        assert_eq!(cell.is_some(), expected.is_some());
        if let (Some(cell), Some(expected)) = (cell, expected) {
            assert!(
                (cell - expected).abs() < 1e-9,
                "row {row}: {cell}, {expected}"
            );
        }
    }
}

//! Limits of distance and clearance beside their formulas.

use super::*;

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

/// The rig pair at most material. At the distance found, model 3 has no backlash at the pose found, the
/// worst of the sweep's poses is the one model 3 has for worst, and no rotation of the phase has less.
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
        let expected = limits::radial_clearance(&assembly, Member::Wheel) - 0.04 - 0.03;
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
    let expected = limits::radial_clearance(&assembly, Member::Pinion) - 0.07;
    assert!((found.distance - expected).abs() <= 1e-6, "{found:?}");
    // Where the tips stand in the roots, too: 130 − 69 − 62.25 mm, less both displacements.
    let jammed = eccentric(130.0, [(0.04, 5.0), (0.03, 9.5)], 44);
    let found = radial_clearance(&jammed, Member::Wheel, &[mating(4, 9)]).unwrap();
    assert!((found.distance - (-1.25 - 0.07)).abs() <= 1e-6, "{found:?}");
    let jammed = eccentric(130.0, [(0.0, 1.0), (0.0, 1.0)], 44);
    let found = radial_clearance(&jammed, Member::Pinion, &[mating(1, 1)]).unwrap();
    assert!((found.distance - -1.25).abs() <= 1e-12, "{found:?}");
    // Perfect gears: the formula.
    let perfect = eccentric(132.4, [(0.0, 1.0), (0.0, 1.0)], 44);
    let found = radial_clearance(&perfect, Member::Wheel, &[mating(1, 1)]).unwrap();
    assert!((found.distance - limits::radial_clearance(&perfect, Member::Wheel)).abs() <= 1e-12);
}

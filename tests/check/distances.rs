//! Limits of distance and clearance beside their formulas, the map that shows them, and which checks fail.

use super::*;
use gearlash::analysis::diagnosis::{MAP_ROWS, pitch_count};
use gearlash::error::go_on;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU64, Ordering};

const NO_RUNOUT: [(f64, f64); 2] = [(0.0, 1.0); 2];

/// K (17) is exact for perfect gears.
#[test]
fn zero_backlash_distance_of_perfect_gears_is_k_17() {
    let reference = ["clear_1", "clear_2", "clear_3"].map(|name| reference_pair(name).assembly);
    let rig = eccentric(132.3, NO_RUNOUT, 44);
    for assembly in reference.into_iter().chain([rig]) {
        let plan = SweepPlan::Revolution {
            pitches: 5,
            steps_per_pitch: 16,
            start: (1, 1),
        };
        let found = zero_distance(&assembly, &plan.matings(&assembly), &go_on);
        let found = found.unwrap().unwrap();
        let expected = limits::zero_backlash_distance(&assembly).unwrap();
        near("distance", found.distance, expected, 1e-9);
        assert!(found.bracket[0] <= found.bracket[1]);
    }
}

/// The announced number of ticks equals the actual one.
#[test]
fn each_pitch_of_the_clearance_ticks_once() {
    let study = study("fixtures/karba_44x44.toml");
    let ticks = AtomicU64::new(0);
    let runs = compared(&study);
    diagnose(
        &study,
        &runs,
        &Default::default(),
        &mut |_| Ok(()),
        &|steps| {
            ticks.fetch_add(steps, Ordering::Relaxed);
            go_on(steps)
        },
    )
    .unwrap();
    let expected = pitch_count(&study.runs().unwrap());
    assert_eq!(ticks.into_inner(), expected as u64);
    assert!(expected > 1);
}

/// `ε_α = (√(r_a1² − r_b1²) + √(r_a2² − r_b2²) − a sin α_wt)/(π m cos α)` of 31/17 teeth: fails from where it is below 1 on.
#[test]
fn a_contact_ratio_below_one_fails() {
    let cos = 20f64.to_radians().cos();
    let mut verdicts = BTreeSet::new();
    for step in 0..8 {
        let distance = 48.4 + 0.3 * f64::from(step);
        let pair = pair(&spur(31, 2.0), &spur(17, 2.0), distance);
        let found = diagnosed(&Study::of_pair("contact ratio", &pair, 1));
        let found = check(&found, "contact_ratio", None);
        let path = |teeth: f64| ((teeth + 2.0).powi(2) - (teeth * cos).powi(2)).sqrt();
        let sin = (1.0 - (48.0 * cos / distance).powi(2)).sqrt();
        let ratio = (path(31.0) + path(17.0) - distance * sin) / (2.0 * PI * cos);
        near(distance, found.formula.unwrap(), ratio, 1e-9);
        near(distance, found.margin.unwrap(), ratio - 1.0, 1e-9);
        let fails = found.verdict == CheckVerdict::Fail;
        assert_eq!(fails, ratio < 1.0, "{ratio} at {distance}");
        verdicts.insert(fails);
    }
    assert_eq!(verdicts.len(), 2);
}

/// How far along the line of action the mate's tip comes from the base circle of `gear`, mm, at a centre distance.
fn tip_from_base(pair: &GearPair, gear: Member, distance: f64) -> f64 {
    let [own, mate] = [gear, gear.mate()].map(|member| pair.gear(member).gear());
    let sum = own.base_radius() + mate.base_radius();
    let line = (distance * distance - sum * sum).sqrt();
    line - (mate.tip_radius().powi(2) - mate.base_radius().powi(2)).sqrt()
}

/// At the limits a tip is on the form or base circle of one gear and outside that of the other, or it has the named clearance from roots.
/// Rows are even and cover all limits plus a 20th of a module, without tips in roots. A cell has the backlash of a pair that stands there.
#[test]
fn limits_of_a_map_have_their_meaning() {
    for (distance, high, pinion) in [
        (132.3, [(0.01, 1.0), (0.02, 3.0)], 44),
        (112.9, [(0.0, 1.0), (0.02, 3.0)], 31),
    ] {
        let pair = eccentric(distance, high, pinion);
        let found = diagnosed(&Study::of_pair("map", &pair, 1));
        let map = map(&found.groups[0], mating(1, 1), &go_on).unwrap();
        let at = |name: &str| {
            let all = map.limits.iter().filter(|limit| limit.name == name);
            let all: Vec<f64> = all.map(|limit| limit.distance).collect();
            assert_eq!(all.len(), 1, "{name}");
            all[0]
        };
        assert_eq!(at("a of the pair"), distance);
        let zero = found.groups[0].zero.clone().unwrap().unwrap();
        assert_eq!(at("zero backlash, outlines"), zero.distance);
        let least = |of: &dyn Fn(Member) -> f64| ends(Member::BOTH.map(of))[0];
        let form = at("tip at form circle");
        let from_form = |member: Member| {
            let gear = pair.gear(member).gear();
            let own = (gear.form_radius().powi(2) - gear.base_radius().powi(2)).sqrt();
            tip_from_base(&pair, member, form) - own
        };
        near("form circle", least(&from_form), 0.0, 1e-9);
        let base = at("tip at base circle, K (8)");
        let from_base = |member| tip_from_base(&pair, member, base);
        near("base circle", least(&from_base), 0.0, 1e-9);
        let clearance = |distance: f64| {
            let of = |member: Member| {
                let (tip, root) = (pair.gear(member).gear(), pair.gear(member.mate()).gear());
                distance - tip.tip_radius() - root.root_radius()
            };
            least(&of)
        };
        for modules in [limits::LEAST_CLEARANCE, limits::RECOMMENDED_CLEARANCE] {
            let at = at(&format!("radial clearance {modules} m"));
            near(modules, clearance(at), 3.0 * modules, 1e-9);
        }
        let distances: Vec<f64> = map.limits.iter().map(|limit| limit.distance).collect();
        assert!(distances.is_sorted(), "{distances:?}");
        let bases = Member::BOTH.map(|member| pair.gear(member).gear().base_radius());
        assert!(distances[0] > bases[0] + bases[1]);
        // Rows are the middles of as many stretches.
        let rows = MAP_ROWS as usize;
        assert_eq!(map.distances.len(), rows);
        let low = distances[0].max(distance - clearance(distance)) - 0.15;
        let step = (distances[distances.len() - 1] + 0.15 - low) / rows as f64;
        for (row, distance) in map.distances.iter().enumerate() {
            near(row, *distance, low + (row as f64 + 0.5) * step, 1e-9);
        }
        let columns = map.fractions.len();
        assert_eq!(columns, 60);
        for (k, fraction) in map.fractions.iter().enumerate() {
            near(k, *fraction, k as f64 / 60.0, 1e-15);
        }
        for row in [0, rows / 2, rows - 1] {
            let there = pair.at(map.distances[row]).unwrap();
            let pose = Pose::new(&there, mating(1, 1).onward(&there, map.fractions[20]));
            let angle = ExactKernel::new(&there).lost_motion(&pose).unwrap().angle();
            let expected = angle.map(|angle| angle * there.operating_pitch_radius(there.free()));
            let cell = map.cells[row * columns + 20].backlash;
            assert_eq!(cell.is_some(), expected.is_some(), "row {row}");
            near(row, cell.unwrap_or(0.0), expected.unwrap_or(0.0), 1e-9);
        }
    }
}

/// A tooth thinner by `t` at the reference circle is thinner by `t r_a/r` at its tip: flanks turn about the centre. It is the one named.
#[test]
fn the_tip_of_a_thin_tooth_is_thin_by_as_much_of_an_angle() {
    let mut thinner = vec![0.0; 30];
    (thinner[2], thinner[7]) = (-0.06, -0.03);
    let wheel = spur(30, 2.0).per_tooth(thinner);
    let mean = limits::tip_thickness(&wheel.gear());
    let pair = pair(&wheel, &spur(30, 2.0), 60.2);
    let found = diagnosed(&Study::of_pair("thin", &pair, 4));
    let tip = check(&found, "tip_thickness", Some(Member::Wheel));
    let expected = mean - 0.06 * 32.0 / 30.0;
    near("tip", tip.outlines.unwrap(), expected, 1e-12);
    near("margin", tip.margin.unwrap(), expected - 0.4, 1e-12);
    assert_eq!(tip.note, "tooth 3");
    let tip = check(&found, "tip_thickness", Some(Member::Pinion));
    assert_eq!(tip.outlines, tip.formula);
    assert_eq!(tip.note, "");
}

/// Tips whose radial clearance is below 0.15 of a module fail, be it that the root is not deep enough or that eccentricities take
/// what a formula leaves: `h_f − h_a` modules of perfect gears at the sum of their reference radii, less both eccentricities.
#[test]
fn too_little_radial_clearance_fails_by_depth_and_by_eccentricity() {
    for (dedendum, eccentricity, fails) in [
        (1.05, 0.0, true),
        (1.14, 0.0, true),
        (1.16, 0.0, false),
        (1.25, 0.07, false),
        (1.25, 0.13, true),
    ] {
        let gear = spur(40, 2.0)
            .rack(1.0, dedendum, 0.1)
            .runout(eccentricity, 1.0);
        let (failed, _) = failing(&Study::of_pair("near", &pair(&gear, &gear, 80.0), 4));
        assert_eq!(failed.contains(&"radial_clearance"), fails, "{failed:?}");
    }
}

/// Which checks fail, found without what is sought only to be reported: the same as every check made. The fixtures; then few teeth and many, close and
/// far apart, undercut, with little clearance of the tips, so that most checks fail somewhere.
#[test]
fn checks_fail_whether_or_not_all_are_made() {
    let fixtures = "karba_44x44 karba_44x44_pitch karba_86x21 hunting_51x23 tip_on_fillet_86x21 profiled_44x44";
    let fixtures = fixtures.split(' ');
    let fixtures = fixtures.map(|name| (name.to_owned(), study(format!("fixtures/{name}.toml"))));
    let drawn = (0..60).map(|index| {
        let mut random = Random::of(14, index);
        let mut gear = || {
            let teeth = random.within(9.0, 50.0) as u32;
            let (dedendum, round) = random.pick(&[(1.25, 0.38), (1.25, 0.2), (1.13, 0.2)]);
            let gear = spur(teeth, 2.0).rack(1.0, dedendum, round);
            let gear = gear.shift(random.within(-0.1, 0.4));
            let gear = gear.allowance(random.within(-0.1, 0.0));
            let gear = gear.runout(random.pick(&[0.0, 0.01, 0.03]), 2.0);
            gear.open(random.chance(0.3))
        };
        let (wheel, pinion) = (gear(), gear());
        let zero = InvolutePair::new(&wheel.gear(), &pinion.gear());
        let distance = zero.center_distance(0.0).unwrap() + random.within(-0.1, 0.4);
        let distance = distance + random.pick(&[0.0, 0.0, 1.5]);
        let pair = pair(&wheel, &pinion, distance);
        (format!("drawn {index}"), Study::of_pair("random", &pair, 4))
    });
    let mut ever = BTreeSet::new();
    for (name, study) in fixtures.chain(drawn) {
        let (needed, analysis) = failing(&study);
        let all = analysis.diagnosis.failed();
        let all: Vec<&str> = all.iter().map(|check| check.id).collect();
        assert_eq!(all, needed, "{name}");
        if name.starts_with("drawn") {
            ever.extend(all);
        }
    }
    // Without these the test would say little.
    let ids = "radial_clearance zero_backlash_distance contact_ratio non_involute_onset";
    assert!(ids.split(' ').all(|id| ever.contains(id)), "{ever:?}");
}

//! The play of the bearings: extremes with the axes pressed together and pulled apart, against the handbook's formula and against pairs
//! that stand there.

use super::*;
use gearlash::analysis::extremes::BearingPlay;
use gearlash::analysis::requirement::{Limits, Quantity};
use gearlash::analysis::verdict::{Requirement, Verdict as CycleVerdict};
use gearlash::contact::Status;
use gearlash::gear::{Pitch, thickness};

/// 31/17 teeth, m 2, 20°: 50 µm thin, with `share` of 20 µm of pitch deviation and of eccentricity.
fn pair(distance: f64, share: f64, any_direction: bool) -> GearPair {
    let gear = |teeth: u32, face| {
        let data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
        let design = GearDesign::standard(data);
        let base = thickness::base_from_allowance(
            &design.basic_data,
            design.nominal_base_thickness(),
            -0.05,
        );
        let mut random = Random::of(31, u64::from(teeth));
        let mut list = || -> Vec<f64> {
            let each = (0..teeth).map(|_| 0.02 * share * random.within(-1.0, 1.0));
            each.collect()
        };
        let (right, left) = (list(), list());
        let deviations = Deviations {
            pitch: (share > 0.0).then(|| Pitch::from_cumulative(&right, &left)),
            eccentricity: 0.02 * share,
            high_tooth: 3.0,
            any_direction,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
    };
    GearPair::new(gear(31, Face::Front), gear(17, Face::Back), distance).unwrap()
}

fn study(pair: &GearPair, clearance: f64) -> Study {
    Study {
        bearing_clearance: clearance,
        ..Study::of_pair("bearings", pair, 1)
    }
}

fn run_of(study: &Study) -> RunExtremes {
    let exact = Method::Exact { certify: true };
    let found = extremes(study, exact, &|| ControlFlow::Continue(())).unwrap();
    found.each.into_iter().next().unwrap()
}

fn play(pair: &GearPair, clearance: f64) -> BearingPlay {
    run_of(&study(pair, clearance)).bearings.unwrap()
}

/// `j_wt = (d_b1 + d_b2)(inv α_wt − inv α)/cos α_wt`, and what both gears are thin at their reference circles, as an arc at α_wt.
fn j_wt(distance: f64) -> f64 {
    let involute = |angle: f64| angle.tan() - angle;
    let alpha = 20f64.to_radians();
    // The reference circles' radii sum up to 48 mm.
    let angle = (48.0 * alpha.cos() / distance).acos();
    let per_reference = distance / 48.0;
    2.0 * distance * (involute(angle) - involute(alpha)) + 0.1 * per_reference
}

#[test]
fn perfect_gears_have_the_formulas_backlash_at_both_ends() {
    for clearance in [0.002, 0.01, 0.06] {
        let found = play(&pair(48.05, 0.0, false), clearance);
        assert_eq!(found.clearance, clearance);
        for (end, distance) in [
            (&found.pressed, 48.05 - clearance),
            (&found.apart, 48.05 + clearance),
        ] {
            assert!((end.assembly.center_distance() - distance).abs() < 1e-12);
            assert_eq!(end.status, Status::Clear);
            let extreme = end.extreme.as_ref().unwrap();
            assert!(extreme.is_proven());
            let expected = j_wt(distance);
            assert!(
                extreme.low <= expected + 1e-9 && expected - 1e-9 <= extreme.high,
                "{} … {}, not {expected}",
                extreme.low,
                extreme.high
            );
        }
    }
}

/// The same brackets as of pairs that are assembled there, and no pose of any distance between is beyond them.
#[test]
fn deviating_gears_have_the_extremes_of_pairs_that_stand_there() {
    for any_direction in [false, true] {
        let pair = pair(48.05, 1.0, any_direction);
        let found = play(&pair, 0.03);
        let near = extremes_of(&pair.at(48.02).unwrap());
        let far = extremes_of(&pair.at(48.08).unwrap());
        for (end, there) in [(&found.pressed, near.least), (&found.apart, far.greatest)] {
            let (end, there) = (end.extreme.as_ref().unwrap(), there.unwrap());
            assert!(end.doubt == there.doubt);
            assert!((end.low - there.low).abs() < 1e-9 && (end.high - there.high).abs() < 1e-9);
        }
        let (least, most) = (
            found.pressed.extreme.unwrap().low,
            found.apart.extreme.unwrap().high,
        );
        for step in 0..=6 {
            let pair = pair.at(48.02 + 0.01 * f64::from(step)).unwrap();
            let kernel = ExactKernel::new(&pair);
            for pose in cycle::spread(&pair, 2_000) {
                let angle = kernel.lost_motion(&pose).unwrap().angle().unwrap();
                let j_wt = angle * pair.operating_pitch_radius(pair.free());
                assert!(least - 1e-9 <= j_wt && j_wt <= most + 1e-9, "{j_wt}");
            }
        }
    }
}

/// The pose that is named has what is said of it, simulated anew: pressed together the least, pulled apart the greatest.
#[test]
fn the_poses_of_both_ends_have_their_extremes() {
    for any_direction in [false, true] {
        let found = play(&pair(48.05, 1.0, any_direction), 0.03);
        for end in [&found.pressed, &found.apart] {
            let extreme = end.extreme.as_ref().unwrap();
            let pair = extreme.assembly.data().unwrap();
            let found = ExactKernel::new(pair).lost_motion(&extreme.pose.simulated.pose);
            let j_wt = found.unwrap().angle().unwrap() * pair.operating_pitch_radius(pair.free());
            assert!(
                extreme.low - 1e-9 <= j_wt && j_wt <= extreme.high + 1e-9,
                "{any_direction}: {} … {}, not {j_wt}",
                extreme.low,
                extreme.high
            );
        }
    }
}

#[test]
fn ends_without_a_value_say_why() {
    // Half a module nearer, tips are in roots; three modules further, nothing meets.
    let found = play(&pair(49.5, 0.0, false), 3.0);
    assert_eq!(found.pressed.status, Status::Jammed);
    assert_eq!(found.apart.status, Status::NoContact);
    assert!(found.pressed.extreme.is_none() && found.apart.extreme.is_none());
}

/// A limit is of the pair wherever its bearings let it stand.
#[test]
fn a_requirement_holds_for_the_axes_moved_too() {
    let pair = pair(48.05, 0.0, false);
    let limits = |min: Option<f64>, max: Option<f64>| {
        vec![(Quantity::OperatingBacklash, Limits { min, max })]
    };
    let (least, most) = (j_wt(48.03), j_wt(48.07));
    let exactly = j_wt(48.05);
    for (clearance, required, kept) in [
        (
            0.0,
            limits(Some(exactly - 1e-3), Some(exactly + 1e-3)),
            true,
        ),
        (0.02, limits(Some(exactly - 1e-3), None), false),
        (0.02, limits(None, Some(exactly + 1e-3)), false),
        (0.02, limits(Some(least - 1e-5), Some(most + 1e-5)), true),
    ] {
        let run = run_of(&study(&pair, clearance));
        let verdict = CycleVerdict::new(std::slice::from_ref(&run), &required, None, Vec::new());
        assert_eq!(
            verdict.requirement == Requirement::Met,
            kept,
            "{required:?}"
        );
        assert!(verdict.unmet.iter().all(|unmet| unmet.with_play));
        let ends = (verdict.least_pressed(), verdict.greatest_apart());
        assert_eq!(ends.0.is_some() && ends.1.is_some(), clearance > 0.0);
    }
}

//! The three analytic models and the limits of a pair against the study's tables, reference data, hand calculation, and each other.

use super::*;
use crate::common::{reference_names, reference_pair};
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::measured::measured_matings;
use gearlash::analysis::simulate::simulate;
use gearlash::analysis::study::Study;
use gearlash::error::go_on;

const UM: f64 = 1e-3;

fn run(study: &Study) -> Vec<ComparedRun> {
    simulate(study, Method::Exact { certify: true }, &go_on).unwrap()
}

/// All 72 predicted limits, model 2 and simulated, mean of both poses: within 0.07 µm of the printed value. "The study measured 72 values: 63 lie in
/// its band, 9 below it, none above"; with the bores' clearance all 72.
#[test]
fn tables_5_and_6() {
    let study = kit::study("fixtures/karba_44x44.toml");
    let runs = run(&study);
    let matings = measured_matings(&study, &runs);
    assert_eq!(matings.len(), 36);
    let mut counts = [0; 3];
    for mating in &matings {
        let (row, printed) = (&mating.row, mating.printed.unwrap());
        let what = (row.wheel_tooth, row.pinion_tooth, row.center_distance);
        for band in [mating.analytic.unwrap(), mating.simulated.unwrap()] {
            near(what, band.min_um, printed.min_um, 0.07);
            near(what, band.max_um, printed.max_um, 0.07);
        }
        for measured in [row.right_um, row.left_um] {
            counts[(1 + printed.side_of(measured)) as usize] += 1;
            assert_eq!(mating.with_clearance.unwrap().side_of(measured), 0);
        }
    }
    assert_eq!(counts, [9, 63, 0]);
}

/// Table 2 of the study, 86/21 by dimension over pins, unrounded.
#[test]
fn table_2_backlash_at_three_centre_distances() {
    let runs = run(&kit::study("fixtures/karba_86x21.toml"));
    assert_eq!(runs.len(), 3);
    for (run, printed) in runs.iter().zip([18.200_263, 40.026_463, 76.490_057]) {
        assert_eq!(run.poses.len(), 2);
        for pose in &run.poses {
            let simulated = pose.simulated.backlash.unwrap();
            near("simulated", simulated * 1e3, printed, 0.001);
            for formula in [pose.involute, pose.line_of_action] {
                near("formula", formula.unwrap() * 1e3, printed, 1e-6);
            }
        }
    }
}

/// Nominal 44/44 at 0.1 mm beyond 132 mm: B = 2 · 0.1 · tan 20° = 0.2 · 0.363970234266202 mm by hand.
/// Thinned by 30 and 20 µm, B_0 = 50 µm on the operating circle of 132 mm, the reference circle.
#[test]
fn model_1_by_hand() {
    for (allowances_um, first) in [([0.0, 0.0], 0.0), ([-30.0, -20.0], 0.050)] {
        let [wheel, pinion] = allowances_um.map(|um| spur(44, 3.0).allowance(um * UM));
        let assembly = pair(&wheel, &pinion, 132.1);
        let found = evaluate(&assembly, &Pose::new(&assembly, Mating::FIRST)).michalec;
        near(first, found.unwrap(), first + 0.072794046853240, 1e-13);
    }
}

#[test]
fn a_model_without_a_value_says_none() {
    let found = |pair: &GearPair| evaluate(pair, &Pose::new(pair, Mating::FIRST));
    // Base circles 0.001 mm apart, outlines 0.02 mm nearer each other.
    let eccentric = spur(44, 3.0).runout(0.010, 1.0);
    let least = 2.0 * eccentric.gear().base_radius();
    let assembly = pair(&eccentric, &eccentric, least + 0.001);
    let result = found(&assembly);
    assert!(result.involute.is_none());
    assert!(result.line_of_action.backlash(&assembly).is_none());
    assert!(result.michalec.is_some_and(f64::is_finite));
    // Out of mesh: no contact inside the tips, but the formulas go on.
    let result = found(&assembly.at(140.0).unwrap());
    let line = result.line_of_action;
    assert_eq!((line.right, line.left), (None, None));
    assert!(result.involute.is_some_and(f64::is_finite));
    // x_1 + x_2 = −1.8 < −(z_1 + z_2) inv α/(2 tan α) = −1.638: no play-free distance.
    let shifted = spur(40, 3.0).shift(-0.9);
    let result = found(&pair(&shifted, &shifted, 114.0));
    assert!(result.michalec.is_none());
    assert!(result.involute.is_some_and(f64::is_finite));
    // Base circles that touch leave no play-free distance to teeth this thin.
    let thin = spur(44, 3.0).thinner(2.0);
    let assembly = pair(&thin, &thin, 130.0);
    assert_eq!(limits::zero_backlash_distance(&assembly), None);
    assert_eq!(limits::radial_backlash(&assembly), None);
}

/// The contact that counts, and how much tighter it is than the next.
fn tightest(assembly: &GearPair, pose: &Pose, side: Side) -> (SideContact, f64) {
    let mut all: Vec<SideContact> = SideContact::all(assembly, pose, side).collect();
    let ahead = |one: &SideContact| side.sense() * one.rotation;
    all.sort_by(|one, other| ahead(one).total_cmp(&ahead(other)));
    let next = all.get(1).map_or(f64::INFINITY, ahead);
    (all[0], next - ahead(&all[0]))
}

/// fixtures/reference/lost_motion: equal wherever both sides touch involute on involute. Elsewhere the simulation may lie below model 3, never above.
#[test]
fn model_3_is_the_reference_on_the_line_of_action_and_never_below_it() {
    let (mut poses, mut named, mut below) = (0, 0, 0);
    for name in reference_names() {
        let pair = reference_pair(&name);
        let assembly = &pair.assembly;
        for reference in &pair.poses {
            let what = (&name, reference);
            let pose = Pose::new(assembly, reference.mating());
            let model = LineOfAction::new(assembly, &pose);
            let mut sides = Side::BOTH.iter();
            let on_line = sides.all(|side| reference.contact(*side).curves() == ["involute"; 2]);
            let Some(backlash) = model.backlash(assembly) else {
                assert!(!on_line, "{what:?}");
                continue;
            };
            let above = reference.j_wt_um - backlash / UM;
            assert!(above <= 1e-6, "{what:?}: {above}");
            below += usize::from(above < -1e-6);
            if !on_line {
                continue;
            }
            near(what, above, 0.0, 1e-6);
            let angle = model.angle().unwrap();
            near(what, angle, reference.lost_motion_rad, 1e-12);
            poses += 1;
            for (side, found) in [(Side::Right, model.right), (Side::Left, model.left)] {
                let (contact, ahead) = tightest(assembly, &pose, side);
                assert_eq!(found.unwrap().rotation, contact.rotation);
                if ahead <= 1e-9 {
                    continue;
                }
                let expected = reference.contact(side);
                let found = (contact.locked_tooth, contact.free_tooth);
                assert_eq!(found, expected.teeth(), "{what:?} {side:?}");
                // The reference searched: the place of an extremum is known to the root of its value only.
                // 1e-5 mm along flanks of some 10 mm curvature is 5e-12 mm across them.
                for (member, roll, radius) in [
                    (Member::Wheel, contact.locked_roll, expected.wheel_radius_mm),
                    (Member::Pinion, contact.free_roll, expected.pinion_radius_mm),
                ] {
                    let base = assembly.gear(member).gear().base_radius();
                    near(what, base * roll.hypot(1.0), radius, 1e-5);
                }
                named += 1;
            }
        }
    }
    assert_eq!((poses, named), (99, 162));
    assert!(below > 0);
}

fn nominal(wheel: u32, pinion: u32, distance: f64) -> GearPair {
    pair(&spur(wheel, 3.0), &spur(pinion, 3.0), distance)
}

/// By hand for 12/60 at 108 mm: (r_b1 + r_b2) tan 20° = 108 sin 20° = 36.9382 mm against the wheel's
/// √(93² − 84.5723²) = 38.6849 mm and the pinion's √(21² − 16.9145²) = 12.4459 mm.
#[test]
fn k_8_fails_for_a_pinion_of_twelve_teeth() {
    let assembly = nominal(60, 12, 108.0);
    let margin = |member| limits::non_involute_margin(&assembly, member);
    near("pinion", margin(Member::Pinion), -1.7467, 1e-4);
    near("wheel", margin(Member::Wheel), 24.4923, 1e-4);
    assert_eq!(limits::active_root_radius(&assembly, Member::Pinion), None);
}

/// The usable path by hand: between the tips, but no deeper than each form circle.
#[test]
fn form_circles_shorten_the_path_of_contact() {
    for (wheel, pinion, distance, shorter) in [
        (44, 44, 132.0, false),
        (86, 21, 160.2, true),
        (60, 12, 108.0, true),
    ] {
        let assembly = nominal(wheel, pinion, distance);
        let gear = |member| assembly.gear(member).gear();
        let along = |member: Member, roll: f64| gear(member).base_radius() * roll;
        let (w, p) = (Member::Wheel, Member::Pinion);
        // Along the line of action from the wheel's base circle.
        let length = limits::base_tangent(&assembly);
        let start = (length - along(p, gear(p).tip_roll())).max(along(w, gear(w).form_roll()));
        let end = along(w, gear(w).tip_roll()).min(length - along(p, gear(p).form_roll()));
        let expected = (end - start) / gear(w).basic_data().base_pitch();
        let usable = limits::usable_contact_ratio(&assembly);
        near((wheel, pinion), usable, expected, 1e-13);
        assert_eq!(usable < limits::contact_ratio(&assembly), shorter);
    }
}

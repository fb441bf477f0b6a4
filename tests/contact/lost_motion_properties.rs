//! Symmetries of the simulation, on random pairs: ordinary ones, and rough ones half out of mesh or jammed.

use crate::common;

use common::random_pair::{Case, case, rough_case};
use gearlash::analytic::evaluate;
use gearlash::contact::{CutPair, LostMotion, Status};
use gearlash::gear::ProfilePart;
use gearlash::pair::{GearPair, Member, Pose};
use proptest::prelude::*;

/// The outcome of a pose: status, and backlash with its bound, both mm of `j_wt` over the scale.
#[derive(Debug, PartialEq)]
struct Outcome {
    status: Status,
    backlash: Option<(f64, f64)>,
}

/// A random pair of sound gears, refined polygons from a coarse start; `None` for gears that cannot exist.
fn simulate(case: &Case, scale: f64) -> Option<(GearPair, Pose, LostMotion)> {
    let assembly = case.try_assemble(scale).ok()?;
    let pose = Pose::new(&assembly, case.mating);
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
    let cut = CutPair::new(wheel, pinion, 1e-3 * scale);
    let lost_motion = cut.refined_kernel(&assembly).lost_motion(&pose).unwrap();
    Some((assembly, pose, lost_motion))
}

fn outcome(case: &Case, scale: f64) -> Option<Outcome> {
    let (assembly, _, lost_motion) = simulate(case, scale)?;
    let um = assembly.operating_pitch_radius(assembly.free()) / scale;
    Some(Outcome {
        status: lost_motion.status(),
        backlash: lost_motion
            .angle()
            .zip(lost_motion.error())
            .map(|(phi, error)| (phi * um, error * um)),
    })
}

/// The same within both bounds. Right at a border (touching a root or not, in reach or not) rounding may
/// put the two on different sides: a status may differ only where the sides nearly agree, and never by a value.
fn same(one: &Option<Outcome>, other: &Option<Outcome>) -> Result<(), TestCaseError> {
    let (Some(one), Some(other)) = (one, other) else {
        prop_assert_eq!(one.is_some(), other.is_some());
        return Ok(());
    };
    prop_assert_eq!(one.backlash.is_some(), other.backlash.is_some());
    if let (Some((a, a_bound)), Some((b, b_bound))) = (one.backlash, other.backlash) {
        prop_assert!(
            (a - b).abs() <= a_bound + b_bound,
            "{a} {b}, bounds {a_bound} {b_bound}"
        );
    } else {
        prop_assert_eq!(one.status, other.status);
    }
    Ok(())
}

fn any_case() -> impl Strategy<Value = Case> {
    prop_oneof![case(), rough_case()]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Wheel and pinion exchanged, the locked gear with them: the picture turned by half a turn.
    #[test]
    fn swapping_the_gears_changes_nothing(case in any_case()) {
        same(&outcome(&case, 1.0), &outcome(&case.swapped(), 1.0))?;
    }

    #[test]
    fn ten_times_the_size_has_ten_times_the_backlash(case in any_case()) {
        same(&outcome(&case, 1.0), &outcome(&case, 10.0))?;
    }

    #[test]
    fn renumbering_the_teeth_changes_nothing(case in any_case(), by in (0u32..17, 0u32..17)) {
        let renumbered = case.renumbered(by.0, by.1);
        same(&outcome(&case, 1.0), &outcome(&renumbered, 1.0))?;
    }

    /// Seen from behind: faces and flanks swap, right and left contact change places.
    #[test]
    fn a_mirrored_pair_is_the_pair_seen_from_behind(case in any_case()) {
        same(&outcome(&case, 1.0), &outcome(&case.mirrored(), 1.0))?;
    }

    /// Design section 5: where the contact is involute on involute, model 3 is exact; elsewhere a real pair
    /// has less backlash than it says, never more.
    #[test]
    fn model_3_is_right_on_the_line_and_never_exceeded(case in any_case()) {
        if let Some((assembly, pose, lost_motion)) = simulate(&case, 1.0) {
            let um = assembly.operating_pitch_radius(assembly.free());
            let formula = evaluate(&assembly, &pose).line_of_action;
            if let (Some(phi), Some(error), Some(formula)) = (lost_motion.angle(), lost_motion.error(), formula.backlash(&assembly)) {
                // Model 3 rounds to some 1e-12 mm itself.
                let bound = error * um + 1e-11;
                prop_assert!(phi * um <= formula + bound, "{} above {formula}", phi * um);
                let on_line = [lost_motion.right, lost_motion.left].iter().flatten().all(|contact| {
                    contact.wheel.curve == ProfilePart::Involute && contact.pinion.curve == ProfilePart::Involute
                        // The ends of an involute belong to corners and joints.
                        && inside(&assembly, Member::Wheel, contact.wheel.radius)
                        && inside(&assembly, Member::Pinion, contact.pinion.radius)
                });
                if on_line {
                    prop_assert!((phi * um - formula).abs() <= bound, "{} {formula}", phi * um);
                }
            }
        }
    }
}

/// A micrometre inside the involute's ends.
fn inside(assembly: &GearPair, member: Member, radius: f64) -> bool {
    let gear = assembly.gear(member).gear();
    (gear.form_radius() + 1e-3..gear.tip_radius() - 1e-3).contains(&radius)
}

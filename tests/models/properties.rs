//! Identities and symmetries of the analytic models, on random pairs.

use crate::common;

use common::random_pair::{ROUNDING, case};
use gearlash::analytic::{InvolutePair, LineOfAction, effective_center_distance, evaluate, limits};
use gearlash::gear::involute;
use gearlash::pair::{Mating, Member, Pose};
use proptest::prelude::*;

/// Equal, or without a value both.
fn same(one: [Option<f64>; 3], other: [Option<f64>; 3]) -> Result<(), TestCaseError> {
    for (model, (one, other)) in one.into_iter().zip(other).enumerate() {
        match (one, other) {
            (Some(one), Some(other)) => prop_assert!(
                (one - other).abs() <= ROUNDING,
                "model {}: {one} {other}",
                model + 1
            ),
            (one, other) => prop_assert_eq!(one, other),
        }
    }
    Ok(())
}

proptest! {
    /// Gears without eccentricity and deviations: models 2 and 3 are one.
    #[test]
    fn models_2_and_3_agree_on_perfect_gears(case in case()) {
        let mut case = case;
        for recipe in [&mut case.wheel, &mut case.pinion] {
            recipe.runout_um = 0.0;
            recipe.per_tooth_um.fill([0.0; 3]);
        }
        let [_, involute, line] = case.backlash(1.0);
        prop_assert!((involute.unwrap() - line.unwrap()).abs() <= ROUNDING);
    }

    /// Wheel and pinion exchanged, the locked gear with them: the picture turned by half a turn.
    #[test]
    fn swapping_the_gears_changes_nothing(case in case()) {
        let swapped = case.swapped();
        same(case.backlash(1.0), swapped.backlash(1.0))?;
        prop_assert_eq!(case.evaluate(1.0).1.line_of_action, swapped.evaluate(1.0).1.line_of_action);
    }

    #[test]
    fn ten_times_the_size_has_ten_times_the_backlash(case in case()) {
        same(case.backlash(1.0), case.backlash(10.0))?;
    }

    #[test]
    fn renumbering_the_teeth_changes_nothing(case in case(), by in (0u32..17, 0u32..17)) {
        let renumbered = case.renumbered(by.0, by.1);
        same(case.backlash(1.0), renumbered.backlash(1.0))?;
    }

    /// Seen from behind: faces and flanks swap, right and left contact change places.
    #[test]
    fn a_mirrored_pair_is_the_pair_seen_from_behind(case in case()) {
        let mirrored = case.mirrored();
        same(case.backlash(1.0), mirrored.backlash(1.0))?;
        let (front, behind) = (case.evaluate(1.0).1, mirrored.evaluate(1.0).1);
        let (right, left) = (front.line_of_action.right.unwrap(), behind.line_of_action.left.unwrap());
        prop_assert!((right.rotation + left.rotation).abs() < 1e-13);
        prop_assert_eq!(right.locked_tooth, left.locked_tooth);
        prop_assert_eq!(right.free_tooth, left.free_tooth);
    }

    /// Turning the locked gear by whole pitches is the mating as many teeth on, however many turns.
    #[test]
    fn whole_pitches_are_the_next_teeth(case in case(), pitches in -1000i32..1000) {
        let locked = if case.locked == Member::Wheel { &case.wheel } else { &case.pinion };
        let free = if case.locked == Member::Wheel { &case.pinion } else { &case.wheel };
        // The free gear's numbers ascend with the locked gear's where the faces differ.
        let sense = if locked.face == free.face { -1 } else { 1 };
        let on = |tooth: u32, teeth: u32, by: i32| {
            (tooth as i32 - 1 + by).rem_euclid(teeth as i32) as u32 + 1
        };
        let steps = |member| if member == case.locked { pitches } else { sense * pitches };
        let mating = Mating {
            wheel_tooth: on(case.mating.wheel_tooth, case.wheel.teeth, steps(Member::Wheel)),
            pinion_tooth: on(case.mating.pinion_tooth, case.pinion.teeth, steps(Member::Pinion)),
            ..case.mating
        };
        let turned = Mating { fraction: case.mating.fraction + f64::from(pitches), ..case.mating };
        let assembly = case.assemble(1.0);
        let by = |mating| LineOfAction::new(&assembly, &Pose::new(&assembly, mating)).backlash(&assembly);
        // 1000 pitches of 17 teeth are 370 rad: 6e-14 rad of rounding, 1e-11 mm on 200 mm.
        prop_assert!((by(mating).unwrap() - by(turned).unwrap()).abs() < 2e-11);
    }

    /// Design section 2: j_bt = (d_b1 + d_b2)(inv α_wt − inv α_w0), j_r = a − a_0, dj_bt/da = 2 sin α_wt.
    #[test]
    fn identities_of_the_normal_backlash(case in case()) {
        let assembly = case.assemble(1.0);
        let pair = InvolutePair::of(&assembly);
        let base_diameters = 2.0 * [Member::Wheel, Member::Pinion]
            .map(|member| assembly.gear(member).gear().base_radius()).iter().sum::<f64>();
        let a = assembly.center_distance();
        let a_0 = limits::zero_backlash_distance(&assembly).unwrap();
        let inv_at = |a: f64| involute::inv((base_diameters / (2.0 * a)).acos());
        let j_bt = pair.base_backlash(a).unwrap();
        prop_assert!((j_bt - base_diameters * (inv_at(a) - inv_at(a_0))).abs() <= ROUNDING);
        prop_assert!((limits::radial_backlash(&assembly).unwrap() - 2.0 * case.radial_play).abs() <= ROUNDING);
        // Central difference over 2h: off by h² j'''/6 < 1e-8 and 1e-13/h of rounding.
        let h = 1e-4;
        let slope = (pair.base_backlash(a + h).unwrap() - pair.base_backlash(a - h).unwrap()) / (2.0 * h);
        prop_assert!((slope - 2.0 * assembly.operating_pressure_angle().sin()).abs() < 1e-7);
        // And back: the centre distance of that backlash.
        prop_assert!((pair.center_distance(j_bt).unwrap() - a).abs() <= ROUNDING);
    }

    /// Model 1 is model 2's tangent where the gears are nominal, and equals it at a_ref always.
    #[test]
    fn michalec_touches_the_involute_model(case in case(), off in -0.01..0.01) {
        let mut case = case;
        for recipe in [&mut case.wheel, &mut case.pinion] {
            recipe.runout_um = 0.0;
        }
        let reference = limits::nominal_zero_backlash_distance(&case.assemble(1.0)).unwrap();
        let at = |a: f64| {
            let assembly = case.assemble(1.0).at(a).unwrap();
            let pose = Pose::new(&assembly, case.mating);
            let found = evaluate(&assembly, &pose);
            prop_assert!((effective_center_distance(&assembly, &pose) - a).abs() == 0.0);
            Ok(found.michalec.unwrap() - found.involute.unwrap())
        };
        prop_assert!(at(reference)?.abs() <= ROUNDING);
        for recipe in [&mut case.wheel, &mut case.pinion] {
            recipe.allowance_um = 0.0;
        }
        let at = |a: f64| {
            let assembly = case.assemble(1.0).at(a).unwrap();
            let found = evaluate(&assembly, &Pose::new(&assembly, case.mating));
            found.michalec.unwrap() - found.involute.unwrap()
        };
        // j_wt = j_bn a/R: its second derivative is below 1/mm for these gears.
        prop_assert!(at(reference + off).abs() <= off * off);
    }
}

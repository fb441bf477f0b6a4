//! Identities and symmetries of the analytic models on random pairs; contacts of model 3 touch on the gears' own profiles, and none is missed.

use super::*;
use common::random_pair::Case;

/// Equal, or without a value both.
fn same(one: [Option<f64>; 3], other: [Option<f64>; 3]) -> Result<(), TestCaseError> {
    for (model, (one, other)) in one.into_iter().zip(other).enumerate() {
        match (one, other) {
            (Some(one), Some(other)) => {
                prop_assert!((one - other).abs() <= ROUNDING, "{model}: {one} {other}")
            }
            (one, other) => prop_assert_eq!(one, other),
        }
    }
    Ok(())
}

proptest! {
    /// Gears without eccentricity and deviations: models 2 and 3 are one.
    #[test]
    fn models_2_and_3_agree_on_perfect_gears(mut case in case()) {
        for recipe in [&mut case.wheel, &mut case.pinion] {
            recipe.runout_um = 0.0;
            recipe.per_tooth_um.fill([0.0; 3]);
        }
        let [_, involute, line] = case.backlash(1.0);
        prop_assert!((involute.unwrap() - line.unwrap()).abs() <= ROUNDING);
    }

    /// Wheel and pinion exchanged, the locked gear with them: the picture turned by half a turn. Ten times as large. Teeth renumbered. Seen from behind: faces
    /// and flanks swap, right and left contact change places.
    #[test]
    fn symmetries_change_nothing(case in case(), by in (0u32..17, 0u32..17)) {
        let (swapped, mirrored) = (case.swapped(), case.mirrored());
        let renumbered = case.renumbered(by.0, by.1);
        let plain = case.backlash(1.0);
        for other in [&swapped, &mirrored, &renumbered] {
            same(plain, other.backlash(1.0))?;
        }
        same(plain, case.backlash(10.0))?;
        let line = |case: &Case| case.evaluate(1.0).1.line_of_action;
        prop_assert_eq!(line(&case), line(&swapped));
        let (right, left) = (line(&case).right.unwrap(), line(&mirrored).left.unwrap());
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

    /// j_bt = (d_b1 + d_b2)(inv α_wt − inv α_w0), j_r = a − a_0, dj_bt/da = 2 sin α_wt.
    #[test]
    fn identities_of_the_normal_backlash(case in case()) {
        let assembly = case.assemble(1.0);
        let pair = InvolutePair::of(&assembly);
        let bases = Member::BOTH.map(|member| assembly.gear(member).gear().base_radius());
        let base_diameters = 2.0 * (bases[0] + bases[1]);
        let a = assembly.center_distance();
        let a_0 = limits::zero_backlash_distance(&assembly).unwrap();
        let inv_at = |a: f64| inv((base_diameters / (2.0 * a)).acos());
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
    fn michalec_touches_the_involute_model(mut case in case(), off in -0.01..0.01) {
        for recipe in [&mut case.wheel, &mut case.pinion] {
            recipe.runout_um = 0.0;
        }
        let reference = limits::nominal_zero_backlash_distance(&case.assemble(1.0)).unwrap();
        let at = |case: &Case, a: f64| {
            let assembly = case.assemble(1.0).at(a).unwrap();
            let pose = Pose::new(&assembly, case.mating);
            let found = evaluate(&assembly, &pose);
            prop_assert!((effective_center_distance(&assembly, &pose) - a).abs() == 0.0);
            Ok(found.michalec.unwrap() - found.involute.unwrap())
        };
        prop_assert!(at(&case, reference)?.abs() <= ROUNDING);
        for recipe in [&mut case.wheel, &mut case.pinion] {
            recipe.allowance_um = 0.0;
        }
        // j_wt = j_bn a/R: its second derivative is below 1/mm for these gears.
        prop_assert!(at(&case, reference + off)?.abs() <= off * off);
    }

    /// A contact ratio above 1 leaves each side one pair at least. The test skips rough gears, and gears of unequal
    /// temperature, that cannot exist. Unequal temperatures give unequal base pitches.
    #[test]
    fn contacts_touch_and_no_pair_is_missed(
        case in case(),
        rough in rough_case(),
        expansion in prop::array::uniform2(-0.008..0.008f64),
    ) {
        let contacts = check_contacts(&case.assemble(1.0), case.mating)?;
        prop_assert!(contacts >= 2);
        if let Ok(assembly) = rough.try_assemble(1.0) {
            check_contacts(&assembly, rough.mating)?;
            for value in rough.backlash(1.0) {
                prop_assert!(value.is_none_or(f64::is_finite));
            }
        }
        if let Ok(assembly) = rough.warmed(expansion) {
            check_contacts(&assembly, rough.mating)?;
        }
    }
}

fn turned(angle: f64, vector: Vector2<f64>) -> Vector2<f64> {
    Rotation2::new(angle) * vector
}

/// Point and outward normal of a contact on one gear, in the picture, from the gear's profile.
fn touch(
    assembly: &GearPair,
    member: Member,
    rotation: f64,
    side: Side,
    tooth: u32,
    roll: f64,
) -> (Vector2<f64>, Vector2<f64>) {
    let gear = assembly.gear(member);
    let profile = Profile::new(gear.gear());
    let tooth_1 = assembly.mate_direction(member) + rotation;
    let flank = tooth_1 + gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
    let point = profile.point(ProfilePart::Involute, roll, side).coords;
    let centre = assembly.axis(member).coords + gear.displacement(tooth_1);
    let normal = profile.normal(ProfilePart::Involute, roll, side);
    (centre + turned(flank, point), turned(flank, normal))
}

/// How many contacts model 3 reports: points coincide and normals oppose on the gears' own profiles, within both gears' circles. Every facing pair that
/// counts is found, by a plain contraction of all locked teeth without a window, and the tightest is taken.
fn check_contacts(assembly: &GearPair, mating: Mating) -> Result<usize, TestCaseError> {
    let pose = Pose::new(assembly, mating);
    let model = LineOfAction::new(assembly, &pose);
    let gear = assembly.gear(assembly.locked());
    let mating_tooth = mating.tooth(assembly.locked());
    let mut contacts = 0;
    for (side, tightest) in [(Side::Right, model.right), (Side::Left, model.left)] {
        let found: Vec<SideContact> = SideContact::all(assembly, &pose, side).collect();
        prop_assert_eq!(found.is_empty(), tightest.is_none());
        for contact in &found {
            let of = |member, rotation, tooth, roll| {
                let gear = assembly.gear(member).gear();
                let radius = involute::radius_at(roll, gear.base_radius());
                prop_assert!(radius > gear.form_radius() - 1e-9);
                prop_assert!(radius < gear.tip_radius() + 1e-9);
                Ok(touch(assembly, member, rotation, side, tooth, roll))
            };
            let (tooth, roll) = (contact.locked_tooth, contact.locked_roll);
            let locked = of(assembly.locked(), pose.locked_rotation(), tooth, roll)?;
            let (tooth, roll) = (contact.free_tooth, contact.free_roll);
            let free = of(assembly.free(), contact.rotation, tooth, roll)?;
            prop_assert!((locked.0 - free.0).norm() < ROUNDING, "{contact:?}");
            prop_assert!((locked.1 + free.1).norm() < 1e-13, "{contact:?}");
            let ahead = contact.rotation - tightest.unwrap().rotation;
            prop_assert!(side.sense() * ahead >= 0.0);
        }
        contacts += found.len();
        let mut expected: Vec<u32> = (-60..=60)
            .filter(|&steps| plain_contact(assembly, &pose, side, steps))
            .map(|steps| gear.counter_clockwise(mating_tooth, steps))
            .collect();
        let mut teeth: Vec<u32> = found.iter().map(|contact| contact.locked_tooth).collect();
        teeth.sort_unstable();
        expected.sort_unstable();
        prop_assert_eq!(teeth, expected);
    }
    Ok(contacts)
}

/// Whether the contact of one facing pair is on both involutes, by the equations of model 3. They are written out for
/// each side in the picture frame, with the free gear's rotation by plain iteration.
fn plain_contact(assembly: &GearPair, pose: &Pose, side: Side, steps: i64) -> bool {
    let [locked, free] = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
    let locked_tooth = locked.counter_clockwise(pose.mating().tooth(assembly.locked()), steps);
    let free_tooth = pose.facing_tooth(assembly, side, steps);
    let (base_1, base_2) = (locked.gear().base_radius(), free.gear().base_radius());
    // −1 for right flanks, which lie clockwise of their tooth.
    let s = side.sense();
    let at = |member: Member, rotation: f64| {
        let tooth_1 = assembly.mate_direction(member) + rotation;
        assembly.axis(member).coords + assembly.gear(member).displacement(tooth_1)
    };
    let line = assembly.mate_direction(assembly.locked());
    let mating_tooth = f64::from(pose.mating().tooth(assembly.locked()));
    let theta_1 = pose.locked_rotation()
        + locked.tooth_angle(mating_tooth)
        + steps as f64 * locked.gear().basic_data().angular_pitch()
        + locked.flank_offset(side, locked_tooth);
    // The same tooth a turn on faces another one.
    if theta_1.abs() > PI {
        return false;
    }
    let mut rotation = pose.free_rotation();
    let mut rolls = (f64::NAN, f64::NAN);
    for _ in 0..40 {
        let d = at(assembly.free(), rotation) - at(assembly.locked(), pose.locked_rotation());
        let d = turned(-line, d);
        let sum = (d.norm_squared() - (base_1 + base_2).powi(2)).sqrt();
        // Left flanks are the mirror image: every angle changes sign.
        let along = -s * d.y.atan2(d.x) + (sum / (base_1 + base_2)).atan();
        let roll_1 = along + locked.gear().half_base_angle() + s * theta_1;
        let roll_2 = (sum - base_1 * roll_1) / base_2;
        let theta_2 = -s * (along + free.gear().half_base_angle() - roll_2);
        let place = free.tooth_angle(f64::from(free_tooth)) + free.flank_offset(side, free_tooth);
        let turn = theta_2 - place - pose.free_rotation();
        rotation = pose.free_rotation() + turn.sin().atan2(turn.cos());
        rolls = (roll_1, roll_2);
    }
    let on = |gear: &Gear, roll: f64| gear.form_roll() <= roll && roll <= gear.tip_roll();
    on(locked.gear(), rolls.0) && on(free.gear(), rolls.1)
}

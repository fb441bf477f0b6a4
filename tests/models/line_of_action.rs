//! Model 3 on random pairs: its contacts touch on the gears' own profiles, and none is missed.

use crate::common;

use common::random_pair::{ROUNDING, case, rough_case};
use gearlash::analytic::{LineOfAction, SideContact};
use gearlash::gear::{Gear, Profile, ProfilePart, Side, involute};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use nalgebra::{Rotation2, Vector2};
use proptest::prelude::*;
use std::f64::consts::PI;

proptest! {
    #[test]
    fn contacts_touch(case in case()) {
        let contacts = check_contacts(&case.assemble(1.0), case.mating)?;
        // A contact ratio above 1 leaves each side one pair at least.
        prop_assert!(contacts >= 2);
    }

    #[test]
    fn contacts_touch_on_rough_gears(case in rough_case()) {
        // A gear that cannot exist is no case.
        if let Ok(assembly) = case.try_assemble(1.0) {
            check_contacts(&assembly, case.mating)?;
            for value in case.backlash(1.0) {
                prop_assert!(value.is_none_or(f64::is_finite));
            }
        }
    }

    /// Gears of unequal temperature have unequal base pitches.
    #[test]
    fn contacts_touch_on_gears_unequally_warm(
        case in rough_case(),
        expansion in prop::array::uniform2(-0.008..0.008f64),
    ) {
        if let Ok(assembly) = case.warmed(expansion) {
            check_contacts(&assembly, case.mating)?;
            check_complete(&assembly, case.mating)?;
        }
    }

    /// Every facing pair within both gears' circles is found, and the tightest is taken:
    /// all locked teeth tried by a plain contraction, without a window.
    #[test]
    fn no_pair_is_missed(case in case()) {
        check_complete(&case.assemble(1.0), case.mating)?;
    }

    #[test]
    fn no_pair_is_missed_on_rough_gears(case in rough_case()) {
        if let Ok(assembly) = case.try_assemble(1.0) {
            check_complete(&assembly, case.mating)?;
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
    (
        centre + turned(flank, point),
        turned(flank, profile.normal(ProfilePart::Involute, roll, side)),
    )
}

/// The contacts model 3 reports are contacts: points coincide, normals oppose, on the gears' own profiles,
/// within both gears' circles. Returns how many there are.
fn check_contacts(assembly: &GearPair, mating: Mating) -> Result<usize, TestCaseError> {
    let pose = Pose::new(assembly, mating);
    let mut contacts = 0;
    for side in Side::BOTH {
        for contact in SideContact::all(assembly, &pose, side) {
            let of = |member, rotation, tooth, roll| {
                let gear = assembly.gear(member).gear();
                let radius = involute::radius_at(roll, gear.base_radius());
                prop_assert!(radius > gear.form_radius() - 1e-9);
                prop_assert!(radius < gear.tip_radius() + 1e-9);
                Ok(touch(assembly, member, rotation, side, tooth, roll))
            };
            let locked = of(
                assembly.locked(),
                pose.locked_rotation(),
                contact.locked_tooth,
                contact.locked_roll,
            )?;
            let free = of(
                assembly.free(),
                contact.rotation,
                contact.free_tooth,
                contact.free_roll,
            )?;
            prop_assert!((locked.0 - free.0).norm() < ROUNDING, "{contact:?}");
            prop_assert!((locked.1 + free.1).norm() < 1e-13, "{contact:?}");
            contacts += 1;
        }
    }
    Ok(contacts)
}

/// Every facing pair that counts is found, and the tightest of them taken.
fn check_complete(assembly: &GearPair, mating: Mating) -> Result<(), TestCaseError> {
    let pose = Pose::new(assembly, mating);
    let model = LineOfAction::new(assembly, &pose);
    let locked = assembly.gear(assembly.locked());
    let mating_tooth = mating.tooth(assembly.locked());
    for (side, tightest) in [(Side::Right, model.right), (Side::Left, model.left)] {
        let found: Vec<SideContact> = SideContact::all(assembly, &pose, side).collect();
        prop_assert_eq!(found.is_empty(), tightest.is_none());
        for contact in &found {
            let ahead = contact.rotation - tightest.unwrap().rotation;
            prop_assert!(side.sense() * ahead >= 0.0);
        }
        let mut expected: Vec<u32> = (-60..=60)
            .filter(|&steps| plain_contact(assembly, &pose, side, steps))
            .map(|steps| locked.counter_clockwise(mating_tooth, steps))
            .collect();
        let mut teeth: Vec<u32> = found.iter().map(|contact| contact.locked_tooth).collect();
        teeth.sort_unstable();
        expected.sort_unstable();
        prop_assert_eq!(teeth, expected);
    }
    Ok(())
}

/// Whether the contact of one facing pair is on both involutes, by the equations of model 3. They are written out for
/// each side in the picture frame, with the free gear's rotation by plain iteration.
fn plain_contact(assembly: &GearPair, pose: &Pose, side: Side, steps: i64) -> bool {
    let (locked, free) = (
        assembly.gear(assembly.locked()),
        assembly.gear(assembly.free()),
    );
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

//! The hard cases, each by both methods: one status a pose, agreement to 1e-6 µm, and what the
//! case must show. Where the answer has a closed form it is computed in the test.

use gearlash::contact::{Contact, CutPair, ExactKernel, LostMotion, Status};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, ProfilePart,
    Side, involute,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::{PI, TAU};

/// Both methods must agree within this, µm of `j_wt` (issue 3).
const AGREEMENT_UM: f64 = 1e-6;

fn design(teeth: u32, module: f64) -> GearDesign {
    GearDesign {
        basic_data: BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap(),
        profile_shift: 0.0,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    }
}

fn perfect(design: GearDesign) -> AsBuilt {
    AsBuilt::perfect(Gear::nominal(design).unwrap(), Face::Front)
}

fn deviated(design: GearDesign, deviations: &Deviations) -> AsBuilt {
    AsBuilt::new(Gear::nominal(design).unwrap(), Face::Back, deviations).unwrap()
}

fn eccentric(design: GearDesign, eccentricity: f64, high_tooth: f64) -> AsBuilt {
    let deviations = Deviations {
        eccentricity,
        high_tooth,
        ..Deviations::default()
    };
    deviated(design, &deviations)
}

/// One pose by both methods, which must agree; the exact result.
fn by_both(assembly: &GearPair, fraction: f64) -> LostMotion {
    let mating = Mating {
        wheel_tooth: 1,
        pinion_tooth: 1,
        flank: Side::Right,
        fraction,
    };
    let pose = Pose::new(assembly, mating);
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m));
    let cut = CutPair::new(wheel, pinion, 1e-4 * wheel.gear().basic_data().module());
    let exact = ExactKernel::new(assembly).lost_motion(&pose).unwrap();
    let polygon = cut.refined_kernel(assembly).lost_motion(&pose).unwrap();
    assert_eq!(exact.status(), polygon.status(), "{exact:?} {polygon:?}");
    let um = assembly.operating_pitch_radius(assembly.free()) * 1e3;
    if let (Some(one), Some(other)) = (exact.angle(), polygon.angle()) {
        let difference = (one - other).abs() * um;
        assert!(
            difference <= AGREEMENT_UM,
            "{difference:e} µm at {fraction}"
        );
    }
    exact
}

/// Sixteen poses over a pitch, each with either gear locked.
fn over_a_pitch(wheel: AsBuilt, pinion: AsBuilt, distance: f64) -> Vec<LostMotion> {
    let mut results = Vec::new();
    for locked in [Member::Wheel, Member::Pinion] {
        let assembly =
            GearPair::with_locked(wheel.clone(), pinion.clone(), distance, locked).unwrap();
        results.extend((0..16).map(|k| by_both(&assembly, f64::from(k) / 16.0)));
    }
    results
}

fn only(results: &[LostMotion], allowed: &[Status]) {
    for result in results {
        assert!(allowed.contains(&result.status()), "{result:?}");
    }
}

fn count(results: &[LostMotion], status: Status) -> usize {
    results.iter().filter(|r| r.status() == status).count()
}

fn contacts(results: &[LostMotion]) -> impl Iterator<Item = Contact> {
    results.iter().flat_map(|r| [r.right, r.left]).flatten()
}

fn touches(contact: &Contact, curve: ProfilePart) -> bool {
    contact.wheel.curve == curve || contact.pinion.curve == curve
}

/// `j_wt` of perfect gears in involute contact, mm: the closed form of design section 2,
/// `j_bt = p_b − s_b1 − s_b2 + (d_b1 + d_b2) inv α_wt`, over `cos α_wt`.
fn closed_form(assembly: &GearPair) -> f64 {
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m).gear());
    let bases = wheel.base_radius() + pinion.base_radius();
    let angle = (bases / assembly.center_distance()).acos();
    let normal = wheel.basic_data().base_pitch() - wheel.base_thickness() - pinion.base_thickness()
        + 2.0 * bases * involute::inv(angle);
    normal / angle.cos()
}

/// Every pose is on the involutes and has the closed form's backlash.
fn is_closed_form(wheel: AsBuilt, pinion: AsBuilt, distance: f64) {
    let assembly =
        GearPair::with_locked(wheel.clone(), pinion.clone(), distance, Member::Wheel).unwrap();
    let expected = closed_form(&assembly);
    let radius = assembly.operating_pitch_radius(Member::Pinion);
    let results = over_a_pitch(wheel, pinion, distance);
    only(&results, &[Status::Clear]);
    for result in &results[..16] {
        let off = (result.angle().unwrap() * radius - expected).abs();
        assert!(off <= 1e-9, "off by {off:e} mm");
    }
}

/// Addendum 0.4: the path of contact is shorter than a base pitch, so between two pairs on
/// it a tip corner carries, with more backlash than the closed form.
#[test]
fn contact_ratio_below_one() {
    let stub = |teeth| {
        perfect(GearDesign {
            rack: BasicRack::new(0.4, 1.25, 0.38).unwrap(),
            ..design(teeth, 2.0)
        })
    };
    let (wheel, pinion, distance) = (stub(20), stub(31), 51.2);
    let assembly =
        GearPair::with_locked(wheel.clone(), pinion.clone(), distance, Member::Wheel).unwrap();
    let angle = assembly.operating_pressure_angle();
    let [one, two] = [&wheel, &pinion].map(AsBuilt::gear);
    let path = one.base_radius() * one.tip_roll() + two.base_radius() * two.tip_roll()
        - distance * angle.sin();
    assert!(path < one.basic_data().base_pitch(), "{path}");
    let expected = closed_form(&assembly);
    let radius = assembly.operating_pitch_radius(Member::Pinion);
    let results = over_a_pitch(wheel, pinion, distance);
    only(&results, &[Status::Clear]);
    assert!(contacts(&results).any(|contact| touches(&contact, ProfilePart::Tip)));
    for result in &results[..16] {
        assert!(result.angle().unwrap() * radius >= expected - 1e-9);
    }
}

/// Tip circles 0.03 mm into each other: nothing but tips can touch, and most poses touch nothing.
#[test]
fn only_tips_touch() {
    let gear = || perfect(design(30, 3.0));
    let results = over_a_pitch(gear(), gear(), 96.0 - 0.03);
    only(&results, &[Status::Clear, Status::NoContact]);
    assert!(count(&results, Status::Clear) > 0 && count(&results, Status::NoContact) > 0);
    for contact in contacts(&results) {
        // Both within 0.03 mm of the tip circle, 48 mm.
        assert!(contact.wheel.radius > 47.96 && contact.pinion.radius > 47.96);
    }
}

#[test]
fn out_of_mesh() {
    let gear = || perfect(design(30, 3.0));
    only(&over_a_pitch(gear(), gear(), 96.001), &[Status::NoContact]);
    only(&over_a_pitch(gear(), gear(), 500.0), &[Status::NoContact]);
}

#[test]
fn one_tooth_difference() {
    is_closed_form(perfect(design(31, 2.0)), perfect(design(30, 2.0)), 61.05);
}

/// z = 6 is undercut far up its flank: contact leaves the involute, on the joint's edge too.
#[test]
fn six_teeth_heavily_undercut() {
    let six = Gear::nominal(design(6, 2.0)).unwrap();
    assert!(six.fillet().end() < PI / 2.0 - six.basic_data().pressure_angle());
    let results = over_a_pitch(perfect(design(6, 2.0)), perfect(design(40, 2.0)), 46.1);
    only(&results, &[Status::Clear, Status::Interference]);
    assert!(contacts(&results).any(|contact| {
        touches(&contact, ProfilePart::Fillet)
            || touches(&contact, ProfilePart::Tip)
            || (contact.wheel.radius - six.form_radius()).abs() < 1e-6
    }));
}

#[test]
fn two_thousand_teeth() {
    is_closed_form(
        perfect(design(2000, 1.0)),
        perfect(design(2000, 1.0)),
        2000.02,
    );
    is_closed_form(
        perfect(design(2000, 1.0)),
        perfect(design(20, 1.0)),
        1010.02,
    );
}

#[test]
fn least_and_greatest_modules() {
    for module in [0.05, 50.0] {
        is_closed_form(
            perfect(design(40, module)),
            perfect(design(25, module)),
            32.55 * module,
        );
    }
}

/// z = 12 is pointed a little above x = 0.8: a tip land below a tenth of the module.
#[test]
fn nearly_pointed_teeth() {
    let pointed = GearDesign {
        profile_shift: 0.77,
        ..design(12, 4.0)
    };
    let gear = Gear::nominal(pointed).unwrap();
    assert!(2.0 * gear.tip_radius() * gear.half_angle_at_roll(gear.tip_roll()) < 0.4);
    let results = over_a_pitch(perfect(pointed), perfect(design(30, 4.0)), 86.8);
    only(&results, &[Status::Clear]);
}

/// A wave of a third of a pitch: from tooth to tooth 0.45 mm, far above the backlash. It
/// interferes where two pairs disagree, and the backlash varies by more than it would be without.
#[test]
fn pitch_deviation_of_a_third_of_a_pitch() {
    let third = PI * 3.0 / 3.0;
    let wave: Vec<f64> = (0..44)
        .map(|k| third * (TAU * f64::from(k) / 44.0).sin())
        .collect();
    let deviations = Deviations {
        pitch: Some(Pitch::from_cumulative(&wave, &wave)),
        ..Deviations::default()
    };
    let results = over_a_pitch(
        deviated(design(44, 3.0), &deviations),
        perfect(design(44, 3.0)),
        132.3,
    );
    only(&results, &[Status::Clear, Status::Interference]);
    assert!(count(&results, Status::Interference) > 0);
}

/// Eccentric by 2.25 mm, a third of the tooth depth, at 134 mm (2 mm beyond the nominal distance). High
/// teeth towards each other dive 4.5 − 2 mm too deep, past the 0.75 mm of tip clearance; away from each other
/// they stand 6.5 mm apart, beyond the 6 mm that tips overlap.
#[test]
fn eccentricity_of_a_third_of_the_tooth_depth() {
    let gear = |high| eccentric(design(44, 3.0), 2.25, high);
    only(
        &over_a_pitch(gear(1.0), gear(1.0), 134.0),
        &[Status::Jammed],
    );
    only(
        &over_a_pitch(gear(23.0), gear(23.0), 134.0),
        &[Status::NoContact],
    );
    let nominal = || perfect(design(44, 3.0));
    for results in [
        over_a_pitch(gear(12.0), nominal(), 134.0),
        over_a_pitch(nominal(), gear(12.0), 134.0),
        over_a_pitch(gear(12.0), gear(34.0), 134.0),
    ] {
        only(&results, &[Status::Clear]);
    }
}

/// 1 mm below the nominal distance, 0.75 mm of tip clearance: wherever a tip stands near the line of centres it is jammed.
#[test]
fn a_tip_in_a_root_is_jammed() {
    let gear = || perfect(design(30, 3.0));
    let results = over_a_pitch(gear(), gear(), 89.0);
    only(&results, &[Status::Jammed, Status::Interference]);
    assert!(count(&results, Status::Jammed) > 0);
}

/// An eccentric gear's tip land just reaches the mate's root land when its high tooth is on the line of centres, or
/// just does not: 1 µm decides. Thin teeth keep the flanks clear.
#[test]
fn a_tip_just_touches_a_root_land() {
    let design = GearDesign {
        rack: BasicRack::new(1.0, 1.25, 0.2).unwrap(),
        ..design(30, 3.0)
    };
    let thin = design.nominal_base_thickness() - 1.5;
    let high = {
        let deviations = Deviations {
            eccentricity: 0.3,
            high_tooth: 1.0,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::new(design, thin).unwrap(), Face::Front, &deviations).unwrap()
    };
    // Shorter teeth: they do not reach the other's root land first.
    let short = GearDesign {
        tip_diameter: Some(95.0),
        ..design
    };
    let mate = AsBuilt::perfect(Gear::new(short, thin).unwrap(), Face::Back);
    // The root follows the generating shift, so it is deeper than nominal.
    let touching = high.reach() + mate.gear().root_radius();
    for (distance, expected) in [
        (touching - 1e-3, Status::Jammed),
        (touching + 1e-3, Status::Clear),
    ] {
        let assembly =
            GearPair::with_locked(high.clone(), mate.clone(), distance, Member::Wheel).unwrap();
        // Tooth 1 points at the mate once the pose's own half tooth is taken back.
        let half_tooth =
            assembly.operating_half_angle(Member::Wheel) / high.gear().basic_data().angular_pitch();
        let result = by_both(&assembly, -half_tooth);
        assert_eq!(result.status(), expected, "{result:?}");
    }
}

//! The hard cases of the issue: each has a definite answer, checked against brute force at several phases.

use crate::campaign::{Tally, compare};
use gearlash::contact::{ExactKernel, LostMotion, Status};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::{PI, TAU};

struct Plan {
    teeth: u32,
    module: f64,
    shift: f64,
    rack: BasicRack,
}

impl Plan {
    fn new(teeth: u32, module: f64) -> Plan {
        Plan {
            teeth,
            module,
            shift: 0.0,
            rack: BasicRack::ISO_53_A,
        }
    }

    fn gear(&self) -> Gear {
        Gear::nominal(GearDesign {
            basic_data: BasicGearData::new(self.teeth, self.module, 20f64.to_radians()).unwrap(),
            profile_shift: self.shift,
            rack: self.rack,
            tip_diameter: None,
        })
        .unwrap()
    }

    fn perfect(&self) -> AsBuilt {
        AsBuilt::perfect(self.gear(), Face::Front)
    }

    fn deviated(&self, deviations: &Deviations) -> AsBuilt {
        AsBuilt::new(self.gear(), Face::Back, deviations).unwrap()
    }
}

fn pair(wheel: AsBuilt, pinion: AsBuilt, distance: f64) -> GearPair {
    GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap()
}

/// Sixteen poses over a pitch from the mating (1, 1), each third checked against brute force.
fn over_a_pitch(assembly: &GearPair) -> Vec<LostMotion> {
    let kernel = ExactKernel::new(assembly);
    let mut tally = Tally::default();
    (0..16)
        .map(|k| {
            let mating = Mating {
                wheel_tooth: 1,
                pinion_tooth: 1,
                flank: if k % 2 == 0 { Side::Right } else { Side::Left },
                fraction: f64::from(k) / 16.0,
            };
            if k % 3 == 0 {
                compare(assembly, mating, &mut tally, 0);
            }
            kernel.lost_motion(&Pose::new(assembly, mating)).unwrap()
        })
        .collect()
}

fn statuses(results: &[LostMotion]) -> Vec<Status> {
    results.iter().map(LostMotion::status).collect()
}

fn all(results: &[LostMotion], status: Status) -> bool {
    results.iter().all(|result| result.status() == status)
}

#[test]
fn contact_ratio_below_one() {
    // Addendum 0.4: a path of contact shorter than a base pitch. Between two pairs a tip corner carries.
    let stub = BasicRack::new(0.4, 1.25, 0.38).unwrap();
    let plan = |teeth| Plan {
        rack: stub,
        ..Plan::new(teeth, 2.0)
    };
    let results = over_a_pitch(&pair(plan(20).perfect(), plan(31).perfect(), 51.2));
    assert!(all(&results, Status::Clear));
    let on_tips = |result: &&LostMotion| {
        let touches = [result.right.unwrap(), result.left.unwrap()];
        touches.iter().any(|contact| {
            [contact.wheel.curve, contact.pinion.curve]
                .map(|c| c.name())
                .contains(&"tip")
        })
    };
    assert!(results.iter().filter(on_tips).count() > 0);
}

#[test]
fn only_tips_touch() {
    let plan = Plan::new(30, 3.0);
    // Tip circles overlap by 0.03 mm.
    let results = over_a_pitch(&pair(plan.perfect(), plan.perfect(), 96.0 - 0.03));
    let statuses = statuses(&results);
    assert!(statuses.contains(&Status::Clear));
    assert!(statuses.contains(&Status::NoContact));
    assert!(
        statuses
            .iter()
            .all(|&s| s == Status::Clear || s == Status::NoContact)
    );
    let results = over_a_pitch(&pair(plan.perfect(), plan.perfect(), 96.001));
    assert!(all(&results, Status::NoContact));
}

#[test]
fn one_tooth_difference() {
    let results = over_a_pitch(&pair(
        Plan::new(31, 2.0).perfect(),
        Plan::new(30, 2.0).perfect(),
        61.05,
    ));
    assert!(all(&results, Status::Clear));
}

#[test]
fn six_teeth_heavily_undercut() {
    let results = over_a_pitch(&pair(
        Plan::new(6, 2.0).perfect(),
        Plan::new(40, 2.0).perfect(),
        46.1,
    ));
    assert!(results.iter().all(|result| result.angle().is_some()));
    let results = over_a_pitch(&pair(
        Plan::new(40, 2.0).perfect(),
        Plan::new(6, 2.0).perfect(),
        46.1,
    ));
    assert!(results.iter().all(|result| result.angle().is_some()));
}

#[test]
fn two_thousand_teeth() {
    let wheel = || Plan::new(2000, 1.0).perfect();
    assert!(all(
        &over_a_pitch(&pair(wheel(), wheel(), 2000.02)),
        Status::Clear
    ));
    assert!(all(
        &over_a_pitch(&pair(wheel(), Plan::new(20, 1.0).perfect(), 1010.02)),
        Status::Clear
    ));
}

#[test]
fn least_and_greatest_modules() {
    for module in [0.05, 50.0] {
        let (wheel, pinion) = (Plan::new(40, module), Plan::new(17, module));
        let results = over_a_pitch(&pair(wheel.perfect(), pinion.perfect(), 28.55 * module));
        assert!(all(&results, Status::Clear));
    }
}

#[test]
fn nearly_pointed_teeth() {
    // z = 12: pointed a little above x = 0.8.
    let pointed = Plan {
        shift: 0.77,
        ..Plan::new(12, 4.0)
    };
    let gear = pointed.gear();
    let tip = 2.0 * gear.tip_radius() * gear.half_angle_at_roll(gear.tip_roll());
    assert!(tip < 0.1 * 4.0, "{tip}");
    let results = over_a_pitch(&pair(pointed.perfect(), Plan::new(30, 4.0).perfect(), 86.6));
    assert!(results.iter().all(|result| result.angle().is_some()));
}

#[test]
fn pitch_deviation_of_a_third_of_a_pitch() {
    let plan = Plan::new(44, 3.0);
    let wave: Vec<f64> = (0..44)
        .map(|k| PI * 3.0 / 3.0 * (TAU * f64::from(k) / 44.0).sin())
        .collect();
    let deviations = Deviations {
        pitch: Some(Pitch::from_cumulative(&wave, &wave)),
        ..Deviations::default()
    };
    // A pitch error of 0.45 mm from tooth to tooth cannot pass at this backlash: it interferes
    // wherever two pairs disagree by more than the backlash.
    let results = over_a_pitch(&pair(plan.deviated(&deviations), plan.perfect(), 132.3));
    assert!(results.iter().all(|result| result.angle().is_some()));
    assert!(statuses(&results).contains(&Status::Interference));
}

#[test]
fn eccentricity_of_a_third_of_the_tooth_depth() {
    let plan = Plan::new(44, 3.0);
    for high_tooth in [1.0, 12.0, 23.0, 34.0] {
        let deviations = Deviations {
            eccentricity: 2.25 * 3.0 / 3.0,
            high_tooth,
            ..Deviations::default()
        };
        let eccentric = || plan.deviated(&deviations);
        for assembly in [
            pair(eccentric(), plan.perfect(), 134.0),
            pair(plan.perfect(), eccentric(), 134.0),
            pair(eccentric(), eccentric(), 134.0),
        ] {
            for result in over_a_pitch(&assembly) {
                // Both high teeth towards the mate: 4.5 mm too near.
                let dived = 134.0 - 132.0 < 2.25 && high_tooth == 1.0;
                assert!(dived || result.angle().is_some() || result.status() == Status::NoContact);
            }
        }
    }
}

#[test]
fn a_tip_in_a_root_is_jammed() {
    let plan = Plan::new(30, 3.0);
    // Clearance is 0.75 mm: 1 mm below the nominal distance every tip at the line of centres dives in.
    let results = over_a_pitch(&pair(plan.perfect(), plan.perfect(), 89.0));
    let statuses = statuses(&results);
    assert!(statuses.contains(&Status::Jammed));
    assert!(
        statuses
            .iter()
            .all(|&s| s == Status::Jammed || s == Status::Interference)
    );
}

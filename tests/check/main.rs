//! Checks of a pair: classes of contact, what they cost, limits by formula and as measured.

mod along_face;
mod assembles;
mod bearings;
mod classes;
mod directions;
mod distances;
mod failed;
mod lands;
mod map;
mod onset;
mod outlines;
mod play_free;
mod population;
mod population_draws;
mod population_required;
mod population_worst;
mod tips;
mod uncertainty;
mod undercut;
mod verdict;

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/cycle.rs"]
mod cycle;
#[path = "../common/design.rs"]
mod design;
#[path = "../common/eccentric_17_100.rs"]
mod eccentric_17_100;

#[path = "../common/campaign/random.rs"]
#[allow(dead_code)] // campaigns use the rest
mod random;

#[path = "../common/pair_86_21.rs"]
mod pair_86_21;

use common::{ReferenceContact, reference_pair};
use design::design;
use eccentric_17_100::eccentric_17_100;
use gearlash::analysis::compare::compare;
use gearlash::analysis::diagnosis::{
    Check, Diagnosis, Verdict, diagnose, non_involute_onset, radial_clearance, zero_distance,
};
use gearlash::analysis::extremes::{RunExtremes, extremes};
use gearlash::analysis::simulate::simulate;
use gearlash::analysis::study::Study;
use gearlash::analytic::{LineOfAction, SideContact, limits};
use gearlash::contact::{ContactClass, ContactKind, ExactKernel, Method, Moment, PoseClass};
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Side};
use gearlash::pair::{GearPair, Mating, Member, Pose, SweepPlan};
use gearlash_files as input;
use pair_86_21::{pair_86_21, written};
use random::Random;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("fixtures")
        .join(name)
}

/// The extremes of the cycle that begins with wheel tooth 1 and pinion tooth 1.
fn extremes_of(pair: &GearPair) -> RunExtremes {
    let study = Study::of_pair("extremes", pair, 1);
    let exact = Method::Exact { certify: false };
    let found = extremes(&study, exact, &|| ControlFlow::Continue(())).unwrap();
    found.each.into_iter().next().unwrap()
}

fn diagnosed(study: &Study) -> Diagnosis {
    let runs = simulate(study, Method::Exact { certify: true }, &|| {
        ControlFlow::Continue(())
    });
    let runs = compare(runs.unwrap(), study.tolerance_um);
    diagnose(study, &runs, &Default::default(), &mut |_| Ok(()), &|| {
        std::ops::ControlFlow::Continue(())
    })
    .unwrap()
}

fn check<'a>(diagnosis: &'a Diagnosis, id: &str, gear: Option<Member>) -> &'a Check {
    let mut all = diagnosis.groups.iter().flat_map(|group| &group.checks);
    all.find(|check| check.id == id && check.gear == gear)
        .unwrap()
}

/// Two gears, m 3, 20°, 44 and `pinion` teeth, each with an eccentricity.
fn eccentric(distance: f64, high: [(f64, f64); 2], pinion: u32) -> GearPair {
    let gear = |teeth, face, (eccentricity, high_tooth)| {
        let design = GearDesign {
            basic_data: BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap(),
            profile_shift: 0.0,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        };
        let deviations = Deviations {
            eccentricity,
            high_tooth,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::nominal(design).unwrap(), face, &deviations).unwrap()
    };
    GearPair::with_locked(
        gear(44, Face::Front, high[0]),
        gear(pinion, Face::Back, high[1]),
        distance,
        Member::Wheel,
    )
    .unwrap()
}

fn mating(wheel_tooth: u32, pinion_tooth: u32) -> Mating {
    Mating {
        wheel_tooth,
        pinion_tooth,
        flank: Side::Right,
        fraction: 0.0,
    }
}

//! Checks of a pair: classes of contact, what they cost, limits by formula and as measured.

mod along_face;
mod contacts;
mod distances;
#[path = "../common/kit.rs"]
mod kit;
mod lands;
mod outlines;
mod play_free;
mod population;
mod population_limits;
mod runs;
mod verdict;

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/cycle.rs"]
mod cycle;
#[path = "../common/campaign"]
mod campaign {
    #[allow(dead_code)] // campaigns use the rest
    pub mod random;
}

use campaign::random::Random;
use common::reference_pair;
use gearlash::analysis::compare::{ComparedRun, PoseVerdict};
use gearlash::analysis::diagnosis::{
    Check, CheckVerdict, Diagnosis, PoseEvidence, diagnose, failed_checks, map, non_involute_onset,
    radial_clearance, zero_distance,
};
use gearlash::analysis::extremes::{RunExtremes, extremes};
use gearlash::analysis::requirement::{Limits, Quantity};
use gearlash::analysis::simulate::simulate;
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::verdict::{RequirementOutcome, Verdict};
use gearlash::analysis::{Analysis, Plan};
use gearlash::analytic::{InvolutePair, SideContact, limits};
use gearlash::contact::{
    ContactClass, ContactKind, Doubt, ExactKernel, Method, Moment, PoseClass, Status,
};
use gearlash::error::go_on;
use gearlash::gear::{Face, Hand, Lead, Side, Trace};
use gearlash::outline::OutlineGear;
use gearlash::pair::{FaceDeviation, GearPair, Mating, Member, Pose, SweepPlan};
use kit::{Make, ends, near, pair, spur, study};
use std::f64::consts::{FRAC_PI_4, PI, TAU};
use std::ops::ControlFlow;

/// The extremes of each run of a study.
fn runs_of(study: &Study, certify: bool) -> Vec<RunExtremes> {
    extremes(study, Method::Exact { certify }, &go_on)
        .unwrap()
        .each
}

fn run_of(study: &Study) -> RunExtremes {
    runs_of(study, true).swap_remove(0)
}

/// The extremes of the cycle that begins with wheel tooth 1 and pinion tooth 1.
fn extremes_of(pair: &GearPair) -> RunExtremes {
    runs_of(&Study::of_pair("extremes", pair, 1), false).swap_remove(0)
}

fn compared(study: &Study) -> Vec<ComparedRun> {
    simulate(study, Method::Exact { certify: true }, &go_on).unwrap()
}

fn diagnosed(study: &Study) -> Diagnosis {
    let runs = compared(study);
    diagnose(study, &runs, &Default::default(), &mut |_| Ok(()), &go_on).unwrap()
}

fn check<'a>(diagnosis: &'a Diagnosis, id: &str, gear: Option<Member>) -> &'a Check {
    let mut all = diagnosis.groups.iter().flat_map(|group| &group.checks);
    let found = all.find(|check| check.id == id && check.gear == gear);
    found.unwrap()
}

/// The ids of the checks that fail, found without what is sought only to be reported, and every check made.
fn failing(study: &Study) -> (Vec<&'static str>, Analysis<'_>) {
    let plan = Plan::new(study, Method::Exact { certify: false });
    let analysis = Analysis::silently(&plan.with_extremes().with_checks()).unwrap();
    let evidence: Vec<PoseEvidence> = analysis.runs.iter().filter_map(PoseEvidence::of).collect();
    let failed = failed_checks(study, &evidence, &analysis.extremes, &go_on).unwrap();
    (failed.iter().map(|check| check.id).collect(), analysis)
}

/// Two gears, m 3, 20°, 44 and `pinion` teeth, each with an eccentricity.
fn eccentric(distance: f64, high: [(f64, f64); 2], pinion: u32) -> GearPair {
    let [wheel, pinion] = [(44, high[0]), (pinion, high[1])]
        .map(|(teeth, (eccentricity, high))| spur(teeth, 3.0).runout(eccentricity, high));
    pair(&wheel, &pinion, distance)
}

fn mating(wheel_tooth: u32, pinion_tooth: u32) -> Mating {
    kit::at(wheel_tooth, pinion_tooth, 0.0)
}

/// The pair at one mating, at parts of a pitch from there.
fn at_mating(pair: &GearPair, mating: (u32, u32), fractions: Vec<f64>) -> Study {
    let sweep = SweepPlan::Matings {
        matings: vec![mating],
        fractions,
    };
    Study {
        sweep: Some(sweep),
        ..Study::of_pair("one mating", pair, 1)
    }
}

/// The pair at mating 1, 1 alone.
fn at_one_pose(pair: &GearPair) -> Study {
    at_mating(pair, (1, 1), vec![0.0])
}

/// `j_wt`, mm, of a pose that has one.
fn backlash(pair: &GearPair, pose: &Pose) -> f64 {
    let found = ExactKernel::new(pair).lost_motion(pose).unwrap();
    found.angle().unwrap() * pair.operating_pitch_radius(pair.free())
}

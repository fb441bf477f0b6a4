//! What `compare` found of a pair, and its JSON.

use super::verdict_json::{VerdictRecord, verdict_record};
use crate::column::Row;
use crate::extreme::extremes;
use crate::pose::{PoseRow, doubts};
use gearlash::analysis::compare::{ComparedPose, Verdict};
use gearlash::analysis::extremes::RunExtremes;
use gearlash::analysis::requirement::Requirements;
use gearlash::analysis::tally::RunTally;
use gearlash::analysis::uncertainty::Uncertainty;
use gearlash::analysis::verdict::{Requirement, Verdict as CycleVerdict};
use gearlash::contact::Unproven;
use gearlash_files::characters;
use serde::Serialize;

/// One compared pair file.
#[derive(Debug)]
pub struct ComparedPair {
    /// The file as named on the command line.
    pub file: String,
    /// Its title.
    pub title: String,
    /// Tolerance in force, µm.
    pub tolerance_um: f64,
    /// Whether off-line contact passes.
    pub allow_off_line: bool,
    /// Every run.
    pub runs: Vec<RunTally>,
    /// Extremes of the whole mesh cycle.
    pub extremes: Vec<RunExtremes>,
    /// Ids of the checks that fail.
    pub failed_checks: Vec<&'static str>,
    /// What the pair must keep.
    pub requirements: Requirements,
    /// What its measurements may be off, where that is stated.
    pub uncertainty: Option<Uncertainty>,
}

impl ComparedPair {
    /// Whether every run passes, and what is required is kept.
    pub fn passes(&self) -> bool {
        let agrees = self.runs.iter().all(|run| run.passes(self.allow_off_line));
        agrees && self.verdict().requirement != Requirement::NotMet
    }

    /// What is to be said first.
    pub fn verdict(&self) -> CycleVerdict<'_> {
        CycleVerdict::new(
            &self.extremes,
            &self.requirements,
            self.uncertainty,
            self.failed_checks.clone(),
        )
    }
}

#[derive(Serialize)]
struct JsonReport<'a> {
    gearlash: &'static str,
    passed: bool,
    pairs: Vec<JsonPair<'a>>,
}

#[derive(Serialize)]
struct JsonPair<'a> {
    file: &'a str,
    title: &'a str,
    tolerance_um: f64,
    allow_off_line_contact: bool,
    passed: bool,
    verdict: VerdictRecord,
    runs: Vec<JsonRun>,
    extremes: Vec<serde_json::Value>,
}

#[derive(Serialize)]
struct JsonRun {
    center_distance_mm: f64,
    material: &'static str,
    poses: usize,
    compared: usize,
    passed: bool,
    off_line: usize,
    below: usize,
    above: usize,
    max_deviation_um: JsonDeviation,
    worst: Option<JsonWorst>,
    /// Poses that are not proven, none of which is compared.
    unproven: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    unproven_poses: Vec<JsonUnproven>,
}

#[derive(Serialize)]
struct JsonUnproven {
    mating: serde_json::Value,
    /// None where the pose itself is proven, and an end of the bearing clearance is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    unproven: Option<serde_json::Value>,
    /// All that is in doubt, in words.
    reason: String,
}

#[derive(Serialize)]
struct JsonDeviation {
    involute: Option<f64>,
    line_of_action: Option<f64>,
}

#[derive(Serialize)]
struct JsonWorst {
    wheel_tooth: u32,
    pinion_tooth: u32,
    flank: &'static str,
    fraction: f64,
    difference_um: f64,
    error_bound_um: Option<f64>,
}

/// The outcome of `compare` as JSON, one line end at the end.
///
/// # Errors
/// None for a comparison; a number that JSON cannot hold otherwise.
pub fn comparison_json(pairs: &[ComparedPair]) -> Result<String, serde_json::Error> {
    let report = JsonReport {
        gearlash: env!("CARGO_PKG_VERSION"),
        passed: pairs.iter().all(ComparedPair::passes),
        pairs: pairs.iter().map(json_pair).collect(),
    };
    characters::json_of(&report)
}

fn json_pair(pair: &ComparedPair) -> JsonPair<'_> {
    let run = |run: &RunTally| {
        let summary = run.summary();
        JsonRun {
            center_distance_mm: run.assembly.center_distance(),
            material: run.material.name(),
            poses: run.poses,
            compared: run.compared,
            passed: run.passes(pair.allow_off_line),
            off_line: run.count(Verdict::OffLine),
            below: run.count(Verdict::Below),
            above: run.count(Verdict::Above),
            max_deviation_um: JsonDeviation {
                involute: summary.off_involute.map(|length| length * 1e3),
                line_of_action: summary.off_line_of_action.map(|length| length * 1e3),
            },
            unproven: run.count(Verdict::Unproven),
            unproven_poses: run.first_unproven.iter().map(json_unproven).collect(),
            worst: run.worst().map(|(pose, difference)| {
                let mating = pose.simulated.pose.mating();
                JsonWorst {
                    wheel_tooth: mating.wheel_tooth,
                    pinion_tooth: mating.pinion_tooth,
                    flank: mating.flank.name(),
                    fraction: mating.fraction,
                    difference_um: difference * 1e3,
                    error_bound_um: pose.simulated.error_bound.map(|length| length * 1e3),
                }
            }),
        }
    };
    JsonPair {
        file: &pair.file,
        title: &pair.title,
        tolerance_um: pair.tolerance_um,
        allow_off_line_contact: pair.allow_off_line,
        passed: pair.passes(),
        verdict: verdict_record(&pair.verdict()),
        runs: pair.runs.iter().map(run).collect(),
        extremes: extremes(&pair.verdict()),
    }
}

fn json_unproven(pose: &ComparedPose) -> JsonUnproven {
    JsonUnproven {
        mating: PoseRow::mating_json(pose.simulated.pose.mating()),
        unproven: pose.simulated.found.as_ref().err().map(unproven),
        reason: doubts(pose),
    }
}

fn unproven(unproven: &Unproven) -> serde_json::Value {
    serde_json::json!(Unproven::columns().object(unproven))
}

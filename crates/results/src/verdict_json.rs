//! The verdict and the extremes of the mesh cycle, as results carry them beside their runs.

use crate::column::Row;
use crate::extreme::extremes;
use crate::pose::PoseRow;
use crate::verdict::lines;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::extremes::CoveredPhases;
use gearlash::analysis::verdict::Verdict;
use gearlash::outline::AssembledPair;
use gearlash_files::characters;
use serde::Serialize;

/// What is said first.
#[derive(Debug, Serialize)]
pub(super) struct VerdictRecord {
    text: String,
    assembles: Option<bool>,
    requirement: &'static str,
    phases: PhasesRecord,
    failed_checks: Vec<&'static str>,
    matings: u64,
}

/// The assembly phases that a verdict covers: `"all"`, or the wheel and pinion tooth that name each.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum PhasesRecord {
    All(&'static str),
    Some(Vec<(u32, u32)>),
}

/// The extremes that `verdict` rests on as JSON: a list of what results have under `extremes`.
///
/// # Errors
/// None for a verdict; a number that JSON cannot hold otherwise.
pub fn extremes_json(verdict: &Verdict) -> Result<String, serde_json::Error> {
    serde_json::to_string(&extremes(verdict)).map(characters::json)
}

/// A pose of `assembly` as JSON, as results have it.
///
/// # Errors
/// None for a pose; a number that JSON cannot hold otherwise.
pub fn pose_json(
    assembly: &AssembledPair,
    pose: &ComparedPose,
) -> Result<String, serde_json::Error> {
    serde_json::to_string(&PoseRow::columns().object(&PoseRow::new(assembly, pose)))
        .map(characters::json)
}

pub(super) fn verdict_record(verdict: &Verdict) -> VerdictRecord {
    VerdictRecord {
        text: lines(verdict).to_string(),
        assembles: verdict.assembles(),
        requirement: verdict.requirement.name(),
        phases: match CoveredPhases::of(verdict.runs) {
            CoveredPhases::All => PhasesRecord::All("all"),
            CoveredPhases::Some(phases) => PhasesRecord::Some(phases),
        },
        failed_checks: verdict.failed_checks.iter().map(|check| check.id).collect(),
        matings: verdict.matings(),
    }
}

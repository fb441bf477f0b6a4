//! The verdict and the extremes of the mesh cycle, as in results.

use crate::column::Row;
use crate::extreme::extremes;
use crate::pose::PoseRow;
use crate::verdict::lines;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::extremes::CoveredPhases;
use gearlash::analysis::verdict::Verdict;
use gearlash::outline::AssembledPair;
use gearlash_files::characters;
use serde_json::{Value, json};

/// The extremes behind `verdict` as JSON: the list under `extremes` in results.
///
/// # Errors
/// None for a verdict; otherwise a number that JSON cannot hold.
pub fn extremes_json(verdict: &Verdict) -> Result<String, serde_json::Error> {
    serde_json::to_string(&extremes(verdict)).map(characters::json)
}

/// A pose of `assembly` as JSON, as in results.
///
/// # Errors
/// None for a pose; otherwise a number that JSON cannot hold.
pub fn pose_json(
    assembly: &AssembledPair,
    pose: &ComparedPose,
) -> Result<String, serde_json::Error> {
    serde_json::to_string(&PoseRow::columns().object(&PoseRow::new(assembly, pose)))
        .map(characters::json)
}

/// `verdict` as JSON. Its assembly phases are `"all"`, or the wheel and pinion tooth of each.
pub(super) fn verdict_record(verdict: &Verdict) -> Value {
    let failed = verdict.failed_checks.iter().map(|check| check.id);
    json!({
        "text": lines(verdict).to_string(),
        "assembles": verdict.assembles(),
        "requirement": verdict.requirement.name(),
        "phases": match CoveredPhases::of(verdict.runs) {
            CoveredPhases::All => json!("all"),
            CoveredPhases::Some(phases) => json!(phases),
        },
        "failed_checks": failed.collect::<Vec<_>>(),
        "matings": verdict.matings(),
    })
}

//! The verdict and the extremes of the mesh cycle, as results carry them beside their runs.

use super::records::{PoseRecord, pose_record, um};
use crate::verdict::{doubt, in_words, sentence};
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::extremes::{RunExtreme, RunExtremes};
use gearlash::analysis::verdict::Verdict;
use gearlash::pair::{GearPair, Member};
use gearlash_files::characters;
use serde::Serialize;

/// What is said first.
#[derive(Debug, Serialize)]
pub(super) struct VerdictRecord {
    text: String,
    assembles: Option<bool>,
    requirement: &'static str,
    failed_checks: Vec<&'static str>,
    matings: u64,
}

/// The extremes of one centre distance, material and assembly phase.
#[derive(Debug, Serialize)]
pub(super) struct ExtremesRecord {
    center_distance_mm: f64,
    material: &'static str,
    phase: Option<[u32; 2]>,
    status: &'static str,
    assembles_from_mm: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    assembles_from_doubt: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    meshes_to_mm: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    meshes_to_doubt: Option<&'static str>,
    least: Option<ExtremeRecord>,
    greatest: Option<ExtremeRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    with_bearing_clearance: Option<BearingRecord>,
}

/// The least at `a − c`, the greatest at `a + c`.
#[derive(Debug, Serialize)]
struct BearingRecord {
    clearance_mm: f64,
    /// Of the axes pressed together, and pulled apart.
    status: [&'static str; 2],
    least: Option<ExtremeRecord>,
    greatest: Option<ExtremeRecord>,
}

#[derive(Debug, Serialize)]
struct ExtremeRecord {
    j_wt_um: [f64; 2],
    lost_motion_rad: [f64; 2],
    lost_motion_arcmin: ArcminRecord,
    proven: bool,
    uncertainty_um: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    doubt: Option<String>,
    /// Where it is worst, of gears without a direction.
    #[serde(skip_serializing_if = "Option::is_none")]
    high_tooth: Option<HighTooth>,
    pose: PoseRecord,
}

#[derive(Debug, Serialize)]
struct HighTooth {
    wheel: Option<f64>,
    pinion: Option<f64>,
}

#[derive(Debug, Serialize)]
struct ArcminRecord {
    wheel: f64,
    pinion: f64,
}

/// The extremes that `verdict` rests on as JSON: a list of what results have under `extremes`.
///
/// # Errors
/// None for a verdict; a number that JSON cannot hold otherwise.
pub fn extremes_json(verdict: &Verdict) -> Result<String, serde_json::Error> {
    serde_json::to_string(&extremes_records(verdict)).map(characters::json)
}

/// A pose of `assembly` as JSON, as results have it.
///
/// # Errors
/// None for a pose; a number that JSON cannot hold otherwise.
pub fn pose_json(assembly: &GearPair, pose: &ComparedPose) -> Result<String, serde_json::Error> {
    serde_json::to_string(&pose_record(assembly, pose)).map(characters::json)
}

pub(super) fn verdict_record(verdict: &Verdict) -> VerdictRecord {
    VerdictRecord {
        text: sentence(verdict),
        assembles: verdict.assembles(),
        requirement: verdict.requirement.name(),
        failed_checks: verdict.failed_checks.clone(),
        matings: verdict.matings(),
    }
}

pub(super) fn extremes_records(verdict: &Verdict) -> Vec<ExtremesRecord> {
    let runs = verdict.runs.iter();
    runs.map(|run| extremes_record(verdict, run)).collect()
}

fn extremes_record(verdict: &Verdict, run: &RunExtremes) -> ExtremesRecord {
    let one = |extreme: &Option<RunExtreme>| {
        let extreme = extreme.as_ref();
        extreme.map(|extreme| extreme_record(verdict, run, extreme))
    };
    ExtremesRecord {
        center_distance_mm: run.assembly.center_distance(),
        material: run.material.name(),
        phase: run.phase.map(|(wheel, pinion)| [wheel, pinion]),
        status: run.status.name(),
        assembles_from_mm: run.assembles_from.map(|from| [from.low, from.high]),
        assembles_from_doubt: run.assembles_from.and_then(|from| from.doubt).map(in_words),
        meshes_to_mm: run.meshes_to.map(|to| [to.low, to.high]),
        meshes_to_doubt: run.meshes_to.and_then(|to| to.doubt).map(in_words),
        least: one(&run.least),
        greatest: one(&run.greatest),
        with_bearing_clearance: run.bearings.as_ref().map(|play| BearingRecord {
            clearance_mm: play.clearance,
            status: [&play.pressed, &play.apart].map(|end| end.status.name()),
            least: one(&play.pressed.extreme),
            greatest: one(&play.apart.extreme),
        }),
    }
}

fn extreme_record(verdict: &Verdict, run: &RunExtremes, extreme: &RunExtreme) -> ExtremeRecord {
    let assembly = &extreme.assembly;
    let bracket = [extreme.low, extreme.high];
    let found = assembly.backlash(extreme.found());
    ExtremeRecord {
        j_wt_um: bracket.map(um),
        lost_motion_rad: bracket.map(|j_wt| assembly.backlash(j_wt).angle(assembly.free())),
        lost_motion_arcmin: ArcminRecord {
            wheel: found.arcmin(Member::Wheel),
            pinion: found.arcmin(Member::Pinion),
        },
        proven: extreme.is_proven(),
        uncertainty_um: verdict.expanded(extreme).map(um),
        doubt: doubt(extreme),
        high_tooth: run.any_direction().then(|| {
            let of = |member| {
                let open = run.assembly.gear(member).any_direction();
                open.then(|| assembly.gear(member).high_tooth())
            };
            HighTooth {
                wheel: of(Member::Wheel),
                pinion: of(Member::Pinion),
            }
        }),
        pose: pose_record(assembly, &extreme.pose),
    }
}

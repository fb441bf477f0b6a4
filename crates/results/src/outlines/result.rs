//! The result of a pair of outlines as JSON and CSV, keys as of other results where they mean the same.

use super::fitted::{FittedRecord, records};
use super::sentence::lines;
use crate::judged::{Case, Judged, VERDICT};
use crate::layout::Screen;
use crate::text::outlines;
use gearlash::analysis::diagnosis::Verdict;
use gearlash::analysis::outlines::{OutlineMap, OutlinePose, OutlineRun, turns};
use gearlash::analysis::verdict::Requirement;
use gearlash::contact::{OutlineContact, Status};
use gearlash::pair::{BacklashUnit, Member, arcmin};
use gearlash_files::OutlinePairFile;
use gearlash_files::characters;
use gearlash_files::characters::csv_text;
use gearlash_files::spec::OutlinePairSpec;
use serde::Serialize;
use serde_json::{Value, to_value};

#[derive(Serialize)]
struct Result<'a> {
    gearlash: &'static str,
    pair: &'a OutlinePairSpec,
    verdict: VerdictRecord,
    fitted_involutes: Vec<FittedRecord>,
    runs: Vec<RunRecord>,
}

#[derive(Serialize)]
struct VerdictRecord {
    text: String,
    assembles: Option<bool>,
    requirement: &'static str,
    failed_checks: [&'static str; 0],
    matings: u64,
    certified: bool,
    proven: bool,
}

#[derive(Serialize)]
struct RunRecord {
    center_distance_mm: f64,
    material: &'static str,
    matings: u64,
    turns: Option<bool>,
    turns_from_mm: Option<f64>,
    least: Option<PoseRecord>,
    greatest: Option<PoseRecord>,
    counts: Counts,
    poses: Vec<PoseRecord>,
}

#[derive(Serialize)]
struct Counts {
    clear: usize,
    interference: usize,
    jammed: usize,
    no_contact: usize,
    unproven: usize,
}

#[derive(Serialize)]
struct PoseRecord {
    wheel_tooth: u32,
    pinion_tooth: u32,
    fraction: f64,
    status: &'static str,
    lost_motion_rad: Option<f64>,
    j_wt_um: Option<f64>,
    wheel_arcmin: Option<f64>,
    pinion_arcmin: Option<f64>,
    error_bound_um: Option<f64>,
    right: Option<ContactRecord>,
    left: Option<ContactRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

#[derive(Serialize)]
struct ContactRecord {
    wheel_tooth: u32,
    pinion_tooth: u32,
    wheel_region: &'static str,
    pinion_region: &'static str,
    wheel_radius_mm: f64,
    pinion_radius_mm: f64,
    free_rotation_rad: f64,
    point_mm: [f64; 2],
    normal: [f64; 2],
}

fn contact(contact: &OutlineContact) -> ContactRecord {
    ContactRecord {
        wheel_tooth: contact.wheel.tooth,
        pinion_tooth: contact.pinion.tooth,
        wheel_region: contact.wheel.curve.name(),
        pinion_region: contact.pinion.curve.name(),
        wheel_radius_mm: contact.wheel.radius,
        pinion_radius_mm: contact.pinion.radius,
        free_rotation_rad: contact.rotation,
        point_mm: contact.point.into(),
        normal: contact.normal.into(),
    }
}

fn pose(run: &OutlineRun, pose: &OutlinePose) -> PoseRecord {
    let found = pose.found.as_ref().ok();
    let j_wt = pose.j_wt.map(|(j_wt, _)| j_wt);
    let at = |member| j_wt.map(|j_wt| arcmin(j_wt / run.pair.operating_pitch_radius(member)));
    let error = pose.j_wt.map(|(_, error)| error);
    PoseRecord {
        wheel_tooth: pose.mating.wheel_tooth,
        pinion_tooth: pose.mating.pinion_tooth,
        fraction: pose.mating.fraction,
        status: pose.status().name(),
        lost_motion_rad: pose.angle(),
        j_wt_um: j_wt.map(|mm| mm * 1e3),
        wheel_arcmin: at(Member::Wheel),
        pinion_arcmin: at(Member::Pinion),
        error_bound_um: error.map(|mm| mm * 1e3),
        right: found.and_then(|found| found.right.as_ref()).map(contact),
        left: found.and_then(|found| found.left.as_ref()).map(contact),
        reason: pose.found.as_ref().err().map(ToString::to_string),
    }
}

fn run(of: &OutlineRun) -> RunRecord {
    RunRecord {
        center_distance_mm: of.pair.center_distance(),
        material: of.material.name(),
        matings: of.matings,
        turns: of.turns(),
        turns_from_mm: of.turns_from.as_ref().map(|from| from.high),
        least: of.least.as_ref().map(|least| pose(of, least)),
        greatest: of.greatest.as_ref().map(|greatest| pose(of, greatest)),
        counts: Counts {
            clear: of.count(Status::Clear),
            interference: of.count(Status::Interference),
            jammed: of.count(Status::Jammed),
            no_contact: of.count(Status::NoContact),
            unproven: of.count(Status::Unproven),
        },
        poses: of.poses.iter().map(|each| pose(of, each)).collect(),
    }
}

/// The whole result as JSON.
///
/// # Errors
/// Of serde_json.
pub fn to_json(file: &OutlinePairFile, runs: &[OutlineRun]) -> serde_json::Result<String> {
    characters::json_of(&Result {
        gearlash: env!("CARGO_PKG_VERSION"),
        pair: &file.spec,
        verdict: verdict(file, runs),
        fitted_involutes: records(file),
        runs: runs.iter().map(run).collect(),
    })
}

fn verdict(file: &OutlinePairFile, runs: &[OutlineRun]) -> VerdictRecord {
    VerdictRecord {
        text: lines(&file.study, runs).to_string(),
        assembles: turns(runs),
        requirement: file.study.requirement(runs).name(),
        failed_checks: [],
        matings: runs.first().map_or(0, |run| run.matings),
        certified: !runs.is_empty() && runs.iter().all(|run| run.certified),
        proven: false,
    }
}

#[derive(Serialize)]
struct CheckedFile<'a> {
    file: &'a str,
    passed: bool,
    pair: &'a OutlinePairSpec,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    warnings: &'a [String],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    remarks: &'a [String],
    verdict: VerdictRecord,
    checks: [&'static str; 0],
    fitted_involutes: Vec<FittedRecord>,
    runs: Vec<RunRecord>,
}

/// The outcome of `check` for the pair of `file`, called `name`; `is_proven` says whether all its poses are. Its text is for `screen`.
///
/// # Errors
/// Of serde_json.
pub fn checked(
    name: &str,
    file: &OutlinePairFile,
    runs: &[OutlineRun],
    is_proven: bool,
    screen: &Screen,
) -> serde_json::Result<Judged> {
    let requirement = file.study.requirement(runs);
    let kept = match requirement {
        Requirement::None => turns(runs) == Some(true),
        requirement => requirement.is_kept(),
    };
    let passes = is_proven && kept;
    let lines = lines(&file.study, runs);
    let json: Value = to_value(&CheckedFile {
        file: name,
        passed: passes,
        pair: &file.spec,
        warnings: &file.warnings,
        remarks: &file.remarks,
        verdict: verdict(file, runs),
        checks: [],
        fitted_involutes: records(file),
        runs: runs.iter().map(run).collect(),
    })?;
    Ok(Judged {
        file: name.to_owned(),
        title: file.study.title.clone(),
        passes,
        cases: vec![Case {
            name: VERDICT.to_owned(),
            verdict: match passes {
                true => Verdict::Pass,
                false => lines.state.max(Verdict::Unproven),
            },
            message: lines.to_string(),
        }],
        warnings: file.warnings.clone(),
        remarks: file.remarks.clone(),
        text: outlines(file, runs, BacklashUnit::Um, screen),
        markdown: String::new(),
        json,
        verdict: lines,
    })
}

#[derive(Serialize)]
struct MapRow {
    center_distance_mm: f64,
    pitches: f64,
    wheel_tooth: u32,
    pinion_tooth: u32,
    fraction: f64,
    status: &'static str,
    j_wt_um: Option<f64>,
}

#[derive(Serialize)]
struct Row {
    center_distance_mm: f64,
    material: &'static str,
    wheel_tooth: u32,
    pinion_tooth: u32,
    fraction: f64,
    status: &'static str,
    j_wt_um: Option<f64>,
    error_bound_um: Option<f64>,
    wheel_arcmin: Option<f64>,
    pinion_arcmin: Option<f64>,
    right_wheel_tooth: Option<u32>,
    right_pinion_tooth: Option<u32>,
    right_wheel_region: Option<&'static str>,
    right_pinion_region: Option<&'static str>,
    left_wheel_tooth: Option<u32>,
    left_pinion_tooth: Option<u32>,
    left_wheel_region: Option<&'static str>,
    left_pinion_region: Option<&'static str>,
}

/// `map` as CSV, a row a cell: its pose.
///
/// # Errors
/// Of the csv crate.
pub fn outline_map_csv(map: &OutlineMap) -> std::result::Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (distance, cells) in map
        .distances
        .iter()
        .zip(map.cells.chunks(map.columns.max(1)))
    {
        for cell in cells {
            writer.serialize(MapRow {
                center_distance_mm: *distance,
                pitches: cell.pitches,
                wheel_tooth: cell.mating.wheel_tooth,
                pinion_tooth: cell.mating.pinion_tooth,
                fraction: cell.mating.fraction,
                status: cell.status().name(),
                j_wt_um: cell.j_wt.map(|(mm, _)| mm * 1e3),
            })?;
        }
    }
    csv_text(writer)
}

/// A row a pose.
///
/// # Errors
/// Of the csv crate.
pub fn to_csv(runs: &[OutlineRun]) -> std::result::Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for of in runs {
        for each in &of.poses {
            let of_pose = pose(of, each);
            let (right, left) = (of_pose.right.as_ref(), of_pose.left.as_ref());
            writer.serialize(Row {
                center_distance_mm: of.pair.center_distance(),
                material: of.material.name(),
                wheel_tooth: of_pose.wheel_tooth,
                pinion_tooth: of_pose.pinion_tooth,
                fraction: of_pose.fraction,
                status: of_pose.status,
                j_wt_um: of_pose.j_wt_um,
                error_bound_um: of_pose.error_bound_um,
                wheel_arcmin: of_pose.wheel_arcmin,
                pinion_arcmin: of_pose.pinion_arcmin,
                right_wheel_tooth: right.map(|contact| contact.wheel_tooth),
                right_pinion_tooth: right.map(|contact| contact.pinion_tooth),
                right_wheel_region: right.map(|contact| contact.wheel_region),
                right_pinion_region: right.map(|contact| contact.pinion_region),
                left_wheel_tooth: left.map(|contact| contact.wheel_tooth),
                left_pinion_tooth: left.map(|contact| contact.pinion_tooth),
                left_wheel_region: left.map(|contact| contact.wheel_region),
                left_pinion_region: left.map(|contact| contact.pinion_region),
            })?;
        }
    }
    csv_text(writer)
}

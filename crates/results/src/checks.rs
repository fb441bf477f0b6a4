//! The checks of a pair as JSON, and the map of what touches as CSV.

use super::table::{Column, Table, Unit};
use super::verdict_json::{VerdictRecord, verdict_record};
use crate::extreme::extremes;
use crate::run::contact_count;
use gearlash::analysis::diagnosis::{Check, Diagnosis, Group, Map as ContactMap};
use gearlash::analysis::verdict::Verdict;
use gearlash::pair::Member;
use gearlash_files::PairFile;
use gearlash_files::characters;
use gearlash_files::spec::PairSpec;
use serde::Serialize;
use serde_json::{Map, Value};

#[derive(Debug, Serialize)]
struct CheckFile<'a> {
    gearlash: &'static str,
    pair: &'a PairSpec,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    warnings: &'a [String],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    remarks: &'a [String],
    verdict: VerdictRecord,
    extremes: Vec<Value>,
    checks_verdict: &'static str,
    checks: Vec<CheckRecord<'a>>,
    contact: Value,
    runs: Vec<GroupRecord>,
}

#[derive(Debug, Serialize)]
struct CheckRecord<'a> {
    id: &'static str,
    gear: Option<&'static str>,
    analytic: Option<f64>,
    measured: Option<f64>,
    limit: Option<f64>,
    margin: Option<f64>,
    unit: &'static str,
    verdict: &'static str,
    center_distance_mm: f64,
    material: &'static str,
    details: Map<String, Value>,
    note: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    unproven: Option<&'a str>,
}

#[derive(Debug, Serialize)]
struct GroupRecord {
    center_distance_mm: f64,
    material: &'static str,
    contact: Value,
}

/// The checks of a pair as JSON, one line end at the end: every check of each centre distance and material.
///
/// # Errors
/// None for a diagnosis; a number that JSON cannot hold otherwise.
pub fn checks_json(
    file: &PairFile,
    diagnosis: &Diagnosis,
    verdict: &Verdict,
) -> Result<String, serde_json::Error> {
    let groups = || diagnosis.groups.iter();
    let file = CheckFile {
        gearlash: env!("CARGO_PKG_VERSION"),
        pair: &file.spec,
        warnings: &file.warnings,
        remarks: &file.remarks,
        verdict: verdict_record(verdict),
        extremes: extremes(verdict),
        checks_verdict: diagnosis.verdict().name(),
        checks: groups()
            .flat_map(|group| group.checks.iter().map(|check| check_record(group, check)))
            .collect(),
        contact: contact_count(&diagnosis.contact),
        runs: groups()
            .map(|group| GroupRecord {
                center_distance_mm: group.assembly.center_distance(),
                material: group.material.name(),
                contact: contact_count(&group.contact),
            })
            .collect(),
    };
    characters::json_of(&file)
}

fn check_record<'a>(group: &Group, check: &'a Check) -> CheckRecord<'a> {
    let details = check.details.iter();
    CheckRecord {
        id: check.id,
        gear: check.gear.map(Member::name),
        analytic: check.analytic,
        measured: check.measured,
        limit: check.limit,
        margin: check.margin,
        unit: check.unit,
        verdict: check.verdict.name(),
        center_distance_mm: group.assembly.center_distance(),
        material: group.material.name(),
        details: details
            .map(|(name, value)| ((*name).to_owned(), (*value).into()))
            .collect(),
        note: &check.note,
        unproven: check.unproven.as_deref(),
    }
}

/// `map` as CSV, a row a pose.
///
/// # Errors
/// None that a map can cause; the writer's otherwise.
pub fn map_csv(map: &ContactMap) -> Result<String, csv::Error> {
    let distances = map.distances.iter();
    let places = distances.flat_map(|distance| {
        let fractions = map.fractions.iter();
        fractions.map(|fraction| (*distance, *fraction))
    });
    let (distances, fractions): (Vec<f64>, Vec<f64>) = places.unzip();
    let cells = || map.cells.iter();
    let table = Table {
        name: "map",
        columns: vec![
            Column::new("center_distance_mm", Unit::Mm, distances),
            Column::new("fraction", Unit::None, fractions),
            Column::new("class", Unit::None, cells().map(|cell| cell.class.name())),
            Column::new(
                "j_wt_um",
                Unit::Um,
                cells().map(|cell| cell.backlash.map(|j| j * 1e3)),
            ),
        ],
    };
    table.to_csv()
}

//! The checks of a pair as a judged file, and the map of what touches as CSV.

use crate::extreme::extremes;
use crate::judged::{Case, Judged, VERDICT};
use crate::layout::Screen;
use crate::remedies::RemedyRecord;
use crate::run::contact_count;
use crate::table::{Column, Table, Unit};
use crate::text::check::{governing, outlines, text, unit};
use crate::verdict::lines;
use crate::verdict_json::{VerdictRecord, verdict_record};
use gearlash::analysis::diagnosis::{self, Check, Diagnosis, Group, Map as ContactMap};
use gearlash::analysis::verdict::Verdict;
use gearlash::pair::Member;
use gearlash_files::PairFile;
use gearlash_files::numbers::fixed;
use gearlash_files::spec::PairSpec;
use serde::Serialize;
use serde_json::{Map, Value, to_value};

#[derive(Debug, Serialize)]
struct FileRecord<'a> {
    file: &'a str,
    passed: bool,
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
    remedies: &'a [RemedyRecord],
}

#[derive(Debug, Serialize)]
struct CheckRecord<'a> {
    id: &'static str,
    title: &'static str,
    gear: Option<&'static str>,
    formula: Option<f64>,
    outlines: Option<f64>,
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

/// The outcome of `check` for the pair of `file`, called `name`; `is_proven` says whether all its poses are. Its text is for `screen`.
///
/// # Errors
/// None for a diagnosis; a number that JSON cannot hold otherwise.
pub fn checked(
    name: &str,
    file: &PairFile,
    diagnosis: &Diagnosis,
    verdict: &Verdict,
    remedies: &[RemedyRecord],
    is_proven: bool,
    screen: &Screen,
) -> serde_json::Result<Judged> {
    let checks = diagnosis.verdict() < diagnosis::Verdict::Unproven;
    let passes = is_proven && checks && verdict.passes();
    let lines = lines(verdict);
    let mut cases = vec![
        Case {
            name: VERDICT.to_owned(),
            verdict: match verdict.passes() {
                true => diagnosis::Verdict::Pass,
                false => verdict.state().max(diagnosis::Verdict::Unproven),
            },
            message: lines.to_string(),
        },
        Case {
            name: "poses".to_owned(),
            verdict: match is_proven {
                true => diagnosis::Verdict::Pass,
                false => diagnosis::Verdict::Unproven,
            },
            message: match is_proven {
                true => "all poses are proven".to_owned(),
                false => "some poses are not proven, or methods disagree".to_owned(),
            },
        },
    ];
    cases.extend(
        governing(diagnosis)
            .into_iter()
            .map(|(_, check)| case(check)),
    );
    let record = FileRecord {
        file: name,
        passed: passes,
        pair: &file.spec,
        warnings: &file.warnings,
        remarks: &file.remarks,
        verdict: verdict_record(verdict),
        extremes: extremes(verdict),
        checks_verdict: diagnosis.verdict().name(),
        checks: diagnosis
            .groups
            .iter()
            .flat_map(|group| group.checks.iter().map(|check| check_record(group, check)))
            .collect(),
        contact: contact_count(&diagnosis.contact),
        runs: diagnosis.groups.iter().map(group_record).collect(),
        remedies,
    };
    Ok(Judged {
        file: name.to_owned(),
        title: file.study.title.clone(),
        passes,
        cases,
        warnings: file.warnings.clone(),
        remarks: file.remarks.clone(),
        text: text(&file.study, verdict, diagnosis, remedies, screen),
        markdown: String::new(),
        json: to_value(&record)?,
        verdict: lines,
    })
}

fn case(check: &Check) -> Case {
    let value = |value: Option<f64>| fixed(value, 4);
    let note = match check.note.is_empty() {
        true => String::new(),
        false => format!("; {}", check.note),
    };
    let numbers = format!(
        "formula {}, outlines {}, limit {} {}",
        value(check.formula),
        outlines(check, value),
        value(check.limit),
        unit(check.unit)
    );
    Case {
        name: match check.gear {
            Some(gear) => format!("{} ({})", check.title, gear.name()),
            None => check.title.to_owned(),
        },
        verdict: check.verdict,
        message: format!("{}{note}", numbers.trim_end()),
    }
}

fn group_record(group: &Group) -> GroupRecord {
    GroupRecord {
        center_distance_mm: group.assembly.center_distance(),
        material: group.material.name(),
        contact: contact_count(&group.contact),
    }
}

fn check_record<'a>(group: &Group, check: &'a Check) -> CheckRecord<'a> {
    let details = check.details.iter();
    CheckRecord {
        id: check.id,
        title: check.title,
        gear: check.gear.map(Member::name),
        formula: check.formula,
        outlines: check.outlines,
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

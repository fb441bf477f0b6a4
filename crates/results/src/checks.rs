//! The checks of a pair as a judged file, and the contact map as CSV.

use crate::check::{CheckRow, unit};
use crate::column::Row;
use crate::extreme::{extremes, verdict_record};
use crate::fitted;
use crate::judged::{Case, Judged, VERDICT};
use crate::layout::Screen;
use crate::remedies::RemedyRecords;
use crate::run::contact_count;
use crate::text::check::{governing, text};
use crate::verdict::lines;
use gearlash::analysis::backlash_map::BacklashMap;
use gearlash::analysis::diagnosis::{self, Check, Diagnosis, Map as ContactMap};
use gearlash::analysis::verdict::Verdict;
use gearlash_files::PairFile;
use gearlash_files::characters::csv_text;
use gearlash_files::numbers::fixed;
use serde_json::json;

/// The outcome of `check` for the pair of `file`, called `name`; `is_proven`: all its poses are proven. Its text is for `screen`.
pub fn checked(
    name: &str,
    file: &PairFile,
    diagnosis: &Diagnosis,
    verdict: &Verdict,
    remedies: &RemedyRecords,
    is_proven: bool,
    screen: &Screen,
) -> Judged {
    let checks = diagnosis.verdict() < diagnosis::Verdict::Unproven;
    let passes = is_proven && checks && verdict.passes();
    let lines = lines(verdict);
    let state = if verdict.passes() {
        diagnosis::Verdict::Pass
    } else {
        verdict.state().max(diagnosis::Verdict::Unproven)
    };
    let (proof, of_poses) = if is_proven {
        (diagnosis::Verdict::Pass, "all poses are proven")
    } else {
        let doubt = "some poses are not proven, or methods disagree";
        (diagnosis::Verdict::Unproven, doubt)
    };
    let mut cases = vec![
        Case::new(VERDICT, state, lines.to_string()),
        Case::new("poses", proof, of_poses.to_owned()),
    ];
    cases.extend(check_cases(diagnosis));
    let groups = || diagnosis.groups.iter();
    let checks = groups().flat_map(|group| {
        let checks = group.checks.iter();
        checks.map(|check| json!(CheckRow::columns().object(&CheckRow::new(group, check, true))))
    });
    let runs = groups().map(|group| {
        json!({
            "center_distance_mm": group.assembly.center_distance(),
            "material": group.material.name(),
            "contact": contact_count(&group.contact),
        })
    });
    let mut json = json!({ "file": name, "passed": passes, "pair": file.spec });
    let fitted = fitted::records(file);
    if !fitted.is_empty() {
        json["fitted_involutes"] = json!(fitted);
    }
    for (key, words) in [("warnings", &file.warnings), ("remarks", &file.remarks)] {
        if !words.is_empty() {
            json[key] = json!(words);
        }
    }
    json["verdict"] = verdict_record(verdict);
    json["extremes"] = extremes(verdict).into();
    json["checks_verdict"] = diagnosis.verdict().name().into();
    json["checks"] = checks.collect();
    json["contact"] = contact_count(&diagnosis.contact);
    json["runs"] = runs.collect();
    json["remedies"] = json!(remedies.changes);
    if !remedies.missing.is_empty() {
        json["remedies_missing"] = json!(remedies.missing);
    }
    Judged {
        file: name.to_owned(),
        title: file.study.title.clone(),
        passes,
        cases,
        warnings: file.warnings.to_vec(),
        remarks: file.remarks.to_vec(),
        way_out: (!remedies.changes.is_empty())
            .then(|| format!("Run gearlash check {name} for changes that make it fit.")),
        text: text(file, verdict, diagnosis, remedies, screen),
        markdown: String::new(),
        json,
        verdict: lines,
    }
}

/// A case for each check; one with a value for each gear has the worse outcome.
fn check_cases(diagnosis: &Diagnosis) -> Vec<Case> {
    let each = governing(diagnosis);
    let cases = each
        .chunk_by(|one, other| one.1.id == other.1.id)
        .map(|of_check| {
            let verdict = of_check.iter().map(|(_, check)| check.verdict).max();
            let verdict = verdict.unwrap_or(diagnosis::Verdict::Pass);
            // A gear that passes is not named beside one that does not.
            let told = of_check.iter().filter(|(_, check)| {
                check.verdict != diagnosis::Verdict::Pass || verdict == diagnosis::Verdict::Pass
            });
            let messages: Vec<String> = told.map(|(_, check)| message(check, verdict)).collect();
            let title = of_check.first().map_or("", |(_, check)| check.title);
            Case::new(title, verdict, messages.join(";\n"))
        });
    cases.collect()
}

/// The numbers of `check`; its outcome only where it is not `verdict`, the case's.
fn message(check: &Check, verdict: diagnosis::Verdict) -> String {
    let value = |value: Option<f64>| fixed(value, 4);
    let outlines = match (&check.unproven, check.outlines) {
        (Some(_), None) => "unproven".to_owned(),
        (_, outlines) => value(outlines),
    };
    let gear = check
        .gear
        .map_or(String::new(), |gear| format!("{}: ", gear.name()));
    let outcome = if check.verdict == verdict {
        String::new()
    } else {
        format!("{}: ", check.verdict.name())
    };
    let note = if check.note.is_empty() {
        String::new()
    } else {
        format!("; {}", check.note)
    };
    let numbers = format!(
        "{gear}{outcome}formula {}, outlines {outlines}, limit {} {}",
        value(check.formula),
        value(check.limit),
        unit(check.unit)
    );
    format!("{}{note}", numbers.trim_end())
}

/// `map` of a drawn pair as CSV, one row per cell with its pose.
///
/// # Errors
/// None: the text is in memory.
pub fn backlash_map_csv(map: &BacklashMap) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "center_distance_mm",
        "pitches",
        "wheel_tooth",
        "pinion_tooth",
        "fraction",
        "status",
        "j_wt_um",
    ])?;
    let rows = map.distances.iter();
    for (a, cells) in rows.zip(map.cells.chunks(map.columns.max(1))) {
        for cell in cells {
            let j_wt = cell.backlash.map(|mm| (mm * 1e3).to_string());
            writer.write_record([
                &a.to_string(),
                &cell.pitches.to_string(),
                &cell.mating.wheel_tooth.to_string(),
                &cell.mating.pinion_tooth.to_string(),
                &cell.mating.fraction.to_string(),
                cell.status.name(),
                &j_wt.unwrap_or_default(),
            ])?;
        }
    }
    csv_text(writer)
}

/// `map` as CSV, one row per pose.
///
/// # Errors
/// None: the text is in memory.
pub fn map_csv(map: &ContactMap) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["center_distance_mm", "fraction", "class", "j_wt_um"])?;
    let distances = map.distances.iter();
    let places = distances.flat_map(|a| map.fractions.iter().map(move |fraction| (a, fraction)));
    for ((a, fraction), cell) in places.zip(&map.cells) {
        let j_wt = cell.backlash.map(|mm| (mm * 1e3).to_string());
        writer.write_record([
            &a.to_string(),
            &fraction.to_string(),
            cell.class.name(),
            &j_wt.unwrap_or_default(),
        ])?;
    }
    csv_text(writer)
}

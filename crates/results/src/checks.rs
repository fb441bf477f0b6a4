//! The checks of a pair: their rows, their outcome as a judged file, and their text.

use crate::assembly_state::distinct;
use crate::column::{PeopleColumn, Row, Value, row_type, shown};
use crate::judged::{Case, Judgement, VERDICT};
use crate::layout::{Screen, Tone};
use crate::notes::{self, drawn_notes};
use crate::remedies::RemedyRecords;
use crate::run::{contact_count, extremes, verdict_record};
use crate::verdict::{self, heading, lines, short_title};
use gearlash::analysis::backlash_map::{BacklashCell, BacklashMap};
use gearlash::analysis::diagnosis::{
    Check, CheckVerdict, CheckedPair, Diagnosis, Map as ContactMap, MapCell,
};
use gearlash::analysis::verdict::{RequirementOutcome, Verdict};
use gearlash::pair::Member;
use gearlash_input::PairFile;
use gearlash_text::numbers::{ascii, fixed, stated_distance, um_ascii};
use serde_json::json;
use std::fmt::Write;

/// A check at one centre distance and material.
#[derive(Debug)]
pub(crate) struct CheckRow {
    center_distance: f64,
    material: &'static str,
    /// Whether the pair has several centre distances or materials, so that tables for people must show this one.
    is_of_several: bool,
    check: Check,
}

impl CheckRow {
    /// The row of a `check` of `group`; `is_of_several`: the pair has several groups.
    pub fn new(group: &CheckedPair, check: &Check, is_of_several: bool) -> CheckRow {
        CheckRow {
            center_distance: group.assembly.center_distance(),
            material: group.material.name(),
            is_of_several,
            check: check.clone(),
        }
    }

    /// `value`, shown to people where there are several groups.
    fn of_several(&self, value: impl Into<Value>) -> Value {
        Value::optional(self.is_of_several.then_some(value))
    }

    fn details(&self) -> Value {
        let details = self.check.details.iter();
        let details = details.map(|(name, value)| ((*name).to_owned(), (*value).into()));
        Value::Json(serde_json::Value::Object(details.collect()))
    }

    /// The value on the outlines, as shown to people.
    fn outlines_value(&self) -> Value {
        match (&self.check.unproven, self.check.outlines) {
            (Some(_), None) => "unproven".into(),
            (_, value) => value.into(),
        }
    }
}

row_type!(row: CheckRow {
    "" Severity [heading(shown("verdict"))] => row.check.verdict.name();
    "id" Plain => row.check.id;
    "title" Plain [heading(shown("check").left().broken())] => row.check.title;
    "gear" Plain => row.check.gear.map(Member::name);
    "" Plain [heading(shown("gear").left())] => row.check.gear.map_or("", Member::name);
    "" Distance [heading(shown("a mm").spare(2))] => row.of_several(row.center_distance);
    "" Plain [heading(shown("material").spare(2))] => row.of_several(row.material);
    "formula" Fixed(4) [heading(shown("formula").spare(1))] => row.check.formula;
    "outlines" Plain => row.check.outlines;
    "" Fixed(4) [heading(shown("outlines"))] => row.outlines_value();
    "limit" Fixed(4) [heading(shown("limit"))] => row.check.limit;
    "margin" Fixed(4) [heading(shown("margin"))] => row.check.margin;
    "unit" Plain => row.check.unit;
    "" Plain [heading(shown("").left())] => unit(row.check.unit);
    "verdict" Plain => row.check.verdict.name();
    "center_distance_mm" Plain => row.center_distance;
    "material" Plain => row.material;
    "details" Plain => row.details();
    "note" Plain [heading(shown("").left().below())] => row.check.note.clone();
    "unproven" Plain => Value::optional(row.check.unproven.clone());
});

/// A sentence that defines the margin of a check.
pub const MARGIN: &str = "Margin: to the limit, from the worse of formula and outlines; of centre distances, from the outlines. A negative one misses it.";

/// The unit of a check, as shown to people.
fn unit(unit: &'static str) -> &'static str {
    if unit == "1" { "" } else { unit }
}

/// The outcome of `check` for the pair of `file`, called `name`; `is_proven`: all its poses are proven. Its text is for `screen`.
pub fn checked(
    name: &str,
    file: &PairFile,
    diagnosis: &Diagnosis,
    verdict: &Verdict,
    remedies: &RemedyRecords,
    is_proven: bool,
    screen: &Screen,
) -> Judgement {
    let checks = diagnosis.verdict() < CheckVerdict::Unproven;
    let passes = is_proven && checks && verdict.passes();
    let lines = lines(verdict);
    let state = if verdict.passes() {
        CheckVerdict::Pass
    } else {
        verdict.state().max(CheckVerdict::Unproven)
    };
    let (proof, of_poses) = if is_proven {
        (CheckVerdict::Pass, "all poses are proven")
    } else {
        let doubt = "some poses are not proven, or methods disagree";
        (CheckVerdict::Unproven, doubt)
    };
    let message = verdict::message(verdict) + "\n" + &remedies.text(verdict);
    let mut cases = vec![
        Case::new(VERDICT, state, message.trim_end().to_owned()),
        Case::new("poses", proof, of_poses.to_owned()),
    ];
    cases.extend(check_cases(diagnosis));
    let checks = diagnosis.groups.iter().flat_map(|group| {
        let checks = group.checks.iter();
        checks.map(|check| CheckRow::new(group, check, true).json())
    });
    let runs = diagnosis.groups.iter().map(|group| {
        json!({
            "center_distance_mm": group.assembly.center_distance(),
            "material": group.material.name(),
            "contact": contact_count(&group.contact),
        })
    });
    let mut json = json!({ "file": name, "passed": passes, "pair": file.spec });
    for (key, notes) in notes::entries(file) {
        json[key] = notes;
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
    Judgement {
        file: name.to_owned(),
        title: file.study.title.clone(),
        passes,
        cases,
        warnings: file.warnings.to_vec(),
        remarks: file.remarks.to_vec(),
        hint: (!remedies.changes.is_empty())
            .then(|| format!("Run gearlash check {name} for changes that make it fit.")),
        text: text(file, verdict, diagnosis, remedies, screen),
        markdown: String::new(),
        json,
        verdict: lines,
        misses_limit: verdict.misses_limit(),
    }
}

/// A case for each check; one with a value for each gear has the worse outcome.
fn check_cases(diagnosis: &Diagnosis) -> Vec<Case> {
    let each = governing(diagnosis);
    let cases = each
        .chunk_by(|one, other| one.1.id == other.1.id)
        .map(|of_check| {
            let verdict = of_check.iter().map(|(_, check)| check.verdict).max();
            let verdict = verdict.unwrap_or(CheckVerdict::Pass);
            // A gear that passes is not named beside one that does not.
            let told = of_check.iter().filter(|(_, check)| {
                check.verdict != CheckVerdict::Pass || verdict == CheckVerdict::Pass
            });
            let messages: Vec<String> = told.map(|(_, check)| message(check, verdict)).collect();
            let title = of_check.first().map_or("", |(_, check)| check.title);
            Case::new(title, verdict, messages.join(";\n"))
        });
    cases.collect()
}

/// The numbers of `check`; its outcome only where it is not `verdict`, the case's.
fn message(check: &Check, verdict: CheckVerdict) -> String {
    let value = |value: Option<f64>| fixed(value, 4);
    let outlines = match (&check.unproven, check.outlines) {
        (Some(_), None) => "unproven".to_owned(),
        (_, outlines) => value(outlines),
    };
    let mut text = String::new();
    if let Some(gear) = check.gear {
        text += &format!("{}: ", gear.name());
    }
    if check.verdict != verdict {
        text += &format!("{}: ", check.verdict.name());
    }
    text += &format!(
        "formula {}, outlines {outlines}, limit {} {}",
        value(check.formula),
        value(check.limit),
        unit(check.unit)
    );
    text.truncate(text.trim_end().len());
    if !check.note.is_empty() {
        text += &format!("; {}", check.note);
    }
    text
}

/// The checks as text on `screen`: each once, at its worst centre distance and material.
pub fn text(
    file: &PairFile,
    verdict: &Verdict,
    diagnosis: &Diagnosis,
    remedies: &RemedyRecords,
    screen: &Screen,
) -> String {
    let lines = lines(verdict);
    let remedies = remedies.text(verdict);
    let mut text = heading(&file.study.title, &lines, screen);
    if diagnosis.groups.is_empty() {
        for sentence in &lines.left_out {
            let _ = writeln!(text, "Note: {sentence}.\n");
        }
        return screen.fold(&(text + &drawn_notes(file) + &remedies));
    }
    text += &CheckRow::columns().text(&rows(diagnosis), screen);
    let _ = writeln!(text, "\n{MARGIN}");
    if diagnosis.groups.len() > 1 {
        text += "Each check is shown at its worst centre distance and material; --format json has all.\n";
    }
    for reason in check_doubts(diagnosis) {
        let word = screen.toned(Tone::Doubtful, "UNPROVEN");
        let _ = writeln!(text, "\n{word}: {reason}.");
    }
    for sentence in &lines.left_out {
        let _ = writeln!(text, "\nNote: {sentence}.");
    }
    text += &contact(diagnosis, verdict.requirement);
    text += &remedies;
    screen.fold(&text)
}

/// One row per check, for its worst centre distance and material.
fn rows(diagnosis: &Diagnosis) -> Vec<CheckRow> {
    let several = diagnosis.groups.len() > 1;
    let rows = governing(diagnosis).into_iter();
    rows.map(|(group, check)| CheckRow::new(group, check, several))
        .collect()
}

/// The table of checks for a page.
pub fn table(diagnosis: &Diagnosis) -> Vec<PeopleColumn> {
    CheckRow::columns().in_um(&rows(diagnosis))
}

/// The worst occurrence of each check: worst verdict, then greatest loss of backlash where it has one, then least margin, then the
/// first.
fn governing(diagnosis: &Diagnosis) -> Vec<(&CheckedPair, &Check)> {
    let mut governing: Vec<(&CheckedPair, &Check)> = Vec::new();
    for group in &diagnosis.groups {
        for check in &group.checks {
            let same = |known: &&mut (&CheckedPair, &Check)| {
                known.1.id == check.id && known.1.gear == check.gear
            };
            match governing.iter_mut().find(same) {
                None => governing.push((group, check)),
                Some(known) if governs(check, known.1) => *known = (group, check),
                Some(_) => {}
            }
        }
    }
    governing
}

/// Whether `check` is worse than the same check elsewhere.
fn governs(check: &Check, known: &Check) -> bool {
    if check.verdict != known.verdict {
        return check.verdict > known.verdict;
    }
    // A loss in µm; those that differ by rounding are equal.
    let [loss, known_loss] = [check, known].map(|check| {
        let mut details = check.details.iter();
        let loss = details.find(|(name, _)| *name == "worst_loss_um");
        loss.map_or(0.0, |(_, loss)| *loss)
    });
    let more = loss - known_loss;
    more > 1e-6 || more > -1e-6 && check.margin < known.margin
}

fn contact(diagnosis: &Diagnosis, requirement: RequirementOutcome) -> String {
    let count = &diagnosis.contact;
    let classes = count.classes.iter();
    let classes = classes.map(|(class, poses)| format!("{} {poses}", class.name()));
    let classes: Vec<String> = classes.collect();
    let mut text = format!("\n{} poses: {}.\n", count.poses(), classes.join(", "));
    if let Some(loss) = &count.loss {
        let (worst, mating) = (&loss.worst, loss.worst.pose.mating());
        let (wheel, pinion) = (&worst.contact.wheel, &worst.contact.pinion);
        let _ = writeln!(
            text,
            "Backlash j_wt by formula less that on the outlines: {} to {} µm, {} µm on average.",
            um_ascii(loss.least, 3),
            um_ascii(worst.loss, 3),
            um_ascii(loss.mean, 3),
        );
        // A loss that prints as 0.000 µm does not count.
        if worst.loss >= 5e-7 {
            let _ = writeln!(
                text,
                "Largest loss at mating {},{} {} +{}, a {} mm, {}: formula {} µm, outlines {} µm; wheel tooth {} {} (radius {} mm) on pinion tooth {} {} (radius {} mm), {} flanks.",
                mating.wheel_tooth,
                mating.pinion_tooth,
                mating.flank.name(),
                ascii(mating.fraction, 4),
                stated_distance(worst.assembly.center_distance()),
                worst.material.words(),
                um_ascii(worst.backlash + worst.loss, 3),
                um_ascii(worst.backlash, 3),
                wheel.tooth,
                wheel.curve.name(),
                ascii(wheel.radius, 3),
                pinion.tooth,
                pinion.curve.name(),
                ascii(pinion.radius, 3),
                worst.side.name(),
            );
        }
    }
    text + &format!("{}\n", outcome(diagnosis, requirement))
}

/// The distinct short titles of the checks with this verdict.
pub fn titles(diagnosis: &Diagnosis, verdict: CheckVerdict) -> Vec<&'static str> {
    let checks = governing(diagnosis).into_iter().map(|(_, check)| check);
    let checks = checks.filter(|check| check.verdict == verdict);
    distinct(checks.map(|check| short_title(check.title)))
}

/// The number of failing or unproven checks, and their titles. Where none fails, a limit that is not kept is named beside.
fn outcome(diagnosis: &Diagnosis, requirement: RequirementOutcome) -> String {
    let all = distinct(governing(diagnosis).iter().map(|(_, check)| check.title)).len();
    let named = |count: &str, titles: &[&str]| {
        format!(
            "{} of {all} checks {count}, counted by title: {}.",
            titles.len(),
            titles.join(", ")
        )
    };
    let [failed, unproven] =
        [CheckVerdict::Fail, CheckVerdict::Unproven].map(|verdict| titles(diagnosis, verdict));
    match (&failed[..], &unproven[..]) {
        ([], []) => match requirement {
            RequirementOutcome::None | RequirementOutcome::Met => "No check fails.",
            RequirementOutcome::NotMet => "No check fails, but a requirement is not met.",
            RequirementOutcome::NotProven => "No check fails, but a requirement is not proven.",
        }
        .to_owned(),
        ([], unproven) => named("are unproven", unproven),
        ([_], _) => named("fails", &failed),
        (_, _) => named("fail", &failed),
    }
}

/// The distinct reasons why checks are not proven.
pub fn check_doubts(diagnosis: &Diagnosis) -> Vec<&str> {
    let checks = diagnosis.groups.iter().flat_map(|group| &group.checks);
    distinct(checks.filter_map(|check| check.unproven.as_deref()))
}

// A cell of a map of backlash, with its centre distance, mm.
row_type!(row: (f64, BacklashCell) {
    "center_distance_mm" Plain => row.0;
    "pitches" Plain => row.1.pitches;
    "wheel_tooth" Plain => row.1.mating.wheel_tooth;
    "pinion_tooth" Plain => row.1.mating.pinion_tooth;
    "fraction" Plain => row.1.mating.fraction;
    "status" Plain => row.1.status.name();
    "j_wt_um" Plain => Value::um(row.1.backlash);
});

/// `map` of a drawn pair as CSV, one row per cell with its pose.
pub fn backlash_map_csv(map: &BacklashMap) -> String {
    let rows = map.cells.chunks(map.columns.max(1));
    let cells = map.distances.iter().zip(rows);
    let cells = cells.flat_map(|(a, cells)| cells.iter().map(|cell| (*a, *cell)));
    Row::columns().csv(&cells.collect::<Vec<_>>())
}

// A cell of a map of contacts, with its centre distance, mm, and its fraction of a pitch.
row_type!(row: (f64, f64, MapCell) {
    "center_distance_mm" Plain => row.0;
    "fraction" Plain => row.1;
    "class" Plain => row.2.class.name();
    "j_wt_um" Plain => Value::um(row.2.backlash);
});

/// `map` as CSV, one row per pose.
pub fn map_csv(map: &ContactMap) -> String {
    let places = map.distances.iter();
    let places = places.flat_map(|a| map.fractions.iter().map(move |fraction| (*a, *fraction)));
    let rows = places.zip(&map.cells);
    let rows = rows.map(|((a, fraction), cell)| (a, fraction, *cell));
    Row::columns().csv(&rows.collect::<Vec<_>>())
}

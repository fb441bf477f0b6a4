//! The checks of a pair as text.

use crate::check::CheckRow;
use crate::column::{Row, Shown};
use crate::fitted::drawn_notes;
use crate::layout::{Screen, Tone};
use crate::remedies::RemedyRecords;
use crate::verdict::{heading, lines, short_title};
use gearlash::analysis::diagnosis::{Check, Diagnosis, Group, Verdict};
use gearlash::analysis::verdict::Verdict as CycleVerdict;
use gearlash::pair::BacklashUnit;
use gearlash_files::PairFile;
use gearlash_files::numbers::{ascii, stated_distance, um_ascii};
use std::fmt::Write;

/// The checks as text on `screen`: each once, at its worst centre distance and material.
pub fn text(
    file: &PairFile,
    verdict: &CycleVerdict,
    diagnosis: &Diagnosis,
    remedies: &RemedyRecords,
    screen: &Screen,
) -> String {
    let lines = lines(verdict);
    let remedies = remedies.text(!file.study.requirements.is_empty());
    let mut text = heading(&file.study.title, &lines, screen);
    if diagnosis.groups.is_empty() {
        for sentence in &lines.left_out {
            let _ = writeln!(text, "{sentence}.\n");
        }
        return screen.fold(&(text + &drawn_notes(file) + &remedies));
    }
    text += &CheckRow::columns().text(&rows(diagnosis), screen);
    if diagnosis.groups.len() > 1 {
        text += "\nEach check is shown at its worst centre distance and material; --format json has all.\n";
    }
    for reason in doubts(diagnosis) {
        let word = screen.toned(Tone::Doubtful, "UNPROVEN");
        let _ = writeln!(text, "\n{word}: {reason}.");
    }
    for sentence in &lines.left_out {
        let _ = writeln!(text, "\n{sentence}.");
    }
    text += &contact(diagnosis);
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
pub fn shown(diagnosis: &Diagnosis) -> Vec<Shown> {
    CheckRow::columns().shown(&rows(diagnosis), |_| f64::NAN, BacklashUnit::Um)
}

/// The worst occurrence of each check: worst verdict, then least margin, then the first.
pub(crate) fn governing(diagnosis: &Diagnosis) -> Vec<(&Group, &Check)> {
    let mut governing: Vec<(&Group, &Check)> = Vec::new();
    for group in &diagnosis.groups {
        for check in &group.checks {
            let same = |known: &&mut (&Group, &Check)| {
                known.1.id == check.id && known.1.gear == check.gear
            };
            match governing.iter_mut().find(same) {
                None => governing.push((group, check)),
                Some(known) => {
                    let graver = check.verdict > known.1.verdict;
                    let closer = check.verdict == known.1.verdict && check.margin < known.1.margin;
                    if graver || closer {
                        *known = (group, check);
                    }
                }
            }
        }
    }
    governing
}

fn contact(diagnosis: &Diagnosis) -> String {
    let count = &diagnosis.contact;
    let classes = count.classes.iter();
    let classes = classes.map(|(class, poses)| format!("{} {poses}", class.name()));
    let classes: Vec<String> = classes.collect();
    let mut text = format!("\n{} poses: {}.\n", count.poses(), classes.join(", "));
    if let Some(loss) = &count.loss {
        let worst = &loss.worst;
        let mating = worst.pose.mating();
        let _ = writeln!(
            text,
            "Backlash j_wt by formula minus that on the outlines: least {}, mean {}, greatest {} µm.",
            um_ascii(loss.least, 3),
            um_ascii(loss.mean, 3),
            um_ascii(worst.loss, 3),
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
                worst.material.name(),
                um_ascii(worst.backlash + worst.loss, 3),
                um_ascii(worst.backlash, 3),
                worst.contact.wheel.tooth,
                worst.contact.wheel.curve.name(),
                ascii(worst.contact.wheel.radius, 3),
                worst.contact.pinion.tooth,
                worst.contact.pinion.curve.name(),
                ascii(worst.contact.pinion.radius, 3),
                worst.side.name(),
            );
        }
    }
    text + &format!("{}\n", outcome(diagnosis))
}

/// The distinct short titles of the checks with this verdict.
pub fn titles(diagnosis: &Diagnosis, verdict: Verdict) -> Vec<&'static str> {
    let mut titles: Vec<&str> = Vec::new();
    for (_, check) in governing(diagnosis) {
        let title = short_title(check.title);
        if check.verdict == verdict && !titles.contains(&title) {
            titles.push(title);
        }
    }
    titles
}

/// The number of failing or unproven checks, and their titles.
pub(crate) fn outcome(diagnosis: &Diagnosis) -> String {
    let checks = governing(diagnosis);
    let all = each_title(&checks);
    let named = |count: &str, titles: &[&str]| {
        format!(
            "{} of {all} checks {count}: {}.",
            titles.len(),
            titles.join(", ")
        )
    };
    let [failed, unproven] =
        [Verdict::Fail, Verdict::Unproven].map(|verdict| titles(diagnosis, verdict));
    match (&failed[..], &unproven[..]) {
        ([], []) => "No check fails.".to_owned(),
        ([], unproven) => named("are unproven", unproven),
        ([_], _) => named("fails", &failed),
        (_, _) => named("fail", &failed),
    }
}

/// The number of checks; those of both gears count once.
fn each_title(checks: &[(&Group, &Check)]) -> usize {
    let mut titles: Vec<&str> = checks.iter().map(|(_, check)| check.title).collect();
    titles.sort_unstable();
    titles.dedup();
    titles.len()
}

/// The distinct reasons why checks are not proven.
pub fn doubts(diagnosis: &Diagnosis) -> Vec<&str> {
    let checks = diagnosis.groups.iter().flat_map(|group| &group.checks);
    let mut doubts = Vec::new();
    for reason in checks.filter_map(|check| check.unproven.as_deref()) {
        if !doubts.contains(&reason) {
            doubts.push(reason);
        }
    }
    doubts
}

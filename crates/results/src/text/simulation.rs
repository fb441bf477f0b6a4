//! The result as text for a terminal. Lengths in µm unless the heading says mm.

use super::measured::{measured_count, measured_table};
use super::phases::phase_table;
use crate::column::Row;
use crate::doubts;
use crate::layout::{Screen, Tone, pose_label};
use crate::pose::PoseRow;
use crate::run::RunRow;
use crate::unit;
use crate::verdict::{heading, lines};
use gearlash::analysis::measured::MeasuredMating;
use gearlash::analysis::phases::phase_groups;
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{MOST_LISTED, RunTally};
use gearlash::analysis::verdict::Verdict;
use gearlash::gear::Hand;
use gearlash::pair::{BacklashUnit, Member};
use gearlash_files::numbers::{stated_distance, trimmed};

/// The text that `simulate` prints on `screen`, backlash in `unit`.
pub fn simulation(
    study: &Study,
    verdict: &Verdict,
    runs: &[RunTally],
    measured: &[MeasuredMating],
    unit: BacklashUnit,
    screen: &Screen,
) -> String {
    let mut asked = verdict.clone();
    if let BacklashUnit::Arcmin { at, .. } = unit {
        asked.lost_motion_of = Some(at);
    }
    let mut text = heading(&study.title, &lines(&asked), screen);
    if !measured.is_empty() {
        text += &measured_table(measured, unit, screen);
        text += &measured_count(study, measured, unit, screen);
        text.push('\n');
    }
    let poses: usize = runs.iter().map(|run| run.poses).sum();
    if measured.is_empty() && poses <= MOST_LISTED {
        text += &pose_table(runs, unit, screen);
        text.push('\n');
    }
    let groups = phase_groups(runs);
    if groups.is_empty() {
        text += &listed_note(study);
        text += &run_table(study, runs, unit, screen);
        let has_formulas = runs.iter().any(|run| run.evidence.is_some());
        let models = if has_formulas { MODELS } else { "" };
        let of = unit::measure(unit);
        text += &screen.paragraphs(&format!(
            "{of}{AT}{models} Negative backlash: interference."
        ));
    }
    for group in &groups {
        text += &phase_table(group, unit, screen);
    }
    text += &helical_note(study, runs, screen);
    text += &off_line_note(runs);
    text += &unproven_note(runs, screen);
    screen.fold(&text)
}

/// A note on helical gears: the section of each value, and the face of the result.
fn helical_note(study: &Study, runs: &[RunTally], screen: &Screen) -> String {
    let helical = |run: &RunTally| Some(run.assembly.data()?.gear(Member::Wheel).gear().clone());
    let wheel = runs.iter().find(|run| run.assembly.is_helical());
    let Some(wheel) = wheel.and_then(helical) else {
        return String::new();
    };
    let data = wheel.basic_data();
    let hand = match data.hand() {
        Some(Hand::Left) => "left",
        _ => "right",
    };
    let [from, to] = study.face.map(|end| trimmed(end, 0, 3));
    screen.paragraphs(&format!(
        "Helical, β {}°, wheel {hand}-hand, over the common face {from} … {to} mm from the measuring plane. Module, pressure angle, profile shift, \
         rack and thickness are those of the normal section, j_wt is of the transverse one.",
        trimmed(data.helix_angle().to_degrees(), 0, 6)
    ))
}

/// A note on the poses of the rows below, where they could be mistaken for the whole cycle.
fn listed_note(study: &Study) -> String {
    let of = if study.sweeps() {
        "Of the poses swept"
    } else {
        "Of the listed poses"
    };
    format!("{of} (the verdict above is of the whole mesh cycle):\n")
}

const AT: &str = ", simulated; \"at\": mating, fraction of a pitch beyond it, flank.";
const MODELS: &str =
    " Off model 2, 3: largest difference to the involute and to the line-of-action formula.";

fn pose_table(runs: &[RunTally], unit: BacklashUnit, screen: &Screen) -> String {
    let rows = runs.iter().flat_map(|run| {
        let poses = run.listed.iter();
        poses.map(move |pose| PoseRow::of_run(run, pose))
    });
    let rows: Vec<PoseRow> = rows.collect();
    PoseRow::columns().table(&rows, PoseRow::center_distance, unit, screen)
}

fn run_table(study: &Study, runs: &[RunTally], unit: BacklashUnit, screen: &Screen) -> String {
    let rows = runs.iter();
    let rows = rows.map(|run| RunRow::new(run, study.bearing_clearance));
    let rows: Vec<RunRow> = rows.collect();
    RunRow::columns().table(&rows, RunRow::center_distance, unit, screen)
}

fn off_line_note(runs: &[RunTally]) -> String {
    let total: usize = runs.iter().map(|run| run.poses).sum();
    let less: usize = runs.iter().map(|run| run.compared_off_line).sum();
    let alone: usize = runs.iter().map(RunTally::simulated_alone).sum();
    let mut text = String::new();
    if less > 0 {
        text += &format!(
            "\nIn {less} of {total} poses a tooth corner, fillet or root touches off the line of action: the pair has less backlash there than model 3 says.\n"
        );
    }
    if alone > 0 {
        text += &format!(
            "\nIn {alone} of {total} poses no two involutes reach each other on the line of action: model 3 has no value there.\n"
        );
    }
    text
}

/// Most poses that are listed individually (tuned: a screen).
const MOST_NAMED: usize = 10;

/// The number of unproven poses of `runs`, and the first of them, one per line; empty where all are proven.
fn unproven_note(runs: &[RunTally], screen: &Screen) -> String {
    let poses: usize = runs.iter().map(|run| run.poses).sum();
    let count: usize = runs.iter().map(|run| run.unproven).sum();
    let first = runs.iter().flat_map(|run| {
        let poses = run.first_unproven.iter();
        poses.map(move |pose| (run, pose))
    });
    if count == 0 {
        return String::new();
    }
    let mut text = format!(
        "\n{}: {count} of {poses} poses. No number above includes them; whether the pair \
         has backlash there is not known.\n",
        screen.toned(Tone::Doubtful, "UNPROVEN")
    );
    for (run, pose) in first.take(MOST_NAMED) {
        text += &format!(
            "  a = {} mm, {}, {}: {}\n",
            stated_distance(run.assembly.center_distance()),
            run.material.name(),
            pose_label(pose),
            doubts(pose)
        );
    }
    if count > MOST_NAMED {
        let more = count - MOST_NAMED;
        text += &format!("  … and {more} more: --format json has all\n");
    }
    text
}

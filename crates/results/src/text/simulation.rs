//! The result as text for a terminal. Lengths in µm unless the heading says mm.

use super::layout::{Column, Screen, Table, Tone, where_it_is};
use super::measured::{measured_count, measured_table};
use super::phases::phase_table;
use super::unit;
use super::verdict::first_lines;
use crate::doubts;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::measured::MeasuredMating;
use gearlash::analysis::phases::phase_groups;
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{MOST_LISTED, RunTally};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::{Contact, Status};
use gearlash::gear::Hand;
use gearlash::pair::{BacklashUnit, Member};
use gearlash_files::numbers::{NONE, stated_distance, trimmed};

/// The text `simulate` prints on `screen`, backlash in `unit`.
pub fn simulation(
    study: &Study,
    verdict: &Verdict,
    runs: &[RunTally],
    measured: &[MeasuredMating],
    unit: BacklashUnit,
    screen: &Screen,
) -> String {
    let mut text = first_lines(&study.title, verdict, screen);
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
        text += &listed(study);
        text += &run_table(study, runs, unit, screen);
        text += &screen.paragraphs(&format!("{}{RUN_LEGEND}", unit::measure(unit)));
    }
    for group in &groups {
        text += &phase_table(group, unit, screen);
    }
    text += &helical_note(study, runs, screen);
    text += &off_line_note(runs);
    text += &unproven_note(runs, screen);
    screen.fold(&text)
}

/// Of helical gears: which section each of their data is of, and over which face the result holds.
fn helical_note(study: &Study, runs: &[RunTally], screen: &Screen) -> String {
    let Some(run) = runs.iter().find(|run| run.assembly.is_helical()) else {
        return String::new();
    };
    let data = run.assembly.gear(Member::Wheel).gear().basic_data();
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

/// What the rows below are of, where it could be taken for the whole cycle.
fn listed(study: &Study) -> String {
    let of = match study.sweeps() {
        true => "Of the poses swept",
        false => "Of the listed poses",
    };
    format!("{of} (the verdict above is of the whole mesh cycle):\n")
}

const RUN_LEGEND: &str = "\
, simulated; \"at\": mating, fraction of a pitch beyond it, flank. Off model 2, 3: largest \
difference to the involute and to the line-of-action formula. Negative backlash: interference.";

fn pose_table(runs: &[RunTally], unit: BacklashUnit, screen: &Screen) -> String {
    let mut table = Table::new([
        Column::new("a mm"),
        Column::new("material"),
        Column::new("mating"),
        Column::new("flank"),
        Column::new(match unit {
            BacklashUnit::Um => "j_wt".to_owned(),
            BacklashUnit::Arcmin { at, .. } => format!("{} arcmin", at.name()),
        }),
        Column::new("± bound").spare(6),
        Column::new("status"),
        Column::new("right contact").spare(3),
        Column::new("left contact").spare(2),
        Column::new("Michalec").spare(5),
        Column::new("involute").spare(4),
        Column::new("line of action").spare(1),
    ]);
    for run in runs {
        for pose in &run.listed {
            let mating = pose.simulated.pose.mating();
            let beyond = match mating.fraction {
                0.0 => String::new(),
                fraction => format!(" +{fraction}"),
            };
            let found = pose.simulated.backlash.and(pose.simulated.proven());
            let contact = |contact: Option<&Contact>| match contact {
                Some(contact) => format!(
                    "{},{} {}-{}",
                    contact.wheel.tooth,
                    contact.pinion.tooth,
                    contact.wheel.curve.name(),
                    contact.pinion.curve.name()
                ),
                None => NONE.to_owned(),
            };
            let a = run.assembly.center_distance();
            let cell = |j_wt| unit::cell(unit, j_wt, a, 3);
            table.add(vec![
                stated_distance(a),
                run.material.name().to_owned(),
                format!("{},{}{beyond}", mating.wheel_tooth, mating.pinion_tooth),
                mating.flank.name().to_owned(),
                cell(pose.simulated.backlash),
                unit::order(unit, pose.simulated.error_bound, a),
                status(pose.simulated.status(), screen),
                contact(found.and_then(|found| found.right.as_ref())),
                contact(found.and_then(|found| found.left.as_ref())),
                cell(pose.michalec),
                cell(pose.involute),
                cell(pose.line_of_action),
            ]);
        }
    }
    table.text(screen)
}

fn status(status: Status, screen: &Screen) -> String {
    match status {
        Status::Interference | Status::Jammed => screen.toned(Tone::Bad, status.name()),
        Status::Unproven => screen.toned(Tone::Doubtful, status.name()),
        Status::Clear | Status::NoContact => status.name().to_owned(),
    }
}

fn run_table(study: &Study, runs: &[RunTally], unit: BacklashUnit, screen: &Screen) -> String {
    let mut columns = vec![
        Column::new("a mm"),
        Column::new("material"),
        Column::new("poses").spare(5),
        Column::new(unit::column(unit, "least")),
        Column::new("at").broken(),
        Column::new(unit::column(unit, "mean")).spare(2),
        Column::new(unit::column(unit, "greatest")),
        Column::new("at").broken(),
    ];
    if study.bearing_clearance > 0.0 {
        let clearance = stated_distance(study.bearing_clearance);
        columns.push(Column::new(format!("a ± {clearance} mm")).spare(1));
    }
    columns.push(Column::new("off model 2").spare(4));
    columns.push(Column::new("off model 3").spare(3));
    let unproven = runs.iter().any(|run| run.unproven > 0);
    columns.extend(unproven.then(|| Column::new("unproven")));
    let mut table = Table::new(columns);
    for run in runs {
        let summary = run.summary();
        let at = |pose: Option<&ComparedPose>| pose.map_or(NONE.to_owned(), where_it_is);
        let (least, most) = run.extremes().unzip();
        let a = run.assembly.center_distance();
        let cell = |j_wt, a| unit::cell(unit, j_wt, a, 3);
        let mut row = vec![
            stated_distance(a),
            run.material.name().to_owned(),
            run.poses.to_string(),
            cell(summary.min, a),
            at(least),
            cell(summary.mean, a),
            cell(summary.max, a),
            at(most),
        ];
        if study.bearing_clearance > 0.0 {
            let [near, far] = summary.with_clearance;
            let c = study.bearing_clearance;
            let [near, far] = [(near, a - c), (far, a + c)];
            let end = |(j_wt, a)| unit::cell(unit, j_wt, a, 1);
            row.push(format!("{} … {}", end(near), end(far)));
        }
        row.extend([
            cell(summary.off_involute, a),
            cell(summary.off_line_of_action, a),
        ]);
        if unproven {
            row.push(run.unproven.to_string());
        }
        table.add(row);
    }
    table.text(screen)
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

/// Poses up to this many are listed one by one (tuned: a screen).
const MOST_NAMED: usize = 10;

/// How many poses of `runs` are not proven, and the first of them, each on a line; nothing where all are proven.
fn unproven_note(runs: &[RunTally], screen: &Screen) -> String {
    let poses: usize = runs.iter().map(|run| run.poses).sum();
    let count: usize = runs.iter().map(|run| run.unproven).sum();
    let of_run = |run| move |pose| (run, pose);
    let first = runs
        .iter()
        .flat_map(|run: &RunTally| run.first_unproven.iter().map(of_run(run)));
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
            where_it_is(pose),
            doubts(pose)
        );
    }
    if count > MOST_NAMED {
        text += &format!(
            "  … and {} more: --format json has all\n",
            count - MOST_NAMED
        );
    }
    text
}

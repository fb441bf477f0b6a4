//! The result as text for a terminal. Lengths in µm unless the heading says mm.

use super::layout::{Column, Screen, Table, Tone, where_it_is};
use super::measured::{measured_count, measured_table};
use super::phases::phase_table;
use super::verdict::first_lines;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::measured::MeasuredMating;
use gearlash::analysis::phases::phase_groups;
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{MOST_LISTED, RunTally};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::{Contact, Status};
use gearlash_files::numbers::{NONE, order_um, stated_distance, um_ascii};
use gearlash_files::results::doubts;

/// The text `simulate` prints on `screen`.
pub fn simulation(
    study: &Study,
    verdict: &Verdict,
    runs: &[RunTally],
    measured: &[MeasuredMating],
    screen: &Screen,
) -> String {
    let mut text = first_lines(&study.title, verdict, screen);
    if !measured.is_empty() {
        text += &measured_table(measured, screen);
        text += &measured_count(study, measured, screen);
        text.push('\n');
    }
    let poses: usize = runs.iter().map(|run| run.poses).sum();
    if measured.is_empty() && poses <= MOST_LISTED {
        text += &pose_table(runs, screen);
        text.push('\n');
    }
    let groups = phase_groups(runs);
    if groups.is_empty() {
        text += &listed(study);
        text += &run_table(study, runs, screen);
        text += &screen.paragraphs(RUN_LEGEND);
    }
    for group in &groups {
        text += &phase_table(group, screen);
    }
    text += &off_line_note(runs);
    text += &unproven_note(runs, screen);
    screen.fold(&text)
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
j_wt in µm, simulated; \"at\": mating, fraction of a pitch beyond it, flank. Off model 2, 3: largest \
difference to the involute and to the line-of-action formula. Negative backlash: interference.";

fn pose_table(runs: &[RunTally], screen: &Screen) -> String {
    let mut table = Table::new([
        Column::new("a mm"),
        Column::new("material"),
        Column::new("mating"),
        Column::new("flank"),
        Column::new("j_wt"),
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
            let mating = pose.swept.pose.mating();
            let beyond = match mating.fraction {
                0.0 => String::new(),
                fraction => format!(" +{fraction}"),
            };
            let found = pose.swept.backlash.and(pose.swept.proven());
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
            table.add(vec![
                stated_distance(run.assembly.center_distance()),
                run.material.name().to_owned(),
                format!("{},{}{beyond}", mating.wheel_tooth, mating.pinion_tooth),
                mating.flank.name().to_owned(),
                um_ascii(pose.swept.backlash, 3),
                pose.swept.error_bound.map_or(NONE.to_owned(), order_um),
                status(pose.swept.status(), screen),
                contact(found.and_then(|found| found.right.as_ref())),
                contact(found.and_then(|found| found.left.as_ref())),
                um_ascii(pose.michalec, 3),
                um_ascii(pose.involute, 3),
                um_ascii(pose.line_of_action, 3),
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

fn run_table(study: &Study, runs: &[RunTally], screen: &Screen) -> String {
    let mut columns = vec![
        Column::new("a mm"),
        Column::new("material"),
        Column::new("poses").spare(5),
        Column::new("least"),
        Column::new("at").broken(),
        Column::new("mean").spare(2),
        Column::new("greatest"),
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
        let mut row = vec![
            stated_distance(run.assembly.center_distance()),
            run.material.name().to_owned(),
            run.poses.to_string(),
            um_ascii(summary.min, 3),
            at(least),
            um_ascii(summary.mean, 3),
            um_ascii(summary.max, 3),
            at(most),
        ];
        if study.bearing_clearance > 0.0 {
            let [near, far] = summary.with_clearance;
            row.push(format!("{} … {}", um_ascii(near, 1), um_ascii(far, 1)));
        }
        row.extend([
            um_ascii(summary.off_involute, 3),
            um_ascii(summary.off_line_of_action, 3),
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

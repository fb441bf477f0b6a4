//! The result as text for a terminal. Lengths in µm unless the heading says mm.

use super::layout::{finish, table, where_it_is};
use super::measured::{measured_count, measured_table};
use super::phases::phase_table;
use gearlash::analysis::compare::{ComparedPose, Verdict};
use gearlash::analysis::measured::MeasuredMating;
use gearlash::analysis::phases::phase_groups;
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{MOST_LISTED, RunTally};
use gearlash::contact::Contact;
use gearlash_files::characters::plain;
use gearlash_files::numbers::{NONE, distance, order_um, um_ascii};
use gearlash_files::results::doubts;

/// The text `simulate` prints.
pub fn simulation(study: &Study, runs: &[RunTally], measured: &[MeasuredMating]) -> String {
    let mut text = format!("{}\n\n", plain(&study.title));
    if !measured.is_empty() {
        text += &measured_table(measured);
        text += &measured_count(study, measured);
        text.push('\n');
    }
    let poses: usize = runs.iter().map(|run| run.poses).sum();
    if measured.is_empty() && poses <= MOST_LISTED {
        text += &pose_table(runs);
        text.push('\n');
    }
    let groups = phase_groups(runs);
    if groups.is_empty() {
        text += &run_table(study, runs);
        text += RUN_LEGEND;
    }
    for group in &groups {
        text += &phase_table(group);
    }
    text += &off_line_note(runs);
    text += &unproven_note(runs);
    text
}

const RUN_LEGEND: &str = "\
j_wt in µm, simulated; \"at\": mating, fraction of a pitch beyond it, flank. Off model 2, 3: largest
difference to the involute and to the line-of-action formula. Negative backlash: interference.
";

fn pose_table(runs: &[RunTally]) -> String {
    let mut table = table(&[
        "a mm",
        "material",
        "mating",
        "flank",
        "j_wt",
        "± bound",
        "status",
        "right contact",
        "left contact",
        "Michalec",
        "involute",
        "line of action",
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
            table.add_row(vec![
                distance(run.assembly.center_distance()),
                run.material.name().to_owned(),
                format!("{},{}{beyond}", mating.wheel_tooth, mating.pinion_tooth),
                mating.flank.name().to_owned(),
                um_ascii(pose.swept.backlash, 3),
                pose.swept.error_bound.map_or(NONE.to_owned(), order_um),
                pose.swept.status().name().to_owned(),
                contact(found.and_then(|found| found.right.as_ref())),
                contact(found.and_then(|found| found.left.as_ref())),
                um_ascii(pose.michalec, 3),
                um_ascii(pose.involute, 3),
                um_ascii(pose.line_of_action, 3),
            ]);
        }
    }
    finish(&table)
}

fn run_table(study: &Study, runs: &[RunTally]) -> String {
    let mut headings = vec![
        "a mm", "material", "poses", "least", "at", "mean", "greatest", "at",
    ];
    let clearance = format!("a ± {} mm", distance(study.bearing_clearance));
    if study.bearing_clearance > 0.0 {
        headings.push(&clearance);
    }
    headings.extend(["off model 2", "off model 3"]);
    let unproven = runs.iter().any(|run| run.unproven > 0);
    if unproven {
        headings.push("unproven");
    }
    let mut table = table(&headings);
    for run in runs {
        let summary = run.summary();
        let at = |pose: Option<&ComparedPose>| pose.map_or(NONE.to_owned(), where_it_is);
        let (least, most) = run.extremes().unzip();
        let mut row = vec![
            distance(run.assembly.center_distance()),
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
        table.add_row(row);
    }
    finish(&table)
}

fn off_line_note(runs: &[RunTally]) -> String {
    let total: usize = runs.iter().map(|run| run.poses).sum();
    let off: usize = runs.iter().map(|run| run.count(Verdict::OffLine)).sum();
    if off == 0 {
        return String::new();
    }
    format!(
        "\nIn {off} of {total} poses a tooth corner, fillet or root touches off the line of action: the pair has less backlash there than model 3 says.\n"
    )
}

/// Poses up to this many are listed one by one (tuned: a screen).
const MOST_NAMED: usize = 10;

/// How many poses of `runs` are not proven, and the first of them, each on a line; nothing where all are proven.
fn unproven_note(runs: &[RunTally]) -> String {
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
        "\nUNPROVEN: {count} of {poses} poses. No number above takes them in, and nobody knows whether the pair \
         has backlash there.\n"
    );
    for (run, pose) in first.take(MOST_NAMED) {
        text += &format!(
            "  a = {} mm, {}, {}: {}\n",
            distance(run.assembly.center_distance()),
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

//! The result as text for a terminal, and measurements of a rig compared with their bands. Lengths in µm unless the heading says mm.

use crate::column::{PeopleColumn, Row, Value, backlash_cell, quantity_words, row_type, shown};
use crate::layout::{Screen, Tone, pose_label};
use crate::pose::{PoseRow, pose_doubts};
use crate::run::{RunRow, extremes_at};
use crate::verdict::{heading, lines};
use gearlash::analysis::measured::{Band, MeasuredMating, sides};
use gearlash::analysis::phases::{PhaseGroup, phase_groups};
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{MOST_LISTED, RunTally};
use gearlash::analysis::verdict::Verdict;
use gearlash::gear::Hand;
use gearlash::pair::{BacklashUnit, Member};
use gearlash_text::numbers::{backlash_ascii, stated_distance, trimmed};
use std::fmt::Write;

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
        let rows = runs.iter().flat_map(|run| {
            let poses = run.listed.iter();
            poses.map(move |pose| PoseRow::of_run(run, pose))
        });
        let rows: Vec<PoseRow> = rows.collect();
        text += &PoseRow::columns().table(&rows, PoseRow::center_distance, unit, screen);
        text.push('\n');
    }
    let groups = phase_groups(runs);
    if groups.is_empty() {
        let of = if study.sweeps() {
            "Of the poses swept"
        } else {
            "Of the listed poses"
        };
        let axes = match study.bearing_ends {
            None => "",
            Some(_) => ", without bearing clearance",
        };
        // These rows could be mistaken for the whole cycle.
        text += &format!("{of}{axes} (the verdict above is of the whole mesh cycle):\n");
        let rows = runs.iter();
        let rows = rows.map(|run| RunRow::new(run, study.clearance_of_poses()));
        let rows: Vec<RunRow> = rows.collect();
        text += &RunRow::columns().table(&rows, RunRow::center_distance, unit, screen);
        let has_formulas = runs.iter().any(|run| run.evidence.is_some());
        let models = if has_formulas { MODELS } else { "" };
        let of = quantity_words(unit);
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
    let helical = runs.iter().find(|run| run.assembly.is_helical());
    let wheel = helical.and_then(|run| run.assembly.as_built(Member::Wheel));
    let Some(wheel) = wheel else {
        return String::new();
    };
    let data = wheel.gear().basic_data();
    let hand = data.hand().map_or("right", Hand::name);
    let [from, to] = study.face.map(|end| trimmed(end, 0, 3));
    screen.paragraphs(&format!(
        "Helical, β {}°, wheel {hand}-hand, over the common face {from} … {to} mm from the measuring plane. Module, pressure angle, profile shift, \
         rack and thickness are those of the normal section, j_wt is of the transverse one.",
        trimmed(data.helix_angle().to_degrees(), 0, 6)
    ))
}

const AT: &str = ", simulated; \"at\": mating, fraction of a pitch beyond it, flank.";
const MODELS: &str =
    " Off model 2, 3: largest difference to the involute and to the line-of-action formula.";

fn off_line_note(runs: &[RunTally]) -> String {
    let total: usize = runs.iter().map(|run| run.poses).sum();
    let less: usize = runs.iter().map(|run| run.compared_off_line).sum();
    let alone: usize = runs.iter().map(RunTally::simulated_alone).sum();
    let mut text = String::new();
    if less > 0 {
        text += &format!(
            "\nIn {less} of {total} poses a tooth corner, fillet or root touches off the line of action: the pair has less backlash there than model 3 says, by more than compare tolerates.\n"
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
            run.material.words(),
            pose_label(pose),
            pose_doubts(pose)
        );
    }
    if count > MOST_NAMED {
        let more = count - MOST_NAMED;
        text += &format!("  … and {more} more: --format json has all\n");
    }
    text
}

/// A run of one assembly phase.
struct PhaseRow {
    run: RunTally,
    /// Whether a phase of the table is unproven.
    with_unproven: bool,
}

row_type!(row: PhaseRow {
    "" Plain [heading(shown("phase"))] => phase_name(&row.run);
    "" Backlash [heading(shown("least"))] => Value::um(row.run.summary().min);
    "" Plain [heading(shown("at").broken())] => extremes_at(&row.run)[0].take();
    "" Backlash [heading(shown("mean").spare(1))] => Value::um(row.run.summary().mean);
    "" Backlash [heading(shown("greatest"))] => Value::um(row.run.summary().max);
    "" Plain [heading(shown("at").broken())] => extremes_at(&row.run)[1].take();
    "" Backlash [heading(shown("variation"))] => Value::um(row.run.variation());
    "" Plain [heading(shown("unproven"))] => Value::optional(row.with_unproven.then_some(row.run.unproven));
});

fn phase_name(run: &RunTally) -> String {
    let (wheel, pinion) = run.phase.unwrap_or((1, 1));
    format!("{wheel},{pinion}")
}

/// Assembly phases, and the teeth to mark.
fn phase_table(group: &PhaseGroup, unit: BacklashUnit, screen: &Screen) -> String {
    let Some(first) = group.runs.first() else {
        return String::new();
    };
    let rows = group.runs.iter().map(|run| PhaseRow {
        run: (*run).clone(),
        with_unproven: group.runs.iter().any(|run| run.unproven > 0),
    });
    let (a, rows) = (first.assembly.center_distance(), rows.collect::<Vec<_>>());
    let mut text = format!(
        "centre distance {} mm, {}\n\n{}",
        stated_distance(a),
        first.material.words(),
        PhaseRow::columns().table(&rows, |_| a, unit, screen)
    );
    let variation = |run: &RunTally| {
        let variation = backlash_cell(unit, run.variation(), a, 3);
        format!("{variation} {}", unit.name())
    };
    text += &match (group.best, group.worst) {
        _ if group.runs.len() == 1 => {
            "There is only one assembly phase: the tooth numbers have no common divisor, every tooth meets every tooth.\n".to_owned()
        }
        (Some(best), Some(worst)) => format!(
            "Best phase {}: mark wheel tooth {} and pinion tooth {} together (least variation, {}); worst {} ({}).\n",
            phase_name(best),
            best.phase.map_or(1, |phase| phase.0),
            best.phase.map_or(1, |phase| phase.1),
            variation(best),
            phase_name(worst),
            variation(worst),
        ),
        _ => "No phase has backlash at every pose.\n".to_owned(),
    };
    text + "\n"
}

/// A measured mating.
struct MeasuredRow {
    mating: MeasuredMating,
    /// The band that the measured values are compared with.
    beside: Option<Band>,
    unit: BacklashUnit,
    /// Whether the band with bearing clearance is a column.
    with_clearance: bool,
}

impl MeasuredRow {
    fn center_distance(&self) -> f64 {
        self.mating.row.center_distance
    }

    fn band(&self, band: Option<Band>) -> Value {
        let a = self.center_distance();
        let ends = band.map(|band| [band.min_um, band.max_um].map(|um| (Some(um), a)));
        ends.map_or(Value::NULL, Value::Band)
    }

    /// A measured value, with a mark above or below its band.
    fn marked(&self, um: f64) -> String {
        let mark = match self.beside.map_or(0, |band| band.side_of(um)) {
            0 => ' ',
            1 => '↑',
            _ => '↓',
        };
        match self.unit {
            BacklashUnit::Um => format!("{um} {mark}"),
            unit => format!(
                "{} {mark}",
                backlash_ascii(unit, um, self.center_distance(), 1)
            ),
        }
    }
}

row_type!(row: MeasuredRow {
    "" Plain [heading(shown("mating"))] => format!("{},{}", row.mating.row.wheel_tooth, row.mating.row.pinion_tooth);
    "" Distance [heading(shown("a mm"))] => row.center_distance();
    "" BacklashAgain [heading(shown("predicted (printed)"))] => Value::optional(row.mating.printed.map(|band| row.band(Some(band))));
    "" BacklashAgain [heading(shown("analytic").spare(1))] => row.band(row.mating.analytic);
    "" BacklashAgain [heading(shown("simulated"))] => row.band(row.mating.simulated);
    "" BacklashAgain [heading(shown("with bearing clearance"))] => Value::optional(row.with_clearance.then(|| row.band(row.mating.with_clearance)));
    "" BacklashAgain [heading(shown("measured right"))] => row.marked(row.mating.row.right_um);
    "" BacklashAgain [heading(shown("left"))] => row.marked(row.mating.row.left_um);
});

/// The `measured` matings, each compared with the band `beside` it.
fn measured_rows(
    measured: &[MeasuredMating],
    beside: fn(&MeasuredMating) -> Option<Band>,
    unit: BacklashUnit,
    with_clearance: bool,
) -> Vec<MeasuredRow> {
    let row = |mating: &MeasuredMating| MeasuredRow {
        beside: beside(mating),
        mating: mating.clone(),
        unit,
        with_clearance,
    };
    measured.iter().map(row).collect()
}

/// The measured matings for a page, compared with the simulated bands.
pub fn measured_shown(study: &Study, measured: &[MeasuredMating]) -> Vec<PeopleColumn> {
    let (unit, has_clearance) = (BacklashUnit::Um, study.clearance_of_poses() > 0.0);
    let rows = measured_rows(measured, |mating| mating.simulated, unit, has_clearance);
    MeasuredRow::columns().for_people(&rows, MeasuredRow::center_distance, unit)
}

/// The band of a mating on a terminal: the printed one, else the simulated one.
fn printed_or_simulated(mating: &MeasuredMating) -> Option<Band> {
    mating.printed.or(mating.simulated)
}

/// The measured matings for a terminal.
fn measured_table(measured: &[MeasuredMating], unit: BacklashUnit, screen: &Screen) -> String {
    let rows = measured_rows(measured, printed_or_simulated, unit, false);
    MeasuredRow::columns().table(&rows, MeasuredRow::center_distance, unit, screen)
}

/// The number of measured values inside their bands, and a legend.
fn measured_count(
    study: &Study,
    measured: &[MeasuredMating],
    unit: BacklashUnit,
    screen: &Screen,
) -> String {
    let is_predicted = measured.iter().any(|mating| mating.printed.is_some());
    let (band, predicted) = if is_predicted {
        (
            "predicted",
            " Predicted: as printed beside the measurement.",
        )
    } else {
        ("simulated", "")
    };
    let [below, inside, above] = sides(measured, printed_or_simulated);
    let total = below + inside + above;
    let mut text = format!(
        "\n{inside} of {total} measured values lie inside the {band} band: {below} below it (↓), {above} above it (↑).\n",
    );
    if study.clearance_of_poses() > 0.0 {
        let [_, inside, _] = sides(measured, |mating| mating.with_clearance);
        let _ = writeln!(
            text,
            "With the bearing clearance taken in (a ± {} mm), {inside} of {total} lie inside the simulated band.",
            stated_distance(study.bearing_clearance)
        );
    }
    let legend = format!(
        "{}. Bands run from most to least material.{predicted} \
         Analytic: model 2 (involute); simulated: on the tooth outlines; both are means of the mating's right-flank \
         and left-flank pose. ↓ ↑: measured below or above the {band} band.",
        quantity_words(unit)
    );
    text + &screen.paragraphs(&legend)
}

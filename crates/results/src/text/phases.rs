//! Assembly phases, and the teeth to mark.

use crate::layout::{Column, Screen, Table, pose_label};
use crate::unit;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::phases::PhaseGroup;
use gearlash::analysis::tally::RunTally;
use gearlash::pair::BacklashUnit;
use gearlash_files::numbers::{NONE, stated_distance};

pub fn phase_table(group: &PhaseGroup, unit: BacklashUnit, screen: &Screen) -> String {
    let mating = |run: &RunTally| {
        let (wheel, pinion) = run.phase.unwrap_or((1, 1));
        format!("{wheel},{pinion}")
    };
    let cell = |run: &RunTally, j_wt| unit::cell(unit, j_wt, run.assembly.center_distance(), 3);
    let unproven = group.runs.iter().any(|run| run.unproven > 0);
    let mut columns = vec![
        Column::new("phase"),
        Column::new(unit::column(unit, "least")),
        Column::new("at").broken(),
        Column::new(unit::column(unit, "mean")).spare(1),
        Column::new(unit::column(unit, "greatest")),
        Column::new("at").broken(),
        Column::new(unit::column(unit, "variation")),
    ];
    columns.extend(unproven.then(|| Column::new("unproven")));
    let mut table = Table::new(columns);
    for run in &group.runs {
        let summary = run.summary();
        let at = |pose: Option<&ComparedPose>| pose.map_or(NONE.to_owned(), pose_label);
        let (least, most) = run.extremes().unzip();
        let mut row = vec![
            mating(run),
            cell(run, summary.min),
            at(least),
            cell(run, summary.mean),
            cell(run, summary.max),
            at(most),
            cell(run, run.variation()),
        ];
        row.extend(unproven.then(|| run.unproven.to_string()));
        table.add(row);
    }
    let name = unit.name();
    let Some(first) = group.runs.first() else {
        return String::new();
    };
    let mut text = format!(
        "centre distance {} mm, material {}\n\n{}",
        stated_distance(first.assembly.center_distance()),
        first.material.name(),
        table.text(screen)
    );
    text += &match (group.best, group.worst) {
        _ if group.runs.len() == 1 => {
            "There is only one assembly phase: the tooth numbers have no common divisor, every tooth meets every tooth.\n".to_owned()
        }
        (Some(best), Some(worst)) => format!(
            "Best phase {}: mark wheel tooth {} and pinion tooth {} together (least variation, {} {name}); worst {} ({} {name}).\n",
            mating(best),
            best.phase.map_or(1, |phase| phase.0),
            best.phase.map_or(1, |phase| phase.1),
            cell(best, best.variation()),
            mating(worst),
            cell(worst, worst.variation()),
        ),
        _ => "No phase has backlash at every pose.\n".to_owned(),
    };
    text + "\n"
}

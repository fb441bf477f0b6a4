//! What is found of a pair of outlines, as text.

use super::verdict::heading;
use crate::layout::{Column, Screen, Table};
use crate::outlines::{lines, looks_like, region_words};
use crate::unit::cell;
use gearlash::analysis::outlines::OutlineRun;
use gearlash::pair::BacklashUnit;
use gearlash_files::OutlinePairFile;
use gearlash_files::numbers::stated_distance;
use std::fmt::Write;

/// Wheel teeth that bind are listed up to so many.
const LISTED: usize = 24;

/// As text on `screen`, backlash of tables in `unit`: the verdict, the wheel teeth that bind, and what the outlines look like.
pub fn text(
    file: &OutlinePairFile,
    runs: &[OutlineRun],
    unit: BacklashUnit,
    screen: &Screen,
) -> String {
    let lines = lines(&file.study, runs);
    let mut text = heading(&file.study.title, &lines, screen);
    for run in runs {
        text += &binding(run, unit, screen);
    }
    text += "An outline has no module and no involute: formulas, contact ratio and limits are left out.\n";
    for finding in looks_like(file) {
        let _ = writeln!(text, "{finding}");
    }
    screen.fold(&text)
}

/// The wheel teeth at which a run binds, each at its worst; empty where it turns.
fn binding(run: &OutlineRun, unit: BacklashUnit, screen: &Screen) -> String {
    let worst = run.binding_teeth();
    // Jammed throughout there is nothing to choose between.
    if worst.iter().all(|(_, pose)| pose.j_wt.is_none()) {
        return String::new();
    }
    let mut rows = Table::new(vec![
        Column::new("wheel tooth"),
        Column::new(match unit {
            BacklashUnit::Um => "j_wt µm".to_owned(),
            BacklashUnit::Arcmin { at, .. } => format!("{} arcmin", at.name()),
        }),
        Column::new("right flanks").left(),
        Column::new("left flanks").left(),
    ]);
    for (tooth, pose) in worst.iter().take(LISTED) {
        let [right, left] = pose.contacts().map(|contact| {
            contact.map_or("jammed".to_owned(), |contact| {
                format!(
                    "{}·{} {}",
                    contact.wheel.tooth,
                    contact.pinion.tooth,
                    region_words(&contact)
                )
            })
        });
        let j_wt = pose.j_wt.map(|(j_wt, _)| j_wt);
        rows.add(vec![
            tooth.to_string(),
            cell(unit, j_wt, run.pair.center_distance(), 2),
            right,
            left,
        ]);
    }
    let mut text = format!(
        "Where it binds at a = {} mm, each wheel tooth at its worst{}:\n",
        stated_distance(run.pair.center_distance()),
        match worst.len().saturating_sub(LISTED) {
            0 => String::new(),
            more => format!(" ({LISTED} of {})", LISTED + more),
        }
    );
    let _ = writeln!(text, "{}", rows.text(screen));
    text
}

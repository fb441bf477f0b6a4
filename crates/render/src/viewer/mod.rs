//! The mesh viewer of a page: both gears as built, with zoom and pan, and steps through the poses of a run.
//!
//! The page has an SVG of the worst pose, complete without a script; the results in columns; and `viewer.js`, which only sets
//! transforms and texts from those columns. Positions, contacts and their classes are read from the results. Shown values are
//! rounded: outlines and contact points as `precision.rs` defines, rotations to 1e-6°. `j_wt` is the result's own f64.

mod columns;
mod contacts;
mod drawing;
mod marks;
mod precision;
mod readout;
mod section;
mod viewed;

use columns::Columns;
use gearlash::analysis::Analysis;
use gearlash::analysis::curves::Course;
use gearlash::contact::Status;
use precision::Precision;
use std::fmt::Write;
use viewed::{Shown, outlines, start, viewed, worst_outside_runs};

/// The style sheet, for the head of the page.
pub const STYLE: &str = include_str!("viewer.css");
const SCRIPT: &str = include_str!("viewer.js");
const CONTROLS: &str = include_str!("controls.html");
/// Additional controls for helical gears.
const SECTION_CONTROLS: &str = include_str!("section.html");
const SECTION_SCRIPT: &str = include_str!("section.js");
/// Most poses of a page over all runs, apart from a few per run (tuned: some 140 bytes each, so that a page with a dozen charts
/// stays below 8 MB).
const MOST_POSES: usize = 30_000;

/// The part of a page that shows the mesh of an `analysis`: HTML for the body, once; empty without a pose, and for a drawn pair.
///
/// It opens at the worst pose of the whole mesh cycle. `charts` are curves over the teeth, each with the id of its chart's
/// `<svg>` in the page: a cursor moves in it, and a click there selects the nearest pose. If there are too many poses for a page,
/// it has every n-th pose of each run, and each run's least and greatest backlash; a note states this.
///
/// # Errors
/// None for results of a simulation: the columns are numbers and names.
pub fn fragment(
    analysis: &Analysis,
    charts: &[(&str, &Course)],
) -> Result<String, serde_json::Error> {
    let study = analysis.study;
    let worst_outside_runs = worst_outside_runs(analysis);
    let turned = analysis.revolution.iter().map(|run| (run, false));
    let runs: Vec<Shown> = turned
        .chain(worst_outside_runs.iter().map(|run| (run, true)))
        .map(|(run, is_worst_of_cycle)| Shown {
            run,
            is_worst_of_cycle,
        })
        .collect();
    let Some(start) = start(&runs, analysis) else {
        return Ok(String::new());
    };
    let (run, pose) = (&runs[start[0]].run, &runs[start[0]].run.poses[start[1]]);
    let Some(pair) = run.run.assembly.data() else {
        return Ok(String::new());
    };
    let precision = Precision::of(pair);
    let outlines = outlines(&runs);
    let (views, every) = viewed(&runs, MOST_POSES, start);
    let [first_run, first_pose] = start;
    let place = views[first_run].numbers.binary_search(&first_pose);
    let shown = [first_run, place.unwrap_or(0)];
    let columns = Columns::new(study, &views, charts, shown, &outlines, precision);
    let data = serde_json::to_string(&columns)?;
    let mut html = String::from("<div class=\"viewer\" id=\"viewer\">\n");
    html.push_str(CONTROLS);
    let helical = run.run.assembly.is_helical();
    if helical {
        html.push_str(SECTION_CONTROLS);
    }
    html.push_str(&drawing::draw(&outlines, run, pose, precision));
    html.push_str(&section::note(&run.run.assembly, &pose.simulated));
    html.push_str(&readout::draw(&views[first_run], start[1]));
    if every > 1 {
        let held: usize = views.iter().map(|run| run.numbers.len()).sum();
        let all: usize = runs.iter().map(|shown| shown.run.poses.len()).sum();
        let _ = writeln!(
            html,
            "<p class=\"viewer-note\">{held} of {all} poses can be looked at here: of each run every {every}{}, and those \
             with the least and the greatest backlash. The numbers on this page are of all.</p>",
            ordinal(every),
        );
    }
    let _ = writeln!(
        html,
        "<p class=\"viewer-note\">{} Outlines: chords within {} µm of the curves, places to {} µm, rotations to 1e-6°.</p>\n\
         <noscript><p class=\"viewer-note\">This is {} pose. With JavaScript every pose can be looked at.</p></noscript>",
        readout::LEGEND,
        precision.chord_um(),
        precision.place_um(),
        match pose.simulated.status() {
            Status::NoContact | Status::Unproven => "the first",
            _ => "the worst",
        },
    );
    // `<` occurs only in strings, where JSON can escape it: no text can end the element early.
    let _ = writeln!(
        html,
        "<script type=\"application/json\" id=\"viewer-data\">{}</script>\n<script>\n{SCRIPT}</script>\n{}</div>",
        data.replace('<', "\\u003c"),
        if helical {
            format!("<script>\n{SECTION_SCRIPT}</script>\n")
        } else {
            String::new()
        }
    );
    Ok(html)
}

/// The suffix of an ordinal number.
fn ordinal(number: usize) -> &'static str {
    match (number % 10, number % 100) {
        (1, tens) if tens != 11 => "st",
        (2, tens) if tens != 12 => "nd",
        (3, tens) if tens != 13 => "rd",
        _ => "th",
    }
}

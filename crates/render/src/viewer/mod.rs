//! The mesh viewer of a page: both gears as built, with zoom and pan, moved from pose to pose.
//!
//! The page has an SVG of one pose, complete without a script, and results in columns. `mesh.js` only sets transforms and texts
//! from those columns. In a report, [`fragment`], `poses.js` steps through the runs of an analysis. A page that runs the program
//! asks for each pose ([`LivePose`]).
//!
//! Positions, contacts and their classes are read from the results. Shown values are rounded: outlines and contact points as
//! `precision.rs` defines, rotations to 1e-6°. `j_wt` is the result's own f64.

mod columns;
mod drawing;
mod mesh;
mod precision;
mod readout;
mod viewed;

pub use mesh::LivePose;

use gearlash::analysis::Analysis;
use gearlash::analysis::curves::Course;
use gearlash::contact::Status;
use mesh::Mesh;
use std::fmt::Write;
use viewed::{Viewed, count, select, start, worst_outside_runs};

/// The style sheet, for the head of the page.
pub const STYLE: &str = include_str!("viewer.css");
/// Moves the picture; for the report and for the page that runs the program.
const MESH_SCRIPT: &str = include_str!("mesh.js");
/// Steps through the poses of a report.
const POSES_SCRIPT: &str = include_str!("poses.js");
/// Additional controls for the poses of a report.
const POSES_CONTROLS: &str = include_str!("poses.html");
/// Most poses of a page over all runs, apart from a few per run (tuned: some 200 bytes each, so that a page with a dozen charts
/// stays below 8 MB).
const MOST_POSES: usize = 25_000;

/// The part of a page that shows the mesh of an `analysis`: HTML for the body, once; empty without a pose.
///
/// It opens at the worst pose of the whole mesh cycle. `charts` are curves over the teeth, each with the id of its chart's
/// `<svg>` in the page: a cursor moves in it, and a click there selects the nearest pose. If there are too many poses for a page,
/// it has every n-th pose of each run, and each run's least and greatest backlash; a note states this.
///
/// # Errors
/// None for results of a simulation: the columns are numbers and names.
pub fn fragment(
    analysis: &Analysis,
    charts: &[(String, &Course)],
) -> Result<String, serde_json::Error> {
    let worst_outside_runs = worst_outside_runs(analysis);
    let turned = analysis
        .revolution
        .iter()
        .map(|run| Viewed::all(run, false));
    let worst = worst_outside_runs.iter().map(|run| Viewed::all(run, true));
    let mut runs: Vec<Viewed> = turned.chain(worst).collect();
    let Some(start) = start(&runs, analysis) else {
        return Ok(String::new());
    };
    let pose = &runs[start[0]].run.poses[start[1]];
    let all = count(&runs);
    let every = select(&mut runs, MOST_POSES, start);
    let held = count(&runs);
    let pairs: Vec<_> = runs.iter().map(|run| &run.run.run.assembly).collect();
    let Some(mesh) = Mesh::new(analysis.study, runs, start, pairs.into_iter()) else {
        return Ok(String::new());
    };
    let data = serde_json::to_string(&mesh.columns(charts))?;
    let mut html = format!(
        "<div class=\"viewer\" id=\"viewer\">\n{}",
        mesh.html(POSES_CONTROLS)
    );
    if every > 1 {
        let _ = writeln!(
            html,
            "<p class=\"viewer-note\">{held} of {all} poses can be looked at here: of each run every {every}{}, and those \
             with the least and the greatest backlash. The numbers on this page are of all.</p>",
            ordinal(every),
        );
    }
    // `<` occurs only in strings, where JSON can escape it: no text can end the element early.
    let _ = writeln!(
        html,
        "<noscript><p class=\"viewer-note\">This is {} pose. With JavaScript every pose can be looked at.</p></noscript>\n\
         <script type=\"application/json\" id=\"viewer-data\">{}</script>\n<script>\n{MESH_SCRIPT}{POSES_SCRIPT}</script>\n</div>",
        match pose.simulated.status() {
            Status::NoContact | Status::Unproven => "the first",
            _ => "the worst",
        },
        data.replace('<', "\\u003c"),
    );
    Ok(html)
}

fn ordinal(number: usize) -> &'static str {
    match (number % 10, number % 100) {
        (1, tens) if tens != 11 => "st",
        (2, tens) if tens != 12 => "nd",
        (3, tens) if tens != 13 => "rd",
        _ => "th",
    }
}

//! The poses with the least and the greatest backlash, drawn.

use super::Page;
use super::inline::inline;
use super::words::{distance, material, pose, um};
use crate::error::Error;
use crate::outcome::Found;
use crate::render::{Snapshot, snapshot};
use maud::{Markup, PreEscaped, html};

/// Centre distances, beside that of the least pose, whose least pose is drawn too (tuned: some 30 kB each).
const MOST_DRAWN: usize = 8;

pub(super) fn section(page: &Page) -> Result<Markup, Error> {
    let whole = &page.whole;
    let others = others(page);
    Ok(html! {
        section id="poses" {
            h2 { "Worst poses" }
            @if let Some(least) = whole.least { (figure(page, "least", "Least backlash", least)?) }
            @if let Some(greatest) = whole.greatest {
                (figure(page, "greatest", "Greatest backlash", greatest)?)
            }
            @if !others.is_empty() {
                details {
                    summary { "Least backlash at the other centre distances" }
                    @for (number, least) in others.into_iter().enumerate() {
                        (figure(page, &format!("least{}", number + 1), "Least backlash", least)?)
                    }
                }
            }
        }
    })
}

/// The least poses of the other centre distances, where they are few.
fn others<'a>(page: &Page<'a>) -> Vec<Found<'a>> {
    let distance = |found: Found| found.run.run.assembly.center_distance();
    let drawn = page.whole.least.map(distance);
    let least = page.distances.iter().filter_map(|at| at.all.least);
    let others: Vec<Found> = least
        .filter(|found| Some(distance(*found)) != drawn)
        .collect();
    match others.len() {
        0..=MOST_DRAWN => others,
        _ => Vec::new(),
    }
}

fn figure(page: &Page, id: &str, what: &str, found: Found) -> Result<Markup, Error> {
    let run = &found.run.run;
    let swept = &found.pose.swept;
    let picture = snapshot(&Snapshot {
        title: &page.report.study.title,
        assembly: &run.assembly,
        pose: &swept.pose,
        material: run.material.name(),
        lost_motion: &swept.lost_motion,
    });
    let words = format!(
        "{what}: {} µm, {}, centre distance {} mm, {}.",
        um(swept.backlash, 3),
        pose(found),
        distance(run.assembly.center_distance()),
        material(run.material)
    );
    Ok(html! {
        figure.sheet {
            (PreEscaped(inline(&picture, id, &words)?))
            figcaption { (words) }
        }
    })
}

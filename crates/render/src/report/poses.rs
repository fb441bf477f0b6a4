//! The poses with the least and the greatest backlash, drawn.

use super::figures::more;
use super::page::Page;
use super::phrases::pose;
use crate::snapshot::pose_picture_in_page;
use gearlash::analysis::outcome::PoseOfRun;
use gearlash::contact::Status;
use gearlash_files::numbers::{stated_distance, trimmed, um};
use maud::{Markup, PreEscaped, html};

/// Most other centre distances whose least pose is drawn (tuned: some 30 kB each).
const MOST_DRAWN: usize = 8;

pub(super) fn section(page: &Page) -> Markup {
    let whole = &page.whole;
    let others = other_distances(page);
    html! {
        section id="poses" {
            h2 { "Worst poses" }
            @if whole.worst.is_none() {
                p { "No pose is " @if whole.unproven > 0 { "proven to be " } "in mesh: there is nothing to draw." }
            }
            @if let Some(jammed) = whole.worst.filter(|found| found.pose.simulated.status() == Status::Jammed) {
                (figure(page, "jammed", "Jammed, a tip in a root", jammed))
            }
            @if let Some(least) = whole.least { (figure(page, "least", "Least backlash", least)) }
            @if let Some(greatest) = whole.greatest {
                (figure(page, "greatest", "Greatest backlash", greatest))
            }
            @if let Some((most, loss)) = greatest_loss(page) {
                (figure(page, "lost", &format!("Largest loss to contact off the line of action, {} µm", um(Some(loss), 2)), most))
            }
            @if whole.worst.is_some() { p.note { "Scale bars are correct; the ratios beside them hold on the A4 sheet of " code { "gearlash snapshot" } "." } }
            @if !others.is_empty() {
                (more("least backlash at the other centre distances", html! {
                    @for (number, least) in others.into_iter().enumerate() {
                        (figure(page, &format!("least{}", number + 1), "Least backlash", least))
                    }
                }))
            }
        }
    }
}

/// The pose with the greatest loss beyond all formulas, where that exceeds the tolerance and is not drawn yet.
fn greatest_loss<'a>(page: &Page<'a>) -> Option<(PoseOfRun<'a>, f64)> {
    let loss = page.report.analysis.diagnosis.contact.loss.as_ref()?;
    let worst = &loss.worst;
    let is_worst = |found: &PoseOfRun| {
        let run = &found.run.run;
        run.material == worst.material
            && run.assembly.center_distance() == worst.assembly.center_distance()
            && found.pose.simulated.pose == worst.pose
    };
    let runs = page.report.analysis.runs.iter();
    let mut all = runs.flat_map(|run| run.poses.iter().map(move |pose| PoseOfRun { run, pose }));
    let found = all.find(is_worst)?;
    let drawn = [page.whole.least, page.whole.greatest];
    let known = drawn.iter().flatten().any(is_worst);
    (worst.loss > page.report.pair.study.tolerance_um * 1e-3 && !known)
        .then_some((found, worst.loss))
}

/// The least poses of the other centre distances, where there are few.
fn other_distances<'a>(page: &Page<'a>) -> Vec<PoseOfRun<'a>> {
    let distance = |found: PoseOfRun| found.run.run.assembly.center_distance();
    let drawn = page.whole.least.map(distance);
    let least = page.distances.iter().filter_map(|at| at.all.least);
    let others: Vec<PoseOfRun> = least
        .filter(|found| Some(distance(*found)) != drawn)
        .collect();
    match others.len() {
        0..=MOST_DRAWN => others,
        _ => Vec::new(),
    }
}

fn figure(page: &Page, id: &str, what: &str, found: PoseOfRun) -> Markup {
    let run = &found.run.run;
    let result = &found.pose.simulated;
    let backlash = result
        .backlash
        .map(|mm| format!(": {} µm", um(Some(mm), 2)));
    let words = |section: Option<f64>| {
        let at = section.map_or(String::new(), |at| {
            format!(", section at z = {} mm", trimmed(at, 0, 3))
        });
        format!(
            "{what}{}, {}, centre distance {} mm, {}{at}.",
            backlash.as_deref().unwrap_or_default(),
            pose(found),
            stated_distance(run.assembly.center_distance()),
            run.material.words()
        )
    };
    let title = &page.report.pair.study.title;
    let drawn = pose_picture_in_page(title, &run.assembly, run.material, result, (id, words));
    html! {
        @match drawn {
            Ok([picture, words]) => figure.sheet tabindex="0" {
                (PreEscaped(picture))
                figcaption { (words) }
            },
            Err(reason) => p { (what) ": not drawn: " (reason.to_string()) "." },
        }
    }
}

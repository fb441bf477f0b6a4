//! The poses with the least and the greatest backlash, drawn.

use super::super::figures::not_on_paper;
use super::{OutlineReport, place, teeth, value};
use crate::pose_name::pose_name;
use crate::snapshot::outline_snapshot_in_page;
use gearlash::analysis::outlines::{OutlinePose, OutlineRun, worst};
use gearlash::contact::Status;
use maud::{Markup, PreEscaped, html};

/// Runs, beside the worst, whose least pose is drawn too (tuned: as of gears by their data).
const MOST_DRAWN: usize = 8;

/// The pictures that have to be opened.
const OTHERS: &str = "least backlash at the other centre distances and materials";

pub(super) fn section(report: &OutlineReport) -> Markup {
    let worst = worst(report.runs);
    let greatest = report
        .runs
        .iter()
        .filter_map(|run| Some((run, run.greatest.as_ref()?)));
    let greatest = greatest.max_by(|a, b| a.1.room().total_cmp(&b.1.room()));
    let drawn = worst.map(|(run, _)| run);
    let others = report
        .runs
        .iter()
        .filter(|run| drawn.is_some_and(|drawn| !std::ptr::eq(*run, drawn)));
    let others: Vec<_> = others
        .filter_map(|run| Some((run, run.least.as_ref()?)))
        .collect();
    html! {
        section id="poses" {
            h2 { "Worst poses" }
            @if worst.is_none() && greatest.is_none() {
                p { "No pose is known to be in mesh: there is nothing to draw." }
            }
            @if let Some((run, pose)) = worst {
                @let what = if pose.status() == Status::Jammed { "Jammed" } else { "Least backlash" };
                (figure(report, "least", what, run, pose))
            }
            @if let Some((run, pose)) = greatest { (figure(report, "greatest", "Greatest backlash", run, pose)) }
            @if worst.is_some() { p.note { "Scale bars are correct; the ratios beside them hold on the A4 sheet of " code { "gearlash snapshot" } "." } }
            @if !others.is_empty() && others.len() <= MOST_DRAWN {
                details {
                    summary { "More: " (OTHERS) }
                    @for (number, (run, pose)) in others.into_iter().enumerate() {
                        (figure(report, &format!("least{}", number + 1), "Least backlash", run, pose))
                    }
                }
                (not_on_paper(OTHERS))
            }
        }
    }
}

fn figure(
    report: &OutlineReport,
    id: &str,
    what: &str,
    run: &OutlineRun,
    pose: &OutlinePose,
) -> Markup {
    let backlash = match pose.j_wt {
        Some(_) => {
            let [right, left] = teeth(pose);
            let um = value(Some(pose));
            format!(": {um} µm, right flanks of teeth {right} and left flanks of {left} touch")
        }
        None => String::new(),
    };
    let words = format!(
        "{what}{backlash}; {}, {}.",
        pose_name(&pose.mating),
        place(report, run)
    );
    let title = &report.pair.study.title;
    html! {
        figure.sheet tabindex="0" {
            (PreEscaped(outline_snapshot_in_page(title, run, pose, [id, &words])))
            figcaption { (words) }
        }
    }
}

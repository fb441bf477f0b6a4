//! Unproven poses: their number, list and reasons.

use super::page::Page;
use super::phrases::{plain, pose};
use gearlash::analysis::outcome::PoseOfRun;
use gearlash_files::numbers::stated_distance;
use gearlash_results::doubts;
use maud::{Markup, html};

/// Most poses that are listed individually (tuned: a screen).
const MOST_LISTED: usize = 12;

/// The number of unproven poses, in words; `None` where all are proven.
pub(super) fn count(page: &Page) -> Option<String> {
    let poses = page.whole.poses;
    let (unproven, ends) = (page.whole.unproven, page.whole.unproven_ends);
    let with_clearance = page.report.pair.study.bearing_clearance > 0.0;
    let mut parts = Vec::new();
    match unproven {
        0 => {}
        1 => parts.push(format!("1 of {poses} poses is unproven")),
        _ => parts.push(format!("{unproven} of {poses} poses are unproven")),
    }
    for (end, name) in ends.into_iter().zip(["a − c", "a + c"]) {
        if with_clearance && end > 0 {
            parts.push(format!(
                "{end} of {poses} are unproven at {name} of the bearing clearance"
            ));
        }
    }
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// Each of them with its reason and unverified values; empty where all are proven.
pub(super) fn section(page: &Page) -> Markup {
    let runs = page.all.iter().copied();
    let unproven = runs.flat_map(|run| run.unproven().map(move |pose| PoseOfRun { run, pose }));
    let unproven: Vec<PoseOfRun> = unproven.collect();
    html! {
        @if let Some(count) = count(page) {
            section id="unproven" {
                h2 { "Unproven poses" }
                p {
                    strong { (count) "." }
                    " A certificate failed there, a contact was lost, or the two methods differ by more than their error bounds. "
                    "No table, curve or verdict of this page takes such a pose in; the values below are doubtful and are listed for inspection only."
                }
                ul {
                    @for found in unproven.iter().take(MOST_LISTED) {
                        li {
                            (pose(*found)) ", centre distance " (stated_distance(found.run.run.assembly.center_distance())) " mm, "
                            (found.run.run.material.words()) ": " (plain(&doubts(found.pose)))
                        }
                    }
                }
                @if unproven.len() > MOST_LISTED {
                    p.note { (unproven.len() - MOST_LISTED) " more; " code { "gearlash simulate --format json" } " lists them all." }
                }
            }
        }
    }
}

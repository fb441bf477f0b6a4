//! The reliability of the numbers; unproven poses with their reasons.

use super::models::sentence;
use super::page::Page;
use super::phrases::{j_wt, plain, pose};
use gearlash::analysis::extremes::WIDTH;
use gearlash::analysis::outcome::{MODELS, PoseOfRun, deviation};
use gearlash::contact::{Method, MethodAgreement};
use gearlash_results::pose_doubts;
use gearlash_text::numbers::{bound_um, difference_um, shortest, stated_distance};
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    let measured = sentence(page.report);
    html! {
        section id="trust" {
            h2 { "Can the numbers be trusted?" }
            p { strong { (answer(page)) } }
            ul {
                li { (certificate(page)) }
                li { (formula(page)) }
                @if let Some(measured) = measured { li { (measured) } }
                li {
                    "The result is as good as the measurements it starts from: 1 µm more tooth thickness, at the reference "
                    "circle, is 1 µm less backlash there"
                    @if page.report.pair.study.is_helical() { ", both in the transverse section" }
                    "."
                }
            }
        }
    }
}

fn answer(page: &Page) -> String {
    let of = &page.agreement;
    let (fails, bad) = (of.formula_fails(), of.unexplained());
    if let Some(unproven) = count(page) {
        return format!(
            "Not without a check: {unproven}. What happens there is not known. Please report the pair file."
        );
    }
    if bad > 0 {
        return format!(
            "Not without a check: at {bad} poses simulation and formula disagree, and no reason was found. Please report the pair file."
        );
    }
    if page.whole.least.is_none() {
        return "No backlash exists: at no pose can the free gear turn between two contacts."
            .to_owned();
    }
    let valued = of.valued();
    match (fails, of.agree) {
        (0, _) if valued == of.poses => {
            "Yes, for the gears as measured: simulation and formula agree at every pose.".to_owned()
        }
        (0, _) => format!(
            "Yes, for the gears as measured: simulation and formula agree at all {valued} poses that have a backlash."
        ),
        (_, 0) => "Yes, the simulation, for the gears as measured. The line-of-action formula does not apply to this pair: at every pose the teeth touch off the line of action.".to_owned(),
        (_, agree) => format!(
            "Yes, the simulation, for the gears as measured. The line-of-action formula does not apply at {fails} of {valued} poses, where the teeth touch off the line of action. At the other {agree} poses both agree."
        ),
    }
}

fn certificate(page: &Page) -> Markup {
    let how = match page.report.analysis.method {
        Method::Exact { certify: true } | Method::Checked => {
            "Each rotation was found on the exact tooth curves and proven: slightly more open nothing touches, slightly more closed something does. Polygons check the poses of the extremes and every 64th pose. "
        }
        Method::Exact { certify: false } => {
            "Each rotation was found on the exact tooth curves; the proof was left out (--no-certify). "
        }
        Method::Polygon => "Each rotation was found on polygons cut ever finer round the contact. ",
        Method::Both => {
            "Each rotation was found twice, on the exact tooth curves and on polygons. "
        }
    };
    let poses = page.all.iter().flat_map(|run| &run.poses);
    let results = poses.map(|pose| &pose.simulated);
    let proven = results.filter(|result| result.proven().is_some());
    let agreement = MethodAgreement::of(proven);
    html! {
        (how)
        @if page.whole.unproven > 0 { "What follows is of the proven poses alone. " }
        @if agreement.compared > 0 { "Both lie within " (bound_um(agreement.largest)) " µm. " }
        @if let Some(error) = page.whole.error_bound {
            "The numerical error of " (j_wt()) " is at most " (bound_um(error)) " µm."
        }
        " Between poses, and at matings that were not simulated, the bounds of least and greatest hold, to "
        (bound_um(WIDTH)) " µm where they are proven."
    }
}

fn formula(page: &Page) -> Markup {
    let of = &page.agreement;
    let [.., line_of_action] = MODELS;
    html! {
        @if of.both > 0 {
            "The line-of-action formula, which shares nothing with the simulation but the gears’ data, agrees within "
            (shortest(page.report.pair.study.tolerance_um)) " µm at " (of.agree) " of the " (of.both) " poses where both give a value"
            @if let Some(deviation) = deviation(&page.all, line_of_action) {
                "; the largest difference is " (difference_um(deviation.largest)) " µm"
            }
            ". "
        } @else {
            "There is no pose where simulation and line-of-action formula both give a value: nothing was compared. "
        }
        @if of.poses > of.both {
            (why_not_compared(page)) ". "
        }
        (off_line(page))
    }
}

/// The reason why the other poses cannot be compared.
fn why_not_compared(page: &Page) -> String {
    let of = &page.agreement;
    let alone = "in contact where no two involutes reach each other";
    let parts = [
        (page.whole.jammed, "jammed"),
        (page.whole.out_of_mesh, "out of mesh"),
        (page.whole.unproven, "unproven"),
        (of.simulated_alone, alone),
    ];
    let parts = parts.into_iter().filter(|(poses, _)| *poses > 0);
    let parts: Vec<(usize, &str)> = parts.collect();
    let other = of.poses - of.both;
    match (&parts[..], other == of.poses) {
        ([(_, what)], true) => format!("Every pose is {what}"),
        ([(1, what)], false) => format!("The other pose is {what}"),
        ([(_, what)], false) => format!("The other {other} poses are {what}"),
        (parts, _) => {
            let named = parts.iter().map(|(poses, what)| format!("{poses} {what}"));
            let named = named.collect::<Vec<_>>().join(", ");
            format!("The other {other} poses: {named}")
        }
    }
}

/// The number of poses with contact off the line of action, and of those where it matters.
fn off_line(page: &Page) -> Markup {
    let of = &page.agreement;
    let valued = of.valued();
    // The formula is wrong about poses beyond the tolerance.
    let slight = of.touch_off_line.saturating_sub(of.formula_fails());
    let tolerance = shortest(page.report.pair.study.tolerance_um);
    html! {
        @match of.touch_off_line {
            0 if valued == 0 => "",
            0 if valued == of.poses && of.simulated_alone == 0 => "Only involutes touch, at every pose.",
            0 if of.simulated_alone > 0 => "",
            0 => "Where there is backlash, only involutes touch.",
            1 => "At one pose a tip corner, an undercut edge, a fillet or a root touches",
            poses => { "At " (poses) " poses a tip corner, an undercut edge, a fillet or a root touches" }
        }
        @match (of.touch_off_line, slight) {
            (0, _) => "",
            (_, 0) => ".",
            (1, _) => { ", and costs no more than " (tolerance) " µm." }
            (_, 1) => { "; at 1 of them that costs no more than " (tolerance) " µm." }
            (all, slight) if all == slight => { ", which costs no more than " (tolerance) " µm." }
            (_, slight) => { "; at " (slight) " of them that costs no more than " (tolerance) " µm." }
        }
    }
}

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
pub(super) fn unproven(page: &Page) -> Markup {
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
                            (found.run.run.material.words()) ": " (plain(&pose_doubts(found.pose)))
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

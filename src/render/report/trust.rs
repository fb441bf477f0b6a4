//! Whether to trust the numbers, and why.

use super::Page;
use super::measured::sentence;
use super::words::{bound, fine, j_wt, written};
use crate::compare::{Verdict, touches_off_line};
use crate::mesh::Method;
use crate::outcome::{MODELS, count, deviation};
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
                    "circle, is 1 µm less backlash there."
                }
            }
        }
    }
}

fn disagreeing(page: &Page) -> usize {
    count(&page.all, Verdict::Above) + count(&page.all, Verdict::Below)
}

fn answer(page: &Page) -> String {
    match (disagreeing(page), count(&page.all, Verdict::OffLine)) {
        (0, 0) if page.whole.least.is_none() => {
            "There is no number to trust: at no pose is the free gear free to turn and held by its mate.".to_owned()
        }
        (0, 0) => {
            "Yes, for the gears as measured: simulation and formula agree at every pose.".to_owned()
        }
        (0, off) => format!(
            "Yes, for the gears as measured: simulation and formula agree at {} of {} poses; at the other {off} the teeth touch off the line of action, where the formula does not hold.",
            count(&page.all, Verdict::Agrees),
            count(&page.all, Verdict::Agrees) + off
        ),
        (bad, _) => format!(
            "Not without a look: at {bad} poses simulation and formula disagree for no reason found. Please report the pair file."
        ),
    }
}

fn certificate(page: &Page) -> Markup {
    let how = match page.report.method {
        Method::Exact { certify: true } => {
            "Each rotation was found on the exact tooth curves and certified by polygons: a little more open everything is clear, a little more closed something touches. "
        }
        Method::Exact { certify: false } => {
            "Each rotation was found on the exact tooth curves; the check by polygons was left out (--no-certify). "
        }
        Method::Polygon => "Each rotation was found on polygons cut ever finer round the contact. ",
        Method::Both => {
            "Each rotation was found twice, on the exact tooth curves and on polygons. "
        }
    };
    let largest = page
        .all
        .iter()
        .flat_map(|run| &run.poses)
        .filter_map(|pose| pose.swept.polygon_difference)
        .map(f64::abs)
        .reduce(f64::max);
    html! {
        (how)
        @if let Some(largest) = largest { "Both lie within " (bound(largest)) " µm. " }
        @if let Some(error) = page.whole.error_bound {
            "The numerical error of " (j_wt()) " is at most " (bound(error)) " µm."
        }
    }
}

fn formula(page: &Page) -> Markup {
    let agrees = count(&page.all, Verdict::Agrees);
    let off = page
        .all
        .iter()
        .flat_map(|run| &run.poses)
        .filter(|pose| touches_off_line(&pose.swept.lost_motion))
        .count();
    let [.., line_of_action] = MODELS;
    html! {
        "The line-of-action formula, which shares nothing with the simulation but the gears’ data, agrees within "
        (written(page.report.study.tolerance_um)) " µm at " (agrees) " of " (page.whole.poses) " poses"
        @if let Some(deviation) = deviation(&page.all, line_of_action) {
            "; the largest difference is " (fine(Some(deviation.largest))) " µm"
        }
        ". "
        @match off {
            0 => "Only involutes touch, at every pose.",
            1 => "At one pose a tip corner, a fillet or a root takes part in a contact.",
            _ => { "At " (off) " poses a tip corner, a fillet or a root takes part in a contact." }
        }
    }
}

//! The poses that the result covers.

use super::page::Page;
use super::phrases::few;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::outcome::PoseOfRun;
use gearlash::analysis::phases::phase;
use gearlash::pair::{GearPair, Member, SweepPlan};
use maud::{Markup, html};
use std::collections::BTreeSet;

/// The simulated poses, and results for the others.
pub(super) fn section(page: &Page) -> Markup {
    html! {
        p.note { (simulated(page)) }
        p.note { (other_poses(page)) (phases(page)) }
    }
}

fn simulated(page: &Page) -> String {
    let report = page.report;
    let poses = |runs: &[ComparedRun]| -> usize { runs.iter().map(|run| run.poses.len()).sum() };
    let turned = poses(&report.analysis.revolution);
    let requested = poses(&report.analysis.runs);
    let picked = poses(&report.analysis.extremes.runs);
    let mut parts = Vec::new();
    if report.pair.study.sweeps() {
        parts.push(format!("the {requested} of the pair file’s sweep, which “gearlash simulate” and “gearlash compare” report"));
        if turned > requested {
            parts.push(format!("the {} of the same wheel teeth and fractions with the left flank at the pitch point, for the curves", turned - requested));
        }
    } else {
        parts.push(format!("{turned} of whole wheel revolutions at 16 poses a pitch, with the right flank and with the left flank at the pitch point"));
        parts.push(format!("the {requested} that the pair file asks for, which “gearlash simulate” and “gearlash compare” report"));
    }
    if picked > 0 {
        parts.push(format!("{picked} at the extremes of the whole mesh cycle"));
    }
    let words = match parts.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{}, and {last}", rest.join(", ")),
        _ => parts.join(""),
    };
    let extremes = match (page.whole.least, page.whole.unproven) {
        (Some(_), 0) => " Least and greatest are over all of them.",
        (Some(_), _) => " Least and greatest are over those that are proven.",
        (None, _) => "",
    };
    let added = poses(&report.analysis.curves).saturating_sub(turned);
    let drawn = match added {
        0 => String::new(),
        _ => format!(
            " The curves go through {added} more poses, where they bend; these are drawn and not counted."
        ),
    };
    format!("Over {} poses: {words}.{extremes}{drawn}", page.whole.poses)
}

fn other_poses(page: &Page) -> Markup {
    let extremes = &page.report.analysis.extremes.each;
    let matings = extremes.iter().map(|run| run.matings).max().unwrap_or(0);
    let unproven = extremes.iter().filter(|run| !run.is_proven()).count();
    html! {
        @if extremes.iter().all(|run| run.assembly.data().is_some_and(|pair| differ(pair) == [false; 2])) {
            "All teeth of each gear are equal, and so are all matings. "
        }
        "The hunting cycle is " (matings) " matings. Least and greatest backlash are "
        "bracketed over all of them and every rotation between"
        @match unproven {
            0 => ", and proven.",
            some if some == extremes.len() => { ", but " strong { "not proven" } "." },
            some => { "; " strong { (some) " of " (extremes.len()) " brackets are not proven" } "." },
        }
    }
}

/// Whether the teeth of wheel and pinion differ.
fn differ(pair: &GearPair) -> [bool; 2] {
    Member::BOTH.map(|member| pair.gear(member).has_different_teeth())
}

/// The assembly phases of the poses.
fn phases(page: &Page) -> Markup {
    let study = &page.report.pair.study;
    let first = page.report.analysis.revolution.first();
    let first = first.and_then(|run| Some((run, run.poses.first()?)));
    let (Some((run, pose)), false) = (first, matches!(study.sweep, Some(SweepPlan::Phases { .. })))
    else {
        return html! {};
    };
    let [wheel, pinion] = Member::BOTH.map(|member| run.run.assembly.teeth(member));
    let ways = SweepPlan::phase_count(wheel, pinion);
    let mating = pose.simulated.pose.mating();
    // Where one gear is perfect, the phase does not matter.
    let pair = run.run.assembly.data();
    let matters = ways > 1 && pair.is_some_and(|pair| differ(pair) == [true; 2]);
    let way = phase(&run.run.assembly, mating);
    let requested = page.report.analysis.runs.iter().flat_map(|run| {
        let poses = run.poses.iter();
        poses.map(|pose| phase(&run.run.assembly, pose.simulated.pose.mating()))
    });
    let elsewhere: Vec<u32> = requested.filter(|other| *other != way).collect();
    let other_ways = BTreeSet::from_iter(elsewhere.iter().copied());
    let other_ways = Vec::from_iter(other_ways);
    html! {
        @if matters {
            " Wheel tooth " (mating.wheel_tooth) " meets pinion tooth " (mating.pinion_tooth)
            @if ways == 2 { "; there is one other way" } @else { "; there are " (ways - 1) " other ways" }
            " to put the gears together, with other backlash (" code { "[sweep] phases = \"all\"" } ")."
            @if !elsewhere.is_empty() {
                " Of the poses that the pair file asks for, " (elsewhere.len())
                (if elsewhere.len() == 1 { " belongs" } else { " belong" }) " to another phase: the teeth that it names meet at "
                "those flanks where wheel tooth 1 meets pinion tooth " (few(&other_ways, u32::to_string)) "."
            }
        }
    }
}

/// Whether backlash is equal at every pose of the centre distance and material of `found`.
pub(super) fn is_constant(page: &Page, found: PoseOfRun) -> bool {
    let run = &found.run.run;
    let mut distances = page.distances.iter();
    let here = distances.find(|at| at.center_distance == run.assembly.center_distance());
    let mut materials = here.into_iter().flat_map(|at| &at.materials);
    materials.any(|(end, of)| *end == run.material && of.uniform)
}

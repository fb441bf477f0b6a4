//! Which poses the result is of, and which it is not.

use super::page::Page;
use super::phrases::few;
use gearlash::analysis::cycle::RemainingMatings;
use gearlash::analysis::outcome::Found;
use gearlash::analysis::phases::phase;
use gearlash::pair::{Member, SweepPlan};
use maud::{Markup, html};
use std::collections::BTreeSet;

/// What limits the verdict, where something does.
pub(super) fn limit(page: &Page) -> Option<String> {
    let cycle = &page.report.analysis.cycle;
    match cycle.others {
        RemainingMatings::TooMany { .. } => Some(format!(
            "That is so at the {} of {} matings that were simulated; other matings can have less backlash",
            cycle.simulated, cycle.matings
        )),
        RemainingMatings::None | RemainingMatings::Seen { .. } => None,
    }
}

/// Which poses were simulated, and what is known of the others.
pub(super) fn section(page: &Page) -> Markup {
    html! {
        p.note { (simulated(page)) }
        p.note { (others(page)) (phases(page)) }
    }
}

fn simulated(page: &Page) -> String {
    let report = page.report;
    let poses = |runs: &[gearlash::analysis::compare::ComparedRun]| -> usize {
        runs.iter().map(|run| run.poses.len()).sum()
    };
    let (turned, asked) = (
        poses(&report.analysis.revolution),
        poses(&report.analysis.runs),
    );
    let picked = poses(&report.analysis.cycle.extremes);
    let mut parts = Vec::new();
    match report.pair.study.sweeps() {
        true => {
            parts.push(format!("the {asked} of the pair file’s sweep, which “gearlash simulate” and “gearlash compare” report"));
            parts.push(format!("the {} of the same wheel teeth and fractions with the left flank at the pitch point, for the curves", turned - asked));
        }
        false => {
            parts.push(format!("{turned} of whole wheel revolutions at 16 poses a pitch, with the right flank and with the left flank at the pitch point"));
            parts.push(format!("the {asked} that the pair file asks for, which “gearlash simulate” and “gearlash compare” report"));
        }
    }
    if picked > 0 {
        parts.push(format!("{picked} at the extremes of the other matings"));
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
    format!("Over {} poses: {words}.{extremes}", page.whole.poses)
}

fn others(page: &Page) -> Markup {
    let cycle = &page.report.analysis.cycle;
    let (simulated, matings) = (cycle.simulated, cycle.matings);
    html! {
        @match cycle.others {
            RemainingMatings::None if matings == 1 => "Neither gear has deviations: all matings are alike.",
            RemainingMatings::None => { "The hunting cycle is " (matings) " matings, and all were simulated." }
            RemainingMatings::Seen { steps_per_pitch, poses } => {
                "These revolutions meet " (simulated) " of " (matings) " matings. The others were searched too, on the exact tooth "
                "curves (" (poses) " poses, " (steps_per_pitch) " a pitch); where backlash is least and greatest, the pair was simulated like the rest."
                @if cycle.lost > 0 {
                    " " strong { "At " (cycle.lost) " of them the contact was lost: they are unproven" }
                    ", and can have less backlash, or none."
                }
            }
            RemainingMatings::TooMany { most } => {
                strong { "These revolutions meet " (simulated) " of " (matings) " matings" }
                "; the others were not searched (at one pose a pitch they are more than " (most) "): they can have less backlash, and more."
            }
        }
    }
}

/// In which of several ways the gears are put together.
fn phases(page: &Page) -> Markup {
    let study = &page.report.pair.study;
    let first = page
        .report
        .analysis
        .revolution
        .first()
        .and_then(|run| run.poses.first().map(|pose| (run, pose)));
    let (Some((run, pose)), false) = (first, matches!(study.sweep, Some(SweepPlan::Phases { .. })))
    else {
        return html! {};
    };
    let [wheel, pinion] = [Member::Wheel, Member::Pinion]
        .map(|member| run.run.assembly.gear(member).gear().basic_data().teeth());
    let ways = SweepPlan::phase_count(wheel, pinion);
    let mating = pose.swept.pose.mating();
    // Where one gear is perfect, it does not matter which of its teeth are met.
    let matters =
        page.report.analysis.cycle.matings == SweepPlan::hunting_pitches(wheel, pinion) && ways > 1;
    let way = phase(&run.run.assembly, mating);
    let asked = page.report.analysis.runs.iter().flat_map(|run| {
        let poses = run.poses.iter();
        poses.map(|pose| phase(&run.run.assembly, pose.swept.pose.mating()))
    });
    let elsewhere: Vec<u32> = asked.filter(|other| *other != way).collect();
    let other_ways: Vec<u32> = BTreeSet::from_iter(elsewhere.iter().copied())
        .into_iter()
        .collect();
    html! {
        @if matters {
            " Wheel tooth " (mating.wheel_tooth) " meets pinion tooth " (mating.pinion_tooth) "; there are " (ways - 1)
            " other ways to put the gears together, with other backlash (" code { "[sweep] phases = \"all\"" } ")."
            @if !elsewhere.is_empty() {
                " Of the poses that the pair file asks for, " (elsewhere.len()) " belong to another phase: the teeth that it names meet at "
                "those flanks where wheel tooth 1 meets pinion tooth " (few(&other_ways, u32::to_string)) "."
            }
        }
    }
}

/// Whether backlash is the same at every pose of the centre distance and material of `found`.
pub(super) fn same_everywhere(page: &Page, found: Found) -> bool {
    let run = &found.run.run;
    let mut distances = page.distances.iter();
    let here = distances.find(|at| at.center_distance == run.assembly.center_distance());
    let mut materials = here.into_iter().flat_map(|at| &at.materials);
    materials.any(|(end, of)| *end == run.material && of.uniform)
}

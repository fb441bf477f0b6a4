//! The answer: whether the pair assembles, how much backlash it has, where, at which teeth, and over which poses.

use super::page::Page;
use super::phrases::{band, j_wt, limits, touching, with_symbols};
use super::table::{Table, cells, columns, mark, marked};
use super::trust::count;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::diagnosis::CheckVerdict;
use gearlash::analysis::extremes::{BearingEnd, RunExtreme};
use gearlash::analysis::outcome::{Outcome, PoseOfRun};
use gearlash::analysis::phases::phase;
use gearlash::analysis::verdict::Verdict;
use gearlash::gear::has_different_teeth;
use gearlash::pair::{GearPair, Member, SweepPlan};
use gearlash_results::text::check::titles;
use gearlash_results::verdict::{VerdictLines, uncut};
use gearlash_text::numbers::{stated_distance, um};
use maud::{Markup, Render, html};

pub(super) fn section(page: &Page) -> Markup {
    let required = limits(&page.report.pair.study.requirements).join(", ");
    html! {
        section id="result" {
            div.verdict.(state(page).name()) {
                p.state { (mark(state(page))) }
                @if !required.is_empty() { p { "Required: " (with_symbols(&required)) "." } }
                (verdict(page))
                @if !(page.report.pair.study.bearing_clearance > 0.0) {
                    p { "Bearing clearance: none is stated; the axes are assumed fixed at the centre distance." }
                }
                (failing(page))
            }
            (table(page))
            p.note { (simulated(page)) }
            p.note { (other_poses(page)) (phases(page)) }
        }
    }
}

/// The worst verdict of the answer and the checks.
fn state(page: &Page) -> CheckVerdict {
    let poses = match page.whole.unproven {
        0 => CheckVerdict::Pass,
        _ => CheckVerdict::Unproven,
    };
    let answer = page.report.analysis.verdict().state();
    answer
        .max(poses)
        .max(page.report.analysis.diagnosis.verdict())
}

fn failing(page: &Page) -> Markup {
    let diagnosis = &page.report.analysis.diagnosis;
    html! {
        @for (verdict, word) in [(CheckVerdict::Fail, "failed"), (CheckVerdict::Unproven, "unproven"), (CheckVerdict::Warn, "with a warning")] {
            @let titles = titles(diagnosis, verdict).join(", ");
            @if !titles.is_empty() {
                p { a href="#checks" { "Checks" } " " (word) ": " (titles) "." }
            }
        }
    }
}

/// The verdict, and the number of poses it excludes. Failing checks are listed below it.
fn verdict(page: &Page) -> Markup {
    let verdict = Verdict {
        failed_checks: Vec::new(),
        ..page.report.analysis.verdict()
    };
    html! {
        (answer(&uncut(&verdict)))
        @if let Some(count) = count(page) { p.proof { (count) "." } }
    }
}

/// The verdict's lines: least and greatest in large type, the proof in small type.
pub(super) fn answer(lines: &VerdictLines) -> Markup {
    html! {
        p.answer { (lines.status) }
        @if !lines.extremes.is_empty() {
            dl.extremes {
                @for row in &lines.extremes {
                    div {
                        dt { (row.name) " backlash" }
                        dd.value { (row.value) }
                        @if let Some((arcmin, member)) = &row.arcmin { dd { (arcmin) " arcmin at the " (member.name()) } }
                        dd { (row.place_words()) }
                    }
                }
            }
        }
        @for qualifier in &lines.qualifiers { p { (with_symbols(qualifier)) } }
        @if !lines.proof.is_empty() { p.proof { (lines.proof) } }
    }
}

fn table(page: &Page) -> Markup {
    let study = &page.report.pair.study;
    let c = study.bearing_clearance;
    let play = stated_distance(c);
    let mut columns = columns(&format!(
        "a mm:n | assembles | least:n | teeth at least:w | mean:n | greatest:n | teeth at greatest:w | with a ± {play} mm:n"
    ));
    columns[7].is_shown = c > 0.0;
    let rows = page.distances.iter().map(|at| {
        let [least, greatest] = [at.all.least, at.all.greatest].map(|found| extreme(page, found));
        let [(least, teeth_at_least), (greatest, teeth_at_greatest)] = [least, greatest];
        cells![
            stated_distance(at.center_distance),
            assembles_cell(&at.all, is_settled(page, at.center_distance)),
            least,
            teeth_at_least,
            um(at.all.mean, 2),
            greatest,
            teeth_at_greatest,
            band(with_clearance(page, at.center_distance), 2),
        ]
    });
    let caption = html! {
        "Circumferential backlash " (j_wt()) " on the operating pitch circle, µm"
        @if study.materials.len() > 1 { ", from most to least material" }
        ". Teeth: wheel·pinion, right flanks / left flanks in contact."
    };
    let table = Table::new("Backlash at each centre distance", caption, columns, rows);
    table.big().render()
}

/// Least and greatest backlash at a centre distance, with the axes moved as far as their bearings allow.
fn with_clearance(page: &Page, center_distance: f64) -> [Option<f64>; 2] {
    let runs = page.report.analysis.extremes.each.iter();
    let here = runs.filter(|run| run.assembly.center_distance() == center_distance);
    let ends = here.filter_map(|run| run.bearings.as_ref());
    let found = |end: &BearingEnd| end.extreme.as_ref().map(RunExtreme::found);
    let least = ends.clone().filter_map(|play| found(&play.pressed));
    let greatest = ends.filter_map(|play| found(&play.pulled_apart));
    [least.reduce(f64::min), greatest.reduce(f64::max)]
}

/// The backlash of a pose and its teeth in contact.
fn extreme(page: &Page, found: Option<PoseOfRun>) -> (Markup, String) {
    let [right, left] = touching(found);
    let teeth = if found.is_some_and(|found| is_constant(page, found)) {
        "all alike".to_owned()
    } else {
        format!("{right} / {left}")
    };
    let j_wt = found.and_then(|found| found.pose.simulated.backlash);
    (html! { strong { (um(j_wt, 2)) } }, teeth)
}

/// Whether every run of the mesh cycle at a centre distance proves that it assembles, or that it does not.
fn is_settled(page: &Page, center_distance: f64) -> bool {
    let verdict = page.report.analysis.verdict();
    let mut here = verdict
        .runs
        .iter()
        .filter(|run| run.assembly.center_distance() == center_distance);
    here.all(|run| run.assembles().is_some())
}

/// Whether a pair assembles, in a word or two, from its poses and whether the mesh cycle is settled.
fn assembles_cell(all: &Outcome, settled: bool) -> Markup {
    let (verdict, word) = match all {
        all if all.jammed > 0 => (CheckVerdict::Fail, "no: jammed"),
        all if all.interfering > 0 => (CheckVerdict::Fail, "no: interference"),
        all if all.out_of_mesh > 0 => (CheckVerdict::Fail, "out of mesh"),
        all if all.unproven > 0 => (CheckVerdict::Unproven, "unproven"),
        _ if !settled => (CheckVerdict::Unproven, "not proven"),
        all if all.touching > 0 => (CheckVerdict::Warn, "without backlash"),
        _ => (CheckVerdict::Pass, "yes"),
    };
    marked(verdict, word)
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
    Member::BOTH.map(|member| has_different_teeth(pair.gear(member)))
}

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
    let mut other_ways = elsewhere.clone();
    other_ways.sort_unstable();
    other_ways.dedup();
    let few = other_ways.iter().take(6).map(u32::to_string);
    let few: Vec<String> = few.collect();
    html! {
        @if matters {
            " Wheel tooth " (mating.wheel_tooth) " meets pinion tooth " (mating.pinion_tooth)
            @if ways == 2 { "; there is one other way" } @else { "; there are " (ways - 1) " other ways" }
            " to put the gears together, with other backlash (" code { "[sweep] phases = \"all\"" } ")."
            @if !elsewhere.is_empty() {
                " Of the poses that the pair file asks for, " (elsewhere.len())
                (if elsewhere.len() == 1 { " belongs" } else { " belong" }) " to another phase: the teeth that it names meet at "
                "those flanks where wheel tooth 1 meets pinion tooth " (few.join(", ")) @if other_ways.len() > few.len() { ", …" } "."
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

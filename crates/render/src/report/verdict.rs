//! The answer: whether the pair assembles, how much backlash it has, where, and at which teeth.

use super::cycle::is_constant;
use super::marks::{mark, marked};
use super::page::Page;
use super::phrases::{band, j_wt, touching, with_symbols};
use super::table::{Table, cells, columns};
use super::{cycle, unproven};
use gearlash::analysis::diagnosis::Verdict;
use gearlash::analysis::extremes::{BearingEnd, RunExtreme};
use gearlash::analysis::outcome::{Outcome, PoseOfRun};
use gearlash::analysis::verdict::Verdict as CycleVerdict;
use gearlash_files::numbers::{stated_distance, um};
use gearlash_results::text::check::titles;
use gearlash_results::verdict::{VerdictLines, lines};
use maud::{Markup, Render, html};

pub(super) fn section(page: &Page) -> Markup {
    html! {
        section id="result" {
            div.verdict.(state(page).name()) {
                p.state { (mark(state(page))) }
                (verdict(page))
                (clearance(page))
                (failing(page))
            }
            (table(page))
            (cycle::section(page))
        }
    }
}

/// The worst verdict of the answer and the checks.
fn state(page: &Page) -> Verdict {
    let poses = match page.whole.unproven {
        0 => Verdict::Pass,
        _ => Verdict::Unproven,
    };
    let answer = page.report.analysis.verdict().state();
    answer
        .max(poses)
        .max(page.report.analysis.diagnosis.verdict())
}

/// The titles of the checks that do not pass.
fn failing(page: &Page) -> Markup {
    let diagnosis = &page.report.analysis.diagnosis;
    html! {
        @for (verdict, word) in [(Verdict::Fail, "failed"), (Verdict::Unproven, "unproven"), (Verdict::Warn, "with a warning")] {
            @let titles = titles(diagnosis, verdict).join(", ");
            @if !titles.is_empty() {
                p { a href="#checks" { "Checks" } " " (word) ": " (titles) "." }
            }
        }
    }
}

/// The verdict, and the number of poses it excludes. Failing checks are listed below it.
fn verdict(page: &Page) -> Markup {
    let verdict = CycleVerdict {
        failed_checks: Vec::new(),
        ..page.report.analysis.verdict()
    };
    html! {
        (answer(&lines(&verdict)))
        @if let Some(count) = unproven::count(page) { p.proof { (count) "." } }
    }
}

/// The verdict's lines: least and greatest in large type, the proof in small type.
pub(super) fn answer(lines: &VerdictLines) -> Markup {
    html! {
        p.answer { (lines.status) }
        @if !lines.rows.is_empty() {
            dl.extremes {
                @for row in &lines.rows {
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

/// A note that bearings have no play, where none is stated; otherwise the verdict states the effect.
fn clearance(page: &Page) -> Markup {
    html! {
        @if !(page.report.pair.study.bearing_clearance > 0.0) {
            p { "Bearing clearance: none is stated; the axes are assumed fixed at the centre distance." }
        }
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
            band(with_play(page, at.center_distance), 2),
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
fn with_play(page: &Page, center_distance: f64) -> [Option<f64>; 2] {
    let runs = page.report.analysis.extremes.each.iter();
    let here = runs.filter(|run| run.assembly.center_distance() == center_distance);
    let ends = here.filter_map(|run| run.bearings.as_ref());
    let found = |end: &BearingEnd| end.extreme.as_ref().map(RunExtreme::found);
    let least = ends.clone().filter_map(|play| found(&play.pressed));
    let greatest = ends.filter_map(|play| found(&play.apart));
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
        all if all.jammed > 0 => (Verdict::Fail, "no: jammed"),
        all if all.interfering > 0 => (Verdict::Fail, "no: interference"),
        all if all.apart > 0 => (Verdict::Fail, "out of mesh"),
        all if all.unproven > 0 => (Verdict::Unproven, "unproven"),
        _ if !settled => (Verdict::Unproven, "not proven"),
        all if all.touching > 0 => (Verdict::Warn, "without backlash"),
        _ => (Verdict::Pass, "yes"),
    };
    marked(verdict, word)
}

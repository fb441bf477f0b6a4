//! The answer: does the pair assemble, how much backlash, where, which teeth.

use super::cycle::{limit, same_everywhere};
use super::marks::{mark, marked};
use super::page::Page;
use super::phrases::{band, few, j_wt, material, touching};
use super::{cycle, unproven};
use crate::text::check::governing;
use gearlash::analysis::diagnosis::Verdict;
use gearlash::analysis::outcome::{AtDistance, Found, Outcome};
use gearlash::analysis::phases::failing_phases;
use gearlash_files::numbers::{bound_um, stated_distance, um};
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    html! {
        section id="result" {
            div.verdict.(state(page).name()) {
                p.state { (mark(state(page))) }
                p.answer { (answer(page)) }
                (clearance(page))
                (failing(page))
            }
            (table(page))
            (cycle::section(page))
        }
    }
}

/// The worst of the answer and the checks.
fn state(page: &Page) -> Verdict {
    let whole = &page.whole;
    let answer = match (whole.assembles(), whole.fails()) {
        (true, _) => Verdict::Pass,
        (false, true) => Verdict::Fail,
        (false, false) => Verdict::Unproven,
    };
    answer.max(page.report.analysis.diagnosis.verdict())
}

/// The checks that do not pass, by name.
fn failing(page: &Page) -> Markup {
    let diagnosis = &page.report.analysis.diagnosis;
    let checks = governing(diagnosis);
    let named = |verdict: Verdict| {
        let of = checks.iter().filter(|(_, check)| check.verdict == verdict);
        let mut titles: Vec<&str> = Vec::new();
        for (_, check) in of {
            if !titles.contains(&check.title) {
                titles.push(check.title);
            }
        }
        titles.join(", ")
    };
    html! {
        @for (verdict, word) in [(Verdict::Fail, "failed"), (Verdict::Unproven, "unproven"), (Verdict::Warn, "with a warning")] {
            @let titles = named(verdict);
            @if !titles.is_empty() {
                p { a href="#checks" { "Checks" } " " (word) ": " (titles) "." }
            }
        }
    }
}

/// The verdict in a sentence, and what limits it.
fn answer(page: &Page) -> Markup {
    let whole = &page.whole;
    let partly = whole.least.is_some() && whole.jammed + whole.apart > 0;
    html! {
        (verdict(page))
        @if let (Some(count), Some(_)) = (unproven::count(page), whole.least) { ". " (count) ", and not in what follows" }
        @if partly { ". Where the gears are in mesh and free to turn" }
        @else if whole.unproven > 0 { ". At the poses that are proven" }
        @if let (Some(least), Some(greatest)) = (whole.least, whole.greatest) {
            @if whole.uniform {
                ": backlash " span.w { (um(least.pose.swept.backlash, 2)) " µm" } " at every pose"
            } @else {
                ": least backlash " (extreme(page, least)) "; greatest " (extreme(page, greatest))
            }
        }
        "."
        @if let Some(limit) = limit(page) { " " (limit) "." }
    }
}

fn verdict(page: &Page) -> String {
    let kept_by = |keeps: fn(&Outcome) -> bool| -> Vec<&AtDistance> {
        page.distances.iter().filter(|at| keeps(&at.all)).collect()
    };
    let number = page.distances.len();
    let tight = kept_by(|all| all.interfering + all.jammed > 0);
    let apart = kept_by(|all| all.apart > 0);
    let touching = kept_by(|all| all.touching > 0);
    if !tight.is_empty() {
        let phases = phases(page);
        return format!("Does not assemble {}{phases}", places(&tight, number));
    }
    if !apart.is_empty() {
        return format!("Out of mesh {}{}", places(&apart, number), phases(page));
    }
    // Least and greatest of what is proven say nothing about the rest.
    let unproven = kept_by(|all| all.unproven > 0);
    if !unproven.is_empty() {
        return format!(
            "Unproven: it is not known whether the pair assembles {}",
            places(&unproven, number)
        );
    }
    let none = format!(
        "without backlash (0 within the error bound of {} µm)",
        page.whole.error_bound.map_or("0".to_owned(), bound_um)
    );
    match &page.distances[..] {
        [] => "Nothing was run".to_owned(),
        [_] if !touching.is_empty() => format!("Assembles {none} {}", places(&touching, number)),
        [only] => format!(
            "Assembles at a = {} mm",
            stated_distance(only.center_distance)
        ),
        _ if !touching.is_empty() => {
            format!(
                "Assembles at {} centre distances, {none} {}",
                all_of(number),
                places(&touching, number)
            )
        }
        _ => format!("Assembles at {} centre distances", all_of(number)),
    }
}

/// All of several, in words.
fn all_of(number: usize) -> String {
    match number {
        2 => "both".to_owned(),
        more => format!("all {more}"),
    }
}

/// In which assembly phases, where they are run apart and it is not so in all.
fn phases(page: &Page) -> String {
    let (failing, all) = failing_phases(&page.report.analysis.revolution);
    if failing.len() == all {
        return match all {
            0 => String::new(),
            _ => ", in every assembly phase".to_owned(),
        };
    }
    let named = few(&failing, |(wheel, pinion)| format!("{wheel}·{pinion}"));
    format!(", in {} of {all} assembly phases ({named})", failing.len())
}

/// Up to four centre distances by name.
fn places(at: &[&AtDistance], number: usize) -> String {
    let named = at
        .iter()
        .take(4)
        .map(|at| stated_distance(at.center_distance));
    let named = named.collect::<Vec<_>>().join(", ");
    let more = match at.len() {
        0..=4 => String::new(),
        all => format!(" and {} more", all - 4),
    };
    match number {
        1 => format!("at a = {named} mm"),
        _ => format!(
            "at a = {named} mm{more} ({} of {number} centre distances)",
            at.len()
        ),
    }
}

fn extreme(page: &Page, found: Found) -> Markup {
    let run = &found.run.run;
    let [right, left] = touching(Some(found));
    html! {
        span.w { (um(found.pose.swept.backlash, 2)) " µm" } " at "
        span.w { i { "a" } " = " (stated_distance(run.assembly.center_distance())) " mm" }
        @if same_everywhere(page, found) {
            ", the same at every pose, "
        } @else {
            ", teeth " span.w { (right) } " (right flanks) and " span.w { (left) } " (left flanks), "
        }
        (material(run.material))
    }
}

fn clearance(page: &Page) -> Markup {
    let c = page.report.pair.study.bearing_clearance;
    if !(c > 0.0) {
        return html! {
            p { "Bearing clearance: none is stated; the axes are assumed fixed at the centre distance." }
        };
    }
    let whole = &page.whole;
    let ends = whole.with_clearance;
    let tighter = ends[0].is_some_and(|least| least < 0.0) || whole.without_value[0] > 0;
    let binds = whole.assembles() && tighter;
    html! {
        p {
            "With the bearing clearance taken in (" i { "a" } " ± " (stated_distance(c)) " mm) "
            @if ends == [None, None] {
                "no pose has a value: the gears are jammed or out of mesh there"
                @if whole.unproven_ends != [0, 0] { ", or it is unproven" }
            } @else {
                "backlash lies within " span.w { (band(ends, 2)) " µm" } " over all centre distances"
                @if whole.unproven_ends != [0, 0] { " where it is proven" }
                @for (end, poses) in ["−", "+"].into_iter().zip(whole.without_value) {
                    @if poses > 0 {
                        "; at " (poses) " of " (whole.poses) " poses the gears are jammed or out of mesh at "
                        span.w { i { "a" } " " (end) " " (stated_distance(c)) " mm" }
                    }
                }
            }
            @if binds { strong { ": pushed together in their bearings, the gears bind" } }
            "."
        }
    }
}

fn table(page: &Page) -> Markup {
    let study = &page.report.pair.study;
    let c = study.bearing_clearance;
    html! {
        div.scroll tabindex="0" role="region" aria-label="Backlash at each centre distance" {
            table.big {
                caption {
                    "Circumferential backlash " (j_wt()) " on the operating pitch circle, µm"
                    @if study.materials.len() > 1 { ", from most to least material" }
                    ". Teeth: wheel·pinion, right flanks / left flanks in contact."
                }
                thead { tr {
                    th.n scope="col" { i { "a" } " mm" }
                    th scope="col" { "assembles" }
                    th.n scope="col" { "least" }
                    th scope="col" { "teeth at least" }
                    th.n scope="col" { "mean" }
                    th.n scope="col" { "greatest" }
                    th scope="col" { "teeth at greatest" }
                    @if c > 0.0 { th.n scope="col" { "with " i { "a" } " ± " (stated_distance(c)) " mm" } }
                } }
                tbody {
                    @for at in &page.distances {
                        tr {
                            th.n scope="row" { (stated_distance(at.center_distance)) }
                            (fits(&at.all))
                            (extreme_cells(page, at.all.least))
                            td.n { (um(at.all.mean, 2)) }
                            (extreme_cells(page, at.all.greatest))
                            @if c > 0.0 { td.n { (band(at.all.with_clearance, 2)) } }
                        }
                    }
                }
            }
        }
    }
}

fn extreme_cells(page: &Page, found: Option<Found>) -> Markup {
    let [right, left] = touching(found);
    let same = found.is_some_and(|found| same_everywhere(page, found));
    html! {
        td.n { strong { (um(found.and_then(|found| found.pose.swept.backlash), 2)) } }
        td.w { @if same { "all alike" } @else { (right) " / " (left) } }
    }
}

/// Whether a pair assembles, in a word or two.
fn fits(all: &Outcome) -> Markup {
    let (verdict, word) = match all {
        all if all.jammed > 0 => (Verdict::Fail, "no: jammed"),
        all if all.interfering > 0 => (Verdict::Fail, "no: interference"),
        all if all.apart > 0 => (Verdict::Fail, "out of mesh"),
        all if all.unproven > 0 => (Verdict::Unproven, "unproven"),
        all if all.touching > 0 => (Verdict::Warn, "without backlash"),
        _ => (Verdict::Pass, "yes"),
    };
    html! { td { (marked(verdict, word)) } }
}

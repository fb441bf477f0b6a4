//! The answer: does the pair assemble, how much backlash, where, which teeth.

use super::Page;
use super::words::{band, distance, j_wt, material, touching, um};
use crate::outcome::{AtDistance, Found, Outcome};
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    let good = page.whole.assembles();
    html! {
        section id="result" {
            div.verdict.bad[!good] {
                p.answer { (answer(page)) }
                (clearance(page))
            }
            (table(page))
            p.note { (poses(page)) }
        }
    }
}

/// The verdict in a sentence.
fn answer(page: &Page) -> Markup {
    html! {
        (verdict(page))
        @if let (Some(least), Some(greatest)) = (page.whole.least, page.whole.greatest) {
            ": least backlash " (extreme(least)) "; greatest " (extreme(greatest))
        }
        "."
    }
}

fn verdict(page: &Page) -> String {
    let kept_by = |keeps: fn(&Outcome) -> bool| -> Vec<&AtDistance> {
        page.distances.iter().filter(|at| keeps(&at.all)).collect()
    };
    let number = page.distances.len();
    let tight = kept_by(|all| all.interfering + all.jammed > 0);
    let apart = kept_by(|all| all.apart > 0);
    if !tight.is_empty() {
        return format!("Does not assemble {}", places(&tight, number));
    }
    if !apart.is_empty() {
        return format!("Out of mesh {}", places(&apart, number));
    }
    match &page.distances[..] {
        [] => "Nothing was run".to_owned(),
        [only] => format!("Assembles at a = {} mm", distance(only.center_distance)),
        _ => format!("Assembles at all {number} centre distances"),
    }
}

/// Up to four centre distances by name.
fn places(at: &[&AtDistance], number: usize) -> String {
    let named = at.iter().take(4).map(|at| distance(at.center_distance));
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

fn extreme(found: Found) -> Markup {
    let run = &found.run.run;
    let [right, left] = touching(Some(found));
    html! {
        span.w { (um(found.pose.swept.backlash, 2)) " µm" } " at "
        span.w { i { "a" } " = " (distance(run.assembly.center_distance())) " mm" }
        ", teeth " span.w { (right) } " (right flanks) and " span.w { (left) } " (left flanks), "
        (material(run.material))
    }
}

fn clearance(page: &Page) -> Markup {
    let c = page.report.study.bearing_clearance;
    if !(c > 0.0) {
        return html! {
            p { "Bearing clearance: none is stated; the axes are taken to stand at the centre distance." }
        };
    }
    let ends = page.whole.with_clearance;
    let lost = page.whole.assembles() && ends[0].is_some_and(|least| least < 0.0);
    html! {
        p {
            "With the bearing clearance taken in (" i { "a" } " ± " (distance(c)) " mm) backlash lies within "
            span.w { (band(ends, 2)) " µm" } " over all centre distances"
            @if lost { strong { ": pushed together in their bearings, the gears bind" } }
            "."
        }
    }
}

fn table(page: &Page) -> Markup {
    let study = page.report.study;
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
                    th scope="col" { "teeth that bind" }
                    th.n scope="col" { "mean" }
                    th.n scope="col" { "greatest" }
                    th scope="col" { "teeth there" }
                    @if c > 0.0 { th.n scope="col" { "with " i { "a" } " ± " (distance(c)) " mm" } }
                } }
                tbody {
                    @for at in &page.distances {
                        tr {
                            th.n scope="row" { (distance(at.center_distance)) }
                            (fits(&at.all))
                            (extreme_cells(at.all.least))
                            td.n { (um(at.all.mean, 2)) }
                            (extreme_cells(at.all.greatest))
                            @if c > 0.0 { td.n { (band(at.all.with_clearance, 2)) } }
                        }
                    }
                }
            }
        }
    }
}

fn extreme_cells(found: Option<Found>) -> Markup {
    let [right, left] = touching(found);
    html! {
        td.n { strong { (um(found.and_then(|found| found.pose.swept.backlash), 2)) } }
        td.w { (right) " / " (left) }
    }
}

/// Whether a pair assembles, in a word or two.
fn fits(all: &Outcome) -> Markup {
    html! {
        @if all.jammed > 0 { td.fail { "no: jammed" } }
        @else if all.interfering > 0 { td.fail { "no: interference" } }
        @else if all.apart > 0 { td.fail { "out of mesh" } }
        @else { td { "yes" } }
    }
}

/// Which poses the table is of.
fn poses(page: &Page) -> String {
    let report = page.report;
    let turned: usize = report.revolution.iter().map(|run| run.poses.len()).sum();
    let asked: usize = report.runs.iter().map(|run| run.poses.len()).sum();
    match report.sweeps() {
        true => format!(
            "Over {turned} poses: the sweep of the pair file at each centre distance and material."
        ),
        false => format!(
            "Over {} poses: {turned} of whole wheel revolutions at 16 poses a pitch, and the {asked} that the pair file asks for.",
            turned + asked
        ),
    }
}

//! Backlash over the teeth and over the centre distance, and the mesh itself.

use super::figures::{charted, folded, over_distance, revolutions};
use super::page::Page;
use crate::chart::PictureError;
use crate::map::backlash_map_in_page;
use crate::viewer;
use gearlash::analysis::outcome::{Outcome, PoseOfRun};
use gearlash::analysis::phases::phase_groups;
use gearlash::analysis::tally::{RunTally, tally};
use gearlash_files::numbers::{stated_distance, um};
use maud::{Markup, PreEscaped, html};

pub(super) fn section(page: &Page) -> Result<Markup, PictureError> {
    let charts = charted(page);
    let charts: Vec<_> = charts
        .iter()
        .map(|(id, course)| (id.as_str(), *course))
        .collect();
    let mesh = viewer::fragment(page.report.analysis, &charts)
        .map_err(|error| PictureError(format!("the poses cannot be written: {error}")))?;
    Ok(html! {
        section id="backlash" {
            h2 { "Backlash and mesh" }
            (revolutions(page)?)
            @if !mesh.is_empty() {
                h3 { "The mesh" }
                (PreEscaped(mesh))
            }
            h3 { "Over the centre distance" }
            @if page.report.pair.study.is_drawn() { (maps(page)) } @else { (over_distance(page)?) }
            h3 { "Each centre distance and material" }
            (materials(page))
            (phases(page))
        }
    })
}

/// Backlash of a drawn pair over the mesh cycle and the centre distance.
fn maps(page: &Page) -> Markup {
    let title = &page.report.pair.study.title;
    html! {
        p {
            "How much backlash is left at each centre distance, all round the mesh cycle. Where interference reaches farther up than "
            "elsewhere, that tooth interferes first."
        }
        @for map in &page.report.analysis.maps {
            figure.chart.tall tabindex="0" { (PreEscaped(backlash_map_in_page(title, map))) }
        }
    }
}

/// Each centre distance and material.
fn materials(page: &Page) -> Markup {
    let rows = page
        .distances
        .iter()
        .flat_map(|at| at.materials.iter().map(move |(end, of)| (at, *end, of)));
    let rows: Vec<_> = rows.collect();
    let table = html! {
        div.scroll tabindex="0" role="region" aria-label="Backlash of each centre distance and material" {
            table {
                caption { "Backlash, µm, and how many poses there are" }
                thead { tr {
                    th.n scope="col" { i { "a" } " mm" }
                    th scope="col" { "material" }
                    th.n scope="col" { "poses" }
                    th.n scope="col" { "least" }
                    th.n scope="col" { "mean" }
                    th.n scope="col" { "greatest" }
                    th.n scope="col" { "interfering" }
                    th.n scope="col" { "jammed" }
                    th.n scope="col" { "out of mesh" }
                    @if page.whole.unproven > 0 { th.n scope="col" { "unproven" } }
                } }
                tbody { @for (at, end, of) in &rows {
                    tr {
                        th.n scope="row" { (stated_distance(at.center_distance)) }
                        td.w { (end.words()) }
                        (counts(of))
                        @if page.whole.unproven > 0 { td.n { (of.unproven) } }
                    }
                } }
            }
        }
    };
    folded(rows.len(), "Each centre distance and material", &table)
}

/// Which teeth to mark together, where phases are run apart.
fn phases(page: &Page) -> Markup {
    let runs = tally(&page.report.analysis.revolution);
    let groups = phase_groups(&runs);
    let cells = |run: Option<&RunTally>| {
        let phase = run.and_then(|run| run.phase);
        html! {
            td { (phase.map_or("–".to_owned(), |(wheel, pinion)| format!("{wheel}·{pinion}"))) }
            td.n { (um(run.and_then(|run| run.summary().min), 2)) }
            td.n { (um(run.and_then(RunTally::variation), 2)) }
        }
    };
    let assemble = |runs: &[&RunTally]| runs.iter().filter(|run| run.assembles()).count();
    let table = html! {
        @if !groups.is_empty() {
            div.scroll tabindex="0" role="region" aria-label="Assembly phases" {
                table {
                    caption { "Assembly phases: teeth to mark together (wheel·pinion), the least backlash then, and how much it varies, µm" }
                    thead { tr {
                        th.n scope="col" { i { "a" } " mm" }
                        th scope="col" { "material" }
                        th.n scope="col" { "phases" } th.n scope="col" { "assemble" }
                        th scope="col" { "best" } th.n scope="col" { "least" } th.n scope="col" { "varies by" }
                        th scope="col" { "worst" } th.n scope="col" { "least" } th.n scope="col" { "varies by" }
                    } }
                    tbody { @for group in &groups {
                        tr {
                            @if let Some(run) = group.runs.first() {
                                th.n scope="row" { (stated_distance(run.assembly.center_distance())) }
                                td.w { (run.material.words()) }
                            }
                            td.n { (group.runs.len()) }
                            td.n { (assemble(&group.runs)) }
                            (cells(group.best))
                            (cells(group.worst))
                        }
                    } }
                }
            }
        }
    };
    folded(groups.len(), "Assembly phases", &table)
}

fn counts(of: &Outcome) -> Markup {
    let backlash = |found: Option<PoseOfRun>| um(found.and_then(|f| f.pose.simulated.backlash), 2);
    html! {
        td.n { (of.poses) }
        td.n { (backlash(of.least)) }
        td.n { (um(of.mean, 2)) }
        td.n { (backlash(of.greatest)) }
        td.n { (of.interfering) }
        td.n { (of.jammed) }
        td.n { (of.apart) }
    }
}

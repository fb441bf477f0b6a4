//! Backlash over the teeth and over the centre distance, and the mesh viewer.

use super::figures::{charted, folded, over_distance, revolutions};
use super::page::Page;
use super::table::{Table, cells, columns};
use crate::chart::PictureError;
use crate::map::backlash_map_in_page;
use crate::viewer;
use gearlash::analysis::outcome::PoseOfRun;
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
            (over_distance(page)?)
            @if !page.report.analysis.maps.is_empty() { (maps(page)) }
            h3 { "Each centre distance and material" }
            (materials(page))
            (phases(page))
        }
    })
}

/// Backlash of a drawn pair over mesh cycle and centre distance.
fn maps(page: &Page) -> Markup {
    let title = &page.report.pair.study.title;
    html! {
        p {
            "How much backlash is left at each centre distance, all round the mesh cycle. Where interference reaches farther up than "
            "elsewhere, that tooth interferes first."
        }
        @for (number, map) in page.report.analysis.maps.iter().enumerate() {
            figure.chart.tall tabindex="0" { (PreEscaped(backlash_map_in_page(&format!("map{number}"), title, map))) }
        }
    }
}

/// One row per centre distance and material.
fn materials(page: &Page) -> Markup {
    let mut columns = columns(
        "a mm:n | material:w | poses:n | least:n | mean:n | greatest:n | interfering:n | jammed:n | out of mesh:n | unproven:n",
    );
    columns[9].is_shown = page.whole.unproven > 0;
    let backlash = |found: Option<PoseOfRun>| um(found.and_then(|f| f.pose.simulated.backlash), 2);
    let mut rows = Vec::new();
    for at in &page.distances {
        rows.extend(at.materials.iter().map(|(end, of)| {
            cells![
                stated_distance(at.center_distance),
                end.words(),
                of.poses,
                backlash(of.least),
                um(of.mean, 2),
                backlash(of.greatest),
                of.interfering,
                of.jammed,
                of.apart,
                of.unproven,
            ]
        }));
    }
    let caption = html! { "Backlash, µm, and how many poses there are" };
    let label = "Each centre distance and material";
    folded(label, &Table::new(label, caption, columns, rows))
}

/// The teeth to mark for each phase, where phases are run separately.
fn phases(page: &Page) -> Markup {
    let runs = tally(&page.report.analysis.revolution);
    let groups = phase_groups(&runs);
    if groups.is_empty() {
        return html! {};
    }
    let columns = columns(
        "a mm:n | material:w | phases:n | assemble:n | best | least:n | varies by:n | worst | least:n | varies by:n",
    );
    let rows = groups.iter().filter_map(|group| {
        let first = group.runs.first()?;
        let assemble = group.runs.iter().filter(|run| run.assembles()).count();
        let mut row = cells![
            stated_distance(first.assembly.center_distance()),
            first.material.words(),
            group.runs.len(),
            assemble,
        ];
        for run in [group.best, group.worst] {
            let phase = run.and_then(|run| run.phase);
            let phase = phase.map_or("–".to_owned(), |(wheel, pinion)| {
                format!("{wheel}·{pinion}")
            });
            row.extend(cells![
                phase,
                um(run.and_then(|run| run.summary().min), 2),
                um(run.and_then(RunTally::variation), 2),
            ]);
        }
        Some(row)
    });
    let caption = html! {
        "Assembly phases: teeth to mark together (wheel·pinion), the least backlash then, and how much it varies, µm"
    };
    let label = "Assembly phases";
    folded(label, &Table::new(label, caption, columns, rows))
}

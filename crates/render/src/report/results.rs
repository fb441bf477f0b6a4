//! Backlash over the teeth and over the centre distance, the mesh viewer, and the poses with the least and the greatest backlash, drawn.

use super::figures::{charted, folded, more, over_distance, revolutions};
use super::page::Page;
use super::phrases::pose;
use super::table::{Table, cells, columns};
use crate::chart::PictureError;
use crate::map::backlash_map_in_page;
use crate::snapshot::pose_picture_in_page;
use crate::viewer;
use gearlash::analysis::outcome::PoseOfRun;
use gearlash::analysis::phases::phase_groups;
use gearlash::analysis::tally::{RunTally, tally};
use gearlash::contact::Status;
use gearlash_text::numbers::{stated_distance, trimmed, um};
use maud::{Markup, PreEscaped, html};

pub(super) fn section(page: &Page) -> Result<Markup, PictureError> {
    page.tick()?;
    let mesh = viewer::fragment(page.report.analysis, &charted(page))
        .map_err(|error| PictureError(format!("the poses cannot be written: {error}")))?;
    page.tick()?;
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
                of.out_of_mesh,
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

/// Most other centre distances whose least pose is drawn (tuned: some 30 kB each).
const MOST_DRAWN: usize = 8;

pub(super) fn poses(page: &Page) -> Markup {
    let whole = &page.whole;
    let others = other_distances(page);
    html! {
        section id="poses" {
            h2 { "Worst poses" }
            @if whole.worst.is_none() {
                p { "No pose is " @if whole.unproven > 0 { "proven to be " } "in mesh: there is nothing to draw." }
            }
            @if let Some(jammed) = whole.worst.filter(|found| found.pose.simulated.status() == Status::Jammed) {
                (figure(page, "jammed", "Jammed, a tip in a root", jammed))
            }
            @if let Some(least) = whole.least { (figure(page, "least", "Least backlash", least)) }
            @if let Some(greatest) = whole.greatest {
                (figure(page, "greatest", "Greatest backlash", greatest))
            }
            @if let Some((most, loss)) = greatest_loss(page) {
                (figure(page, "lost", &format!("Largest loss to contact off the line of action, {} µm", um(loss, 2)), most))
            }
            @if whole.worst.is_some() { p.note { "Scale bars are correct; the ratios beside them hold on the A4 sheet of " code { "gearlash snapshot" } "." } }
            @if !others.is_empty() {
                (more("least backlash at the other centre distances", html! {
                    @for (number, least) in others.into_iter().enumerate() {
                        (figure(page, &format!("least{}", number + 1), "Least backlash", least))
                    }
                }))
            }
        }
    }
}

/// The pose off the line of action with the greatest loss, where that exceeds the tolerance and is not drawn yet.
fn greatest_loss<'a>(page: &Page<'a>) -> Option<(PoseOfRun<'a>, f64)> {
    let contact = &page.report.analysis.diagnosis.contact;
    let worst = contact.worst_off_line.as_ref()?;
    let is_worst = |found: &PoseOfRun| {
        let run = &found.run.run;
        run.material == worst.material
            && run.assembly.center_distance() == worst.assembly.center_distance()
            && found.pose.simulated.pose == worst.pose
    };
    let runs = page.report.analysis.runs.iter();
    let mut all = runs.flat_map(|run| run.poses.iter().map(move |pose| PoseOfRun { run, pose }));
    let found = all.find(is_worst)?;
    let drawn = [page.whole.least, page.whole.greatest];
    let known = drawn.iter().flatten().any(is_worst);
    (worst.loss > page.report.pair.study.tolerance_um * 1e-3 && !known)
        .then_some((found, worst.loss))
}

/// The least poses of the other centre distances, where there are few.
fn other_distances<'a>(page: &Page<'a>) -> Vec<PoseOfRun<'a>> {
    let distance = |found: PoseOfRun| found.run.run.assembly.center_distance();
    let drawn = page.whole.least.map(distance);
    let least = page.distances.iter().filter_map(|at| at.all.least);
    let others: Vec<PoseOfRun> = least
        .filter(|found| Some(distance(*found)) != drawn)
        .collect();
    match others.len() {
        0..=MOST_DRAWN => others,
        _ => Vec::new(),
    }
}

fn figure(page: &Page, id: &str, what: &str, found: PoseOfRun) -> Markup {
    let run = &found.run.run;
    let result = &found.pose.simulated;
    let backlash = result.backlash.map(|mm| format!(": {} µm", um(mm, 2)));
    let words = |section: Option<f64>| {
        let at = section.map_or(String::new(), |at| {
            format!(", section at z = {} mm", trimmed(at, 0, 3))
        });
        format!(
            "{what}{}, {}, centre distance {} mm, {}{at}.",
            backlash.as_deref().unwrap_or_default(),
            pose(found),
            stated_distance(run.assembly.center_distance()),
            run.material.words()
        )
    };
    let title = &page.report.pair.study.title;
    let drawn = pose_picture_in_page(title, &run.assembly, run.material, result, (id, words));
    html! {
        @match drawn {
            Ok([picture, words]) => figure.sheet tabindex="0" {
                (PreEscaped(picture))
                figcaption { (words) }
            },
            Err(reason) => p { (what) ": not drawn: " (reason.to_string()) "." },
        }
    }
}

//! The page of a pair of which one gear at least is an outline.

mod drawings;
mod poses;
mod scope;

use super::figures::{figure, not_on_paper};
use super::marks::{mark, marked};
use super::phrases::j_wt;
use super::shell::Shell;
use super::verdict::answer;
use crate::chart::{self, Heading, PictureError};
use crate::map::outline_map_in_page;
use gearlash::analysis::diagnosis::Verdict;
use gearlash::analysis::outlines::{OutlineMap, OutlinePose, OutlineRun, TurnsFrom, worst};
use gearlash::contact::Status;
use gearlash::pair::BacklashUnit;
use gearlash_files::OutlinePairFile;
use gearlash_files::numbers::{NONE, fixed, stated_distance, um, um_within};
use gearlash_results::outlines::{lines, region_words};
use maud::{Markup, PreEscaped, html};

/// Centre distances whose curves stand in the page (tuned: as of gears by their data).
const MOST_CURVES: usize = 12;
/// Wheel teeth that bind are listed up to so many (tuned: a screen).
const MOST_TEETH: usize = 24;

/// What a report of a pair with an outline is of.
#[derive(Debug, Clone, Copy)]
pub struct OutlineReport<'a> {
    /// The pair as read.
    pub pair: &'a OutlinePairFile,
    /// Name of its file.
    pub file: &'a str,
    /// Day of the report, as it shall stand there.
    pub date: &'a str,
    /// Every centre distance and material, in order.
    pub runs: &'a [OutlineRun],
    /// Of each run its zero-backlash distance, where one was found.
    pub zeros: &'a [Option<TurnsFrom>],
    /// Of the first runs the maps.
    pub maps: &'a [OutlineMap],
}

/// The page of `report`, in UTF-8.
///
/// # Errors
/// A chart that cannot be drawn: none for results of a study.
pub fn outline_report(report: &OutlineReport) -> Result<String, PictureError> {
    let sections = [
        ("result", "Result"),
        ("backlash", "Backlash"),
        ("poses", "Worst poses"),
        ("input", "Drawings"),
        ("left-out", "Left out"),
        ("method", "Method"),
    ];
    let main = html! {
        (result(report))
        (backlash(report)?)
        (poses::section(report))
        (drawings::section(report))
        (scope::section(report))
    };
    let shell = Shell {
        title: &report.pair.study.title,
        file: report.file,
        date: report.date,
        sections: &sections,
        same: "The same pair file, drawings and version give the same numbers.",
    };
    Ok(shell.page(&main))
}

fn result(report: &OutlineReport) -> Markup {
    let runs = report.runs;
    let lines = lines(&report.pair.study, runs);
    html! {
        section id="result" {
            div.verdict.(lines.state.name()) {
                p.state { (mark(lines.state)) }
                (answer(&lines))
            }
            (distances(report))
            @if let Some((run, _)) = worst(runs) { (binding(report, run)) }
        }
    }
}

/// A row a centre distance and material.
fn distances(report: &OutlineReport) -> Markup {
    let materials = report.pair.study.materials.len() > 1;
    html! {
        div.scroll tabindex="0" role="region" aria-label="Backlash at each centre distance" {
            table.big {
                caption {
                    "Circumferential backlash " (j_wt()) " on the operating pitch circle, µm. "
                    "Teeth: wheel·pinion, right flanks / left flanks in contact."
                }
                thead { tr {
                    th.n scope="col" { i { "a" } " mm" }
                    @if materials { th scope="col" { "material" } }
                    th scope="col" { "turns" }
                    th.n scope="col" { "least" }
                    th scope="col" { "teeth at least" }
                    th.n scope="col" { "greatest" }
                    th scope="col" { "teeth at greatest" }
                    th.n scope="col" { "turns freely from " i { "a" } " mm" }
                } }
                tbody { @for (run, zero) in report.runs.iter().zip(report.zeros) {
                    tr {
                        th.n scope="row" { (stated_distance(run.pair.center_distance())) }
                        @if materials { td.w { (run.material.words()) } }
                        (whether(run))
                        (extreme(run.least.as_ref()))
                        (extreme(run.greatest.as_ref()))
                        td.n { (zero.as_ref().map_or(NONE.to_owned(), |zero| fixed(zero.rounded(), 4))) }
                    }
                } }
            }
        }
    }
}

fn whether(run: &OutlineRun) -> Markup {
    let (verdict, word) = match run.turns() {
        Some(true) => (Verdict::Pass, "yes"),
        Some(false) if run.count(Status::Jammed) > 0 => (Verdict::Fail, "no: jammed"),
        Some(false) => (Verdict::Fail, "no: binds"),
        None if run.count(Status::NoContact) > 0 => (Verdict::Fail, "out of mesh"),
        None => (Verdict::Unproven, "unproven"),
    };
    html! { td { (marked(verdict, word)) } }
}

fn extreme(pose: Option<&OutlinePose>) -> Markup {
    let teeth = pose.map_or([NONE.to_owned(), NONE.to_owned()], teeth);
    html! {
        td.n { strong { (value(pose)) } }
        td.w { (teeth[0]) " / " (teeth[1]) }
    }
}

/// `j_wt` in µm, with what the drawing leaves open.
fn value(pose: Option<&OutlinePose>) -> String {
    match pose.and_then(|pose| pose.j_wt) {
        Some((j_wt, error)) if error >= 5e-6 => um_within(j_wt, error),
        j_wt => um(j_wt.map(|(j_wt, _)| j_wt), 2),
    }
}

/// The teeth that touch: right flanks, left flanks; wheel and pinion tooth each.
fn teeth(pose: &OutlinePose) -> [String; 2] {
    pose.contacts().map(|contact| {
        contact.map_or(NONE.to_owned(), |contact| {
            format!("{}·{}", contact.wheel.tooth, contact.pinion.tooth)
        })
    })
}

/// The wheel teeth at which a run binds, each at its worst; nothing where it turns.
fn binding(report: &OutlineReport, run: &OutlineRun) -> Markup {
    let worst = run.binding_teeth();
    // Jammed throughout there is nothing to choose between.
    if worst.iter().all(|(_, pose)| pose.j_wt.is_none()) {
        return html! {};
    }
    let touching = |pose: &OutlinePose| {
        pose.contacts().map(|contact| {
            contact.map_or("jammed".to_owned(), |contact| {
                let (wheel, pinion) = (contact.wheel.tooth, contact.pinion.tooth);
                format!("{wheel}·{pinion}, {}", region_words(&contact))
            })
        })
    };
    html! {
        div.scroll tabindex="0" role="region" aria-label="Where it binds" {
            table {
                caption {
                    "Where it binds at " (place(report, run)) ", each wheel tooth at its worst"
                    @if worst.len() > MOST_TEETH { " (" (MOST_TEETH) " of " (worst.len()) ")" }
                }
                thead { tr {
                    th scope="col" { "wheel tooth" }
                    th.n scope="col" { (j_wt()) " µm" }
                    th scope="col" { "right flanks" }
                    th scope="col" { "left flanks" }
                } }
                tbody { @for (tooth, pose) in worst.iter().take(MOST_TEETH) {
                    @let [right, left] = touching(pose);
                    tr {
                        th scope="row" { (tooth) }
                        td.n { (value(Some(pose))) }
                        td.w { (right) }
                        td.w { (left) }
                    }
                } }
            }
        }
    }
}

/// Centre distance of a run, and its material where there are two.
fn place(report: &OutlineReport, run: &OutlineRun) -> String {
    let a = stated_distance(run.pair.center_distance());
    match report.pair.study.materials.len() {
        0 | 1 => format!("a = {a} mm"),
        _ => format!("a = {a} mm, {}", run.material.words()),
    }
}

/// Backlash over the mesh cycle, and over the centre distance, too.
fn backlash(report: &OutlineReport) -> Result<Markup, PictureError> {
    let mut curves: Vec<&[OutlineRun]> = report
        .runs
        .chunk_by(|a, b| a.pair.center_distance() == b.pair.center_distance())
        .collect();
    // The centre distance with the least backlash first.
    if let Some((run, _)) = worst(report.runs) {
        let a = run.pair.center_distance();
        curves.sort_by_key(|runs| runs[0].pair.center_distance() != a);
    }
    let draw = |(number, runs): (usize, &&[OutlineRun])| {
        let a = stated_distance(runs[0].pair.center_distance());
        let heading = Heading {
            prefix: &format!("cycle{number}"),
            title: &format!("Backlash over the mesh cycle at a = {a} mm"),
            subtitle: &report.pair.study.title,
        };
        let drawn = chart::outlines(BacklashUnit::Um, &heading, runs)?;
        Ok(figure(&drawn))
    };
    let drawn = curves.iter().take(MOST_CURVES).enumerate().map(draw);
    let drawn = drawn.collect::<Result<Vec<Markup>, PictureError>>()?;
    let others = "backlash over the mesh cycle at the other centre distances";
    Ok(html! {
        section id="backlash" {
            h2 { "Backlash over the mesh cycle" }
            @for first in drawn.iter().take(1) { (first) }
            @if drawn.len() > 1 {
                details {
                    summary { "More: " (others) }
                    @for other in &drawn[1..] { (other) }
                    @if curves.len() > MOST_CURVES {
                        p.note { (curves.len() - MOST_CURVES) " more by " code { "gearlash chart --center-distance" } "." }
                    }
                }
                (not_on_paper(others))
            }
            (maps(report))
        }
    })
}

/// The maps on which some pose has a backlash.
fn maps(report: &OutlineReport) -> Markup {
    let shown =
        |(_, map): &(&OutlineRun, &OutlineMap)| map.cells.iter().any(|cell| cell.j_wt.is_some());
    let maps: Vec<_> = report.runs.iter().zip(report.maps).filter(shown).collect();
    html! {
        @if !maps.is_empty() {
            h3 { "Over the centre distance" }
            p {
                "How much backlash is left at each centre distance, all round the mesh cycle. Where interference reaches farther up than "
                "elsewhere, that tooth binds first."
            }
            @for (run, map) in maps {
                figure.chart.tall tabindex="0" {
                    (PreEscaped(outline_map_in_page(&report.pair.study.title, run, map)))
                }
            }
        }
    }
}

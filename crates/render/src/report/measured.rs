//! Measured backlash beside the predicted bands.

use super::figures::folded;
use super::page::{Page, Report};
use super::phrases::plain;
use super::table::{Table, cells, columns};
use gearlash::analysis::measured::{Band, MeasuredMating, sides};
use gearlash_files::numbers::{fixed, stated_distance};
use maud::{Markup, html};

/// How many measured values lie in their bands; `None` without measurements.
pub(super) fn sentence(report: &Report) -> Option<String> {
    if report.analysis.measured.is_empty() {
        return None;
    }
    let [below, inside, above] = sides(&report.analysis.measured, |mating| mating.simulated);
    let of = below + inside + above;
    let mut text = format!(
        "{inside} of {of} measured values lie inside the simulated band, {below} below it, {above} above it"
    );
    if report.pair.study.bearing_clearance > 0.0 {
        let [_, inside, _] = sides(&report.analysis.measured, |mating| mating.with_clearance);
        text += &format!("; {inside} of {of} with the bearing clearance taken in");
    }
    Some(text + ".")
}

pub(super) fn section(page: &Page) -> Markup {
    let report = page.report;
    let Some(sentence) = sentence(report) else {
        return html! {};
    };
    let clearance = report.pair.study.bearing_clearance > 0.0;
    let mut columns = columns(
        "mating | a mm:n | measured right:n | left:n | simulated:n | with bearing clearance:n | involute formula:n | predicted in the file:n",
    );
    columns[5].is_shown = clearance;
    let rows = report.analysis.measured.iter().map(row);
    let caption = html! {
        "Backlash, µm. Bands from most to least material, means of the mating’s right-flank and left-flank pose. "
        "↓ ↑: below or above the simulated band. Predicted in the file: what the file of measurements gives beside them."
    };
    let table = Table::new("Measured and predicted backlash", caption, columns, rows);
    html! {
        section id="measured" {
            h2 { "Measured and predicted" }
            p { (sentence) }
            (folded("Measured matings", &table))
            (sources(&report.analysis.measured))
        }
    }
}

fn row(mating: &MeasuredMating) -> Vec<Markup> {
    let row = &mating.row;
    let marked = |um: f64| {
        let mark = match mating.simulated.map_or(0, |band| band.side_of(um)) {
            0 => "\u{2007}",
            1 => "↑",
            _ => "↓",
        };
        format!("{} {mark}", gearlash_files::numbers::shortest(um))
    };
    cells![
        format!("{}·{}", row.wheel_tooth, row.pinion_tooth),
        stated_distance(row.center_distance),
        marked(row.right_um),
        marked(row.left_um),
        band(mating.simulated),
        band(mating.with_clearance),
        band(mating.analytic),
        band(Some(mating.printed)),
    ]
}

fn band(band: Option<Band>) -> String {
    band.map_or("–".to_owned(), |band| {
        format!(
            "{} … {}",
            fixed(Some(band.min_um), 1),
            fixed(Some(band.max_um), 1)
        )
    })
}

/// Where the rows come from, each source once.
fn sources(measured: &[MeasuredMating]) -> Markup {
    let mut sources: Vec<&str> = Vec::new();
    for mating in measured {
        let source = mating.row.source.as_str();
        if !source.is_empty() && !sources.contains(&source) {
            sources.push(source);
        }
    }
    html! {
        @if !sources.is_empty() { p.note { "Source as that file names it: " (plain(&sources.join("; "))) "." } }
    }
}

//! Measured backlash beside the predicted bands.

use super::figures::folded;
use super::page::{Page, Report};
use super::phrases::plain;
use super::table::Table;
use gearlash::analysis::measured::{MeasuredMating, sides};
use gearlash_results::text::measured_shown;
use maud::{Markup, html};

/// The number of measured values within their bands; `None` without measurements.
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
    let caption = html! {
        "Backlash, µm. Bands from most to least material, means of the mating’s right-flank and left-flank pose. "
        "↓ ↑: below or above the simulated band. Predicted: as printed in the file of measurements. Analytic: model 2 (involute)."
    };
    let shown = measured_shown(&report.pair.study, &report.analysis.measured);
    let table = Table::of_shown("Measured and predicted backlash", caption, &shown);
    html! {
        section id="measured" {
            h2 { "Measured and predicted" }
            p { (sentence) }
            (folded("Measured matings", &table))
            (sources(&report.analysis.measured))
        }
    }
}

/// The sources of the rows, each once.
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

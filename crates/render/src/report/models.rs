//! The simulation beside checks, measured values and formulas.

use super::figures::{difference, folded};
use super::page::{Page, Report};
use super::phrases::{plain, study, symbol};
use super::table::{Table, cells, columns};
use crate::chart::PictureError;
use gearlash::analysis::diagnosis::CheckVerdict;
use gearlash::analysis::measured::{MeasuredMating, sides};
use gearlash::analysis::outcome::{MODELS, deviation};
use gearlash_results::text::check::{MARGIN, check_doubts, table};
use gearlash_results::text::measured_shown;
use gearlash_text::numbers::difference_um;
use indexmap::IndexSet;
use maud::{Markup, html};

pub(super) fn checks(page: &Page) -> Markup {
    let diagnosis = &page.report.analysis.diagnosis;
    let several = diagnosis.groups.len() > 1;
    let listed_runs = page.report.analysis.runs.iter();
    let poses: usize = listed_runs.map(|run| run.poses.len()).sum();
    let outcome = match diagnosis.verdict() {
        CheckVerdict::Pass => "Every check passes.",
        CheckVerdict::Warn => "No check fails; some values are outside the recommended range.",
        CheckVerdict::Unproven => {
            "No check fails, but some are unproven: whether their limits are met is not known."
        }
        CheckVerdict::Fail => "A check fails.",
    };
    html! {
        section id="checks" {
            h2 { "Checks" }
            p {
                (outcome)
                " “Formula” is of the gears’ mean teeth, “outlines” as found at the " (poses) " poses that the pair file asks for."
                @if !page.report.analysis.extremes.runs.is_empty() {
                    " The zero-backlash centre distance is that of the whole hunting cycle; the other checks are of these poses."
                }
                @if several { " Each check is shown at its worst centre distance and material." }
            }
            (Table::of_shown("Checks", html! {}, &table(diagnosis)))
            p { (MARGIN) }
            @for reason in check_doubts(diagnosis) { p { strong { "Unproven: " } (plain(reason)) "." } }
            (study())
            p.note {
                "A contact is named by the curves that meet: tip-fillet is a tip on its mate’s fillet, undercut-edge the edge that undercut "
                "leaves at the foot of the involute. “0.25 pitch beyond”: turned on by a quarter of a tooth from where that flank passes "
                "through the operating pitch point."
            }
        }
    }
}

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
    if report.pair.study.clearance_of_poses() > 0.0 {
        let [_, inside, _] = sides(&report.analysis.measured, |mating| mating.with_clearance);
        text += &format!("; {inside} of {of} with the bearing clearance taken in");
    }
    Some(text + ".")
}

pub(super) fn measured(page: &Page) -> Markup {
    let report = page.report;
    let Some(sentence) = sentence(report) else {
        return html! {};
    };
    let measured = &report.analysis.measured;
    let caption = html! {
        "Backlash, µm. Bands from most to least material, means of the mating’s right-flank and left-flank pose. "
        "↓ ↑: below or above the simulated band. "
        @if measured.iter().any(|mating| mating.printed.is_some()) { "Predicted: as printed in the file of measurements. " }
        "Analytic: model 2 (involute)."
    };
    let shown = measured_shown(&report.pair.study, measured);
    let table = Table::of_shown("Measured and predicted backlash", caption, &shown);
    html! {
        section id="measured" {
            h2 { "Measured and predicted" }
            p { (sentence) }
            (folded("Measured matings", &table))
            (sources(measured))
        }
    }
}

fn sources(measured: &[MeasuredMating]) -> Markup {
    let sources = measured.iter().map(|mating| &*mating.row.source);
    let sources: IndexSet<&str> = sources.filter(|source| !source.is_empty()).collect();
    let sources: Vec<&str> = sources.into_iter().collect();
    html! {
        @if !sources.is_empty() { p.note { "Source as that file names it: " (plain(&sources.join("; "))) "." } }
    }
}

/// The inputs of each formula, in the order of [`MODELS`].
#[rustfmt::skip]
const NAMES: [(&str, &str); 3] = [
    ("1 Michalec, K (1)–(7)", "mean thickness, eccentricity; linear in the centre distance"),
    ("2 involute, K (11)–(17)", "mean thickness, eccentricity at the pose"),
    ("3 line of action", "every flank’s thickness and pitch, eccentricity; exact while involutes touch"),
];

pub(super) fn section(page: &Page) -> Result<Markup, PictureError> {
    let of = &page.agreement;
    let off_line = "lie below model 3, the teeth touching off the line of action";
    let alone = "have no value of model 3, no two involutes reaching each other";
    let counts = [
        (of.agree, "agree with model 3"),
        (of.off_line, off_line),
        (of.below, "lie below model 3 where involutes touch"),
        (of.above, "lie above model 3"),
        (of.simulated_alone, alone),
        (of.jammed, "are jammed where model 3 has a value"),
        (of.apart, "are out of mesh where model 3 has a value"),
        (of.neither, "are jammed or out of mesh: neither has a value"),
        (of.unproven, "are unproven: not compared"),
    ];
    let counts = counts.iter().filter(|(poses, _)| *poses > 0);
    let counts = counts.map(|(poses, words)| format!("{poses} {words}"));
    let counts: Vec<String> = counts.collect();
    let columns = columns("model:w | what it includes | poses:n | mean:n | largest:n");
    let rows = NAMES.into_iter().zip(MODELS).map(|((name, knows), model)| {
        let found = deviation(&page.all, model);
        let ends = [found.map(|of| of.mean), found.map(|of| of.largest)];
        let [mean, largest] = ends.map(difference_um);
        cells![name, knows, found.map_or(0, |of| of.poses), mean, largest]
    });
    Ok(html! {
        section id="models" {
            h2 { "Formulas beside the simulation" }
            p {
                "Of " (of.poses) " poses " (counts.join("; "))
                " (tolerance " (gearlash_text::numbers::shortest(page.report.pair.study.tolerance_um)) " µm and the error bound)."
            }
            @if page.report.pair.study.is_helical() {
                p {
                    "All three count in the transverse section: reference circles of " (symbol("m", "t")) " = " (symbol("m", "n")) "/cos " i { "β" } ", operating pressure angle "
                    (symbol("α", "wt")) " from cos " (symbol("α", "wt")) " = (" (symbol("r", "b1")) " + " (symbol("r", "b2")) ")/" i { "a" } ", base circles of "
                    (symbol("α", "t")) "; thickness allowances of the normal section are divided by cos " i { "β" } ". Models 1 and 2 know no face; model 3 takes every pair "
                    "of teeth that can touch within the common one."
                }
            }
            @if page.all.iter().any(|run| run.run.assembly.is_modified()) {
                p {
                    "Models 1 and 2 know no profile deviation. Model 3 takes it at its own contact point; where a flank is tilted there the real "
                    "contact lies beside it, which the model cannot follow: it lies above by the square of the tilt."
                }
            }
            (Table::new("Formulas beside the simulation", html! { "Simulated minus formula, µm" }, columns, rows))
            (difference(page)?)
        }
    })
}

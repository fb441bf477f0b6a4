//! Accuracy grades of pitch and runout, as the gauge reads them.

use super::page::Page;
use super::phrases::symbol;
use gearlash::gauge::{GradedReading, Unmeasured};
use gearlash::gear::{Flank, GRADE_SOURCE, Grade, GradedQuantity, PitchAxis};
use gearlash_files::numbers::um;
use maud::{Markup, html};

pub(super) fn table(page: &Page) -> Markup {
    let graded = page.report.grades;
    let count = |of: &Result<Vec<GradedReading>, Unmeasured>| of.as_ref().map_or(0, Vec::len);
    html! {
        @if graded.iter().any(|(_, of)| count(of) > 0) {
            div.scroll tabindex="0" role="region" aria-label="Accuracy grades" {
                table {
                    caption { "Accuracy grades " (GRADE_SOURCE) }
                    thead { tr {
                        th scope="col" { "gear" } th scope="col" { "symbol" } th scope="col" { "deviation" }
                        th.n scope="col" { "measured µm" } th.n scope="col" { "grade" }
                        th.n scope="col" { "its tolerance µm" }
                    } }
                    tbody { @for (name, of) in graded {
                        @for reading in of.iter().flatten() { (row(name, reading)) }
                    } }
                }
            }
            p.note {
                "Read on the modelled gears as “gearlash gauge” reads them: pitch about the datum axis, which is what a standard grades, "
                "and about the gear’s own centre; runout with a ball in every space, so that the pitch and the thickness of the teeth are in it, "
                "not the eccentricity alone."
            }
        }
        @for (name, of) in graded {
            @if let Err(reason) = of { p.note { "No accuracy grade for the " (name) ": " (reason.to_string()) "." } }
        }
    }
}

fn row(gear: &str, reading: &GradedReading) -> Markup {
    let (sign, name) = match reading.quantity {
        GradedQuantity::SinglePitch => (symbol("f", "p"), "single pitch"),
        GradedQuantity::TotalPitch => (symbol("F", "p"), "total cumulative pitch"),
        GradedQuantity::Runout => (symbol("F", "r"), "runout, by a ball"),
    };
    let flanks = match reading.pitch {
        Some((_, Flank::Right)) => ", right flanks",
        Some((_, Flank::Left)) => ", left flanks",
        None => "",
    };
    let axis = match reading.pitch {
        Some((PitchAxis::Datum, _)) => ", datum axis",
        Some((PitchAxis::Own, _)) => ", own centre",
        None => "",
    };
    html! {
        tr {
            td { (gear) }
            td.w { (sign) }
            th scope="row" { (name) (flanks) (axis) }
            td.n { (um(Some(reading.measured), 3)) }
            @match reading.grade {
                Grade::Within { grade, tolerance } => { td.n { (grade) } td.n { (um(Some(tolerance), 1)) } }
                Grade::Beyond { last, tolerance } => { td.n { "beyond " (last) } td.n { (um(Some(tolerance), 1)) } }
            }
        }
    }
}

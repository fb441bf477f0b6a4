//! Accuracy grades of pitch and runout, as the gauge reads them, beside those required.

use super::marks::marked;
use super::page::{GearGrades, Page};
use super::phrases::symbol;
use gearlash::analysis::diagnosis::Verdict;
use gearlash::gauge::{GradedReading, PitchReadings};
use gearlash::gear::{Flank, GRADE_SOURCE, Grade, GradedQuantity, PitchAxis};
use gearlash_files::numbers::um;
use maud::{Markup, html};

pub(super) fn table(page: &Page) -> Markup {
    let gears = page.report.grades;
    let any = gears
        .iter()
        .any(|gear| gear.graded.iter().flatten().next().is_some());
    let required = gears.iter().any(|gear| gear.required.is_some());
    html! {
        @if any {
            div.scroll tabindex="0" role="region" aria-label="Accuracy grades" {
                table {
                    caption { "Accuracy grades " (GRADE_SOURCE) }
                    thead { tr {
                        th scope="col" { "gear" } th scope="col" { "symbol" } th scope="col" { "deviation" }
                        th.n scope="col" { "measured µm" } th.n scope="col" { "grade" }
                        th.n scope="col" { "its tolerance µm" }
                        @if required { th scope="col" { "required grade" } }
                    } }
                    tbody { @for gear in gears {
                        @for reading in gear.graded.iter().flatten() { (graded(gear, reading, required)) }
                        @for pitch in gear.pitches.iter().filter(|pitch| pitch.axis == PitchAxis::Datum) {
                            @for flank in Flank::BOTH { (ungraded(gear.name, pitch, flank, required)) }
                        }
                    } }
                }
            }
            p.note {
                "Read on the modelled gears as “gearlash gauge” reads them: pitch about the datum axis, which is what a standard grades, "
                "and about the gear’s own centre; runout with a ball in every space, so that the pitch and the thickness of the teeth are in it, "
                "not the eccentricity alone. The formulas grade " (symbol("f", "p")) ", " (symbol("F", "p")) " and " (symbol("F", "r")) " alone"
                @if page.report.pair.study.is_helical() {
                    ", by the reference diameter " i { "d" } " and the normal module " (symbol("m", "n")) "; pitch in the transverse section of the measuring plane. "
                    "Helix deviations are not measured and have no grade"
                }
                "."
            }
        }
        @for gear in gears {
            @if let Err(reason) = &gear.graded { p.note { "No accuracy grade for the " (gear.name) ": " (reason.to_string()) "." } }
        }
    }
}

/// Of which flanks and about which axis.
fn of(pitch: Option<(PitchAxis, Flank)>) -> &'static str {
    match pitch {
        Some((PitchAxis::Datum, Flank::Right)) => ", right flanks, datum axis",
        Some((PitchAxis::Datum, Flank::Left)) => ", left flanks, datum axis",
        Some((PitchAxis::Own, Flank::Right)) => ", right flanks, own centre",
        Some((PitchAxis::Own, Flank::Left)) => ", left flanks, own centre",
        None => "",
    }
}

fn graded(gear: &GearGrades, reading: &GradedReading, required: bool) -> Markup {
    let (sign, name) = match reading.quantity {
        GradedQuantity::SinglePitch => (symbol("f", "p"), "single pitch"),
        GradedQuantity::TotalPitch => (symbol("F", "p"), "total cumulative pitch"),
        GradedQuantity::Runout => (symbol("F", "r"), "runout, by a ball"),
    };
    let (grade, tolerance, finest) = match reading.grade {
        Grade::Within { grade, tolerance } => (grade.to_string(), tolerance, Some(grade)),
        Grade::Beyond { last, tolerance } => (format!("beyond {last}"), tolerance, None),
    };
    // About the gear's own centre no standard grades.
    let own = matches!(reading.pitch, Some((PitchAxis::Own, _)));
    let wanted = gear.required.filter(|_| !own);
    html! {
        tr {
            td { (gear.name) }
            td.w { (sign) }
            th scope="row" { (name) (of(reading.pitch)) }
            td.n { (um(Some(reading.measured), 3)) }
            td.n { (grade) }
            td.n { (um(Some(tolerance), 1)) }
            @if required {
                td { @match wanted {
                    None => "–",
                    Some(wanted) if finest.is_some_and(|grade| grade <= wanted) => {
                        (marked(Verdict::Pass, &format!("{wanted}, met")))
                    }
                    Some(wanted) => { (marked(Verdict::Fail, &format!("{wanted}, not met"))) }
                } }
            }
        }
    }
}

/// What inspection sheets list beside what is graded.
fn ungraded(gear: &str, pitch: &PitchReadings, flank: Flank, required: bool) -> Markup {
    let rows = [
        (
            symbol("f", "u"),
            "difference of adjacent pitches",
            pitch.adjacent_difference(flank),
        ),
        (
            symbol("F", "p(z/8)"),
            "cumulative pitch over an eighth of the teeth",
            pitch.eighth(flank),
        ),
        (
            symbol("R", "p"),
            "range of the single pitch",
            pitch.single_range(flank),
        ),
    ];
    html! {
        @for (sign, name, mm) in rows {
            tr {
                td { (gear) }
                td.w { (sign) }
                th scope="row" { (name) (of(Some((pitch.axis, flank)))) }
                td.n { (um(Some(mm), 3)) }
                td.n { "–" }
                td.n { "–" }
                @if required { td { "–" } }
            }
        }
    }
}

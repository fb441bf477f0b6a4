//! Accuracy grades of the pitch and the runout that are given.

use super::Page;
use super::words::{symbol, um};
use crate::error::GearError;
use crate::gear::{AsBuilt, GRADE_SOURCE, Grade, Graded, GradedValue, Side};
use maud::{Markup, html};

pub(super) fn table(page: &Page) -> Markup {
    let study = page.report.study;
    let Some((_, wheel, pinion)) = study.materials.first() else {
        return html! {};
    };
    let graded = [("wheel", wheel), ("pinion", pinion)].map(|(name, gear)| {
        let pitch = !study.echo[name]["pitch"].is_null();
        (name, given(gear, pitch))
    });
    let values = |of: &Result<Vec<GradedValue>, GearError>| of.as_ref().map_or(0, Vec::len);
    let any = graded.iter().any(|(_, of)| values(of) > 0);
    html! {
        @if any {
            div.scroll tabindex="0" role="region" aria-label="Accuracy grades" {
                table {
                    caption { "Accuracy grades " (GRADE_SOURCE) }
                    thead { tr {
                        th scope="col" { "gear" } th scope="col" { "symbol" } th scope="col" { "deviation" }
                        th.n scope="col" { "measured µm" } th.n scope="col" { "grade" }
                        th.n scope="col" { "its tolerance µm" }
                    } }
                    tbody { @for (name, of) in &graded {
                        @for value in of.iter().flatten() { (row(name, value)) }
                    } }
                }
            }
            @if graded.iter().any(|(_, of)| values(of) > 1) { p.note { "Pitch is graded about the gear’s own centre, free of eccentricity, which the runout shows; “gearlash gauge” grades it about the datum axis too." } }
        }
        @for (name, of) in &graded {
            @if let Err(error) = of { p.note { "No accuracy grade for the " (name) ": " (error.to_string()) "." } }
        }
    }
}

/// What is given of `gear`.
fn given(gear: &AsBuilt, pitch: bool) -> Result<Vec<GradedValue>, GearError> {
    let mut values = match pitch {
        true => GradedValue::of_pitch(gear)?,
        false => Vec::new(),
    };
    if gear.eccentricity() > 0.0 {
        values.push(GradedValue::of_runout(gear)?);
    }
    Ok(values)
}

fn row(gear: &str, value: &GradedValue) -> Markup {
    let (sign, name) = match value.what {
        Graded::SinglePitch => (symbol("f", "p"), "single pitch"),
        Graded::TotalPitch => (symbol("F", "p"), "total cumulative pitch"),
        Graded::Runout => (symbol("F", "r"), "runout, twice the eccentricity"),
    };
    let flanks = match value.side {
        Some(Side::Right) => ", right flanks",
        Some(Side::Left) => ", left flanks",
        None => "",
    };
    html! {
        tr {
            td { (gear) }
            td.w { (sign) }
            th scope="row" { (name) (flanks) }
            td.n { (um(Some(value.value), 1)) }
            @match value.grade {
                Grade::Within { grade, tolerance } => { td.n { (grade) } td.n { (um(Some(tolerance), 1)) } }
                Grade::Beyond { last, tolerance } => { td.n { "beyond " (last) } td.n { (um(Some(tolerance), 1)) } }
            }
        }
    }
}

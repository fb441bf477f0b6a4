//! Helical gears: what the face width costs, where over the face the teeth touch, and what each backlash is.

use super::page::Page;
use super::phrases::symbol;
use crate::chart::{self, Heading, PictureError};
use gearlash::analysis::extremes::RunExtreme;
use gearlash::analysis::face_width::AtWidth;
use gearlash::analysis::outcome::Found;
use gearlash::pair::{Backlash, GearPair};
use gearlash_files::numbers::{trimmed, um};
use gearlash_files::verdict::doubt;
use maud::{Markup, PreEscaped, html};

/// Whether a page has this section.
pub(super) fn is_of(page: &Page) -> bool {
    page.report.pair.study.is_helical()
}

pub(super) fn section(page: &Page) -> Result<Markup, PictureError> {
    if !is_of(page) {
        return Ok(html! {});
    }
    Ok(html! {
        section id="face" {
            h2 { "Face width" }
            (widths(page))
            h3 { "Field of action" }
            (field(page)?)
            h3 { "Four backlashes of one lost motion" }
            (definitions(page))
        }
    })
}

fn widths(page: &Page) -> Markup {
    let widths = &page.report.analysis.widths;
    let one_section = widths.first();
    html! {
        p {
            "Helical teeth stop the free gear where the first section of the common face does: a wider face never has more play. Between perfect "
            "involutes, and with eccentricities alone, every section stops it at the same rotation and the width costs nothing; pitch deviations, tips "
            "and fillets make it cost."
        }
        @if widths.is_empty() {
            p { "Left out: the extremes over the face were not looked for." }
        } @else {
            div.scroll tabindex="0" role="region" aria-label="What the face width costs" {
                table {
                    caption {
                        "What the face width costs: " (symbol("j", "wt")) ", µm, least and greatest over the whole mesh cycle, all centre distances and "
                        "materials. The parts of the face hold each other, about the measuring plane, or the place of the face nearest to it; width 0 is one section."
                    }
                    thead { tr {
                        th.n scope="col" { "face width mm" } th scope="col" { "from … to mm" }
                        th.n scope="col" { "least" } th.n scope="col" { "more than in one section" } th scope="col" { "proof" }
                        th.n scope="col" { "greatest" } th.n scope="col" { "more than in one section" } th scope="col" { "proof" }
                    } }
                    tbody { @for at in widths { (row(at, one_section)) } }
                }
            }
        }
    }
}

fn row(at: &AtWidth, one_section: Option<&AtWidth>) -> Markup {
    let [from, to] = at.face.map(|end| trimmed(end, 0, 3));
    let [least, greatest] = one_section.map_or([None; 2], |first| at.against(first));
    html! {
        tr {
            th.n scope="row" { (trimmed(at.width(), 0, 3)) }
            td.w { (from) " … " (to) }
            (extreme(at.least(), least, "jammed"))
            (extreme(at.greatest(), greatest, "out of mesh"))
        }
    }
}

/// Value, difference and whether it is proven.
fn extreme(found: Option<&RunExtreme>, against: Option<f64>, none: &str) -> Markup {
    html! {
        @match found {
            Some(found) => {
                td.n { strong { (um(found.found(), 2)) } }
                td.n { (um(against, 2)) }
                td { @match doubt(found) {
                    None => "proven",
                    Some(why) => { "not proven: " (why) }
                } }
            }
            None => { td.n { "–" } td.n {} td { (none) } }
        }
    }
}

fn field(page: &Page) -> Result<Markup, PictureError> {
    let Some(field) = &page.report.analysis.field else {
        return Ok(html! {
            p { "Left out: the worst pose has no proven contact on both sides, so that there are no contact lines." }
        });
    };
    let heading = Heading {
        prefix: "field",
        title: "Field of action at the least backlash",
        subtitle: &page.report.pair.study.title,
    };
    let drawn = chart::field(&heading, field)?;
    Ok(html! {
        figure.chart.tall tabindex="0" {
            (PreEscaped(&drawn.svg))
            figcaption.hint {
                "Each tooth pair touches along a line that climbs the path of contact by tan β" sub { "b" } " a mm of face. The curve below is how much "
                "farther each section alone would let the free gear turn: where it is 0 the gears touch."
            }
        }
    })
}

/// Symbol, formula, meaning, and the value of it.
type Definition = (
    &'static str,
    &'static str,
    &'static str,
    fn(&GearPair, &Backlash) -> f64,
);

const DEFINITIONS: [Definition; 4] = [
    (
        "wt",
        "φ_j r_w",
        "arc of the operating pitch circles, transverse section",
        |_, of| of.j_wt,
    ),
    (
        "t",
        "φ_j r = j_wt cos α_wt / cos α_t",
        "arc of the reference circle, transverse section",
        |_, of| of.j_t,
    ),
    (
        "bt",
        "φ_j r_b = j_wt cos α_wt",
        "along the line of action, transverse section",
        |pair, of| of.j_bt(pair),
    ),
    (
        "bn",
        "j_bt cos β_b = j_t cos α_n cos β",
        "along the normal of the flanks: what a feeler gauge finds",
        |_, of| of.j_bn,
    ),
];

fn definitions(page: &Page) -> Markup {
    let of = |found: Option<Found>| {
        let found = found?;
        let pair = found.run.run.assembly.clone();
        let backlash = pair.backlash(found.pose.swept.backlash?);
        Some((pair, backlash))
    };
    let ends = [of(page.whole.least), of(page.whole.greatest)];
    html! {
        div.scroll tabindex="0" role="region" aria-label="Backlash in four definitions" {
            table {
                caption { "The least and the greatest backlash of this page, µm; " i { "φ" } sub { "j" } " is the lost motion, " i { "r" } " a radius of the gear that turns" }
                thead { tr {
                    th scope="col" { "symbol" } th scope="col" { "formula" } th scope="col" { "what it is" }
                    th.n scope="col" { "least" } th.n scope="col" { "greatest" }
                } }
                tbody { @for (index, formula, what, value) in DEFINITIONS {
                    tr {
                        td.w { (symbol("j", index)) }
                        td.w { (formula_markup(formula)) }
                        th scope="row" { (what) }
                        @for end in &ends { td.n { (um(end.as_ref().map(|(pair, of)| value(pair, of)), 2)) } }
                    }
                } }
            }
        }
        p.note {
            "Three definitions of a normal backlash " (symbol("j", "n")) " are in use. Here it is " (symbol("j", "bn")) " of ISO 21771, in the last row. Others take "
            (formula_markup("j_wt cos α_n cos β")) ", which is " (formula_markup("cos α_t / cos α_wt")) " times as much, or "
            (formula_markup("j_bt cos β")) ", with the helix angle of the reference in place of that of the base cylinder. Compare formulas before values."
        }
    }
}

/// A formula in which `x_y` is a symbol with an index.
fn formula_markup(formula: &str) -> Markup {
    html! {
        @for (number, word) in formula.split(' ').enumerate() {
            @if number > 0 { " " }
            @match word.split_once('_') {
                Some((letter, index)) => (symbol(letter, index)),
                None if ["r", "β"].contains(&word) => i { (word) },
                None => (word),
            }
        }
    }
}

//! Pairs that vary along the face: the effect of the face width, the place of contact over the face, and definitions of backlash.

use super::figures::svg;
use super::page::Page;
use super::phrases::{band, symbol};
use super::table::{Table, cells, columns};
use crate::chart::{self, Heading};
use gearlash::analysis::face_width::{AtWidth, FaceExtreme};
use gearlash::analysis::outcome::PoseOfRun;
use gearlash::contact::Status;
use gearlash::pair::{Backlash, GearPair};
use gearlash_results::verdict::extreme_doubt;
use gearlash_text::numbers::{NONE, trimmed, um};
use maud::{Markup, html};

/// Whether a page has this section.
pub(super) fn is_of(page: &Page) -> bool {
    page.report.pair.study.varies_along_face()
}

pub(super) fn section(page: &Page) -> Markup {
    if !is_of(page) {
        return html! {};
    }
    html! {
        section id="face" {
            h2 { "Face width" }
            (widths(page))
            h3 { "Field of action" }
            (field(page))
            @if page.report.pair.study.is_helical() {
                h3 { "Four backlashes of one lost motion" }
                (definitions(page))
            }
        }
    }
}

fn widths(page: &Page) -> Markup {
    let widths = &page.report.analysis.widths;
    let narrowest = widths.first();
    let is_section = narrowest.is_some_and(|at| at.width() == 0.0);
    let than = if is_section {
        "in one section"
    } else {
        "narrowest"
    };
    let columns = columns(&format!(
        "face width mm:n | from … to mm:w | least:n w | more than {than}:n w | proof | greatest:n w | more than {than}:n w | proof"
    ));
    let rows = widths.iter().map(|at| row(at, narrowest));
    html! {
        p {
            @if page.report.pair.study.deviates_along_face() {
                "The first section of the common face to touch stops the free gear: a wider face never has more play. Leads and leaning axes make the "
                "width cost, most where right and left flanks bind at opposite ends."
            } @else {
                "Helical teeth stop the free gear where the first section of the common face does: a wider face never has more play. Between perfect "
                "involutes, and with eccentricities alone, every section stops it at the same rotation and the width costs nothing; pitch deviations, tips "
                "and fillets make it cost."
            }
        }
        @if widths.is_empty() {
            p { "Left out: the extremes over the face were not looked for." }
        } @else {
            (Table::new("What the face width costs", html! {
                "What the face width costs: " (symbol("j", "wt")) ", µm, least and greatest over the whole mesh cycle, all centre distances and "
                "materials. The parts of the face hold each other, cut about the middle of the common face as a narrower gear in the same place would be; teeth, "
                "pitch and high tooth stay stated in the measuring plane, z = 0."
                @if is_section { " Width 0 is one section." }
                " Two values are a bracket."
            }, columns, rows))
        }
    }
}

fn row(at: &AtWidth, narrowest: Option<&AtWidth>) -> Vec<Markup> {
    let [from, to] = at.face.map(|end| trimmed(end, 0, 3));
    let none = if at.each.iter().any(|run| run.status == Status::Jammed) {
        "jammed"
    } else {
        "out of mesh"
    };
    let mut row = cells![trimmed(at.width(), 0, 3), format!("{from} … {to}")];
    for end in [AtWidth::least, AtWidth::greatest] {
        row.extend(extreme(end(at), narrowest.and_then(end), none));
    }
    row
}

/// Value, difference from that in the narrowest face, and whether it is proven; if not, both ends of the proven bracket.
fn extreme(here: Option<FaceExtreme>, narrowest: Option<FaceExtreme>, none: &str) -> Vec<Markup> {
    let Some(here) = here else {
        return cells!["–", "", none];
    };
    let both = narrowest.filter(|one| one.holds() && here.holds());
    let more = match both {
        Some(one) if one.doubtful.is_none() && here.doubtful.is_none() => {
            um(here.found - one.found, 2)
        }
        Some(one) => {
            let ends = here.against(&one);
            band(ends.map_or([None; 2], |ends| ends.map(Some)), 2)
        }
        None => NONE.to_owned(),
    };
    let value = match (here.doubtful.is_none(), here.holds()) {
        (false, true) => band([here.low, here.high].map(Some), 2),
        _ => um(here.found, 2),
    };
    let proof = match (here.doubtful.and_then(extreme_doubt), here.holds()) {
        (None, _) => "proven".to_owned(),
        (Some(why), true) => format!("bracket: {why}"),
        (Some(why), false) => format!("not proven, found: {why}"),
    };
    cells![html! { strong { (value) } }, more, proof]
}

fn field(page: &Page) -> Markup {
    let Some(field) = &page.report.analysis.field else {
        return html! {
            p { "Left out: the worst pose has no proven contact on both sides, so that there are no contact lines." }
        };
    };
    let heading = Heading {
        prefix: "field",
        title: "Field of action at the least backlash",
        subtitle: &page.report.pair.study.title,
    };
    let drawn = chart::field(&heading, field);
    html! {
        figure.chart.tall tabindex="0" {
            (svg(&drawn))
            figcaption.hint {
                @if page.report.pair.study.deviates_along_face() {
                    "The places where each tooth pair would touch, paler the wider its gap along the line of action in the transverse section; numbers beside "
                    "them are its teeth and its least gap. Room over the face is how much farther each section alone would let the free gear turn: where it is 0 "
                    "the gears touch. The leads are those of the teeth that bind."
                } @else {
                "Each tooth pair touches along a line that climbs the path of contact by tan β" sub { "b" } " a mm of face; numbers beside it are its teeth and the gap that is left, along the line of action in the transverse section (the gap along the "
                "normal of the flanks is cos β" sub { "b" } " of it). The curve below is how much farther each section alone would let the free gear turn: where it is 0 the gears touch."
                }
            }
        }
    }
}

/// Symbol, section, formula, meaning, and value.
type Definition = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    fn(&GearPair, &Backlash) -> f64,
);

#[rustfmt::skip]
const DEFINITIONS: [Definition; 4] = [
    ("wt", "transverse", "φ_j r_w", "arc of the operating pitch circles", |_, of| of.j_wt),
    ("t", "transverse", "φ_j r = j_wt cos α_wt / cos α_t", "arc of the reference circles", |_, of| of.j_t),
    ("bt", "transverse, base", "φ_j r_b = j_wt cos α_wt", "along the line of action, arc of the base circles", |pair, of| of.j_bt(pair)),
    ("bn", "normal, base", "j_bt cos β_b = j_t cos α_n cos β", "along the normal of the flanks: what a feeler gauge finds", |_, of| of.j_bn),
];

fn definitions(page: &Page) -> Markup {
    let of = |found: Option<PoseOfRun>| {
        let found = found?;
        let pair = found.run.run.assembly.data()?.clone();
        let backlash = Backlash::new(&pair, found.pose.simulated.backlash?);
        Some((pair, backlash))
    };
    let ends = [of(page.whole.least), of(page.whole.greatest)];
    let columns = columns("symbol:w | section:w | formula:w | what it is | least:n | greatest:n");
    let rows = DEFINITIONS.map(|(index, section, formula, what, value)| {
        let [least, greatest] = ends
            .each_ref()
            .map(|end| um(end.as_ref().map(|(pair, of)| value(pair, of)), 2));
        cells![
            symbol("j", index),
            section,
            formula_markup(formula),
            what,
            least,
            greatest
        ]
    });
    let caption = html! {
        "The least and the greatest backlash of this page, µm; " i { "φ" } sub { "j" } " is the lost motion, " i { "r" } " a radius of the gear that turns"
    };
    html! {
        (Table::new("Backlash in four definitions", caption, columns, rows).named_by(3))
        p.note {
            "Three definitions of a normal backlash " (symbol("j", "n")) " are in use. Here it is " (symbol("j", "bn")) " of ISO 21771, in the last row. Others take "
            (formula_markup("j_wt cos α_n cos β")) ", which is " (formula_markup("cos α_t / cos α_wt")) " times as much, or "
            (formula_markup("j_bt cos β")) ", with the helix angle of the reference in place of that of the base cylinder. Compare formulas before values."
        }
    }
}

/// A formula in which `x_y` becomes a symbol with an index.
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

//! The method, its accuracy and its limits.

use super::figures::collapsed;
use super::page::Page;
use super::phrases::{j_wt, symbol};
use gearlash_text::numbers::bound_um;
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    let is_drawn = page.report.pair.spec.by_data().is_none();
    html! {
        section id="method" {
            h2 { "Method and error bound" }
            (collapsed("How the numbers are found", "how the numbers are found", html! {
                p {
                    @if is_drawn {
                        "Outlines are taken as drawn; a gear by its data is built as measured. The "
                    } @else {
                        "Both outlines are built as measured: involutes, generated fillets, tips and roots, each flank where its "
                        "thickness and pitch deviation put it, each gear off its axis by half its runout. The "
                    }
                    (page.report.pair.study.locked.name()) " is locked; its mate is turned until the right flanks touch, and until the "
                    "left flanks touch. The angle between is the lost motion, signed: negative backlash means that the teeth "
                    "would have to overlap, and that the pair cannot be assembled. Times the mate’s operating pitch radius it is "
                    "the circumferential backlash " (j_wt()) "."
                }
                p {
                    "Contacts are found on the curves themselves. The bound on the error of " (j_wt())
                    @if is_drawn { " covers rounding, and how far the curves may lie from what was drawn, and follows each pose" }
                    @else { " covers rounding alone and follows each pose" }
                    @if let Some(error) = page.whole.error_bound {
                        "; the greatest here is " (bound_um(error)) " µm"
                    }
                    @if is_drawn {
                        ". A drawing does not show how far it deviates from the intended gear."
                    } @else {
                        ". Symbols follow ISO 21771: " (symbol("s", base_index(page))) " base tooth thickness, " (symbol("x", "E"))
                        " generating profile shift coefficient, " (symbol("d", "Ff")) " root form diameter."
                    }
                }
                p {
                    "In a mating (w, p) the flank of wheel tooth w stands in the operating pitch point; flanks are named as seen "
                    "from the front, teeth numbered on each gear’s reference face."
                }
                @if is_drawn {
                    p {
                        "Teeth of a drawing are numbered clockwise from the first at or beyond +y; the picture shows the reference face. A tooth’s tip and root are the "
                        "last hundredth of its height; between is flank."
                    }
                }
                @if page.report.pair.study.is_helical() {
                    p {
                        "Helical teeth wind about the axis, an eccentricity does not. Rotation keeps points in their transverse section, so that the free gear "
                        "stops where the first section of the common face does. Each section is a spur pair with its teeth rolled on; it is looked at in as many "
                        "sections as no tooth pair can slip between, both ends of the face among them, and where an edge comes to a fillet. The result is that "
                        "of the whole face, not of a number of slices. Module, pressure angle, profile shift, rack and thickness allowances are those of the normal "
                        "section; " (symbol("s", base_index(page))) " and the diameters are those of the transverse section."
                    }
                }
            }))
            h3 { "Not in the model" }
            ul { @for left_out in not_modelled(page) { li { (left_out) } } }
        }
    }
}

/// Index of quantities on the base circle, as in the input section.
fn base_index(page: &Page) -> &'static str {
    if page.report.pair.study.is_helical() {
        "bt"
    } else {
        "b"
    }
}

fn not_modelled(page: &Page) -> Vec<&'static str> {
    let study = &page.report.pair.study;
    let mut left_out = vec!["Deflection under load."];
    if study.lean == [0.0; 2] && study.open_lean == [0.0; 2] && study.bearing_ends.is_none() {
        left_out.push("Axes that are not parallel.");
    }
    let spec = &page.report.pair.spec;
    let Some(gears) = spec.by_data() else {
        left_out.extend([
            "Deviations along the face width.",
            "Temperature: none is stated.",
        ]);
        return left_out;
    };
    if study.is_helical() && gears.iter().all(|gear| gear.lead.is_none()) {
        left_out.push("Lead deviations and modifications.");
    } else if !study.deviates_along_face() {
        left_out.push("Deviations along the face width.");
    }
    if spec.assembly.temperature_c.is_none() {
        left_out.push("Temperature: none is stated.");
    }
    left_out.push(if gears.iter().any(|gear| gear.profile.is_some()) { "Flank form beyond the stated profile deviations. Pitch and thickness deviations shift a flank rigidly." } else { "Flank form: each flank is an exact involute, which pitch and thickness deviations shift rigidly." });
    left_out
}

//! How the numbers were found, how closely, and what they leave out.

use super::page::Page;
use super::phrases::{j_wt, symbol};
use gearlash_files::numbers::bound_um;
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    html! {
        section id="method" {
            h2 { "Method and error bound" }
            p {
                "Both outlines are built as measured: involutes, generated fillets, tips and roots, each flank where its "
                "thickness and pitch deviation put it, each gear off its axis by half its runout. The "
                (page.report.pair.study.locked.name()) " is locked; its mate is turned until the right flanks touch, and until the "
                "left flanks touch. The angle between is the lost motion, signed: negative backlash means that the teeth "
                "would have to overlap, and that the pair cannot be assembled. Times the mate’s operating pitch radius it is "
                "the circumferential backlash " (j_wt()) "."
            }
            p {
                "Contacts are found on the curves themselves. The bound on the error of " (j_wt())
                " covers rounding alone and follows each pose"
                @if let Some(error) = page.whole.error_bound {
                    "; the greatest here is " (bound_um(error)) " µm"
                }
                ". Symbols follow ISO 21771: " (symbol("s", base_index(page))) " base tooth thickness, " (symbol("x", "E"))
                " generating profile shift coefficient, " (symbol("d", "Ff")) " root form diameter."
            }
            p {
                "In a mating (w, p) the flank of wheel tooth w stands in the operating pitch point; flanks are named as seen "
                "from the front, teeth numbered on each gear’s reference face."
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
            h3 { "Not in the model" }
            p {
                "Lead deviations and modifications, deflection under load, temperature and axis misalignment. Pitch and thickness deviations shift "
                "a flank rigidly; its form is the involute with the profile deviations that the file states."
            }
        }
    }
}

/// Index of what is of the base circle, as among the input.
fn base_index(page: &Page) -> &'static str {
    match page.report.pair.study.is_helical() {
        true => "bt",
        false => "b",
    }
}

//! The method, its accuracy and its limits.

use super::figures::collapsed;
use super::gears::{Gears, base_thickness};
use super::page::Page;
use super::phrases::j_wt;
use gearlash::pair::Member;
use gearlash_text::numbers::bound_um;
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    let gears = Gears::of(page.report.pair);
    html! {
        section id="method" {
            h2 { "Method and error bound" }
            (collapsed("How the numbers are found", "how the numbers are found", html! {
                p {
                    (gears.built) "The "
                    (page.report.pair.study.locked.name()) " is locked; its mate is turned until the right flanks touch, and until the "
                    "left flanks touch. The angle between is the lost motion, signed: negative backlash means that the teeth "
                    "would have to overlap, and that the pair cannot be assembled. Times the mate’s operating pitch radius it is "
                    "the circumferential backlash " (j_wt()) "."
                }
                p {
                    "Contacts are found on the curves themselves. The bound on the error of " (j_wt())
                    (gears.bound) " and follows each pose"
                    @if let Some(error) = page.whole.error_bound {
                        "; the greatest here is " (bound_um(error)) " µm"
                    }
                    (gears.symbols)
                }
                p {
                    "In a mating (w, p) the flank of wheel tooth w stands in the operating pitch point; flanks are named as seen "
                    "from the front, teeth numbered on each gear’s reference face."
                }
                @if let Some(teeth) = gears.teeth { p { (teeth) } }
                @if page.report.pair.study.is_helical() {
                    p {
                        "Helical teeth wind about the axis, an eccentricity does not. Rotation keeps points in their transverse section, so that the free gear "
                        "stops where the first section of the common face does. Each section is a spur pair with its teeth rolled on; it is looked at in as many "
                        "sections as no tooth pair can slip between, both ends of the face among them, and where an edge comes to a fillet. The result is that "
                        "of the whole face, not of a number of slices. Module, pressure angle, profile shift, rack and thickness allowances are those of the normal "
                        "section; " (base_thickness(page.report.pair)) " and the diameters are those of the transverse section."
                    }
                }
            }))
            h3 { "Not in the model" }
            ul { @for left_out in not_modelled(page).into_iter().chain(gears.form) { li { (left_out) } } }
        }
    }
}

fn not_modelled(page: &Page) -> Vec<&'static str> {
    let study = &page.report.pair.study;
    let mut left_out = vec!["Deflection under load."];
    if study.lean == [0.0; 2] && study.open_lean == [0.0; 2] && study.bearing_ends.is_none() {
        left_out.push("Axes that are not parallel.");
    }
    let spec = &page.report.pair.spec;
    let has_lead = |member| spec.data(member).is_some_and(|gear| gear.lead.is_some());
    if study.is_helical() && !Member::BOTH.into_iter().any(has_lead) {
        left_out.push("Lead deviations and modifications.");
    } else if !study.deviates_along_face() {
        left_out.push("Deviations along the face width.");
    }
    if spec.assembly.temperature_c.is_none() {
        left_out.push("Temperature: none is stated.");
    }
    left_out
}

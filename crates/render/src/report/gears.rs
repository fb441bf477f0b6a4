//! Parts of a page that depend on how gears are given: by their data, or by drawings.

use super::phrases::{plain, symbol};
use super::table::{Table, cells, columns};
use super::{drawings, stated};
use gearlash_input::PairFile;
use gearlash_input::spec::GearSpec;
use gearlash_text::numbers::shortest;
use maud::{Markup, Render, html};

/// The words of a page that differ between gears by data and drawn ones.
pub(super) struct Gears {
    /// The sentence on the input that reproduces the numbers.
    pub same: &'static str,
    /// How the outlines are made.
    pub built: &'static str,
    /// The errors within the error bound.
    pub bound: &'static str,
    /// The sentence after the bound: symbols, or limits of a drawing.
    pub symbols: Markup,
    /// How teeth are found on a drawing.
    pub teeth: Option<&'static str>,
    /// The flank form that the model leaves out.
    pub form: Option<&'static str>,
}

impl Gears {
    pub fn of(pair: &PairFile) -> Gears {
        let Some(gears) = pair.spec.by_data() else {
            return drawn();
        };
        let has_profile = gears.iter().any(|gear| gear.profile.is_some());
        Gears {
            same: "The same pair file and version give the same numbers.",
            built: "Both outlines are built as measured: involutes, generated fillets, tips and roots, each flank where its \
                    thickness and pitch deviation put it, each gear off its axis by half its runout. ",
            bound: " covers rounding alone",
            symbols: html! {
                ". Symbols follow ISO 21771: " (base_thickness(pair)) " base tooth thickness, " (symbol("x", "E"))
                " generating profile shift coefficient, " (symbol("d", "Ff")) " root form diameter."
            },
            teeth: None,
            form: Some(if has_profile {
                "Flank form beyond the stated profile deviations. Pitch and thickness deviations shift a flank rigidly."
            } else {
                "Flank form: each flank is an exact involute, which pitch and thickness deviations shift rigidly."
            }),
        }
    }
}

fn drawn() -> Gears {
    Gears {
        same: "The same pair file, drawings and version give the same numbers.",
        built: "Outlines are taken as drawn; a gear by its data is built as measured. ",
        bound: " covers rounding, and how far the curves may lie from what was drawn,",
        symbols: html! { ". A drawing does not show how far it deviates from the intended gear." },
        teeth: Some(
            "Teeth of a drawing are numbered clockwise from the first at or beyond +y; the picture shows the reference face. A tooth’s tip and root are the \
             last hundredth of its height; between is flank.",
        ),
        form: None,
    }
}

/// Table of both gears as stated.
pub(super) fn table(pair: &PairFile) -> Markup {
    let Some(gears) = pair.spec.by_data() else {
        return drawings::gears(pair);
    };
    let of = |value: &dyn Fn(&GearSpec) -> String| gears.map(value);
    let pressure = of(&|gear| shortest(gear.pressure_angle_deg));
    let helix = of(&|gear| gear.helix_angle_deg.map_or("0".to_owned(), shortest));
    let pitch = of(&|gear| stated::pitch(gear.pitch.as_ref(), false));
    let mut rows = vec![
        ("teeth", of(&|gear| gear.teeth.to_string())),
        ("module, mm", of(&|gear| shortest(gear.module_mm))),
        ("pressure angle, °", pressure),
        ("helix angle, °", helix),
        ("profile shift", of(&|gear| shortest(gear.profile_shift))),
        ("thickness", of(&|gear| stated::thickness(&gear.thickness))),
        ("runout, µm", of(&|gear| stated::runout(&gear.runout))),
        ("pitch", pitch),
    ];
    if gears.iter().all(|gear| gear.helix_angle_deg.is_none()) {
        rows.retain(|(name, _)| *name != "helix angle, °");
    }
    let columns = columns(" | wheel | pinion");
    let rows = rows.into_iter();
    let rows = rows.map(|(name, [wheel, pinion])| cells![name, plain(&wheel), plain(&pinion)]);
    Table::new("Gears", html! { "Gears as stated" }, columns, rows).render()
}

/// Symbol of the base tooth thickness, as in the section of the input.
pub(super) fn base_thickness(pair: &PairFile) -> Markup {
    symbol("s", if pair.study.is_helical() { "bt" } else { "b" })
}

//! The input as understood: both gears side by side, the assembly, warnings and remarks.

use super::figures::inspections;
use super::page::Page;
use super::phrases::{plain, sentence, symbol};
use super::stated::{high_tooth, pitch, profile, runout, thickness};
use super::{drawings, grades, notes};
use crate::chart::PictureError;
use gearlash::gear::{AsBuilt, Inspection};
use gearlash::pair::Member;
use gearlash_files::AnyPairSpec;
use gearlash_files::numbers::{fixed, shortest, stated_distance, trimmed};
use gearlash_files::spec::{AssemblySpec, GearSpec, HandName};
use maud::{Markup, html};

/// A property of a gear as built: symbol, index, name, unit, decimals, value.
type Property = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    usize,
    fn(&AsBuilt) -> f64,
);

/// What follows from the drawing and the measured thickness, lengths in mm.
const DERIVED: [Property; 7] = [
    (
        "x",
        "E",
        "generating profile shift coefficient",
        "–",
        5,
        |g| g.gear().generating_shift(),
    ),
    ("d", "", "reference diameter", "mm", 4, |g| {
        2.0 * g.gear().basic_data().reference_radius()
    }),
    ("d", "a", "tip diameter", "mm", 4, |g| {
        2.0 * g.gear().tip_radius()
    }),
    ("d", "f", "root diameter", "mm", 4, |g| {
        2.0 * g.gear().root_radius()
    }),
    ("d", "b", "base diameter", "mm", 4, |g| {
        2.0 * g.gear().base_radius()
    }),
    ("d", "Ff", "root form diameter", "mm", 4, |g| {
        2.0 * g.gear().form_radius()
    }),
    ("s", "b", "base tooth thickness", "mm", 5, |g| {
        g.gear().base_thickness()
    }),
];

/// What the drawing of a helical gear calls otherwise: place among [`DRAWN`], index, name, unit.
const NORMAL: [(usize, &str, &str, &str); 6] = [
    (1, "n", "normal module", "mm"),
    (2, "n", "normal pressure angle", "°"),
    (3, "", "profile shift coefficient, normal section", "–"),
    (4, "aP", "addendum of the basic rack", "normal module"),
    (5, "fP", "dedendum of the basic rack", "normal module"),
    (6, "fP", "root radius of the basic rack", "normal module"),
];

/// What the properties of a drawing are called.
fn drawn(is_helical: bool) -> [Property; 7] {
    let mut drawn = DRAWN;
    if is_helical {
        for (place, index, name, unit) in NORMAL {
            let property = &mut drawn[place];
            (property.1, property.2, property.3) = (index, name, unit);
        }
    }
    drawn
}

/// What follows, likewise.
fn derived(is_helical: bool) -> [Property; 7] {
    let mut derived = DERIVED;
    if is_helical {
        (derived[6].1, derived[6].2) = ("bt", "base tooth thickness, transverse section");
    }
    derived
}

/// What winds, of helical gears.
const WOUND: [Property; 5] = [
    (
        "β",
        "",
        "helix angle at the reference circle",
        "°",
        4,
        |g| g.gear().basic_data().helix_angle().to_degrees(),
    ),
    ("β", "b", "base helix angle", "°", 4, |g| {
        g.gear().basic_data().base_helix_angle().to_degrees()
    }),
    ("α", "t", "transverse pressure angle", "°", 4, |g| {
        g.gear()
            .basic_data()
            .transverse_pressure_angle()
            .to_degrees()
    }),
    ("m", "t", "transverse module", "mm", 4, |g| {
        2.0 * g.gear().basic_data().reference_radius() / f64::from(g.gear().basic_data().teeth())
    }),
    ("p", "bt", "transverse base pitch", "mm", 4, |g| {
        g.gear().basic_data().base_pitch()
    }),
];

/// What the drawing says.
const DRAWN: [Property; 7] = [
    ("z", "", "number of teeth", "–", 0, |g| {
        f64::from(g.gear().basic_data().teeth())
    }),
    ("m", "", "module", "mm", 4, |g| {
        g.gear().basic_data().module()
    }),
    ("α", "", "pressure angle", "°", 4, |g| {
        g.gear().basic_data().pressure_angle().to_degrees()
    }),
    ("x", "", "profile shift coefficient", "–", 4, |g| {
        g.gear().design().profile_shift
    }),
    ("h*", "aP", "addendum of the basic rack", "module", 3, |g| {
        g.gear().design().rack.addendum()
    }),
    ("h*", "fP", "dedendum of the basic rack", "module", 3, |g| {
        g.gear().design().rack.dedendum()
    }),
    (
        "ρ*",
        "fP",
        "root radius of the basic rack",
        "module",
        3,
        |g| g.gear().design().rack.root_radius(),
    ),
];

pub(super) fn section(page: &Page) -> Result<Markup, PictureError> {
    let study = &page.report.pair.study;
    let spec = match page.report.pair.spec {
        AnyPairSpec::Data(spec) => spec,
        AnyPairSpec::Outlines(spec) => {
            let assembly = assembly(page, &spec.assembly);
            return Ok(drawings::section(page, spec, &assembly));
        }
    };
    let gears = [&spec.wheel, &spec.pinion];
    let several = study.materials.len() > 1;
    let stated = |words: fn(&GearSpec) -> String| gears.map(words);
    let by_tooth = |gear: &AsBuilt| {
        let of = Inspection::of(gear);
        of.thickness().iter().any(|thickness| *thickness != 0.0)
    };
    let by_tooth = study
        .materials
        .first()
        .map_or([false; 2], |(_, wheel, pinion)| {
            [by_tooth(wheel), by_tooth(pinion)]
        });
    let pitches = [(&spec.wheel, by_tooth[0]), (&spec.pinion, by_tooth[1])];
    let pitches = pitches.map(|(gear, by_tooth)| pitch(gear.pitch.as_ref(), by_tooth));
    let face = gears.map(|gear| gear.reference_face.name().to_owned());
    Ok(html! {
        section id="input" {
            h2 { "Input" }
            div.scroll tabindex="0" role="region" aria-label="Both gears" {
                table {
                    caption {
                        "The gears as understood, defaults filled in"
                        @if study.is_helical() { "; module, pressure angle, profile shift, rack and thickness allowances in the normal section" }
                        @if several { "; two values: at most material, at least material" }
                    }
                    thead { tr {
                        th scope="col" { "symbol" } th scope="col" { "name" } th scope="col" { "unit" }
                        th.n scope="col" { "wheel (1)" } th.n scope="col" { "pinion (2)" }
                    } }
                    tbody {
                        @for property in drawn(study.is_helical()).iter() { (row(page, property)) }
                        @if study.is_helical() {
                            @for property in WOUND.iter().take(1) { (row(page, property)) }
                            (text_row(("", ""), "hand", "–", gears.map(hand)))
                            (text_row(("", ""), "face, each from its own measuring plane", "mm", gears.map(own_face)))
                            @for property in WOUND.iter().skip(1) { (row(page, property)) }
                        }
                        @for property in derived(study.is_helical()).iter() { (row(page, property)) }
                        (text_row(("", ""), as_stated(study.is_helical()), "", stated(|gear| thickness(&gear.thickness))))
                        (text_row(("2 e", ""), "twice the eccentricity, the runout as stated", "µm", stated(|gear| runout(&gear.runout))))
                        (text_row(("", ""), "high tooth", "–", stated(|gear| high_tooth(&gear.runout))))
                        (text_row(("F", "p"), if study.is_helical() { "pitch deviations, transverse section" } else { "pitch deviations" }, "", pitches))
                        @if gears.iter().any(|gear| gear.profile.is_some()) {
                            (text_row(("", ""), "profile deviations, + = more material", "", stated(|gear| profile(gear.profile.as_ref()))))
                        }
                        (text_row(("", ""), "reference face towards", "", face))
                    }
                }
            }
            (assembly(page, &spec.assembly))
            @for warning in page.report.pair.warnings.iter().chain(page.report.pair.remarks) { p.warning { strong { "Note: " } (sentence(&plain(warning))) } }
            (notes::list(page))
            (grades::table(page))
            (inspections(page)?)
        }
    })
}

/// How thickness is named.
fn as_stated(is_helical: bool) -> &'static str {
    match is_helical {
        true => "thickness as stated, allowances in the normal section",
        false => "thickness as stated",
    }
}

/// Which way the teeth wind.
fn hand(gear: &GearSpec) -> String {
    match gear.hand {
        Some(HandName::Left) => "left".to_owned(),
        Some(HandName::Right) => "right".to_owned(),
        None => String::new(),
    }
}

fn own_face(gear: &GearSpec) -> String {
    gear.face_mm.map_or(String::new(), |face| {
        let [from, to] = face.map(|end| trimmed(end, 0, 3));
        format!("{from} … {to}")
    })
}

fn row(page: &Page, (letter, index, name, unit, decimals, of): &Property) -> Markup {
    let cell = |member: Member| {
        let gears = page.report.pair.study.materials.iter();
        let mut values: Vec<String> = gears
            .map(|(_, wheel, pinion)| match member {
                Member::Wheel => trimmed(of(wheel), 0, *decimals),
                Member::Pinion => trimmed(of(pinion), 0, *decimals),
            })
            .collect();
        values.dedup();
        values.join(" / ")
    };
    text_row((letter, index), name, unit, Member::BOTH.map(cell))
}

fn text_row(
    (letter, index): (&str, &str),
    name: &str,
    unit: &str,
    [wheel, pinion]: [String; 2],
) -> Markup {
    html! {
        tr {
            td.w { (symbol(letter, index)) }
            th scope="row" { (name) }
            td { (unit) }
            td.n { (wheel) }
            td.n { (pinion) }
        }
    }
}

fn assembly(page: &Page, spec: &AssemblySpec) -> Markup {
    let study = &page.report.pair.study;
    let clearance = &spec.bearing_clearance_mm;
    let distances: Vec<String> = study
        .center_distances
        .iter()
        .map(|a| stated_distance(*a))
        .collect();
    let angles = page.report.analysis.runs.iter();
    let angles = angles.filter_map(|run| {
        Some(
            run.run
                .assembly
                .data()?
                .operating_pressure_angle()
                .to_degrees(),
        )
    });
    let (least, most) = (angles.clone().reduce(f64::min), angles.reduce(f64::max));
    let angle = match least == most {
        true => fixed(least, 4),
        false => format!("{} … {}", fixed(least, 4), fixed(most, 4)),
    };
    html! {
        div.scroll tabindex="0" role="region" aria-label="Assembly" {
            table {
                caption { "Assembly" }
                tbody {
                    tr { td { i { "a" } } th scope="row" { "centre distance" } td { "mm" }
                        td { (distances.join(", ")) } }
                    @if study.is_helical() {
                        @let [from, to] = study.face.map(|end| trimmed(end, 0, 3));
                        @let offset = spec.face_offset_mm.unwrap_or_default();
                        tr { td {} th scope="row" { "face offset: the pinion’s measuring plane beyond the wheel’s, away from the viewer" } td { "mm" } td { (shortest(offset)) } }
                        tr { td {} th scope="row" { "common face, from the wheel’s measuring plane away from the viewer" } td { "mm" } td { (from) " … " (to) } }
                    }
                    @if !study.is_drawn() {
                        tr { td { (symbol("α", "wt")) } th scope="row" { "operating pressure angle" } td { "°" } td { (angle) } }
                    }
                    tr { td {} th scope="row" { "radial bearing clearance, wheel / pinion" } td { "mm" }
                        td { (shortest(clearance.wheel)) " / " (shortest(clearance.pinion)) } }
                    tr { td {} th scope="row" { "locked gear" } td {} td { (study.locked.name()) } }
                }
            }
        }
    }
}

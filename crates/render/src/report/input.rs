//! The input as understood: both gears side by side, the assembly, warnings and remarks.

use super::figures::inspections;
use super::grades;
use super::page::Page;
use super::phrases::{plain, sentence, symbol};
use super::stated::{face_runout, high_tooth, lead, pitch, profile, runout, thickness};
use super::table::{Table, cells, columns};
use crate::chart::PictureError;
use gearlash::gear::{AsBuilt, BasicGearData, Hand, Inspection};
use gearlash_input::spec::{AssemblySpec, GearSpec};
use gearlash_text::numbers::{fixed, shortest, stated_distance, trimmed};
use maud::{Markup, Render, html};

/// A property of a gear as built: symbol, name and unit for spur gears; those for helical gears where they differ; decimals;
/// value.
type Property = (&'static str, &'static str, usize, fn(&AsBuilt) -> f64);

/// Properties that the drawing states.
#[rustfmt::skip]
const DRAWN: [Property; 7] = [
    ("z | number of teeth | –", "", 0, |g| basic(g).teeth().into()),
    ("m | module | mm", "m_n | normal module | mm", 4, |g| basic(g).module()),
    ("α | pressure angle | °", "α_n | normal pressure angle | °", 4, |g| basic(g).pressure_angle().to_degrees()),
    ("x | profile shift coefficient | –", "x | profile shift coefficient, normal section | –", 4, |g| g.gear().design().profile_shift),
    ("h*_aP | addendum of the basic rack | module", "h*_aP | addendum of the basic rack | normal module", 3, |g| g.gear().design().rack.addendum()),
    ("h*_fP | dedendum of the basic rack | module", "h*_fP | dedendum of the basic rack | normal module", 3, |g| g.gear().design().rack.dedendum()),
    ("ρ*_fP | root radius of the basic rack | module", "ρ*_fP | root radius of the basic rack | normal module", 3, |g| g.gear().design().rack.root_radius()),
];

/// The helix of helical gears.
#[rustfmt::skip]
const HELIX: [Property; 1] = [
    ("β | helix angle at the reference circle | °", "", 4, |g| basic(g).helix_angle().to_degrees()),
];

/// Properties of the transverse section of helical gears.
#[rustfmt::skip]
const TRANSVERSE: [Property; 4] = [
    ("β_b | base helix angle | °", "", 4, |g| basic(g).base_helix_angle().to_degrees()),
    ("α_t | transverse pressure angle | °", "", 4, |g| basic(g).transverse_pressure_angle().to_degrees()),
    ("m_t | transverse module | mm", "", 4, |g| 2.0 * basic(g).reference_radius() / f64::from(basic(g).teeth())),
    ("p_bt | transverse base pitch | mm", "", 4, |g| basic(g).base_pitch()),
];

/// Properties that follow from the drawing and the measured thickness.
#[rustfmt::skip]
const DERIVED: [Property; 7] = [
    ("x_E | generating profile shift coefficient | –", "", 5, |g| g.gear().generating_shift()),
    ("d | reference diameter | mm", "", 4, |g| 2.0 * basic(g).reference_radius()),
    ("d_a | tip diameter | mm", "", 4, |g| 2.0 * g.gear().tip_radius()),
    ("d_f | root diameter | mm", "", 4, |g| 2.0 * g.gear().root_radius()),
    ("d_b | base diameter | mm", "", 4, |g| 2.0 * g.gear().base_radius()),
    ("d_Ff | root form diameter | mm", "", 4, |g| 2.0 * g.gear().form_radius()),
    ("s_b | base tooth thickness | mm", "s_bt | base tooth thickness, transverse section | mm", 5, |g| g.gear().base_thickness()),
];

fn basic(gear: &AsBuilt) -> &BasicGearData {
    gear.gear().basic_data()
}

pub(super) fn section(page: &Page, gears: [&GearSpec; 2]) -> Result<Markup, PictureError> {
    let pair = page.report.pair;
    let study = &pair.study;
    let several = study.materials.len() > 1;
    let is_helical = study.is_helical();
    let mut rows = properties(page, &DRAWN);
    if is_helical {
        rows.extend(properties(page, &HELIX));
        rows.push(("| hand | –", gears.map(hand)));
        let name = "| face, each from its own measuring plane | mm";
        rows.push((name, gears.map(own_face)));
        rows.extend(properties(page, &TRANSVERSE));
    }
    rows.extend(properties(page, &DERIVED));
    let section = |spur, helical| if is_helical { helical } else { spur };
    let name = section(
        "| thickness as stated |",
        "| thickness as stated, allowances in the normal section |",
    );
    rows.push((name, gears.map(|gear| thickness(&gear.thickness))));
    let name = "2 e | twice the eccentricity, the runout as stated | µm";
    rows.push((name, gears.map(|gear| runout(&gear.runout))));
    let high_teeth = gears.map(|gear| high_tooth(&gear.runout));
    rows.push(("| high tooth | –", high_teeth));
    if gears.iter().any(|gear| gear.runout.face_runout.is_some()) {
        let name = "f_ax | axial runout of a shoulder, the wobble of the teeth |";
        rows.push((name, gears.map(|gear| face_runout(&gear.runout))));
    }
    let name = section(
        "F_p | pitch deviations |",
        "F_p | pitch deviations, transverse section |",
    );
    rows.push((name, pitches(page, gears)));
    if gears.iter().any(|gear| gear.profile.is_some()) {
        let name = "| profile deviations, + = more material |";
        rows.push((name, gears.map(|gear| profile(gear.profile.as_ref()))));
    }
    if gears.iter().any(|gear| gear.lead.is_some()) {
        let name = "| lead deviations, + = more material |";
        rows.push((name, gears.map(|gear| lead(gear.lead.as_ref()))));
    }
    let face = gears.map(|gear| gear.reference_face.name().to_owned());
    rows.push(("| reference face towards |", face));
    let columns = columns("symbol:w | name | unit | wheel (1):n | pinion (2):n");
    let rows = rows.iter().map(|(named, [wheel, pinion])| {
        let mut row = named_cells(named);
        row.extend(cells![wheel, pinion]);
        row
    });
    let caption = html! {
        "The gears as understood, defaults filled in"
        @if is_helical { "; module, pressure angle, profile shift, rack and thickness allowances in the normal section" }
        @if several { "; two values: at most material, at least material" }
    };
    Ok(html! {
        section id="input" {
            h2 { "Input" }
            (Table::new("Both gears", caption, columns, rows).named_by(1))
            (assembly(page, &pair.spec.assembly))
            @for warning in pair.warnings.iter().chain(&pair.remarks) { p.warning { strong { "Note: " } (sentence(&plain(warning))) } }
            (grades::notes(page))
            (grades::table(page))
            (inspections(page)?)
        }
    })
}

/// The cells of a symbol, a name and a unit, such as `d_a | tip diameter | mm`.
fn named_cells(text: &str) -> Vec<Markup> {
    let mut parts = text.splitn(3, '|').map(str::trim);
    let mut next = || parts.next().unwrap_or_default();
    let symbols = next();
    let (letter, index) = symbols.split_once('_').unwrap_or((symbols, ""));
    cells![symbol(letter, index), next(), next()]
}

fn pitches(page: &Page, gears: [&GearSpec; 2]) -> [String; 2] {
    let first = page.report.pair.study.materials.first();
    [0, 1].map(|k| {
        let by_tooth = first.is_some_and(|(_, wheel, pinion)| {
            let inspection = Inspection::of([wheel, pinion][k]);
            inspection.thickness().iter().any(|off| *off != 0.0)
        });
        pitch(gears[k].pitch.as_ref(), by_tooth)
    })
}

/// The values of `list` for both gears, for each material where they differ.
fn properties(page: &Page, list: &[Property]) -> Vec<(&'static str, [String; 2])> {
    let study = &page.report.pair.study;
    let each = list.iter().map(|(spur, helical, decimals, of)| {
        let values = [0, 1].map(|k| {
            let materials = study.materials.iter();
            let gears = materials.map(|(_, wheel, pinion)| [wheel, pinion][k]);
            by_material(gears.map(|gear| trimmed(of(gear), 0, *decimals)))
        });
        let is_other = study.is_helical() && !helical.is_empty();
        (if is_other { *helical } else { *spur }, values)
    });
    each.collect()
}

/// The values of one gear at most and at least material: one where they are equal.
pub(super) fn by_material(values: impl Iterator<Item = String>) -> String {
    let mut values: Vec<String> = values.collect();
    values.dedup();
    values.join(" / ")
}

fn hand(gear: &GearSpec) -> String {
    gear.hand.map_or("", Hand::name).to_owned()
}

fn own_face(gear: &GearSpec) -> String {
    gear.face_mm.map_or(String::new(), |face| {
        let [from, to] = face.map(|end| trimmed(end, 0, 3));
        format!("{from} … {to}")
    })
}

pub(super) fn assembly(page: &Page, spec: &AssemblySpec) -> Markup {
    let study = &page.report.pair.study;
    let clearance = &spec.bearing_clearance_mm;
    let distances = study.center_distances.iter().map(|a| stated_distance(*a));
    let distances: Vec<String> = distances.collect();
    let angles = page.report.analysis.runs.iter();
    let angles = angles.filter_map(|run| run.run.assembly.operating_pressure_angle());
    let angles = angles.map(f64::to_degrees);
    let ends = [angles.clone().reduce(f64::min), angles.reduce(f64::max)];
    let mut rows = vec![("a | centre distance | mm", distances.join(", "))];
    if study.lean != [0.0; 2] {
        let [in_plane, out_of_plane] = study.lean.map(|lean| trimmed(1e3 * lean, 0, 4));
        let name = "| lean of the pinion’s axis, in the plane of the axes / out of it | µm/mm";
        rows.push((name, format!("{in_plane} / {out_of_plane}")));
    }
    if study.is_helical() {
        let [from, to] = study.face.map(|end| trimmed(end, 0, 3));
        let offset = shortest(spec.face_offset_mm.unwrap_or_default());
        rows.push(("| face offset: the pinion’s measuring plane beyond the wheel’s, away from the viewer | mm", offset));
        let name = "| common face, from the wheel’s measuring plane away from the viewer | mm";
        rows.push((name, format!("{from} … {to}")));
    }
    if let [Some(least), Some(most)] = ends {
        let angle = if least == most {
            fixed(least, 4)
        } else {
            format!("{} … {}", fixed(least, 4), fixed(most, 4))
        };
        rows.push(("α_wt | operating pressure angle | °", angle));
    }
    let each = clearance.each().map(|ends| {
        let mut ends = ends.map(shortest).to_vec();
        ends.dedup();
        ends.join(", ")
    });
    let name = "| radial bearing clearance, wheel / pinion | mm";
    rows.push((name, each.join(" / ")));
    if let Some(at) = clearance.at_mm {
        let name = "| bearings, from the wheel’s measuring plane away from the viewer | mm";
        rows.push((name, at.map(shortest).join(", ")));
    }
    rows.push(("| locked gear |", study.locked.name().to_owned()));
    let rows = rows.into_iter().map(|(named, value)| {
        let mut row = named_cells(named);
        row.extend(cells![value]);
        row
    });
    let caption = html! { "Assembly" };
    Table::new("Assembly", caption, columns(" | | | "), rows)
        .named_by(1)
        .render()
}

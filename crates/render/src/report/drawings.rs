//! The drawings as read, and the assembly.

use super::input::{assembly, by_material};
use super::page::Page;
use super::phrases::{plain, sentence};
use super::stated::{high_tooth, runout, single_or_band, thickness};
use super::table::{Table, cells, columns};
use gearlash::outline::OutlineGear;
use gearlash_input::PairFile;
use gearlash_input::outlines::DrawingRead;
use gearlash_input::spec::{
    CentreName, CentreSpec, EitherGearSpec, GearSpec, OutlineSpec, PointsKind,
};
use gearlash_results::drawn_notes;
use gearlash_text::numbers::{bound_um, shortest, trimmed};
use maud::{Markup, Render, html};

pub(super) fn section(page: &Page) -> Markup {
    let pair = page.report.pair;
    let notes = drawn_notes(pair);
    html! {
        section id="input" {
            h2 { "Drawings and assembly" }
            (gears(pair))
            @for note in notes.lines() { p { (note) } }
            @if notes.lines().count() <= pair.drawings.iter().flatten().count() {
                p { (if notes.lines().count() > 1 { "No other" } else { "No" }) " outline looks like an involute." }
            }
            (assembly(page, &pair.spec.assembly))
            @for warning in pair.warnings.iter().chain(&pair.remarks) { p.warning { strong { "Note: " } (sentence(&plain(warning))) } }
        }
    }
}

/// Table of both gears of a pair with a drawn one.
pub(super) fn gears(pair: &PairFile) -> Markup {
    let columns = columns("name | wheel (1):n | pinion (2):n");
    let rows = rows(pair).into_iter();
    let rows = rows.map(|(name, [wheel, pinion])| cells![name, wheel, pinion]);
    let caption =
        html! { "What was read of each drawing; lengths after its unit and scale are taken in" };
    Table::new("Both gears", caption, columns, rows).render()
}

fn rows(pair: &PairFile) -> Vec<(&'static str, [String; 2])> {
    let specs = [&pair.spec.wheel, &pair.spec.pinion];
    let dash = || "–".to_owned();
    let of = |drawing: &dyn Fn(&OutlineSpec, &DrawingRead) -> String,
              data: &dyn Fn(&GearSpec) -> String| {
        [0, 1].map(|k| match (specs[k], &pair.drawings[k]) {
            (EitherGearSpec::Outline(spec), Some(read)) => drawing(&spec.outline, read),
            (EitherGearSpec::Data(spec), _) => data(spec),
            (EitherGearSpec::Outline(_), None) => dash(),
        })
    };
    let drawn = |drawing: &dyn Fn(&OutlineSpec, &DrawingRead) -> String| of(drawing, &|_| dash());
    let gears = |value: fn(&OutlineGear) -> f64| {
        [0, 1].map(|k| {
            let gears = pair.study.drawn.iter();
            let gears = gears.map(|(_, wheel, pinion)| value([wheel, pinion][k]));
            by_material(gears.map(|value| trimmed(value, 0, 4)))
        })
    };
    let runouts = specs.map(EitherGearSpec::runout);
    let followed = drawn(&|_, read| match read.bound_mm {
        0.0 => "as drawn".to_owned(),
        bound => bound_um(bound),
    });
    let inside = drawn(&|_, read| read.inside.to_string());
    let faces = specs.map(|spec| spec.reference_face().name().to_owned());
    let mut rows = vec![
        ("drawing", of(&|spec, _| plain(&spec.file), &by_its_data)),
        ("chosen path", drawn(&|spec, _| selection(spec))),
        ("unit", drawn(&unit)),
        ("scale", specs.map(scale)),
        ("centre in the drawing, mm", drawn(&centre)),
        ("parts of the outline", drawn(&parts)),
        ("followed within, µm", followed),
        ("closed paths inside", inside),
        ("moved out by, mm", specs.map(offset)),
        ("teeth", gears(|gear| f64::from(gear.teeth()))),
        ("tip diameter, mm", gears(|gear| 2.0 * gear.tip_radius())),
        ("root diameter, mm", gears(|gear| 2.0 * gear.root_radius())),
        ("runout as stated, µm", runouts.map(runout)),
        ("high tooth", runouts.map(high_tooth)),
        ("reference face towards", faces),
    ];
    rows.retain(|(_, cells)| cells.iter().any(|cell| cell != "–"));
    rows
}

fn by_its_data(spec: &GearSpec) -> String {
    format!(
        "none: by its data, module {} mm, {}°, x = {}, {}",
        shortest(spec.module_mm),
        shortest(spec.pressure_angle_deg),
        shortest(spec.profile_shift),
        thickness(&spec.thickness)
    )
}

fn offset(spec: &EitherGearSpec) -> String {
    let thickness = match spec {
        EitherGearSpec::Outline(spec) => spec.thickness,
        EitherGearSpec::Data(_) => None,
    };
    let stated = thickness.and_then(|thickness| thickness.flank_offset_mm);
    stated.map_or("–".to_owned(), |stated| single_or_band(&stated))
}

fn scale(spec: &EitherGearSpec) -> String {
    spec.scale().map_or("–".to_owned(), shortest)
}

fn selection(spec: &OutlineSpec) -> String {
    match (&spec.layer, &spec.id) {
        (Some(layer), _) => format!("layer {}", plain(layer)),
        (_, Some(id)) => format!("id {}", plain(id)),
        (None, None) => "–".to_owned(),
    }
}

fn unit(spec: &OutlineSpec, read: &DrawingRead) -> String {
    let by = match spec.units {
        Some(_) => "the pair file",
        None => "the drawing",
    };
    format!("{} mm, stated by {by}", shortest(read.unit_mm))
}

fn centre(spec: &OutlineSpec, read: &DrawingRead) -> String {
    let how = match spec.center_mm {
        CentreSpec::At(_) => "as stated",
        CentreSpec::Found(CentreName::Bore) => "of the circle inside",
        CentreSpec::Found(CentreName::Fit) => "of the circle through the tips",
    };
    let [x, y] = [read.centre.x, read.centre.y].map(|mm| trimmed(mm, 0, 6));
    format!("({x}, {y}), {how}")
}

fn parts(spec: &OutlineSpec, read: &DrawingRead) -> String {
    let named = ["line", "arc", "curve"].into_iter().zip(read.parts);
    let named = named.filter(|(_, count)| *count > 0);
    let named = named.map(|(name, count)| match count {
        1 => format!("1 {name}"),
        _ => format!("{count} {name}s"),
    });
    let smooth = match spec.kind {
        PointsKind::Smooth => " through the points",
        PointsKind::Polygon => "",
    };
    named.collect::<Vec<_>>().join(", ") + smooth
}

//! A list of the outlines of a drawing, for a user to choose from.

use super::pair::{OutlineOptions, by_flags};
use super::paths::{outlines, start};
use gearlash::outline::{PathSegment, fit_centre};
use gearlash_drawing::{Format, Options, Unit};
use gearlash_text::{InputError, Problem, source};
use nalgebra::Vector2;
use std::path::Path;

/// The outlines of a drawing.
#[derive(Debug, Clone)]
pub struct ListedOutlines {
    /// Length of one of its units, mm.
    pub unit_mm: f64,
    /// Its unit as in a pair file, where it states none.
    pub units: Option<String>,
    /// In the order of the file.
    pub outlines: Vec<ListedOutline>,
    /// Distance of the centres of two gears that are drawn in mesh, mm.
    pub mesh_distance_mm: Option<f64>,
    /// Ignored and repaired elements.
    pub remarks: Vec<String>,
}

/// One outline of a drawing.
#[derive(Debug, Clone)]
pub struct ListedOutline {
    /// Its layer, or the id of its element; empty without one.
    pub name: String,
    /// Where in the file it begins.
    pub place: String,
    /// Where it begins in the drawing, mm, as `(x, y)`.
    pub start: String,
    /// Width and height, mm.
    pub size_mm: Vector2<f64>,
    /// Whether its axis can be the origin of the drawing: the middle of its box is near.
    pub is_centred: bool,
    /// Lines, arcs and curves.
    pub parts: usize,
    /// Closed paths inside it.
    pub inside: usize,
}

/// Distance of the centres of two gears that are drawn in mesh, mm; `None` of others.
fn mesh_distance_mm(gears: &[(&[PathSegment], f64)]) -> Option<f64> {
    let [(wheel, r_1), (pinion, r_2)] = *gears else {
        return None;
    };
    let centre = |outline| fit_centre(outline).ok().map(|fitted| fitted.centre);
    let distance = (centre(wheel)? - centre(pinion)?).norm();
    // Tips reach past each other, and no centre is inside the other gear.
    (r_1.max(r_2)..r_1 + r_2)
        .contains(&distance)
        .then_some(distance)
}

/// Largest distance of a gear's axis from the middle of its outline, of half the diagonal of its box. Runout is below 0.01 of it.
const OFF_CENTRE: f64 = 0.05;

/// Whether a file is a drawing that names its outlines: DXF or SVG.
pub fn lists_outlines(path: &Path) -> bool {
    matches!(Format::of(path), Some(Format::Dxf | Format::Svg))
}

/// The outlines of the drawing at `path`; `units` is its unit as in a pair file, used where it states none.
///
/// # Errors
/// [`InputError`] where the file is no drawing or has a fault; it names options of the command line, not keys.
pub fn listed_outlines(path: &Path, units: Option<&str>) -> Result<ListedOutlines, InputError> {
    let unit = |name: &str| Unit::NAMED.iter().find(|(known, _)| *known == name);
    let fault = |problem: Problem| by_flags(InputError::of(path, vec![problem]));
    let bytes = source::bytes(path).map_err(fault)?;
    let given = OutlineOptions {
        units,
        ..OutlineOptions::default()
    };
    let (needed, unused) = given.with_unit_needed(path, None);
    let options = Options {
        unit: needed.units.and_then(unit).map(|(_, unit)| *unit),
        ..Options::default()
    };
    let read = gearlash_drawing::read(path, &bytes, &options);
    let mut read = read.map_err(|error| fault(Problem::of_file(error.to_string(), error.help)))?;
    read.remarks.extend(unused);
    let help = "remove what is no outline, or name the layer or id to read in a pair file";
    let outlines = outlines(&read.loops, &mut read.remarks)
        .map_err(|error| fault(Problem::of_file(error, help)))?;
    let each = outlines.iter().map(|outline| {
        let path = &read.loops[outline.index];
        let [low, high] = outline.ends;
        ListedOutline {
            name: path.name.clone(),
            place: path.place.clone(),
            start: start(path),
            size_mm: high - low,
            is_centred: (low.coords + high.coords).norm() <= OFF_CENTRE * (high - low).norm(),
            parts: path.segments.len(),
            inside: outline.inside.len(),
        }
    });
    let gears = outlines.iter().map(|outline| {
        let [low, high] = outline.ends;
        let segments = &read.loops[outline.index].segments;
        (&segments[..], 0.5 * (high - low).max())
    });
    Ok(ListedOutlines {
        mesh_distance_mm: mesh_distance_mm(&gears.collect::<Vec<_>>()),
        unit_mm: read.unit_mm,
        units: needed.units.map(str::to_owned),
        outlines: each.collect(),
        remarks: read.remarks,
    })
}

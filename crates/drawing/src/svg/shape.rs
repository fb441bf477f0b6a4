//! The shapes of an SVG by their attributes, and its user space: view boxes, the length of its unit.

use crate::affine::Affine;
use crate::error::LONGEST_NAME;
use gearlash_text::characters::cut;
use nalgebra::{Matrix2, Vector2};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, ViewBox};

pub enum Data {
    Path(String),
    /// An ellipse by its centre and radii.
    Round([f64; 2], [f64; 2]),
}

/// The shape that the element `name` draws, or its fault in words; `None`: such elements are not read.
pub fn data(node: Node, name: &str) -> Option<Result<Data, String>> {
    Some(match name {
        "path" => path(node),
        "polygon" => points(node, " Z"),
        "polyline" => points(node, ""),
        "line" => line(node),
        "rect" => rectangle(node),
        "circle" => round(node, ["r", "r"]),
        "ellipse" => round(node, ["rx", "ry"]),
        _ => return None,
    })
}

/// A number of user units; `None` where the attribute is absent.
pub fn number(node: Node, name: &str) -> Result<Option<f64>, String> {
    let Some(text) = node.attribute(name) else {
        return Ok(None);
    };
    let shown = || cut(text, LONGEST_NAME);
    let length: Length = text
        .trim()
        .parse()
        .map_err(|error| format!("{name} = \"{}\": {error}", shown()))?;
    match length.unit {
        LengthUnit::None | LengthUnit::Px => Ok(Some(length.number)),
        _ => Err(format!(
            "{name} = \"{}\", expected a number of user units",
            shown()
        )),
    }
}

fn needed(node: Node, name: &str) -> Result<f64, String> {
    number(node, name)?.ok_or_else(|| format!("{name} is missing"))
}

/// A number; 0 where it is absent.
fn or_zero(node: Node, name: &str) -> Result<f64, String> {
    Ok(number(node, name)?.unwrap_or(0.0))
}

fn path(node: Node) -> Result<Data, String> {
    let data = node.attribute("d").ok_or("d is missing")?;
    Ok(Data::Path(data.to_owned()))
}

/// A list of points, written as path data.
fn points(node: Node, end: &str) -> Result<Data, String> {
    let points = node.attribute("points").ok_or("points is missing")?;
    let strange = |c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E');
    if let Some(strange) = points.chars().find(|c| strange(*c)) {
        return Err(format!("points: \"{strange}\", expected numbers alone"));
    }
    // SVG draws nothing for an empty list.
    Ok(Data::Path(match points.trim() {
        "" => String::new(),
        _ => format!("M {points}{end}"),
    }))
}

fn line(node: Node) -> Result<Data, String> {
    let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|name| or_zero(node, name));
    Ok(Data::Path(format!("M {},{} L {},{}", x1?, y1?, x2?, y2?)))
}

fn rectangle(node: Node) -> Result<Data, String> {
    let (x, y) = (or_zero(node, "x")?, or_zero(node, "y")?);
    let (width, height) = (needed(node, "width")?, needed(node, "height")?);
    if !(width > 0.0 && height > 0.0) {
        return Err("width or height is not above 0".to_owned());
    }
    // One radius stands for both, and none is over half a side: SVG 2, 10.3.
    let stated = [number(node, "rx")?, number(node, "ry")?];
    let [rx, ry] = [stated[0].or(stated[1]), stated[1].or(stated[0])];
    let [rx, ry] = [(rx, width), (ry, height)].map(|(r, side)| r.unwrap_or(0.0).min(side / 2.0));
    Ok(Data::Path(if rx > 0.0 && ry > 0.0 {
        let (from, wide, high) = (x + rx, width - 2.0 * rx, height - 2.0 * ry);
        let round = |to_x: f64, to_y: f64| format!("a {rx},{ry} 0 0 1 {to_x},{to_y}");
        let corners = [(rx, ry), (-rx, ry), (-rx, -ry), (rx, -ry)].map(|(x, y)| round(x, y));
        let [one, two, three, four] = corners;
        format!(
            "M {from},{y} h {wide} {one} v {high} {two} h {} {three} v {} {four} Z",
            -wide, -high
        )
    } else {
        format!("M {x},{y} h {width} v {height} h {} Z", -width)
    }))
}

fn round(node: Node, names: [&str; 2]) -> Result<Data, String> {
    let centre = [or_zero(node, "cx")?, or_zero(node, "cy")?];
    let radii = [needed(node, names[0])?, needed(node, names[1])?];
    if radii.iter().all(|&radius| radius > 0.0) {
        Ok(Data::Round(centre, radii))
    } else {
        Err(format!("{} is not above 0", names.join(" or ")))
    }
}

/// The length of a unit of the outermost user space by the size of the page, in words and mm; `None` where the page has no size on
/// paper, and `Err` in words where width and height do not agree.
pub fn page_unit(
    size: [Option<Length>; 2],
    view: Option<ViewBox>,
    aspect: AspectRatio,
) -> Result<Option<(String, f64)>, String> {
    let ([Some(width), Some(height)], Some(view)) = (size, view) else {
        return Ok(None);
    };
    let (Some(wide), Some(high)) = (on_paper(&width), on_paper(&height)) else {
        return Ok(None);
    };
    let scales = [wide / view.w, high / view.h];
    let scale = fitted(scales, aspect);
    if !(scale[0] > 0.0 && scale[0].is_finite()) {
        return Err("a page without size".to_owned());
    }
    // A stretch by the last printed digit is rounding.
    if (scale[1] / scale[0] - 1.0).abs() > 1e-6 {
        return Err("preserveAspectRatio=\"none\" with a page of other proportions".to_owned());
    }
    let words = format!("width {wide} mm of {} units", view.w);
    Ok(Some((words, scale[0])))
}

/// A length in mm, where its unit is one of paper: CSS Values 3, 6.2. A px belongs to a screen in practice.
fn on_paper(length: &Length) -> Option<f64> {
    let mm = match length.unit {
        LengthUnit::Mm => 1.0,
        LengthUnit::Cm => 10.0,
        LengthUnit::In => 25.4,
        LengthUnit::Pt => 25.4 / 72.0,
        LengthUnit::Pc => 25.4 / 6.0,
        _ => return None,
    };
    Some(length.number * mm)
}

/// Both scales by `preserveAspectRatio`.
fn fitted([x, y]: [f64; 2], aspect: AspectRatio) -> [f64; 2] {
    match (aspect.align, aspect.slice) {
        (Align::None, _) => [x, y],
        (_, false) => [x.min(y); 2],
        (_, true) => [x.max(y); 2],
    }
}

/// The map from the user space of a nested `svg` at `corner` with `size` to the one around it: SVG 2, 8.2.
pub fn viewport(corner: [f64; 2], size: [f64; 2], view: ViewBox, aspect: AspectRatio) -> Affine {
    let scale = fitted([size[0] / view.w, size[1] / view.h], aspect);
    let share = match aspect.align {
        Align::None | Align::XMinYMin => [0.0, 0.0],
        Align::XMidYMin => [0.5, 0.0],
        Align::XMaxYMin => [1.0, 0.0],
        Align::XMinYMid => [0.0, 0.5],
        Align::XMidYMid => [0.5, 0.5],
        Align::XMaxYMid => [1.0, 0.5],
        Align::XMinYMax => [0.0, 1.0],
        Align::XMidYMax => [0.5, 1.0],
        Align::XMaxYMax => [1.0, 1.0],
    };
    let shift = |axis: usize, from: f64, length: f64| {
        let rest = size[axis] - length * scale[axis];
        corner[axis] - from * scale[axis] + share[axis] * rest
    };
    Affine::new(
        Matrix2::from_diagonal(&Vector2::from(scale)),
        Vector2::new(shift(0, view.x, view.w), shift(1, view.y, view.h)),
    )
}

//! The shapes of an SVG by their attributes.

use roxmltree::Node;
use svgtypes::{Length, LengthUnit};

pub enum Data {
    Path(String),
    /// An ellipse by its centre and radii.
    Round([f64; 2], [f64; 2]),
    /// No shape, by the rules of SVG.
    Nothing,
    /// The fault, in words.
    Wrong(String),
    /// An element that is not read, by its name.
    Refused(String),
}

/// The shape that the element `name` draws.
pub fn data(node: Node, name: &str) -> Data {
    let drawn = match name {
        "path" => path(node),
        "polygon" => points(node, " Z"),
        "polyline" => points(node, ""),
        "line" => line(node),
        "rect" => rectangle(node),
        "circle" => round(node, ["r", "r"]),
        "ellipse" => round(node, ["rx", "ry"]),
        _ => Ok(Data::Refused(format!(
            "the element {}",
            crate::characters::cut(name, 60)
        ))),
    };
    drawn.unwrap_or_else(Data::Wrong)
}

/// A number of user units; `None` where the attribute is absent.
pub fn number(node: Node, name: &str) -> Result<Option<f64>, String> {
    let Some(text) = node.attribute(name) else {
        return Ok(None);
    };
    let shown = || crate::characters::cut(text, 60);
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
    if points.trim().is_empty() {
        return Ok(Data::Nothing);
    }
    Ok(Data::Path(format!("M {points}{end}")))
}

fn line(node: Node) -> Result<Data, String> {
    let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|name| or_zero(node, name));
    Ok(Data::Path(format!("M {},{} L {},{}", x1?, y1?, x2?, y2?)))
}

fn rectangle(node: Node) -> Result<Data, String> {
    let round = [or_zero(node, "rx")?, or_zero(node, "ry")?];
    if round != [0.0, 0.0] {
        return Ok(Data::Refused("a rect with round corners".to_owned()));
    }
    let (x, y) = (or_zero(node, "x")?, or_zero(node, "y")?);
    let (width, height) = (needed(node, "width")?, needed(node, "height")?);
    if width > 0.0 && height > 0.0 {
        Ok(Data::Path(format!(
            "M {x},{y} h {width} v {height} h {} Z",
            -width
        )))
    } else {
        Err("width or height is not above 0".to_owned())
    }
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

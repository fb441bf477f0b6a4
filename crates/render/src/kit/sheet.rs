//! The sheet, the lines on it, and areas that a picture fills, strokes and clips by, each with an id.
//!
//! Programs limit what can be used. Inkscape 1.2 shows `<use>` only with XLink's `href`. LibreOffice 7.4 neither clips by a
//! `<use>` nor clips one. So `href` is XLink's, a clip has its own copy of the path, and the clipped element is a group.

use super::frame::{Frame, Spot, number};
use svg::Node;
use svg::node::element::{ClipPath, Definitions, Group, Path, Rectangle, SVG, Use};

/// Width of an A4 sheet in landscape, units of 0.25 mm.
pub const WIDTH: f64 = 1188.0;
pub const HEIGHT: f64 = 840.0;
pub const UNITS_PER_MM: f64 = 4.0;

/// The namespace of references that Inkscape 1.2 also follows.
const XLINK: &str = "http://www.w3.org/1999/xlink";

/// The reader's own sans-serif face first. resvg takes Arial for it, and shows no text at all where Arial is absent. The other
/// fonts are on most machines, and none is wider than the widths in `text.rs`.
pub const FONTS: &str = "sans-serif, DejaVu Sans, Liberation Sans, Noto Sans";

/// An empty white sheet with a size in units, true to size in print.
pub fn blank_sheet(width: f64, height: f64) -> SVG {
    let ground = Rectangle::new().set("width", "100%").set("height", "100%");
    SVG::new()
        .set("xmlns:xlink", XLINK)
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("width", format!("{}mm", width / UNITS_PER_MM))
        .set("height", format!("{}mm", height / UNITS_PER_MM))
        .set("font-family", FONTS)
        .add(ground.set("fill", "white"))
}

/// `picture` for a page, with its id there and a description for screen readers.
pub fn in_page(picture: SVG, id: &str, label: &str) -> String {
    let picture = picture.set("id", id).set("role", "img");
    format!("{}\n", picture.set("aria-label", label))
}

/// Ids of a picture: a page can hold several.
#[derive(Debug, Clone, Default)]
pub struct Ids {
    prefix: String,
}

impl Ids {
    /// Ids that begin with `prefix`, unique in a page.
    pub fn in_page(prefix: &str) -> Ids {
        Ids {
            prefix: format!("{prefix}-"),
        }
    }

    pub fn is_sheet(&self) -> bool {
        self.prefix.is_empty()
    }

    pub fn of(&self, name: &str) -> String {
        format!("{}{name}", self.prefix)
    }

    /// A reference to the element called `name`, for a fill or a clip.
    pub fn url(&self, name: &str) -> String {
        format!("url(#{})", self.of(name))
    }
}

/// Path data through `points`, without repeated points.
pub fn path_data(points: &[Spot], closed: bool) -> String {
    let mut data = String::new();
    let mut last = String::new();
    for [x, y] in points {
        let here = format!("{} {}", number(*x), number(*y));
        if here != last {
            data.push(if data.is_empty() { 'M' } else { 'L' });
            data.push_str(&here);
            last = here;
        }
    }
    if closed {
        data.push('Z');
    }
    data
}

/// A line through `points`, without fill.
pub fn line(points: &[Spot], colour: &str, width: f64) -> Path {
    Path::new()
        .set("d", path_data(points, false))
        .set("fill", "none")
        .set("stroke", colour)
        .set("stroke-width", number(width))
}

pub fn dashed(points: &[Spot], colour: &str, width: f64, dashes: &str) -> Path {
    line(points, colour, width).set("stroke-dasharray", dashes)
}

pub fn group<T: Into<Box<dyn Node>>>(parts: impl IntoIterator<Item = T>) -> Group {
    parts.into_iter().fold(Group::new(), Group::add)
}

/// The filled polygon of `points`.
pub fn polygon(points: &[Spot], fill: &str) -> Path {
    Path::new()
        .set("d", path_data(points, true))
        .set("fill", fill)
}

/// `definitions` with the inside of `points` as the area `name`.
pub fn define_area(
    definitions: Definitions,
    ids: &Ids,
    name: &str,
    points: &[Spot],
) -> Definitions {
    let path = Path::new().set("d", path_data(points, true));
    let limit = ClipPath::new().set("id", ids.of(&format!("{name}-clip")));
    let area = path.clone().set("id", ids.of(name));
    definitions.add(area).add(limit.add(path))
}

/// The area `name`, to be filled or stroked.
pub fn area(ids: &Ids, name: &str) -> Use {
    Use::new().set("xlink:href", format!("#{}", ids.of(name)))
}

pub fn within_area(ids: &Ids, name: &str) -> Group {
    clipped(ids, &format!("{name}-clip"))
}

pub fn clipped(ids: &Ids, name: &str) -> Group {
    Group::new().set("clip-path", ids.url(name))
}

/// The inside of `frame` as the limit `name`.
pub fn define_frame(ids: &Ids, name: &str, frame: &Frame) -> Definitions {
    let limit = ClipPath::new().set("id", ids.of(name));
    Definitions::new().add(limit.add(frame.rectangle()))
}

/// The outline of the area `name`, on its inner side only: half the stroke's width is visible.
pub fn inner_outline(ids: &Ids, name: &str, colour: &str, width: &str) -> Group {
    let stroke = area(ids, name)
        .set("fill", "none")
        .set("stroke", colour)
        .set("stroke-width", width)
        .set("stroke-linejoin", "round");
    within_area(ids, name).add(stroke)
}

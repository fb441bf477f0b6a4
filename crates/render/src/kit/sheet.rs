//! The sheet, and the lines on it.

use super::frame::{Spot, number};
use svg::node::element::{Path, Rectangle, SVG};

/// Width of an A4 sheet in landscape, units of 0.25 mm.
pub const WIDTH: f64 = 1188.0;
/// Its height.
pub const HEIGHT: f64 = 840.0;
/// Units in a millimetre of paper.
pub const UNITS_PER_MM: f64 = 4.0;

/// The namespace of references that Inkscape 1.2 also follows.
const XLINK: &str = "http://www.w3.org/1999/xlink";

/// The reader's own sans-serif face first. resvg takes Arial for it, and shows no text at all where Arial is absent. The other
/// fonts are on most machines, and none is wider than the widths in `text.rs`.
pub const FONTS: &str = "sans-serif, DejaVu Sans, Liberation Sans, Noto Sans";

/// An empty white sheet with a size in units, true to size in print.
pub fn blank_sheet(width: f64, height: f64) -> SVG {
    SVG::new()
        .set("xmlns:xlink", XLINK)
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("width", format!("{}mm", width / UNITS_PER_MM))
        .set("height", format!("{}mm", height / UNITS_PER_MM))
        .set("font-family", FONTS)
        .add(
            Rectangle::new()
                .set("width", "100%")
                .set("height", "100%")
                .set("fill", "white"),
        )
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

    /// Whether the picture is a sheet of its own.
    pub fn is_sheet(&self) -> bool {
        self.prefix.is_empty()
    }

    /// The id of the element called `name`.
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

/// The filled polygon of `points`.
pub fn polygon(points: &[Spot], fill: &str) -> Path {
    Path::new()
        .set("d", path_data(points, true))
        .set("fill", fill)
}

//! The sheet: A4 landscape in quarter millimetres, its palette, and how numbers and text get onto it.
//!
//! Colours are told apart by lightness first, so that they survive black-and-white
//! print: metal light, gap middling, overlap dark and hatched. Of the hues only
//! green and red are easily mistaken, and those two differ in lightness and hatching.

use gearlash_files::characters::plain;
use gearlash_files::numbers::ascii;
use svg::node::Blob;
use svg::node::element::{Element, Path, Rectangle, SVG};
use svg::node::{Node, Text};

/// Sheet width, units of 0.25 mm.
pub const WIDTH: f64 = 1188.0;
/// Sheet height.
pub const HEIGHT: f64 = 840.0;
/// Units in a millimetre of paper.
pub const UNITS_PER_MM: f64 = 4.0;

/// Lines and text.
pub const INK: &str = "#1b1f24";
/// Second-rank text and thin lines.
pub const GREY: &str = "#565d66";
/// Wheel metal.
pub const WHEEL: &str = "#dde2e8";
/// Pinion metal.
pub const PINION: &str = "#f3ead9";
/// Gap between facing flanks.
pub const GAP: &str = "#6cc5a8";
/// Overlap, under its hatching.
pub const OVERLAP: &str = "#e0402c";
/// Line of action and path of contact.
pub const ACTION: &str = "#0072b2";
/// Band of the path of contact.
pub const PATH: &str = "#9ccbe8";

/// An empty white sheet, true to size in print.
pub fn blank_sheet() -> SVG {
    SVG::new()
        .set("viewBox", format!("0 0 {WIDTH} {HEIGHT}"))
        .set("width", format!("{}mm", WIDTH / UNITS_PER_MM))
        .set("height", format!("{}mm", HEIGHT / UNITS_PER_MM))
        .set("font-family", "sans-serif")
        .add(
            Rectangle::new()
                .set("width", "100%")
                .set("height", "100%")
                .set("fill", "white"),
        )
}

/// A point of the sheet: right, down.
pub type Spot = [f64; 2];

/// A rectangle of the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Frame {
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// Larger by `margin` on every side.
    pub fn grown(&self, margin: f64) -> Frame {
        Frame {
            left: self.left - margin,
            top: self.top - margin,
            right: self.right + margin,
            bottom: self.bottom + margin,
        }
    }

    /// Whether `other` lies wholly inside.
    pub fn holds(&self, other: &Frame) -> bool {
        other.left >= self.left
            && other.right <= self.right
            && other.top >= self.top
            && other.bottom <= self.bottom
    }

    /// Whether the two share more than an edge.
    pub fn overlaps(&self, other: &Frame) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    pub fn middle(&self) -> Spot {
        [
            0.5 * (self.left + self.right),
            0.5 * (self.top + self.bottom),
        ]
    }

    /// Its outline.
    pub fn border(&self) -> Rectangle {
        self.rectangle()
            .set("fill", "none")
            .set("stroke", INK)
            .set("stroke-width", "1.40")
    }

    pub fn rectangle(&self) -> Rectangle {
        Rectangle::new()
            .set("x", number(self.left))
            .set("y", number(self.top))
            .set("width", number(self.width()))
            .set("height", number(self.height()))
    }
}

/// Two decimals, a quarter of a hundredth of a millimetre of paper; never `-0.00`.
pub fn number(value: f64) -> String {
    ascii(value, 2)
}

/// Path data through `points`; repeated points are left out.
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

/// Symbols of lengths as they stand in text, and as they are set: italic with a subscript.
const SYMBOLS: [(&str, &str); 2] = [("j_wt", "wt"), ("j_bn", "bn")];

/// A `<text>` that starts at `at`, on its baseline.
///
/// `j_wt` and `j_bn` are set as symbols unless `verbatim`. Characters that XML cannot hold become spaces.
pub fn text(content: &str, at: Spot, size: f64, verbatim: bool) -> Element {
    let mut element = Element::new("text");
    element.assign("x", number(at[0]));
    element.assign("y", number(at[1]));
    element.assign("font-size", number(size));
    let plain = plain(content);
    let used = SYMBOLS.iter().find(|(name, _)| plain.contains(name));
    match used.filter(|_| !verbatim) {
        None => element.append(Text::new(plain)),
        Some((name, subscript)) => {
            let (before, after) = plain.split_once(name).unwrap_or_default();
            // A space at the start of a tspan is lost in some programs; a shift is kept.
            let shift = number(size * 0.3);
            let after = after.trim_start();
            let drop = number(size * 0.22);
            element.append(Blob::new(format!(
                "{}<tspan font-style=\"italic\">j</tspan><tspan dy=\"{drop}\" font-size=\"{}\">{subscript}</tspan><tspan dx=\"{shift}\" dy=\"-{drop}\">{}</tspan>",
                Text::new(before),
                number(size * 0.72),
                Text::new(after),
            )));
        }
    }
    element
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A title with U+FFFF made a snapshot that no parser reads.
    #[test]
    fn a_text_of_a_picture_is_xml() {
        let drawn = text("a\u{ffff}b j_wt \u{1}<c>", [0.0; 2], 12.0, false);
        let drawn = drawn.to_string();
        let read = roxmltree::Document::parse(&drawn).unwrap();
        let words: String = read.descendants().filter_map(|node| node.text()).collect();
        assert!(words.contains("a b"), "{words}");
    }
}

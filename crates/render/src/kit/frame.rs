//! Points and rectangles of a sheet, y downwards.

use super::paint::INK;
use gearlash_text::numbers::ascii;
use svg::node::element::Rectangle;

/// A point of the sheet: right, down.
pub type Spot = [f64; 2];

/// Two decimals, a quarter of a hundredth of a millimetre of paper; never `-0.00`.
pub fn number(value: f64) -> String {
    ascii(value, 2)
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Frame {
    /// The rectangle between its upper left and its lower right corner.
    pub const fn new([left, top]: Spot, [right, bottom]: Spot) -> Frame {
        Frame {
            left,
            top,
            right,
            bottom,
        }
    }

    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub fn grown(&self, margin: f64) -> Frame {
        Frame::new(
            [self.left - margin, self.top - margin],
            [self.right + margin, self.bottom + margin],
        )
    }

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

    /// The corners, in order round the frame.
    pub fn corners(&self) -> [Spot; 4] {
        [
            [self.left, self.top],
            [self.right, self.top],
            [self.right, self.bottom],
            [self.left, self.bottom],
        ]
    }

    pub fn border(&self) -> Rectangle {
        self.painted("none", INK, "1.40")
    }

    /// It, filled, and its outline.
    pub fn painted(&self, fill: &str, stroke: &str, width: &str) -> Rectangle {
        self.rectangle()
            .set("fill", fill)
            .set("stroke", stroke)
            .set("stroke-width", width)
    }

    pub fn rectangle(&self) -> Rectangle {
        Rectangle::new()
            .set("x", number(self.left))
            .set("y", number(self.top))
            .set("width", number(self.width()))
            .set("height", number(self.height()))
    }
}

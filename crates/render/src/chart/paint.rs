//! Colours and line styles that survive colour-blindness and a black-and-white printer.

use plotters::style::RGBColor;

/// Lines and text.
pub(super) const INK: RGBColor = RGBColor(0x1b, 0x1f, 0x24);
/// Second-rank text.
pub(super) const GREY: RGBColor = RGBColor(0x56, 0x5d, 0x66);
/// Grid.
pub(super) const GRID: RGBColor = RGBColor(0xd5, 0xd9, 0xde);
/// Ground of negative backlash: lighter than any band, in grey print too, told from paper by its hatch.
pub(super) const INTERFERENCE: RGBColor = RGBColor(0xfd, 0xf3, 0xf0);
/// Its hatch.
pub(super) const HATCH: RGBColor = RGBColor(0xd9, 0x9a, 0x8c);

/// How a series looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Look {
    /// Right flanks: blue (Okabe–Ito), solid, filled circles.
    Right,
    /// Left flanks: vermillion, lighter in grey; dashed, open squares.
    Left,
    /// Neither: black, solid.
    Plain,
    /// A third series: bluish green, dotted with long gaps, crosses.
    Third,
    /// A limit or tolerance: grey, short dashes.
    Limit,
}

/// Dash and gap, units of the `viewBox`.
pub(super) type Dash = Option<[f64; 2]>;

impl Look {
    pub(super) fn colour(self) -> RGBColor {
        match self {
            Look::Right => RGBColor(0x00, 0x72, 0xb2),
            Look::Left => RGBColor(0xd5, 0x5e, 0x00),
            Look::Plain => INK,
            Look::Third => RGBColor(0x00, 0x9e, 0x73),
            Look::Limit => GREY,
        }
    }

    pub(super) fn dash(self) -> Dash {
        match self {
            Look::Right | Look::Plain => None,
            Look::Left => Some([7.0, 4.0]),
            Look::Third => Some([2.0, 3.0]),
            Look::Limit => Some([3.0, 3.0]),
        }
    }

    pub(super) fn shape(self) -> Shape {
        match self {
            Look::Right => Shape::Disc,
            Look::Left => Shape::Square,
            Look::Plain | Look::Third | Look::Limit => Shape::Cross,
        }
    }
}

/// A mark of one value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// Filled circle.
    Disc,
    /// Open square.
    Square,
    /// Diagonal cross.
    Cross,
}

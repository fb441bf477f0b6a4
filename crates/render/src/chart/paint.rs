//! Colours and line styles that survive colour-blindness and a black-and-white printer.

use crate::kit::{GREY, INK, Spot, cross, disc, square};
use svg::node::element::{Element, Path};

/// Fill of the area of negative backlash: lighter than any band, in grey print too; the hatch distinguishes it from paper.
pub(super) const INTERFERENCE: &str = "#fdf3f0";
/// Its hatch.
pub(super) const GROUND_HATCH: &str = "#d99a8c";
/// Opacity of a bar that is pale beside its neighbour.
const PALE: f64 = 0.25;

/// Style of a series.
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

impl Look {
    pub(super) fn colour(self) -> &'static str {
        match self {
            Look::Right => "#0072b2",
            Look::Left => "#d55e00",
            Look::Plain => INK,
            Look::Third => "#009e73",
            Look::Limit => GREY,
        }
    }

    /// A line in this look's dashes.
    pub(super) fn dashed(self, line: Path) -> Path {
        match self {
            Look::Right | Look::Plain => line,
            Look::Left => line.set("stroke-dasharray", "7 4"),
            Look::Third => line.set("stroke-dasharray", "2 3"),
            Look::Limit => line.set("stroke-dasharray", "3 3"),
        }
    }

    /// Opacity of a bar's fill.
    pub(super) fn bar(self) -> f64 {
        match self {
            Look::Left => PALE,
            _ => 1.0,
        }
    }

    /// The mark of a single value.
    pub(super) fn mark(self, at: Spot) -> Element {
        const HALF: f64 = 3.5;
        match self {
            Look::Right => disc(at, HALF, self.colour()).into(),
            Look::Left => square(at, HALF, self.colour()).into(),
            Look::Plain | Look::Third | Look::Limit => cross(at, HALF, self.colour()).into(),
        }
    }
}

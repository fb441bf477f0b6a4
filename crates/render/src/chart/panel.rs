//! Parts of a chart: panels with two axes and marks, in data coordinates; colours and line styles that survive colour-blindness and a
//! black-and-white printer.

use crate::kit::{Anchor, Axis, GREY, INK, Spot, cross, disc, square};
use svg::node::element::{Element, Path};

/// Fill of the area of negative backlash: lighter than any band, in grey print too; the hatch distinguishes it from paper.
pub(super) const INTERFERENCE: &str = "#fdf3f0";
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

    pub(super) fn bar(self) -> f64 {
        match self {
            Look::Left => PALE,
            _ => 1.0,
        }
    }

    pub(super) fn mark(self, at: Spot) -> Element {
        const HALF: f64 = 3.5;
        match self {
            Look::Right => disc(at, HALF, self.colour()).into(),
            Look::Left => square(at, HALF, self.colour()).into(),
            Look::Plain | Look::Third | Look::Limit => cross(at, HALF, self.colour()).into(),
        }
    }
}

/// A value at a place; `None` makes a gap in a line.
pub(super) type Point = (f64, Option<f64>);

/// A mark in a panel, drawn in this order.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Mark {
    /// A hatched area over the whole width, up to a value of y.
    Ground(f64),
    /// A shade over the whole height between two places, with its opacity.
    Shade([f64; 2], Look, f64),
    /// The area between two lines, with its opacity.
    Band([Vec<Point>; 2], Look, f64),
    /// A line, with its width.
    Line(Vec<Point>, Look, f64),
    /// Single values.
    Dots(Vec<Point>, Look),
    /// A bar between two places and two values.
    Bar([f64; 2], [f64; 2], Look),
    /// A text, moved right and down by `shift` units.
    Text {
        at: [f64; 2],
        shift: [f64; 2],
        text: String,
        anchor: Anchor,
    },
}

impl Mark {
    pub fn level(x: [f64; 2], y: f64, look: Look, width: f64) -> Mark {
        Mark::Line(x.map(|x| (x, Some(y))).to_vec(), look, width)
    }

    pub fn upright(x: f64, y: [f64; 2], look: Look, width: f64) -> Mark {
        Mark::Line(y.map(|y| (x, Some(y))).to_vec(), look, width)
    }

    pub fn text(at: [f64; 2], shift: [f64; 2], text: impl Into<String>, anchor: Anchor) -> Mark {
        let text = text.into();
        Mark::Text {
            at,
            shift,
            text,
            anchor,
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Panel {
    /// The title above the plot; may be empty.
    pub title: String,
    pub x: Axis,
    pub y: Axis,
    /// Height with its axis, units.
    pub height: f64,
    pub marks: Vec<Mark>,
}

impl Panel {
    pub fn new(x: Axis, y: Axis, height: f64, marks: Vec<Mark>) -> Panel {
        Panel {
            title: String::new(),
            x,
            y,
            height,
            marks,
        }
    }

    pub fn titled(self, title: impl Into<String>) -> Panel {
        let title = title.into();
        Panel { title, ..self }
    }
}

/// The sample beside a name in the legend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Swatch {
    Line,
    Band(f64),
    LineInBand(f64),
    Dot,
    Bar,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Entry {
    pub name: String,
    pub look: Look,
    pub sample: Swatch,
}

/// An axis range for backlash, with room for a label at both ends, at least `um` wide: a micrometre, so that rounding does not
/// fill it. Where no value is negative it starts at zero; else there is room for a word below the zero line.
pub(super) fn backlash_range(values: impl Iterator<Item = f64>, um: f64) -> Option<[f64; 2]> {
    let mut least = f64::INFINITY;
    let values = values.inspect(|value| least = least.min(*value));
    let [low, high] = range(values, [0.16; 2], um)?;
    Some(if least >= 0.0 {
        [low.max(0.0), high]
    } else {
        [low.min(-0.1 * high), high]
    })
}

/// An axis range round all `values`, with `margin` (a share of the range) on both sides, at least `least` wide.
pub(super) fn range(
    values: impl Iterator<Item = f64>,
    margin: [f64; 2],
    least: f64,
) -> Option<[f64; 2]> {
    let ends = values.fold(None, |ends: Option<[f64; 2]>, value| match ends {
        None => Some([value, value]),
        Some([low, high]) => Some([low.min(value), high.max(value)]),
    });
    let [low, high] = ends?;
    let width = high - low;
    let missing = 0.5 * (least - width).max(0.0);
    let width = width.max(least);
    Some([
        low - missing - margin[0] * width,
        high + missing + margin[1] * width,
    ])
}

//! Several series as lines or single values.

use super::captions::entry;
use super::paint::Look;
use super::panel::{Entry, Mark, Panel, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;

/// One series of a line chart.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSeries<'a> {
    /// The name in the legend.
    pub name: &'a str,
    /// Places in ascending order with their values; `None` is a gap.
    pub points: Vec<(f64, Option<f64>)>,
    /// The style.
    pub look: Look,
    /// Draws single marks instead of a line.
    pub dots: bool,
}

/// The axes of a line chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineAxes<'a> {
    /// The title above the plot; may be empty.
    pub title: &'a str,
    /// Quantity and unit.
    pub x: &'a str,
    /// The number of teeth where x is a tooth number.
    pub teeth: Option<u32>,
    /// Quantity and unit.
    pub y: &'a str,
    /// The least height shown, in that unit; a smaller one would show rounding noise.
    pub least: f64,
}

/// A chart of `series`.
///
/// # Errors
/// [`PictureError`] when no series has a value.
pub fn lines(
    heading: &Heading,
    axes: LineAxes,
    series: &[LineSeries],
) -> Result<Chart, PictureError> {
    let points = || series.iter().flat_map(|line| &line.points);
    // Less than a tooth beyond the teeth: the number before 1 is the last.
    let (margin, beyond) = match axes.teeth {
        Some(_) => (0.0, 0.6),
        None => (0.02, 0.0),
    };
    let x = range(points().map(|point| point.0), [margin; 2], 1e-9);
    let x = x.map(|[from, to]| [from - beyond, to + beyond]);
    let values = || points().filter_map(|point| point.1);
    let y = range(values(), [0.08; 2], axes.least);
    let (Some(x), Some(y)) = (x, y) else {
        return Err(PictureError("there are no values to draw".to_owned()));
    };
    let marks = series.iter().map(|line| {
        let points = line.points.clone();
        if line.dots {
            Mark::dots(points, line.look)
        } else {
            Mark::line(points, line.look, 1.6)
        }
    });
    let legend: Vec<Entry> = series
        .iter()
        .map(|line| {
            let sample = if line.dots { Swatch::Dot } else { Swatch::Line };
            entry(line.name, line.look, sample)
        })
        .collect();
    let panel = Panel {
        title: axes.title.to_owned(),
        x: Axis {
            teeth: axes.teeth,
            ..Axis::new(axes.x, x)
        },
        y: Axis::new(axes.y, y),
        height: 340.0,
        marks: marks.collect(),
    };
    // A single line is named by the axis.
    let legend = if series.len() > 1 { &legend[..] } else { &[] };
    sheet::draw(heading, "", legend, &[panel])
}

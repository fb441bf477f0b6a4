//! Several series as lines or single values.

use super::paint::Look;
use super::panel::{Axis, Entry, Mark, Panel, Sample, range};
use super::{Chart, Heading, sheet};
use crate::error::Error;

/// One series of a line chart.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSeries<'a> {
    /// As the legend names it.
    pub name: &'a str,
    /// Places in ascending order with their values; a gap where there is none.
    pub points: Vec<(f64, Option<f64>)>,
    /// How it is drawn.
    pub look: Look,
    /// Single marks instead of a line.
    pub dots: bool,
}

/// A chart of `series`; `x_axis` and `y_axis` name quantity and unit.
///
/// # Errors
/// [`Error::Chart`] when no series has a value.
pub fn lines(
    heading: &Heading,
    x_axis: &str,
    y_axis: &str,
    series: &[LineSeries],
) -> Result<Chart, Error> {
    let points = || series.iter().flat_map(|line| &line.points);
    let x = range(points().map(|point| point.0), [0.02; 2], 1e-9);
    let values = || points().filter_map(|point| point.1);
    let largest = values().map(f64::abs).fold(0.0, f64::max);
    // Not a line across rounding noise: at least a thousandth of the values.
    let y = range(values(), [0.08; 2], f64::max(1e-3 * largest, 1e-12));
    let (Some(x), Some(y)) = (x, y) else {
        return Err(Error::Chart("there are no values to draw".to_owned()));
    };
    let marks = series.iter().map(|line| {
        let points = line.points.clone();
        match line.dots {
            true => Mark::Dots {
                points,
                look: line.look,
            },
            false => Mark::Line {
                points,
                look: line.look,
                width: 1.6,
            },
        }
    });
    let legend: Vec<Entry> = series
        .iter()
        .map(|line| Entry {
            name: line.name.to_owned(),
            look: line.look,
            sample: if line.dots { Sample::Dot } else { Sample::Line },
        })
        .collect();
    let panel = Panel {
        title: String::new(),
        x: Axis::new(x_axis, x),
        y: Axis::new(y_axis, y),
        height: 340.0,
        marks: marks.collect(),
    };
    sheet::draw(heading, &legend, &[panel])
}

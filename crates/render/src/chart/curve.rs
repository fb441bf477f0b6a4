//! A curve over the teeth.

use super::panel::{Look, Mark, Panel, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;

/// The axes of a curve over the teeth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurveAxes<'a> {
    /// The title above the plot; may be empty.
    pub title: &'a str,
    /// Quantity and unit.
    pub x: &'a str,
    /// The number of teeth.
    pub teeth: u32,
    /// Quantity and unit.
    pub y: &'a str,
    /// The least height shown, in that unit; a smaller one would show rounding noise.
    pub least: f64,
}

/// A curve through `points`: tooth numbers in ascending order with their values; `None` is a gap.
///
/// # Errors
/// [`PictureError`] when no point has a value.
pub fn curve(
    heading: &Heading,
    axes: CurveAxes,
    points: Vec<(f64, Option<f64>)>,
) -> Result<Chart, PictureError> {
    // Less than a tooth beyond the teeth: the number before 1 is the last.
    let x = range(points.iter().map(|point| point.0), [0.0; 2], 1e-9);
    let x = x.map(|[from, to]| [from - 0.6, to + 0.6]);
    let y = range(
        points.iter().filter_map(|point| point.1),
        [0.08; 2],
        axes.least,
    );
    let (Some(x), Some(y)) = (x, y) else {
        return Err(PictureError("there are no values to draw".to_owned()));
    };
    let x = Axis::of_teeth(axes.x, x, Some(axes.teeth));
    let marks = vec![Mark::line(points, Look::Plain, 1.6)];
    let panel = Panel::new(x, Axis::new(axes.y, y), 340.0, marks);
    sheet::draw(heading, "", &[], &[panel.titled(axes.title)])
}

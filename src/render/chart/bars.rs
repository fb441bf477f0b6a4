//! Bars, one place a tooth.

use super::paint::Look;
use super::panel::{Anchor, Axis, Entry, Mark, Panel, Sample, range};
use super::{Chart, Heading, sheet};
use crate::error::Error;

/// Teeth beyond which lines stand for bars: narrower than a unit, two flanks' bars cannot be told apart.
const MOST_BARS: usize = 350;

/// One series of a bar chart.
#[derive(Debug, Clone, PartialEq)]
pub struct BarSeries<'a> {
    /// As the legend names it.
    pub name: &'a str,
    /// One value a tooth, from tooth 1 on.
    pub values: Vec<Option<f64>>,
    /// How it is drawn.
    pub look: Look,
}

/// A bar chart of `series` over tooth numbers, side by side; the axes name what the numbers count, and
/// quantity and unit.
///
/// # Errors
/// [`Error::Chart`] when no series has a value.
pub fn bars(
    heading: &Heading,
    [x_axis, y_axis]: [&str; 2],
    series: &[BarSeries],
) -> Result<Chart, Error> {
    let panel = panel(["", x_axis, y_axis], 340.0, series)
        .ok_or_else(|| Error::Chart("there are no values to draw".to_owned()))?;
    sheet::draw(heading, "", &legend(series), &[panel])
}

/// The legend of bars.
pub(super) fn legend(series: &[BarSeries]) -> Vec<Entry> {
    let entry = |bars: &BarSeries| Entry {
        name: bars.name.to_owned(),
        look: bars.look,
        sample: Sample::Bar,
    };
    series.iter().map(entry).collect()
}

/// Bars from zero under a title, with the names of both axes; `None` without any value.
pub(super) fn panel(
    [title, x_axis, y_axis]: [&str; 3],
    height: f64,
    series: &[BarSeries],
) -> Option<Panel> {
    let values = || series.iter().flat_map(|bars| &bars.values).flatten();
    values().next()?;
    // A tenth of a unit at least: zeros stay on a line.
    let y = range(values().copied().chain([0.0]), [0.08; 2], 0.1)?;
    let teeth = series.iter().map(|bars| bars.values.len()).max()?;
    let ends = [0.4, teeth as f64 + 0.6];
    let width = 0.8 / series.len() as f64;
    let mut marks = vec![Mark::Line {
        points: vec![(ends[0], Some(0.0)), (ends[1], Some(0.0))],
        look: Look::Plain,
        width: 1.0,
    }];
    for (place, bars) in series.iter().enumerate() {
        let left = 0.6 + place as f64 * width;
        match teeth > MOST_BARS {
            true => marks.push(curve(bars)),
            false => marks.extend(rods(bars, [left, left + width])),
        }
    }
    if values().all(|value| *value == 0.0) {
        marks.push(Mark::Text {
            at: [0.5 * (ends[0] + ends[1]), 0.0],
            shift: [0.0, -10.0],
            text: "none".to_owned(),
            anchor: Anchor::Middle,
        });
    }
    Some(Panel {
        title: title.to_owned(),
        x: Axis {
            teeth: u32::try_from(teeth).ok(),
            ..Axis::new(x_axis, ends)
        },
        y: Axis::new(y_axis, y),
        height,
        marks,
    })
}

/// Bars from `x[0]` to `x[1]` for tooth 1, a tooth further for each next.
fn rods(bars: &BarSeries, x: [f64; 2]) -> impl Iterator<Item = Mark> {
    let known = bars.values.iter().enumerate();
    known.filter_map(move |(index, value)| {
        let value = (*value)?;
        Some(Mark::Bar {
            x: x.map(|x| x + index as f64),
            y: [value.min(0.0), value.max(0.0)],
            look: bars.look,
        })
    })
}

fn curve(bars: &BarSeries) -> Mark {
    let teeth = (1..).map(f64::from);
    Mark::Line {
        points: teeth.zip(bars.values.iter().copied()).collect(),
        look: bars.look,
        width: 1.0,
    }
}

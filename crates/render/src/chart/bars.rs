//! Bar charts with one place per tooth.

use super::captions::entry;
use super::panel::{Look, Mark, Panel, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::{Anchor, Axis};

/// Number of teeth above which lines replace bars. Narrower than a unit, the bars of two flanks cannot be distinguished.
const MOST_BARS: usize = 350;

/// One series of a bar chart.
#[derive(Debug, Clone, PartialEq)]
pub struct BarSeries<'a> {
    /// The name in the legend.
    pub name: &'a str,
    /// One value per tooth, from tooth 1 on.
    pub values: Vec<Option<f64>>,
    /// The style.
    pub look: Look,
}

impl<'a> BarSeries<'a> {
    /// Values given in mm, drawn in µm.
    pub fn of_mm(name: &'a str, values: &[f64], look: Look) -> BarSeries<'a> {
        BarSeries {
            name,
            values: values.iter().map(|mm| Some(mm * 1e3)).collect(),
            look,
        }
    }
}

/// Two lines that limit the values, in the unit of the y axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    /// Lower and upper.
    pub values: [f64; 2],
    /// The name at the upper one.
    pub name: String,
}

/// One panel of bars.
#[derive(Debug, Clone, PartialEq)]
pub struct BarPanel<'a> {
    /// The title above the plot; may be empty.
    pub title: &'a str,
    /// Quantity, place of its zero, and unit.
    pub y_axis: &'a str,
    /// Drawn side by side.
    pub series: &'a [BarSeries<'a>],
    /// Limit lines; the axis makes room for them.
    pub limits: Vec<Limits>,
    /// If no value reaches this amount, the panel states it.
    pub level: f64,
}

/// Bar charts over the same teeth, one below the other. `x_axis` is the name below the last, `details` a line below the heading.
/// The legend names the series of the first panel where there are several.
///
/// # Errors
/// [`PictureError`] when a panel has no value.
pub fn bar_panels(
    heading: &Heading,
    details: &str,
    x_axis: &str,
    panels: &[BarPanel],
) -> Result<Chart, PictureError> {
    let height = match panels.len() {
        1 => 340.0,
        2 => 260.0,
        _ => 180.0,
    };
    let mut drawn = Vec::new();
    for (index, bars) in panels.iter().enumerate() {
        let x_axis = if index + 1 == panels.len() {
            x_axis
        } else {
            ""
        };
        let titles = [bars.title, x_axis, bars.y_axis];
        let mut panel = panel(titles, height, bars.series)
            .ok_or_else(|| PictureError("there are no values to draw".to_owned()))?;
        bars.limit(&mut panel);
        bars.add_level_note(&mut panel);
        drawn.push(panel);
    }
    let names = match panels.first() {
        Some(first) if first.series.len() > 1 => {
            let name = |bars: &BarSeries| entry(bars.name, bars.look, Swatch::Bar);
            first.series.iter().map(name).collect()
        }
        _ => Vec::new(),
    };
    sheet::draw(heading, details, &names, &drawn)
}

impl BarPanel<'_> {
    fn limit(&self, panel: &mut Panel) {
        for limits in &self.limits {
            let [low, high] = panel.y.range;
            let shown = range([low, high].into_iter().chain(limits.values), [0.05; 2], 0.1);
            panel.y.range = shown.unwrap_or([low, high]);
            let ends = panel.x.range;
            for value in limits.values {
                panel.marks.push(Mark::level(ends, value, Look::Limit, 1.2));
            }
            // Clear of the line, including subscripts.
            let (at, shift) = ([ends[1], limits.values[1]], [-4.0, -8.0]);
            let name = Mark::text(at, shift, &limits.name, Anchor::End);
            panel.marks.push(name);
        }
    }

    /// Adds a note where no value exceeds the level.
    fn add_level_note(&self, panel: &mut Panel) {
        let mut values = self.series.iter().flat_map(|bars| &bars.values).flatten();
        // The panel itself notes zeros.
        let zeros = values.clone().all(|value| *value == 0.0);
        if !zeros && values.all(|value| value.abs() < self.level) {
            let words = format!("no deviation within {} µm", self.level);
            panel.marks.push(above_zero(panel.x.range, &words));
        }
    }
}

/// Bars from zero under a title, with the names of both axes; `None` without any value.
fn panel([title, x_axis, y_axis]: [&str; 3], height: f64, series: &[BarSeries]) -> Option<Panel> {
    let values = || series.iter().flat_map(|bars| &bars.values).flatten();
    values().next()?;
    // At least a tenth of a unit, so that zeros stay on a line.
    let y = range(values().copied().chain([0.0]), [0.08; 2], 0.1)?;
    let teeth = series.iter().map(|bars| bars.values.len()).max()?;
    let ends = [0.4, teeth as f64 + 0.6];
    let width = 0.8 / series.len() as f64;
    let mut marks = vec![Mark::level(ends, 0.0, Look::Plain, 1.0)];
    for (place, bars) in series.iter().enumerate() {
        let left = 0.6 + place as f64 * width;
        if teeth > MOST_BARS {
            let points = (1..).map(f64::from).zip(bars.values.iter().copied());
            marks.push(Mark::line(points.collect(), bars.look, 1.0))
        } else {
            marks.extend(rods(bars, [left, left + width]))
        }
    }
    if values().all(|value| *value == 0.0) {
        marks.push(above_zero(ends, "none"));
    }
    let x = Axis::of_teeth(x_axis, ends, u32::try_from(teeth).ok());
    Some(Panel::new(x, Axis::new(y_axis, y), height, marks).titled(title))
}

/// Words above the middle of the zero line.
fn above_zero([from, to]: [f64; 2], words: &str) -> Mark {
    Mark::text(
        [0.5 * (from + to), 0.0],
        [0.0, -10.0],
        words,
        Anchor::Middle,
    )
}

/// Bars from `x[0]` to `x[1]` for tooth 1, shifted by one for each following tooth.
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

//! Values of each tooth as bars, and a curve over the teeth.

use super::captions::entry;
use super::panel::{Entry, Look, Mark, Panel, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::{Anchor, Axis};
use gearlash::gear::Flank;

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

    /// Values of right and of left flanks, given in mm, drawn in µm.
    pub fn of_flanks(values: impl Fn(Flank) -> Vec<f64>) -> [BarSeries<'a>; 2] {
        [
            BarSeries::of_mm("right flanks", &values(Flank::Right), Look::Right),
            BarSeries::of_mm("left flanks", &values(Flank::Left), Look::Left),
        ]
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
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BarPanel<'a> {
    /// The title above the plot; may be empty.
    pub title: &'a str,
    /// Quantity, place of its zero, and unit.
    pub y_axis: &'a str,
    /// Drawn side by side.
    pub series: &'a [BarSeries<'a>],
    /// Limit lines; the axis makes room for them.
    pub limits: Option<Limits>,
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
    let Some(first) = panels.first() else {
        return Err(PictureError("there is nothing to draw".to_owned()));
    };
    let name = |bars: &BarSeries| entry(bars.name, bars.look, Swatch::Bar);
    let names: Vec<Entry> = match first.series {
        [_] => Vec::new(),
        several => several.iter().map(name).collect(),
    };
    Ok(sheet::draw(heading, details, &names, &drawn))
}

impl BarPanel<'_> {
    fn limit(&self, panel: &mut Panel) {
        if let Some(limits) = &self.limits {
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
            marks.push(Mark::Line(points.collect(), bars.look, 1.0))
        } else {
            let values = (0u32..).map(f64::from).zip(&bars.values);
            marks.extend(values.filter_map(|(shift, value)| {
                let value = (*value)?;
                let x = [left + shift, left + width + shift];
                Some(Mark::Bar(x, [value.min(0.0), value.max(0.0)], bars.look))
            }))
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
    let middle = [0.5 * (from + to), 0.0];
    Mark::text(middle, [0.0, -10.0], words, Anchor::Middle)
}

/// A curve under a title over `teeth`, with the names of both axes. `points` are tooth numbers in ascending order with their
/// values; `None` is a gap. The axis of values is at least `least` high; less would show rounding noise.
///
/// # Errors
/// [`PictureError`] when no point has a value.
pub fn curve(
    heading: &Heading,
    [title, x_axis, y_axis]: [&str; 3],
    teeth: u32,
    least: f64,
    points: Vec<(f64, Option<f64>)>,
) -> Result<Chart, PictureError> {
    // Less than a tooth beyond the teeth: the number before 1 is the last.
    let x = range(points.iter().map(|point| point.0), [0.0; 2], 1e-9);
    let x = x.map(|[from, to]| [from - 0.6, to + 0.6]);
    let values = points.iter().filter_map(|point| point.1);
    let y = range(values, [0.08; 2], least);
    let (Some(x), Some(y)) = (x, y) else {
        return Err(PictureError("there are no values to draw".to_owned()));
    };
    let x = Axis::of_teeth(x_axis, x, Some(teeth));
    let marks = vec![Mark::Line(points, Look::Plain, 1.6)];
    let panel = Panel::new(x, Axis::new(y_axis, y), 340.0, marks);
    Ok(sheet::draw(heading, "", &[], &[panel.titled(title)]))
}

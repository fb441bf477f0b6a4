//! Charts as SVG: curves over the teeth, over the centre distance, and bars per tooth.
//!
//! Axes, grids, ticks and marks are drawn by `plotters` with its SVG backend alone. Of the plotting crates looked
//! at (plotters, kuva, poloto, charts-rs, plotly, charming) it is the one that is widely used and kept by more
//! than one person (its repository takes in others' work in 2026), writes text as `<text>` without asking for
//! fonts, needs no browser and no script, and costs nothing here: the benches' `criterion` brings it anyway. Its
//! backend counts whole pixels, so a chart is drawn ten times as large and scaled back: places are true to a
//! tenth of a unit of the `viewBox`.
//!
//! Colours are Okabe and Ito's, right flanks solid and dark, left flanks dashed, so that they are told apart in
//! black and white too. The same input gives the same bytes. A chart has no ids but those that start with
//! its prefix, so that several can stand in one page.

mod bars;
mod canvas;
mod difference;
mod distance;
mod inspection;
mod legend;
mod lines;
mod marks;
mod materials;
mod overplotting;
mod paint;
mod panel;
mod plot;
mod revolution;
mod sheet;
mod thin;
mod ticks;
mod words;

pub use bars::{BarPanel, BarSeries, Limits, bar_panels, bars};
pub use difference::difference;
pub use distance::distance;
pub use inspection::inspection;
pub use lines::{LineAxes, LineSeries, lines};
pub use paint::Look;
pub use revolution::revolution;

/// What stands above and beside a chart. Texts may hold anything: they are escaped.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading<'a> {
    /// Start of every id in the SVG: a letter, then letters, digits, `-` and `_`; unique in a page.
    pub prefix: &'a str,
    /// First line.
    pub title: &'a str,
    /// Second line; may be empty.
    pub subtitle: &'a str,
}

/// A chart, complete.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// One `<svg>` element with a `viewBox`, without XML prolog; its `data-` attributes repeat `plot`.
    pub svg: String,
    /// Where the data are: the first panel's frame.
    pub plot: Plot,
    /// Every panel's frame from above, `plot` first.
    pub panels: Vec<Plot>,
}

/// The frame of a plot and the data at its edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plot {
    /// Left edge, units of the `viewBox`.
    pub left: f64,
    /// Right edge.
    pub right: f64,
    /// Upper edge.
    pub top: f64,
    /// Lower edge.
    pub bottom: f64,
    /// Data at the left and at the right edge.
    pub x: [f64; 2],
    /// Data at the lower and at the upper edge.
    pub y: [f64; 2],
}

//! What stands in a plot: lines, bands, bars and single values.

use super::canvas::{Drawn, FINE, closed, dot, fine};
use super::overplotting::Overplotting;
use super::paint::{Dash, HATCH, INTERFERENCE, Look};
use super::panel::Mark;
use super::{Plot, overplotting, thin};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

/// A plot with its axes.
pub(super) type Context<'a> =
    ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// A hatched ground between two values of `y` over the width `x`.
pub(super) fn draw_ground(chart: &mut Context, y: [f64; 2], x: [f64; 2]) -> Drawn<()> {
    let corners = [(x[0], y[0]), (x[1], y[1])];
    chart.draw_series([Rectangle::new(corners, INTERFERENCE.filled())])?;
    let [from, to] = corners.map(|corner| chart.backend_coord(&corner));
    let size = [f64::from(to.0 - from.0), f64::from(from.1 - to.1)];
    let [[left, bottom], [right, top]] = corners.map(|(x, y)| [x, y]);
    let place = |[across, up]: [f64; 2]| {
        let x = left + (right - left) * across / size[0];
        (x, bottom + (top - bottom) * up / size[1])
    };
    let stroke = HATCH.stroke_width(fine(0.7) as u32);
    let line: Vec<(f64, f64)> = hatch(size).map(place).collect();
    chart.draw_series([PathElement::new(line, stroke)])?;
    Ok(())
}

/// Lines at 45° across a rectangle of `width` and `height` pixels from its lower left corner, up and down by turns:
/// one line, which takes less room in the file than many.
fn hatch([width, height]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let step = FINE * 9.0;
    let count = ((width + height) / step) as u32;
    (1..=count).flat_map(move |number| {
        let foot = f64::from(number) * step - height;
        let ends = [(-foot).max(0.0), height.min(width - foot)].map(|up| [foot + up, up]);
        let [low, high] = ends;
        if number % 2 == 0 {
            [low, high]
        } else {
            [high, low]
        }
    })
}

/// Draws one mark; whether it is a line drawn by its edges.
pub(super) fn draw_mark(chart: &mut Context, mark: &Mark, plot: &Plot) -> Drawn<bool> {
    let mut solid = false;
    let column = (plot.x[1] - plot.x[0]) / (plot.right - plot.left);
    match mark {
        Mark::Ground { .. } => {}
        Mark::Band {
            low,
            high,
            look,
            opacity,
        } => {
            for [low, high] in thin::bands(low, high, column) {
                let outline: Vec<(f64, f64)> =
                    high.into_iter().chain(low.into_iter().rev()).collect();
                let colour = look.colour().mix(*opacity);
                chart.draw_series([Polygon::new(outline, colour.filled())])?;
            }
        }
        Mark::Line {
            points,
            look,
            width,
        } => {
            let scale = [
                1.0 / column,
                (plot.bottom - plot.top) / (plot.y[1] - plot.y[0]),
            ];
            for run in thin::runs(points, column) {
                if let [alone] = run[..] {
                    let spot = Circle::new(alone, fine(*width), look.colour().filled());
                    chart.draw_series([spot])?;
                    continue;
                }
                match overplotting::of(&run, scale) {
                    Overplotting::Clear => draw_line(chart, run, *look, *width, plot)?,
                    Overplotting::Dense => {
                        draw_line(chart, run, *look, overplotting::FINE * width, plot)?
                    }
                    Overplotting::Solid([low, high]) => {
                        solid = true;
                        // Two fills over each other would be a third colour: left flanks keep to their edges.
                        if *look != Look::Left {
                            let outline: Vec<(f64, f64)> =
                                high.iter().chain(low.iter().rev()).copied().collect();
                            let fill = look.colour().mix(overplotting::FILL).filled();
                            chart.draw_series([Polygon::new(outline, fill)])?;
                        }
                        for edge in [low, high] {
                            draw_line(chart, edge, *look, *width, plot)?;
                        }
                    }
                }
            }
        }
        Mark::Dots { points, look } => {
            for (x, y) in points.iter().filter_map(|&(x, y)| Some((x, y?))) {
                let at = chart.backend_coord(&(x, y));
                let area = chart.plotting_area().strip_coord_spec();
                let (left, top) = area.get_base_pixel();
                dot(&area, (at.0 - left, at.1 - top), *look)?;
            }
        }
        Mark::Bar { x, y, look } => {
            let corners = [(x[0], y[0]), (x[1], y[1])];
            let outline = look.colour().stroke_width(fine(1.0) as u32);
            if *look != Look::Left {
                chart.draw_series([Rectangle::new(corners, look.colour().filled())])?;
            } else {
                chart.draw_series([Rectangle::new(corners, look.colour().mix(0.25).filled())])?;
            }
            chart.draw_series([PathElement::new(closed(corners).to_vec(), outline)])?;
        }
        // Above everything, by the sheet.
        Mark::Text { .. } => {}
    }
    Ok(solid)
}

fn draw_line(
    chart: &mut Context,
    run: Vec<(f64, f64)>,
    look: Look,
    width: f64,
    plot: &Plot,
) -> Drawn<()> {
    let stroke = look.colour().stroke_width(fine(width) as u32);
    match dash(look.dash(), &run, plot) {
        None => chart.draw_series([PathElement::new(run, stroke)])?,
        Some([on, off]) => {
            chart.draw_series(DashedLineSeries::new(run, fine(on), fine(off), stroke))?
        }
    };
    Ok(())
}

/// The dash of a line, longer on a long line so that it stays below some four hundred pieces.
fn dash(dash: Dash, run: &[(f64, f64)], plot: &Plot) -> Dash {
    let [on, off] = dash?;
    let across = (plot.right - plot.left) / (plot.x[1] - plot.x[0]);
    let up = (plot.bottom - plot.top) / (plot.y[1] - plot.y[0]);
    let steps = run.windows(2).map(|pair| {
        f64::hypot(
            (pair[1].0 - pair[0].0) * across,
            (pair[1].1 - pair[0].1) * up,
        )
    });
    let factor = f64::max(1.0, steps.sum::<f64>() / (400.0 * (on + off)));
    Some([on * factor, off * factor])
}

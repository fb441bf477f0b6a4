//! One panel by `plotters`: axes, grid and marks.

use super::brush::{Area, Drawn, FINE, SIDES, WIDTH, closed, dot, fine, plain, style};
use super::paint::{Dash, GRID, HATCH, INK, INTERFERENCE, Look};
use super::panel::{Anchor, Axis, Mark, Panel};
use super::ticks::Ticks;
use super::{Plot, thin};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// Room of the y axis' numbers and name.
const Y_AXIS: f64 = 70.0;
/// Room of the x axis' numbers and name, and of numbers alone.
const X_AXIS: [f64; 2] = [42.0, 22.0];

type Context<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Draws `panel` over the whole of `area`; says where its plot is.
pub(super) fn draw(area: &Area, panel: &Panel) -> Drawn<Plot> {
    let (x, y) = (&panel.x, &panel.y);
    let mut chart = ChartBuilder::on(area)
        .margin_top(fine(if panel.title.is_empty() { 8.0 } else { 24.0 }))
        .margin_right(fine(WIDTH - SIDES[1]))
        .x_label_area_size(fine(if x.name.is_empty() {
            X_AXIS[1]
        } else {
            X_AXIS[0]
        }))
        .y_label_area_size(fine(Y_AXIS))
        .build_cartesian_2d(x.range[0]..x.range[1], y.range[0]..y.range[1])?;
    for mark in &panel.marks {
        if let Mark::Ground { y } = mark {
            let corners = [(x.range[0], y[0]), (x.range[1], y[1])];
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
        }
    }
    // No ticks between two teeth.
    let across = match x.teeth {
        Some(_) => usize::clamp((x.range[1] - x.range[0]) as usize, 1, 12),
        None => 12,
    };
    let labels = [across, (panel.height / 32.0) as usize];
    let numbers = |axis: &Axis, labels: usize| {
        let ticks = Ticks::new(axis.range, labels);
        let teeth = axis.teeth;
        move |value: &f64| teeth.map_or_else(|| ticks.number(*value), |teeth| tooth(teeth, *value))
    };
    let (x_numbers, y_numbers) = (numbers(x, labels[0]), numbers(y, labels[1]));
    chart
        .configure_mesh()
        .x_labels(labels[0])
        .y_labels(labels[1])
        .x_max_light_lines(0)
        .y_max_light_lines(0)
        .bold_line_style(GRID.stroke_width(fine(0.8) as u32))
        .axis_style(INK.stroke_width(fine(1.0) as u32))
        .set_all_tick_mark_size(fine(4.0))
        .label_style(style(12.0, &INK, HPos::Center, VPos::Center))
        .axis_desc_style(style(13.0, &INK, HPos::Center, VPos::Center))
        .x_label_formatter(&x_numbers)
        .y_label_formatter(&y_numbers)
        .x_desc(plain(&x.name))
        .y_desc(plain(&y.name))
        .draw()?;
    let corner = |x, y| chart.backend_coord(&(x, y));
    let (left, bottom) = corner(x.range[0], y.range[0]);
    let (right, top) = corner(x.range[1], y.range[1]);
    let unit = |pixel: i32| f64::from(pixel) / FINE;
    let plot = Plot {
        left: unit(left),
        right: unit(right),
        top: unit(top),
        bottom: unit(bottom),
        x: x.range,
        y: y.range,
    };
    let title = style(13.0, &INK, HPos::Left, VPos::Bottom);
    let base = area.get_base_pixel();
    let above = (left - base.0, top - base.1 - fine(3.0));
    area.draw(&Text::new(plain(&panel.title), above, title))?;
    for mark in &panel.marks {
        draw_mark(&mut chart, mark, &plot)?;
    }
    Ok(plot)
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

fn draw_mark(chart: &mut Context, mark: &Mark, plot: &Plot) -> Drawn<()> {
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
            let stroke = look.colour().stroke_width(fine(*width) as u32);
            for run in thin::runs(points, column) {
                if let [alone] = run[..] {
                    let spot = Circle::new(alone, fine(*width), look.colour().filled());
                    chart.draw_series([spot])?;
                    continue;
                }
                match dash(look.dash(), &run, plot) {
                    None => chart.draw_series([PathElement::new(run, stroke)])?,
                    Some([on, off]) => chart.draw_series(DashedLineSeries::new(
                        run,
                        fine(on),
                        fine(off),
                        stroke,
                    ))?,
                };
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
        Mark::Text {
            at,
            shift,
            text,
            anchor,
        } => {
            let place = chart.backend_coord(&(at[0], at[1]));
            let area = chart.plotting_area().strip_coord_spec();
            let (left, top) = area.get_base_pixel();
            let place = (
                place.0 - left + fine(shift[0]),
                place.1 - top + fine(shift[1]),
            );
            let anchor = match anchor {
                Anchor::Start => HPos::Left,
                Anchor::Middle => HPos::Center,
                Anchor::End => HPos::Right,
            };
            let look = style(12.0, &INK, anchor, VPos::Center);
            area.draw(&Text::new(plain(text), place, look))?;
        }
    }
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

/// A tooth's number at a place: those beyond the last start again.
fn tooth(teeth: u32, value: f64) -> String {
    let tooth = (value.round() as i64 - 1).rem_euclid(i64::from(teeth.max(1))) + 1;
    format!("{tooth}")
}

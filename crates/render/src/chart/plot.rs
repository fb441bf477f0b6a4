//! One panel by `plotters`: axes, grid and marks.

use super::Plot;
use super::canvas::{Area, Drawn, FINE, SIDES, WIDTH, fine, plain, style};
use super::marks::{draw_ground, draw_mark};
use super::paint::{GRID, INK};
use super::panel::{Axis, Mark, Panel};
use super::ticks::Ticks;
use crate::kit::labels;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// Room of the y axis' numbers and name.
const Y_AXIS: f64 = 70.0;
/// Room of the x axis' numbers and name, and of numbers alone.
const X_AXIS: [f64; 2] = [42.0, 22.0];

/// Draws `panel` over the whole of `area`; says where its plot is.
///
/// The second value: whether a line is drawn by its edges.
pub(super) fn draw(area: &Area, panel: &Panel) -> Drawn<(Plot, bool)> {
    let (x, y) = (&panel.x, &panel.y);
    let mut chart = ChartBuilder::on(area)
        .margin_top(fine(if panel.title.is_empty() { 8.0 } else { 24.0 }))
        .margin_right(fine(right_margin(x)))
        .x_label_area_size(fine(if x.name.is_empty() {
            X_AXIS[1]
        } else {
            X_AXIS[0]
        }))
        .y_label_area_size(fine(Y_AXIS))
        .build_cartesian_2d(x.range[0]..x.range[1], y.range[0]..y.range[1])?;
    for mark in &panel.marks {
        if let Mark::Ground { y } = mark {
            draw_ground(&mut chart, *y, x.range)?;
        }
    }
    let up = match y.bare {
        true => 0,
        false => (panel.height / 32.0) as usize,
    };
    let labels = [most_ticks(x), up];
    let numbers = |axis: &Axis, labels: usize| {
        let ticks = Ticks::new(axis.range, labels);
        let teeth = axis.teeth;
        move |value: &f64| teeth.map_or_else(|| ticks.number(*value), |teeth| tooth(teeth, *value))
    };
    let (x_numbers, y_numbers) = (numbers(x, labels[0]), numbers(y, labels[1]));
    let mut mesh = chart.configure_mesh();
    if y.bare {
        mesh.disable_y_axis().disable_y_mesh();
    }
    mesh.x_labels(labels[0])
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
    let mut solid = false;
    for mark in &panel.marks {
        solid |= draw_mark(&mut chart, mark, &plot)?;
    }
    Ok((plot, solid))
}

/// How many numbers an x axis has at most.
fn most_ticks(x: &Axis) -> usize {
    match x.teeth {
        // None between two teeth.
        Some(_) => usize::clamp((x.range[1] - x.range[0]) as usize, 1, 12),
        None => 12,
    }
}

/// Room beside the plot: half of the last number where it stands near the edge.
fn right_margin(x: &Axis) -> f64 {
    let margin = WIDTH - SIDES[1];
    let ticks = Ticks::new(x.range, most_ticks(x));
    let (None, Some(&last)) = (x.teeth, ticks.at.last()) else {
        return margin;
    };
    let half = 0.5 * labels::width(&ticks.number(last), 12.0);
    let left_over =
        (x.range[1] - last) / (x.range[1] - x.range[0]) * (SIDES[1] - SIDES[0] - Y_AXIS);
    f64::max(margin, half + 2.0 - left_over)
}

/// A tooth's number at a place: those beyond the last start again.
fn tooth(teeth: u32, value: f64) -> String {
    let tooth = (value.round() as i64 - 1).rem_euclid(i64::from(teeth.max(1))) + 1;
    format!("{tooth}")
}

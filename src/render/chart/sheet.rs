//! Drawing panels with `plotters`, and the element round them.

use super::paint::{Dash, GREY, GRID, INK, INTERFERENCE, Look, Shape};
use super::panel::{Anchor, Axis, Entry, Mark, Panel, Sample};
use super::{Chart, Heading, Plot, thin};
use crate::error::Error;
use crate::render::labels;
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::fmt::Write;

/// Width of every chart, units of the `viewBox`: pixels on a screen, 0.22 mm across A4.
pub(super) const WIDTH: f64 = 800.0;
/// Pixels of the backend in a unit.
const FINE: f64 = 10.0;
/// Left and right edge of the header.
const SIDES: [f64; 2] = [16.0, 784.0];
/// Room of the y axis' numbers and name.
const Y_AXIS: f64 = 62.0;
/// Room of the x axis' numbers and name.
const X_AXIS: f64 = 42.0;
/// Height of a row of the legend.
const ROW: f64 = 19.0;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Context<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Draws title, legend and panels, one below the other.
pub(super) fn draw(heading: &Heading, legend: &[Entry], panels: &[Panel]) -> Result<Chart, Error> {
    let places = flow(legend);
    let rows = places.last().map_or(0, |(row, _)| row + 1);
    let top = 58.0 + ROW * rows as f64;
    let height = top + panels.iter().map(|panel| panel.height).sum::<f64>() + 8.0;
    let mut content = String::new();
    let plots = plot_all(
        &mut content,
        height,
        top,
        heading,
        (legend, &places),
        panels,
    )
    .map_err(|error| Error::Chart(error.to_string()))?;
    let Some(&plot) = plots.first() else {
        return Err(Error::Chart("there is nothing to draw".to_owned()));
    };
    Ok(Chart {
        svg: element(heading, height, &plot, inner(&content)),
        plot,
        panels: plots,
    })
}

fn plot_all(
    content: &mut String,
    height: f64,
    top: f64,
    heading: &Heading,
    (legend, places): (&[Entry], &[(usize, f64)]),
    panels: &[Panel],
) -> Result<Vec<Plot>, DrawingAreaErrorKind<std::io::Error>> {
    let size = (fine(WIDTH) as u32, fine(height) as u32);
    let root = SVGBackend::with_string(content, size).into_drawing_area();
    root.fill(&WHITE)?;
    let title = plain(&labels::shortened(heading.title, 18.0, SIDES[1] - SIDES[0]));
    let title_style = style(18.0, &INK, HPos::Left, VPos::Bottom);
    let bold = TextStyle {
        font: title_style.font.style(FontStyle::Bold),
        ..title_style
    };
    root.draw(&Text::new(title, spot(SIDES[0], 28.0), bold))?;
    let subtitle = plain(&labels::shortened(
        heading.subtitle,
        13.0,
        SIDES[1] - SIDES[0],
    ));
    let left = style(13.0, &GREY, HPos::Left, VPos::Bottom);
    root.draw(&Text::new(subtitle, spot(SIDES[0], 47.0), left))?;
    for (entry, (row, x)) in legend.iter().zip(places) {
        legend_entry(&root, entry, [*x, 64.0 + ROW * *row as f64])?;
    }
    let mut from = top;
    let mut plots = Vec::new();
    for panel in panels {
        let to = from + panel.height;
        let area = root.clone().shrink(
            spot(SIDES[0] - 6.0, from),
            (
                fine(WIDTH - SIDES[0] + 6.0) as u32,
                fine(panel.height) as u32,
            ),
        );
        plots.push(draw_panel(&area, panel)?);
        from = to;
    }
    root.present()?;
    Ok(plots)
}

fn draw_panel(area: &Area, panel: &Panel) -> Result<Plot, DrawingAreaErrorKind<std::io::Error>> {
    let (x, y) = (&panel.x, &panel.y);
    let mut chart = ChartBuilder::on(area)
        .margin_top(fine(if panel.title.is_empty() { 8.0 } else { 24.0 }))
        .margin_right(fine(WIDTH - SIDES[1]))
        .x_label_area_size(fine(if x.name.is_empty() { 22.0 } else { X_AXIS }))
        .y_label_area_size(fine(Y_AXIS))
        .build_cartesian_2d(x.range[0]..x.range[1], y.range[0]..y.range[1])?;
    for mark in &panel.marks {
        if let Mark::Ground { y } = mark {
            let corners = [(x.range[0], y[0]), (x.range[1], y[1])];
            chart.draw_series([Rectangle::new(corners, INTERFERENCE.filled())])?;
        }
    }
    let labels = [12, (panel.height / 32.0) as usize];
    let numbers = |axis: &Axis, labels: usize| {
        let axis = axis.clone();
        move |value: &f64| number(&axis, labels, *value)
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

fn draw_mark(chart: &mut Context, mark: &Mark, plot: &Plot) -> Drawn {
    let column = (plot.x[1] - plot.x[0]) / (plot.right - plot.left);
    match mark {
        Mark::Ground { .. } => {}
        Mark::Band {
            low,
            high,
            look,
            opacity,
        } => {
            let [low, high] = [low, high].map(|points| thin::runs(points, column));
            for (low, high) in low.into_iter().zip(high) {
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

fn dot(area: &Area, (x, y): (i32, i32), look: Look) -> Drawn {
    let r = fine(3.5);
    let stroke = look.colour().stroke_width(fine(1.4) as u32);
    match look.shape() {
        Shape::Disc => area.draw(&Circle::new((x, y), r, look.colour().filled())),
        Shape::Square => {
            let corners = [(x - r, y - r), (x + r, y + r)];
            area.draw(&Rectangle::new(corners, WHITE.filled()))?;
            area.draw(&PathElement::new(closed(corners).to_vec(), stroke))
        }
        Shape::Cross => {
            for tilt in [-r, r] {
                let line = vec![(x - r, y - tilt), (x + r, y + tilt)];
                area.draw(&PathElement::new(line, stroke))?;
            }
            Ok(())
        }
    }
}

/// Row and left edge of each entry.
fn flow(legend: &[Entry]) -> Vec<(usize, f64)> {
    let (mut row, mut x) = (0, SIDES[0]);
    let mut places = Vec::new();
    for entry in legend {
        let width = 40.0 + labels::width(&entry.name, 12.0);
        if x > SIDES[0] && x + width > SIDES[1] {
            (row, x) = (row + 1, SIDES[0]);
        }
        places.push((row, x));
        x += width + 14.0;
    }
    places
}

fn legend_entry(root: &Area, entry: &Entry, [x, y]: [f64; 2]) -> Drawn {
    let colour = entry.look.colour();
    let boxed = [spot(x, y - 6.0), spot(x + 30.0, y + 6.0)];
    match entry.sample {
        Sample::Band(opacity) | Sample::LineInBand(opacity) => {
            root.draw(&Rectangle::new(boxed, colour.mix(opacity).filled()))?;
        }
        Sample::Bar => {
            let opacity = if entry.look == Look::Left { 0.25 } else { 1.0 };
            root.draw(&Rectangle::new(boxed, colour.mix(opacity).filled()))?;
            let outline = colour.stroke_width(fine(1.0) as u32);
            root.draw(&PathElement::new(closed(boxed).to_vec(), outline))?;
        }
        Sample::Dot => dot(root, spot(x + 15.0, y), entry.look)?,
        Sample::Line => {}
    }
    if matches!(entry.sample, Sample::Line | Sample::LineInBand(_)) {
        let [on, off] = entry.look.dash().unwrap_or([30.0, 1.0]);
        let mut from = 0.0;
        while from < 30.0 {
            let piece = vec![spot(x + from, y), spot(x + f64::min(from + on, 30.0), y)];
            root.draw(&PathElement::new(
                piece,
                colour.stroke_width(fine(1.6) as u32),
            ))?;
            from += on + off;
        }
    }
    let words = style(12.0, &INK, HPos::Left, VPos::Center);
    root.draw(&Text::new(plain(&entry.name), spot(x + 36.0, y), words))
}

/// A tick's number: a tooth, or a value with as many decimals as the step of at most `labels` ticks needs.
fn number(axis: &Axis, labels: usize, value: f64) -> String {
    if let Some(teeth) = axis.teeth {
        let tooth = (value.round() as i64 - 1).rem_euclid(i64::from(teeth.max(1))) + 1;
        return format!("{tooth}");
    }
    // Steps are 1, 2 or 5 times a power of ten.
    let least = (axis.range[1] - axis.range[0]) / labels as f64;
    let mut decimals = 0;
    let mut decade = 1.0;
    while 0.5 * decade > least && decimals < 12 {
        decade *= 0.1;
        decimals += 1;
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| "0.".contains(c)) => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

fn style(size: f64, colour: &'static RGBColor, across: HPos, up: VPos) -> TextStyle<'static> {
    // The backend divides sizes by 1.24.
    let font = ("sans-serif", size * FINE * 1.24).into_font();
    TextStyle::from(font)
        .color(colour)
        .pos(Pos::new(across, up))
}

/// A rectangle as a line: the backend draws an unfilled one without a width.
fn closed<T: Copy>([(x0, y0), (x1, y1)]: [(T, T); 2]) -> [(T, T); 5] {
    [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
}

fn fine(units: f64) -> i32 {
    (units * FINE).round() as i32
}

fn spot(x: f64, y: f64) -> (i32, i32) {
    (fine(x), fine(y))
}

/// Control characters, which XML cannot hold, become spaces.
fn plain(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect()
}

/// What stands inside the backend's own root element.
fn inner(content: &str) -> &str {
    let from = content.find('>').map_or(0, |end| end + 1);
    let to = content.rfind("</svg>").unwrap_or(content.len());
    content.get(from..to).unwrap_or_default().trim()
}

/// The chart's element: named for screen readers, with the plot's frame for scripts.
fn element(heading: &Heading, height: f64, plot: &Plot, content: &str) -> String {
    let prefix = heading.prefix;
    let title = svg::node::Text::new(plain(heading.title));
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" id=\"{prefix}\" class=\"gearlash-chart\" role=\"img\" \
         aria-labelledby=\"{prefix}-title\" viewBox=\"0 0 {WIDTH} {height}\" font-family=\"sans-serif\""
    );
    for (name, value) in [
        ("left", plot.left),
        ("right", plot.right),
        ("top", plot.top),
        ("bottom", plot.bottom),
        ("x0", plot.x[0]),
        ("x1", plot.x[1]),
        ("y0", plot.y[0]),
        ("y1", plot.y[1]),
    ] {
        // Writing to a String cannot fail.
        let _ = write!(text, " data-{name}=\"{value}\"");
    }
    let scale = 1.0 / FINE;
    let _ = write!(
        text,
        ">\n<title id=\"{prefix}-title\">{title}</title>\n<g transform=\"scale({scale})\">\n{content}\n</g>\n</svg>\n"
    );
    text
}

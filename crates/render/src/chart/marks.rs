//! Marks in a plot: lines, bands, bars and single values.

use super::panel::{GROUND_HATCH, INTERFERENCE, Look, Mark, Point};
use super::thin::{self, Overplotting};
use crate::kit::{Frame, Plot, Spot, disc, line, number, polygon};
use svg::node::Node;
use svg::node::element::Group;

/// A hatched area over the whole width up to a value of y.
pub(super) fn ground(plot: &Plot, below: f64) -> Group {
    let frame = Frame {
        top: plot.spot((plot.x[0], below))[1].max(plot.frame.top),
        ..plot.frame
    };
    Group::new()
        .add(frame.rectangle().set("fill", INTERFERENCE))
        .add(line(&hatch(&frame), GROUND_HATCH, 0.7))
}

/// Lines at 45° across a frame, up and down in turn: a single path needs less room in the file than many.
fn hatch(frame: &Frame) -> Vec<Spot> {
    const STEP: f64 = 9.0;
    let (width, height) = (frame.width(), frame.height());
    let count = ((width + height) / STEP) as u32;
    let strokes = (1..=count).flat_map(|number| {
        let foot = f64::from(number) * STEP - height;
        let ends = [(-foot).max(0.0), height.min(width - foot)].map(|up| [foot + up, up]);
        let [low, high] = ends;
        if number % 2 == 0 {
            [low, high]
        } else {
            [high, low]
        }
    });
    strokes
        .map(|[across, up]| [frame.left + across, frame.bottom - up])
        .collect()
}

pub(super) fn draw(mark: &Mark, plot: &Plot, group: &mut Group) {
    let column = 1.0 / plot.scale()[0];
    let spots = |run: &[(f64, f64)]| run.iter().map(|point| plot.spot(*point)).collect();
    match mark {
        // Areas are below the grid, texts above everything.
        Mark::Ground(_) | Mark::Text { .. } => {}
        Mark::Shade(x, look, opacity) => {
            let [left, right] = x.map(|x| plot.spot((x, plot.y[0]))[0]);
            let frame = Frame {
                left,
                right,
                ..plot.frame
            };
            let shade = frame.rectangle().set("fill", look.colour());
            group.append(shade.set("fill-opacity", number(*opacity)));
        }
        Mark::Band([low, high], look, opacity) => {
            for [low, high] in thin::bands(low, high, column) {
                group.append(area(spots(&low), spots(&high), *look, *opacity));
            }
        }
        Mark::Line(points, look, width) => draw_line(points, *look, *width, plot, group),
        Mark::Dots(points, look) => {
            for (x, y) in points.iter().filter_map(|&(x, y)| Some((x, y?))) {
                group.append(look.mark(plot.spot((x, y))));
            }
        }
        Mark::Bar(x, y, look) => {
            group.append(bar(&plot.between(*x, *y), *look));
        }
    }
}

/// A bar, filled or pale, with its edge.
pub(super) fn bar(frame: &Frame, look: Look) -> svg::node::element::Rectangle {
    let bar = frame.painted(look.colour(), look.colour(), "1.00");
    bar.set("fill-opacity", number(look.bar()))
}

/// Whether one of a panel's lines is drawn as an envelope in `plot`.
pub(super) fn has_envelope(marks: &[Mark], plot: &Plot) -> bool {
    marks.iter().any(|mark| {
        let Mark::Line(points, ..) = mark else {
            return false;
        };
        let runs = thin::runs(points, 1.0 / plot.scale()[0]).into_iter();
        let mut seen = runs.map(|run| thin::overplotting(&run, plot.scale()));
        seen.any(|density| matches!(density, Overplotting::Solid(_)))
    })
}

fn draw_line(points: &[Point], look: Look, width: f64, plot: &Plot, group: &mut Group) {
    let spots = |run: &[(f64, f64)]| run.iter().map(|point| plot.spot(*point)).collect();
    let stroke = |run: &[(f64, f64)], width: f64| {
        let spots: Vec<Spot> = spots(run);
        look.dashed(line(&spots, look.colour(), width))
    };
    for run in thin::runs(points, 1.0 / plot.scale()[0]) {
        if let [alone] = run[..] {
            group.append(disc(plot.spot(alone), width, look.colour()));
            continue;
        }
        match thin::overplotting(&run, plot.scale()) {
            Overplotting::Clear => group.append(stroke(&run, width)),
            Overplotting::Dense => group.append(stroke(&run, thin::FINE * width)),
            Overplotting::Solid([low, high]) => {
                // Two overlapping fills would be a third colour, so left flanks have edges only.
                if look != Look::Left {
                    group.append(area(spots(&low), spots(&high), look, thin::FILL));
                }
                group.append(stroke(&low, width));
                group.append(stroke(&high, width));
            }
        }
    }
}

fn area(low: Vec<Spot>, high: Vec<Spot>, look: Look, opacity: f64) -> svg::node::element::Path {
    let outline: Vec<Spot> = high.into_iter().chain(low.into_iter().rev()).collect();
    polygon(&outline, look.colour()).set("fill-opacity", number(opacity))
}

//! Marks at a place, arrows, and hatching.

use super::frame::{Frame, Spot, number};
use super::paint::{HATCH, INK};
use super::sheet::{Ids, line, polygon};
use svg::node::Node;
use svg::node::element::{Circle, Definitions, Element, Group, Path, Pattern, Rectangle};

pub fn disc([x, y]: Spot, radius: f64, fill: &str) -> Circle {
    Circle::new()
        .set("cx", number(x))
        .set("cy", number(y))
        .set("r", number(radius))
        .set("fill", fill)
}

/// A contact point (filled), or one of two that will meet.
pub fn dot(spot: Spot, radius: f64, filled: bool) -> Circle {
    disc(spot, radius, if filled { INK } else { "white" })
        .set("stroke", INK)
        .set("stroke-width", "1.50")
}

pub fn square(spot: Spot, half: f64, colour: &str) -> Rectangle {
    around(spot, half).painted("white", colour, "1.40")
}

/// Rows of cells that fill `field` from the top, each in its colour. Neighbouring cells of one colour form one rectangle.
pub fn shaded(field: &Frame, rows: &[Vec<&str>]) -> Group {
    let mut group = Group::new().set("shape-rendering", "crispEdges");
    let height = field.height() / rows.len() as f64;
    for (row, cells) in rows.iter().enumerate() {
        let width = field.width() / cells.len() as f64;
        let top = field.top + row as f64 * height;
        let mut column = 0;
        for run in cells.chunk_by(|a, b| a == b) {
            let left = field.left + column as f64 * width;
            column += run.len();
            let right = field.left + column as f64 * width;
            let frame = Frame::new([left, top], [right, top + height]);
            group.append(frame.rectangle().set("fill", run[0]));
        }
    }
    group
}

/// A text that runs upwards from its place.
pub fn turned(mut text: Element, at: Spot) -> Element {
    let [x, y] = at.map(number);
    text.assign("transform", format!("rotate(-90 {x} {y})"));
    text
}

pub fn cross([x, y]: Spot, half: f64, colour: &str) -> Group {
    let stroke = |tilt: f64| line(&[[x - half, y - tilt], [x + half, y + tilt]], colour, 1.4);
    Group::new().add(stroke(-half)).add(stroke(half))
}

pub fn diamond([x, y]: Spot) -> Path {
    let corners = [[x, y - 6.0], [x + 6.0, y], [x, y + 6.0], [x - 6.0, y]];
    polygon(&corners, "white")
        .set("stroke", INK)
        .set("stroke-width", "1.60")
}

/// A line with a head at `to`.
pub fn arrow(from: Spot, to: Spot, width: f64) -> Group {
    let along = [0, 1].map(|i| to[i] - from[i]);
    let length = along[0].hypot(along[1]);
    let unit = along.map(|x| x / length);
    let back = 4.5 * width + 2.0;
    let half = 0.36 * back;
    let neck = [0, 1].map(|i| to[i] - back * unit[i]);
    let side = |sign: f64| {
        [
            neck[0] - sign * half * unit[1],
            neck[1] + sign * half * unit[0],
        ]
    };
    Group::new()
        .add(line(&[from, neck], INK, width))
        .add(polygon(&[to, side(1.0), side(-1.0)], INK))
}

pub fn around([x, y]: Spot, radius: f64) -> Frame {
    Frame::new([x, y], [x, y]).grown(radius)
}

/// Dark diagonal lines under the id `hatch`, so that an overlap is visible without colour.
pub fn hatch(ids: &Ids) -> Definitions {
    Definitions::new().add(
        Pattern::new()
            .set("id", ids.of("hatch"))
            .set("width", "6")
            .set("height", "6")
            .set("patternUnits", "userSpaceOnUse")
            .set("patternTransform", "rotate(45)")
            .add(line(&[[0.0, 3.0], [6.0, 3.0]], HATCH, 1.4)),
    )
}

//! Marks at a place, arrows, and hatching.

use super::frame::{Frame, Spot, number};
use super::paint::{HATCH, INK};
use super::sheet::{Ids, line, polygon};
use svg::node::element::{Circle, Definitions, Group, Path, Pattern, Rectangle};

/// A contact point, or one of two that will meet.
pub fn dot(spot: Spot, radius: f64, filled: bool) -> Circle {
    Circle::new()
        .set("cx", number(spot[0]))
        .set("cy", number(spot[1]))
        .set("r", number(radius))
        .set("fill", if filled { INK } else { "white" })
        .set("stroke", INK)
        .set("stroke-width", "1.50")
}

/// An open square.
pub fn square(spot: Spot, half: f64, colour: &str) -> Rectangle {
    around(spot, half)
        .rectangle()
        .set("fill", "white")
        .set("stroke", colour)
        .set("stroke-width", "1.40")
}

/// A diagonal cross.
pub fn cross([x, y]: Spot, half: f64, colour: &str) -> Group {
    let stroke = |tilt: f64| line(&[[x - half, y - tilt], [x + half, y + tilt]], colour, 1.4);
    Group::new().add(stroke(-half)).add(stroke(half))
}

/// An open diamond.
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

/// The box about a disc.
pub fn around([x, y]: Spot, radius: f64) -> Frame {
    Frame {
        left: x,
        top: y,
        right: x,
        bottom: y,
    }
    .grown(radius)
}

/// Dark diagonal lines under the id `hatch`, so that an overlap shows without colour.
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

//! Contact points, the points that will meet, and normals.

use super::view::View;
use crate::kit::labels::Occupied;
use crate::kit::sheet::{Frame, INK, Spot, line, number, path_data};
use gearlash::mesh::DrawnContact;
use svg::node::element::{Circle, Group, Path};

/// How large the marks of a view are, units of the sheet.
#[derive(Debug, Clone, Copy)]
pub struct MarkSize {
    /// Radius of a contact point.
    pub dot: f64,
    /// Length of a normal.
    pub normal: f64,
}

/// Marks in the main view.
pub const IN_MAIN: MarkSize = MarkSize {
    dot: 4.0,
    normal: 52.0,
};
/// Marks in an inset.
pub const IN_INSET: MarkSize = MarkSize {
    dot: 5.0,
    normal: 64.0,
};

/// Draws a meeting: filled where the gears touch, else the two points that will meet, open, with
/// the way of the free one to the other when there is room to see it.
pub fn draw(meeting: &DrawnContact, view: &View, size: MarkSize, occupied: &mut Occupied) -> Group {
    let locked = view.spot(meeting.on_locked);
    let free = view.spot(meeting.on_free);
    // y is down on the sheet.
    let normal = [meeting.normal.x, -meeting.normal.y];
    // Across a gap wide enough to see, the normal ends where an involute's other flank stands.
    let across = meeting.gap * view.scale();
    let length = if across > 24.0 { across } else { size.normal };
    let tip = [0, 1].map(|i| locked[i] + length * normal[i]);
    let mut group = Group::new().add(arrow(locked, tip, 1.8));
    occupied.line(&[locked, tip]);
    let touching = meeting.turn == 0.0;
    if !touching {
        let way = [0, 1].map(|i| locked[i] - free[i]);
        let length = way[0].hypot(way[1]);
        if length > 6.0 * size.dot {
            let ends = [size.dot, length - size.dot]
                .map(|s| [0, 1].map(|i| free[i] + way[i] * s / length));
            occupied.line(&ends);
            group = group.add(arrow(ends[0], ends[1], 1.2));
        }
    }
    for spot in if touching {
        vec![locked]
    } else {
        vec![locked, free]
    } {
        occupied.frame(around(spot, size.dot));
        group = group.add(dot(spot, size.dot, touching));
    }
    group
}

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
    Group::new().add(line(&[from, neck], INK, width)).add(
        Path::new()
            .set("d", path_data(&[to, side(1.0), side(-1.0)], true))
            .set("fill", INK),
    )
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

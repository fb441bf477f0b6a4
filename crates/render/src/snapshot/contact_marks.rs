//! Contact points, the points that will meet, and normals.

use super::view::View;
use crate::kit::{Occupied, around, arrow, dot};
use gearlash::contact::DrawnContact;
use svg::node::element::Group;

/// Size of the marks in a view, units of the sheet.
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

/// Draws a contact. Where the gears touch, it is one filled point. Elsewhere it is the two open points that will meet, with the path
/// from the free gear's to the other where it is visible.
pub fn draw(contact: &DrawnContact, view: &View, size: MarkSize, occupied: &mut Occupied) -> Group {
    let locked = view.spot(contact.on_locked);
    let free = view.spot(contact.on_free);
    // y points down on the sheet.
    let normal = [contact.normal.x, -contact.normal.y];
    // Across a visible gap, the normal ends at an involute's opposite flank.
    let across = contact.gap * view.scale;
    let length = if across > 24.0 { across } else { size.normal };
    let tip = [0, 1].map(|i| locked[i] + length * normal[i]);
    let mut group = Group::new().add(arrow(locked, tip, 1.8));
    occupied.line(&[locked, tip]);
    let touching = contact.turn == 0.0;
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
    for spot in [Some(locked), (!touching).then_some(free)]
        .into_iter()
        .flatten()
    {
        occupied.frame(around(spot, size.dot));
        group = group.add(dot(spot, size.dot, touching));
    }
    group
}

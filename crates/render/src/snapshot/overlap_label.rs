//! The label of an overlap: its depth and size.

use super::view::View;
use crate::kit::{self, Frame, HATCH, Occupied, Spot, TextStyle, clip, line};
use gearlash::contact::{DrawnContact, FreePlacement, Scene};
use gearlash_files::numbers::{significant, um};
use svg::node::element::Group;

const STYLE: TextStyle = TextStyle::new(13.0);

/// The label of the overlap at `contact`, if there is one, with a leader to it; its room is added to `occupied`.
pub fn draw(scene: &Scene, contact: &DrawnContact, view: &View, occupied: &mut Occupied) -> Group {
    let Some(overlap) = scene.overlap(contact) else {
        return Group::new();
    };
    let mut rows = Vec::new();
    if let FreePlacement::AtContact(_) = scene.free_placement() {
        rows.push(format!("depth {} µm", um(-contact.along_normal, 2)));
    }
    rows.push(format!("area {} mm²", significant(overlap.area)));
    let width = rows.iter().map(|row| STYLE.width(row));
    let width = width.fold(0.0, f64::max) + 12.0;
    let height = 18.0 * rows.len() as f64 + 6.0;
    let seen = clip::polygon(&view.spots(&overlap.outline), &view.frame.grown(-8.0));
    let target = interior_point(&seen, &view.frame).unwrap_or(view.spot(contact.on_locked));
    let Some((room, leader)) = place([width, height], target, &view.frame, occupied) else {
        return Group::new();
    };
    occupied.frame(room);
    occupied.line(&leader);
    let mut group = Group::new().add(line(&leader, HATCH, 1.2)).add(
        room.rectangle()
            .set("fill", "white")
            .set("stroke", HATCH)
            .set("stroke-width", "1.00"),
    );
    for (row, i) in rows.iter().zip(0u32..) {
        let at = [room.left + 6.0, room.top + 16.0 + 18.0 * f64::from(i)];
        group = group.add(STYLE.text(row, at));
    }
    group
}

/// A point well inside a closed polygon: the middle of the longest horizontal chord, of several across `frame`.
fn interior_point(polygon: &[Spot], frame: &Frame) -> Option<Spot> {
    let levels = (1..24).map(|i| frame.top + frame.height() * f64::from(i) / 24.0);
    let chords = levels.flat_map(|y| {
        let edges = (0..polygon.len()).map(|i| [polygon[i], polygon[(i + 1) % polygon.len()]]);
        let cut = edges.filter(|[from, to]| (from[1] > y) != (to[1] > y));
        let mut at: Vec<f64> = cut
            .map(|[from, to]| from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0]))
            .collect();
        at.sort_by(f64::total_cmp);
        let chords: Vec<_> = at
            .chunks_exact(2)
            .map(|ends| (ends[1] - ends[0], [0.5 * (ends[0] + ends[1]), y]))
            .collect();
        chords
    });
    let longest = chords.reduce(|longest, next| if next.0 > longest.0 { next } else { longest });
    longest.map(|(_, middle)| middle)
}

/// The free room nearest to `target`, and the leader from it, which crosses no other label.
fn place(
    [width, height]: [f64; 2],
    target: Spot,
    frame: &Frame,
    occupied: &Occupied,
) -> Option<(Frame, [Spot; 2])> {
    let inner = frame.grown(-8.0);
    let steps =
        |from: f64, to: f64| (0..=32).map(move |i| from + (to - from) * f64::from(i) / 32.0);
    let rooms = steps(inner.top, inner.bottom - height).flat_map(|top| {
        steps(inner.left, inner.right - width)
            .map(move |left| Frame::new([left, top], [left + width, top + height]))
    });
    let leader = |room: &Frame| {
        let from = [
            target[0].clamp(room.left, room.right),
            target[1].clamp(room.top, room.bottom),
        ];
        [from, target]
    };
    let far = |room: &Frame| {
        let [from, to] = leader(room);
        (from[0] - to[0]).hypot(from[1] - to[1])
    };
    let free = |room: &Frame, clear: f64| {
        far(room) > 12.0 && occupied.is_clear(room, clear) && !occupied.crosses_frame(&leader(room))
    };
    let rooms: Vec<Frame> = rooms.collect();
    [10.0, kit::CLEAR].into_iter().find_map(|clear| {
        let fitting = rooms.iter().filter(|room| free(room, clear));
        fitting
            .min_by(|a, b| far(a).total_cmp(&far(b)))
            .map(|room| (*room, leader(room)))
    })
}

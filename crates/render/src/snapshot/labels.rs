//! Labels in a view: the numbers of its teeth, and the depth and size of an overlap.

use super::view::View;
use crate::kit::{self, Frame, HATCH, Occupied, Spot, TextStyle, clip, line};
use gearlash::contact::{DrawnContact, FreePlacement, Scene};
use gearlash::pair::{Mating, Member};
use gearlash_text::numbers::{significant, um};
use nalgebra::Vector2;
use std::f64::consts::TAU;
use svg::node::Node;
use svg::node::element::{Element, Group};

const SIZE: f64 = 15.0;

/// Numbers the teeth in view of wheel and pinion, mating ones in bold. Their rooms are added to `occupied` and returned.
///
/// All numbers of a gear are on one circle: among some round its root, the first with room for the most numbers. Numbers without
/// room are left out, except for the mating teeth, which try further circles. Teeth smaller than a number get none.
pub fn tooth_numbers(
    scene: &Scene,
    view: &View,
    mating: &Mating,
    occupied: &mut Occupied,
) -> ([Group; 2], Vec<Frame>) {
    let mut groups = [Group::new(), Group::new()];
    let mut taken = Vec::new();
    let inside = view.frame.grown(-6.0);
    for (member, group) in Member::BOTH.into_iter().zip(&mut groups) {
        let placed = scene.placed(member);
        let [tip, root] = placed.radii();
        let foot = placed.base_radius().map_or(root, |base| root.min(base));
        let pitch = TAU / f64::from(scene.assembly().teeth(member));
        if pitch * root * view.scale < SIZE {
            continue;
        }
        let below = |radius: f64, lines: f64| radius - lines * SIZE / view.scale;
        let teeth = placed.teeth_near(view.middle, view.reach());
        let rings = [
            below(root, 1.2),
            below(root, 2.4),
            below(foot, 1.2),
            0.5 * (root + tip),
        ];
        let farther = (0..24).map(|i| below(tip, 0.8 + 0.4 * f64::from(i)));
        let free_room = |there: &(u32, f64), ring: f64, beside: f64, occupied: &Occupied| {
            let (tooth, direction) = *there;
            let outward = Vector2::new(direction.cos(), direction.sin());
            let across = Vector2::new(-outward.y, outward.x) * (beside * SIZE / view.scale);
            let at = placed.centre() + ring * outward + across;
            let room = kit::room(&tooth.to_string(), SIZE, view.spot(at));
            (inside.holds(&room) && occupied.is_clear(&room, kit::CLEAR)).then_some(room)
        };
        let fitting = |ring: f64, occupied: &Occupied| {
            let fits = |tooth: &&(u32, f64)| free_room(tooth, ring, 0.0, occupied).is_some();
            teeth.iter().filter(fits).count()
        };
        let counts = rings.map(|ring| fitting(ring, occupied));
        let most = counts.into_iter().max();
        let mut counted = rings.into_iter().zip(counts);
        let best = counted.find(|(_, count)| Some(*count) == most);
        for there in &teeth {
            let is_mating = there.0 == mating.tooth(member);
            let on_best = best.and_then(|(ring, _)| free_room(there, ring, 0.0, occupied));
            let room = on_best.or_else(|| {
                let mut places = [0.0, 0.7, -0.7]
                    .into_iter()
                    .flat_map(|beside| farther.clone().map(move |ring| (ring, beside)));
                places
                    .find_map(|(ring, beside)| free_room(there, ring, beside, occupied))
                    .filter(|_| is_mating)
            });
            if let Some(room) = room {
                occupied.frame(room);
                taken.push(room);
                group.append(centred(&there.0.to_string(), &room, SIZE, is_mating));
            }
        }
    }
    (groups, taken)
}

pub fn centred(content: &str, room: &Frame, size: f64, bold: bool) -> Element {
    let at: Spot = [0.5 * (room.left + room.right), room.bottom];
    let style = TextStyle::new(size).middle();
    let style = if bold { style.bold() } else { style };
    style.text(content, at)
}

const STYLE: TextStyle = TextStyle::new(13.0);

/// The label of the overlap at `contact`, if there is one, with a leader to it; its room is added to `occupied`.
pub fn overlap_label(
    scene: &Scene,
    contact: &DrawnContact,
    view: &View,
    occupied: &mut Occupied,
) -> Group {
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
    let mut group = Group::new()
        .add(line(&leader, HATCH, 1.2))
        .add(room.painted("white", HATCH, "1.00"));
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
        let mut at = clip::crossings(polygon, y);
        at.sort_unstable_by(f64::total_cmp);
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

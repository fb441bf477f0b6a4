//! The numbers of the teeth in view.

use super::view::View;
use crate::kit::{self, Frame, Occupied, Spot, TextStyle};
use nalgebra::{Point2, Vector2};
use svg::node::Node;
use svg::node::element::{Element, Group};

/// Size of tooth numbers.
const SIZE: f64 = 15.0;

/// A gear whose teeth are numbered, at its place in the picture; lengths in mm, angles in rad.
#[derive(Debug, Clone)]
pub struct Numbered {
    /// The centre of its teeth.
    pub centre: Point2<f64>,
    pub tip: f64,
    pub root: f64,
    /// The lesser of root and base radius; the root radius for a gear without a base circle.
    pub foot: f64,
    pub pitch: f64,
    /// Teeth that can be in view, and their directions.
    pub teeth: Vec<(u32, f64)>,
    /// The mating one, in bold.
    pub mating: u32,
}

/// Numbers the teeth in view of wheel and pinion. Their rooms are added to `occupied` and returned.
///
/// All numbers of a gear are on one circle: among some round its root, the first with room for the most numbers. Numbers without
/// room are left out, except for the mating teeth, which try further circles. Teeth smaller than a number get none.
pub fn draw(
    gears: &[Numbered; 2],
    view: &View,
    occupied: &mut Occupied,
) -> ([Group; 2], Vec<Frame>) {
    let mut groups = [Group::new(), Group::new()];
    let mut taken = Vec::new();
    let inside = view.frame.grown(-6.0);
    for (gear, group) in gears.iter().zip(&mut groups) {
        let Numbered {
            tip, root, foot, ..
        } = *gear;
        if gear.pitch * root * view.scale < SIZE {
            continue;
        }
        let below = |radius: f64, lines: f64| radius - lines * SIZE / view.scale;
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
            let at = gear.centre + ring * outward + across;
            let room = kit::room(&tooth.to_string(), SIZE, view.spot(at));
            (inside.holds(&room) && occupied.is_free(&room)).then_some(room)
        };
        let fitting = |ring: f64, occupied: &Occupied| {
            let fits = |tooth: &&(u32, f64)| free_room(tooth, ring, 0.0, occupied).is_some();
            gear.teeth.iter().filter(fits).count()
        };
        let counts = rings.map(|ring| fitting(ring, occupied));
        let most = counts.into_iter().max();
        let mut counted = rings.into_iter().zip(counts);
        let best = counted.find(|(_, count)| Some(*count) == most);
        for there in &gear.teeth {
            let is_mating = there.0 == gear.mating;
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

/// A text centred in its room.
pub fn centred(content: &str, room: &Frame, size: f64, bold: bool) -> Element {
    let at: Spot = [0.5 * (room.left + room.right), room.bottom];
    let style = TextStyle::new(size).middle();
    let style = if bold { style.bold() } else { style };
    style.text(content, at)
}

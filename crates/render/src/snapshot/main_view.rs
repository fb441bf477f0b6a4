//! The mesh zone: what it shows, and the tooth numbers in it.

use super::view::View;
use crate::kit::{self, Frame, Occupied, Spot, TextStyle, UNITS_PER_MM, scale};
use gearlash::contact::Scene;
use gearlash::gear::Side;
use gearlash::pair::Member;
use nalgebra::{Point2, Vector2};
use svg::node::Node;
use svg::node::element::Group;

/// Pitches shown above and below the line of centres: with one and a half each gear shows three
/// whole teeth, more than ever mate in ordinary pairs.
const PITCHES: f64 = 1.5;
/// Room kept round what must be seen, modules.
const BORDER: f64 = 1.0;
/// How far off a base tangent point is brought into view, modules: two pitches, a third more than is shown anyway.
const NEAR: f64 = 6.3;
/// Size of tooth numbers.
const SIZE: f64 = 15.0;

/// The view of the mesh zone in `frame`: about the middle between the tip circles, with both root
/// circles, the paths of contact and the contacts in it.
pub fn view(scene: &Scene, frame: Frame) -> View {
    let gear = |member| scene.assembly().gear(member).gear();
    let (wheel, pinion) = (gear(Member::Wheel), gear(Member::Pinion));
    let module = wheel.basic_data().module();
    let distance = scene.assembly().center_distance();
    let middle = Point2::new(
        0.5 * (wheel.tip_radius() + distance - pinion.tip_radius()),
        0.0,
    );
    let mut half = Vector2::new(0.0, PITCHES * std::f64::consts::PI * module);
    let mut include = |point: Point2<f64>| {
        half = half.sup(&((point - middle).abs().add_scalar(BORDER * module)));
    };
    include(Point2::new(wheel.root_radius(), 0.0));
    include(Point2::new(distance - pinion.root_radius(), 0.0));
    for contact in scene.meetings() {
        include(contact.on_locked);
        include(contact.on_free);
    }
    for action in Side::BOTH
        .iter()
        .filter_map(|side| scene.line_of_action(*side))
    {
        action.path.iter().flatten().copied().for_each(&mut include);
        let contacts = scene.meetings().iter();
        for contact in contacts.filter(|contact| contact.side == action.side) {
            let is_limit = [Member::Wheel, Member::Pinion].map(|m| contact.is_below_form_circle(m));
            let ends = action.ends.into_iter().zip(is_limit);
            // Tangent points of large gears lie too far off to be worth the smaller scale.
            let is_near = |end: &Point2<f64>| (end - middle).norm() <= NEAR * module;
            ends.filter(|(end, is_limit)| *is_limit && is_near(end))
                .for_each(|(end, _)| include(end));
        }
    }
    let fits = f64::min(0.5 * frame.width() / half.x, 0.5 * frame.height() / half.y);
    View::new(
        frame,
        middle,
        UNITS_PER_MM * scale::at_most(fits / UNITS_PER_MM, scale::FINE),
    )
}

/// Numbers the teeth in view, the wheel's and the pinion's, those that mate in bold; their rooms are taken in `occupied` and returned.
///
/// A gear's numbers stand on one circle: of some round its root the first on which the most find
/// room. What finds none is left out, but for the mating teeth, which look farther. Teeth no
/// larger than a number get none.
pub fn tooth_numbers(
    scene: &Scene,
    view: &View,
    mating: [u32; 2],
    occupied: &mut Occupied,
) -> ([Group; 2], Vec<Frame>) {
    let mut groups = [Group::new(), Group::new()];
    let mut taken = Vec::new();
    let inside = view.frame().grown(-6.0);
    let members = [Member::Wheel, Member::Pinion].into_iter().zip(mating);
    for ((member, mating), group) in members.zip(&mut groups) {
        let placed = scene.placed(member);
        let gear = placed.as_built().gear();
        let teeth = placed.teeth_near(view.middle(), view.reach());
        let root = gear.root_radius();
        if gear.basic_data().angular_pitch() * root * view.scale() < SIZE {
            continue;
        }
        let below = |radius: f64, lines: f64| radius - lines * SIZE / view.scale();
        let rings = [
            below(root, 1.2),
            below(root, 2.4),
            below(root.min(gear.base_radius()), 1.2),
            0.5 * (root + gear.tip_radius()),
        ];
        let farther = (0..24).map(|i| below(gear.tip_radius(), 0.8 + 0.4 * f64::from(i)));
        let free_room = |tooth: u32, ring: f64, beside: f64, occupied: &Occupied| {
            let outward = unit(placed.direction(tooth));
            let across = Vector2::new(-outward.y, outward.x) * (beside * SIZE / view.scale());
            let at = placed.centre() + ring * outward + across;
            let room = kit::room(&tooth.to_string(), SIZE, view.spot(at));
            (inside.holds(&room) && occupied.is_free(&room)).then_some(room)
        };
        let fitting = |ring: f64, occupied: &Occupied| {
            let fits = |tooth: &&u32| free_room(**tooth, ring, 0.0, occupied).is_some();
            teeth.iter().filter(fits).count()
        };
        let counts = rings.map(|ring| fitting(ring, occupied));
        let most = counts.into_iter().max();
        let best = rings
            .into_iter()
            .zip(counts)
            .find(|(_, count)| Some(*count) == most);
        for &tooth in &teeth {
            let on_best = best.and_then(|(ring, _)| free_room(tooth, ring, 0.0, occupied));
            let room = on_best.or_else(|| {
                let mut places = [0.0, 0.7, -0.7]
                    .into_iter()
                    .flat_map(|beside| farther.clone().map(move |ring| (ring, beside)));
                places
                    .find_map(|(ring, beside)| free_room(tooth, ring, beside, occupied))
                    .filter(|_| tooth == mating)
            });
            if let Some(room) = room {
                occupied.frame(room);
                taken.push(room);
                group.append(centred(&tooth.to_string(), &room, SIZE, tooth == mating));
            }
        }
    }
    (groups, taken)
}

/// A text in the middle of its room.
pub fn centred(content: &str, room: &Frame, size: f64, bold: bool) -> svg::node::element::Element {
    let at: Spot = [0.5 * (room.left + room.right), room.bottom];
    let style = TextStyle::new(size).middle();
    let style = if bold { style.bold() } else { style };
    style.text(content, at)
}

fn unit(angle: f64) -> Vector2<f64> {
    Vector2::new(angle.cos(), angle.sin())
}

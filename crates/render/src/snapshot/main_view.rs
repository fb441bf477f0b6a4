//! The view of the mesh zone, and the numbers of its teeth.

use super::tooth_numbers::{self, Numbered};
use super::view::View;
use crate::kit::{Frame, Occupied, UNITS_PER_MM, scale};
use gearlash::contact::Scene;
use gearlash::gear::Side;
use gearlash::pair::{Mating, Member};
use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;
use svg::node::element::Group;

/// Pitches shown above and below the line of centres: with one and a half each gear shows three whole teeth, more than ever mate
/// in ordinary pairs.
const PITCHES: f64 = 1.5;
/// Margin round the required content, modules.
const BORDER: f64 = 1.0;
/// Base tangent points up to this distance are brought into view, modules: two pitches, a third more than is shown anyway.
const NEAR: f64 = 6.3;

/// The view of the mesh zone in `frame`: about the middle between the tip circles, with both root
/// circles, the paths of contact and the contacts in it.
pub fn view(scene: &Scene, frame: Frame) -> View {
    let [wheel, pinion] = Member::BOTH.map(|member| scene.placed(member).radii());
    let module = scene.module();
    let distance = scene.assembly().center_distance();
    let middle = Point2::new(0.5 * (wheel[0] + distance - pinion[0]), 0.0);
    let mut half = Vector2::new(0.0, PITCHES * std::f64::consts::PI * module);
    let mut include = |point: Point2<f64>| {
        half = half.sup(&((point - middle).abs().add_scalar(BORDER * module)));
    };
    include(Point2::new(wheel[1], 0.0));
    include(Point2::new(distance - pinion[1], 0.0));
    for contact in scene.contacts() {
        include(contact.on_locked);
        include(contact.on_free);
    }
    for side in Side::BOTH {
        let Some(action) = scene.line_of_action(side) else {
            continue;
        };
        action.path.iter().flatten().copied().for_each(&mut include);
        let contacts = scene.contacts().iter();
        for contact in contacts.filter(|contact| contact.side == side) {
            let is_limit = Member::BOTH.map(|m| contact.is_below_form_circle(m));
            let ends = action.ends.into_iter().zip(is_limit);
            // Tangent points of large gears are too far off to justify the smaller scale.
            let is_near = |end: &Point2<f64>| (end - middle).norm() <= NEAR * module;
            ends.filter(|(end, is_limit)| *is_limit && is_near(end))
                .for_each(|(end, _)| include(end));
        }
    }
    let fits = f64::min(0.5 * frame.width() / half.x, 0.5 * frame.height() / half.y);
    View {
        frame,
        middle,
        scale: UNITS_PER_MM * scale::at_most(fits / UNITS_PER_MM, scale::FINE),
    }
}

/// Numbers the teeth in view of wheel and pinion, mating ones in bold. Their rooms are added to `occupied` and returned.
pub fn tooth_numbers(
    scene: &Scene,
    view: &View,
    mating: &Mating,
    occupied: &mut Occupied,
) -> ([Group; 2], Vec<Frame>) {
    let gears = Member::BOTH.map(|member| {
        let placed = scene.placed(member);
        let [tip, root] = placed.radii();
        Numbered {
            centre: placed.centre(),
            tip,
            root,
            foot: placed.base_radius().map_or(root, |base| root.min(base)),
            pitch: TAU / f64::from(scene.assembly().teeth(member)),
            teeth: placed.teeth_near(view.middle, view.reach()),
            mating: mating.tooth(member),
        }
    });
    tooth_numbers::draw(&gears, view, occupied)
}

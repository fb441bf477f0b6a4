//! The gears turning through a pitch, always in contact: one SVG, moved by SMIL.
//!
//! Without SMIL it shows its first frame. Rotations between two steps are interpolated; marks jump where
//! another pair of teeth takes over.

use super::gears::lines_over;
use super::subject::{MAIN, Snapshot, names};
use super::turning::{course, jumping, motion, rotation};
use super::turning::{metal, times, turns};
use super::view::View;
use super::{caption, main_view, pitch_chart};
use crate::kit::{
    HEIGHT, INK, Ids, Occupied, Spot, TextStyle, WIDTH, around, blank_sheet, dot, hatch, scale,
};
use gearlash::contact::{DrawnContact, MeshSection, PoseResult, Scene};
use gearlash::gear::Side;
use gearlash::pair::Member;
use svg::node::element::Group;

/// The SVG text of `steps` through a pitch, in ascending order; `view` shows the first. For helical gears `sections` has the
/// section of each step, all at one place; for spur gears it is empty.
pub fn animation(view: &Snapshot, steps: &[PoseResult], sections: &[MeshSection]) -> String {
    let steps_in_sections = steps.iter().enumerate();
    let scenes = steps_in_sections.map(|(number, step)| {
        let at_step = Snapshot {
            pose: &step.pose,
            found: step.found.as_ref(),
            section: sections.get(number),
            ..*view
        };
        at_step.scene()
    });
    let scenes: Vec<Scene> = scenes.collect();
    let first = view.scene();
    let main = main_view::view(&first, MAIN);
    let mut occupied = Occupied::default();
    let mating = view.drawn_pose().mating();
    let times = times(steps);
    let metal = metal(&first, &scenes, &times, &main, &mut occupied);
    let over = lines_over(&first, &main, &Side::BOTH, Group::new(), &mut occupied);
    for contact in first.contacts() {
        for point in [contact.on_locked, contact.on_free] {
            occupied.frame(around(main.spot(point), 4.0));
        }
    }
    let (numbers, _) = main_view::tooth_numbers(&first, &main, mating, &mut occupied);
    let turning = |(member, numbers)| {
        let axis = main.spot(first.placed(member).axis());
        let motion = rotation(&turns(&scenes, member), &times, axis);
        Group::new().add(motion).add(numbers)
    };
    let numbers = Member::BOTH.into_iter().zip(numbers).map(turning);
    let numbers = numbers.fold(
        Group::new().set("clip-path", "url(#mesh-frame)"),
        Group::add,
    );
    let sheet = blank_sheet(WIDTH, HEIGHT)
        .add(hatch(&Ids::default()))
        .add(caption::draw_turning(
            view,
            &first,
            steps,
            MAIN.left,
            WIDTH - 2.0 * MAIN.left,
        ))
        .add(names(&first, &MAIN))
        .add(metal)
        .add(Group::new().set("clip-path", "url(#mesh-frame)").add(over))
        .add(MAIN.border())
        .add(marks(&scenes, &times, &main))
        .add(numbers)
        .add(scale::bar([MAIN.left, MAIN.bottom + 16.0], main.scale))
        .add(pitch_chart::draw(steps))
        .add(key(view.section.is_some()));
    format!("{sheet}\n")
}

/// The contacts: filled where the gears touch; open for the two points that meet on the other side.
fn marks(scenes: &[Scene], times: &[f64], view: &View) -> Group {
    let mut group = Group::new().set("clip-path", "url(#mesh-frame)");
    for side in Side::BOTH {
        let contacts = scenes.iter().map(|scene| scene.contacts().iter());
        let contacts = contacts.map(|mut each| each.find(|contact| contact.side == side));
        let contacts: Vec<Option<&DrawnContact>> = contacts.collect();
        for on_free in [true, false] {
            let spots = contacts.iter().map(|contact| {
                let contact = (*contact)?;
                let at = if on_free {
                    contact.on_free
                } else {
                    contact.on_locked
                };
                let teeth = Member::BOTH.map(|member| contact.touch(member).tooth);
                Some((view.spot(at), teeth))
            });
            let spots: Option<Vec<(Spot, [u32; 2])>> = spots.collect();
            let touch = |contact: &Option<&DrawnContact>| {
                contact.is_some_and(|contact| contact.turn == 0.0)
            };
            let touching = contacts.iter().all(touch);
            // Sections of helical gears touch only at some steps.
            let fills = (!touching && contacts.iter().any(touch)).then(|| {
                let fill = |contact| if touch(contact) { INK } else { "white" };
                jumping("fill", contacts.iter().map(fill), times)
            });
            // A side that is out of mesh at some step has no marks; one in contact needs a single dot.
            if let Some(spots) = spots.filter(|_| !(touching && on_free)) {
                let [x, y] = [0, 1].map(|axis| course(&spots, times, axis));
                let filled = touch(&contacts[0]);
                let mut mark = dot(spots[0].0, 4.0, filled)
                    .add(motion("cx", &x))
                    .add(motion("cy", &y));
                if let Some(fills) = fills {
                    mark = mark.add(fills);
                }
                group = group.add(mark);
            }
        }
    }
    group
}

/// The meaning of the marks, and help for a still picture.
fn key(is_section: bool) -> Group {
    let open = if is_section {
        "points of flanks that would meet · lines and circles as in a snapshot"
    } else {
        "points of the other flanks that would meet · lines and circles as in a snapshot"
    };
    let [x, y] = [MAIN.left, 780.0];
    let mut group = Group::new()
        .add(dot([x + 8.0, y], 4.0, true))
        .add(dot([x + 214.0, y], 4.0, false))
        .add(dot([x + 230.0, y], 4.0, false));
    for (words, left) in [("where the gears touch", 20.0), (open, 242.0)] {
        group = group.add(TextStyle::new(13.0).text(words, [x + left, y + 4.5]));
    }
    let note = "animated in a browser; elsewhere its first frame. Found at every sixtieth of the pitch and at its extremes, to scale";
    group.add(TextStyle::new(13.0).grey().text(note, [x, y + 29.5]))
}

//! The caption above a picture: title, mating, result.

use super::subject::Snapshot;
use crate::kit::{Spot, TextStyle};
use crate::pose_name::pose_name;
use gearlash::contact::{FreePlacement, PoseResult, Scene, Status};
use gearlash::gear::Side;
use gearlash_text::numbers::{trimmed, um, um_bounded};
use svg::node::element::{Element, Group};

/// Least type size of a result; a longer one is cut.
const LEAST: f64 = 9.0;

/// Title, mating and result, from `left` on and no wider than `room`.
pub fn draw(view: &Snapshot, scene: &Scene, left: f64, room: f64) -> Group {
    with_result(view, &result_line(view, scene), left, room)
}

fn with_result(view: &Snapshot, result: &str, left: f64, room: f64) -> Group {
    let result = in_room(TextStyle::new(16.0), result, [left, 97.0], room);
    heading(view, left, room).add(result)
}

/// `words` in `style`: smaller where they are longer than `room`, and cut where that is not enough.
fn in_room(style: TextStyle, words: &str, at: Spot, room: f64) -> Element {
    let style = style.fitted(words, room, LEAST);
    style.text(&style.shortened(words, room), at)
}

pub fn heading(view: &Snapshot, left: f64, room: f64) -> Group {
    let (title, pose) = (TextStyle::new(24.0).bold(), TextStyle::new(16.0).grey());
    Group::new()
        .add(title.verbatim(&title.shortened(view.title, room), [left, 46.0]))
        .add(in_room(pose, &pose_line(view), [left, 73.0], room))
}

fn pose_line(view: &Snapshot) -> String {
    let section = view.section.map_or(String::new(), |section| {
        format!(" · section at z = {} mm", trimmed(section.at(), 0, 3))
    });
    format!(
        "{}{section} · centre distance {} mm · {}",
        pose_name(view.pose.mating()),
        trimmed(view.assembly.center_distance(), 3, 6),
        view.material.words()
    )
}

/// Title, the pose at the start of the pitch, and the result over its `steps`.
pub fn draw_turning(
    view: &Snapshot,
    scene: &Scene,
    steps: &[PoseResult],
    left: f64,
    room: f64,
) -> Group {
    let known = || steps.iter().filter_map(|step| step.backlash);
    let ends = [known().reduce(f64::min), known().reduce(f64::max)];
    let without = steps.len() - known().count();
    let mut words = match ends {
        [Some(least), Some(greatest)] => format!(
            "over the pitch from there on: least j_wt {} µm, greatest {} µm{}",
            um(least, 2),
            um(greatest, 2),
            over_face(view)
        ),
        _ => "over the pitch from there on: no backlash".to_owned(),
    };
    if without > 0 {
        let all = steps.len();
        words += &format!(" · {without} of {all} frames jammed, out of mesh or unproven");
    }
    let words = format!("{words} · {}", drawn_contact(scene));
    with_result(view, &words, left, room)
}

fn result_line(view: &Snapshot, scene: &Scene) -> String {
    let (status, backlash) = match (view.section, view.found) {
        // The gap of a section alone is not that of the gears.
        (Some(_), Ok(found)) => {
            let radius = view.assembly.operating_pitch_radius(view.assembly.free());
            let both = found.angle().zip(found.error());
            let both = both.map(|(angle, error)| (angle * radius, error * radius));
            (found.status(), both)
        }
        _ => (scene.status(), scene.circumferential_backlash()),
    };
    let what = match (view.found, status, backlash) {
        (Err(unproven), ..) => format!("unproven, no contact is drawn: {}", unproven.reason),
        (Ok(_), status, Some((value, error))) => {
            let word = match status {
                Status::Interference => "interference",
                _ => "clear",
            };
            let j_wt = um_bounded(value, error);
            format!("j_wt = {j_wt}{} · {word}", over_face(view))
        }
        (Ok(_), Status::Jammed, None) => "jammed: a tip sits in a root".to_owned(),
        (Ok(_), _, None) => "no contact: out of mesh".to_owned(),
    };
    format!("{what} · {}", drawn_contact(scene))
}

/// The face for which the result of a section holds; empty where sections do not differ.
fn over_face(view: &Snapshot) -> String {
    view.section.map_or(String::new(), |_| {
        let [from, to] = view.assembly.face().map(|end| trimmed(end, 0, 3));
        format!(" over the face {from} … {to} mm")
    })
}

/// The contact in which the free gear is drawn.
fn drawn_contact(scene: &Scene) -> String {
    let free = scene.assembly().free().name();
    match scene.free_placement() {
        FreePlacement::AtContact(side) => {
            let way = match side {
                Side::Right => "clockwise",
                Side::Left => "counter-clockwise",
            };
            let side = side.name();
            format!("drawn with the {free} turned {way} to {side}-flank contact")
        }
        FreePlacement::Nominal => format!("drawn with the {free} at its nominal rotation"),
    }
}

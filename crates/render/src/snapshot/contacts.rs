//! Contact points, the points that will meet, normals, bands along the touching curves, and the marks of a fillet's contact.
//!
//! Each kind of curve has a colour of its own lightness and a line style of its own, so that colour-blind readers
//! and black-and-white print distinguish them.

use super::view::{MARGIN, View};
use crate::kit::{
    Frame, GREY, INK, Occupied, Spot, around, arrow, clip, dashed, diamond, dot, group, line,
};
use gearlash::contact::{DrawnContact, Scene};
use gearlash::gear::{Placed, ProfilePart};
use gearlash::pair::Member;
use svg::node::element::Group;

/// Size of the marks in a view, units of the sheet.
#[derive(Debug, Clone, Copy)]
pub struct MarkSize {
    pub dot: f64,
    pub normal: f64,
}

pub const IN_MAIN: MarkSize = MarkSize {
    dot: 4.0,
    normal: 52.0,
};
pub const IN_INSET: MarkSize = MarkSize {
    dot: 5.0,
    normal: 64.0,
};

/// Draws a contact. Where the gears touch, it is one filled point. Elsewhere it is the two open points that will meet, with the path
/// from the free gear's to the other where it is visible.
pub fn marks(
    contact: &DrawnContact,
    view: &View,
    size: MarkSize,
    occupied: &mut Occupied,
) -> Group {
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
    let other = (!touching).then_some(free);
    for spot in [Some(locked), other].into_iter().flatten() {
        occupied.frame(around(spot, size.dot));
        group = group.add(dot(spot, size.dot, touching));
    }
    group
}

/// Width of a band in the mesh zone and in an inset. Half of it, on the metal's side, is visible; its outer part is under the
/// outline.
pub const BANDS: [f64; 2] = [9.0, 13.0];
pub const FORM_DASH: &str = "1.6 3.4";

/// Colour and dashes of a curve's band; no dashes: solid.
pub fn style(curve: ProfilePart) -> (&'static str, &'static str) {
    match curve {
        ProfilePart::Involute => ("#5b3a8c", ""),
        ProfilePart::Fillet => ("#e69f00", "9 4"),
        ProfilePart::Tip => ("#b0176b", "2.5 2.5"),
        ProfilePart::Root => ("#7a4a12", "12 3 2.5 3"),
    }
}

/// The part of a profile on which `contact` lies, and its gear; `None` for a drawn one.
pub fn part_on<'a>(
    scene: &'a Scene,
    contact: &DrawnContact,
    member: Member,
) -> Option<(ProfilePart, &'a Placed<'a>)> {
    let part = contact.touch(member).curve.part();
    part.zip(scene.placed(member).data())
}

/// The bands of one contact, on the metal's side of both outlines (clips `{id}-wheel-clip`, `{id}-pinion-clip`).
pub fn bands(scene: &Scene, contact: &DrawnContact, view: &View, id: &str, width: f64) -> Group {
    let wide = view.frame.grown(MARGIN);
    let mut group = Group::new();
    for member in Member::BOTH {
        let Some((part, placed)) = part_on(scene, contact, member) else {
            continue;
        };
        let (colour, dashes) = style(part);
        let tooth = contact.touch(member).tooth;
        let points = placed.curve(contact.side, tooth, part, view.chord());
        for run in clip::parts(&view.spots(&points), &wide) {
            let clip = format!("url(#{id}-{}-clip)", member.name());
            group = group.add(band(&run, width, colour, dashes).set("clip-path", clip));
        }
    }
    group
}

/// A coloured line, dashed on white.
pub fn band(points: &[Spot], width: f64, colour: &str, dashes: &str) -> Group {
    match dashes {
        "" => Group::new().add(line(points, colour, width)),
        _ => group([
            line(points, "white", width),
            dashed(points, colour, width, dashes),
        ]),
    }
}

/// For a contact below a gear's form circle: that circle, and the point where the line of action touches its base circle, beyond
/// which there is no involute.
pub fn limits(
    scene: &Scene,
    contact: &DrawnContact,
    view: &View,
    occupied: &mut Occupied,
) -> Group {
    let wide = view.frame.grown(MARGIN);
    let mut group = Group::new();
    for (_, placed) in below_form(scene, contact) {
        let radius = placed.as_built().gear().form_radius();
        for run in clip::runs(&view.arc(placed.centre(), radius), &wide) {
            occupied.line(&run);
            group = group.add(dashed(&run, INK, 1.6, FORM_DASH));
        }
    }
    for spot in tangent_points(scene, contact, view) {
        occupied.frame(around(spot, 6.0));
        group = group.add(diamond(spot));
    }
    group
}

/// The gears below whose form circle `contact` lies.
pub fn below_form<'a>(
    scene: &'a Scene,
    contact: &'a DrawnContact,
) -> impl Iterator<Item = (Member, &'a Placed<'a>)> {
    let members = Member::BOTH.into_iter();
    let below = members.filter(|member| contact.is_below_form_circle(*member));
    below.filter_map(|member| Some((member, scene.placed(member).data()?)))
}

pub fn tangent_points(scene: &Scene, contact: &DrawnContact, view: &View) -> Vec<Spot> {
    let Some(action) = scene.line_of_action(contact.side) else {
        return Vec::new();
    };
    let members = below_form(scene, contact);
    let ends = members.map(|(member, _)| action.ends[usize::from(member == Member::Pinion)]);
    let inner = view.frame.grown(-8.0);
    ends.map(|end| view.spot(end))
        .filter(|spot| inner.holds(&around(*spot, 0.0)))
        .collect()
}

pub fn sample(x: f64, y: f64, width: f64, curve: ProfilePart) -> Group {
    let (colour, dashes) = style(curve);
    let frame = Frame::new([x, y - 4.0], [x + width, y + 4.0]);
    let band = band(&[[x, y], [x + width, y]], 7.0, colour, dashes);
    Group::new()
        .add(band)
        .add(frame.painted("none", GREY, "0.60"))
}

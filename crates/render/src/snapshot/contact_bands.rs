//! Bands along the touching curves: their styles, and the marks of a fillet's contact.
//!
//! Each kind has a colour of its own lightness and a line style of its own, so that colour-blind readers
//! and black-and-white print distinguish them.

use super::view::{MARGIN, View};
use crate::kit::{Frame, GREY, INK, Occupied, Spot, around, clip, diamond, line};
use gearlash::contact::{DrawnContact, Scene};
use gearlash::gear::ProfilePart;
use gearlash::pair::Member;
use svg::node::element::Group;

/// Width of a band in the mesh zone and in an inset. Half of it, on the metal's side, is visible; its outer part is under the
/// outline.
pub const BANDS: [f64; 2] = [9.0, 13.0];
/// Dots.
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

/// The bands of one contact, on the metal's side of both outlines (clips `{id}-wheel-clip`, `{id}-pinion-clip`).
pub fn bands(scene: &Scene, contact: &DrawnContact, view: &View, id: &str, width: f64) -> Group {
    let wide = view.frame.grown(MARGIN);
    let mut group = Group::new();
    for member in Member::BOTH {
        let touch = contact.touch(member);
        let (Some(part), Some(placed)) = (touch.curve.part(), scene.placed(member).data()) else {
            continue;
        };
        let (colour, dashes) = style(part);
        let points = placed.curve(contact.side, touch.tooth, part, view.chord());
        for run in clip::parts(&view.spots(&points), &wide) {
            let clip = format!("url(#{id}-{}-clip)", member.name());
            group = group.add(band(&run, width, colour, dashes).set("clip-path", clip));
        }
    }
    group
}

/// A coloured line, dashed on white.
pub fn band(points: &[Spot], width: f64, colour: &str, dashes: &str) -> Group {
    let coloured = line(points, colour, width);
    match dashes {
        "" => Group::new().add(coloured),
        _ => Group::new()
            .add(line(points, "white", width))
            .add(coloured.set("stroke-dasharray", dashes)),
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
    for member in below_form(contact) {
        let Some(placed) = scene.placed(member).data() else {
            continue;
        };
        let radius = placed.as_built().gear().form_radius();
        for run in clip::runs(&view.arc(placed.centre(), radius), &wide) {
            occupied.line(&run);
            group = group.add(line(&run, INK, 1.6).set("stroke-dasharray", FORM_DASH));
        }
    }
    for spot in tangent_points(scene, contact, view) {
        occupied.frame(around(spot, 6.0));
        group = group.add(diamond(spot));
    }
    group
}

/// The gears with the contact on their fillet or root.
pub fn below_form(contact: &DrawnContact) -> Vec<Member> {
    let members = Member::BOTH.into_iter();
    members
        .filter(|member| contact.is_below_form_circle(*member))
        .collect()
}

/// The visible base tangent points.
pub fn tangent_points(scene: &Scene, contact: &DrawnContact, view: &View) -> Vec<Spot> {
    let Some(action) = scene.line_of_action(contact.side) else {
        return Vec::new();
    };
    let members = below_form(contact).into_iter();
    let ends = members.map(|member| action.ends[usize::from(member == Member::Pinion)]);
    let inner = view.frame.grown(-8.0);
    ends.map(|end| view.spot(end))
        .filter(|spot| inner.holds(&around(*spot, 0.0)))
        .collect()
}

/// The sample of a band in the legend.
pub fn sample(x: f64, y: f64, width: f64, curve: ProfilePart) -> Group {
    let (colour, dashes) = style(curve);
    let frame = Frame::new([x, y - 4.0], [x + width, y + 4.0]);
    Group::new()
        .add(band(&[[x, y], [x + width, y]], 7.0, colour, dashes))
        .add(
            frame
                .rectangle()
                .set("fill", "none")
                .set("stroke", GREY)
                .set("stroke-width", "0.60"),
        )
}

//! Marks over the metal: axes, tooth numbers, contacts, normals. Strokes keep their width on the screen.

use super::contacts::touching;
use super::precision::{Precision, degrees};
use super::section::Winding;
use crate::kit::{ACTION, GREY, INK};
use gearlash::analysis::compare::ComparedPose;
use gearlash::contact::{Contact, LostMotion, Status};
use gearlash::gear::Side;
use gearlash::outline::{AssembledPair, PlacedGear};
use gearlash::pair::Member;
use gearlash_files::numbers::rounded;
use svg::node::element::{Group, Path, Text};

/// Half the length of a normal, modules: across the mesh zone.
const NORMAL: f64 = 12.0;
/// Half the arms of the cross on an axis, modules.
const CROSS: f64 = 1.0;
/// Size of a tooth number, modules.
const NUMBER: f64 = 0.75;
/// Distance of a tooth's number inside the root circle, modules: clear of contacts and circles.
const INSIDE: f64 = 0.6;

/// A thin grey line.
pub fn line() -> Path {
    stroke(GREY, "1")
}

/// A circle about the origin, as path data.
pub fn circle(radius: f64) -> String {
    format!("M{radius} 0A{radius} {radius} 0 1 1 -{radius} 0A{radius} {radius} 0 1 1 {radius} 0Z")
}

/// A cross at the origin.
pub fn axis(module: f64) -> Path {
    let arm = CROSS * module;
    line().set("d", format!("M-{arm} 0H{arm}M0 -{arm}V{arm}"))
}

/// The number of every tooth of a gear at the origin, upright where the tooth points at the mate; for helical gears in a section.
pub fn numbers(
    gear: &PlacedGear,
    member: Member,
    module: f64,
    section: Option<f64>,
    precision: Precision,
) -> Group {
    let [tip, root] = gear.radii();
    let radius = rounded(root - INSIDE * module, precision.decimals);
    // A disc that contains the centre has all teeth.
    let mut teeth = gear.teeth_near(gear.centre(), tip);
    teeth.sort_by_key(|(tooth, _)| *tooth);
    let first = teeth.first().map_or(0.0, |(_, direction)| *direction);
    let centre = gear.centre() - gear.axis();
    let [x, y] = [centre.x, centre.y].map(|value| rounded(value, precision.decimals));
    let at_mate = match member {
        Member::Wheel => radius,
        Member::Pinion => -radius,
    };
    let wound = section.map(|at| Winding::new(gear, member, at, precision.decimals));
    let group = match wound {
        None => Group::new().set("transform", format!("translate({x} {y})")),
        Some(wound) => Group::new()
            .set(
                "transform",
                format!("translate({x} {y}) rotate({})", wound.turned),
            )
            .set("data-winds", wound.name)
            .set("data-centre", wound.centre()),
    };
    let group = group
        .set("font-size", rounded(NUMBER * module, 4))
        .set("text-anchor", "middle")
        .set("fill", GREY);
    teeth.into_iter().fold(group, |group, (tooth, direction)| {
        let place = format!(
            "rotate({}) translate({} 0) scale(1 -1)",
            degrees(direction - first),
            at_mate
        );
        group.add(
            Text::new(tooth.to_string())
                .set("id", format!("viewer-{}-tooth-{tooth}", member.name()))
                .set("transform", place)
                .set("dy", "0.35em"),
        )
    })
}

/// The contact on `side`: its normal, and the points on the locked and on the free gear. The free gear is drawn in right-flank
/// contact, so the left points are apart by the lost motion.
pub fn marks(
    assembly: &AssembledPair,
    pose: &ComparedPose,
    side: Side,
    precision: Precision,
) -> Group {
    let contact = touching(&pose.simulated, side);
    let place = contact.map_or(String::from("translate(0 0)"), |contact| {
        let [x, y] = [contact.point.x, contact.point.y].map(|v| rounded(v, precision.decimals));
        format!("translate({x} {y})")
    });
    let lost = pose.simulated.proven().and_then(LostMotion::angle);
    let lost = lost.map_or(0.0, degrees);
    let back = match side {
        Side::Right => 0.0,
        Side::Left => -lost,
    };
    let axis = assembly.axis(assembly.free()).x;
    let half = NORMAL * assembly.module();
    let name = side.name();
    let towards = |contact: Contact| degrees(contact.normal.y.atan2(contact.normal.x));
    let turned = contact.map_or(0.0, towards);
    let normal = stroke(ACTION, "1.2")
        .set("id", format!("viewer-normal-{name}"))
        .set("transform", format!("rotate({turned})"))
        .set("d", format!("M-{half} 0H{half}"));
    let class = match side {
        Side::Right => "viewer-dot",
        Side::Left => "viewer-dot viewer-open",
    };
    let dot = |id: &str| {
        let hole = point("white", "6").set("transform", place.as_str());
        Group::new()
            .set("id", format!("viewer-{id}-{name}"))
            .set("class", class)
            .add(point(INK, "10").set("transform", place.as_str()))
            .add(hole.set("class", "viewer-hole"))
    };
    // An overlap of some µm is narrower than a pixel at first, so its dots are red and large.
    let class = match pose.simulated.status() {
        Status::Interference => "viewer-overlapping",
        Status::Clear | Status::Jammed | Status::NoContact | Status::Unproven => "",
    };
    let group = Group::new()
        .set("id", format!("viewer-{name}-contact"))
        .set("class", class);
    let group = match contact {
        Some(_) => group,
        None => group.set("display", "none"),
    };
    group
        .add(Group::new().set("transform", place.as_str()).add(normal))
        .add(dot("locked"))
        .add(dot("free").set("transform", format!("rotate({back} {axis} 0)")))
}

fn stroke(colour: &str, width: &str) -> Path {
    Path::new()
        .set("fill", "none")
        .set("stroke", colour)
        .set("stroke-width", width)
        .set("vector-effect", "non-scaling-stroke")
}

/// A dot of constant size: a round cap without a line.
fn point(colour: &str, size: &str) -> Path {
    stroke(colour, size)
        .set("stroke-linecap", "round")
        .set("d", "M0 0h0")
}

//! The SVG of one pose; the script moves its parts. Strokes of marks keep their width on the screen.
//!
//! Coordinates are mm in the picture frame, with y up by a flip of the outermost group. A gear's group turns about its axis; the
//! outline in it is displaced by the eccentricity.

use super::columns::{free_rotation, outline_of};
use super::precision::{Precision, degrees};
use super::readout::{first, touching};
use crate::kit::{ACTION, GREY, INK, OVERLAP, PINION, WHEEL};
use gearlash::analysis::compare::{ComparedPose, ComparedRun};
use gearlash::contact::{Contact, LostMotion, Status};
use gearlash::gear::Side;
use gearlash::outline::{AssembledPair, PlacedGear};
use gearlash::pair::Member;
use gearlash_text::numbers::rounded;
use std::fmt::Write;
use svg::node::element::{ClipPath, Definitions, Group, Path, SVG, Text, Use};

const ASPECT: f64 = 1.25;
/// Half the height shown first, modules: more than one and a half pitches, as in a snapshot.
const HALF_HEIGHT: f64 = 5.0;
const BORDER: f64 = 2.0;

pub fn draw(
    outlines: &[&AssembledPair],
    run: &ComparedRun,
    pose: &ComparedPose,
    precision: Precision,
) -> String {
    let assembly = &run.run.assembly;
    let module = assembly.module();
    let turn = |member: Member| {
        let turned = if member == assembly.locked() {
            degrees(pose.simulated.pose.locked_rotation())
        } else {
            degrees(free_rotation(&pose.simulated))
        };
        format!("translate({} 0) rotate({turned})", assembly.axis(member).x)
    };
    let own = outline_of(outlines, run);
    let section = first(assembly, &pose.simulated);
    let metal = |member: Member| {
        Use::new()
            .set("href", format!("#viewer-{}-{own}", member.name()))
            .set("data-outline", member.name())
    };
    let gear = |(member, fill): (Member, &str)| {
        let outline = metal(member).set("fill", fill).set("stroke", INK);
        let placed = PlacedGear::new(assembly, member, 0.0);
        Group::new()
            .set("id", format!("viewer-{}", member.name()))
            .set("transform", turn(member))
            .add(outline.set("stroke-width", "1.3"))
            .add(axis(module))
            .add(numbers(&placed, member, module, section, precision))
    };
    let overlap = Group::new()
        .set("id", "viewer-overlap")
        .set("transform", turn(Member::Pinion))
        .add(metal(Member::Pinion).set("fill", OVERLAP));
    let overlap = Group::new()
        .set("clip-path", "url(#viewer-clip)")
        .add(overlap);
    let clip = metal(Member::Wheel)
        .set("id", "viewer-clip-shape")
        .set("transform", turn(Member::Wheel));
    // Unlimited dashes: a view 0.02 mm wide would have millions. The script cuts both lines to the visible part.
    let centres = line()
        .set("id", "viewer-centres")
        .set("d", format!("M0 0H{}", assembly.center_distance()))
        .set("stroke-dasharray", "22 4 2 4 2 4");
    let pitch_circle = |member: Member| {
        let radius = assembly.operating_pitch_radius(member);
        let axis = assembly.axis(member).x;
        line()
            .set("id", format!("viewer-pitch-{}", member.name()))
            .set("transform", format!("translate({axis} 0)"))
            .set("d", circle(rounded(radius, precision.decimals)))
            .set("stroke-dasharray", "14 3 2 3")
    };
    let gears = [(Member::Wheel, WHEEL), (Member::Pinion, PINION)].map(gear);
    let picture = Group::new().set("transform", "scale(1 -1)");
    let picture = gears.into_iter().fold(picture, Group::add);
    let picture = picture.add(overlap).add(centres);
    let circles = Member::BOTH.map(pitch_circle).into_iter();
    let picture = circles.fold(picture, Group::add);
    let marks = Side::BOTH.map(|side| marks(assembly, pose, side, precision));
    let picture = marks.into_iter().fold(picture, Group::add);
    let [home, whole] = views(assembly, module);
    let definitions = definitions(outlines, section, precision)
        .add(ClipPath::new().set("id", "viewer-clip").add(clip));
    let sheet = SVG::new()
        .set("id", "viewer-picture")
        .set("viewBox", home.as_str())
        .set("data-home", home)
        .set("data-whole", whole)
        .set("data-narrowest", rounded(precision.narrowest(), 6))
        .set("role", "img")
        .set("aria-label", "Both gears in mesh")
        .set("font-family", "sans-serif")
        .add(definitions)
        .add(picture);
    format!("{sheet}\n")
}

/// The outlines, `viewer-wheel-0` and so on, in a section where sections differ.
fn definitions(
    outlines: &[&AssembledPair],
    section: Option<f64>,
    precision: Precision,
) -> Definitions {
    let gears = outlines.iter().enumerate().flat_map(|(number, pair)| {
        let both = Member::BOTH.into_iter();
        both.map(move |member| (number, member, *pair))
    });
    gears.fold(Definitions::new(), |definitions, (number, member, pair)| {
        let placed = PlacedGear::new(pair, member, 0.0);
        let scale = format!("scale({})", precision.unit());
        let outline = match section {
            None => Path::new().set("transform", scale),
            Some(at) => {
                let (turned, centre) = (turned(&placed, at), centre(&placed, precision));
                Path::new()
                    .set("transform", format!("rotate({turned} {centre}) {scale}"))
                    .set("data-winds", member.name())
                    .set("data-centre", centre)
                    .set("data-then", scale)
            }
        };
        let outline = outline
            .set("id", format!("viewer-{}-{number}", member.name()))
            .set("vector-effect", "non-scaling-stroke")
            .set("stroke-linejoin", "round");
        definitions.add(outline.set("d", path(&placed, pair.gear_reach(member), precision)))
    })
}

/// The rotation of the teeth of `gear` in `section`, mm, in degrees.
fn turned(gear: &PlacedGear, section: f64) -> f64 {
    degrees(gear.twist() * section)
}

/// The offset of the centre of `gear` from its axis, mm.
fn centre(gear: &PlacedGear, precision: Precision) -> String {
    let centre = gear.centre() - gear.axis();
    let [x, y] = [centre.x, centre.y].map(|value| rounded(value, precision.decimals));
    format!("{x} {y}")
}

/// The `viewBox` of the mesh zone and of the whole gears.
fn views(assembly: &AssembledPair, module: f64) -> [String; 2] {
    let a = assembly.center_distance();
    let [wheel, pinion] = Member::BOTH.map(|member| assembly.gear_reach(member));
    let view = |middle: f64, half_width: f64, half_height: f64| {
        let half_height = f64::max(half_height, half_width / ASPECT);
        let half_width = half_height * ASPECT;
        let corner = [middle - half_width, -half_height].map(|v| rounded(v, 4));
        let size = [2.0 * half_width, 2.0 * half_height].map(|v| rounded(v, 4));
        format!("{} {} {} {}", corner[0], corner[1], size[0], size[1])
    };
    let border = BORDER * module;
    let half_width = 0.5 * (a + wheel + pinion) + border;
    let half_height = f64::max(wheel, pinion) + border;
    [
        view(0.5 * (wheel + a - pinion), 0.0, HALF_HEIGHT * module),
        view(0.5 * (a + pinion - wheel), half_width, half_height),
    ]
}

/// The whole outline about its axis, displaced by its eccentricity: relative path data in units of the last decimal.
///
/// Whole numbers stay exact: browsers add single-precision numbers, which hold 24 bits.
fn path(gear: &PlacedGear, reach: f64, precision: Precision) -> String {
    // A disc about the axis, at least as large as the gear, contains its centre and thus all teeth.
    let mut data = String::new();
    let mut last: Option<[i64; 2]> = None;
    for point in gear.outline_near(gear.axis(), reach, precision.chord) {
        let point = point - gear.axis();
        let [x, y] = [point.x, point.y].map(|value| precision.units(value));
        let _ = match last {
            None => write!(data, "M{x} {y}l"),
            Some(before) if before == [x, y] => Ok(()),
            Some([left, low]) => {
                let [dx, dy] = [x - left, y - low];
                // A minus sign separates two numbers as a space does.
                let is_first = data.ends_with('l');
                let separator = if is_first || dx < 0 { "" } else { " " };
                let between = if dy < 0 { "" } else { " " };
                write!(data, "{separator}{dx}{between}{dy}")
            }
        };
        last = Some([x, y]);
    }
    data.push('z');
    data
}

/// Half the length of a normal, modules: across the mesh zone.
const NORMAL: f64 = 12.0;
const CROSS: f64 = 1.0;
const NUMBER: f64 = 0.75;
/// Distance of a tooth's number inside the root circle, modules: clear of contacts and circles.
const INSIDE: f64 = 0.6;

pub fn line() -> Path {
    stroke(GREY, "1")
}

/// A circle about the origin, as path data.
pub fn circle(radius: f64) -> String {
    format!("M{radius} 0A{radius} {radius} 0 1 1 -{radius} 0A{radius} {radius} 0 1 1 {radius} 0Z")
}

pub fn axis(module: f64) -> Path {
    let arm = CROSS * module;
    line().set("d", format!("M-{arm} 0H{arm}M0 -{arm}V{arm}"))
}

/// The number of every tooth of a gear at the origin, upright where the tooth points at the mate, in a section where sections differ.
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
    teeth.sort_by_cached_key(|(tooth, _)| u64::from(*tooth));
    let first = teeth.first().map_or(0.0, |(_, direction)| *direction);
    let centre = centre(gear, precision);
    let at_mate = match member {
        Member::Wheel => radius,
        Member::Pinion => -radius,
    };
    let group = match section.map(|at| turned(gear, at)) {
        None => Group::new().set("transform", format!("translate({centre})")),
        Some(turned) => Group::new()
            .set("transform", format!("translate({centre}) rotate({turned})"))
            .set("data-winds", member.name())
            .set("data-centre", centre),
    };
    let group = group
        .set("font-size", rounded(NUMBER * module, 4))
        .set("text-anchor", "middle")
        .set("fill", GREY);
    teeth.into_iter().fold(group, |group, (tooth, direction)| {
        let turned = degrees(direction - first);
        let place = format!("rotate({turned}) translate({at_mate} 0) scale(1 -1)");
        let number = Text::new(tooth.to_string())
            .set("id", format!("viewer-{}-tooth-{tooth}", member.name()))
            .set("transform", place);
        group.add(number.set("dy", "0.35em"))
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

//! The contact of a drawn pair: one pose, true to scale, on an A4 sheet; both contacts enlarged beside it.

use super::gears::{CENTRES_DASH, PITCH_DASH, clipped};
use super::inset;
use super::legend::{self, Shown};
use super::subject::{Layout, SHEET, in_page};
use super::tooth_numbers::{self, Numbered};
use super::view::{MARGIN, View};
use crate::kit::{
    Frame, GREY, HEIGHT, INK, Ids, OVERLAP, Occupied, PINION, Spot, TextStyle, UNITS_PER_MM, WHEEL,
    area, around, arrow, blank_sheet, clip, dot, hatch, line, scale, within_area,
};
use gearlash::analysis::study::Material;
use gearlash::contact::{Contact, PoseResult, Status};
use gearlash::gear::Side;
use gearlash::outline::OutlinePair;
use gearlash::pair::Member;
use gearlash_files::numbers::{trimmed, um_bounded};
use nalgebra::Point2;
use svg::node::element::{Group, SVG};

/// Operating pitches shown above and below the line of centres.
const PITCHES: f64 = 1.5;
/// How much larger an inset is than the main view: both flanks curve away from a contact.
const ENLARGED: f64 = 10.0;
/// Of the stroke half lies outside the metal.
const STROKE: f64 = 1.2;

/// A pose of a drawn pair as the SVG text of a sheet.
pub fn outline_snapshot(
    title: &str,
    pair: &OutlinePair,
    material: Material,
    pose: &PoseResult,
) -> String {
    let (sheet, _) = draw(title, pair, material, pose, &Ids::default(), &SHEET);
    format!("{sheet}\n")
}

/// The same for a page, with ids that begin with `prefix`, named `label` for those who do not see it.
pub fn outline_snapshot_in_page(
    title: &str,
    pair: &OutlinePair,
    material: Material,
    pose: &PoseResult,
    [prefix, label]: [&str; 2],
) -> String {
    in_page(prefix, label, |ids, layout| {
        draw(title, pair, material, pose, ids, layout)
    })
}

/// The contacts of right and of left flanks.
fn contacts(pose: &PoseResult) -> [Option<Contact>; 2] {
    pose.proven()
        .map_or([None; 2], |found| [found.right, found.left])
}

/// The sheet, and how far down its last row is.
fn draw(
    title: &str,
    pair: &OutlinePair,
    material: Material,
    pose: &PoseResult,
    ids: &Ids,
    layout: &Layout,
) -> (SVG, f64) {
    let frame = layout.main;
    let main = main_view(pair, frame);
    let contacts = contacts(pose);
    let held = contacts.iter().flatten().next();
    let nominal = pose.pose.free_rotation();
    let rotation = held.map_or(nominal, |contact| contact.rotation);
    let mut occupied = Occupied::default();
    let drawn = gears(pair, pose, &main, ("mesh", ids), rotation);
    drawn.metal.iter().for_each(|metal| occupied.line(metal));
    drawn.over.iter().for_each(|line| occupied.line(line));
    let mut sheet = blank_sheet(layout.width, HEIGHT).add(hatch(ids));
    if layout.is_sheet {
        sheet = sheet.add(caption(title, pair, material, pose, held.is_some()));
    }
    let mut sheet = sheet
        .add(names(pair, &frame))
        .add(drawn.group)
        .add(frame.border());
    for (contact, (side, frame)) in contacts
        .iter()
        .zip([Side::Right, Side::Left].into_iter().zip(layout.insets))
    {
        let heading = TextStyle::new(14.0);
        let at = [frame.left, frame.top - 8.0];
        let Some(contact) = contact else {
            let text = format!("no contact of {} flanks", side.name());
            sheet = sheet.add(heading.text(&text, at)).add(frame.border());
            continue;
        };
        let view = View::new(
            frame,
            contact.point,
            UNITS_PER_MM * scale::at_most(ENLARGED * main.scale() / UNITS_PER_MM, scale::ISO_5455),
        );
        sheet = sheet
            .add(heading.text(&words(side, contact), at))
            .add(enlarged(pair, pose, (side, contact), &view, ids))
            .add(frame.border())
            .add(scale::bar([frame.left, frame.bottom + 16.0], view.scale()));
        if contact.rotation == rotation {
            sheet = sheet.add(mark(contact, &main, 52.0, &mut occupied));
        }
    }
    let shown = Shown {
        on_paper: ids.is_sheet(),
        overlap: matches!(pose.status(), Status::Interference | Status::Jammed),
        outlines: true,
        ..Shown::default()
    };
    let (legend, last) = legend::draw(layout.legend, layout.room(), &shown, ids);
    let sheet = sheet
        .add(numbers(pair, pose, &main, rotation, &mut occupied))
        .add(scale::bar([frame.left, frame.bottom + 16.0], main.scale()))
        .add(legend);
    (sheet, last)
}

/// A contact enlarged, each gear with the number of its tooth that touches.
fn enlarged(
    pair: &OutlinePair,
    pose: &PoseResult,
    (side, contact): (Side, &Contact),
    view: &View,
    ids: &Ids,
) -> Group {
    let mut occupied = Occupied::default();
    let teeth = [contact.wheel.tooth, contact.pinion.tooth];
    let drawn = gears(pair, pose, view, (side.name(), ids), contact.rotation);
    drawn.metal.iter().for_each(|metal| occupied.line(metal));
    drawn.over.iter().for_each(|line| occupied.line(line));
    let mark = mark(contact, view, 64.0, &mut occupied);
    let names = inset::names(teeth, &drawn.metal, view, &mut occupied);
    let group = Group::new().add(drawn.group).add(mark);
    names.into_iter().fold(group, Group::add)
}

/// Numbers of the teeth in view, the free gear at `rotation`; those that mate in bold.
fn numbers(
    pair: &OutlinePair,
    pose: &PoseResult,
    view: &View,
    rotation: f64,
    occupied: &mut Occupied,
) -> Group {
    let numbered = |member| {
        let turned = turned(pair, pose, member, rotation);
        let gear = pair.gear(member);
        Numbered {
            centre: pair.centre(member, turned),
            tip: gear.tip_radius(),
            root: gear.root_radius(),
            foot: gear.root_radius(),
            pitch: gear.pitch(),
            teeth: pair.teeth_near(member, turned, view.middle(), view.reach()),
            mating: pose.pose.mating().tooth(member),
        }
    };
    let gears = Member::BOTH.map(numbered);
    let ([wheel, pinion], _) = tooth_numbers::draw(&gears, view, occupied);
    Group::new().add(wheel).add(pinion)
}

/// The rotation at which a gear is drawn, the free one at `rotation`.
fn turned(pair: &OutlinePair, pose: &PoseResult, member: Member, rotation: f64) -> f64 {
    match member == pair.locked() {
        true => pose.pose.locked_rotation(),
        false => rotation,
    }
}

/// What touches, in words.
fn words(side: Side, contact: &Contact) -> String {
    format!(
        "{} flanks: {} on {}, wheel tooth {} and pinion tooth {}",
        side.name(),
        contact.wheel.curve.name(),
        contact.pinion.curve.name(),
        contact.wheel.tooth,
        contact.pinion.tooth
    )
}

fn main_view(pair: &OutlinePair, frame: Frame) -> View {
    let radius = |member| pair.gear(member).tip_radius();
    let root = |member| pair.gear(member).root_radius();
    let (wheel, pinion) = (Member::Wheel, Member::Pinion);
    let distance = pair.center_distance();
    let middle = 0.5 * (radius(wheel) + distance - radius(pinion));
    let pitch = pair.operating_pitch_radius(wheel) * pair.gear(wheel).pitch();
    let half_width = (middle - root(wheel)).max(distance - root(pinion) - middle) + 0.3 * pitch;
    let fits = f64::min(
        0.5 * frame.width() / half_width,
        0.5 * frame.height() / (PITCHES * pitch),
    );
    View::new(
        frame,
        Point2::new(middle, 0.0),
        UNITS_PER_MM * scale::at_most(fits / UNITS_PER_MM, scale::FINE),
    )
}

/// The gears of one view: the drawing, both metals as drawn, wheel first, and the lines over them.
struct DrawnGears {
    group: Group,
    metal: [Vec<Spot>; 2],
    over: Vec<Vec<Spot>>,
}

/// Both gears, the free one at `rotation`: metal, overlap, operating pitch circles and line of centres.
fn gears(
    pair: &OutlinePair,
    pose: &PoseResult,
    view: &View,
    (id, ids): (&str, &Ids),
    rotation: f64,
) -> DrawnGears {
    let frame = view.frame();
    let wide = frame.grown(MARGIN);
    let members = Member::BOTH;
    let names = members.map(|member| format!("{id}-{}", member.name()));
    let metal = members.map(|member| {
        let turned = turned(pair, pose, member, rotation);
        let points = pair.outline(member, turned, view.chord());
        let spots: Vec<Spot> = points.iter().map(|point| view.spot(*point)).collect();
        clip::polygon(&spots, &wide)
    });
    let mut group = clipped(frame, (id, ids), &names, &metal);
    for (name, fill) in names.iter().zip([WHEEL, PINION]) {
        group = group.add(area(ids, name).set("fill", fill));
    }
    let both = |fill: &str| within_area(ids, &names[0]).add(area(ids, &names[1]).set("fill", fill));
    let mut over = Vec::new();
    group = group.add(both(OVERLAP)).add(both(&ids.url("hatch")));
    for (member, name) in members.into_iter().zip(&names) {
        let stroke = area(ids, name).set("fill", "none").set("stroke", INK);
        group = group.add(stroke.set("stroke-width", STROKE));
        let circle = view.arc(pair.axis(member), pair.operating_pitch_radius(member));
        for run in clip::runs(&circle, &wide) {
            group = group.add(line(&run, GREY, 1.1).set("stroke-dasharray", PITCH_DASH));
            over.push(run);
        }
    }
    let axes = members.map(|member| view.spot(pair.axis(member)));
    if let Some(centres) = clip::segment(axes[0], axes[1], &wide) {
        group = group.add(line(&centres, GREY, 1.1).set("stroke-dasharray", CENTRES_DASH));
        over.push(centres.to_vec());
    }
    DrawnGears { group, metal, over }
}

/// The contact point, and its normal out of the wheel.
fn mark(contact: &Contact, view: &View, length: f64, occupied: &mut Occupied) -> Group {
    let spot = view.spot(contact.point);
    // y is down on the sheet.
    let tip = [
        spot[0] + length * contact.normal.x,
        spot[1] - length * contact.normal.y,
    ];
    occupied.line(&[spot, tip]);
    occupied.frame(around(spot, 4.5));
    Group::new()
        .add(arrow(spot, tip, 1.8))
        .add(dot(spot, 4.5, true))
}

fn names(pair: &OutlinePair, main: &Frame) -> Group {
    let name = |member: Member| {
        let role = if member == pair.locked() {
            "locked"
        } else {
            "free"
        };
        format!(
            "{} ({role}), z = {}",
            member.name(),
            pair.gear(member).teeth()
        )
    };
    let (style, y) = (TextStyle::new(14.0), main.top - 8.0);
    let Frame { left, right, .. } = *main;
    Group::new()
        .add(style.text(&name(Member::Wheel), [left, y]))
        .add(style.end().text(&name(Member::Pinion), [right, y]))
}

fn caption(
    title: &str,
    pair: &OutlinePair,
    material: Material,
    pose: &PoseResult,
    held: bool,
) -> Group {
    let (left, room) = (SHEET.main.left, SHEET.room());
    let what = match (pose.status(), pose.backlash.zip(pose.error_bound)) {
        (status, Some((value, error))) => {
            format!("j_wt = {} · {}", um_bounded(value, error), status.name())
        }
        (Status::Jammed, None) => "jammed: a tip sits in a root".to_owned(),
        (Status::Unproven, None) => "not settled".to_owned(),
        (_, None) => "no contact: out of mesh".to_owned(),
    };
    let drawn = match held {
        true => format!("drawn with the {} in contact", pair.free().name()),
        false => format!(
            "drawn with the {} at its nominal rotation",
            pair.free().name()
        ),
    };
    let where_to = format!(
        "wheel tooth {} and pinion tooth {}, {} of a pitch on · centre distance {} mm · {}",
        pose.pose.mating().wheel_tooth,
        pose.pose.mating().pinion_tooth,
        trimmed(pose.pose.mating().fraction, 1, 4),
        trimmed(pair.center_distance(), 3, 6),
        material.words()
    );
    let (heading, second) = (TextStyle::new(24.0).bold(), TextStyle::new(16.0));
    Group::new()
        .add(heading.verbatim(&heading.shortened(title, room), [left, 46.0]))
        .add(
            second
                .grey()
                .text(&second.shortened(&where_to, room), [left, 73.0]),
        )
        .add(second.text(
            &second.shortened(&format!("{what} · {drawn}"), room),
            [left, 97.0],
        ))
}

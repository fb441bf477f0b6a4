//! Both gears in one view: metal, gap, overlap, circles, lines of action.

use super::contacts;
use super::view::{MARGIN, View};
use crate::kit::{
    self, ACTION, GAP, GREY, INK, Ids, OVERLAP, Occupied, PATH, PINION, Spot, WHEEL, area, clip,
    clipped, dashed, define_area, define_frame, inner_outline, line, polygon, within_area,
};
use gearlash::contact::{DrawnContact, Scene};
use gearlash::gear::Side;
use gearlash::pair::Member;
use svg::node::element::Group;

/// The drawing of a view's gears, and their polygons, wheel first.
pub struct Gears {
    pub group: Group,
    pub metal: [Vec<Spot>; 2],
}

#[derive(Debug, Clone, Copy)]
pub struct Look<'a> {
    /// Distinguishes the definitions of one view from another's.
    pub id: &'a str,
    pub ids: &'a Ids,
    pub sides: &'a [Side],
    /// Whether outlines are drawn over an overlap, or the overlap over them.
    pub outlines_last: bool,
    pub band: f64,
}

/// Draws the gears of `scene` into `view`.
///
/// Outlines are stroked on their metal's side only, so that a gap keeps its true width. The overlap is the pinion's metal clipped
/// by the wheel's.
pub fn draw(scene: &Scene, view: &View, look: &Look, occupied: &mut Occupied) -> Gears {
    let (id, ids) = (look.id, look.ids);
    let frame = &view.frame;
    let wide = frame.grown(MARGIN);
    let names = Member::BOTH.map(|member| format!("{id}-{}", member.name()));
    let metal = Member::BOTH.map(|member| {
        let placed = scene.placed(member);
        let outline = placed.outline_near(view.middle, view.reach(), view.chord());
        clip::polygon(&view.spots(&outline), &wide)
    });
    metal.iter().for_each(|polygon| occupied.line(polygon));
    let limit = format!("{id}-frame");
    let mut definitions = define_frame(ids, &limit, frame);
    for (polygon, name) in metal.iter().zip(&names) {
        definitions = define_area(definitions, ids, name, polygon);
    }
    let mut group = clipped(ids, &limit)
        .add(definitions)
        .add(frame.rectangle().set("fill", "white"));
    for contact in scene.contacts() {
        // The gap area ends at whole chords; a finer chord keeps its ends in place.
        let room = scene.room_between(contact, view.chord() / 16.0);
        let room = clip::polygon(&view.spots(&room), &wide);
        if !room.is_empty() {
            group = group.add(polygon(&room, GAP));
        }
    }
    for (name, fill) in names.iter().zip([WHEEL, PINION]) {
        group = group.add(area(ids, name).set("fill", fill));
    }
    let shown = |contact: &&DrawnContact| look.sides.contains(&contact.side);
    let outlines = names
        .each_ref()
        .map(|name| inner_outline(ids, name, INK, "2.40"));
    let overlap = [OVERLAP.to_owned(), ids.url("hatch")]
        .map(|fill| within_area(ids, &names[0]).add(area(ids, &names[1]).set("fill", fill)));
    let touching = scene.contacts().iter().filter(shown);
    let id = ids.of(id);
    let bands = touching.map(|contact| contacts::bands(scene, contact, view, &id, look.band));
    let bands = kit::group(bands);
    let [outlines, overlap] = [outlines, overlap].map(kit::group);
    let layers = if look.outlines_last {
        [overlap, bands, outlines]
    } else {
        [bands, outlines, overlap]
    };
    group = layers.into_iter().fold(group, Group::add);
    group = lines_over(scene, view, look.sides, group, occupied);
    for contact in scene.contacts().iter().filter(shown) {
        group = group.add(contacts::limits(scene, contact, view, occupied));
    }
    Gears { group, metal }
}

/// Pitch and base circles, line of centres, lines of action with the paths of contact.
pub fn lines_over(
    scene: &Scene,
    view: &View,
    sides: &[Side],
    mut group: Group,
    occupied: &mut Occupied,
) -> Group {
    let wide = view.frame.grown(MARGIN);
    for member in Member::BOTH {
        let placed = scene.placed(member);
        let pitch = scene.assembly().operating_pitch_radius(member);
        let base = placed.base_radius();
        let pitch = (placed.axis(), pitch, PITCH_DASH);
        let base = base.map(|base| (placed.centre(), base, BASE_DASH));
        for (centre, radius, dash) in [Some(pitch), base].into_iter().flatten() {
            for run in clip::runs(&view.arc(centre, radius), &wide) {
                occupied.line(&run);
                group = group.add(dashed(&run, GREY, 1.1, dash));
            }
        }
    }
    let axes = Member::BOTH.map(|member| view.spot(scene.assembly().axis(member)));
    if let Some(centres) = clip::segment(axes[0], axes[1], &wide) {
        occupied.line(&centres);
        group = group.add(dashed(&centres, GREY, 1.1, CENTRES_DASH));
    }
    for side in sides {
        let Some(action) = scene.line_of_action(*side) else {
            continue;
        };
        if let Some([from, to]) = action.path {
            let ends = [view.spot(from), view.spot(to)];
            if let Some(path) = clip::segment(ends[0], ends[1], &wide) {
                occupied.line(&path);
                let path = line(&path, PATH, 6.0).set("stroke-linecap", "round");
                group = group.add(path.set("stroke-opacity", "0.75"));
            }
        }
        let ends = action.ends.map(|end| view.spot(end));
        if let Some(whole) = clip::segment(ends[0], ends[1], &wide) {
            occupied.line(&whole);
            group = group.add(line(&whole, ACTION, 1.2));
        }
    }
    group
}

pub const PITCH_DASH: &str = "14 3 2 3";
pub const BASE_DASH: &str = "5 4";
pub const CENTRES_DASH: &str = "22 4 2 4 2 4";

//! A contact, enlarged until its gap is visible.

use super::contacts::{self, IN_INSET};
use super::gears::{self, Look};
use super::labels::{centred, overlap_label};
use super::subject::Snapshot;
use super::view::View;
use crate::kit::{self, Frame, GREY, INK, Ids, Occupied, Spot, TextStyle, clip, line, scale};
use crate::pose_name::flank_heading;
use gearlash::contact::{
    Contact, ContactClass, ContactKind, DrawnContact, FreePlacement, Scene, Status,
};
use gearlash::gear::{ProfilePart, Side};
use gearlash::pair::{GearPair, Member};
use gearlash_text::numbers::um;
use nalgebra::center;
use svg::node::element::{Element, Group, Rectangle};

/// Greatest width of a gap in an inset, units of the sheet. With steps of 2 and 2.5 no gap is drawn narrower than 36, 9 mm of
/// paper.
const GAP_WIDTH: f64 = 90.0;
/// Greatest enlargement of a closed contact relative to the main view: both flanks visibly curve away.
const ENLARGEMENT: f64 = 12.0;
const LEAST: f64 = 2.0;
/// Greatest enlargement, units per millimetre: 1 µm is then 40 units, and the contact's own error is visible.
const GREATEST: f64 = 40_000.0;
const SMALLEST: f64 = 9.0;
const SIZE: f64 = 14.0;

/// The view of one contact in `frame`, for a main view at `main` units per millimetre.
pub fn view(contact: &DrawnContact, frame: Frame, main: f64) -> View {
    let separation = (contact.on_free - contact.on_locked).norm();
    let wanted = if contact.turn != 0.0 {
        (GAP_WIDTH / separation).clamp(LEAST * main, GREATEST.max(LEAST * main))
    } else {
        ENLARGEMENT * main
    };
    let middle = center(&contact.on_locked, &contact.on_free);
    View::at_most(frame, middle, wanted, scale::ISO_5455)
}

/// The enlarged contact with its frame and the gears' names.
pub fn draw(scene: &Scene, contact: &DrawnContact, view: &View, ids: &Ids) -> Group {
    let mut occupied = Occupied::default();
    let id = contact.side.name();
    let look = Look {
        id,
        ids,
        sides: &[contact.side],
        outlines_last: true,
        band: contacts::BANDS[1],
    };
    let gears = gears::draw(scene, view, &look, &mut occupied);
    let mark = contacts::marks(contact, view, IN_INSET, &mut occupied)
        .set("clip-path", ids.url(&format!("{id}-frame")));
    let label = overlap_label(scene, contact, view, &mut occupied);
    let teeth = [contact.contact.wheel.tooth, contact.contact.pinion.tooth];
    let drawn = Group::new().add(gears.group).add(mark).add(label);
    let names = names(teeth, &gears.metal, view, &mut occupied);
    let drawn = names.into_iter().fold(drawn, Group::add);
    drawn.add(view.frame.border())
}

/// Names of wheel and pinion with these tooth numbers, each on its own metal where there is room.
pub fn names(
    teeth: [u32; 2],
    [wheel, pinion]: &[Vec<Spot>; 2],
    view: &View,
    occupied: &mut Occupied,
) -> Vec<Element> {
    let names = ["wheel", "pinion"].into_iter().zip(teeth);
    let mut placed = Vec::new();
    for ((name, tooth), metal) in names.zip([[wheel, pinion], [pinion, wheel]]) {
        let name = format!("{name} {tooth}");
        if let Some(room) = place(&name, metal, view, occupied) {
            occupied.frame(room);
            placed.push(centred(&name, &room, SIZE, false));
        }
    }
    placed
}

pub fn empty(frame: Frame) -> Rectangle {
    let empty = frame.painted("#f4f5f6", GREY, "1.00");
    empty.set("stroke-dasharray", "6 4")
}

pub fn heading(
    view: &Snapshot,
    scene: &Scene,
    side: Side,
    contact: Option<&DrawnContact>,
    frame: &Frame,
) -> Group {
    let Frame { left, top, .. } = *frame;
    let name = flank_heading(side);
    let (first, second) = match contact {
        None => (
            format!("{name} flanks: no contact"),
            match scene.status() {
                Status::Unproven => "not proven: none is drawn".to_owned(),
                _ => "out of mesh on this side".to_owned(),
            },
        ),
        Some(contact) => {
            let gap = contact.gap;
            let length = um(gap, 2);
            let pair = view.assembly;
            // In a transverse section the line of action is in that section, and another section can be tighter.
            let (symbol, here) = match scene.placed(Member::Wheel).base_radius() {
                None => ("", " along the normal"),
                Some(_) if pair.is_helical() => ("j_bt = ", " in this section"),
                Some(_) if pair.varies_along_face() => ("j_bn = ", " in this section"),
                Some(_) => ("j_bn = ", ""),
            };
            let first = match scene.free_placement() {
                _ if contact.turn == 0.0 => format!("{name} flanks touch"),
                FreePlacement::AtContact(_) if gap > 0.0 => {
                    format!("{name} flanks: gap {symbol}{length} µm{here}")
                }
                FreePlacement::AtContact(_) => {
                    format!("{name} flanks: overlap, {symbol}{length} µm{here}")
                }
                FreePlacement::Nominal if gap >= 0.0 => {
                    format!("{name} flanks, short of their contact")
                }
                FreePlacement::Nominal => format!("{name} flanks, past their contact"),
            };
            let pair = scene.assembly().data();
            let edge = pair.and_then(|pair| edge(pair, side, &contact.contact));
            let touches = Member::BOTH.map(|member| {
                let touch = contact.touch(member);
                let curve = if edge == Some(member) {
                    "undercut edge"
                } else {
                    touch.curve.name()
                };
                format!("{} {} {curve}", member.name(), touch.tooth)
            });
            (first, touches.join(" on "))
        }
    };
    let room = frame.width();
    let title = TextStyle::new(16.0).bold().fitted(&first, room, SMALLEST);
    let details = TextStyle::new(13.0).grey().fitted(&second, room, SMALLEST);
    Group::new()
        .add(title.text(&first, [left, top - 27.0]))
        .add(details.text(&second, [left, top - 9.0]))
}

/// The gear whose undercut edge touches; of two undercut gears the one touched nearer to the foot of its involute.
fn edge(assembly: &GearPair, side: Side, contact: &Contact) -> Option<Member> {
    if ContactClass::of(assembly, side, contact).kind != ContactKind::Edge {
        return None;
    }
    let above_foot = |member: Member| {
        let gear = assembly.gear(member).gear();
        let touch = contact.touch(member);
        let involute = touch.curve == ProfilePart::Involute && gear.is_undercut();
        involute.then_some((member, touch.radius - gear.form_radius()))
    };
    let touched = Member::BOTH.into_iter().filter_map(above_foot);
    let nearest = touched.min_by(|a, b| a.1.total_cmp(&b.1));
    nearest.map(|(member, _)| member)
}

/// A free place for `name` on the first `metal` and off the other. It is well clear of all that is drawn where that is possible, and of
/// such places the nearest to the middle.
fn place(name: &str, metal: [&Vec<Spot>; 2], view: &View, occupied: &Occupied) -> Option<Frame> {
    let inner = view.frame.grown(-8.0);
    let middle = view.frame.middle();
    let size = kit::room(name, SIZE, middle);
    let (dx, dy) = (0.5 * size.width(), 0.5 * size.height());
    let steps =
        |low: f64, high: f64| (0..=16).map(move |i| low + (high - low) * f64::from(i) / 16.0);
    let spots: Vec<Spot> = steps(inner.top + dy, inner.bottom - dy)
        .flat_map(|y| steps(inner.left + dx, inner.right - dx).map(move |x| [x, y]))
        .filter(|spot| contains(metal[0], *spot) && !contains(metal[1], *spot))
        .collect();
    let far = |spot: &Spot| (spot[0] - middle[0]).hypot(spot[1] - middle[1]);
    [16.0, 8.0, kit::CLEAR].into_iter().find_map(|clear| {
        let free = spots
            .iter()
            .filter(|spot| occupied.is_clear(&kit::room(name, SIZE, **spot), clear));
        free.min_by(|a, b| far(a).total_cmp(&far(b)))
            .map(|spot| kit::room(name, SIZE, *spot))
    })
}

/// Whether a place is inside a closed polygon: a ray to the right crosses it an odd number of times.
fn contains(polygon: &[Spot], [x, y]: Spot) -> bool {
    let crossings = clip::crossings(polygon, y).into_iter();
    crossings.filter(|crossing| x < *crossing).count() % 2 == 1
}

/// Connects an inset to its place in the main view.
#[derive(Debug, Clone, Copy)]
pub struct Link {
    /// The area of the inset in the main view, or a larger box of its shape where that would be too small to see.
    pub shown: Frame,
    inset: Frame,
}

impl Link {
    /// Connects the area of `enlarged` to its place in `main`.
    pub fn new(main: &View, enlarged: &View) -> Link {
        let inset = enlarged.frame;
        let half = f64::max(0.5 * inset.width() * main.scale / enlarged.scale, 14.0);
        let [x, y] = main.spot(enlarged.middle);
        let rise = half * inset.height() / inset.width();
        Link {
            shown: Frame::new([x - half, y - rise], [x + half, y + rise]),
            inset,
        }
    }

    /// The box; and `with_leader` a leader from it to the side of the inset. Candidates go from the middle of that side outwards;
    /// the first that crosses none of the `taken` rooms is drawn.
    pub fn draw(&self, taken: &[Frame], with_leader: bool) -> Group {
        let shown = Group::new().add(self.shown.border().set("stroke-width", "1.00"));
        if !with_leader {
            return shown;
        }
        let from = self.shown.middle();
        let leaders = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9].map(|part| {
            let to = [self.inset.left, self.inset.top + part * self.inset.height()];
            let along = [0, 1].map(|i| to[i] - from[i]);
            let size = [self.shown.width(), self.shown.height()];
            let leave = [0, 1].map(|i| 0.5 * size[i] / along[i].abs());
            let leave = f64::min(leave[0], leave[1]);
            [[0, 1].map(|i| from[i] + leave * along[i]), to]
        });
        let is_clear = |[from, to]: &&[Spot; 2]| {
            let crosses = |room: &Frame| clip::segment(*from, *to, &room.grown(6.0)).is_some();
            !taken.iter().any(crosses)
        };
        let leader = leaders.iter().find(is_clear).unwrap_or(&leaders[0]);
        shown.add(line(leader, INK, 1.0))
    }
}

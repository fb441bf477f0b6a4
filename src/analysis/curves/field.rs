//! The field of action of helical gears at one pose: over the common face and along the path of contact, where their tooth pairs touch.
//!
//! In every transverse section involutes touch on the line of action, the common tangent of the displaced base circles, which is the same in
//! all sections: centres do not wind. A pair's contact runs along it as the teeth wind: with `b` mm along the face its roll on the wheel
//! falls by `τ_1 b`, and its place on the path,
//!
//! ```text
//! s = r_b1 ξ_1 − T r_b1/(r_b1 + r_b2),
//! ```
//!
//! counted from the pitch point towards the pinion's end of the tangent of length `T`, changes by `∓ tan β_b` a mm: a straight line.

use crate::analytic::SideContact;
use crate::contact::{Contact, ContactClass, ContactKind, ExactKernel, LostMotion, PoseResult};
use crate::gear::{Placed, Side};
use crate::pair::{GearPair, Member, Pose};
use nalgebra::{UnitComplex, Vector2};
use std::f64::consts::TAU;

/// Spaces between the sections that are looked at (tuned: a pixel or two of a chart each, where no fillet is touched in fewer).
const SPACES: u32 = 160;

/// The field of action at a pose, each side with the free gear held there.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Field {
    /// The pose.
    pub pose: Pose,
    /// Ends of the common face, mm from the measuring plane.
    pub face: [f64; 2],
    /// Right and left contact.
    pub sides: [FieldSide; 2],
}

/// One side of it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FieldSide {
    /// Its flanks.
    pub side: Side,
    /// Ends of the path of contact, mm from the pitch point.
    pub path: [f64; 2],
    /// What ends it there.
    pub limits: [PathLimit; 2],
    /// The contact line of every pair that has one on the face, in the order of the locked teeth.
    pub lines: Vec<ContactLine>,
    /// What holds the free gear.
    pub binding: BindingContact,
    /// Section by section, ascending.
    pub sections: Vec<FieldSection>,
}

/// What ends the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PathLimit {
    /// The tip circle of this gear.
    Tip(Member),
    /// The form circle of this gear, below which its flank is no involute.
    Form(Member),
}

/// Where the involutes of a tooth pair touch, or would after a further turn of the free gear.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ContactLine {
    /// Wheel tooth.
    pub wheel_tooth: u32,
    /// Pinion tooth.
    pub pinion_tooth: u32,
    /// Both ends: mm along the face, mm along the path.
    pub ends: [[f64; 2]; 2],
    /// Room that is left between the flanks along the line of action, mm: 0 of the pair that binds.
    pub gap: f64,
    /// Whether its teeth hold the free gear.
    pub binds: bool,
}

/// The contact that holds the free gear.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BindingContact {
    /// Wheel tooth.
    pub wheel_tooth: u32,
    /// Pinion tooth.
    pub pinion_tooth: u32,
    /// Where along the face, mm.
    pub section: f64,
    /// Where along the path, mm: of a contact beside the line of action, the foot of its perpendicular.
    pub place: f64,
    /// What touches.
    pub kind: ContactKind,
}

/// What the teeth of one section would allow alone.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FieldSection {
    /// Where along the face, mm.
    pub at: f64,
    /// How much farther, along the line of action, the free gear could turn if there were this section alone, mm; `None` where nothing touches in it.
    pub gap: Option<f64>,
    /// What would touch.
    pub kind: Option<ContactKind>,
}

impl Field {
    /// The field of action of helical gears at `pose`; `None` of spur gears, and where no lost motion is proven or the displaced base circles overlap.
    pub fn of(assembly: &GearPair, pose: &PoseResult) -> Option<Field> {
        let found = pose.proven().filter(|found| found.angle().is_some())?;
        if !assembly.is_helical() {
            return None;
        }
        let sections = alone(assembly, &pose.pose, found);
        let side = |side: Side| {
            let contact = on(found, side)?;
            FieldSide::new(assembly, &pose.pose, side, &contact, &sections)
        };
        Some(Field {
            pose: pose.pose,
            face: assembly.face(),
            sides: [side(Side::Right)?, side(Side::Left)?],
        })
    }
}

fn on(found: &LostMotion, side: Side) -> Option<Contact> {
    match side {
        Side::Right => found.right,
        Side::Left => found.left,
    }
}

/// A section of the pair, the pose in it, and what it would come to alone.
struct Alone {
    at: f64,
    pair: GearPair,
    pose: Pose,
    found: Option<LostMotion>,
}

/// Sections spread over the face, and those that hold the free gear.
fn alone(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Vec<Alone> {
    let [from, to] = assembly.face();
    let spread = (0..=SPACES).map(|k| from + (to - from) * (f64::from(k) / f64::from(SPACES)));
    let holding = Side::BOTH.into_iter().filter_map(|side| on(found, side));
    let mut places: Vec<f64> = spread.chain(holding.map(|c| c.section)).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let section = |at: &f64| {
        let (pair, here) = (assembly.section(*at), pose.in_section(assembly, *at));
        Alone {
            at: *at,
            found: ExactKernel::new(&pair).lost_motion(&here).ok(),
            pair,
            pose: here,
        }
    };
    places.iter().map(section).collect()
}

impl FieldSide {
    fn new(
        assembly: &GearPair,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        sections: &[Alone],
    ) -> Option<FieldSide> {
        let tangent = Tangent::new(assembly, pose, side, contact.rotation)?;
        let (path, limits) = tangent.path(assembly);
        let teeth = (contact.wheel.tooth, contact.pinion.tooth);
        let radius = assembly.gear(assembly.free()).gear().base_radius();
        // How far beyond the contact, along the line of action.
        let gap = |turn: f64| side.sense() * wrapped(turn) * radius;
        let slope = side.sense() * tangent.base[0] * basic_twist(assembly);
        let lines = SideContact::all(assembly, pose, side).filter_map(|line| {
            let (wheel, pinion) = by_member(assembly, line.locked_tooth, line.free_tooth);
            let rolls = by_member(assembly, line.locked_roll, line.free_roll);
            let place = tangent.place([rolls.0, rolls.1]);
            let ends = clipped(line.section, place, slope, assembly.face(), path)?;
            Some(ContactLine {
                wheel_tooth: wheel,
                pinion_tooth: pinion,
                ends,
                gap: gap(line.rotation - contact.rotation),
                binds: (wheel, pinion) == teeth,
            })
        });
        let sections = sections.iter().map(|alone| {
            let touching = alone.found.as_ref().and_then(|found| on(found, side));
            let turn = |here: Contact| {
                let beyond = here.rotation - alone.pose.free_rotation();
                gap(beyond - (contact.rotation - pose.free_rotation()))
            };
            FieldSection {
                at: alone.at,
                gap: touching.map(turn),
                kind: touching.map(|here| ContactClass::of(&alone.pair, side, &here).kind),
            }
        });
        Some(FieldSide {
            side,
            path,
            limits,
            lines: lines.collect(),
            binding: BindingContact {
                wheel_tooth: teeth.0,
                pinion_tooth: teeth.1,
                section: contact.section,
                place: tangent.foot(contact),
                kind: ContactClass::of(assembly, side, contact).kind,
            },
            sections: sections.collect(),
        })
    }
}

/// The common tangent of the displaced base circles.
struct Tangent {
    /// Base radii of wheel and pinion, mm.
    base: [f64; 2],
    /// Its length, mm.
    length: f64,
    /// From the origin to the pitch point on it, mm.
    pitch_point: Vector2<f64>,
    /// From the wheel's end to the pinion's.
    direction: Vector2<f64>,
}

impl Tangent {
    /// That of `side` with the free gear at `rotation`; `None` where the base circles overlap.
    fn new(assembly: &GearPair, pose: &Pose, side: Side, rotation: f64) -> Option<Tangent> {
        let centre = |member: Member| {
            let turned = match member == assembly.locked() {
                true => pose.locked_rotation(),
                false => rotation,
            };
            let tooth_1 = assembly.mate_direction(member) + turned;
            Placed::new(assembly.gear(member), assembly.axis(member), tooth_1).centre()
        };
        let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(centre);
        let base = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m).gear().base_radius());
        let between = pinion - wheel;
        let (distance, sum) = (between.norm(), base[0] + base[1]);
        if distance <= sum {
            return None;
        }
        // As in `Scene::line_of_action`.
        let radial =
            UnitComplex::new(-side.sense() * (sum / distance).acos()) * (between / distance);
        let ends = [wheel + base[0] * radial, pinion - base[1] * radial];
        let along = ends[1] - ends[0];
        let length = ((distance - sum) * (distance + sum)).sqrt();
        Some(Tangent {
            base,
            length,
            pitch_point: ends[0].coords + along * (base[0] / sum),
            direction: along / length,
        })
    }

    /// The part of the wheel in lengths from one end to the other.
    fn share(&self) -> f64 {
        self.base[0] / (self.base[0] + self.base[1])
    }

    /// Where a contact with these rolls of wheel and pinion is, mm from the pitch point.
    fn place(&self, rolls: [f64; 2]) -> f64 {
        let arms = [self.base[0] * rolls[0], self.base[1] * rolls[1]];
        arms[0] - (arms[0] + arms[1]) * self.share()
    }

    /// The foot of the perpendicular from a contact.
    fn foot(&self, contact: &Contact) -> f64 {
        (contact.point.coords - self.pitch_point).dot(&self.direction)
    }

    /// Both ends of the path of contact, mm from the pitch point, and what they are.
    fn path(&self, assembly: &GearPair) -> ([f64; 2], [PathLimit; 2]) {
        let arms = |member: Member, base: f64| {
            let gear = assembly.gear(member).gear();
            [gear.form_roll(), gear.tip_roll()].map(|roll| base * roll)
        };
        let [form_1, tip_1] = arms(Member::Wheel, self.base[0]);
        let [form_2, tip_2] = arms(Member::Pinion, self.base[1]).map(|arm| self.length - arm);
        let (low, begins) = match tip_2 >= form_1 {
            true => (tip_2, PathLimit::Tip(Member::Pinion)),
            false => (form_1, PathLimit::Form(Member::Wheel)),
        };
        let (high, ends) = match tip_1 <= form_2 {
            true => (tip_1, PathLimit::Tip(Member::Wheel)),
            false => (form_2, PathLimit::Form(Member::Pinion)),
        };
        let origin = self.length * self.share();
        ([low - origin, high - origin], [begins, ends])
    }
}

fn basic_twist(assembly: &GearPair) -> f64 {
    assembly.gear(Member::Wheel).gear().basic_data().twist()
}

/// Of wheel and pinion, what is of the locked and of the free gear.
fn by_member<T>(assembly: &GearPair, locked: T, free: T) -> (T, T) {
    match assembly.locked() {
        Member::Wheel => (locked, free),
        Member::Pinion => (free, locked),
    }
}

/// The line through `place` at `at`, with this slope, as far as face and path go; `None` where it only grazes them by rounding.
fn clipped(
    at: f64,
    place: f64,
    slope: f64,
    face: [f64; 2],
    path: [f64; 2],
) -> Option<[[f64; 2]; 2]> {
    let on_path = path.map(|end| at + (end - place) / slope);
    let from = face[0].max(on_path[0].min(on_path[1]));
    let to = face[1].min(on_path[0].max(on_path[1]));
    (from <= to).then(|| [from, to].map(|b| [b, place + slope * (b - at)]))
}

fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

//! The content of a picture of one pose, in mm of the picture frame: both gears, their contacts, the lines of action.
//!
//! The free gear is drawn in contact on the mating's flank, so that the whole lost motion is open on the other side. A
//! pose without lost motion is drawn at the nominal rotation.

use super::overlap::{Overlap, overlaps};
use super::{DrawnContact, LostMotion, MeshSection, Status};
use crate::gear::Side;
use crate::outline::{AssembledPair, PlacedGear};
use crate::pair::{Member, Pose};
use nalgebra::{Point2, UnitComplex, center};

/// The position in which the free gear is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FreePlacement {
    /// In contact on this flank.
    AtContact(Side),
    /// At the pose's nominal rotation, without a lost motion.
    Nominal,
}

/// The line on which involutes touch on one side: the common tangent of both base circles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineOfAction {
    /// The flanks that touch on it.
    pub side: Side,
    /// Its tangent points on the wheel's and the pinion's base circle, mm.
    pub ends: [Point2<f64>; 2],
    /// The path of contact, between the tip circles; `None` out of mesh.
    pub path: Option<[Point2<f64>; 2]>,
}

/// Chordal error of the outline of an overlap, as a part of the tooth depth.
const FINE: f64 = 1.0 / 2000.0;
/// Distance around a contact within which its overlap is searched, modules: a tooth is 2.25 deep.
const REACH: f64 = 3.0;

/// The pose as drawn.
#[derive(Debug, Clone)]
pub struct Scene<'a> {
    assembly: &'a AssembledPair,
    wheel: PlacedGear<'a>,
    pinion: PlacedGear<'a>,
    free_placement: FreePlacement,
    contacts: Vec<DrawnContact>,
    lost_motion: Option<&'a LostMotion>,
}

impl<'a> Scene<'a> {
    /// The scene of `pose` with its `lost_motion`.
    pub fn new(assembly: &'a AssembledPair, pose: &Pose, lost_motion: &'a LostMotion) -> Scene<'a> {
        Scene::of(assembly, pose, Some(lost_motion))
    }

    /// The scene of a `pose` whose contacts are unproven: both gears without contacts.
    pub fn unproven(assembly: &'a AssembledPair, pose: &Pose) -> Scene<'a> {
        Scene::of(assembly, pose, None)
    }

    /// The scene of one section of helical gears. The whole face determines the free gear's rotation; the teeth of the
    /// section may be apart.
    pub fn in_section(section: &'a MeshSection) -> Scene<'a> {
        let flank = section.pose().mating().flank;
        let held = match section.held() {
            Some(rotation) => (FreePlacement::AtContact(flank), rotation),
            None => (FreePlacement::Nominal, section.pose().free_rotation()),
        };
        Scene::at_rotation(section.pair(), section.pose(), section.alone(), held)
    }

    fn of(
        assembly: &'a AssembledPair,
        pose: &Pose,
        lost_motion: Option<&'a LostMotion>,
    ) -> Scene<'a> {
        let flank = pose.mating().flank;
        let on = |side| lost_motion.and_then(|found| found.on(side));
        let angle = lost_motion.and_then(LostMotion::angle);
        let held = match (angle, on(flank)) {
            (Some(_), Some(contact)) => (FreePlacement::AtContact(flank), contact.rotation),
            _ => (FreePlacement::Nominal, pose.free_rotation()),
        };
        Scene::at_rotation(assembly, pose, lost_motion, held)
    }

    /// The free gear at a rotation.
    fn at_rotation(
        assembly: &'a AssembledPair,
        pose: &Pose,
        lost_motion: Option<&'a LostMotion>,
        (free_placement, rotation): (FreePlacement, f64),
    ) -> Scene<'a> {
        let on = |side| lost_motion.and_then(|found| found.on(side));
        let place = |member| {
            let turned = if member == assembly.locked() {
                pose.locked_rotation()
            } else {
                rotation
            };
            PlacedGear::new(assembly, member, turned)
        };
        Scene {
            assembly,
            wheel: place(Member::Wheel),
            pinion: place(Member::Pinion),
            free_placement,
            contacts: Side::BOTH
                .into_iter()
                .filter_map(|side| Some(DrawnContact::new(assembly, side, on(side)?, rotation)))
                .collect(),
            lost_motion,
        }
    }

    /// The pair.
    pub fn assembly(&self) -> &'a AssembledPair {
        self.assembly
    }

    /// One of the gears at its position.
    pub fn placed(&self, member: Member) -> &PlacedGear<'a> {
        match member {
            Member::Wheel => &self.wheel,
            Member::Pinion => &self.pinion,
        }
    }

    /// Module of the gears, mm; for a drawn pair that of its operating pitch circles.
    pub fn module(&self) -> f64 {
        self.assembly.module()
    }

    /// The position in which the free gear is drawn.
    pub fn free_placement(&self) -> FreePlacement {
        self.free_placement
    }

    /// The contacts, right first.
    pub fn contacts(&self) -> &[DrawnContact] {
        &self.contacts
    }

    /// The space between the two flanks of `contact`, a closed polygon in mm with chords within `chordal_error` mm. It
    /// is empty if they overlap, and for a drawn pair.
    ///
    /// It includes the part of each flank that is inside the mate's tip circle at contact.
    pub fn room_between(&self, contact: &DrawnContact, chordal_error: f64) -> Vec<Point2<f64>> {
        if contact.gap <= 0.0 {
            return Vec::new();
        }
        let at_contact = |member| {
            let placed = self.placed(member).data()?;
            Some(if member == self.assembly.free() {
                placed.turned(contact.turn)
            } else {
                *placed
            })
        };
        let flank = |member: Member, tooth| {
            let both = at_contact(member).zip(at_contact(member.mate()));
            let (Some((placed, mate)), Some(drawn)) = (both, self.placed(member).data()) else {
                return Vec::new();
            };
            let tip = mate.as_built().gear().tip_radius();
            let is_inside = |point: &Point2<f64>| (point - mate.centre()).norm() <= tip;
            let touching = placed.flank(contact.side, tooth, chordal_error);
            let drawn = drawn.flank(contact.side, tooth, chordal_error);
            let pairs = drawn.into_iter().zip(touching);
            pairs
                .filter(|(_, touching)| is_inside(touching))
                .map(|(drawn, _)| drawn)
                .collect::<Vec<_>>()
        };
        // Both run from tip to root, and the tip of each is near the root of the other.
        let mut room = flank(Member::Wheel, contact.contact.wheel.tooth);
        room.extend(flank(Member::Pinion, contact.contact.pinion.tooth));
        room
    }

    /// The metal in both gears at `contact`, nearest its points; `None` if they do not overlap there.
    ///
    /// The outlines have chords within a two-thousandth of the depth, which keeps the area of a thin piece accurate to a few thousandths.
    pub fn overlap(&self, contact: &DrawnContact) -> Option<Overlap> {
        if contact.gap >= 0.0 {
            return None;
        }
        let module = self.module();
        let chordal_error = (-contact.along_normal * FINE).clamp(1e-8 * module, 1e-5 * module);
        let place = center(&contact.on_locked, &contact.on_free);
        let outline =
            |placed: &PlacedGear| placed.outline_near(place, REACH * module, chordal_error);
        let pieces = overlaps(&outline(&self.wheel), &outline(&self.pinion));
        // Where flanks only touch, their chords may cross by both chordal errors.
        let real = pieces
            .into_iter()
            .filter(|piece| piece.width() > 2.0 * chordal_error);
        real.min_by(|a, b| a.distance(place).total_cmp(&b.distance(place)))
    }

    /// The status of the pose.
    pub fn status(&self) -> Status {
        self.lost_motion
            .map_or(Status::Unproven, LostMotion::status)
    }

    /// Circumferential backlash `j_wt = φ_j r_w` of the free gear and the bound on its error, mm.
    pub fn circumferential_backlash(&self) -> Option<(f64, f64)> {
        let radius = self.assembly.operating_pitch_radius(self.assembly.free());
        Some((
            self.lost_motion?.angle()? * radius,
            self.lost_motion?.error()? * radius,
        ))
    }

    /// The operating pitch point, mm.
    pub fn pitch_point(&self) -> Point2<f64> {
        Point2::new(self.assembly.operating_pitch_radius(Member::Wheel), 0.0)
    }

    /// The line of action of `side`; `None` if eccentric base circles overlap, and for drawn gears. Profile deviations are too
    /// small to bend it.
    ///
    /// The centres are `D` apart. The tangent that crosses between the circles leaves each at the angle `acos((r_b1 +
    /// r_b2)/D)` from the line of centres: towards +y on the wheel for right flanks, whose normal out of the wheel
    /// points clockwise. A tip circle cuts it at `√(r_a² − r_b²)` from its own end.
    pub fn line_of_action(&self, side: Side) -> Option<LineOfAction> {
        let wheel = self.wheel.data()?.as_built().gear();
        let gears = [wheel, self.pinion.data()?.as_built().gear()];
        let between = self.pinion.centre() - self.wheel.centre();
        let distance = between.norm();
        let [(base_1, reach_1), (base_2, reach_2)] =
            gears.map(|gear| (gear.base_radius(), gear.base_radius() * gear.tip_roll()));
        let bases = base_1 + base_2;
        if distance <= bases {
            return None;
        }
        let radial =
            UnitComplex::new(-side.sense() * (bases / distance).acos()) * (between / distance);
        let ends = [
            self.wheel.centre() + base_1 * radial,
            self.pinion.centre() - base_2 * radial,
        ];
        let length = ((distance - bases) * (distance + bases)).sqrt();
        let (from, to) = ((length - reach_2).max(0.0), reach_1.min(length));
        let at = |s: f64| ends[0] + (ends[1] - ends[0]) * (s / length);
        Some(LineOfAction {
            side,
            ends,
            path: (from < to).then(|| [at(from), at(to)]),
        })
    }
}

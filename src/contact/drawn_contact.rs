//! The two points of a contact at the gears' positions in a picture.

use super::{Contact, ToothPlace, Touch};
use crate::gear::Side;
use crate::outline::AssembledPair;
use crate::pair::Member;
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::TAU;

/// The two points of a contact, apart unless the gears are drawn in that contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnContact {
    /// The flanks that touch.
    pub side: Side,
    /// The contact they meet in.
    pub contact: Contact,
    /// The locked gear's point, mm.
    pub on_locked: Point2<f64>,
    /// The free gear's point as drawn, mm.
    pub on_free: Point2<f64>,
    /// Unit normal out of the locked gear's metal.
    pub normal: Vector2<f64>,
    /// Turn of the free gear from here to the contact, rad, counter-clockwise; 0 when drawn in it.
    pub turn: f64,
    /// That turn as a length along the free gear's base circle, or for a drawn pair along the contact's normal, mm;
    /// negative where the flanks overlap.
    pub gap: f64,
    /// That turn as a length along the contact's normal, mm: the turn times the normal's distance from the free gear's
    /// axis. It equals `gap` for involutes without eccentricity, whose normals touch the base circle.
    pub along_normal: f64,
}

impl DrawnContact {
    pub(super) fn new(
        assembly: &AssembledPair,
        side: Side,
        contact: Contact,
        rotation: f64,
    ) -> DrawnContact {
        let turn = contact.rotation - rotation;
        let turn = turn - TAU * (turn / TAU).round();
        let free = assembly.axis(assembly.free());
        let along_normal = side.sense() * turn * contact.lever(free);
        let base = assembly.as_built(assembly.free());
        let base = base.map(|gear| gear.gear().base_radius());
        DrawnContact {
            side,
            contact,
            on_locked: contact.point,
            on_free: match turn {
                0.0 => contact.point,
                _ => free + Rotation2::new(-turn) * (contact.point - free),
            },
            normal: match assembly.locked() {
                Member::Wheel => contact.normal,
                Member::Pinion => -contact.normal,
            },
            turn,
            gap: base.map_or(along_normal, |base| side.sense() * turn * base),
            along_normal,
        }
    }

    /// One gear's side of the contact.
    pub fn touch(&self, member: Member) -> &Touch {
        self.contact.touch(member)
    }

    /// Whether the contact lies on a fillet or a root of `member`.
    pub fn is_below_form_circle(&self, member: Member) -> bool {
        matches!(
            self.touch(member).curve,
            ToothPlace::Fillet | ToothPlace::Root
        )
    }
}

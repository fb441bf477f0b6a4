//! The contacts of helical gears over the face: on either side the first section to touch stops the free gear.

use super::lost_motion::{Contact, LostMotion, Status};
use crate::gear::Side;
use crate::numeric::wrap_angle;
use crate::pair::Pose;
use std::f64::consts::{PI, TAU};

/// The play of the free gear over the sections examined so far, from its nominal rotation.
#[derive(Debug, Default)]
pub(super) struct OverFace {
    right: Option<(f64, Contact)>,
    left: Option<(f64, Contact)>,
    /// The first section that is certainly jammed, mm. Nothing turns then, and its contacts are the result.
    jam: Option<f64>,
    /// The first section whose overlap is within its error bound, so that it may be jammed, mm.
    may_be_jammed: Option<f64>,
}

/// The result of a pose over a face.
#[derive(Debug)]
pub(super) struct FoundOverFace {
    pub lost_motion: LostMotion,
    /// A section that jams the gears by itself, mm.
    pub jam: Option<f64>,
}

impl OverFace {
    /// Adds the result of the section at `b`, mm, at its pose `here`.
    pub fn add(&mut self, b: f64, here: &Pose, found: LostMotion) {
        let nominal = here.free_rotation();
        // Rounding of the twist: a few ulps of both rotations, including whole turns.
        let rounding = 8.0 * f64::EPSILON * (here.locked_rotation().abs() + nominal.abs() + TAU);
        if self.is_solid() {
            return;
        }
        if found.status() == Status::Jammed {
            let overlap = found.right.zip(found.left);
            let overlap = overlap.map(|(right, left)| right.rotation - left.rotation);
            match overlap.zip(found.error()) {
                Some((overlap, bound)) if overlap <= bound => {
                    self.may_be_jammed.get_or_insert(b);
                }
                _ => (self.jam, self.right, self.left) = (Some(b), None, None),
            }
        }
        let right = found
            .right
            .map(|contact| wrap_angle(contact.rotation - nominal));
        // The left rotation continues from the right one.
        let left = found.left.map(|contact| match found.right.zip(right) {
            Some((first, beyond)) => beyond + (contact.rotation - first.rotation),
            None => wrap_angle(contact.rotation - nominal),
        });
        let at = |contact: Contact| Contact {
            error: (contact.error + rounding).min(PI),
            section: b,
            ..contact
        };
        if let Some((beyond, contact)) = right.zip(found.right.map(at))
            && (self.right).is_none_or(|(most, held)| beyond > most + held.error)
        {
            self.right = Some((beyond, contact));
        }
        if let Some((beyond, contact)) = left.zip(found.left.map(at))
            && (self.left).is_none_or(|(least, held)| beyond < least - held.error)
        {
            self.left = Some((beyond, contact));
        }
    }

    /// The rotations beyond nominal, rad, at which the sections so far stop the free gear on the right and on the left. Another section needs to
    /// find only tighter contacts. If a section `may_jam` and none does yet, the limits admit every contact that could overlap.
    pub fn known(&self, may_jam: bool) -> [f64; 2] {
        match (self.right, self.left) {
            (Some((right, _)), Some((left, _))) if !may_jam => [right, left],
            (Some((right, _)), Some((left, _))) => [right.min(left), right.max(left)],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// Whether contacts of another section beyond `known` could overlap with those `found` there, at its pose `here`.
    pub fn may_overlap(here: &Pose, found: &LostMotion, [right, left]: [f64; 2]) -> bool {
        let nominal = here.free_rotation();
        let beyond = |contact: Option<Contact>| {
            contact.map(|contact| wrap_angle(contact.rotation - nominal))
        };
        let (one, other) = (beyond(found.right), beyond(found.left));
        // A contact that is known exactly leaves nothing open.
        let open = [
            one.is_none_or(|one| one <= right),
            other.is_none_or(|other| other >= left),
        ];
        let one = one.map_or(right, |one| one.max(right));
        let other = other.map_or(left, |other| other.min(left));
        open.contains(&true) && one > other
    }

    /// Whether a section is certainly jammed.
    pub fn is_solid(&self) -> bool {
        self.jam.is_some()
    }

    /// Rotation beyond nominal at which the free gear stops, rad.
    pub fn beyond(&self, side: Side) -> Option<f64> {
        match side {
            Side::Right => self.right,
            Side::Left => self.left,
        }
        .map(|(beyond, _)| beyond)
    }

    /// Both contacts at a pose of the measuring plane with this nominal rotation of the free gear, whose angular pitch is `pitch`, rad.
    pub fn found(self, nominal: f64, pitch: f64) -> FoundOverFace {
        let jam = self.jam.or(self.may_be_jammed);
        // A jam independent of contacts: nothing was turned in that section.
        if self.jam.is_some() && self.right.is_none() {
            let lost_motion = LostMotion::JAMMED;
            return FoundOverFace { lost_motion, jam };
        }
        let contact = |held: Option<(f64, Contact)>| {
            held.map(|(beyond, contact)| Contact {
                rotation: nominal + beyond,
                ..contact
            })
        };
        let result = LostMotion {
            right: contact(self.right),
            left: contact(self.left),
            solid: jam.is_some(),
        };
        FoundOverFace {
            lost_motion: result.normalised(nominal).within(pitch),
            jam,
        }
    }
}

#[cfg(test)]
mod tests;

//! Helical gears stop where the first of their sections does.

use super::lost_motion::{Contact, LostMotion, Status};
use crate::gear::Side;
use crate::pair::Pose;
use std::f64::consts::{PI, TAU};

/// What the sections seen so far leave of the free gear's play, from its nominal rotation.
#[derive(Debug, Default)]
pub(super) struct OverFace {
    right: Option<(f64, Contact)>,
    left: Option<(f64, Contact)>,
    /// The first section that is surely jammed, mm: nothing turns then, whatever touches first elsewhere, and what touches there is named.
    jam: Option<f64>,
    /// The first that may only seem to be, of an overlap within its bound, mm.
    seems_jammed: Option<f64>,
}

/// What was found at a pose over a face.
#[derive(Debug)]
pub(super) struct FoundOverFace {
    pub lost_motion: LostMotion,
    /// A section that jams the gears by itself, mm, whatever touches first elsewhere.
    pub jam: Option<f64>,
}

impl OverFace {
    /// Takes what was found in the section at `b`, mm, at the pose `here` of it.
    pub fn take(&mut self, b: f64, here: &Pose, found: LostMotion) {
        let nominal = here.free_rotation();
        // What the twist's rounding comes to: some ulps of the locked and of the free rotation, whole turns and all.
        let rounding = 8.0 * f64::EPSILON * (here.locked_rotation().abs() + nominal.abs() + TAU);
        if self.is_solid() {
            return;
        }
        if found.status() == Status::Jammed {
            let overlap = found.right.zip(found.left);
            let overlap = overlap.map(|(right, left)| right.rotation - left.rotation);
            match overlap.zip(found.error()) {
                Some((overlap, bound)) if overlap <= bound => {
                    self.seems_jammed.get_or_insert(b);
                }
                _ => (self.jam, self.right, self.left) = (Some(b), None, None),
            }
        }
        let turns = |angle: f64| angle - TAU * (angle / TAU).round();
        let right = found.right.map(|contact| turns(contact.rotation - nominal));
        // The left one continues from the right one.
        let left = found.left.map(|contact| match found.right.zip(right) {
            Some((first, beyond)) => beyond + (contact.rotation - first.rotation),
            None => turns(contact.rotation - nominal),
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

    /// How far beyond its nominal rotation the free gear stops at least, rad, by the right and by the left side, of what another section has
    /// to be asked for: what lets it farther is not tighter. Where a section `may_jam` by itself, and none does yet, what lets it farther than
    /// both sides do: that does not overlap either.
    pub fn known(&self, may_jam: bool) -> [f64; 2] {
        match (self.right, self.left) {
            (Some((right, _)), Some((left, _))) if !may_jam => [right, left],
            (Some((right, _)), Some((left, _))) => [right.min(left), right.max(left)],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// Whether contacts that another section has beyond `known` might overlap with those that were `found` there, at the pose `here` of it.
    pub fn may_overlap(here: &Pose, found: &LostMotion, [right, left]: [f64; 2]) -> bool {
        let nominal = here.free_rotation();
        let turns = |angle: f64| angle - TAU * (angle / TAU).round();
        let beyond =
            |contact: Option<Contact>| contact.map(|contact| turns(contact.rotation - nominal));
        let (one, other) = (beyond(found.right), beyond(found.left));
        // Of a contact that is known for certain nothing is left open.
        let open = [
            one.is_none_or(|one| one <= right),
            other.is_none_or(|other| other >= left),
        ];
        let one = one.map_or(right, |one| one.max(right));
        let other = other.map_or(left, |other| other.min(left));
        open.contains(&true) && one > other
    }

    /// Whether a section is surely jammed.
    pub fn is_solid(&self) -> bool {
        self.jam.is_some()
    }

    /// How far beyond its nominal rotation the free gear stops, rad.
    pub fn beyond(&self, side: Side) -> Option<f64> {
        match side {
            Side::Right => self.right,
            Side::Left => self.left,
        }
        .map(|(beyond, _)| beyond)
    }

    /// Both contacts at a pose of the measuring plane with this nominal rotation of the free gear; `pitch` is its angular pitch, rad.
    pub fn found(self, nominal: f64, pitch: f64) -> FoundOverFace {
        let jam = self.jam.or(self.seems_jammed);
        // Jammed whatever touches, so that nothing was turned in that section.
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

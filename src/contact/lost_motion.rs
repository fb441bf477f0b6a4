//! The result of one pose: right- and left-flank contact, and the lost motion between them.

use super::gap::C;
use crate::error::Error;
use crate::gear::{ProfilePart, Side};
use crate::pair::{Member, Pose};
use nalgebra::{Point2, Vector2};
use std::f64::consts::{PI, TAU};

/// A place on a tooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ToothPlace {
    /// The tip corner or the tip land; on a drawn tooth the upper hundredth of its height.
    Tip,
    /// The involute of a gear by its data.
    Involute,
    /// The fillet of a gear by its data.
    Fillet,
    /// The root land; on a drawn tooth the lower hundredth of its height.
    Root,
    /// The part of a drawn tooth between tip and root.
    Flank,
}

impl ToothPlace {
    /// Its name in results.
    pub fn name(self) -> &'static str {
        match self.part() {
            Some(part) => part.name(),
            None => "flank",
        }
    }

    /// Whether it is a tip land or a root land.
    pub fn is_land(self) -> bool {
        matches!(self, ToothPlace::Tip | ToothPlace::Root)
    }

    /// The part of the profile of a gear by its data; `None` for a drawn flank.
    pub fn part(self) -> Option<ProfilePart> {
        match self {
            ToothPlace::Tip => Some(ProfilePart::Tip),
            ToothPlace::Involute => Some(ProfilePart::Involute),
            ToothPlace::Fillet => Some(ProfilePart::Fillet),
            ToothPlace::Root => Some(ProfilePart::Root),
            ToothPlace::Flank => None,
        }
    }
}

impl From<ProfilePart> for ToothPlace {
    fn from(part: ProfilePart) -> ToothPlace {
        match part {
            ProfilePart::Tip => ToothPlace::Tip,
            ProfilePart::Involute => ToothPlace::Involute,
            ProfilePart::Fillet => ToothPlace::Fillet,
            ProfilePart::Root => ToothPlace::Root,
        }
    }
}

impl PartialEq<ProfilePart> for ToothPlace {
    fn eq(&self, part: &ProfilePart) -> bool {
        self.part() == Some(*part)
    }
}

/// One gear's side of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Touch {
    /// Tooth number, `1..=z`.
    pub tooth: u32,
    /// Place on the tooth.
    pub curve: ToothPlace,
    /// Radius about the gear's own geometric centre, mm.
    pub radius: f64,
}

/// Contact of the free gear on one side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Contact {
    /// Rotation of the free gear at contact, rad, counted as in [`crate::pair::Pose`].
    pub rotation: f64,
    /// Error bound, rad: the true rotation of the outlines is within `rotation ± error`. For drawn outlines it consists
    /// of rounding, the error of the search, and, to first order, the uncertainty of the drawing.
    pub error: f64,
    /// The wheel's side.
    pub wheel: Touch,
    /// The pinion's side.
    pub pinion: Touch,
    /// Point of contact in the picture frame, mm.
    pub point: Point2<f64>,
    /// Unit normal at the contact, out of the wheel's metal.
    pub normal: Vector2<f64>,
    /// Its position `b` along the axes, mm from the measuring plane away from the viewer; 0 for spur gears.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "is_measuring_plane"))]
    pub section: f64,
}

impl Contact {
    /// One gear's side.
    pub fn touch(&self, member: Member) -> &Touch {
        match member {
            Member::Wheel => &self.wheel,
            Member::Pinion => &self.pinion,
        }
    }

    /// Lever of the contact force about `axis`, mm.
    pub(crate) fn lever(&self, axis: Point2<f64>) -> f64 {
        (self.point - axis).perp(&self.normal).abs()
    }
}

#[cfg(feature = "serde")]
fn is_measuring_plane(section: &f64) -> bool {
    *section == 0.0
}

/// The result of a search in the frame of the exact method and of outlines. The free gear's axis is at the origin and
/// the locked one's at `(a, 0)`; the left side is mirrored.
pub(super) struct ContactInFrame {
    pub side: Side,
    pub free: Member,
    pub center_distance: f64,
    /// Rotation of the free gear, rad.
    pub rotation: f64,
    pub error: f64,
    pub locked: Touch,
    pub mated: Touch,
    pub point: C,
    /// Out of the locked metal.
    pub normal: C,
}

impl ContactInFrame {
    /// The contact in the picture.
    pub fn contact(self) -> Contact {
        let mirror = |z: C| match self.side {
            Side::Right => z,
            Side::Left => z.conj(),
        };
        // The frame is the picture if the wheel is free, and the picture turned by half a turn if the pinion is.
        let (point, normal) = (mirror(self.point), -mirror(self.normal));
        let (wheel, pinion, point) = match self.free {
            Member::Pinion => (
                self.locked,
                self.mated,
                C::from(self.center_distance) - point,
            ),
            Member::Wheel => (self.mated, self.locked, point),
        };
        Contact {
            rotation: -self.side.sense() * self.rotation,
            error: self.error.min(PI),
            wheel,
            pinion,
            point: Point2::new(point.re, point.im),
            normal: Vector2::new(normal.re, normal.im),
            section: 0.0,
        }
    }
}

/// The error of a contact of two teeth, the locked gear's first, that was lost at `pose`.
pub(super) fn contact_lost(
    free: Member,
    [locked_tooth, free_tooth]: [u32; 2],
    side: Side,
    pose: &Pose,
    reason: &str,
) -> Error {
    let (wheel_tooth, pinion_tooth) = match free {
        Member::Pinion => (locked_tooth, free_tooth),
        Member::Wheel => (free_tooth, locked_tooth),
    };
    Error::ContactLost {
        wheel_tooth,
        pinion_tooth,
        flank: side.name(),
        locked_rotation_rad: pose.locked_rotation(),
        reason: reason.to_owned(),
    }
}

/// The state of the pair at a pose according to its lost motion, or unproven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Status {
    /// Lost motion ≥ 0: the free gear can turn.
    Clear,
    /// Lost motion < 0: the teeth overlap by that amount, and the pair cannot be assembled here.
    Interference,
    /// A tip is in a root: every rotation of the free gear overlaps.
    Jammed,
    /// Out of mesh: at least one side has nothing to touch.
    NoContact,
    /// Unproven: a certificate failed, a contact was lost or two methods differ. A [`LostMotion`] never has this status.
    Unproven,
}

impl Status {
    /// All, each at the index of its number.
    pub const ALL: [Status; 5] = [
        Status::Clear,
        Status::Interference,
        Status::Jammed,
        Status::NoContact,
        Status::Unproven,
    ];

    /// Its name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Status::Clear => "clear",
            Status::Interference => "interference",
            Status::Jammed => "jammed",
            Status::NoContact => "no_contact",
            Status::Unproven => "unproven",
        }
    }
}

/// Right- and left-flank contact of the free gear at one pose of the locked gear.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LostMotion {
    /// Limit of clockwise rotation.
    pub right: Option<Contact>,
    /// Limit of counter-clockwise rotation.
    pub left: Option<Contact>,
    /// Whether no rotation can free the free gear, independent of the contacts. Teeth are in the solid body of the mate, or reach over its
    /// axis, or overlap by a pitch or more. A further turn would only bring the next tooth to the same place.
    pub solid: bool,
}

impl LostMotion {
    /// Jammed independent of contacts, so nothing was turned.
    pub(super) const JAMMED: LostMotion = LostMotion {
        right: None,
        left: None,
        solid: true,
    };

    /// Shifts the right rotation into (−π, π], and the left one by whole turns so that both keep their distance, each counted from the
    /// `nominal` rotation, rad. Gears of three teeth that barely reach each other can turn by more than half a turn.
    pub(super) fn normalised(mut self, nominal: f64) -> LostMotion {
        let turns = |angle: f64| (angle / TAU).round();
        let whole = |contact: &Contact| turns(contact.rotation - nominal);
        let onward = self.right.map_or(0.0, |right| -turns(right.rotation));
        let beside = match (&self.right, &self.left) {
            (Some(right), Some(left)) => onward + whole(right) - whole(left),
            (None, Some(left)) => -turns(left.rotation),
            _ => 0.0,
        };
        if let Some(right) = &mut self.right {
            right.rotation += TAU * onward;
            if right.rotation == -PI {
                right.rotation = PI;
            }
        }
        if let Some(left) = &mut self.left {
            left.rotation += TAU * beside;
        }
        self
    }

    /// Clears `solid` without an overlap, and sets it for an overlap of a `pitch` of the free gear (rad) or more.
    pub(super) fn within(self, pitch: f64) -> LostMotion {
        let overlap = self.right.zip(self.left);
        let overlap = overlap.map_or(0.0, |(right, left)| right.rotation - left.rotation);
        LostMotion {
            solid: overlap > 0.0 && (self.solid || overlap >= pitch),
            ..self
        }
    }

    /// The contact on a side.
    pub fn on(&self, side: Side) -> Option<Contact> {
        match side {
            Side::Right => self.right,
            Side::Left => self.left,
        }
    }

    /// The status of the pose.
    ///
    /// A tip is in a root if teeth are in the mate's body, or if a root land (of an outline a root region) touches in
    /// an overlap. Turning cannot free it, and its angle has no meaning.
    pub fn status(&self) -> Status {
        if self.solid {
            return Status::Jammed;
        }
        let (Some(right), Some(left)) = (&self.right, &self.left) else {
            return Status::NoContact;
        };
        let on_root = |contact: &Contact| {
            [contact.wheel.curve, contact.pinion.curve].contains(&ToothPlace::Root)
        };
        if left.rotation >= right.rotation {
            Status::Clear
        } else if on_root(right) || on_root(left) {
            Status::Jammed
        } else {
            Status::Interference
        }
    }

    /// Lost motion `φ_j` = left − right, rad; negative when the pair interferes, `None` when jammed or out of mesh.
    pub fn angle(&self) -> Option<f64> {
        match self.status() {
            Status::Clear | Status::Interference => {
                Some(self.left?.rotation - self.right?.rotation)
            }
            Status::Jammed | Status::NoContact | Status::Unproven => None,
        }
    }

    /// Bound on the error of [`LostMotion::angle`], rad.
    pub fn error(&self) -> Option<f64> {
        Some(self.left?.error + self.right?.error)
    }
}

#[cfg(test)]
mod tests {
    use super::Status;

    /// A status without an entry shifted every later pose of the run by one.
    #[test]
    fn every_status_has_its_place() {
        for (place, status) in Status::ALL.into_iter().enumerate() {
            assert_eq!(status as usize, place);
        }
        assert_eq!(Status::Unproven as usize + 1, Status::ALL.len());
    }
}

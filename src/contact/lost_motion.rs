//! The result of one pose: right- and left-flank contact, and the lost motion between.

use super::gap::C;
use crate::gear::{ProfilePart, Side};
use crate::pair::Member;
use nalgebra::{Point2, Vector2};
use std::f64::consts::{PI, TAU};

/// A place on a tooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ToothPlace {
    /// The tip corner or the tip land; of a drawn tooth the upper hundredth of its height.
    Tip,
    /// The involute of a gear by its data.
    Involute,
    /// The fillet of a gear by its data.
    Fillet,
    /// The root land; of a drawn tooth the lower hundredth of its height.
    Root,
    /// A drawn tooth between tip and root.
    Flank,
}

impl ToothPlace {
    /// The name results use.
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

    /// The part of the profile of a gear by its data; `None` of a drawn flank.
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

/// What one gear brings to a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Touch {
    /// Tooth number, `1..=z`.
    pub tooth: u32,
    /// Where on the tooth.
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
    /// The true rotation of the outlines lies within `rotation ± error`, rad. Of drawn outlines: rounding, what the search left out, and, to
    /// first order, how far they may lie from what was drawn.
    pub error: f64,
    /// The wheel's part.
    pub wheel: Touch,
    /// The pinion's part.
    pub pinion: Touch,
    /// Point of contact in the picture frame, mm.
    pub point: Point2<f64>,
    /// Unit normal at the contact, out of the wheel's metal.
    pub normal: Vector2<f64>,
    /// Where along the axes it is `b`, mm from the measuring plane away from the viewer; 0 of spur gears.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "is_measuring_plane"))]
    pub section: f64,
}

#[cfg(feature = "serde")]
fn is_measuring_plane(section: &f64) -> bool {
    *section == 0.0
}

/// What a search found, in the frame of the exact method and of outlines: the free gear's axis at the origin, the locked one's at `(a, 0)`, the left
/// side mirrored.
pub(super) struct Framed {
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

impl Framed {
    /// The contact in the picture.
    pub fn contact(self) -> Contact {
        let mirror = |z: C| match self.side {
            Side::Right => z,
            Side::Left => z.conj(),
        };
        // The frame is the picture with a free wheel, the picture turned half round with a free pinion.
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

/// What a lost motion says about the pair at this pose, or that nothing vouches for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Status {
    /// Lost motion ≥ 0: the free gear has room to turn.
    Clear,
    /// Lost motion < 0: the teeth overlap by that much, the pair cannot be assembled here.
    Interference,
    /// A tip sits in a root: no rotation of the free gear is free of overlap.
    Jammed,
    /// Out of mesh: nothing to touch on one side at least.
    NoContact,
    /// Nothing vouches for what was found: a certificate failed, a contact was lost or two methods differ. Never of a
    /// [`LostMotion`] itself.
    Unproven,
}

impl Status {
    /// All, each at the place that is its number.
    pub const ALL: [Status; 5] = [
        Status::Clear,
        Status::Interference,
        Status::Jammed,
        Status::NoContact,
        Status::Unproven,
    ];

    /// The name results use.
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
    /// Whether no rotation of the free gear can free it, whatever touches: teeth stand in the solid body of the mate, or reach
    /// over its axis, or overlap by a pitch or more, so that turning on only brings the next tooth into the place.
    pub solid: bool,
}

impl LostMotion {
    /// Jammed whatever touches, so nothing was turned.
    pub(super) const JAMMED: LostMotion = LostMotion {
        right: None,
        left: None,
        solid: true,
    };

    /// Right into (−π, π]; left as many turns on as the two lie apart, each counted from the `nominal` rotation, rad: gears of three
    /// teeth that hardly reach each other may turn by more than half a turn.
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

    /// The same, solid only with an overlap, and surely where that is a `pitch` of the free gear (rad) or more.
    pub(super) fn within(self, pitch: f64) -> LostMotion {
        let overlap = self.right.zip(self.left);
        let overlap = overlap.map_or(0.0, |(right, left)| right.rotation - left.rotation);
        LostMotion {
            solid: overlap > 0.0 && (self.solid || overlap >= pitch),
            ..self
        }
    }

    /// How the pose ended.
    ///
    /// Teeth in the mate's body, or an overlap in which a root land (of an outline a root region) takes part, are a tip in a root: turning
    /// cannot free it, and its angle means nothing.
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

    /// A status that had no place left its entry out, and every later pose of the run had its neighbour's.
    #[test]
    fn every_status_has_its_place() {
        for (place, status) in Status::ALL.into_iter().enumerate() {
            assert_eq!(status as usize, place);
        }
        assert_eq!(Status::Unproven as usize + 1, Status::ALL.len());
    }
}

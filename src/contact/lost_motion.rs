//! The result of one pose: right- and left-flank contact, and the lost motion between.

use crate::gear::ProfilePart;
use nalgebra::{Point2, Vector2};

/// What one gear brings to a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Touch {
    /// Tooth number, `1..=z`.
    pub tooth: u32,
    /// The curve touched; `Tip` is the tip corner or the tip land.
    pub curve: ProfilePart,
    /// Radius about the gear's own geometric centre, mm.
    pub radius: f64,
}

/// Contact of the free gear on one side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Contact {
    /// Rotation of the free gear at contact, rad, counted as in [`crate::pair::Pose`].
    pub rotation: f64,
    /// The true rotation of the outlines lies within `rotation ± error`, rad.
    pub error: f64,
    /// The wheel's part.
    pub wheel: Touch,
    /// The pinion's part.
    pub pinion: Touch,
    /// Point of contact in the picture frame, mm.
    pub point: Point2<f64>,
    /// Unit normal at the contact, out of the wheel's metal.
    pub normal: Vector2<f64>,
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
    /// The name results use.
    pub fn name(self) -> &'static str {
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
    /// Teeth in the mate's body, or an overlap in which a root land takes part, are a tip in a root: turning
    /// cannot free it, and its angle means nothing.
    pub fn status(&self) -> Status {
        if self.solid {
            return Status::Jammed;
        }
        let (Some(right), Some(left)) = (&self.right, &self.left) else {
            return Status::NoContact;
        };
        let on_root = |contact: &Contact| {
            [contact.wheel.curve, contact.pinion.curve].contains(&ProfilePart::Root)
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

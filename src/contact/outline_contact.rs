//! The result of one pose of outlines: right- and left-flank contact, and the lost motion between.

use super::lost_motion::Status;
use nalgebra::{Point2, Vector2};

/// Where on a tooth of an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Region {
    /// Within the upper hundredth of its height.
    Tip,
    /// Between.
    Flank,
    /// Within the lower hundredth.
    Root,
}

impl Region {
    /// `tip`, `flank` or `root`.
    pub fn name(self) -> &'static str {
        match self {
            Region::Tip => "tip",
            Region::Flank => "flank",
            Region::Root => "root",
        }
    }
}

/// What one gear brings to a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlineTouch {
    /// Tooth number, `1..=z`.
    pub tooth: u32,
    /// Where on it.
    pub region: Region,
    /// Radius about the gear's own geometric centre, mm.
    pub radius: f64,
}

/// Contact of the free gear on one side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlineContact {
    /// Rotation of the free gear at contact, rad, counted from where tooth 1 points at the mate.
    pub rotation: f64,
    /// The rotation of the drawn outlines lies within `rotation ± error`, rad: rounding, what the search left out, and, to first order,
    /// how far the outlines may lie from what was drawn.
    pub error: f64,
    /// The wheel's part.
    pub wheel: OutlineTouch,
    /// The pinion's part.
    pub pinion: OutlineTouch,
    /// Point of contact in the picture frame, mm.
    pub point: Point2<f64>,
    /// Unit normal at the contact, out of the wheel's metal.
    pub normal: Vector2<f64>,
}

/// Right- and left-flank contact of the free gear at one pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlineLostMotion {
    /// Limit of clockwise rotation.
    pub right: Option<OutlineContact>,
    /// Limit of counter-clockwise rotation.
    pub left: Option<OutlineContact>,
    /// Whether no rotation of the free gear can free it.
    pub solid: bool,
}

impl OutlineLostMotion {
    /// How the pose ended; an overlap in which a root region takes part is a tip in a root: jammed.
    pub fn status(&self) -> Status {
        if self.solid {
            return Status::Jammed;
        }
        let (Some(right), Some(left)) = (&self.right, &self.left) else {
            return Status::NoContact;
        };
        let on_root = |contact: &OutlineContact| {
            [contact.wheel.region, contact.pinion.region].contains(&Region::Root)
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

    /// Bound on the error of [`OutlineLostMotion::angle`], rad.
    pub fn error(&self) -> Option<f64> {
        Some(self.left?.error + self.right?.error)
    }
}

/// A pose that was not settled within 150 000 steps of the search.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the search for the contact of wheel tooth {wheel_tooth} and pinion tooth {pinion_tooth} on {flank} flanks did not end"
)]
pub struct Unsettled {
    /// Wheel tooth.
    pub wheel_tooth: u32,
    /// Pinion tooth.
    pub pinion_tooth: u32,
    /// `right` or `left`.
    pub flank: &'static str,
}

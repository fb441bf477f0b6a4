//! What outlines bring to a contact, and a pose that was not settled.

use super::lost_motion::{Contact, LostMotion, ToothPlace, Touch};

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

impl ToothPlace for Region {
    fn is_root(self) -> bool {
        self == Region::Root
    }
}

/// What an outline brings to a contact.
pub type OutlineTouch = Touch<Region>;

/// Contact of outlines. Its rotation counts from where tooth 1 of the free gear points at the mate.
pub type OutlineContact = Contact<Region>;

/// Right- and left-flank contact of outlines.
pub type OutlineLostMotion = LostMotion<Region>;

/// A pose that was not settled within the effort that it may take.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the search for the contact of wheel tooth {wheel_tooth} and pinion tooth {pinion_tooth} on {flank} flanks did not end"
)]
pub struct SearchExhausted {
    /// Wheel tooth.
    pub wheel_tooth: u32,
    /// Pinion tooth.
    pub pinion_tooth: u32,
    /// `right` or `left`.
    pub flank: &'static str,
}

/// A contact that polygons do not bear out.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("polygons do not bear out the contact on {flank} flanks: {reason}")]
pub struct NotBorneOut {
    /// `right` or `left`.
    pub flank: &'static str,
    /// What they show in its place.
    pub reason: &'static str,
}

/// Why a pose of outlines is not proven.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum OutlineDoubt {
    /// The search did not end.
    #[error(transparent)]
    Search(#[from] SearchExhausted),
    /// The certificate failed.
    #[error(transparent)]
    Certificate(#[from] NotBorneOut),
}

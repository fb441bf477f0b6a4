//! The place along the face where the teeth of a contact touch.

use super::lost_motion::{Contact, ToothPlace};
use crate::pair::{GearPair, Member, Pose};
use nalgebra::Vector2;

/// Distance from the end of a gear's teeth, mm, within which a contact is at that end: rounding, and the square of a lean.
const AT_END: f64 = 1e-3;

/// The place of a contact along the common face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum FacePlace {
    /// The end of the common face that is nearest to the viewer, with the least `b`.
    NearEnd,
    /// The end of the common face with the greatest `b`.
    FarEnd,
    /// A tip corner between both ends, beyond the end of its line of contact.
    TipEdge,
    /// Between both ends on the flanks.
    Inside,
}

impl FacePlace {
    /// All, each at the index of its number.
    pub const ALL: [FacePlace; 4] = [
        FacePlace::NearEnd,
        FacePlace::FarEnd,
        FacePlace::TipEdge,
        FacePlace::Inside,
    ];

    /// The place of `contact`, found on `assembly` at `pose`; `None` if equal contacts lie in many sections.
    pub fn of(assembly: &GearPair, pose: &Pose, contact: &Contact) -> Option<FacePlace> {
        if !assembly.binds_anywhere() {
            return None;
        }
        let heights = Member::BOTH.map(|member| {
            let height = height(assembly, pose, contact, member);
            assembly.own_face(member).map(|end| end - height)
        });
        let [from, to] = assembly.face();
        let is_at = |end: usize| from < to && heights.iter().any(|ends| ends[end].abs() <= AT_END);
        Some(if is_at(0) {
            FacePlace::NearEnd
        } else if is_at(1) {
            FacePlace::FarEnd
        } else if [contact.wheel.curve, contact.pinion.curve].contains(&ToothPlace::Tip) {
            FacePlace::TipEdge
        } else {
            FacePlace::Inside
        })
    }

    /// Its name in results.
    pub const fn name(self) -> &'static str {
        match self {
            FacePlace::NearEnd => "near_end",
            FacePlace::FarEnd => "far_end",
            FacePlace::TipEdge => "tip_edge",
            FacePlace::Inside => "inside",
        }
    }

    /// Its name for readers.
    pub const fn words(self) -> &'static str {
        match self {
            FacePlace::NearEnd => "near end",
            FacePlace::FarEnd => "far end",
            FacePlace::TipEdge => "tip edge",
            FacePlace::Inside => "inside",
        }
    }
}

/// Height of a contact on a gear, mm along the axis of its teeth from the measuring plane: `b k + α·(P − C)/k`, as in
/// [`section_at`](crate::pair::section_at).
fn height(assembly: &GearPair, pose: &Pose, contact: &Contact, member: Member) -> f64 {
    let gear = assembly.gear(member);
    let rotation = if member == assembly.locked() {
        pose.locked_rotation()
    } else {
        contact.rotation
    };
    let tooth_1 = rotation + assembly.mate_direction(member);
    let shaft = match member {
        Member::Wheel => Vector2::zeros(),
        Member::Pinion => Vector2::from(assembly.lean()),
    };
    let lean = shaft + gear.lean(tooth_1);
    let b = contact.section;
    let centre = assembly.axis(member).coords + gear.displacement(tooth_1) + lean * b;
    let root = (1.0 + lean.norm_squared()).sqrt();
    b * root + lean.dot(&(contact.point.coords - centre)) / root
}

//! Model 3: exact backlash of eccentric involutes with pitch and thickness deviations.
//!
//! Each side of the free gear is solved on its own, by [`super::one_side`]; only
//! contact on the line of action counts.

use super::one_side::SideContact;
use crate::gear::Side;
use crate::pair::{GearPair, Pose};

/// The tightest contact of each side; `None` where no pair touches on the line of action.
///
/// Where pairs tie within rounding, as perfect gears do, any of them may be named.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineOfAction {
    /// Limit of clockwise rotation.
    pub right: Option<SideContact>,
    /// Limit of counter-clockwise rotation.
    pub left: Option<SideContact>,
}

impl LineOfAction {
    /// Both sides of `pose`.
    pub fn new(assembly: &GearPair, pose: &Pose) -> LineOfAction {
        // Clockwise the free gear stops at the greatest rotation, counter-clockwise at the least.
        let tightest = |side: Side| {
            SideContact::all(assembly, pose, side).reduce(|best, next| {
                if side.sense() * (next.rotation - best.rotation) < 0.0 {
                    next
                } else {
                    best
                }
            })
        };
        LineOfAction {
            right: tightest(Side::Right),
            left: tightest(Side::Left),
        }
    }

    /// Lost motion `φ_j` = left − right, rad.
    pub fn angle(&self) -> Option<f64> {
        Some(self.left?.rotation - self.right?.rotation)
    }

    /// Circumferential backlash `j_wt = φ_j r_w` of the free gear, mm.
    pub fn backlash(&self, assembly: &GearPair) -> Option<f64> {
        Some(self.angle()? * assembly.operating_pitch_radius(assembly.free()))
    }
}

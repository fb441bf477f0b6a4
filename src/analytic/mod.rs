//! Backlash by formula: the three models of design section 5, and the limits of a pair.
//!
//! They share nothing with the simulation but gears, deviations and poses. Each
//! gives the circumferential backlash `j_wt` (mm, negative: interference); a
//! model that has no value says `None`.

mod involute;
pub mod limits;
mod line_of_action;
mod michalec;
mod one_side;

pub use involute::InvolutePair;
pub use line_of_action::LineOfAction;
pub use one_side::SideContact;

use crate::pair::{GearPair, Pose};

/// Circumferential backlash `j_wt` of one pose by each model, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Analytic {
    /// Model 1, Michalec. `None` when the nominal gears have no play-free centre distance.
    pub michalec: Option<f64>,
    /// Model 2, involute. `None` when the base circles overlap at the effective centre distance.
    pub involute: Option<f64>,
    /// Model 3, line of action, side by side.
    pub line_of_action: LineOfAction,
}

/// All three models at `pose`.
pub fn evaluate(assembly: &GearPair, pose: &Pose) -> Analytic {
    let distance = effective_center_distance(assembly, pose);
    Analytic {
        michalec: michalec::backlash(assembly, distance),
        involute: InvolutePair::of(assembly).circumferential_backlash(distance),
        line_of_action: LineOfAction::new(assembly, pose),
    }
}

/// Effective centre distance `a − e_1 cos χ_1 − e_2 cos χ_2` of models 1 and 2, mm.
///
/// `χ` is the angle between a gear's high tooth and the direction to its mate,
/// the free gear at its nominal rotation: the distance of the two outlines'
/// centres along the line of centres.
pub fn effective_center_distance(assembly: &GearPair, pose: &Pose) -> f64 {
    let towards_mate = |member| {
        let gear = assembly.gear(member);
        gear.eccentricity() * gear.towards_mate(pose.rotation(assembly, member))
    };
    assembly.center_distance() - towards_mate(assembly.locked()) - towards_mate(assembly.free())
}

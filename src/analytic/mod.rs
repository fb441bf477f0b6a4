//! Backlash by formula: the three models of docs/explanation/models.md, and the limits of a pair. `K (n)` is formula n of the study that
//! docs/explanation/study.md reproduces.
//!
//! They share only gears, deviations and poses with the simulation. Each gives the circumferential backlash `j_wt` (mm, negative:
//! interference), or `None` without a value.

mod involute;
pub mod limits;
mod line_of_action;

pub use involute::InvolutePair;
pub use line_of_action::{LineOfAction, SideContact};

use crate::pair::{GearPair, Pose};

/// Circumferential backlash `j_wt` of one pose by each model, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Analytic {
    /// Model 1, Michalec. `None` if the nominal gears have no zero-backlash centre distance.
    pub michalec: Option<f64>,
    /// Model 2, involute. `None` if the base circles overlap at the effective centre distance.
    pub involute: Option<f64>,
    /// Model 3, line of action, both sides.
    pub line_of_action: LineOfAction,
}

/// All three models at `pose`.
pub fn evaluate(assembly: &GearPair, pose: &Pose) -> Analytic {
    let distance = effective_center_distance(assembly, pose);
    Analytic {
        michalec: michalec(assembly, distance),
        involute: InvolutePair::of(assembly).circumferential_backlash(distance),
        line_of_action: LineOfAction::new(assembly, pose),
    }
}

/// Effective centre distance `a − e_1 cos χ_1 − e_2 cos χ_2` of models 1 and 2, mm.
///
/// `χ` is the angle between a gear's high tooth and the direction to its mate, with the free gear at its nominal rotation. The value is
/// the distance of the outlines' centres along the line of centres.
pub fn effective_center_distance(assembly: &GearPair, pose: &Pose) -> f64 {
    let towards_mate = |member| {
        let gear = assembly.gear(member);
        gear.eccentricity() * gear.towards_mate(pose.rotation(assembly, member))
    };
    assembly.center_distance() - towards_mate(assembly.locked()) - towards_mate(assembly.free())
}

/// Model 1, Michalec's linear backlash `B = B_0 + 2 ΔC tan φ`, K (1)–(7), at the effective centre distance `distance`, mm.
///
/// `ΔC` counts from the play-free centre distance `a_ref` of the nominal gears, `φ` is their operating pressure angle there.
/// `B_0` is model 2's backlash at `a_ref`: there the two models agree. `None` when there is no `a_ref`.
fn michalec(assembly: &GearPair, distance: f64) -> Option<f64> {
    let reference = limits::nominal_zero_backlash_distance(assembly)?;
    let pair = InvolutePair::of(assembly);
    let angle = pair.operating_pressure_angle(reference)?;
    let at_reference = pair.circumferential_backlash(reference)?;
    Some(at_reference + 2.0 * (distance - reference) * angle.tan())
}

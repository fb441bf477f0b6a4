//! Model 1: Michalec's linear backlash, K (1)–(7).
//!
//! `B = B_0 + 2 ΔC tan φ` about the play-free centre distance `a_ref` of the
//! nominal gears, `φ` their operating pressure angle there and `B_0` model 2's
//! backlash: equal to model 2 at `a_ref`, without its bend elsewhere.

use super::{InvolutePair, limits};
use crate::pair::GearPair;

/// `B` at the effective centre distance `distance`, mm; `None` when there is no `a_ref`.
pub(super) fn backlash(assembly: &GearPair, distance: f64) -> Option<f64> {
    let reference = limits::nominal_zero_backlash_distance(assembly)?;
    let pair = InvolutePair::of(assembly);
    let angle = pair.operating_pressure_angle(reference)?;
    let at_reference = pair.circumferential_backlash(reference)?;
    Some(at_reference + 2.0 * (distance - reference) * angle.tan())
}

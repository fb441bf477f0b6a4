//! Uncertainty of the least and the greatest backlash from the uncertainties of the measurements.
//!
//! Standard uncertainties of the inputs are multiplied by the derivatives of `j_wt` at the extreme's own pose and summed as independent
//! ones (JCGM 100, 5.1.2: law of propagation of uncertainty). With `c = cos α_t` and `c_w = cos α_wt`:
//!
//! ```text
//! base thickness of a gear, s_b:      ∂j_wt/∂s_b = −1/c_w            (j_bn falls by the added base thickness)
//! a tooth's own thickness, at d:      −c/(2 c_w cos β) for each flank that touches (in the normal section)
//! a flank's pitch deviation, at d:    ±c/c_w for each of the four flanks that touch
//! runout F_r = 2 e:                   ∂j_wt/∂e = −2 tan α_wt cos θ,  θ between the high tooth and the line of centres
//! centre distance:                    ∂j_wt/∂a = 2 tan α_wt
//! lead deviation of a flank:          −1/c_w for each of the four flanks that touch
//! lean of the axes in their plane:    at most 2 tan α_wt max |b − b_a| over the face; a holds at b_a
//! lean of the axes out of it:         at most the face width
//! ```
//!
//! These hold for contacts of involutes. At a tip corner they differ by the square of its angle off the line of action.
//! A move of the extreme to another pose is a second-order effect if that pose is further away than the uncertainty.

use crate::contact::PoseResult;
use crate::gear::thickness;
use crate::pair::{GearPair, Member};

/// Standard uncertainties of the measurements.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Uncertainty {
    /// Uncertainty of the transverse base thickness of all teeth of the wheel, and of the pinion, mm.
    pub base_thickness: [f64; 2],
    /// Uncertainty of each tooth's own thickness at the reference circle, in the normal section, mm.
    pub per_tooth: f64,
    /// Uncertainty of each flank's pitch deviation at the reference circle, mm.
    pub pitch: f64,
    /// Uncertainty of the runout `F_r` of each gear, mm.
    pub runout: f64,
    /// Uncertainty of the centre distance, mm.
    pub center_distance: f64,
    /// Uncertainty of each flank's lead deviation where it touches, mm.
    pub lead: f64,
    /// Uncertainty of the lean of the axes, in their plane and out of it, mm per mm.
    pub lean: f64,
    /// The place along the axes at which the centre distance holds, mm from the measuring plane.
    pub distance_at: f64,
    /// Coverage factor `k` of the displayed uncertainty.
    pub coverage: f64,
}

impl Uncertainty {
    /// Expanded uncertainty `U` of `j_wt` at an extreme's pose on `assembly`, mm; `None` without a contact on either side.
    pub fn of(&self, assembly: &GearPair, extreme: &PoseResult) -> Option<f64> {
        let found = extreme.proven()?;
        let touching = [found.right?, found.left?];
        let angle = assembly.operating_pressure_angle();
        let per_base = 1.0 / angle.cos();
        let basic_data = assembly.gear(Member::Wheel).gear().basic_data();
        let per_reference = basic_data.transverse_pressure_angle().cos() * per_base;
        let per_thickness = thickness::per_normal_thickness(basic_data) * per_base;
        let per_shift = 2.0 * angle.tan();
        let mut square = (per_shift * self.center_distance).powi(2);
        let [from, to] = assembly.face();
        let off = (from - self.distance_at)
            .abs()
            .max((to - self.distance_at).abs());
        square += (per_shift * off * self.lean).powi(2) + ((to - from) * self.lean).powi(2);
        for (index, member) in Member::BOTH.into_iter().enumerate() {
            let [right, left] = touching.map(|contact| contact.touch(member).tooth);
            let flanks: f64 = if right == left { 1.0 } else { 0.5f64.sqrt() };
            square += (per_base * self.base_thickness[index]).powi(2);
            square += (per_thickness * flanks * self.per_tooth).powi(2);
            square += 2.0 * (per_reference * self.pitch).powi(2);
            square += 2.0 * (per_base * self.lead).powi(2);
            let rotation = extreme.pose.rotation(assembly, member);
            let toward = assembly.gear(member).towards_mate(rotation);
            square += (per_shift * toward * 0.5 * self.runout).powi(2);
        }
        Some(self.coverage * square.sqrt())
    }
}

//! Uncertainty of the least and the greatest backlash from the uncertainties of the measurements.
//!
//! Standard uncertainties of the inputs are multiplied by the derivatives of `j_wt` at the extreme's own pose and summed as independent
//! ones (JCGM 100, 5.1.2: law of propagation of uncertainty). The normal `n` of a contact points out of the wheel, and its arm about the
//! free gear's axis is `h`. A gap `d` along `n` lets that gear turn by `d/h`. With `k = r_w/h` for each of the two contacts:
//!
//! ```text
//! base thickness of a gear, s_b:      ∂j_wt/∂s_b = −(k_R + k_L)/2         (half on each flank, along its normal)
//! a tooth's own base thickness:       −k/2 for each flank that touches
//! pitch or lead deviation of a flank: ±k                                  (along its normal)
//! displacement u of a gear:           ±(k_R n_R + k_L n_L) · u
//! centre distance:                    the displacement of the pinion along the line of centres
//! runout F_r = 2 e:                   the displacement e/e_0 of the outline; without an e_0, in the direction of most effect
//! lean of the axes in their plane:    at most the displacement max |b − b_a| over the face; a holds at b_a
//! lean of the axes out of it:         at most the face width
//! ```
//!
//! For involutes `k = 1/cos α_wt` and `k_R n_R + k_L n_L = 2 tan α_wt` along the line of centres.
//! A move of the extreme to another pose is a second-order effect if that pose is further away than the uncertainty.

use crate::contact::PoseResult;
use crate::outline::AssembledPair;
use crate::pair::Member;

/// Standard uncertainties of the measurements.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Uncertainty {
    /// Uncertainty of the transverse base thickness of all teeth of the wheel, and of the pinion, mm.
    pub base_thickness: [f64; 2],
    /// Uncertainty of the transverse base thickness of each tooth against the others, of the wheel and of the pinion, mm.
    pub per_tooth: [f64; 2],
    /// Uncertainty of each flank's pitch deviation along its transverse normal, of the wheel and of the pinion, mm.
    pub pitch: [f64; 2],
    /// Uncertainty of the runout `F_r` of each gear, mm.
    pub runout: f64,
    /// Uncertainty of the centre distance, mm.
    pub center_distance: f64,
    /// Uncertainty of each flank's lead deviation where it touches, of the wheel and of the pinion, mm.
    pub lead: [f64; 2],
    /// Uncertainty of the lean of the axes, in their plane and out of it, mm per mm.
    pub lean: f64,
    /// The place along the axes at which the centre distance holds, mm from the measuring plane.
    pub distance_at: f64,
    /// Coverage factor `k` of the displayed uncertainty.
    pub coverage: f64,
}

impl Uncertainty {
    /// Expanded uncertainty `U` of `j_wt` at an extreme's pose on `assembly`, mm; `None` without a contact on either side.
    pub fn of(&self, assembly: &AssembledPair, extreme: &PoseResult) -> Option<f64> {
        let found = extreme.proven()?;
        let touching = [found.right?, found.left?];
        let free = assembly.free();
        let radius = assembly.operating_pitch_radius(free);
        let rates = touching.map(|contact| radius / contact.lever(assembly.axis(free)));
        let mean = 0.5 * (rates[0] + rates[1]);
        let apart = rates[0] * touching[0].normal + rates[1] * touching[1].normal;
        let square_sum = rates[0].powi(2) + rates[1].powi(2);
        let [from, to] = assembly.face();
        let off = (from - self.distance_at)
            .abs()
            .max((to - self.distance_at).abs());
        let mut square = (apart.x * self.center_distance).powi(2)
            + (apart.x * off * self.lean).powi(2)
            + ((to - from) * self.lean).powi(2);
        for (index, member) in Member::BOTH.into_iter().enumerate() {
            let [right, left] = touching.map(|contact| contact.touch(member).tooth);
            let own = if right == left {
                mean.powi(2)
            } else {
                0.25 * square_sum
            };
            square += (mean * self.base_thickness[index]).powi(2);
            square += own * self.per_tooth[index].powi(2);
            square += square_sum * (self.pitch[index].powi(2) + self.lead[index].powi(2));
            let displaced = match assembly.displaced_towards(member, &extreme.pose) {
                Some(direction) => apart.dot(&direction),
                None => apart.norm(),
            };
            square += (displaced * 0.5 * self.runout).powi(2);
        }
        Some(self.coverage * square.sqrt())
    }
}

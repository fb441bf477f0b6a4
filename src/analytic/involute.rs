//! Model 2: two gears of mean thickness along their common base tangent, K (11)–(17).

use crate::gear::{Gear, involute};
use crate::pair::{GearPair, Member};

/// The data of two gears for model 2. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvolutePair {
    /// `r_b1 + r_b2`.
    base_radii: f64,
    /// `s_bt1 + s_bt2`.
    base_thicknesses: f64,
    /// `p_bt`; the mean of both gears at different temperatures.
    base_pitch: f64,
}

impl InvolutePair {
    /// Two gears with equal pressure angle and module (apart from temperature), with their mean thicknesses.
    pub fn new(wheel: &Gear, pinion: &Gear) -> InvolutePair {
        InvolutePair {
            base_radii: wheel.base_radius() + pinion.base_radius(),
            base_thicknesses: wheel.base_thickness() + pinion.base_thickness(),
            base_pitch: 0.5 * (wheel.basic_data().base_pitch() + pinion.basic_data().base_pitch()),
        }
    }

    /// The gears of `assembly`, with their mean thicknesses.
    pub fn of(assembly: &GearPair) -> InvolutePair {
        let gear = |member| assembly.gear(member).gear();
        InvolutePair::new(gear(Member::Wheel), gear(Member::Pinion))
    }

    /// The gears of `assembly` with the nominal thicknesses of their profile shifts `x`.
    pub fn nominal(assembly: &GearPair) -> InvolutePair {
        let nominal = |member| {
            let design = assembly.gear(member).gear().design();
            design.nominal_base_thickness()
        };
        InvolutePair {
            base_thicknesses: nominal(Member::Wheel) + nominal(Member::Pinion),
            ..InvolutePair::of(assembly)
        }
    }

    /// Operating pressure angle `α_wt = arccos((r_b1 + r_b2)/a)`, rad, at centre distance `a`, mm.
    ///
    /// `None` if the base circles overlap: `a ≤ r_b1 + r_b2`.
    pub fn operating_pressure_angle(&self, center_distance: f64) -> Option<f64> {
        (center_distance > self.base_radii).then(|| (self.base_radii / center_distance).acos())
    }

    /// Base circle backlash `j_bt = p_bt − s_bt1 − s_bt2 + 2 (r_b1 + r_b2) inv α_wt`, mm, at centre distance `a`, mm.
    ///
    /// It is the normal backlash `j_bn` of spur gears, and `j_bn/cos β_b` of helical gears. Derivation: one tooth of each gear and the
    /// backlash share the common base tangent. Winding it onto both base circles adds `2 r_b inv α_wt` of each to the base pitch.
    /// `None` as [`InvolutePair::operating_pressure_angle`].
    pub fn base_backlash(&self, center_distance: f64) -> Option<f64> {
        let alpha = self.operating_pressure_angle(center_distance)?;
        Some(self.base_pitch - self.base_thicknesses + 2.0 * self.base_radii * involute::inv(alpha))
    }

    /// Circumferential backlash `j_wt = j_bt/cos α_wt`, mm, on the operating circles of centre distance `a`, mm.
    ///
    /// `None` as [`InvolutePair::operating_pressure_angle`].
    pub fn circumferential_backlash(&self, center_distance: f64) -> Option<f64> {
        let base = self.base_backlash(center_distance)?;
        Some(base * center_distance / self.base_radii)
    }

    /// Centre distance `a`, mm, at which the base circle backlash is `j_bt`, mm: the inverse of
    /// [`InvolutePair::base_backlash`]; K (17) for `j_bt = 0`.
    ///
    /// `None` if touching base circles already have more backlash.
    pub fn center_distance(&self, base_backlash: f64) -> Option<f64> {
        let inv =
            (base_backlash + self.base_thicknesses - self.base_pitch) / (2.0 * self.base_radii);
        (inv > 0.0).then(|| involute::radius_at(involute::roll_of_inv(inv), self.base_radii))
    }
}

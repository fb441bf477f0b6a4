//! Backlash in all usual units, converted from the circumferential backlash `j_wt`.
//!
//! Symbols and conversions follow ISO 21771, also for helical gears. Negative values mean interference.

use super::gear_pair::{GearPair, Member};
use crate::gear::involute;

/// A backlash of a pair at its centre distance, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Backlash {
    /// Circumferential backlash `j_wt`: an arc of the operating pitch circles.
    pub j_wt: f64,
    /// Transverse backlash `j_t = j_wt r/r_w`: the lost motion as an arc of the reference circle, equal for both gears.
    pub j_t: f64,
    /// Normal backlash `j_bn = j_wt cos α_wt cos β_b`: along the normal of the flanks.
    pub j_bn: f64,
    /// Radial backlash `j_r = a − a_0`: the reduction of the centre distance that removes the backlash of involutes.
    ///
    /// `None` if some backlash is left on touching base circles. The first order, `j_wt/(2 tan α_wt)`, differs by some 1 %.
    pub j_r: Option<f64>,
    pitch_radii: [f64; 2],
}

impl Backlash {
    /// The circumferential backlash `j_wt`, mm, of `assembly` in all units.
    pub fn new(assembly: &GearPair, j_wt: f64) -> Backlash {
        let angle = assembly.operating_pressure_angle();
        let wheel_radius = assembly.operating_pitch_radius(Member::Wheel);
        let reference = assembly.gear(Member::Wheel).gear().basic_data();
        Backlash {
            j_wt,
            j_t: j_wt * reference.reference_radius() / wheel_radius,
            j_bn: j_wt * angle.cos() * reference.base_helix_angle().cos(),
            j_r: radial_backlash(assembly, j_wt * angle.cos()),
            pitch_radii: [
                wheel_radius,
                assembly.operating_pitch_radius(Member::Pinion),
            ],
        }
    }

    /// Base circle backlash `j_bt = φ_j r_b = j_wt r_b/r_w`, mm, along the line of action in the transverse section; `j_bn` for spur gears.
    pub fn j_bt(&self, assembly: &GearPair) -> f64 {
        self.j_wt * assembly.operating_pressure_angle().cos()
    }

    /// Lost motion `φ_j = j_wt/r_w` of `gear`, rad, with its mate fixed.
    pub fn angle(&self, gear: Member) -> f64 {
        self.j_wt / self.pitch_radii[gear as usize]
    }

    /// Lost motion of `gear`, arcmin.
    pub fn arcmin(&self, gear: Member) -> f64 {
        arcmin(self.angle(gear))
    }
}

/// `a − a_0`, mm, for a base circle backlash, mm: `j_bt = (d_b1 + d_b2) (inv α_wt − inv α_w0)` and `a_0 = (r_b1 + r_b2)/cos α_w0`,
/// from `d(inv α) = tan² α dα` and `dj_bt/da = 2 sin α_w`.
fn radial_backlash(assembly: &GearPair, j_bt: f64) -> Option<f64> {
    let base = |member| assembly.gear(member).gear().base_radius();
    let sum = base(Member::Wheel) + base(Member::Pinion);
    let at_zero = involute::inv(assembly.operating_pressure_angle()) - j_bt / (2.0 * sum);
    let roll = involute::roll_of_inv(at_zero);
    (at_zero > 0.0).then(|| assembly.center_distance() - involute::radius_at(roll, sum))
}

/// A unit for showing backlash, at any centre distance of two gears.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum BacklashUnit {
    /// `j_wt` in µm.
    #[default]
    Um,
    /// Lost motion at one gear, in arcmin.
    Arcmin {
        /// The gear that turns.
        at: Member,
        /// Its share of the centre distance, `r_w/a = r_b/(r_b1 + r_b2)`.
        share: f64,
    },
}

impl BacklashUnit {
    /// `µm` or `arcmin`.
    pub fn name(self) -> &'static str {
        match self {
            BacklashUnit::Um => "µm",
            BacklashUnit::Arcmin { .. } => "arcmin",
        }
    }

    /// Converts `j_wt_um`, `j_wt` in µm, to this unit at centre distance `a`, mm.
    pub fn of_um(self, j_wt_um: f64, a: f64) -> f64 {
        match self {
            BacklashUnit::Um => j_wt_um,
            BacklashUnit::Arcmin { share, .. } => arcmin(j_wt_um * 1e-3 / (share * a)),
        }
    }
}

/// An angle, rad, in arcmin.
pub fn arcmin(angle: f64) -> f64 {
    angle.to_degrees() * 60.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Base circles of 30/20 teeth at `cos α_wt` = 0.9: inv α_wt = √0.19/0.9 − acos 0.9 = 0.0333. A backlash above (d_b1 + d_b2) times that
    /// remains at any distance.
    #[test]
    fn too_much_backlash_is_left_at_any_distance() {
        let sum = 50.0 * 20f64.to_radians().cos();
        let pair = GearPair::plain([30, 20], [0.0; 2], sum / 0.9, Member::Wheel);
        let most = 2.0 * sum * (0.19f64.sqrt() / 0.9 - 0.9f64.acos()) / 0.9;
        assert!(Backlash::new(&pair, 0.999 * most).j_r.is_some());
        assert_eq!(Backlash::new(&pair, 1.001 * most).j_r, None);
    }
}

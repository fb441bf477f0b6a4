//! What two gears must share to mesh, and the circles that follow from it.

use super::involute;
use crate::error::GearError;
use std::f64::consts::{PI, TAU};

/// Teeth `z`, module `m` (mm) and pressure angle `α` (rad) of a spur gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasicGearData {
    teeth: u32,
    module: f64,
    pressure_angle: f64,
}

impl BasicGearData {
    /// The basic data of a gear; `module` in mm, `pressure_angle` in radians.
    ///
    /// # Errors
    /// Outside 3…10 000 teeth, 0.01…1000 mm, 5…45°. (An angle within 1e-12 of
    /// its end counts as in: degrees do not convert exactly.)
    pub fn new(teeth: u32, module: f64, pressure_angle: f64) -> Result<BasicGearData, GearError> {
        let range = |what, value, allowed| {
            Err(GearError::OutOfRange {
                what,
                value,
                allowed,
            })
        };
        if !(3..=10_000).contains(&teeth) {
            return range("teeth", f64::from(teeth), "3 … 10 000");
        }
        if !(0.01..=1000.0).contains(&module) {
            return range("module", module, "0.01 … 1000 mm");
        }
        let degrees = pressure_angle.to_degrees();
        if !(5.0 - 1e-12..=45.0 + 1e-12).contains(&degrees) {
            return range("pressure angle", degrees, "5 … 45 degrees");
        }
        Ok(BasicGearData {
            teeth,
            module,
            pressure_angle,
        })
    }

    /// `z`.
    pub fn teeth(&self) -> u32 {
        self.teeth
    }

    /// `m`, mm.
    pub fn module(&self) -> f64 {
        self.module
    }

    /// `α`, rad.
    pub fn pressure_angle(&self) -> f64 {
        self.pressure_angle
    }

    /// Angular pitch `τ = 2π/z`, rad.
    pub fn angular_pitch(&self) -> f64 {
        TAU / f64::from(self.teeth)
    }

    /// The tooth (fractional, `1 ≤ … < z + 1`) whose undisturbed centre lies at `angle`, rad, along ascending numbers from that of
    /// tooth 1.
    pub fn tooth_towards(&self, angle: f64) -> f64 {
        let teeth = f64::from(self.teeth);
        let tooth = 1.0 + (angle / self.angular_pitch()).rem_euclid(teeth);
        // rem_euclid of a tiny negative number rounds up to z itself, as the sum may.
        if tooth < teeth + 1.0 { tooth } else { 1.0 }
    }

    /// Reference radius `r = m z/2`, mm.
    pub fn reference_radius(&self) -> f64 {
        self.module * f64::from(self.teeth) / 2.0
    }

    /// Base radius `r_b = r cos α`, mm.
    pub fn base_radius(&self) -> f64 {
        self.reference_radius() * self.pressure_angle.cos()
    }

    /// Half the angle a tooth of generating shift `x` (modules) spans on the base circle, rad:
    /// `s_b/(2 r_b) = (π/2 + 2 x tan α)/z + inv α`.
    pub fn half_base_angle(&self, x: f64) -> f64 {
        let alpha = self.pressure_angle;
        (PI / 2.0 + 2.0 * x * alpha.tan()) / f64::from(self.teeth) + involute::inv(alpha)
    }

    /// Base pitch `p_b = π m cos α`, mm (the study's `t_g`).
    pub fn base_pitch(&self) -> f64 {
        PI * self.module * self.pressure_angle.cos()
    }
}

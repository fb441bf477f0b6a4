//! What two gears must share to mesh, and the circles that follow from it.

use super::involute;
use crate::error::GearError;
use std::f64::consts::{PI, TAU};

/// Greatest helix angle, degrees: beyond it gears are called worms.
const MOST_HELIX_DEG: f64 = 60.0;

/// Which way the teeth of a helical gear wind about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum Hand {
    /// As on a left-hand screw.
    Left,
    // Its sections turn clockwise as they go away from the viewer.
    /// As on a right-hand screw.
    Right,
}

impl Hand {
    /// The hand of an external mate.
    pub fn mate(self) -> Hand {
        match self {
            Hand::Right => Hand::Left,
            Hand::Left => Hand::Right,
        }
    }

    /// `left` or `right`.
    pub fn name(self) -> &'static str {
        match self {
            Hand::Right => "right",
            Hand::Left => "left",
        }
    }

    /// `η`: +1 of a right hand.
    pub(crate) fn sense(self) -> f64 {
        match self {
            Hand::Right => 1.0,
            Hand::Left => -1.0,
        }
    }
}

/// Teeth `z`, normal module `m_n` (mm), normal pressure angle `α_n` and helix angle `β` (rad) of a cylindrical gear.
///
/// Of a spur gear, `β = 0`, normal and transverse sections are one. Tooth heights are in normal modules; circles, pitches and
/// angles are of the transverse section. Symbols and formulas as in ISO 21771.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasicGearData {
    teeth: u32,
    module: f64,
    pressure_angle: f64,
    helix: Option<Helix>,
}

/// Helix angle and what follows from it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Helix {
    angle: f64,
    hand: Hand,
    cos: f64,
    /// `α_t`.
    pressure_angle: f64,
}

impl BasicGearData {
    /// The basic data of a spur gear; `module` in mm, `pressure_angle` in radians.
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
            helix: None,
        })
    }

    /// The same teeth, module and pressure angle in the normal section, wound by `angle`, rad, at the reference circle; an angle of 0
    /// leaves a spur gear, whichever the hand.
    ///
    /// # Errors
    /// Outside 0…60°.
    pub fn with_helix(self, angle: f64, hand: Hand) -> Result<BasicGearData, GearError> {
        let degrees = angle.to_degrees();
        if !(0.0..=MOST_HELIX_DEG + 1e-12).contains(&degrees) {
            return Err(GearError::OutOfRange {
                what: "helix angle",
                value: degrees,
                allowed: "0 … 60 degrees",
            });
        }
        let cos = angle.cos();
        let helix = Helix {
            angle,
            hand,
            cos,
            pressure_angle: (self.pressure_angle.tan() / cos).atan(),
        };
        Ok(BasicGearData {
            helix: (angle > 0.0).then_some(helix),
            ..self
        })
    }

    /// The same but for its module, mm.
    ///
    /// # Errors
    /// As [`BasicGearData::new`].
    pub fn with_module(&self, module: f64) -> Result<BasicGearData, GearError> {
        let helix = self.helix;
        let data = BasicGearData::new(self.teeth, module, self.pressure_angle)?;
        Ok(BasicGearData { helix, ..data })
    }

    /// `z`.
    pub fn teeth(&self) -> u32 {
        self.teeth
    }

    /// Normal module `m_n`, mm.
    pub fn module(&self) -> f64 {
        self.module
    }

    /// Normal pressure angle `α_n`, rad.
    pub fn pressure_angle(&self) -> f64 {
        self.pressure_angle
    }

    /// Helix angle `β` at the reference circle, rad; 0 of a spur gear.
    pub fn helix_angle(&self) -> f64 {
        self.helix.map_or(0.0, |helix| helix.angle)
    }

    /// Hand of the helix; `None` of a spur gear.
    pub fn hand(&self) -> Option<Hand> {
        self.helix.map(|helix| helix.hand)
    }

    /// `cos β`.
    pub fn helix_cos(&self) -> f64 {
        self.helix.map_or(1.0, |helix| helix.cos)
    }

    /// Base helix angle `β_b`, rad: `sin β_b = sin β cos α_n`.
    pub fn base_helix_angle(&self) -> f64 {
        self.helix.map_or(0.0, |helix| {
            (helix.angle.sin() * self.pressure_angle.cos()).asin()
        })
    }

    /// Transverse pressure angle `α_t`, rad: `tan α_t = tan α_n/cos β`.
    pub fn transverse_pressure_angle(&self) -> f64 {
        self.helix
            .map_or(self.pressure_angle, |helix| helix.pressure_angle)
    }

    /// How far sections turn a mm along the axis away from the viewer, rad/mm, counter-clockwise positive: `−η tan β_b/r_b = −η tan β/r`.
    pub fn twist(&self) -> f64 {
        self.helix.map_or(0.0, |helix| {
            -helix.hand.sense() * helix.angle.tan() / self.reference_radius()
        })
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

    /// Reference radius `r = m_n z/(2 cos β)`, mm.
    pub fn reference_radius(&self) -> f64 {
        self.module * f64::from(self.teeth) / 2.0 / self.helix_cos()
    }

    /// Base radius `r_b = r cos α_t`, mm.
    pub fn base_radius(&self) -> f64 {
        self.reference_radius() * self.transverse_pressure_angle().cos()
    }

    /// Half the angle a tooth of generating shift `x` (normal modules) spans on the base circle, rad:
    /// `s_bt/(2 r_b) = (π/2 + 2 x tan α_n)/z + inv α_t`.
    pub fn half_base_angle(&self, x: f64) -> f64 {
        (PI / 2.0 + 2.0 * x * self.pressure_angle.tan()) / f64::from(self.teeth)
            + involute::inv(self.transverse_pressure_angle())
    }

    /// Transverse base pitch `p_bt = π m_n cos α_t/cos β`, mm (the study's `t_g`).
    pub fn base_pitch(&self) -> f64 {
        PI * self.module * self.transverse_pressure_angle().cos() / self.helix_cos()
    }
}

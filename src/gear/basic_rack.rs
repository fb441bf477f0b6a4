//! The standard basic rack tooth profile (ISO 53): proportions in modules.

use super::BasicGearData;
use crate::error::GearError;

/// Modules within which a tool's flat is none: the rounding of a full tip round that was computed by the formula.
const FULL_ROUND: f64 = 1e-12;

/// Basic rack `h_aP*`, `h_fP*`, `ρ_fP*`: addendum, dedendum and root radius in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasicRack {
    addendum: f64,
    dedendum: f64,
    root_radius: f64,
}

impl BasicRack {
    /// ISO 53 profile A: 1.0, 1.25, 0.38.
    pub const ISO_53_A: BasicRack = BasicRack {
        addendum: 1.0,
        dedendum: 1.25,
        root_radius: 0.38,
    };

    /// A basic rack from its proportions in modules.
    ///
    /// # Errors
    /// When addendum or dedendum is not in (0, 10], or the root radius is
    /// negative or larger than the dedendum. Whether the tip round fits the
    /// tool's tooth depends on the pressure angle: [`BasicRack::check_tip_round`].
    pub fn new(addendum: f64, dedendum: f64, root_radius: f64) -> Result<BasicRack, GearError> {
        const DEPTH: &str = "a number of modules above 0 and up to 10";
        for (what, value) in [("addendum", addendum), ("dedendum", dedendum)] {
            if !(value > 0.0 && value <= 10.0) {
                return Err(GearError::OutOfRange {
                    what,
                    value,
                    allowed: DEPTH,
                });
            }
        }
        if !(root_radius >= 0.0 && root_radius <= dedendum) {
            return Err(GearError::OutOfRange {
                what: "root fillet radius",
                value: root_radius,
                allowed: "0 up to the dedendum",
            });
        }
        Ok(BasicRack {
            addendum,
            dedendum,
            root_radius,
        })
    }

    /// `h_aP*`.
    pub fn addendum(&self) -> f64 {
        self.addendum
    }

    /// `h_fP*`.
    pub fn dedendum(&self) -> f64 {
        self.dedendum
    }

    /// `ρ_fP*`, the tool's tip round.
    pub fn root_radius(&self) -> f64 {
        self.root_radius
    }

    /// `c_0`, mm: half the flat left on the tool's tip, `πm/4 − (h_fP − ρ) tan α − ρ/cos α`.
    ///
    /// From the tool's symmetry line to the centre of its tip round.
    pub fn half_tip_flat(&self, basic_data: &BasicGearData) -> f64 {
        let (sin, cos) = basic_data.pressure_angle().sin_cos();
        basic_data.module()
            * (std::f64::consts::FRAC_PI_4
                - (self.dedendum - self.root_radius) * sin / cos
                - self.root_radius / cos)
    }

    /// Half the tool's flat between its tip rounds, which cuts half the root land, mm: 0 where a full tip round leaves
    /// none, or no more than the rounding of its radius does.
    pub fn half_root_land(&self, basic_data: &BasicGearData) -> f64 {
        let flat = self.half_tip_flat(basic_data);
        if flat > FULL_ROUND * basic_data.module() {
            flat
        } else {
            0.0
        }
    }

    /// Whether the two tip rounds fit the tool's tooth: `c_0 ≥ 0`.
    ///
    /// # Errors
    /// [`GearError::TipRoundTooLarge`] with the greatest radius that fits. A
    /// deficit within 1e-12 m is rounding (a full tip round computed by the
    /// user from the same formula) and counts as zero.
    pub fn check_tip_round(&self, basic_data: &BasicGearData) -> Result<(), GearError> {
        let deficit = -self.half_tip_flat(basic_data) / basic_data.module();
        if deficit <= FULL_ROUND {
            return Ok(());
        }
        // c_0 is linear in ρ with slope −(1 − sin α)/cos α.
        let (sin, cos) = basic_data.pressure_angle().sin_cos();
        Err(GearError::TipRoundTooLarge {
            root_radius: self.root_radius,
            most: self.root_radius - deficit * cos / (1.0 - sin),
        })
    }
}

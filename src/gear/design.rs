//! The design of a gear as a drawing states it: basic data (ISO 21771), basic rack (ISO 53), profile shift and tip diameter.

use super::involute;
use crate::error::GearError;
use std::f64::consts::{PI, TAU};

/// Greatest helix angle, degrees: beyond it lie worms.
const MOST_HELIX_DEG: f64 = 60.0;

/// Hand of a helix: the direction in which the teeth of a helical gear wind about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum Hand {
    /// As on a left-hand screw.
    Left,
    // Its sections turn clockwise with the distance from the viewer.
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

    /// `η`: +1 for a right hand, −1 for a left one.
    pub(crate) fn sense(self) -> f64 {
        match self {
            Hand::Right => 1.0,
            Hand::Left => -1.0,
        }
    }
}

/// Teeth `z`, normal module `m_n` (mm), normal pressure angle `α_n` and helix angle `β` (rad) of a cylindrical gear.
///
/// In a spur gear (`β = 0`) normal and transverse section coincide. Tooth heights are in normal modules. Circles, pitches and
/// angles lie in the transverse section. Symbols and formulas follow ISO 21771.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasicGearData {
    teeth: u32,
    module: f64,
    pressure_angle: f64,
    helix: Option<Helix>,
}

/// Helix angle with derived values.
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
    /// Values outside 3…10 000 teeth, 0.01…1000 mm, 5…45°. An angle within 1e-12 of a limit is accepted, because degrees do not
    /// convert exactly.
    pub fn new(teeth: u32, module: f64, pressure_angle: f64) -> Result<BasicGearData, GearError> {
        let z = f64::from(teeth);
        GearError::require((3..=10_000).contains(&teeth), "teeth", z, "3 … 10 000")?;
        let is_module = (0.01..=1000.0).contains(&module);
        GearError::require(is_module, "module", module, "0.01 … 1000 mm")?;
        let degrees = pressure_angle.to_degrees();
        let is_angle = (5.0 - 1e-12..=45.0 + 1e-12).contains(&degrees);
        GearError::require(is_angle, "pressure angle", degrees, "5 … 45 degrees")?;
        Ok(BasicGearData {
            teeth,
            module,
            pressure_angle,
            helix: None,
        })
    }

    /// These data with the helix angle `angle`, rad, at the reference circle. An angle of 0 gives a spur gear.
    ///
    /// # Errors
    /// An angle outside 0…60°.
    pub fn with_helix(self, angle: f64, hand: Hand) -> Result<BasicGearData, GearError> {
        let degrees = angle.to_degrees();
        GearError::require(
            (0.0..=MOST_HELIX_DEG + 1e-12).contains(&degrees),
            "helix angle",
            degrees,
            "0 … 60 degrees",
        )?;
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

    /// These data with another normal module, mm.
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

    /// Helix angle `β` at the reference circle, rad; 0 for a spur gear.
    pub fn helix_angle(&self) -> f64 {
        self.helix.map_or(0.0, |helix| helix.angle)
    }

    /// Hand of the helix; `None` for a spur gear.
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

    /// Rotation of the section per mm away from the viewer, rad/mm, counter-clockwise positive: `−η tan β_b/r_b = −η tan β/r`.
    pub fn twist(&self) -> f64 {
        self.helix.map_or(0.0, |helix| {
            -helix.hand.sense() * helix.angle.tan() / self.reference_radius()
        })
    }

    /// Angular pitch `τ = 2π/z`, rad.
    pub fn angular_pitch(&self) -> f64 {
        TAU / f64::from(self.teeth)
    }

    /// The tooth (fractional, `1 ≤ … < z + 1`) whose undisturbed centre lies at `angle`, rad, from tooth 1 along ascending numbers.
    ///
    /// ```
    /// let gear = gearlash::gear::BasicGearData::new(21, 1.5, 20f64.to_radians()).unwrap();
    /// // Rounding does not make tooth 1 the tooth 22.
    /// assert_eq!(gear.tooth_towards(-1e-13), 1.0);
    /// assert!((gear.tooth_towards(-0.5 * gear.angular_pitch()) - 21.5).abs() < 1e-12);
    /// ```
    pub fn tooth_towards(&self, angle: f64) -> f64 {
        self.tooth_after(angle / self.angular_pitch())
    }

    /// The tooth (fractional, `1 ≤ … < z + 1`) that is this number of pitches after tooth 1, along ascending numbers.
    pub(crate) fn tooth_after(&self, pitches: f64) -> f64 {
        let teeth = f64::from(self.teeth);
        let tooth = 1.0 + pitches.rem_euclid(teeth);
        // Rounding, also of `rem_euclid`, can put tooth 1 just below z + 1.
        if tooth < teeth + 1.0 - 1e-9 {
            tooth
        } else {
            1.0
        }
    }

    /// Reference radius `r = m_n z/(2 cos β)`, mm.
    pub fn reference_radius(&self) -> f64 {
        self.module * f64::from(self.teeth) / 2.0 / self.helix_cos()
    }

    /// Base radius `r_b = r cos α_t`, mm.
    pub fn base_radius(&self) -> f64 {
        self.reference_radius() * self.transverse_pressure_angle().cos()
    }

    /// Half the angle of a tooth with generating shift `x` (normal modules) on the base circle, rad:
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

/// A shorter flat of the tool counts as none, modules: the rounding of a computed full tip round.
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
    /// Addendum or dedendum outside (0, 10], a root radius below 0 or above the dedendum. The tip round must also fit the tool's
    /// tooth, which depends on the pressure angle: [`BasicRack::check_tip_round`].
    pub fn new(addendum: f64, dedendum: f64, root_radius: f64) -> Result<BasicRack, GearError> {
        const DEPTH: &str = "a number of modules above 0 and up to 10";
        for (what, value) in [("addendum", addendum), ("dedendum", dedendum)] {
            GearError::require(value > 0.0 && value <= 10.0, what, value, DEPTH)?;
        }
        GearError::require(
            root_radius >= 0.0 && root_radius <= dedendum,
            "root fillet radius",
            root_radius,
            "0 up to the dedendum",
        )?;
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

    /// `c_0 = πm/4 − (h_fP − ρ) tan α − ρ/cos α`, mm: half the flat on the tool's tip.
    ///
    /// It is the distance from the tool's symmetry line to the centre of its tip round.
    pub fn half_tip_flat(&self, basic_data: &BasicGearData) -> f64 {
        let (sin, cos) = basic_data.pressure_angle().sin_cos();
        basic_data.module()
            * (std::f64::consts::FRAC_PI_4
                - (self.dedendum - self.root_radius) * sin / cos
                - self.root_radius / cos)
    }

    /// Half the tool's flat between its tip rounds, mm, which cuts half the root land. It is 0 for a full tip round, to rounding.
    pub fn half_root_land(&self, basic_data: &BasicGearData) -> f64 {
        let flat = self.half_tip_flat(basic_data);
        if flat > FULL_ROUND * basic_data.module() {
            flat
        } else {
            0.0
        }
    }

    /// Checks that the two tip rounds fit the tool's tooth: `c_0 ≥ 0`.
    ///
    /// # Errors
    /// [`GearError::TipRoundTooLarge`] with the greatest radius that fits. A deficit within 1e-12 m is the rounding of a computed
    /// full tip round and counts as zero.
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

/// The nominal gear of a drawing: basic data, profile shift, rack, tip diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearDesign {
    /// Teeth, module, pressure angle.
    pub basic_data: BasicGearData,
    /// Profile shift coefficient `x`.
    pub profile_shift: f64,
    /// Basic rack.
    pub rack: BasicRack,
    /// Tip diameter `d_a`, mm; `None`: `m z + 2 m (h_aP* + x)`.
    pub tip_diameter: Option<f64>,
}

impl GearDesign {
    /// A gear of ISO 53 rack profile A without profile shift. Its tip diameter follows.
    pub fn standard(basic_data: BasicGearData) -> GearDesign {
        GearDesign {
            basic_data,
            profile_shift: 0.0,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        }
    }

    /// Nominal tooth thickness `s_n = m_n (π/2 + 2 x tan α_n)` at the reference circle in the normal section, mm.
    pub fn nominal_thickness(&self) -> f64 {
        let alpha = self.basic_data.pressure_angle();
        self.basic_data.module() * (PI / 2.0 + 2.0 * self.profile_shift * alpha.tan())
    }

    /// Nominal transverse base tooth thickness `s_bt = r_b (s_t/r + 2 inv α_t)`, mm, with `s_t = s_n/cos β`.
    pub fn nominal_base_thickness(&self) -> f64 {
        2.0 * self.basic_data.base_radius() * self.basic_data.half_base_angle(self.profile_shift)
    }

    /// Tip radius `r_a`, mm.
    pub fn tip_radius(&self) -> f64 {
        match self.tip_diameter {
            Some(diameter) => diameter / 2.0,
            None => {
                self.basic_data.reference_radius()
                    + self.basic_data.module() * (self.rack.addendum() + self.profile_shift)
            }
        }
    }
}

//! A gear as generated: radii, mean base tooth thickness, generating shift.

use super::{BasicGearData, BasicRack, Fillet, involute};
use crate::error::GearError;
use std::f64::consts::PI;

/// What the drawing says, before any measured thickness: basic_data, profile shift, rack, tip.
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
    /// Nominal tooth thickness `s = m (π/2 + 2 x tan α)` at the reference circle, mm.
    pub fn nominal_thickness(&self) -> f64 {
        let alpha = self.basic_data.pressure_angle();
        self.basic_data.module() * (PI / 2.0 + 2.0 * self.profile_shift * alpha.tan())
    }

    /// Nominal base tooth thickness `s_b = r_b (s/r + 2 inv α)`, mm, of `s = m (π/2 + 2 x tan α)`.
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

#[cfg(test)]
impl GearDesign {
    /// The gear most tests take: 20°, ISO 53 profile A, no profile shift.
    pub(crate) fn plain(teeth: u32, module: f64) -> GearDesign {
        GearDesign {
            basic_data: BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap(),
            profile_shift: 0.0,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        }
    }
}

/// A gear with teeth of one mean thickness. Every value is fixed at construction;
/// a `Gear` that exists has teeth with a tip land, an involute and a tooth space.
#[derive(Debug, Clone, PartialEq)]
pub struct Gear {
    design: GearDesign,
    base_thickness: f64,
    generating_shift: f64,
    fillet: Fillet,
}

impl Gear {
    /// A gear of `design` whose teeth have the mean `base_thickness` `s_b`, mm.
    ///
    /// The thickness decides the generating shift
    /// `x_E = x + (s − s_nominal)/(2 m tan α)` (design section 4) and with it
    /// root circle and fillet; the tip circle follows `x` or the given tip diameter.
    ///
    /// # Errors
    /// A gear that cannot exist: tip round too large, cusped fillet, pointed
    /// tooth, no involute between form and tip circle, no tooth space, a tooth that undercut has cut off.
    pub fn new(design: GearDesign, base_thickness: f64) -> Result<Gear, GearError> {
        let basic_data = &design.basic_data;
        let base = basic_data.base_radius();
        if !(base_thickness > 0.0 && base_thickness.is_finite()) {
            return Err(GearError::OutOfRange {
                what: "base tooth thickness (mm)",
                value: base_thickness,
                allowed: "a positive number",
            });
        }
        // s − s_nominal = (s_b − s_b,nominal)/cos α, since s_b = cos α (s + 2 r inv α).
        let alpha = basic_data.pressure_angle();
        let generating_shift = design.profile_shift
            + (base_thickness - design.nominal_base_thickness())
                / (2.0 * basic_data.module() * alpha.sin());
        let fillet = Fillet::new(basic_data, &design.rack, generating_shift)?;
        let gear = Gear {
            design,
            base_thickness,
            generating_shift,
            fillet,
        };
        let pointed = involute::radius_at(involute::roll_of_inv(gear.half_base_angle()), base);
        if gear.tip_radius() >= pointed {
            return Err(GearError::Pointed {
                pointed_diameter_mm: 2.0 * pointed,
                tip_diameter_mm: 2.0 * gear.tip_radius(),
            });
        }
        if gear.tip_roll() <= gear.form_roll() || gear.tip_radius() <= base {
            return Err(GearError::NoInvolute {
                form_diameter_mm: 2.0 * gear.form_radius(),
                tip_diameter_mm: 2.0 * gear.tip_radius(),
            });
        }
        // The space closes where the fillet's root end passes the tooth's own flank at the root,
        // or where neighbouring involutes meet at the form circle.
        let pitch = basic_data.angular_pitch();
        if gear.root_radius() <= 0.0 || 2.0 * gear.half_angle_at_roll(gear.form_roll()) >= pitch {
            return Err(GearError::NoSpace {
                base_thickness_mm: base_thickness,
            });
        }
        if gear.fillet.neck() >= 0.0 {
            return Err(GearError::NoNeck {
                base_thickness_mm: base_thickness,
            });
        }
        Ok(gear)
    }

    /// A gear of nominal thickness.
    ///
    /// # Errors
    /// As [`Gear::new`].
    pub fn nominal(design: GearDesign) -> Result<Gear, GearError> {
        Gear::new(design, design.nominal_base_thickness())
    }

    /// What the drawing says.
    pub fn design(&self) -> &GearDesign {
        &self.design
    }

    /// Teeth, module, pressure angle.
    pub fn basic_data(&self) -> &BasicGearData {
        &self.design.basic_data
    }

    /// The generated fillet.
    pub fn fillet(&self) -> &Fillet {
        &self.fillet
    }

    /// Mean base tooth thickness `s_b`, mm.
    pub fn base_thickness(&self) -> f64 {
        self.base_thickness
    }

    /// Generating profile shift coefficient `x_E`.
    pub fn generating_shift(&self) -> f64 {
        self.generating_shift
    }

    /// Base radius `r_b`, mm.
    pub fn base_radius(&self) -> f64 {
        self.basic_data().base_radius()
    }

    /// Tip radius `r_a`, mm.
    pub fn tip_radius(&self) -> f64 {
        self.design.tip_radius()
    }

    /// Generated root radius `r_f = r − m (h_fP* − x_E)`, mm.
    pub fn root_radius(&self) -> f64 {
        self.basic_data().reference_radius()
            - self.basic_data().module() * (self.design.rack.dedendum() - self.generating_shift)
    }

    /// Root form radius `r_Ff = d_Ff/2`, mm: where the usable involute begins.
    pub fn form_radius(&self) -> f64 {
        involute::radius_at(self.form_roll(), self.base_radius())
    }

    /// Roll `ξ` at the root form circle.
    pub fn form_roll(&self) -> f64 {
        self.fillet.form_roll()
    }

    /// Roll `ξ` at the tip circle.
    pub fn tip_roll(&self) -> f64 {
        involute::roll_at(self.tip_radius(), self.base_radius())
    }

    /// Half the angle a tooth spans on the base circle, `s_b/(2 r_b)`, rad.
    pub fn half_base_angle(&self) -> f64 {
        self.base_thickness / (2.0 * self.base_radius())
    }

    /// Half the angle a tooth spans at the involute's roll `xi`, rad (ISO 21771: `ψ_b − inv α_y`).
    pub fn half_angle_at_roll(&self, xi: f64) -> f64 {
        self.half_base_angle() - involute::inv_of_roll(xi)
    }
}

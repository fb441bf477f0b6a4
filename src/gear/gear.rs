//! A gear as generated: radii, mean base tooth thickness, generating shift.

use super::part::{Arc, InvoluteFlank, Part, PartCurve, ProfilePart};
use super::{BasicGearData, Fillet, GearDesign, involute};
use crate::error::GearError;
use std::f64::consts::{FRAC_PI_2, PI};

/// Root radius generated with the shift `x_e`, mm.
fn root_radius(design: &GearDesign, x_e: f64) -> f64 {
    design.basic_data.reference_radius()
        - design.basic_data.module() * (design.rack.dedendum() - x_e)
}

/// The half tooth that the rack cuts.
fn generated(
    design: &GearDesign,
    base_thickness: f64,
    fillet: &Fillet,
    generating_shift: f64,
) -> [Part; 4] {
    let basic_data = &design.basic_data;
    let (base, tip) = (basic_data.base_radius(), design.tip_radius());
    let half_base = base_thickness / (2.0 * base);
    let tip_roll = involute::roll_at(tip, base);
    // An undercut fillet ends before the tangency.
    let undercut = fillet.end() < FRAC_PI_2 - basic_data.transverse_pressure_angle();
    let land = |radius: f64, ends: [f64; 2]| Part {
        curve: PartCurve::Arc(Arc::new(radius)),
        ends,
        corners: [false; 2],
    };
    [
        land(tip, [0.0, half_base - involute::inv_of_roll(tip_roll)]),
        Part {
            curve: PartCurve::Involute(InvoluteFlank::new(base, half_base)),
            ends: [tip_roll, fillet.form_roll()],
            corners: [true, undercut],
        },
        Part {
            curve: PartCurve::Trochoid(*fillet),
            ends: [fillet.end(), 0.0],
            corners: [undercut, false],
        },
        land(
            root_radius(design, generating_shift),
            [-fillet.root_angle(), PI / f64::from(basic_data.teeth())],
        ),
    ]
}

/// A gear with teeth of one mean thickness. Every tooth has a tip land, a flank and a space: the constructors check it.
#[derive(Debug, Clone, PartialEq)]
pub struct Gear {
    design: GearDesign,
    base_thickness: f64,
    generating_shift: f64,
    fillet: Fillet,
    /// The half tooth, from the tip to the root.
    parts: [Part; 4],
    /// Half the angle a tooth spans at its neck below the flank, rad.
    neck_half_angle: f64,
}

impl Gear {
    /// A gear of `design` whose teeth have the mean transverse `base_thickness` `s_bt`, mm.
    ///
    /// The thickness determines the generating shift `x_E = x + (s_n − s_n,nominal)/(2 m_n tan α_n)`, and so
    /// root circle and fillet. The tip circle follows `x` or the given tip diameter.
    ///
    /// # Errors
    /// A gear that cannot exist: tip round too large, cusped fillet, pointed tooth, no involute between form and tip circle, no
    /// tooth space, a tooth cut off by undercut.
    pub fn new(design: GearDesign, base_thickness: f64) -> Result<Gear, GearError> {
        let basic_data = &design.basic_data;
        let base = basic_data.base_radius();
        GearError::require(
            base_thickness > 0.0 && base_thickness.is_finite(),
            "base tooth thickness (mm)",
            base_thickness,
            "a positive number",
        )?;
        // s_t − s_t,nominal = (s_bt − s_bt,nominal)/cos α_t, since s_bt = cos α_t (s_t + 2 r inv α_t); s_n = s_t cos β, and
        // tan α_n = tan α_t cos β.
        let alpha = basic_data.transverse_pressure_angle();
        let generating_shift = design.profile_shift
            + (base_thickness - design.nominal_base_thickness())
                / (2.0 * basic_data.module() * alpha.sin());
        let fillet = Fillet::new(basic_data, &design.rack, generating_shift)?;
        let parts = generated(&design, base_thickness, &fillet, generating_shift);
        let mut gear = Gear {
            design,
            base_thickness,
            generating_shift,
            fillet,
            parts,
            neck_half_angle: 0.0,
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
        // A space is closed if the root radius is not positive or neighbouring involutes meet at the form circle.
        let pitch = basic_data.angular_pitch();
        if gear.root_radius() <= 0.0 || 2.0 * gear.half_angle_at_roll(gear.form_roll()) >= pitch {
            return Err(GearError::NoSpace {
                base_thickness_mm: base_thickness,
            });
        }
        gear.neck_half_angle = match gear.part(ProfilePart::Fillet).range() {
            (low, high) if low < high => -gear.fillet.neck(),
            _ => gear.form_half_angle(),
        };
        if gear.neck_half_angle <= 0.0 {
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

    /// The design.
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

    /// Mean base tooth thickness `s_bt` in the transverse section, mm.
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
        root_radius(&self.design, self.generating_shift)
    }

    /// Root form radius `r_Ff = d_Ff/2`, mm: where the usable involute begins.
    pub fn form_radius(&self) -> f64 {
        involute::radius_at(self.form_roll(), self.base_radius())
    }

    /// One part of the half tooth.
    pub fn part(&self, part: ProfilePart) -> &Part {
        &self.parts[part as usize]
    }

    /// The parts of the half tooth, from the tip to the root.
    pub(super) fn parts(&self) -> &[Part; 4] {
        &self.parts
    }

    /// This gear with all lengths multiplied by `factor`, as by a change of temperature.
    ///
    /// # Errors
    /// A module out of range.
    pub fn expanded(&self, factor: f64) -> Result<Gear, GearError> {
        let basic_data = self.basic_data();
        let design = GearDesign {
            basic_data: basic_data.with_module(factor * basic_data.module())?,
            tip_diameter: Some(2.0 * factor * self.tip_radius()),
            ..self.design
        };
        Gear::new(design, factor * self.base_thickness)
    }

    /// Whether the fillet meets the flank in an edge.
    pub fn is_undercut(&self) -> bool {
        self.part(ProfilePart::Fillet).corners[0]
    }

    /// Half the angle a tooth spans at the tip circle, rad.
    pub fn tip_half_angle(&self) -> f64 {
        self.part(ProfilePart::Tip).ends[1]
    }

    /// Half the angle a tooth spans at the form circle, rad.
    pub(super) fn form_half_angle(&self) -> f64 {
        self.half_angle_at_roll(self.form_roll())
    }

    /// Half the angle a tooth spans at its neck below the flank, rad.
    pub(super) fn neck_half_angle(&self) -> f64 {
        self.neck_half_angle
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

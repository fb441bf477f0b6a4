//! Two gears at a centre distance, one of them fixed.

use crate::error::GearError;
use crate::gear::{AsBuilt, involute};
use nalgebra::Point2;
use std::f64::consts::PI;

/// One of the two gears.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum Member {
    // Its axis is at the origin.
    /// Gear 1.
    #[default]
    Wheel,
    // Its axis is at (a, 0).
    /// Gear 2.
    Pinion,
}

impl Member {
    /// Wheel and pinion.
    pub const BOTH: [Member; 2] = [Member::Wheel, Member::Pinion];

    /// The other gear.
    pub fn mate(self) -> Member {
        match self {
            Member::Wheel => Member::Pinion,
            Member::Pinion => Member::Wheel,
        }
    }

    /// Its axis in the picture at a centre distance, mm.
    pub(crate) fn axis(self, center_distance: f64) -> Point2<f64> {
        match self {
            Member::Wheel => Point2::origin(),
            Member::Pinion => Point2::new(center_distance, 0.0),
        }
    }

    /// Direction from its axis to its mate's in the picture, rad.
    pub(crate) fn mate_direction(self) -> f64 {
        match self {
            Member::Wheel => 0.0,
            Member::Pinion => PI,
        }
    }

    /// `wheel` or `pinion`.
    pub fn name(self) -> &'static str {
        match self {
            Member::Wheel => "wheel",
            Member::Pinion => "pinion",
        }
    }
}

/// Greatest relative difference of the modules of two mating gears: that of a hot plastic gear (1e-4/K, 200 K) and a steel gear.
pub const MOST_UNEQUAL: f64 = 0.02;

/// A pair as assembled: wheel axis at the origin, pinion axis at `(a, 0)`, y up.
#[derive(Debug, Clone, PartialEq)]
pub struct GearPair {
    wheel: AsBuilt,
    pinion: AsBuilt,
    center_distance: f64,
    locked: Member,
    /// The common face, mm along the axis.
    face: [f64; 2],
}

impl GearPair {
    /// Two gears at `center_distance` `a`, mm, with the wheel fixed.
    ///
    /// # Errors
    /// As [`GearPair::with_locked`].
    pub fn new(
        wheel: AsBuilt,
        pinion: AsBuilt,
        center_distance: f64,
    ) -> Result<GearPair, GearError> {
        GearPair::with_locked(wheel, pinion, center_distance, Member::Wheel)
    }

    /// Two gears at `center_distance` `a`, mm, with the gear `locked` fixed.
    ///
    /// # Errors
    /// Unequal pressure or helix angles; modules that differ by more than [`MOST_UNEQUAL`]; overlapping base circles
    /// (`a ≤ r_b1 + r_b2`), without an operating pressure angle. Helical gears of one hand or with profile deviations.
    pub fn with_locked(
        wheel: AsBuilt,
        pinion: AsBuilt,
        center_distance: f64,
        locked: Member,
    ) -> Result<GearPair, GearError> {
        let (w, p) = (*wheel.gear().basic_data(), *pinion.gear().basic_data());
        // A share of the greater module, plus the rounding of both.
        let most = (MOST_UNEQUAL + 4.0 * f64::EPSILON) * w.module().max(p.module());
        for (what, wheel, pinion, most) in [
            ("module (mm)", w.module(), p.module(), most),
            (
                "pressure angle (degrees)",
                w.pressure_angle().to_degrees(),
                p.pressure_angle().to_degrees(),
                0.0,
            ),
            (
                "helix angle (degrees)",
                w.helix_angle().to_degrees(),
                p.helix_angle().to_degrees(),
                0.0,
            ),
        ] {
            if !((wheel - pinion).abs() <= most) {
                return Err(GearError::Unequal {
                    what,
                    wheel,
                    pinion,
                });
            }
        }
        if let Some(hand) = w.hand().filter(|_| w.hand() == p.hand()) {
            return Err(GearError::SameHand { hand: hand.name() });
        }
        GearError::require(
            w.hand().is_none() || !(wheel.is_modified() || pinion.is_modified()),
            "helix angle, degrees, of gears whose profiles deviate",
            w.helix_angle().to_degrees(),
            "0: between such helical teeth the lost motion varies along the face",
        )?;
        let least = w.base_radius() + p.base_radius();
        if !(center_distance > least && center_distance.is_finite()) {
            return Err(GearError::BaseCirclesOverlap {
                center_distance_mm: center_distance,
                least_mm: least,
            });
        }
        Ok(GearPair {
            wheel,
            pinion,
            center_distance,
            locked,
            face: [0.0; 2],
        })
    }

    /// This pair with the common face from `from` to `to`, mm along the axis away from the viewer.
    ///
    /// 0 is the measuring plane, in which tooth 1, pitch and runout are stated. Without a face the gears face each other in that plane
    /// alone, which makes no difference for spur gears.
    ///
    /// # Errors
    /// Ends that are not finite, or not in this order.
    pub fn with_face(self, [from, to]: [f64; 2]) -> Result<GearPair, GearError> {
        if !(from <= to && from.is_finite() && to.is_finite()) {
            return Err(GearError::NoCommonFace {
                from_mm: from,
                to_mm: to,
            });
        }
        Ok(GearPair {
            face: [from, to],
            ..self
        })
    }

    /// The common face, mm along the axis, the end nearest to the viewer first.
    pub fn face(&self) -> [f64; 2] {
        self.face
    }

    /// Whether the gears are helical.
    pub fn is_helical(&self) -> bool {
        self.wheel.gear().basic_data().hand().is_some()
    }

    /// Whether either gear has lead deviations.
    pub fn has_leads(&self) -> bool {
        self.wheel.has_leads() || self.pinion.has_leads()
    }

    /// Whether transverse sections differ along the face: helical teeth, or lead deviations.
    pub fn varies_along_face(&self) -> bool {
        self.is_helical() || self.has_leads()
    }

    /// Whether either gear has profile deviations.
    pub fn is_modified(&self) -> bool {
        self.wheel.is_modified() || self.pinion.is_modified()
    }

    /// Whether the base pitches `p_b` differ by more than rounding, as at different temperatures.
    pub fn base_pitches_differ(&self) -> bool {
        let [wheel, pinion] =
            [&self.wheel, &self.pinion].map(|gear| gear.gear().basic_data().base_pitch());
        (wheel - pinion).abs() > 8.0 * f64::EPSILON * wheel
    }

    /// These gears at another centre distance.
    ///
    /// # Errors
    /// As [`GearPair::with_locked`].
    pub fn at(&self, center_distance: f64) -> Result<GearPair, GearError> {
        self.with_gears(self.wheel.clone(), self.pinion.clone(), center_distance)
    }

    /// Other gears with this pair's locked gear and common face, at a centre distance, mm.
    ///
    /// # Errors
    /// As [`GearPair::with_locked`].
    pub fn with_gears(
        &self,
        wheel: AsBuilt,
        pinion: AsBuilt,
        center_distance: f64,
    ) -> Result<GearPair, GearError> {
        let pair = GearPair::with_locked(wheel, pinion, center_distance, self.locked)?;
        Ok(GearPair {
            face: self.face,
            ..pair
        })
    }

    /// One of the gears.
    pub fn gear(&self, member: Member) -> &AsBuilt {
        match member {
            Member::Wheel => &self.wheel,
            Member::Pinion => &self.pinion,
        }
    }

    /// Teeth of one of the gears.
    pub fn teeth(&self, member: Member) -> u32 {
        self.gear(member).gear().basic_data().teeth()
    }

    /// Centre distance `a`, mm.
    pub fn center_distance(&self) -> f64 {
        self.center_distance
    }

    /// The fixed gear.
    pub fn locked(&self) -> Member {
        self.locked
    }

    /// The gear that turns.
    pub fn free(&self) -> Member {
        self.locked.mate()
    }

    /// Rotation of one gear's teeth at `b`, mm along the axis: rad, counter-clockwise as seen from the front.
    pub(crate) fn twist(&self, member: Member, b: f64) -> f64 {
        b * self.gear(member).gear().basic_data().twist()
    }

    /// The transverse section at `b`, mm along the axis, as a plane pair with the tooth numbers of the measuring plane.
    ///
    /// Helical teeth wind about the axis and the eccentricity does not: relative to the teeth it turns by `−τ(b)`. Leads turn each flank.
    pub fn section(&self, b: f64) -> GearPair {
        let at = |member| self.gear(member).section_at(b);
        GearPair {
            wheel: at(Member::Wheel),
            pinion: at(Member::Pinion),
            face: [0.0; 2],
            ..self.clone()
        }
    }

    /// Rotation axis, mm.
    pub fn axis(&self, member: Member) -> Point2<f64> {
        member.axis(self.center_distance)
    }

    /// Direction from a gear's axis to its mate's, rad.
    pub fn mate_direction(&self, member: Member) -> f64 {
        member.mate_direction()
    }

    /// Operating pressure angle `α_wt`, rad: `cos α_wt = (r_b1 + r_b2)/a`.
    pub fn operating_pressure_angle(&self) -> f64 {
        let base = self.wheel.gear().base_radius() + self.pinion.gear().base_radius();
        (base / self.center_distance).acos()
    }

    /// Operating pitch radius `r_w = r_b/cos α_wt`, mm.
    pub fn operating_pitch_radius(&self, member: Member) -> f64 {
        let base = self.wheel.gear().base_radius() + self.pinion.gear().base_radius();
        self.gear(member).gear().base_radius() * self.center_distance / base
    }

    /// Half the angle a mean tooth spans on the operating pitch circle, rad (ISO 21771: `ψ_b − inv α_wt`).
    ///
    /// If the pitch point lies beyond the tip, the value is that of the extended undisturbed flank.
    pub fn operating_half_angle(&self, member: Member) -> f64 {
        self.gear(member).gear().half_base_angle() - involute::inv(self.operating_pressure_angle())
    }
}

//! Two gears at a centre distance, one of them locked.

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

/// A kind of deviation along the face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaceDeviation {
    /// Lead deviations of flanks.
    Lead,
    /// Teeth that lean on their shaft.
    Wobble,
    /// Shafts that are not parallel.
    Shafts,
}

impl FaceDeviation {
    /// All kinds, each at the index of its number.
    pub const ALL: [FaceDeviation; 3] = [
        FaceDeviation::Lead,
        FaceDeviation::Wobble,
        FaceDeviation::Shafts,
    ];
}

/// Greatest relative difference of the modules of two mating gears: that of a hot plastic gear (1e-4/K, 200 K) and a steel gear.
pub const MOST_MODULE_DIFFERENCE: f64 = 0.02;

/// Greatest lean of the axes, mm per mm.
pub const MOST_LEAN: f64 = 2e-2;

/// Half the angle, at the centre of a circle of this radius, of its overlap with a circle of radius `other` that is
/// `distance` away. `None` without overlap, also for circles that touch in a point.
pub(crate) fn overlap_half_angle(radius: f64, other: f64, distance: f64) -> Option<f64> {
    if radius + other <= distance {
        return None;
    }
    if other >= distance {
        return Some(PI);
    }
    let tangent = distance * distance - other * other;
    Some(if radius * radius >= tangent {
        (other / distance).asin()
    } else {
        let cos = (radius * radius + tangent) / (2.0 * distance * radius);
        cos.min(1.0).acos()
    })
}

/// A pair as assembled: wheel axis at the origin, pinion axis at `(a, 0)`, y up.
#[derive(Debug, Clone, PartialEq)]
pub struct GearPair {
    gears: [AsBuilt; 2],
    center_distance: f64,
    locked: Member,
    /// Both ends of the wheel's teeth and of the pinion's, mm along the axis.
    faces: [[f64; 2]; 2],
    /// Lean of the pinion's axis, mm per mm along the wheel's: in the plane of the axes, + = apart at the far end, and out of it, + = its
    /// far end moved to +y.
    lean: [f64; 2],
}

impl GearPair {
    /// Two gears at `center_distance` `a`, mm, with the wheel locked.
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

    /// Two gears at `center_distance` `a`, mm, with `locked` as the locked gear.
    ///
    /// # Errors
    /// Unequal pressure or helix angles; modules that differ by more than [`MOST_MODULE_DIFFERENCE`]; overlapping base circles
    /// (`a ≤ r_b1 + r_b2`), without an operating pressure angle. Helical gears of one hand.
    /// Teeth with profile deviations that lean on their shaft.
    pub fn with_locked(
        wheel: AsBuilt,
        pinion: AsBuilt,
        center_distance: f64,
        locked: Member,
    ) -> Result<GearPair, GearError> {
        let (w, p) = (*wheel.gear().basic_data(), *pinion.gear().basic_data());
        // A share of the greater module, plus the rounding of both.
        let most = (MOST_MODULE_DIFFERENCE + 4.0 * f64::EPSILON) * w.module().max(p.module());
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
        let least = w.base_radius() + p.base_radius();
        if !(center_distance > least && center_distance.is_finite()) {
            return Err(GearError::BaseCirclesOverlap {
                center_distance_mm: center_distance,
                least_mm: least,
            });
        }
        GearPair {
            gears: [wheel, pinion],
            center_distance,
            locked,
            faces: [[0.0; 2]; 2],
            lean: [0.0; 2],
        }
        .without_leaning_profiles()
    }

    /// This pair, unless teeth whose profiles deviate lean.
    fn without_leaning_profiles(self) -> Result<GearPair, GearError> {
        GearError::require(
            !(self.is_modified() && self.leans()),
            "lean of the axes (mm per mm) of gears whose profiles deviate",
            self.lean_bound(),
            "0: sections of leaning axes are not worked out for such teeth",
        )?;
        Ok(self)
    }

    /// This pair with the pinion's axis leaning from the wheel's, mm per mm: `in_plane`, + = apart at the far end, and `out_of_plane`, + = its
    /// far end moved to +y. The centre distance holds in the measuring plane.
    ///
    /// # Errors
    /// A lean of more than [`MOST_LEAN`], also of the teeth on a shaft.
    pub fn with_lean(self, [in_plane, out_of_plane]: [f64; 2]) -> Result<GearPair, GearError> {
        let pair = GearPair {
            lean: [in_plane, out_of_plane],
            ..self
        };
        let lean = pair.lean_bound();
        GearError::require(
            lean <= MOST_LEAN,
            "lean of the axes (mm per mm)",
            lean,
            "up to 0.02: sections do not describe the teeth beyond it",
        )?;
        pair.without_leaning_profiles()
    }

    /// Lean of the pinion's axis from the wheel's: in the plane of the axes, and out of it, mm per mm.
    pub fn lean(&self) -> [f64; 2] {
        self.lean
    }

    /// Whether an axis leans: that of the pinion, or that of teeth on their shaft.
    pub fn leans(&self) -> bool {
        self.has(FaceDeviation::Shafts) || self.has(FaceDeviation::Wobble)
    }

    /// Bound on the angle between the axes of both toothings, mm per mm.
    pub fn lean_bound(&self) -> f64 {
        let [wheel, pinion] = self.gears.each_ref().map(AsBuilt::wobble);
        self.lean[0].hypot(self.lean[1]) + wheel + pinion
    }

    /// Bound on the move of the outlines' centres against each other by leaning axes, mm, over the face from the measuring plane.
    pub(crate) fn shift_bound(&self) -> f64 {
        let [from, to] = self.face();
        self.lean_bound() * from.abs().max(to.abs())
    }

    /// Bound on the height of a point of a tooth over its section, mm along the leaning axis of its gear.
    pub(crate) fn height_bound(&self) -> f64 {
        let [wheel, pinion] = self.gears.each_ref().map(AsBuilt::reach);
        self.lean_bound() * wheel.max(pinion)
    }

    /// Bound on what the heights of leaning axes change the leads of a pair of teeth, mm.
    pub(crate) fn lead_change_bound(&self) -> f64 {
        if self.leans() {
            self.height_bound() * self.steepest_leads()
        } else {
            0.0
        }
    }

    /// Bound on the sum of the rates of two leads, mm per mm.
    pub(crate) fn steepest_leads(&self) -> f64 {
        let height = self.height_bound();
        let [from, to] = self.face();
        let face = [from - height, to + height];
        let [wheel, pinion] = self.gears.each_ref().map(|gear| gear.steepest_lead(face));
        wheel + pinion
    }

    /// Bound on what sections of leaning axes leave out of each contact, mm along the base tangent; the teeth are tighter by it
    /// ([`section_at`](super::section_at)).
    pub fn section_error_bound(&self) -> f64 {
        let base = self.least_distance();
        let [wheel, pinion] = self.gears.each_ref().map(AsBuilt::eccentricity);
        let distance = self.center_distance + (wheel + pinion + self.shift_bound());
        let tangent = (distance * distance - base * base).max(0.0).sqrt();
        let basic_data = self.gears[0].gear().basic_data();
        let slope = basic_data.base_helix_angle().tan() * self.lean_bound();
        // Half as much again for the third order.
        1.5 * 0.5 * slope * slope * tangent / 4.0
    }

    /// This pair with the teeth of both gears from `from` to `to`, mm along the axis away from the viewer.
    ///
    /// 0 is the measuring plane, in which tooth 1, pitch and runout are stated. Without a face the gears face each other in that plane
    /// alone, which makes no difference for spur gears.
    ///
    /// # Errors
    /// As [`GearPair::with_faces`].
    pub fn with_face(self, face: [f64; 2]) -> Result<GearPair, GearError> {
        self.with_faces([face; 2])
    }

    /// This pair with the ends of the wheel's and of the pinion's teeth, mm along the axis away from the viewer.
    ///
    /// # Errors
    /// Ends that are not finite, or not in this order; gears that do not face each other.
    pub fn with_faces(self, faces: [[f64; 2]; 2]) -> Result<GearPair, GearError> {
        let pair = GearPair { faces, ..self };
        let face = pair.face();
        for [from, to] in [faces[0], faces[1], face] {
            if !(from <= to && from.is_finite() && to.is_finite()) {
                return Err(GearError::NoCommonFace {
                    from_mm: from,
                    to_mm: to,
                });
            }
        }
        Ok(pair)
    }

    /// The common face, mm along the axis, the end nearest to the viewer first.
    pub fn face(&self) -> [f64; 2] {
        let [wheel, pinion] = self.faces;
        [wheel[0].max(pinion[0]), wheel[1].min(pinion[1])]
    }

    /// Both ends of a gear's teeth, mm along the axis.
    pub(crate) fn own_face(&self, member: Member) -> [f64; 2] {
        self.faces[member as usize]
    }

    /// Whether the gears are helical.
    pub fn is_helical(&self) -> bool {
        self.gears[0].gear().basic_data().hand().is_some()
    }

    /// Whether either gear has lead deviations.
    pub fn has_leads(&self) -> bool {
        self.gears.iter().any(AsBuilt::has_leads)
    }

    /// Whether all teeth of a gear have one lead on each flank.
    pub(crate) fn has_one_lead(&self) -> bool {
        self.gears.iter().all(AsBuilt::has_one_lead)
    }

    /// Whether transverse sections differ along the face: helical teeth, lead deviations, or leaning axes.
    pub fn varies_along_face(&self) -> bool {
        self.is_helical() || self.deviates_along_face()
    }

    /// Whether teeth deviate along the face: lead deviations, or leaning axes.
    pub fn deviates_along_face(&self) -> bool {
        self.has_leads() || self.leans()
    }

    /// Whether helical teeth have profile deviations, which touch anywhere on their lines of contact.
    pub fn binds_along_profiles(&self) -> bool {
        self.is_helical() && self.is_modified()
    }

    /// Whether a pair of teeth may be tightest anywhere on the face: teeth deviate along it, or the profiles of helical ones do.
    pub fn binds_anywhere(&self) -> bool {
        self.deviates_along_face() || self.binds_along_profiles()
    }

    /// Whether this pair has a kind of deviation along the face.
    pub fn has(&self, kind: FaceDeviation) -> bool {
        match kind {
            FaceDeviation::Lead => self.has_leads(),
            FaceDeviation::Wobble => self.gears.iter().any(|gear| gear.wobble() != 0.0),
            FaceDeviation::Shafts => self.lean != [0.0; 2],
        }
    }

    /// This pair without some kinds of deviation along the face. Pitch and thickness hold where each lead is 0.
    pub fn without(&self, kinds: &[FaceDeviation]) -> GearPair {
        kinds.iter().fold(self.clone(), |pair, kind| match kind {
            FaceDeviation::Lead => GearPair {
                gears: pair.gears.each_ref().map(AsBuilt::without_leads),
                ..pair
            },
            FaceDeviation::Wobble => GearPair {
                gears: pair.gears.each_ref().map(AsBuilt::without_wobble),
                ..pair
            },
            FaceDeviation::Shafts => GearPair {
                lean: [0.0; 2],
                ..pair
            },
        })
    }

    /// Whether either gear has profile deviations.
    pub fn is_modified(&self) -> bool {
        self.gears.iter().any(AsBuilt::is_modified)
    }

    /// Whether the base pitches `p_b` differ by more than rounding, as at different temperatures.
    pub fn base_pitches_differ(&self) -> bool {
        let base_pitch = |gear: &AsBuilt| gear.gear().basic_data().base_pitch();
        let [wheel, pinion] = self.gears.each_ref().map(base_pitch);
        (wheel - pinion).abs() > 8.0 * f64::EPSILON * wheel
    }

    /// These gears at another centre distance.
    ///
    /// # Errors
    /// As [`GearPair::with_locked`].
    pub fn at(&self, center_distance: f64) -> Result<GearPair, GearError> {
        let [wheel, pinion] = self.gears.clone();
        self.with_gears(wheel, pinion, center_distance)
    }

    /// Other gears at a centre distance, mm, with this pair's faces, lean and locked member.
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
        GearPair {
            faces: self.faces,
            ..pair
        }
        .with_lean(self.lean)
    }

    /// One of the gears.
    pub fn gear(&self, member: Member) -> &AsBuilt {
        &self.gears[member as usize]
    }

    /// Teeth of one of the gears.
    pub fn teeth(&self, member: Member) -> u32 {
        self.gear(member).gear().basic_data().teeth()
    }

    /// The centre distance `r_b1 + r_b2`, mm, at which the base circles touch: no pair can be assembled at it or below it.
    pub fn least_distance(&self) -> f64 {
        let [wheel, pinion] = self.gears.each_ref().map(|gear| gear.gear().base_radius());
        wheel + pinion
    }

    /// Centre distance `a`, mm.
    pub fn center_distance(&self) -> f64 {
        self.center_distance
    }

    /// The locked gear.
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

    /// The transverse section at `b`, mm along the axis, as a plane pair with the tooth numbers of the measuring plane. Leaning axes
    /// move and stretch sections beside this: see [`section_at`](super::section_at).
    ///
    /// Helical teeth wind about the axis and the eccentricity does not: relative to the teeth it turns by `−τ(b)`. Leads turn each flank.
    pub fn section(&self, b: f64) -> GearPair {
        GearPair {
            gears: self.gears.each_ref().map(|gear| gear.section_at(b)),
            faces: [[0.0; 2]; 2],
            lean: [0.0; 2],
            ..self.clone()
        }
    }

    /// A section with its axes `center_distance` apart, mm, near this pair's, and all teeth of both gears turned by `angle`, rad.
    pub(super) fn with_axes_turned(self, center_distance: f64, angle: f64) -> GearPair {
        GearPair {
            gears: self.gears.map(|gear| gear.turned(angle)),
            center_distance,
            ..self
        }
    }

    /// A section with every flank turned further: right and left flanks of the wheel and of the pinion, rad.
    pub(super) fn with_flanks_turned(self, turns: [[Vec<f64>; 2]; 2]) -> GearPair {
        let ([wheel, pinion], [of_wheel, of_pinion]) = (self.gears, turns);
        GearPair {
            gears: [
                wheel.with_flanks_turned(of_wheel),
                pinion.with_flanks_turned(of_pinion),
            ],
            ..self
        }
    }

    /// Radial clearance `a − r_a − r_f,mate` of `member`'s tip in its mate's root, mm, with both gears on their axes.
    pub fn radial_clearance(&self, member: Member) -> f64 {
        let mate = self.gear(member.mate()).gear();
        self.center_distance - self.gear(member).gear().tip_radius() - mate.root_radius()
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
        (self.least_distance() / self.center_distance).acos()
    }

    /// Operating pitch radius `r_w = r_b/cos α_wt`, mm.
    pub fn operating_pitch_radius(&self, member: Member) -> f64 {
        self.gear(member).gear().base_radius() * self.center_distance / self.least_distance()
    }

    /// Half the angle a mean tooth spans on the operating pitch circle, rad (ISO 21771: `ψ_b − inv α_wt`).
    ///
    /// If the pitch point lies beyond the tip, the value is that of the extended undisturbed flank.
    pub fn operating_half_angle(&self, member: Member) -> f64 {
        self.gear(member).gear().half_base_angle() - involute::inv(self.operating_pressure_angle())
    }
}

#[cfg(test)]
impl GearPair {
    /// Plain gears of module 2 with these eccentricities.
    pub(crate) fn plain(
        teeth: [u32; 2],
        eccentricities: [f64; 2],
        distance: f64,
        locked: Member,
    ) -> GearPair {
        use crate::gear::{Deviations, Face, GearDesign};
        let gear = |kind: usize, face| {
            let deviations = Deviations::off_axis(eccentricities[kind], 2.5);
            GearDesign::plain(teeth[kind], 2.0).built(face, &deviations)
        };
        let (wheel, pinion) = (gear(0, Face::Front), gear(1, Face::Back));
        GearPair::with_locked(wheel, pinion, distance, locked).unwrap()
    }
}

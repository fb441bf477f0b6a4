//! A gear as built: the place of every flank, and the axis of rotation.

use super::lead::Leads;
use super::modified_flanks::{self, HalfTeeth, end_at};
use super::{
    DeviationCurve, Deviations, Face, Flank, Gear, Lead, Modification, Profile, ProfilePart, Side,
    involute, thickness,
};
use crate::error::GearError;
use crate::numeric::ends;
use nalgebra::{UnitComplex, Vector2};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// A gear with every tooth at its measured place.
///
/// Clones share the list of teeth.
#[derive(Debug, Clone, PartialEq)]
pub struct AsBuilt {
    gear: Gear,
    face: Face,
    /// Rotation of each tooth's flank from its undisturbed place, rad, counter-clockwise: front-right flanks, front-left flanks.
    offsets: [Arc<[f64]>; 2],
    eccentricity: f64,
    high_tooth: f64,
    any_direction: bool,
    /// Lean of the teeth's axis, mm per mm, and the tooth towards which the teeth lean away from the reference face.
    wobble: f64,
    wobble_tooth: f64,
    /// Right and left half teeth; `None` without profile deviations.
    modified: Option<Arc<[HalfTeeth; 2]>>,
    /// `None` without lead deviations. The offsets contain their values at `height`.
    leads: Option<Arc<Leads>>,
    /// Height of this section above the measuring plane, mm, away from the reference face; it matters to leads alone.
    height: f64,
}

impl AsBuilt {
    /// A `gear` with `deviations`, its reference face turned to `face`.
    ///
    /// A thickness `δ_s` turns each flank outwards by `δ_s/(2 r)`. A pitch deviation `F` turns it by `F/r` along ascending
    /// numbers. The fillet turns with its flank about the geometric centre. A lead turns it further in each section.
    ///
    /// # Errors
    /// Lists without one value per tooth; a pitch deviation of half a pitch; a runout of the tooth depth or more; a high tooth outside
    /// `1 ≤ … < z + 1`. Profile deviations as in [`Modification::curves`], on straight flanks, or too large for any flank.
    /// Lead deviations as in [`Lead::curves`]. Deviations that leave a tooth without a tip or close a space.
    pub fn new(gear: Gear, face: Face, deviations: &Deviations) -> Result<AsBuilt, GearError> {
        let teeth = gear.basic_data().teeth() as usize;
        let offsets = Side::BOTH.map(|_| vec![0.0; teeth]);
        let offsets = deviations.offsets(gear.basic_data(), face, offsets)?;
        let as_built = AsBuilt {
            modified: modified(&gear, face, &deviations.profiles)?.map(Arc::new),
            leads: Leads::new(&deviations.leads, gear.basic_data().teeth())?.map(Arc::new),
            height: 0.0,
            offsets: offsets.map(Arc::from),
            face,
            eccentricity: deviations.eccentricity,
            high_tooth: deviations.high_tooth,
            any_direction: deviations.any_direction,
            wobble: deviations.wobble,
            // A tooth without a wobble says nothing.
            wobble_tooth: if deviations.wobble == 0.0 {
                1.0
            } else {
                deviations.wobble_tooth
            },
            gear,
        };
        let as_built = as_built.with_leads_turned(|curve| curve.at(0.0));
        as_built.check_leads()?;
        as_built.checked()
    }

    /// Checks the teeth where their leads are least and where they are greatest.
    fn check_leads(&self) -> Result<(), GearError> {
        let bounds = [0, 1].into_iter().filter(|_| self.has_leads());
        let mut gears = bounds.map(|which| self.at_lead_bound(which, None));
        gears.try_for_each(|gear| gear.check_teeth())
    }

    /// This gear, after checking runout and teeth.
    fn checked(self) -> Result<AsBuilt, GearError> {
        self.check_runout()?;
        self.check_teeth()?;
        Ok(self)
    }

    /// A gear without deviations.
    pub fn perfect(gear: Gear, face: Face) -> AsBuilt {
        let teeth = gear.basic_data().teeth() as usize;
        let undisturbed: Arc<[f64]> = Arc::from(vec![0.0; teeth]);
        AsBuilt {
            gear,
            face,
            offsets: [Arc::clone(&undisturbed), undisturbed],
            eccentricity: 0.0,
            high_tooth: 1.0,
            any_direction: false,
            wobble: 0.0,
            wobble_tooth: 1.0,
            modified: None,
            leads: None,
            height: 0.0,
        }
    }

    /// This gear with another runout: the eccentricity, mm, towards a tooth, or `None`: in an unknown direction.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of a runout.
    pub fn with_runout(
        &self,
        eccentricity: f64,
        high_tooth: impl Into<Option<f64>>,
    ) -> Result<AsBuilt, GearError> {
        let high_tooth = high_tooth.into();
        let other = AsBuilt {
            eccentricity,
            high_tooth: high_tooth.unwrap_or(1.0),
            any_direction: high_tooth.is_none(),
            ..self.clone()
        };
        other.check_runout()?;
        Ok(other)
    }

    /// This gear with another wobble: the lean, mm per mm, and the tooth towards which the teeth lean away from the reference face. The
    /// eccentricity in this section stays.
    #[must_use]
    pub fn with_wobble(&self, wobble: f64, wobble_tooth: f64) -> AsBuilt {
        AsBuilt {
            wobble,
            wobble_tooth,
            ..self.clone()
        }
    }

    /// This gear with further lead deviations of its own right and left flanks, without traces of single teeth.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of lead deviations.
    pub fn with_further_leads(&self, further: &[Lead; 2]) -> Result<AsBuilt, GearError> {
        let Some(further) = Leads::new(further, self.gear.basic_data().teeth())? else {
            return Ok(self.clone());
        };
        let sum = match self.leads.as_deref() {
            Some(own) => own.clone().plus(&further),
            None => further.clone(),
        };
        let turned = AsBuilt {
            leads: Some(Arc::new(further)),
            ..self.clone()
        };
        let sum = AsBuilt {
            leads: Some(Arc::new(sum)),
            ..turned.with_leads_turned(|curve| curve.at(self.height))
        };
        sum.check_leads()?;
        sum.checked()
    }

    /// This gear with its deviations from the perfect nominal gear multiplied by `factor`, for a picture.
    ///
    /// Mean thickness, per-tooth thickness, pitch and eccentricity are enlarged. Root and fillet are the nominal gear's and turn
    /// with their flank.
    ///
    /// # Errors
    /// As [`Gear::new`] for the perfect gear; a factor that leaves a tooth without tip, a space without room
    /// or a runout of the tooth depth.
    pub fn exaggerated(&self, factor: f64) -> Result<AsBuilt, GearError> {
        let gear = Gear::nominal(*self.gear.design())?;
        let thicker = self.gear.half_base_angle() - gear.half_base_angle();
        let enlarged = |side: Side, _, offset| factor * (offset + side.sense() * thicker);
        let exaggerated = AsBuilt {
            modified: self.modified_of(&gear, factor)?,
            leads: self.leads_by(1.0, |curve| curve.scaled(factor)),
            offsets: self.offsets_by(enlarged),
            eccentricity: factor * self.eccentricity,
            wobble: factor * self.wobble,
            gear,
            ..*self
        };
        exaggerated.checked()
    }

    /// This gear with all lengths multiplied by `factor`, as by a change of temperature. Angles stay.
    ///
    /// # Errors
    /// As [`Gear::expanded`].
    pub fn expanded(&self, factor: f64) -> Result<AsBuilt, GearError> {
        let gear = self.gear.expanded(factor)?;
        Ok(AsBuilt {
            modified: self.modified_of(&gear, factor)?,
            leads: self.leads_by(factor, |curve| curve.enlarged(factor)),
            height: factor * self.height,
            eccentricity: factor * self.eccentricity,
            gear,
            ..self.clone()
        })
    }

    /// The half teeth of `gear` with this gear's profile deviations multiplied by `factor`.
    fn modified_of(
        &self,
        gear: &Gear,
        factor: f64,
    ) -> Result<Option<Arc<[HalfTeeth; 2]>>, GearError> {
        let Some(sides) = &self.modified else {
            return Ok(None);
        };
        let exaggerated = |side| modified_flanks::exaggerated(side, gear, factor);
        let [right, left] = sides.each_ref().map(exaggerated);
        Ok(Some(Arc::new([right?, left?])))
    }

    /// This gear without an eccentricity of unknown direction.
    pub(crate) fn centred(&self) -> AsBuilt {
        AsBuilt {
            eccentricity: if self.any_direction {
                0.0
            } else {
                self.eccentricity
            },
            any_direction: false,
            ..self.clone()
        }
    }

    /// This gear with the flanks of `side` turned by `angle`, rad, counter-clockwise: every tooth gets thicker or thinner by it.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of thickness.
    pub(crate) fn with_side_turned(&self, side: Side, angle: f64) -> Result<AsBuilt, GearError> {
        let turned = |on, _, offset| if on == side { offset + angle } else { offset };
        let other = AsBuilt {
            offsets: self.offsets_by(turned),
            ..self.clone()
        };
        other.check_teeth()?;
        Ok(other)
    }

    /// The gear of mean thickness.
    pub fn gear(&self) -> &Gear {
        &self.gear
    }

    /// Which way the reference face looks.
    pub fn face(&self) -> Face {
        self.face
    }

    /// Eccentricity `e`, mm.
    pub fn eccentricity(&self) -> f64 {
        self.eccentricity
    }

    /// The high tooth, fractional.
    pub fn high_tooth(&self) -> f64 {
        self.high_tooth
    }

    /// Whether the direction of the eccentricity is unknown; [`AsBuilt::high_tooth`] is then arbitrary.
    pub fn any_direction(&self) -> bool {
        self.any_direction
    }

    /// Rotation of a tooth's flank from its undisturbed place, rad, counter-clockwise.
    ///
    /// `tooth` counts from 1 and lies in `1..=z`.
    pub fn flank_offset(&self, side: Side, tooth: u32) -> f64 {
        self.offsets[side.index()][tooth as usize - 1]
    }

    /// [`AsBuilt::flank_offset`] by pitch and thickness alone, without the lead of this section.
    pub fn stated_offset(&self, side: Side, tooth: u32) -> f64 {
        let lead = self.lead(side, tooth, 0.0) / self.gear.base_radius();
        self.flank_offset(side, tooth) - side.sense() * lead
    }

    /// End of a half tooth's root land: the middle of the space with its deviations, where the next half tooth begins.
    ///
    /// It is the land's parameter ([`ProfilePart::Root`]), rad, about the centre line turned with the flank. It is never less than
    /// the land's other end.
    pub fn root_end(&self, side: Side, tooth: u32) -> f64 {
        let across = self.counter_clockwise(tooth, side.sense() as i64);
        // The rotations of the two flanks widen the space.
        let widening = side.sense()
            * (self.flank_offset(side.other(), across) - self.flank_offset(side, tooth));
        let (start, _) = self.profile(side, tooth).range(ProfilePart::Root);
        let middle = self.gear.part(ProfilePart::Root).ends[1];
        (middle + 0.5 * widening).max(start)
    }

    /// Far end of a half tooth's tip land, at the corner with the other flank.
    ///
    /// It is the land's parameter ([`ProfilePart::Tip`]), rad, about the centre line turned with the flank. The deviations of both
    /// flanks widen the land. On a tooth thinner than half of it, the far corner lies on the near half (above 0).
    pub fn land_start(&self, side: Side, tooth: u32) -> f64 {
        let widening = self.flank_offset(Side::Left, tooth) - self.flank_offset(Side::Right, tooth);
        let (_, corner) = self.profile(side.other(), tooth).range(ProfilePart::Tip);
        -corner - widening
    }

    /// Angle of the (fractional) tooth's undisturbed centre from tooth 1, rad, counter-clockwise.
    pub fn tooth_angle(&self, tooth: f64) -> f64 {
        self.face.ascending() * (tooth - 1.0) * self.gear.basic_data().angular_pitch()
    }

    /// The number of the tooth `steps` places counter-clockwise of `tooth`.
    pub fn counter_clockwise(&self, tooth: u32, steps: i64) -> u32 {
        let teeth = self.gear.basic_data().teeth();
        self.face.counter_clockwise(teeth, tooth, steps)
    }

    /// Cosine of the angle between high tooth and mate, with the gear at `rotation`, rad, from tooth 1 pointing at the mate.
    pub fn towards_mate(&self, rotation: f64) -> f64 {
        (rotation + self.tooth_angle(self.high_tooth)).cos()
    }

    /// Displacement of the outline's centre from the axis, mm, with tooth 1 turned to the angle `tooth_1`.
    pub fn displacement(&self, tooth_1: f64) -> Vector2<f64> {
        self.eccentricity * self.displacement_direction(tooth_1)
    }

    /// The direction of the high tooth, with tooth 1 turned to the angle `tooth_1`.
    pub fn displacement_direction(&self, tooth_1: f64) -> Vector2<f64> {
        UnitComplex::new(tooth_1 + self.tooth_angle(self.high_tooth)) * Vector2::x()
    }

    /// Wobble: lean of the teeth's axis from the rotation axis, mm per mm.
    pub fn wobble(&self) -> f64 {
        self.wobble
    }

    /// The tooth, fractional, towards which the teeth lean away from the reference face.
    pub fn wobble_tooth(&self) -> f64 {
        self.wobble_tooth
    }

    /// Displacement of the outline's centre per mm along the axis away from the viewer, with tooth 1 turned to the angle `tooth_1`.
    pub(crate) fn lean(&self, tooth_1: f64) -> Vector2<f64> {
        UnitComplex::new(tooth_1 + self.tooth_angle(self.wobble_tooth))
            * Vector2::new(self.inwards() * self.wobble, 0.0)
    }

    /// Greatest radius of the outline about the rotation axis, mm.
    pub fn reach(&self) -> f64 {
        self.gear.tip_radius() + self.eccentricity
    }

    /// Checks that the axis is inside the body, within the tooth depth, and that the high tooth exists.
    pub(super) fn check_runout(&self) -> Result<(), GearError> {
        let depth = self.gear.tip_radius() - self.gear.root_radius();
        GearError::require(
            self.eccentricity >= 0.0 && 2.0 * self.eccentricity < depth,
            "runout (mm)",
            2.0 * self.eccentricity,
            "at least 0 and less than the tooth depth",
        )?;
        GearError::require(
            self.eccentricity < self.gear.root_radius(),
            "runout (mm)",
            2.0 * self.eccentricity,
            "less than the root diameter: the axis would lie outside the gear's body",
        )?;
        let teeth = f64::from(self.gear.basic_data().teeth());
        GearError::require(
            self.eccentricity == 0.0 || (1.0..teeth + 1.0).contains(&self.high_tooth),
            "tooth towards which the runout points",
            self.high_tooth,
            "1 up to, but not including, the number of teeth + 1",
        )
    }

    /// Checks that every tooth keeps a tip land and a neck, and that every space is open at the form circle.
    pub(super) fn check_teeth(&self) -> Result<(), GearError> {
        let gear = &self.gear;
        let alike = |offsets: &[f64]| offsets.iter().all(|offset| *offset == offsets[0]);
        // If all teeth are equal, one is checked.
        let last = if self.modified.is_none() && self.offsets.iter().all(|side| alike(side)) {
            1
        } else {
            gear.basic_data().teeth()
        };
        for tooth in 1..=last {
            let widening =
                self.flank_offset(Side::Left, tooth) - self.flank_offset(Side::Right, tooth);
            let own = |side: Side, tooth: u32, place: ProfilePart| {
                self.profile(side, tooth).part(place).ends
            };
            let tips = Side::BOTH.map(|side| own(side, tooth, ProfilePart::Tip)[1]);
            let tip: f64 = tips.iter().sum();
            // The fillet and the start of the root land turn with the lower end of a modified flank.
            let land = gear.part(ProfilePart::Root).ends[0];
            let turned = |side: Side, tooth: u32| own(side, tooth, ProfilePart::Root)[0] - land;
            let both: f64 = Side::BOTH.map(|side| turned(side, tooth)).iter().sum();
            let neck = 2.0 * gear.neck_half_angle() + both;
            GearError::require(
                tip + widening > 0.0,
                "tip thickness of the thinnest tooth (mm)",
                (tip + widening) * gear.tip_radius(),
                "above 0: the deviations leave this tooth without a tip",
            )?;
            GearError::require(
                neck + widening > 0.0,
                "thickness of the thinnest tooth at its neck (rad)",
                neck + widening,
                "above 0: the deviations let undercut from both sides meet and cut this tooth off",
            )?;
            let next = self.counter_clockwise(tooth, 1);
            let narrowing =
                self.flank_offset(Side::Left, tooth) - self.flank_offset(Side::Right, next);
            let space = gear.basic_data().angular_pitch()
                - 2.0 * gear.form_half_angle()
                - turned(Side::Left, tooth)
                - turned(Side::Right, next);
            GearError::require(
                space - narrowing > 0.0,
                "space width at the form circle (mm)",
                (space - narrowing) * gear.form_radius(),
                "above 0: the deviations close a tooth space",
            )?;
        }
        Ok(())
    }

    /// The half tooth on `side` of `tooth`, in its own frame.
    pub fn profile(&self, side: Side, tooth: u32) -> Profile<'_> {
        self.shape(side, self.shape_of(side, tooth))
    }

    /// Number of different half teeth on `side`: 1 unless profiles were measured tooth by tooth.
    pub(crate) fn shapes(&self, side: Side) -> usize {
        self.halves(side).map_or(1, |halves| halves.shapes().len())
    }

    /// Index of a tooth's half-tooth shape on `side`.
    pub(crate) fn shape_of(&self, side: Side, tooth: u32) -> usize {
        self.halves(side).map_or(0, |halves| halves.shape_of(tooth))
    }

    /// The half tooth of a shape on `side`.
    pub(crate) fn shape(&self, side: Side, shape: usize) -> Profile<'_> {
        match self.halves(side) {
            Some(halves) => Profile::of(&self.gear, &halves.shapes()[shape]),
            None => Profile::new(&self.gear),
        }
    }

    fn halves(&self, side: Side) -> Option<&HalfTeeth> {
        let sides = self.modified.as_ref()?;
        Some(&sides[side.index()])
    }

    /// Profile deviation of the flank on `side` of `tooth` over the roll; `None` without profile deviations.
    pub fn modification(&self, side: Side, tooth: u32) -> Option<&DeviationCurve> {
        let involute = self.profile(side, tooth).part(ProfilePart::Involute);
        involute.curve.deviation()
    }

    /// Whether the profiles of one side differ between teeth.
    pub(crate) fn has_different_profiles(&self) -> bool {
        Side::BOTH.into_iter().any(|side| self.shapes(side) > 1)
    }

    /// Whether the gear has profile deviations.
    pub fn is_modified(&self) -> bool {
        self.modified.is_some()
    }

    /// Two gears without profile and lead deviations: one that encloses this gear and one that this gear encloses.
    ///
    /// Their flanks are turned by the greatest and by the least deviation of each flank, over the face `from` to `to`, mm from this section.
    /// An involute with the constant deviation `D` is an involute turned by `D/r_b`. The last value is the greatest range of profile
    /// deviations on one flank, mm.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of thickness.
    pub(crate) fn enclosing(&self, face: [f64; 2]) -> Result<([AsBuilt; 2], f64), GearError> {
        let bound = |which: usize| self.at_lead_bound(which, Some(face)).unmodified();
        let base = self.gear.base_radius();
        let bounds = Side::BOTH.map(|side| self.deviations(side));
        let ranges = bounds.iter().flatten().map(|[least, most]| most - least);
        let range = ranges.fold(0.0, f64::max);
        let enclosing = [1, 0].map(|which| {
            let other = bound(which);
            let turned = |side: Side, tooth, offset| {
                let deviation = bounds[side.index()][self.shape_of(side, tooth)][which];
                offset + side.sense() * deviation / base
            };
            AsBuilt {
                offsets: other.offsets_by(turned),
                ..other
            }
        });
        for other in &enclosing {
            other.check_teeth()?;
        }
        Ok((enclosing, range))
    }

    /// Whether the gear has lead deviations.
    pub fn has_leads(&self) -> bool {
        self.leads.is_some()
    }

    /// Whether it has lead deviations or wobble.
    pub fn deviates_along_face(&self) -> bool {
        self.has_leads() || self.wobble != 0.0
    }

    /// Whether its transverse sections differ: helical teeth, lead deviations, or wobble.
    pub fn varies_along_face(&self) -> bool {
        self.gear.basic_data().hand().is_some() || self.deviates_along_face()
    }

    /// Heights over the measuring plane of both ends of a stretch, mm from this section away from the viewer, the lesser first.
    fn heights(&self, stretch: [f64; 2]) -> [f64; 2] {
        let [one, other] = stretch.map(|b| self.height + self.inwards() * b);
        [one.min(other), one.max(other)]
    }

    /// Sense of the heights along the axis: +1 away from the viewer, where the reference face is in front.
    fn inwards(&self) -> f64 {
        -self.face.ascending()
    }

    /// Lead deviation of a tooth's flank, mm, `b` mm from this section away from the viewer.
    pub fn lead(&self, side: Side, tooth: u32, b: f64) -> f64 {
        self.lead_jet(self.lead_curve(side, tooth), b)[0]
    }

    /// Lead deviation at the second of two places, mm from this section away from the viewer, less that at the first, mm.
    pub(crate) fn lead_change(&self, side: Side, tooth: u32, places: [f64; 2]) -> f64 {
        let curve = self.lead_curve(side, tooth);
        let [from, to] = places.map(|b| self.lead_jet(curve, b)[0]);
        to - from
    }

    /// Lead deviation, mm, `b` mm from this section away from the viewer, and its rate, mm per mm; `curve` is that of
    /// [`AsBuilt::lead_curve`].
    #[inline]
    pub(crate) fn lead_jet(&self, curve: Option<&DeviationCurve>, b: f64) -> [f64; 2] {
        let inwards = self.inwards();
        curve.map_or([0.0; 2], |curve| {
            let [lead, rate, _] = curve.jet(self.height + inwards * b);
            [lead, inwards * rate]
        })
    }

    /// The lead deviation of a tooth's flank over the height; `None` without lead deviations.
    pub(crate) fn lead_curve(&self, side: Side, tooth: u32) -> Option<&DeviationCurve> {
        let leads = self.leads.as_deref()?;
        Some(leads.of(self.face.flank_of(side)).of(tooth))
    }

    /// Places, mm from this section away from the viewer and in no order, between which the lead of a tooth's flank is one cubic.
    pub(crate) fn lead_knots(&self, side: Side, tooth: u32) -> impl Iterator<Item = f64> {
        let curve = self.lead_curve(side, tooth).into_iter();
        let knots = curve.flat_map(|curve| curve.knots().iter());
        knots.map(|knot| self.inwards() * (knot - self.height))
    }

    /// Least and greatest lead of a tooth's flank over `face`, mm from this section: its value, mm, and its first and second rate along the
    /// gear's own heights, mm per mm.
    pub(crate) fn lead_bounds(&self, side: Side, tooth: u32, face: [f64; 2]) -> [[f64; 2]; 3] {
        let [from, to] = self.heights(face);
        let curve = self.lead_curve(side, tooth);
        curve.map_or([[0.0; 2]; 3], |curve| curve.bounds(from, to))
    }

    /// Bound on the amount of the rate of every lead over `face`, mm from this section, mm per mm.
    pub(crate) fn steepest_lead(&self, face: [f64; 2]) -> f64 {
        let teeth = 1..=self.gear.basic_data().teeth();
        let rates = Side::BOTH.into_iter().flat_map(|side| {
            let bounds = move |tooth| self.lead_bounds(side, tooth, face)[1];
            teeth.clone().map(bounds)
        });
        rates.flatten().fold(0.0, |most, rate| most.max(rate.abs()))
    }

    /// This gear without leads, with flanks spread over all that leads turn them to over `face`, and `more`, mm along the base tangent: tooth 1
    /// to one limit, all others to the other.
    ///
    /// # Errors
    /// As [`AsBuilt::enclosing`].
    pub(crate) fn spread_by_leads(&self, face: [f64; 2], more: f64) -> Result<AsBuilt, GearError> {
        let ([outer, inner], _) = self.enclosing(face)?;
        let more = more / self.gear.base_radius();
        let limits = Side::BOTH.map(|side| {
            let all = [&outer, &inner].map(|gear| gear.offsets[side.index()].iter());
            let [least, most] = ends(all.into_iter().flatten());
            [least - more, most + more]
        });
        let spread = |side: Side, tooth, _| limits[side.index()][usize::from(tooth == 1)];
        Ok(AsBuilt {
            offsets: self.offsets_by(spread),
            ..outer
        })
    }

    /// Whether all teeth have one lead on each flank.
    pub(crate) fn has_one_lead(&self) -> bool {
        let mut flanks = Flank::BOTH.into_iter();
        let leads = self.leads.as_deref();
        leads.is_none_or(|leads| flanks.all(|flank| leads.of(flank).shapes().len() == 1))
    }

    /// Teeth that have every lead of the gear: the first one, or all.
    pub(crate) fn teeth_by_lead(&self) -> RangeInclusive<u32> {
        let teeth = self.gear.basic_data().teeth();
        1..=if self.has_one_lead() { 1 } else { teeth }
    }

    /// The offsets with `change` applied to each flank: its side and its tooth.
    fn offsets_by(&self, change: impl Fn(Side, u32, f64) -> f64) -> [Arc<[f64]>; 2] {
        Side::BOTH.map(|side| {
            let offsets = (1..).zip(self.offsets[side.index()].iter());
            offsets
                .map(|(tooth, offset)| change(side, tooth, *offset))
                .collect()
        })
    }

    /// This gear with every flank turned by `more` of its lead, mm.
    fn with_leads_turned(&self, more: impl Fn(&DeviationCurve) -> f64) -> AsBuilt {
        let Some(leads) = &self.leads else {
            return self.clone();
        };
        let base = self.gear.base_radius();
        let more = Side::BOTH.map(|side| {
            let curves = leads.of(self.face.flank_of(side));
            curves.map(|curve| side.sense() * more(curve) / base)
        });
        let turned = |side: Side, tooth, offset| offset + more[side.index()].of(tooth);
        AsBuilt {
            offsets: self.offsets_by(turned),
            ..self.clone()
        }
    }

    /// This gear without leads, every flank turned to the least (0) or the greatest (1) value of its lead over `face`, mm from this section;
    /// `None`: over its own length.
    fn at_lead_bound(&self, which: usize, face: Option<[f64; 2]>) -> AsBuilt {
        let bound = |curve: &DeviationCurve| {
            let knots = curve.knots();
            let own = [knots[0], knots[knots.len() - 1]];
            let [from, to] = face.map_or(own, |face| self.heights(face));
            curve.bounds(from, to)[0][which] - curve.at(self.height)
        };
        AsBuilt {
            leads: None,
            ..self.with_leads_turned(bound)
        }
    }

    /// This gear without lead deviations.
    pub(crate) fn without_leads(&self) -> AsBuilt {
        AsBuilt {
            leads: None,
            ..self.with_leads_turned(|curve| -curve.at(self.height))
        }
    }

    /// This gear without wobble.
    pub(crate) fn without_wobble(&self) -> AsBuilt {
        self.with_wobble(0.0, self.wobble_tooth)
    }

    /// The leads with `change` applied to every curve, and heights multiplied by `factor`.
    fn leads_by(
        &self,
        factor: f64,
        change: impl Fn(&DeviationCurve) -> DeviationCurve,
    ) -> Option<Arc<Leads>> {
        let leads = self.leads.as_deref()?;
        Some(Arc::new(leads.map(factor, change)))
    }

    /// Both ends of the stretch over which every lead trace was measured, mm from this section away from the viewer, the lesser first; `None`
    /// without traces.
    pub fn traced(&self) -> Option<[f64; 2]> {
        let ends = self.leads.as_deref()?.traced()?;
        let [one, other] = ends.map(|end| self.inwards() * (end - self.height));
        Some([one.min(other), one.max(other)])
    }

    /// Least and greatest deviation, mm, of each shape on a side.
    pub(crate) fn deviations(&self, side: Side) -> Vec<[f64; 2]> {
        let profiles = self.profiles(side);
        let bounds = profiles
            .map(|(curve, (low, high))| curve.map_or([0.0; 2], |curve| curve.bounds(low, high)[0]));
        bounds.collect()
    }

    /// The deviation of each half-tooth shape on `side`, and the rolls of its flank's ends.
    fn profiles(&self, side: Side) -> impl Iterator<Item = (Option<&DeviationCurve>, (f64, f64))> {
        (0..self.shapes(side)).map(move |shape| {
            let part = self.shape(side, shape).part(ProfilePart::Involute);
            (part.curve.deviation(), part.range())
        })
    }

    /// Greatest profile deviation of any flank at its lower end, by which fillet and root land are turned, and at its tip corner, mm.
    pub(crate) fn end_deviations(&self) -> [f64; 2] {
        let profiles = Side::BOTH.into_iter().flat_map(|side| self.profiles(side));
        let ends = profiles.map(|(curve, (low, high))| {
            [low, high].map(|end| curve.map_or(0.0, |curve| curve.at(end)))
        });
        ends.fold([f64::NEG_INFINITY; 2], |most, ends| {
            [most[0].max(ends[0]), most[1].max(ends[1])]
        })
    }

    /// Whether a profile lies outside its involute anywhere.
    pub(crate) fn stands_out(&self) -> bool {
        let sides = Side::BOTH.iter().flat_map(|side| self.deviations(*side));
        sides.into_iter().any(|[_, most]| most > 0.0)
    }

    /// This gear without its profile deviations.
    pub fn unmodified(&self) -> AsBuilt {
        AsBuilt {
            modified: None,
            ..self.clone()
        }
    }

    /// This gear with all teeth `thicker`, mm at the reference circle, and with pitch and per-tooth thickness of `further` added.
    ///
    /// The tool cuts the thickness: root and fillet follow, as in [`Gear::new`]. Runout and profiles stay.
    ///
    /// # Errors
    /// As [`Gear::new`] and [`AsBuilt::new`].
    pub fn varied(&self, thicker: f64, further: &Deviations) -> Result<AsBuilt, GearError> {
        let basic_data = self.gear.basic_data();
        let base = thickness::base_from_allowance(basic_data, self.gear.base_thickness(), thicker);
        let gear = if thicker == 0.0 {
            self.gear.clone()
        } else {
            Gear::new(*self.gear.design(), base)?
        };
        let modified = self.modified_of(&gear, 1.0)?;
        let own = self.offsets.each_ref().map(|offsets| offsets.to_vec());
        let offsets = further.offsets(basic_data, self.face, own)?;
        let varied = AsBuilt {
            gear,
            modified,
            offsets: offsets.map(Arc::from),
            ..self.clone()
        };
        varied.checked()
    }

    /// The transverse section of this gear at `b`, mm along the axis from this plane away from the viewer.
    ///
    /// The teeth keep their places of the measuring plane. The eccentricity is constant along the axis, so it turns back by the twist. Leads
    /// turn the flanks. See [`crate::pair::GearPair::section`].
    #[must_use]
    pub fn section_at(&self, b: f64) -> AsBuilt {
        let basic_data = self.gear.basic_data();
        let angle = b * basic_data.twist();
        let teeth = self.face.ascending() * angle / basic_data.angular_pitch();
        let height = self.height + self.inwards() * b;
        let turned_back = |tooth: f64| basic_data.tooth_after(tooth - 1.0 - teeth);
        let (eccentricity, high_tooth) = if self.wobble == 0.0 {
            (self.eccentricity, self.high_tooth)
        } else {
            let centre = self.displacement(0.0) + b * self.lean(0.0);
            let angle = self.face.ascending() * centre.y.atan2(centre.x);
            (centre.norm(), basic_data.tooth_towards(angle))
        };
        AsBuilt {
            eccentricity,
            high_tooth: turned_back(high_tooth),
            wobble_tooth: turned_back(self.wobble_tooth),
            height,
            ..self.with_leads_turned(|curve| curve.at(height) - curve.at(self.height))
        }
    }

    /// The section of this gear in its measuring plane.
    #[must_use]
    pub fn in_measuring_plane(&self) -> AsBuilt {
        if self.height == 0.0 {
            self.clone()
        } else {
            self.section_at(-self.place())
        }
    }

    /// Place of this section, mm from the measuring plane away from the viewer.
    pub(crate) fn place(&self) -> f64 {
        self.inwards() * self.height
    }

    /// This section with its outline turned about the axis by `angle`, rad. All teeth turn by the same angle, counter-clockwise.
    pub(crate) fn turned(self, angle: f64) -> AsBuilt {
        let basic_data = self.gear.basic_data();
        let teeth = self.face.ascending() * angle / basic_data.angular_pitch();
        AsBuilt {
            offsets: self.offsets_by(|_, _, offset| offset + angle),
            high_tooth: basic_data.tooth_after(self.high_tooth - 1.0 + teeth),
            ..self
        }
    }

    /// This section with its right and its left flanks turned further, rad, counter-clockwise, tooth 1 first.
    pub(crate) fn with_flanks_turned(self, turns: [Vec<f64>; 2]) -> AsBuilt {
        let turn = |side: Side, tooth: u32| turns[side.index()][tooth as usize - 1];
        AsBuilt {
            offsets: self.offsets_by(|side, tooth, offset| offset + turn(side, tooth)),
            wobble: 0.0,
            ..self
        }
    }

    /// This gear with its reference face turned to `face`.
    ///
    /// Turning the gear over exchanges right and left in the picture, and clockwise and counter-clockwise.
    #[must_use]
    pub fn facing(&self, face: Face) -> AsBuilt {
        if face == self.face {
            return self.clone();
        }
        let across = |side: Side, tooth, _| -self.flank_offset(side.other(), tooth);
        let swapped = |[right, left]: &[HalfTeeth; 2]| Arc::new([left.clone(), right.clone()]);
        AsBuilt {
            face,
            offsets: self.offsets_by(across),
            modified: self.modified.as_deref().map(swapped),
            ..self.clone()
        }
    }

    /// Mean arc thickness at the reference circle, mm, that profile deviations add to a tooth.
    pub(crate) fn arc_of_profiles(&self) -> f64 {
        let basic_data = self.gear().basic_data();
        let (r, base) = (basic_data.reference_radius(), basic_data.base_radius());
        let roll = involute::roll_at(r, base);
        let of_flank = |side: Side, tooth: u32| {
            let there = end_at(base, roll, self.modification(side, tooth)?);
            there.map(|there| r * (roll - there))
        };
        let of_side = |side: Side| -> f64 {
            let teeth = 1..=basic_data.teeth();
            teeth.filter_map(|tooth| of_flank(side, tooth)).sum()
        };
        Side::BOTH.map(of_side).iter().sum::<f64>() / f64::from(basic_data.teeth())
    }
}

/// The half teeth on both sides of the picture with the gear's profile deviations; `None` without any.
pub(super) fn modified(
    gear: &Gear,
    face: Face,
    profiles: &[Modification; 2],
) -> Result<Option<[HalfTeeth; 2]>, GearError> {
    if profiles.iter().all(Modification::is_none) {
        return Ok(None);
    }
    let halves = Side::BOTH.map(|side| {
        let profile = &profiles[face.flank_of(side).index()];
        modified_flanks::modified(gear, &profile.curves(gear)?)
    });
    let [right, left] = halves;
    Ok(Some([right?, left?]))
}

#[cfg(test)]
mod tests;

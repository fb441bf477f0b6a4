//! The excess of flanks with a profile deviation, as a gauge finds it.
//!
//! A plane, a ball or a measuring circle touches such a flank like an involute moved outwards by the *excess*. Let
//! `E = e^{iξ}`, and let the flank be `E (r_b − ia)` with `a = r_b ξ + δ(ξ)`. Let `θ` be the roll at which the gauge would touch
//! the involute (own derivations):
//!
//! - A plane perpendicular to the base tangent at `θ` lies at the greatest `a cos u − r_b sin u`, `u = ξ − θ`. On an involute
//!   it lies at `r_b θ`.
//! - A ball of radius `ρ` has its centre at `c` along that tangent. It touches the point at `ξ` if
//!   `θ = ξ − atan(a/r_b) − β + atan(c/r_b)`. Here `β` is the angle at the gear's centre in the triangle of `R = √(r_b² + a²)`,
//!   `√(r_b² + c²)` and `ρ`. The least `θ` counts. On an involute `c = r_b θ + ρ`.
//! - A circle about the centre crosses the flank at the same length of the tangent, `r_b ξ + δ = r_b ξ_0`.
//!
//! To first order each excess is `δ` at the contact. The greatest sample is refined by golden section.

use super::modified_flanks::end_at;
use super::{
    ByTooth, DeviationCurve, Deviations, Flank, FlankShifts, Gear, Modification, involute,
    thickness,
};
use crate::error::GearError;
use crate::numeric::golden_section;
use std::collections::HashMap;

/// Samples over the range of possible contact. Tuned: a measured trace has some hundred points on the whole flank.
const SAMPLES: usize = 64;
/// Width to which a maximum is narrowed down, rad: there a value is 1e-18 of the arm below it.
const SUMMIT: f64 = 1e-9;

/// A flank that a gauge touches.
struct GaugedFlank<'a> {
    base: f64,
    deviation: &'a DeviationCurve,
    /// Rolls of its lower and upper end.
    ends: [f64; 2],
}

impl GaugedFlank<'_> {
    /// Excess for a plane that would touch the involute at the roll `theta`, mm.
    fn by_plane(&self, theta: f64) -> f64 {
        let base = self.base;
        self.greatest(theta, |xi| {
            let u = xi - theta;
            let (sin, cos) = u.sin_cos();
            let half = (0.5 * u).sin();
            base * (u * cos - sin) - 2.0 * base * theta * half * half + self.deviation.at(xi) * cos
        })
    }

    /// Excess for a ball of `radius` with its centre at `centre` along the base tangent, mm.
    fn by_ball(&self, centre: f64, radius: f64) -> f64 {
        let base = self.base;
        let (far, beyond) = (base.hypot(centre), (centre / base).atan());
        self.greatest((centre - radius) / base, |xi| {
            let arm = base * xi + self.deviation.at(xi);
            let at = base.hypot(arm);
            let square = (radius - (far - at)) * (radius + (far - at)) / (4.0 * far * at);
            let beta = 2.0 * square.max(0.0).sqrt().asin();
            centre - radius - base * (xi - (arm / base).atan() - beta + beyond)
        })
    }

    /// Excess for a circle through the roll `xi`, mm.
    fn by_circle(&self, xi: f64) -> f64 {
        let there = end_at(self.base, xi, self.deviation);
        there.map_or(0.0, |there| self.base * (xi - there))
    }

    /// The greatest `value` on the flank near the roll `about`.
    fn greatest(&self, about: f64, value: impl Fn(f64) -> f64) -> f64 {
        let [low, high] = self.ends;
        let about = about.clamp(low, high);
        let [[least, most], ..] = self.deviation.bounds(low, high);
        // A point at the distance u loses r_b ξ u²/2 or more, and gains no more than the range of the deviation.
        let arm = self.base * low.max(0.25 * about).max(1e-3);
        let reach = 1.5 * (2.0 * (most - least) / arm).sqrt() + 1e-9;
        let (low, high) = ((about - reach).max(low), (about + reach).min(high));
        let at = |k: usize| low + (high - low) * k as f64 / SAMPLES as f64;
        let values: Vec<f64> = (0..=SAMPLES).map(|k| value(at(k))).collect();
        let mut greatest = value(about);
        for k in 0..=SAMPLES {
            let beside = [k.saturating_sub(1), (k + 1).min(SAMPLES)];
            if beside.iter().all(|&other| values[k] >= values[other]) {
                let [left, right] = beside.map(at);
                let (narrowed, _) = golden_section(left, right, SUMMIT, &value);
                greatest = greatest.max(values[k]).max(narrowed);
            }
        }
        greatest
    }
}

/// The profile deviations of all flanks of a gear.
pub(crate) struct Excess<'a> {
    gear: &'a Gear,
    /// Curves of the gear's own right and left flanks.
    curves: [ByTooth<DeviationCurve>; 2],
}

impl<'a> Excess<'a> {
    /// Profile deviations of `profiles` on `gear`; `None` without any.
    ///
    /// # Errors
    /// As [`Modification::curves`].
    pub fn new(
        gear: &'a Gear,
        profiles: &[Modification; 2],
    ) -> Result<Option<Excess<'a>>, GearError> {
        if profiles.iter().all(Modification::is_none) {
            return Ok(None);
        }
        let [right, left] = profiles.each_ref().map(|profile| profile.curves(gear));
        Ok(Some(Excess {
            gear,
            curves: [right?, left?],
        }))
    }

    /// The `excess` of every flank touched at the place `at`, as shifts at the reference circle.
    fn shifts(
        &self,
        at: impl Fn(Flank, u32) -> f64,
        excess: impl Fn(&GaugedFlank, f64) -> f64,
    ) -> FlankShifts {
        let gear = self.gear;
        let cos = gear.basic_data().transverse_pressure_angle().cos();
        let mut known: HashMap<(Flank, usize, u64), f64> = HashMap::new();
        let of_side = |own: Flank| -> Vec<f64> {
            let curves = &self.curves[own.index()];
            let teeth = 1..=gear.basic_data().teeth();
            let of_tooth = |tooth: u32| {
                let curve = curves.of(tooth);
                let place = at(own, tooth);
                *known
                    .entry((own, curves.shape_of(tooth), place.to_bits()))
                    .or_insert_with(|| {
                        let base = gear.base_radius();
                        let ends = [gear.form_roll(), gear.tip_roll()];
                        let touched = GaugedFlank {
                            base,
                            deviation: curve,
                            ends: ends.map(|xi| end_at(base, xi, curve).unwrap_or(xi)),
                        };
                        excess(&touched, place)
                    })
            };
            // Right flanks are on the ascending side of their tooth.
            let outward = -own.sense() / cos;
            let shifts = teeth.map(of_tooth).map(|mm| outward * mm);
            shifts.collect()
        };
        FlankShifts(Flank::BOTH.map(of_side))
    }

    /// Excess where the anvils of a span over `k` teeth touch, with flanks displaced as in `known`.
    ///
    /// The anvils are perpendicular to the middle of these teeth.
    ///
    /// # Errors
    /// [`GearError::WrongLength`].
    pub fn by_span(&self, k: u32, known: &Deviations) -> Result<FlankShifts, GearError> {
        let gear = self.gear;
        let basic_data = gear.basic_data();
        let standing = FlankShifts::new(basic_data, known)?;
        let span = thickness::span_from_base(basic_data, k, gear.base_thickness());
        let middle = 0.5 * span / gear.base_radius();
        let r = basic_data.reference_radius();
        let at = |own: Flank, tooth| middle - own.sense() * standing.at(own, tooth, 0) / r;
        Ok(self.shifts(at, |touched, roll| touched.by_plane(roll)))
    }

    /// Excess where pins touch in each space, with flanks displaced as in `known` and by the excess found `before`.
    ///
    /// # Errors
    /// [`GearError::WrongLength`].
    pub fn by_pins(
        &self,
        pin: f64,
        known: &Deviations,
        before: &FlankShifts,
    ) -> Result<FlankShifts, GearError> {
        let gear = self.gear;
        let basic_data = gear.basic_data();
        let standing = FlankShifts::new(basic_data, known)?.plus(before);
        let teeth = basic_data.teeth();
        let at = |own: Flank, tooth: u32| {
            // The space after the tooth of the right flank.
            let space = match own {
                Flank::Right => tooth,
                Flank::Left => (tooth + teeth - 2) % teeth + 1,
            };
            let apart = standing.at(Flank::Right, space, 0) - standing.at(Flank::Left, space, 1);
            let base = gear.base_thickness() + apart * basic_data.transverse_pressure_angle().cos();
            let centre = thickness::pin_centre_radius(basic_data, pin, base);
            gear.base_radius() * involute::roll_at(centre, gear.base_radius())
        };
        Ok(self.shifts(at, |touched, centre| touched.by_ball(centre, 0.5 * pin)))
    }

    /// Excess on the reference circle.
    pub fn by_reference_circle(&self) -> FlankShifts {
        let basic_data = self.gear.basic_data();
        let roll = involute::roll_at(basic_data.reference_radius(), basic_data.base_radius());
        self.shifts(|_, _| roll, |touched, roll| touched.by_circle(roll))
    }
}

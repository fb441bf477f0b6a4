//! What flanks with a profile deviation stand out where a gauge touches them.
//!
//! A plane, a ball or a measuring circle finds such a flank where it would find an involute that stands out of the metal by the *excess*. With
//! `E = e^{iξ}`, the flank `E (r_b − ia)`, `a = r_b ξ + δ(ξ)`, and a gauge that an involute would touch at the roll `θ` (own derivations):
//!
//! - A plane square to the base tangent at `θ` stands at the greatest `a cos u − r_b sin u`, `u = ξ − θ`; an involute holds it at `r_b θ`.
//! - A ball whose centre is `c` along that tangent touches the point at `ξ` where the two stand apart, seen from the gear's centre, by the
//!   angle `β` of the triangle of `R = √(r_b² + a²)`, `√(r_b² + c²)` and the ball's radius `ρ`: at
//!   `θ = ξ − atan(a/r_b) − β + atan(c/r_b)`. The least of them counts; an involute holds it at `c = r_b θ + ρ`.
//! - A circle about the centre crosses at the same length of the tangent, `r_b ξ + δ = r_b ξ_0`.
//!
//! To first order each is `δ` where it touches; the greatest is sought among samples and narrowed down until rounding hides it.

use super::modified_flanks::end_at;
use super::{
    AsBuilt, Deviations, Flank, FlankShifts, Gear, Modification, RollCurve, Side, involute,
    thickness,
};
use crate::error::GearError;
use crate::numeric::golden_section;
use std::collections::HashMap;
use std::sync::Arc;

/// Samples over the stretch that may be touched. Tuned: a measured trace has some hundred points on the whole flank.
const SAMPLES: usize = 64;
/// Width to which a maximum is narrowed down, rad: there a value is 1e-18 of the arm below it.
const SUMMIT: f64 = 1e-9;

/// One flank, touched.
struct Touched<'a> {
    base: f64,
    deviation: &'a RollCurve,
    /// Rolls of its lower and upper end.
    ends: [f64; 2],
}

impl Touched<'_> {
    /// By a plane that an involute would touch at the roll `theta`, mm.
    fn by_plane(&self, theta: f64) -> f64 {
        let base = self.base;
        self.greatest(theta, |xi| {
            let u = xi - theta;
            let (sin, cos) = u.sin_cos();
            let half = (0.5 * u).sin();
            base * (u * cos - sin) - 2.0 * base * theta * half * half + self.deviation.at(xi) * cos
        })
    }

    /// By a ball of `radius` whose centre lies `centre` along the base tangent, mm.
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

    /// By a circle of the roll `xi`, mm.
    fn by_circle(&self, xi: f64) -> f64 {
        let there = end_at(self.base, xi, self.deviation);
        there.map_or(0.0, |there| self.base * (xi - there))
    }

    /// The greatest `value` on the flank near the roll `about`.
    fn greatest(&self, about: f64, value: impl Fn(f64) -> f64) -> f64 {
        let [low, high] = self.ends;
        let about = about.clamp(low, high);
        let [[least, most], ..] = self.deviation.bounds(low, high);
        // A point at the distance u loses r_b ξ u²/2 or more; it cannot gain more than the deviation varies.
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

impl AsBuilt {
    /// Arc thickness at the reference circle, mm, that profile deviations add to the mean tooth.
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

/// The profile deviations of all flanks of a gear.
pub(crate) struct Excess<'a> {
    gear: &'a Gear,
    /// Of the gear's own right flanks and of its left ones: by tooth, or one for all.
    curves: [Vec<Arc<RollCurve>>; 2],
}

impl<'a> Excess<'a> {
    /// Those of `profiles` on `gear`; `None` where there are none.
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

    /// Of every flank, as shifts at the reference circle: `excess` of the flank of a side and tooth, and where it is touched.
    fn shifts(
        &self,
        at: impl Fn(Flank, u32) -> f64,
        excess: impl Fn(&Touched, f64) -> f64,
    ) -> FlankShifts {
        let gear = self.gear;
        let cos = gear.basic_data().transverse_pressure_angle().cos();
        let mut known: HashMap<(*const RollCurve, u64), f64> = HashMap::new();
        let mut of_side = |own: Flank| -> Vec<f64> {
            let curves = &self.curves[usize::from(own == Flank::Left)];
            let teeth = 1..=gear.basic_data().teeth();
            let of_tooth = |tooth: u32| {
                let curve = &curves[(tooth as usize - 1).min(curves.len() - 1)];
                let place = at(own, tooth);
                *known
                    .entry((Arc::as_ptr(curve), place.to_bits()))
                    .or_insert_with(|| {
                        let base = gear.base_radius();
                        let ends = [gear.form_roll(), gear.tip_roll()];
                        let touched = Touched {
                            base,
                            deviation: curve,
                            ends: ends.map(|xi| end_at(base, xi, curve).unwrap_or(xi)),
                        };
                        excess(&touched, place)
                    })
            };
            // Right flanks stand at the ascending end of their tooth.
            let outward = -own.sense() / cos;
            let shifts = teeth.map(of_tooth).map(|mm| outward * mm);
            shifts.collect()
        };
        FlankShifts {
            right: of_side(Flank::Right),
            left: of_side(Flank::Left),
        }
    }

    /// Where anvils over `k` teeth touch that stand square to the middle of these teeth, the flanks standing as `known`.
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

    /// Where pins of a diameter touch in each space, the flanks standing as `known` and out by what was found `before`.
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
        let mut standing = FlankShifts::new(basic_data, known)?;
        standing.add(before);
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

    /// Where the reference circle crosses.
    pub fn by_reference_circle(&self) -> FlankShifts {
        let basic_data = self.gear.basic_data();
        let roll = involute::roll_at(basic_data.reference_radius(), basic_data.base_radius());
        self.shifts(|_, _| roll, |touched, roll| touched.by_circle(roll))
    }
}

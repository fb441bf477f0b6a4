//! Profile deviation: a stylus along the tangents of the base circle, roll by roll.
//!
//! The tangent at a roll `ξ` crosses an involute at `r_b ξ` from its point on the base circle. The further distance of the flank is its
//! deviation, plus = more material. The reference is the involute of the mean thickness in its undisturbed place, so the pitch is no part
//! of a profile. The evaluation follows ISO 1328-1 with the involute as design profile. Over the evaluation range a least-squares mean line
//! is fitted over the roll. `f_Hα` is the rise of the mean line over the range, `f_fα` the range of the deviation about the mean line, and
//! `F_α` the range of the deviation itself.

use super::Unmeasured;
use super::workpiece::Workpiece;
use crate::gear::{Flank, involute};
use crate::numeric::{ends, mean, range};
use crate::parallel;

/// Points over a range (tuned: the range of a parabola is accurate to about 1e-5).
const POINTS: usize = 201;
/// Roll omitted at the ends of the flank, rad: more than rounding, and far below the distance of two points.
const INSIDE: f64 = 1e-9;
/// Multiple of its bound above which a deviation is more than rounding.
const LEVEL: f64 = 100.0;

/// Profiles of all flanks.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ProfileReadings {
    /// Profiles of the gear's own right flanks, then of its left ones.
    pub flanks: [FlankTraces; 2],
    /// Their evaluation ranges as diameters, mm.
    pub evaluated_diameters: [[f64; 2]; 2],
    /// Bound on the error of each deviation, mm.
    pub error: f64,
}

/// Profiles or leads of the flanks of one side.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FlankTraces {
    /// The evaluation range: roll lengths `r_b ξ` of profiles, heights of leads, mm.
    pub evaluated: [f64; 2],
    /// Distinct traces.
    pub shapes: Vec<TraceReading>,
    /// Index of the trace of each tooth, tooth 1 first.
    pub of_tooth: Vec<usize>,
}

/// One profile or lead.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TraceReading {
    /// Over the whole flank: roll length `r_b ξ` or height, and deviation, mm.
    pub points: Vec<(f64, f64)>,
    /// Ends of the mean line, at those of the evaluation range.
    pub mean_line: [(f64, f64); 2],
    /// Slope deviation, mm: `f_Hα` of a profile; material of a lead that grows away from the reference face.
    pub slope: f64,
    /// Form deviation `f_fα` or `f_fβ`, mm.
    pub form: f64,
    /// Total deviation `F_α` or `F_β`, mm.
    pub total: f64,
    /// Crowning over the evaluation range, mm: rise of the middle of the least-squares parabola above the chord of its ends.
    pub crowning: f64,
}

impl ProfileReadings {
    /// The profiles of a gear's own flank.
    pub fn flank(&self, own: Flank) -> &FlankTraces {
        &self.flanks[own.index()]
    }

    /// Whether any profile deviates by more than rounding.
    pub fn deviates(&self) -> bool {
        let mut shapes = self.flanks.iter().flat_map(|flank| &flank.shapes);
        let off = |shape: &TraceReading| {
            let mut points = shape.points.iter();
            points.any(|point| point.1.abs() > LEVEL * self.error)
        };
        shapes.any(off)
    }
}

impl FlankTraces {
    /// The trace of a tooth, from 1.
    pub fn tooth(&self, tooth: u32) -> &TraceReading {
        &self.shapes[self.of_tooth[tooth as usize - 1]]
    }

    /// `of` for each tooth, tooth 1 first.
    pub fn by_tooth(&self, of: impl Fn(&TraceReading) -> f64) -> Vec<f64> {
        let teeth = self.of_tooth.iter();
        teeth.map(|&shape| of(&self.shapes[shape])).collect()
    }

    /// Mean over the teeth.
    pub fn mean(&self, of: impl Fn(&TraceReading) -> f64) -> f64 {
        mean(self.by_tooth(of))
    }

    /// The value of greatest amount, with its sign, and its tooth.
    pub fn worst(&self, of: impl Fn(&TraceReading) -> f64) -> (u32, f64) {
        let teeth = (1..).zip(self.by_tooth(of));
        let greater = |worst: (u32, f64), (tooth, value): (u32, f64)| {
            if value.abs() > worst.1.abs() {
                (tooth, value)
            } else {
                worst
            }
        };
        teeth.fold((1, 0.0), greater)
    }

    /// The tooth of the greatest total deviation.
    pub fn worst_tooth(&self) -> u32 {
        self.worst(|profile| profile.total).0
    }
}

/// Measures the profile of every flank. It is evaluated between the `radii` of the own right and left flanks, or over the whole flank.
pub(super) fn profile(
    work: &Workpiece,
    radii: [Option<[f64; 2]>; 2],
) -> Result<ProfileReadings, Unmeasured> {
    let gear = work.as_built.gear();
    let base = gear.base_radius();
    let rolls = radii.map(|radii| match radii {
        Some(radii) => radii.map(|radius| involute::roll_at(radius, base)),
        None => [gear.form_roll(), gear.tip_roll()],
    });
    let ((right, one), (left, other)) = (
        of_flank(work, Flank::Right, rolls[0])?,
        of_flank(work, Flank::Left, rolls[1])?,
    );
    let diameters = |ends: [f64; 2]| ends.map(|xi| 2.0 * involute::radius_at(xi, base));
    Ok(ProfileReadings {
        evaluated_diameters: rolls.map(diameters),
        flanks: [right, left],
        error: one.max(other),
    })
}

/// The profiles of one side, and the bound on their error, mm.
fn of_flank(
    work: &Workpiece,
    own: Flank,
    rolls: [f64; 2],
) -> Result<(FlankTraces, f64), Unmeasured> {
    let gear = work.as_built.gear();
    let base = gear.base_radius();
    let side = work.as_built.face().seen_from_front(own);
    let of_tooth: Vec<usize> = (1..=gear.basic_data().teeth())
        .map(|tooth| work.as_built.shape_of(side, tooth))
        .collect();
    // The first tooth of each shape.
    let first = |shape| of_tooth.iter().position(|&of| of == shape);
    let teeth = (0..work.as_built.shapes(side)).filter_map(first);
    let teeth: Vec<u32> = teeth.map(|index| index as u32 + 1).collect();
    let read = |[from, to]: [f64; 2], tooth: u32| -> Option<(Vec<(f64, f64)>, f64)> {
        let mut worst = 0.0;
        let point = |k: usize| {
            let xi = from + (to - from) * k as f64 / (POINTS - 1) as f64;
            let (at, error) = work.along_tangent(side, tooth, xi)?;
            worst = f64::max(worst, error);
            Some((base * xi, at - base * xi))
        };
        let points = (0..POINTS).map(point).collect::<Option<_>>()?;
        Some((points, worst))
    };
    let shape = |tooth: u32| {
        let [low, high] = work.flank_rolls(side, tooth);
        let whole = [low + INSIDE, high - INSIDE];
        let evaluated = [rolls[0].max(whole[0]), rolls[1].min(whole[1])];
        let (points, error) = read(whole, tooth)?;
        let (within, more) = read(evaluated, tooth)?;
        Some((evaluate(points, &within), error.max(more)))
    };
    let mut error = 0.0;
    let mut shapes = Vec::new();
    let read = parallel::map(teeth.iter().copied(), shape);
    for (tooth, found) in teeth.iter().zip(read) {
        let Some((found, bound)) = found else {
            return Err(off_flank(own, *tooth));
        };
        error = f64::max(error, bound);
        shapes.push(found);
    }
    let profiles = FlankTraces {
        evaluated: rolls.map(|xi| base * xi),
        shapes,
        of_tooth,
    };
    Ok((profiles, error))
}

/// The reason why a trace of the flank of `tooth` cannot be taken.
pub(super) fn off_flank(own: Flank, tooth: u32) -> Unmeasured {
    let flank = own.name();
    Unmeasured(format!(
        "the stylus leaves the {flank} flank of tooth {tooth}"
    ))
}

/// The evaluation of the points `within` the range, which are evenly spread. Each represents the stretch half way to
/// its neighbours, the first and the last half of that.
pub(super) fn evaluate(points: Vec<(f64, f64)>, within: &[(f64, f64)]) -> TraceReading {
    let last = within.len() - 1;
    let weight = |k: usize| if k == 0 || k == last { 0.5 } else { 1.0 };
    let sum = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
        let points = within.iter().enumerate();
        points.map(|(k, &(at, off))| weight(k) * of(at, off)).sum()
    };
    let [at, off] = [sum(&|at, _| at), sum(&|_, off| off)].map(|sum| sum / last as f64);
    let square = sum(&|one, _| (one - at).powi(2));
    let rise = sum(&|one, value| (one - at) * (value - off)) / square;
    let [from, to] = ends(within.iter().map(|point| point.0));
    let on_line = |length: f64| (length, off + rise * (length - at));
    // The parabola that is square to every straight line over the range.
    let mean_square = square / last as f64;
    let bend = |one: f64| (one - at).powi(2) - mean_square;
    let bent = sum(&|one, value| bend(one) * value) / sum(&|one, _| bend(one).powi(2));
    TraceReading {
        crowning: -bent * (0.5 * (to - from)).powi(2),
        points,
        mean_line: [on_line(from), on_line(to)],
        slope: rise * (to - from),
        form: range(within.iter().map(|point| point.1 - rise * point.0)),
        total: range(within.iter().map(|point| point.1)),
    }
}

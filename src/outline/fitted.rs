//! Fits to an outline: the centre from its tips, and the involute that its flanks resemble.
//!
//! The fitted involute is a finding with its residual; no result depends on it. Points of the middle flanks are fitted to involutes
//! of one base circle, each flank with its own start. The distance of a point from an involute, along the normal, is
//! `r_b (θ − inv α − c)`, with its polar angle `θ`, `cos α = r_b / r`, and the start `c` of the flank on the base circle. The
//! derivative by `r_b` is `θ + α − c'` (Gauss–Newton, with each `c` eliminated). Straight lines contribute their ends only, because
//! lines along a flank are chords.
//!
//! A base circle determines only `m cos α`: every rack of that base pitch generates it. The fit offers all standard modules at usual
//! pressure angles with that base circle.

use super::gear::OutlineGear;
use super::half::HalfOutline;
use super::path::{ClosedPath, PathSegment};
use super::polygon;
use super::teeth::find_teeth;
use crate::error::OutlineError;
use crate::gear::{PartCurve, Side, involute};
use crate::numeric::mean;
use nalgebra::{Complex, Matrix3, Point2, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Rounds of the centre (tuned): each finds the tips again about the centre of the last round.
const CENTRE_ROUNDS: u32 = 8;

/// A fitted centre and its residual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedCentre {
    /// In the drawing, mm.
    pub centre: Point2<f64>,
    /// Greatest distance of a tip from the fitted circle, mm.
    pub residual: f64,
}

/// The centre of the circle through the middles of the tips, by least squares of `x² + y² + a x + b y + c` (Kåsa 1976).
///
/// # Errors
/// As [`super::OutlineGear::new`].
pub fn fit_centre(segments: &[PathSegment]) -> Result<FittedCentre, OutlineError> {
    let mut fitted = FittedCentre {
        centre: centroid(segments),
        residual: 0.0,
    };
    for _ in 0..CENTRE_ROUNDS {
        let path = ClosedPath::new(segments, fitted.centre)?;
        let tips: Vec<Point2<f64>> = find_teeth(&path)?.iter().map(|tooth| tooth.tip).collect();
        let (mut matrix, mut sum) = (Matrix3::zeros(), Vector3::zeros());
        for tip in &tips {
            let row = Vector3::new(tip.x, tip.y, 1.0);
            matrix += row * row.transpose();
            sum -= row * tip.coords.norm_squared();
        }
        let Some(solved) = matrix.lu().solve(&sum) else {
            return Ok(fitted);
        };
        let off = Point2::new(-0.5 * solved.x, -0.5 * solved.y);
        let radii = tips.iter().map(|tip| (tip - off).norm());
        let radius = (off.coords.norm_squared() - solved.z).sqrt();
        fitted = FittedCentre {
            centre: fitted.centre + off.coords,
            residual: radii
                .map(|found| (found - radius).abs())
                .fold(0.0, f64::max),
        };
    }
    Ok(fitted)
}

/// The centroid of the area that the segments' ends and middles enclose.
fn centroid(segments: &[PathSegment]) -> Point2<f64> {
    let both = |segment: &PathSegment| [segment.start(), segment.at(0.5)];
    let points: Vec<Point2<f64>> = segments.iter().flat_map(both).collect();
    // A path without area: the first point. The caller reports the error.
    let first = points.first().copied().unwrap_or_default();
    polygon::centroid(&points).unwrap_or(first)
}

/// Range of the tooth depth, from the root, used for the fit: above fillets and undercut, below tip rounding and relief.
///
/// The undercut of a standard tooth ends at 0.44 of its depth even with ten teeth.
const MIDDLE: [f64; 2] = [0.5, 0.9];

/// Fewest points of a flank: any base circle fits two points.
const LEAST_POINTS: usize = 3;

/// Parts into which a curve is divided for its points (tuned).
const PARTS: u32 = 8;

/// Greatest residual of an involute, over the height of its arc above the chord. Tuned: with 20 teeth of module 2 this is some 6 µm,
/// which a ground gear meets. Arcs with a radius a quarter greater leave 0.13, straight flanks 0.67.
const CURVED: f64 = 0.1;

/// Most rounds of the base radius; each squares the error.
const ROUNDS: u32 = 40;

/// Modules with a smaller relative difference are equal: rounding of a drawing's decimals.
const SAME: f64 = 1e-6;

/// ISO 54, both series, and DIN 780 below 1; mm.
const MODULES: [f64; 48] = [
    0.1, 0.12, 0.16, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.125, 1.25, 1.375, 1.5,
    1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 6.5, 7.0, 8.0, 9.0, 10.0, 11.0,
    12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 32.0, 36.0, 40.0, 45.0, 50.0,
];

/// Usual pressure angles, degrees, the commonest first.
const ANGLES_DEG: [f64; 3] = [20.0, 14.5, 25.0];

/// The involute fitted to the flanks of an outline.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedInvolute {
    /// Base radius `r_b`, mm.
    pub base_radius: f64,
    /// Error bound of the base radius, mm, from the residual and the outline's bound.
    pub base_radius_error: f64,
    /// Mean tooth thickness on the base circle, mm.
    pub base_thickness: f64,
    /// Greatest distance of a point of the middle flanks from its involute, along the normal, mm.
    pub residual: f64,
    /// Greatest residual of an involute, mm.
    pub limit: f64,
    /// Standard gears with this base circle.
    pub standard: Vec<StandardGear>,
}

/// A standard gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StandardGear {
    /// Module `m`, mm.
    pub module: f64,
    /// Pressure angle `α`, rad.
    pub pressure_angle: f64,
    /// Generating shift `x_E`: profile shift and thickness allowance together, in modules.
    pub shift: f64,
}

/// A point of a flank: radius and angle from the flank's first point.
type Polar = (f64, f64);

/// The involute fitted to the flanks of `gear`; `None` if they are no involutes or have fewer than three points in the middle of their depth.
pub fn fit_involute(gear: &OutlineGear) -> Option<FittedInvolute> {
    let depth = gear.tip_radius() - gear.root_radius();
    let range = MIDDLE.map(|share| gear.root_radius() + share * depth);
    let teeth = 1..=gear.teeth();
    let halves = teeth.flat_map(|tooth| Side::BOTH.map(|side| gear.half(side, tooth)));
    let mut flanks: Vec<(f64, Vec<Polar>)> = Vec::new();
    for half in halves {
        flanks.push(middle(half, range)?);
    }
    let radii = flanks
        .iter()
        .flat_map(|flank| flank.1.iter().map(|point| point.0));
    let lowest = radii.fold(f64::INFINITY, f64::min);
    let (base, error) = base_radius(&flanks, lowest)?;
    let (mut residual, mut starts): (f64, Vec<f64>) = (0.0, Vec::new());
    for (first, points) in &flanks {
        let off = distances(points, base);
        let mean = mean(&off);
        residual = off
            .iter()
            .fold(residual, |most, off| most.max((off - mean).abs()));
        starts.push(first + mean / base);
    }
    let [from, to] = range.map(|radius| involute::roll_at(radius, base));
    let length = 0.5 * base * (to * to - from * from);
    let limit = CURVED * length * length / (8.0 * base * 0.5 * (from + to));
    if !(residual <= limit) {
        return None;
    }
    // Both flanks start before the tooth's centre line, the left one in its mirrored frame.
    let half_angles = starts
        .chunks(2)
        .map(|sides| 0.5 * (-sides[0] - sides[1]).rem_euclid(TAU));
    let half_angle = half_angles.sum::<f64>() / f64::from(gear.teeth());
    let base_radius_error = error * (residual + gear.bound());
    Some(FittedInvolute {
        base_radius: base,
        base_radius_error,
        base_thickness: 2.0 * base * half_angle,
        residual,
        limit,
        standard: standard(f64::from(gear.teeth()), base, base_radius_error, half_angle),
    })
}

/// Distances of `points` from the involute that starts at angle 0, mm.
fn distances(points: &[Polar], base: f64) -> Vec<f64> {
    let distance = |(radius, angle): &Polar| {
        base * (angle - involute::inv_of_roll(involute::roll_at(*radius, base)))
    };
    points.iter().map(distance).collect()
}

/// The base radius by least squares, mm, and the greatest ratio of its error to the errors of the points.
fn base_radius(flanks: &[(f64, Vec<Polar>)], lowest: f64) -> Option<(f64, f64)> {
    // The start assumes a pressure angle of 20° at the lowest point.
    let mut base = lowest * 20f64.to_radians().cos();
    for _ in 0..ROUNDS {
        let (mut product, mut square, mut sum) = (0.0, 0.0, 0.0);
        for (_, points) in flanks {
            let off = distances(points, base);
            let slope = points
                .iter()
                .map(|(radius, angle)| angle + involute::roll_at(*radius, base).atan());
            let slope: Vec<f64> = slope.collect();
            let (off_mean, slope_mean) = (mean(&off), mean(&slope));
            for (off, slope) in off.iter().zip(&slope) {
                let slope = slope - slope_mean;
                product += slope * (off - off_mean);
                square += slope * slope;
                sum += slope.abs();
            }
        }
        let step = -product / square;
        base += step;
        // No involute of a base circle beyond this range reaches the points.
        if !(base > 0.5 * lowest && base < lowest) {
            return None;
        }
        if step.abs() <= 1e-13 * base {
            return Some((base, sum / square));
        }
    }
    None
}

/// Standard gears of `teeth` teeth with the base radius `base` ± `error`.
fn standard(teeth: f64, base: f64, error: f64, half_angle: f64) -> Vec<StandardGear> {
    let mut found = Vec::new();
    for angle in ANGLES_DEG.map(f64::to_radians) {
        for module in MODULES {
            let off = 0.5 * module * teeth * angle.cos() - base;
            if off.abs() <= error + SAME * base {
                // s_b / 2 r_b = (π/2 + 2 x tan α) / z + inv α.
                let shift = (half_angle - involute::inv(angle)) * teeth - FRAC_PI_2;
                found.push(StandardGear {
                    module,
                    pressure_angle: angle,
                    shift: shift / (2.0 * angle.tan()),
                });
            }
        }
    }
    found
}

/// The points of a half tooth between two radii, and the direction of the first; `None` with too few points.
fn middle(half: &HalfOutline, [low, high]: [f64; 2]) -> Option<(f64, Vec<Polar>)> {
    let mut points: Vec<Complex<f64>> = Vec::new();
    for piece in &half.pieces {
        let parts = match piece.curve {
            PartCurve::Line(_) => 1,
            _ => PARTS,
        };
        let [from, to] = piece.ends;
        for k in 0..=parts {
            let t = from + (to - from) * f64::from(k) / f64::from(parts);
            let point = piece.point(t);
            let inside = (low..=high).contains(&point.norm());
            let known = points.last();
            let new = known.is_none_or(|last| (last - point).norm() > SAME * (high - low));
            if inside && new {
                points.push(point);
            }
        }
    }
    let first = *points.first().filter(|_| points.len() >= LEAST_POINTS)?;
    let polar = |point: &Complex<f64>| (point.norm(), (point * first.conj()).arg());
    Some((first.arg(), points.iter().map(polar).collect()))
}

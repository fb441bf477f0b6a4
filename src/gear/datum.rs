//! Pitch measured about the datum axis: finding and removing the eccentricity it contains.
//!
//! The data locate every flank on the measuring (reference) circle about the datum axis. An eccentricity appears as a sine in
//! the curves of both flanks. The eccentricity is the one whose *exact* removal leaves no such sine in the
//! gear's own pitch deviation, both flanks jointly. A first harmonic of the gear's own pitch has the same shape. The data
//! cannot distinguish the two, and all of it counts as eccentricity.

use super::{Flank, Gear, Pitch, involute};
use crate::error::GearError;
use nalgebra::{Complex, Vector2};

/// A gear's own pitch deviation and the eccentricity separated from it.
#[derive(Debug, Clone, PartialEq)]
pub struct EccentricitySeparation {
    /// Pitch deviation free of eccentricity.
    pub pitch: Pitch,
    /// Eccentricity `e`, mm.
    pub eccentricity: f64,
    /// Tooth (fractional) towards which the outline is displaced.
    pub high_tooth: f64,
}

/// Most corrections of the eccentricity. Each leaves about `e/r` of the error: an eccentricity of a tenth of the radius needs a dozen.
const MOST_CORRECTIONS: usize = 50;

/// Separates datum-axis data `pitch` of `gear`, one value per tooth and flank, into own pitch and eccentricity.
///
/// # Errors
/// [`GearError::WrongLength`]; [`GearError::DatumPitch`] when no eccentricity explains the data.
pub fn separate_eccentricity(
    pitch: &Pitch,
    gear: &Gear,
) -> Result<EccentricitySeparation, GearError> {
    remove_eccentricity(pitch, gear, Vector2::zeros(), true)
}

/// Datum-axis data `pitch` of `gear` without the exact effect of a known `eccentricity`, mm, towards `high_tooth`.
///
/// The rest, including a first harmonic, is the gear's own pitch.
///
/// # Errors
/// As [`separate_eccentricity`].
pub fn without_eccentricity(
    pitch: &Pitch,
    gear: &Gear,
    eccentricity: f64,
    high_tooth: f64,
) -> Result<Pitch, GearError> {
    let (sin, cos) = ((high_tooth - 1.0) * gear.basic_data().angular_pitch()).sin_cos();
    let known = eccentricity * Vector2::new(cos, sin);
    Ok(remove_eccentricity(pitch, gear, known, false)?.pitch)
}

/// Removes the eccentricity `e` from the data `pitch`. If `is_sought`, corrects `e` until no sine is left.
fn remove_eccentricity(
    pitch: &Pitch,
    gear: &Gear,
    mut e: Vector2<f64>,
    is_sought: bool,
) -> Result<EccentricitySeparation, GearError> {
    let teeth = gear.basic_data().teeth();
    for side in Flank::BOTH {
        let found = pitch.flank(side).len();
        if found != teeth as usize {
            return Err(GearError::WrongLength {
                what: "pitch",
                found,
                teeth,
            });
        }
    }
    // Rounding of the readings is some ulps of the radius; no correction falls below it.
    let settled = 1e-13 * gear.basic_data().reference_radius();
    // The curves of a sheet count from their own means: these are the offsets of the readings.
    let mut means = [0.0; 2];
    for _ in 0..MOST_CORRECTIONS {
        let mut own = [Vec::new(), Vec::new()];
        let mut correction = Vector2::zeros();
        let mut drift: f64 = 0.0;
        for (i, side) in Flank::BOTH.into_iter().enumerate() {
            let (deviations, left) = without(pitch, gear, side, e, means[i])?;
            let mean = deviations.iter().sum::<f64>() / f64::from(teeth);
            means[i] -= mean;
            drift = drift.max(mean.abs());
            correction += left;
            own[i] = deviations;
        }
        if !is_sought {
            correction = Vector2::zeros();
        }
        e += correction;
        if correction.norm() <= settled && drift <= settled {
            return Ok(EccentricitySeparation {
                pitch: Pitch::from_cumulative(&own[0], &own[1]),
                eccentricity: e.norm(),
                high_tooth: gear.basic_data().tooth_towards(e.y.atan2(e.x)),
            });
        }
    }
    Err(GearError::DatumPitch(
        "no eccentricity explains these datum-axis pitch deviations",
    ))
}

/// The deviations of one flank after removing the eccentricity `e`, and the rest of the sine pattern in them.
///
/// The pattern of `e = (e_x, e_y)` is `F = (e_y cos(ψ ∓ α) − e_x sin(ψ ∓ α))/cos α`, right flanks with
/// `−α`, left with `+α`. Over equally spaced teeth its normal matrix, both flanks together, is
/// `z/cos² α` times unity (z ≥ 3).
fn without(
    pitch: &Pitch,
    gear: &Gear,
    side: Flank,
    e: Vector2<f64>,
    mean: f64,
) -> Result<(Vec<f64>, Vector2<f64>), GearError> {
    let basic_data = gear.basic_data();
    let alpha = basic_data.transverse_pressure_angle();
    // Ascending numbers count positive here: right flanks are ahead of their tooth.
    let ahead = -side.sense();
    let half = gear.half_angle_at_roll(alpha.tan());
    let mut own = Vec::new();
    let mut left = Vector2::zeros();
    for (index, reading) in pitch.flank(side).iter().enumerate() {
        let place = index as f64 * basic_data.angular_pitch() + ahead * half;
        let deviation = own_deviation(gear, ahead, place, reading + mean, e)?;
        let (sin, cos) = (place - ahead * alpha).sin_cos();
        left += Vector2::new(-sin, cos) * deviation;
        own.push(deviation);
    }
    Ok((own, left * alpha.cos() / f64::from(basic_data.teeth())))
}

/// Most steps of either iteration: any possible eccentricity needs a few.
const MOST_STEPS: usize = 50;

/// The own deviation of a flank at `place` whose datum-axis reading is `reading`, mm.
///
/// A flank turned by `F/r` and moved by `e` reads `F` plus an effect that depends on `F` only by `e/r`: the iteration converges.
fn own_deviation(
    gear: &Gear,
    ahead: f64,
    place: f64,
    reading: f64,
    e: Vector2<f64>,
) -> Result<f64, GearError> {
    let r = gear.basic_data().reference_radius();
    let mut own = reading;
    let mut change = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let next = own + reading - datum_reading(gear, ahead, place, own, e)?;
        change = (next - own).abs();
        own = next;
        if change <= 1e-14 * r {
            return Ok(own);
        }
    }
    // The residual below limits the precision of a reading.
    if change <= 1e-13 * r {
        return Ok(own);
    }
    Err(GearError::DatumPitch(
        "no deviation of a flank gives this reading about the datum axis",
    ))
}

/// Datum-axis reading, mm, of a flank with the own deviation `own` on an outline displaced by `e`.
///
/// The involute `r_b E (1 ± iξ)`, `E = e^{i(β ∓ ξ)}`, meets the reference circle about the axis where
/// `|P + e| = r`. Newton's method finds the roll, starting at the undisturbed crossing `ξ = tan α`.
fn datum_reading(
    gear: &Gear,
    ahead: f64,
    place: f64,
    own: f64,
    e: Vector2<f64>,
) -> Result<f64, GearError> {
    let basic_data = gear.basic_data();
    let (r, base) = (basic_data.reference_radius(), basic_data.base_radius());
    let alpha = basic_data.transverse_pressure_angle();
    let e = Complex::new(e.x, e.y);
    // Angles count from the undisturbed crossing, which keeps them small.
    let e = e * Complex::from_polar(1.0, -place);
    let origin = ahead * involute::inv(alpha) + own / r;
    let mut xi = alpha.tan();
    for _ in 0..MOST_STEPS {
        let turn = Complex::from_polar(1.0, origin - ahead * xi);
        let point = turn * Complex::new(base, ahead * base * xi) + e;
        // dP/dξ = r_b ξ E.
        let slope = (point.conj() * turn).re * base * xi / point.norm();
        let step = (point.norm() - r) / slope;
        if !step.is_finite() || xi - step <= 0.0 {
            break;
        }
        xi -= step;
        if step.abs() <= 1e-15 {
            return Ok(r * point.arg());
        }
    }
    // Newton's method may alternate in the last bit; the residual decides.
    let point =
        Complex::from_polar(1.0, origin - ahead * xi) * Complex::new(base, ahead * base * xi) + e;
    if (point.norm() - r).abs() <= 1e-13 * r {
        return Ok(r * point.arg());
    }
    Err(GearError::DatumPitch(
        "the eccentricity moves the measuring circle off the involute",
    ))
}

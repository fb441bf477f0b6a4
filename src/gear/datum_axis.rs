//! What a machine reads about the datum axis for one flank of a displaced outline, and the way back.

use super::{Gear, involute};
use crate::error::GearError;
use nalgebra::{Complex, Vector2};

/// Steps of either iteration before it is given up: a few for any eccentricity a gear can have.
const MOST_STEPS: usize = 50;

/// The own deviation of a flank at `place` whose datum-axis reading is `reading`, mm.
///
/// A flank turned by `F/r` and moved by `e` reads `F` plus an effect that hardly depends on `F`
/// (by `e/r`), so substituting converges.
pub(super) fn own_deviation(
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
        let next = own + reading - read(gear, ahead, place, own, e)?;
        change = (next - own).abs();
        own = next;
        if change <= 1e-14 * r {
            return Ok(own);
        }
    }
    // A reading is not known better than its residual below.
    if change <= 1e-13 * r {
        return Ok(own);
    }
    Err(GearError::DatumPitch(
        "no deviation of a flank gives this reading about the datum axis",
    ))
}

/// What a machine reads, mm, for a flank with the own deviation `own` when the outline is displaced by `e`.
///
/// The involute `r_b E (1 ± iξ)`, `E = e^{i(β ∓ ξ)}`, meets the reference circle about the axis where
/// `|P + e| = r`. Newton's method in the roll, from the undisturbed crossing `ξ = tan α`.
pub(super) fn read(
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
    // Everything is seen from the undisturbed crossing, so that the angle read is a small one.
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
    // Newton may flutter in the last bit; the residual decides.
    let point =
        Complex::from_polar(1.0, origin - ahead * xi) * Complex::new(base, ahead * base * xi) + e;
    if (point.norm() - r).abs() <= 1e-13 * r {
        return Ok(r * point.arg());
    }
    Err(GearError::DatumPitch(
        "the eccentricity moves the measuring circle off the involute",
    ))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::gear::{BasicGearData, BasicRack, GearDesign};

    pub(in crate::gear) fn gear(teeth: u32) -> Gear {
        let basic_data = BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap();
        Gear::nominal(GearDesign {
            basic_data,
            profile_shift: 0.0,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        })
        .unwrap()
    }

    /// design.md section 6: F_R = −e sin(ψ − α)/cos α, F_L = −e sin(ψ + α)/cos α to first order.
    #[test]
    fn reads_the_first_order_sine() {
        let gear = gear(44);
        let alpha = gear.basic_data().transverse_pressure_angle();
        let e = 1e-4;
        for (ahead, place) in [(1.0, 0.7), (-1.0, 0.7), (1.0, 3.0), (-1.0, -2.0)] {
            let exact = read(&gear, ahead, place, 0.0, Vector2::new(e, 0.0)).unwrap();
            let first = -e * (place - ahead * alpha).sin() / alpha.cos();
            assert!((exact - first).abs() < 10.0 * e * e / gear.basic_data().reference_radius());
        }
    }
}

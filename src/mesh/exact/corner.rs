//! A corner of one half tooth on the curves of the other, of a certified pair.
//!
//! The corner keeps its radius about the free axis. On the mate's half tooth that
//! radius is met once on the flank, found by one monotone inversion, and, beyond
//! the mate's tip, on its land.

use super::branch::{Placed, invert};
use super::shape::C;
use crate::gear::{Curve, involute};
use std::f64::consts::TAU;

/// Curve, parameter and point where `half` has the radius `rho` about the free axis.
///
/// `fillet` is the least `γ` that can be reached, `None` where the fillet cannot be; `near` is a point
/// of the half tooth's own frame near the one sought. `Ok(None)`: the half tooth has no such point.
/// `Err`: the radius lies beyond what the certificate allows for.
pub(super) fn meet(
    half: &Placed,
    fillet: Option<f64>,
    rho: f64,
    near: C,
) -> Result<Option<(Curve, f64, C)>, Beyond> {
    let shape = half.shape;
    let tip = half.at(Curve::Involute, shape.tip_roll).point.norm();
    let form = half.at(Curve::Involute, shape.form_roll).point.norm();
    // ρ rises from tip to root on the locked gear, falls on the free one.
    let inward = (form - tip).signum();
    let (curve, t) = if (rho - tip) * inward < 0.0 {
        let Some(t) = on_land(half, rho) else {
            return Ok(None);
        };
        (Curve::Tip, t)
    } else if (rho - form) * inward <= 0.0 {
        let radius = near.norm_sqr().sqrt();
        let start = involute::roll_at(radius, shape.base).clamp(shape.form_roll, shape.tip_roll);
        let bracket = bracket(shape.form_roll, shape.tip_roll, inward);
        (
            Curve::Involute,
            invert(half, Curve::Involute, rho, bracket, start),
        )
    } else {
        let least = fillet.ok_or(Beyond)?;
        let deepest = half.at(Curve::Fillet, least).point.norm();
        if (rho - deepest) * inward > 0.0 {
            return Err(Beyond);
        }
        let bracket = bracket(least, shape.fillet_end, inward);
        let start = 0.5 * (least + shape.fillet_end);
        (
            Curve::Fillet,
            invert(half, Curve::Fillet, rho, bracket, start),
        )
    };
    Ok(Some((curve, t, half.at(curve, t).point)))
}

/// A corner below the fillet's certified part.
#[derive(Debug)]
pub(super) struct Beyond;

/// Ends of a parameter range, that of lesser `ρ` first, where `ρ` falls with the parameter if `inward` is positive.
fn bracket(low: f64, high: f64, inward: f64) -> [f64; 2] {
    if inward > 0.0 {
        [high, low]
    } else {
        [low, high]
    }
}

/// Parameter at which the tip land has the radius `rho`; of two, the one nearer to the corner,
/// behind which the other lies.
///
/// On the circle `|C + r_a e^{iβ}| = ρ`: `cos(β − arg C) = (ρ² − |C|² − r_a²)/(2 |C| r_a)`.
fn on_land(half: &Placed, rho: f64) -> Option<f64> {
    let shape = half.shape;
    let (centre, radius) = (half.centre, shape.tip_radius);
    let distance = centre.norm();
    let cos = (rho * rho - distance * distance - radius * radius) / (2.0 * distance * radius);
    if !(cos.abs() <= 1.0) {
        return None;
    }
    let (_, corner) = shape.range(Curve::Tip);
    // From the tooth's centre line, clockwise positive.
    let middle = (half.direction * centre.conj()).arg();
    [cos.acos(), -cos.acos()]
        .map(|beta| {
            let t = middle - beta;
            t - TAU * (t / TAU).round()
        })
        .into_iter()
        .filter(|t| (0.0..=corner).contains(t))
        .reduce(f64::max)
}

/// The point of a half tooth's own frame that stands at `point`.
pub(super) fn own_frame(half: &Placed, point: C) -> C {
    (point - half.centre) * half.direction.conj()
}

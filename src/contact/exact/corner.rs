//! A corner of one half tooth on the curves of the other, for pairs without search.
//!
//! The corner keeps its radius about the free axis. The mate's half tooth has that radius once on its flank, which one
//! monotone inversion finds, and past the mate's tip on its land.
//!
//! On the flank of a locked tooth `ρ` rises from tip to root wherever the free gear reaches
//! ([`super::search_free_proof`]). So the free gear reaches a flank from the tip down, if at all. A flank that leaves
//! its reach does not return, and if the tip corner is out of reach, the whole flank is. There `ρ` is unknown (the
//! flank of a tooth that points sideways turns back) and does not matter.

use super::placed::{PlacedHalf, Role};
use super::shape::{C, turn};
use crate::gear::{ProfilePart, involute};
use std::f64::consts::TAU;

/// Profile part and parameter where `half` has the radius `rho` about the free axis. `None` if there is no such point,
/// or if the search covers it.
///
/// `fillet` is the least `γ` that can be reached. `near` is a nearby point in the half tooth's own frame.
pub(super) fn meet(
    half: &PlacedHalf,
    side: Role,
    fillet: Option<f64>,
    rho: f64,
    near: C,
) -> Option<(ProfilePart, f64)> {
    let shape = half.shape;
    let (tip_roll, tip) = outer_end(half);
    let form = half.own_to_axis(shape.joint);
    let inward = match side {
        Role::Locked => 1.0,
        Role::Free => -1.0,
    };
    Some(if (rho - tip) * inward < 0.0 {
        (ProfilePart::Tip, on_land(half, ProfilePart::Tip, rho)?)
    } else if (rho - form) * inward <= 0.0 {
        let radius = near.norm_sqr().sqrt();
        let start = involute::roll_at(radius, shape.base).clamp(shape.form_roll, tip_roll);
        let bracket = bracket(shape.form_roll, tip_roll, inward);
        (
            ProfilePart::Involute,
            half.curve(ProfilePart::Involute)
                .invert(rho, bracket, start),
        )
    } else {
        let least = fillet?;
        let bracket = bracket(least, shape.fillet_end, inward);
        let start = 0.5 * (least + shape.fillet_end);
        (
            ProfilePart::Fillet,
            half.curve(ProfilePart::Fillet).invert(rho, bracket, start),
        )
    })
}

/// The roll below which the involute is monotone in `ρ`, and `ρ` there: at its tip, unless it turns back.
///
/// The normal `−iE` meets the axis where `E` is `acos(r_b/D)` from the direction to it.
fn outer_end(half: &PlacedHalf) -> (f64, f64) {
    let shape = half.shape;
    let tip = (shape.tip_roll, half.own_to_axis(shape.corners()[0].1));
    let distance = half.centre.norm_sqr().sqrt();
    if distance <= shape.base || tip_arm(half) > 0.0 {
        return tip;
    }
    let e = half.direction * turn(shape.tip_roll - shape.half_base);
    let beyond = (-e * half.centre.conj()).arg() - (shape.base / distance).acos();
    if !(beyond > 0.0) {
        return tip;
    }
    let roll = (shape.tip_roll - beyond).max(shape.form_roll);
    let point = half.at(ProfilePart::Involute, roll).point;
    (roll, point.norm_sqr().sqrt())
}

/// `X = Q × n` of the involute at the tip corner, with `Q` from the free axis. It is at most 0 where a locked involute turns back.
pub(super) fn tip_arm(half: &PlacedHalf) -> f64 {
    let shape = half.shape;
    let corner = half.centre * half.direction.conj() + shape.corners()[0].1;
    corner.re * shape.tip_normal.im - corner.im * shape.tip_normal.re
}

/// Least `ρ` where a locked involute turns back. There the normal passes through the free axis, `√(D² − r_b²)` along it
/// from the base circle, and the involute's point is at most `r_b ξ_a` along it.
pub(super) fn nearest_turn(locked: &PlacedHalf) -> f64 {
    let shape = locked.shape;
    (locked.centre.norm_sqr() - shape.base * shape.base).sqrt() - shape.base * shape.tip_roll
}

/// Least radius about the free axis of a locked involute where `ρ` is monotone: at its tip, or where it turns back.
pub(super) fn least_flank_radius(locked: &PlacedHalf) -> f64 {
    outer_end(locked).1
}

/// Ends of a parameter range, the end of lesser `ρ` first. `ρ` falls with the parameter if `inward` is positive.
fn bracket(low: f64, high: f64, inward: f64) -> [f64; 2] {
    if inward > 0.0 {
        [high, low]
    } else {
        [low, high]
    }
}

/// Parameter at which a land has the radius `rho`. If there are two, it is the one nearer to the land's clockwise end,
/// which hides the other.
///
/// On the circle of radius `r` about `C` a point `δ` from the direction to the axis has `ρ² = (|C| − r)² + 4 |C| r sin²
/// δ/2 = (|C| + r)² − 4 |C| r cos² δ/2`, without a difference of large squares.
pub(super) fn on_land(half: &PlacedHalf, land: ProfilePart, rho: f64) -> Option<f64> {
    let (centre, radius) = (half.centre, half.shape.radius(land, 0.0));
    let distance = centre.norm_sqr().sqrt();
    let (least, most) = ((distance - radius).abs(), distance + radius);
    let squares = ((rho - least) * (rho + least), (most - rho) * (most + rho));
    if !(squares.0 >= 0.0 && squares.1 >= 0.0) {
        return None;
    }
    let beside = 2.0 * squares.0.sqrt().atan2(squares.1.sqrt());
    let (far, corner) = half.range(land);
    // From the tooth's centre line, clockwise positive.
    let middle = (-half.direction * centre.conj()).arg();
    [beside, -beside]
        .map(|beside| {
            let t = middle - beside;
            t - TAU * (t / TAU).round()
        })
        .into_iter()
        .filter(|t| (far..=corner).contains(t))
        .reduce(f64::max)
}

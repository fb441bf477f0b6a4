//! The place along the face where an edge touches its mate's fillet tightest in a helical pair.
//!
//! Along the axis the teeth roll on circles about both centres of a section. The common point `P` of the circles, the pitch point, is
//! fixed. The gap between an edge and a smooth curve is stationary where the normal of the curve passes through `P`. On a fillet the normal
//! at `γ` passes through a point of the generating pitch circle, `r sin γ` from the gear's centre. Through `P`, at `r_w` from the centre,
//! it is at `ω = asin(r sin γ/r_w)` from the line of centres. The fillet's point is `r cos γ − L − r_w cos ω` from `P` along it. The edge
//! must be at its radius about its own centre there. That is one equation for `γ`, common to all teeth.

use super::shape::{C, HalfToothShape};
use crate::numeric::bisect_smooth;

/// Stretches of a fillet in which a change of sign is searched. The equation has at most one root, except for overhanging fillets.
const STRETCHES: u32 = 24;

/// Part of a stretch to which a root is bisected, down to the last bit.
const BISECTED: f64 = f64::EPSILON;

/// A touch, with the fillet's centre at 0 and the edge's centre on +x.
#[derive(Debug, Clone, Copy)]
pub(super) struct DeepestTouch {
    /// Direction of the fillet's tooth, rad.
    pub tooth: f64,
    pub point: C,
    /// `ω`: angle of the normal from the line of centres, rad.
    pub lean: f64,
}

/// The touch of an edge `reach` from its own centre with the fillet of `shape`, `distance` away. `mate_base` is the
/// base radius of the edge's gear.
pub(super) fn deepest(
    shape: &HalfToothShape,
    distance: f64,
    mate_base: f64,
    reach: f64,
) -> impl Iterator<Item = DeepestTouch> {
    let pitch_point = distance * shape.base / (shape.base + mate_base);
    let fillet = shape.fillet;
    let r = shape.pitch_radius;
    let at = move |gamma: f64| -> Option<(f64, C)> {
        let (sin, cos) = gamma.sin_cos();
        let lean = (r * sin / pitch_point).asin();
        let along = r * cos - fillet.reach(gamma) - pitch_point * lean.cos();
        (!lean.is_nan()).then(|| (lean, C::from(pitch_point) + C::from_polar(along, -lean)))
    };
    let excess = move |gamma: f64| {
        at(gamma).map_or(f64::NAN, |(_, point)| (point - distance).norm() - reach)
    };
    let end = shape.fillet_end;
    let gamma = move |k: u32| end * f64::from(k) / f64::from(STRETCHES);
    let mut low = (gamma(0), excess(gamma(0)));
    (1..=STRETCHES).filter_map(move |k| {
        let high = (gamma(k), excess(gamma(k)));
        let ends = [std::mem::replace(&mut low, high), high];
        // A normal that misses the pitch circle has no excess.
        let [first, last] = ends.map(|(_, value)| value);
        let is_bracket = (first < 0.0) != (last < 0.0) && !first.is_nan() && !last.is_nan();
        let [from, to] = ends.map(|(gamma, _)| gamma);
        let width = (to - from) * BISECTED;
        let bracket = is_bracket
            .then(|| bisect_smooth(from, to, width, |gamma| first.signum() * -excess(gamma)))?;
        let gamma = 0.5 * (bracket[0] + bracket[1]);
        let (lean, point) = at(gamma)?;
        Some(DeepestTouch {
            tooth: gamma - lean - fillet.pitch_angle(gamma),
            point,
            lean,
        })
    })
}

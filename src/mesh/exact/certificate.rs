//! When a pair of gears needs no search.
//!
//! The polar gap of two half teeth is continuous along their common radii; its
//! slope over `ln ρ` is `σ_locked − σ_free`, and where it vanishes its second
//! derivative has the sign of `−(κ_1 + κ_2)` (κ + for convex): the curves touch
//! there with opposite normals. So its greatest value stands
//!
//! - on the line of action, where both are involutes (κ_1 + κ_2 > 0, one stationary point at most), or
//! - at a corner: the tip corner of either gear, or the joint of an undercut fillet, an edge too,
//!
//! provided that within reach of each other
//!
//! 1. no root land takes part, and both flanks are monotone in `ρ` (the normal never meets the axis);
//! 2. a fillet is hollower than the involute opposite is convex, and no fillet is convex: then the
//!    gap has minima only there. (At a smooth joint slopes agree: a gap that rises towards it rises on.)
//! 3. a tip land runs so nearly round the axis, compared with the flank opposite, that the gap
//!    rises along it towards its corner.
//!
//! These are checked once for all poses, with the locked outline's centre anywhere within its
//! eccentricity `e_L` of its axis. A pair that fails one is left to branch and bound.

use super::facing::lens_half;
use super::shape::Shape;
use crate::gear::{Curve, involute};

/// What the corner search needs to know of a certified pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Certificate {
    /// Least `γ` of the locked and of the free fillet that can be reached; `None`: none of the fillet.
    pub locked_fillet: Option<f64>,
    pub free_fillet: Option<f64>,
}

/// The two gears' half teeth, eccentricities, and the centre distance.
pub(super) struct Setting<'a> {
    pub locked: &'a Shape,
    pub free: &'a Shape,
    pub locked_off: f64,
    pub free_off: f64,
    pub distance: f64,
}

impl Setting<'_> {
    /// The certificate, where all conditions hold.
    pub fn certify(&self) -> Option<Certificate> {
        let (ours, theirs) = (self.locked, self.free);
        // The locked outline's centre at its nearest: the widest lens, the least slopes.
        let near = self.distance - self.locked_off;
        let inmost = near - ours.tip_radius;
        let outmost = theirs.tip_radius + self.free_off;
        if !(inmost > self.free_off && near > outmost && theirs.base > self.free_off) {
            return None;
        }
        let free_fillet = reached(theirs, inmost - self.free_off)?;
        let locked_fillet = reached(ours, near - outmost)?;
        let half = lens_half(ours.tip_radius, outmost, near)?;

        // 1. Free flank: X = Q × n is r_b + C·E on the involute, C × n − r sin γ on the fillet, |C| = e_F.
        if free_fillet.is_some_and(|gamma| !(theirs.pitch_radius * gamma.sin() > self.free_off)) {
            return None;
        }
        // Locked involute: E stands at (polar angle) + atan ξ from the line of centres, X = D cos − r_b.
        let steepest = half + ours.tip_roll.atan();
        let mut least_arm = near * steepest.cos() - ours.base;
        if let Some(gamma) = locked_fillet {
            least_arm = least_arm.min(self.fillet_arm(gamma, half, near));
        }
        if !(least_arm > 1e-9 * near) {
            return None;
        }

        // 2. An involute opposite a fillet is no nearer to its base circle than this roll.
        let hollow = |fillet: &Shape, gamma: Option<f64>, involute: &Shape, radius: f64| {
            gamma.is_none()
                || greatest_fillet_radius(fillet).is_some_and(|greatest| {
                    involute.base * involute::roll_at(radius, involute.base)
                        > greatest * (1.0 + 1e-9)
                })
        };
        let (form, mate_form) = (ours.form_radius(), theirs.form_radius());
        if !hollow(theirs, free_fillet, ours, near - mate_form - self.free_off)
            || !hollow(ours, locked_fillet, theirs, near - form - self.free_off)
        {
            return None;
        }

        // 3. Locked tip land at the angle b from the line of centres: σ = (D cos b − r_a)/(D sin b), falling in b.
        let land = |b: f64| (near * b.cos() - ours.tip_radius) / (near * b.sin());
        // Seen from an axis e off, ψ shifts by asin(e/ρ) at most.
        let shift = (self.free_off / inmost).asin();
        if !((theirs.tip_roll.atan() + shift).tan() < land(half)) {
            return None;
        }
        if let Some(gamma) = free_fillet {
            let sample = theirs.at(Curve::Fillet, gamma);
            let psi = (sample.normal.re * sample.point.re + sample.normal.im * sample.point.im)
                .atan2(
                    (sample.normal.im * sample.point.re - sample.normal.re * sample.point.im).abs(),
                );
            let half = lens_half(ours.tip_radius, mate_form + self.free_off, near);
            if half.is_some_and(|half| !((psi + shift).tan() < land(half))) {
                return None;
            }
        }
        // Free tip land: |σ| ≥ (r_a − e)/e. Locked |σ| ≤ ρ/X on the flank, ρ/(D sin b) on the land,
        // b the angle at which it crosses the free tip circle at its nearest.
        if self.free_off > 0.0 {
            let far = self.distance + self.locked_off;
            let tip = theirs.tip_radius - self.free_off;
            let cos = (ours.tip_radius * ours.tip_radius + far * far - tip * tip)
                / (2.0 * far * ours.tip_radius);
            if !(cos < 1.0) {
                return None;
            }
            let arm = least_arm.min(near * cos.max(0.0).acos().sin());
            if !(outmost / arm < tip / self.free_off) {
                return None;
            }
        }
        Some(Certificate {
            locked_fillet,
            free_fillet,
        })
    }

    /// Least `X = D sin(γ − η) − r sin γ` of the locked fillet from `gamma` up, `η` the angle of its
    /// pitch point `E` from the line of centres.
    ///
    /// `E` stands within `asin(L/r)` of the point. At fixed `η` X is a sine of `γ`, at fixed `γ` one of
    /// `η`: where it is positive it is concave, so its least value stands at a corner of the box.
    fn fillet_arm(&self, gamma: f64, half: f64, near: f64) -> f64 {
        let shape = self.locked;
        let reach = shape.depth.abs() / shape.fillet_end.cos() + shape.round;
        let eta = half + (reach / shape.pitch_radius).min(1.0).asin();
        let mut least = f64::INFINITY;
        for gamma in [gamma, shape.fillet_end] {
            for eta in [-eta, eta] {
                if !(gamma - eta > 0.0 && gamma - eta < std::f64::consts::PI) {
                    return f64::NEG_INFINITY;
                }
                least = least.min(near * (gamma - eta).sin() - shape.pitch_radius * gamma.sin());
            }
        }
        least
    }
}

/// `γ` of the fillet at `radius`; `Some(None)` when `radius` lies above the fillet, `None` when at or below its root.
fn reached(shape: &Shape, radius: f64) -> Option<Option<f64>> {
    if radius >= shape.form_radius() {
        return Some(None);
    }
    if !(radius > shape.root_radius) {
        return None;
    }
    // |P| rises with γ; the lower end of the last bracket is on the safe side.
    let (mut low, mut high) = (0.0, shape.fillet_end);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if shape.at(Curve::Fillet, middle).point.norm() < radius {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(Some(low))
}

/// Greatest radius of curvature of the fillet, `ρ + h_0² c³/(r + h_0 c²)`, `c = 1/cos γ`; `None` where it is not hollow.
///
/// From `S/q` ([`crate::gear::Fillet`]). Rises with `c` while `r + h_0 c² > 0`, which is also when it is hollow.
fn greatest_fillet_radius(shape: &Shape) -> Option<f64> {
    let c = 1.0 / shape.fillet_end.cos();
    let hollow = shape.pitch_radius + shape.depth * c * c;
    (hollow > 1e-9 * shape.pitch_radius)
        .then(|| shape.round + shape.depth * shape.depth * c * c * c / hollow)
}

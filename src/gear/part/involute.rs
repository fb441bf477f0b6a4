//! The involute flank: `P = r_b E (1 − iξ)`, `n = −iE`, `E = e^{i(ξ − ψ_b)}`.

use nalgebra::{Point2, Vector2};

/// An involute of the base circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvoluteFlank {
    /// `r_b`, mm.
    base: f64,
    /// `ψ_b`, rad.
    half_base: f64,
}

impl InvoluteFlank {
    /// The involute that leaves the circle of radius `base` (mm) at the angle `half_base` (rad) from the tooth's centre line.
    pub fn new(base: f64, half_base: f64) -> InvoluteFlank {
        InvoluteFlank { base, half_base }
    }

    #[inline]
    pub(super) fn at(&self, xi: f64) -> (Point2<f64>, Vector2<f64>) {
        let (sin, cos) = (xi - self.half_base).sin_cos();
        let base = self.base;
        (
            Point2::new(base * (cos + xi * sin), base * (sin - xi * cos)),
            Vector2::new(sin, -cos),
        )
    }

    #[inline]
    pub(super) fn point(&self, xi: f64) -> Point2<f64> {
        self.at(xi).0
    }

    #[inline]
    pub(super) fn normal(&self, xi: f64) -> Vector2<f64> {
        self.at(xi).1
    }

    pub(super) fn radius(&self, xi: f64) -> f64 {
        self.base * (1.0 + xi * xi).sqrt()
    }

    /// `dP/dξ = r_b ξ E = r_b ξ · i n`.
    #[inline]
    pub(super) fn speed(&self, xi: f64) -> f64 {
        self.base * xi
    }

    /// The longer half has the length `r_b Δ(ξ²)/2`; the normal turns by `Δξ`.
    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        let half = 0.5 * (high - low);
        (0.5 * self.base * half * (high + 0.5 * (low + high)), half)
    }

    /// `P'' = r_b (E + iξE)`; `E` turns by `Δ` at most, so across the chord `r_b (ξ + Δ)`.
    pub(super) fn bend(&self, xi: f64) -> (f64, f64) {
        (self.base * xi, self.base)
    }

    /// The normal turns by `dξ` over `r_b ξ dξ`.
    pub(super) fn convexity(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        let at = |xi: f64| 1.0 / (self.base * xi);
        (low > 0.0).then(|| (at(high), at(low)))
    }

    /// `1/(r_b ξ)` at the lesser `ξ`.
    pub(super) fn curvature(&self, from: f64, to: f64) -> Option<f64> {
        Some(1.0 / (self.base * from.min(to)))
    }
}

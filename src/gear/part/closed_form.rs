//! Curves of a half tooth in closed form: arc about the gear's centre, circle about any point, straight line, involute.

use nalgebra::{Point2, Vector2};

/// An arc of a circle about the gear's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    radius: f64,
}

impl Arc {
    /// An arc of this radius, mm.
    pub fn new(radius: f64) -> Arc {
        Arc { radius }
    }

    #[inline]
    pub(super) fn at(&self, t: f64) -> (Point2<f64>, Vector2<f64>) {
        (self.point(t), self.normal(t))
    }

    #[inline]
    pub(super) fn point(&self, t: f64) -> Point2<f64> {
        (self.normal(t) * self.radius).into()
    }

    #[inline]
    pub(super) fn normal(&self, t: f64) -> Vector2<f64> {
        let (sin, cos) = (-t).sin_cos();
        Vector2::new(cos, sin)
    }

    pub(super) fn radius(&self, _: f64) -> f64 {
        self.radius
    }

    /// The parameter runs clockwise.
    pub(super) fn speed(&self, _: f64) -> f64 {
        -self.radius
    }

    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        let half = 0.5 * (high - low);
        (self.radius * half, half)
    }

    /// `P''` has the length of the radius.
    pub(super) fn bend(&self, _: f64) -> (f64, f64) {
        (self.radius, 0.0)
    }

    pub(super) fn convexity(&self, _: f64, _: f64) -> Option<(f64, f64)> {
        Some((1.0 / self.radius, 1.0 / self.radius))
    }

    pub(super) fn curvature(&self, _: f64, _: f64) -> Option<f64> {
        Some(1.0 / self.radius)
    }
}

/// An arc of a circle. Parameter: the angle at its centre, rad, counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    centre: Point2<f64>,
    radius: f64,
    /// 1 with the metal inside, −1 with it outside.
    out: f64,
}

impl Circle {
    /// Bounds of the distance of its points from the gear's centre, mm.
    pub(crate) fn radii(&self) -> [f64; 2] {
        let off = self.centre.coords.norm();
        [(off - self.radius).abs(), off + self.radius]
    }

    /// An arc of `radius` (mm) about `centre`. The metal is inside if `convex`.
    pub fn new(centre: Point2<f64>, radius: f64, convex: bool) -> Circle {
        Circle {
            centre,
            radius,
            out: if convex { 1.0 } else { -1.0 },
        }
    }

    /// The centre, mm.
    pub(super) fn centre(&self) -> Point2<f64> {
        self.centre
    }

    // Out of line: the kernel's own curves are not these.
    #[inline(never)]
    pub(super) fn at(&self, t: f64) -> (Point2<f64>, Vector2<f64>) {
        let (sin, cos) = t.sin_cos();
        let radial = Vector2::new(cos, sin);
        (self.centre + radial * self.radius, radial * self.out)
    }

    pub(super) fn point(&self, t: f64) -> Point2<f64> {
        self.at(t).0
    }

    pub(super) fn normal(&self, t: f64) -> Vector2<f64> {
        self.at(t).1
    }

    pub(super) fn radius(&self, t: f64) -> f64 {
        self.point(t).coords.norm()
    }

    /// `dP/dt = r · i e^{it}`, and the normal is `± e^{it}`.
    pub(super) fn speed(&self, _: f64) -> f64 {
        self.out * self.radius
    }

    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        let half = 0.5 * (high - low);
        (self.radius * half, half)
    }

    /// `P''` has the length of the radius.
    pub(super) fn bend(&self, _: f64) -> (f64, f64) {
        (self.radius, 0.0)
    }

    pub(super) fn convexity(&self, _: f64, _: f64) -> Option<(f64, f64)> {
        Some((self.out / self.radius, self.out / self.radius))
    }

    pub(super) fn curvature(&self, _: f64, _: f64) -> Option<f64> {
        Some(1.0 / self.radius)
    }
}

/// A straight line outwards along a tooth, the metal on its left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    start: Point2<f64>,
    along: Vector2<f64>,
}

impl Line {
    /// From a point at the root towards one at the tip, mm apart.
    pub fn new(root: Point2<f64>, tip: Point2<f64>) -> Line {
        Line {
            start: root,
            along: (tip - root).normalize(),
        }
    }

    #[inline]
    pub(super) fn at(&self, t: f64) -> (Point2<f64>, Vector2<f64>) {
        (self.point(t), self.normal(t))
    }

    #[inline]
    pub(super) fn point(&self, t: f64) -> Point2<f64> {
        self.start + self.along * t
    }

    #[inline]
    pub(super) fn normal(&self, _: f64) -> Vector2<f64> {
        Vector2::new(self.along.y, -self.along.x)
    }

    pub(super) fn radius(&self, t: f64) -> f64 {
        self.point(t).coords.norm()
    }

    /// `i n` is the direction of the line.
    pub(super) fn speed(&self, _: f64) -> f64 {
        1.0
    }

    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        (0.5 * (high - low), 0.0)
    }

    pub(super) fn bend(&self, _: f64) -> (f64, f64) {
        (0.0, 0.0)
    }

    pub(super) fn convexity(&self, _: f64, _: f64) -> Option<(f64, f64)> {
        Some((0.0, 0.0))
    }

    pub(super) fn curvature(&self, _: f64, _: f64) -> Option<f64> {
        Some(0.0)
    }
}

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

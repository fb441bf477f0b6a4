//! An arc of a circle about any point, its metal inside or outside.

use nalgebra::{Point2, Vector2};

/// An arc of a circle. Parameter: the angle at its centre, rad, counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    centre: Point2<f64>,
    radius: f64,
    /// 1 with the metal inside, −1 with it outside.
    out: f64,
}

impl Circle {
    /// On the circle of `radius` (mm) about `centre`; `convex`: the metal is inside.
    pub fn new(centre: Point2<f64>, radius: f64, convex: bool) -> Circle {
        Circle {
            centre,
            radius,
            out: if convex { 1.0 } else { -1.0 },
        }
    }

    /// Its centre, mm.
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

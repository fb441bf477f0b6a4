//! An arc about the gear's centre: tip land and root land.

use nalgebra::{Point2, Vector2};

/// An arc of a circle about the gear's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    radius: f64,
}

impl Arc {
    /// On the circle of this radius, mm.
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

//! A straight flank.

use nalgebra::{Point2, Vector2};

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

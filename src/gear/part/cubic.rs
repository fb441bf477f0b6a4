//! A cubic Bézier curve, the metal on its left.
//!
//! Bounds come from control points. A piece of the curve lies in the hull of its control points (de Casteljau subdivision). Its
//! tangent lies in the cone of their differences.

use nalgebra::{Point2, Vector2};
use std::f64::consts::PI;

/// A cubic Bézier curve. Parameter: 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cubic {
    points: [Point2<f64>; 4],
}

impl Cubic {
    /// The curve of these control points, mm, which must not all coincide.
    pub fn new(points: [Point2<f64>; 4]) -> Cubic {
        Cubic { points }
    }

    pub(super) fn points(&self) -> &[Point2<f64>; 4] {
        &self.points
    }

    // Out of line: the kernel's own curves are not these.
    #[inline(never)]
    pub(super) fn at(&self, t: f64) -> (Point2<f64>, Vector2<f64>) {
        (self.point(t), self.normal(t))
    }

    pub(super) fn point(&self, t: f64) -> Point2<f64> {
        let [a, b, c, d] = self.points;
        let s = 1.0 - t;
        let along =
            (b - a) * (3.0 * s * s * t) + (c - a) * (3.0 * s * t * t) + (d - a) * (t * t * t);
        a + along
    }

    /// `dP/dt`.
    fn rise(&self, t: f64) -> Vector2<f64> {
        let [a, b, c, d] = self.points;
        let s = 1.0 - t;
        ((b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t)) * 3.0
    }

    /// The unit normal. If control points coincide at an end, the tangent points to the next different one.
    pub(super) fn normal(&self, t: f64) -> Vector2<f64> {
        let [a, b, c, d] = self.points;
        let rise = self.rise(t);
        let size = (b - a).norm() + (c - b).norm() + (d - c).norm();
        let along = if rise.norm() > f64::EPSILON * size {
            rise
        } else if t < 0.5 {
            if c != a { c - a } else { d - a }
        } else if d != b {
            d - b
        } else {
            d - a
        };
        let along = along.normalize();
        Vector2::new(along.y, -along.x)
    }

    pub(super) fn radius(&self, t: f64) -> f64 {
        self.point(t).coords.norm()
    }

    pub(super) fn speed(&self, t: f64) -> f64 {
        self.rise(t).norm()
    }

    /// The control points of the piece between two parameters (blossom).
    fn piece(&self, low: f64, high: f64) -> [Point2<f64>; 4] {
        let blossom = |u: f64, v: f64, w: f64| {
            let mix = |a: Point2<f64>, b: Point2<f64>, t: f64| a + (b - a) * t;
            let [a, b, c, d] = self.points;
            let (e, f, g) = (mix(a, b, u), mix(b, c, u), mix(c, d, u));
            mix(mix(e, f, v), mix(f, g, v), w)
        };
        [
            blossom(low, low, low),
            blossom(low, low, high),
            blossom(low, high, high),
            blossom(high, high, high),
        ]
    }

    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        let (middle, normal) = self.at(0.5 * (low + high));
        let piece = self.piece(low, high);
        let reach = piece.iter().map(|point| (point - middle).norm());
        let reach = reach.fold(0.0, f64::max);
        let along = Vector2::new(-normal.y, normal.x);
        let steps = piece.windows(2).map(|pair| pair[1] - pair[0]);
        // A step of the size of rounding has no direction.
        let steps = steps.filter(|step| step.norm() > 4.0 * f64::EPSILON * middle.coords.norm());
        let turn = steps.map(|step| along.perp(&step).atan2(along.dot(&step)).abs());
        let turn = turn.fold(0.0, f64::max);
        // A cone wider than half a plane is no bound.
        (reach, if turn < 0.5 * PI { turn } else { PI })
    }

    /// `P''` is linear in the parameter: its greatest length is at an end.
    pub(super) fn bend(&self, _: f64) -> (f64, f64) {
        let [a, b, c, d] = self.points;
        let ends = [(c - b) - (b - a), (d - c) - (c - b)];
        (6.0 * ends[0].norm().max(ends[1].norm()), 0.0)
    }

    /// Bounds of `P' × P'' / |P'|³`.
    ///
    /// With the steps `e` between the control points of the piece and `u + t = 1`, both are quadratic up to factors: `P'` is
    /// `e_0 u² + 2 e_1 ut + e_2 t²` and the cross product is `(e_0 × e_1) u² + (e_0 × e_2) ut + (e_1 × e_2) t²`. The first lies in
    /// the hull of `e`, the second between its coefficients.
    pub(super) fn convexity(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        let [a, b, c, d] = self.piece(low, high);
        let steps = [b - a, c - b, d - c];
        let along = (steps[0] + steps[2]).try_normalize(0.0)?;
        let least = steps.iter().map(|step| along.dot(step));
        let least = least.fold(f64::INFINITY, f64::min);
        let most = steps.iter().map(|step| step.norm()).fold(0.0, f64::max);
        // Control points are rounded by some units in the last place; that times the steps rounds a turn.
        let rounded = 16.0 * f64::EPSILON * a.coords.norm();
        if !(least > 1e6 * rounded) {
            return None;
        }
        let turns = [
            steps[0].perp(&steps[1]),
            0.5 * steps[0].perp(&steps[2]),
            steps[1].perp(&steps[2]),
        ];
        let bound = |turn: f64, short: bool| {
            let speed = if short { least } else { most };
            2.0 / 3.0 * turn / (speed * speed * speed)
        };
        let room = 2.0 * rounded * most;
        let least_turn = turns.into_iter().fold(f64::INFINITY, f64::min) - room;
        let most_turn = turns.into_iter().fold(f64::NEG_INFINITY, f64::max) + room;
        Some((
            bound(least_turn, least_turn < 0.0),
            bound(most_turn, most_turn > 0.0),
        ))
    }

    pub(super) fn curvature(&self, _: f64, _: f64) -> Option<f64> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A curve with zero speed, or with steps as short as rounding, has no bounds.
    #[test]
    fn a_cusp_has_no_curvature() {
        let cubic = |points: [[f64; 2]; 4]| Cubic::new(points.map(Point2::from));
        let cusp = cubic([[40.0, 0.0], [40.0, 0.0], [41.0, 0.5], [42.0, 2.0]]);
        let flank = cubic([[50.0, 3.0], [51.0, 2.6], [52.2, 2.3], [53.0, 1.6]]);
        for (curve, [low, high], is_known) in [
            (&cusp, [0.0, 0.5], false),
            (&cusp, [0.1, 0.5], true),
            (&flank, [0.5, 0.5 + 1e-10], false),
            (&flank, [0.5, 0.5 + 1e-6], true),
        ] {
            assert_eq!(curve.convexity(low, high).is_some(), is_known, "{low}");
        }
    }
}

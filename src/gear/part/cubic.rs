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

    /// A flank, a root, a curve that turns by more than half a turn, and an S.
    fn curves() -> [Cubic; 4] {
        [
            [[50.0, 3.0], [51.0, 2.6], [52.2, 2.3], [53.0, 1.6]],
            [[46.0, 4.0], [45.1, 4.1], [44.8, 4.9], [44.9, 5.6]],
            [[40.0, 0.0], [47.0, 3.0], [35.0, 3.5], [41.0, -1.0]],
            [[40.0, 0.0], [41.0, 1.5], [42.0, -1.2], [43.0, 0.4]],
        ]
        .map(|points| Cubic::new(points.map(|[x, y]| Point2::new(x, y))))
    }

    const STRETCHES: [[f64; 2]; 6] = [
        [0.0, 1.0],
        [0.0, 0.25],
        [0.3, 0.6],
        [0.5, 0.52],
        [0.7, 1.0],
        [0.95, 0.96],
    ];

    /// `P'` and `P''` at a parameter, from neighbouring points.
    fn differences(curve: &Cubic, t: f64) -> [Vector2<f64>; 2] {
        let step = 1e-4;
        let [before, here, behind] = [t - step, t, t + step].map(|t| curve.point(t));
        [
            (behind - before) / (2.0 * step),
            ((behind - here) - (here - before)) / (step * step),
        ]
    }

    fn places([low, high]: [f64; 2]) -> impl Iterator<Item = f64> {
        (0..=200).map(move |k| low + (high - low) * f64::from(k) / 200.0)
    }

    /// Bounds hold at every place between; for a short stretch they are tight. Source: points and their differences.
    #[test]
    fn reach_and_turn_hold_and_are_near() {
        for curve in curves() {
            for stretch in STRETCHES {
                let [low, high] = stretch;
                let (reach, turn) = curve.spread(low, high);
                let (middle, normal) = curve.at(0.5 * (low + high));
                let far = places(stretch).map(|t| (curve.point(t) - middle).norm());
                let far = far.fold(0.0, f64::max);
                let turned = places(stretch).map(|t| {
                    let there = curve.normal(t);
                    normal.perp(&there).atan2(normal.dot(&there)).abs()
                });
                let turned = turned.fold(0.0, f64::max);
                assert!(far <= reach * (1.0 + 1e-12), "{stretch:?}: {far} {reach}");
                assert!(turned <= turn + 1e-12, "{stretch:?}: {turned} {turn}");
                if high - low < 0.05 {
                    assert!(reach < 1.02 * far, "{stretch:?}: {far} {reach}");
                    assert!(turn < 1.1 * turned, "{stretch:?}: {turned} {turn}");
                }
            }
        }
        // Its steps' cone is wider than half a plane.
        assert_eq!(curves()[2].spread(0.0, 1.0).1, PI);
        assert!(curves()[3].spread(0.0, 1.0).1 < 0.5 * PI);
    }

    /// The greatest `P''` is at an end. Source: differences of points.
    #[test]
    fn a_bend_is_the_greatest_second_difference() {
        for curve in curves() {
            let found = curve.bend(0.5);
            let most = places([0.0, 1.0]).map(|t| differences(&curve, t)[1].norm());
            let most = most.fold(0.0, f64::max);
            assert!((found.0 / most - 1.0).abs() < 1e-5, "{found:?} {most}");
            assert_eq!(found.1, 0.0);
        }
    }

    /// Bounds of the curvature hold at every place between; for a short stretch they are tight. Source: differences of points.
    #[test]
    fn curvature_stays_within_its_bounds() {
        let mut known = 0;
        for curve in curves() {
            for stretch in STRETCHES {
                let curvatures = places(stretch).map(|t| {
                    let [rise, bend] = differences(&curve, t);
                    rise.perp(&bend) / rise.norm().powi(3)
                });
                let (least, most) = curvatures
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), c| {
                        (a.min(c), b.max(c))
                    });
                let size = least.abs().max(most.abs());
                let Some(bounds) = curve.convexity(stretch[0], stretch[1]) else {
                    continue;
                };
                known += 1;
                assert!(
                    bounds.0 <= least + 1e-4 * size,
                    "{stretch:?}: {least} {bounds:?}"
                );
                assert!(
                    bounds.1 >= most - 1e-4 * size,
                    "{stretch:?}: {most} {bounds:?}"
                );
                if stretch[1] - stretch[0] < 0.05 {
                    assert!(
                        bounds.0 >= least - 0.2 * size,
                        "{stretch:?}: {least} {bounds:?}"
                    );
                    assert!(
                        bounds.1 <= most + 0.2 * size,
                        "{stretch:?}: {most} {bounds:?}"
                    );
                }
            }
        }
        assert!(known >= 18, "{known}");
    }

    /// A curve with zero speed, or with steps as short as rounding, has no bounds.
    #[test]
    fn a_cusp_has_no_curvature() {
        let points = [[40.0, 0.0], [40.0, 0.0], [41.0, 0.5], [42.0, 2.0]];
        let cusp = Cubic::new(points.map(|[x, y]| Point2::new(x, y)));
        assert_eq!(cusp.convexity(0.0, 0.5), None);
        assert!(cusp.convexity(0.1, 0.5).is_some());
        assert_eq!(curves()[0].convexity(0.5, 0.5 + 1e-10), None);
        assert!(curves()[0].convexity(0.5, 0.5 + 1e-6).is_some());
    }
}

//! An involute with a profile deviation: `P = E (r_b − i (r_b ξ + δ))`, `E = e^{i(ξ − ψ_b)}`.
//!
//! Every point lies `δ` outside the involute, on the same line of action. With `a = r_b ξ + δ`
//!
//! ```text
//! P' = E (a − iδ'),   |P'| = h = √(a² + δ'²),   P'' = E (r_b + 2δ') + iE (a − δ'')
//! ```
//!
//! The normal is the involute's `−iE` turned by `−atan(δ'/a)`. The curvature is `κ = (1 − (δ'' a − δ' (r_b + δ'))/h²)/h`.

use super::Osculating;
use crate::gear::DeviationCurve;
use nalgebra::{Point2, Vector2};
use std::f64::consts::PI;
use std::sync::Arc;

/// An involute of the base circle with a deviation of its profile.
#[derive(Debug, Clone, PartialEq)]
pub struct ModifiedFlank {
    /// `r_b`, mm.
    base: f64,
    /// `ψ_b`, rad.
    half_base: f64,
    deviation: Arc<DeviationCurve>,
    /// [`ModifiedFlank::bend`] over the whole flank, without the term `r_b ξ`.
    bend: (f64, f64),
}

impl ModifiedFlank {
    /// The involute that leaves the circle of radius `base` (mm) at the angle `half_base` (rad) from the centre line, with a deviation.
    ///
    /// `None` if the flank is irregular in the rolls of the range: `r_b ξ + δ` or its slope is not above 0.
    pub(in crate::gear) fn new(
        base: f64,
        half_base: f64,
        deviation: Arc<DeviationCurve>,
        [low, high]: [f64; 2],
    ) -> Option<ModifiedFlank> {
        let mut flank = ModifiedFlank {
            base,
            half_base,
            deviation,
            bend: (0.0, 0.0),
        };
        let arm = flank.arms(low, high)[0];
        let [value, slope, second] = flank.deviation.bounds(low, high).map(most);
        if !(arm > 0.0 && base > slope) {
            return None;
        }
        // A chord is parallel to a tangent, whose angle from E is at most Δ plus this.
        let off = (slope / arm).atan();
        let along = base + 2.0 * slope;
        flank.bend = (value + second + along * off, along);
        Some(flank)
    }

    /// The deviation.
    pub fn deviation(&self) -> &DeviationCurve {
        &self.deviation
    }

    /// Interval of `a` over rolls, mm.
    fn arms(&self, low: f64, high: f64) -> [f64; 2] {
        // It rises with the roll on a regular flank.
        [low, high].map(|xi| self.base * xi + self.deviation.at(xi))
    }

    // Out of line: the kernel's own curves are not these.
    #[inline(never)]
    pub(super) fn at(&self, xi: f64) -> (Point2<f64>, Vector2<f64>) {
        let (sin, cos) = (xi - self.half_base).sin_cos();
        let base = self.base;
        let [value, slope, _] = self.deviation.jet(xi);
        // Without a deviation this is the involute to the last bit.
        let point = Point2::new(
            base * (cos + xi * sin) + value * sin,
            base * (sin - xi * cos) - value * cos,
        );
        let normal = Vector2::new(sin, -cos);
        if slope == 0.0 {
            return (point, normal);
        }
        // −i E (a − iδ')/h.
        let arm = base * xi + value;
        let along = Vector2::new(cos, sin);
        (point, (normal * arm - along * slope).normalize())
    }

    /// Point, normal, speed and curvature, computed together.
    pub(super) fn osculating(&self, xi: f64) -> Osculating {
        let (sin, cos) = (xi - self.half_base).sin_cos();
        let base = self.base;
        let [value, slope, second] = self.deviation.jet(xi);
        let arm = base * xi + value;
        let square = arm * arm + slope * slope;
        let speed = square.sqrt();
        let (across, along) = (arm / speed, slope / speed);
        let point = Point2::new(base * cos + arm * sin, base * sin - arm * cos);
        let normal = Vector2::new(sin * across - cos * along, -cos * across - sin * along);
        let bent = second * arm - slope * (base + slope);
        Osculating {
            point,
            normal,
            speed,
            curvature: (1.0 - bent / square) / speed,
        }
    }

    /// Whether the flank is convex between two rolls: it then lies on one side of each of its tangents.
    ///
    /// It is convex at an edge if the slope falls there, because the normal turns by `−atan(δ'/a)`.
    pub fn is_convex(&self, low: f64, high: f64) -> bool {
        let edges = self.deviation.edges();
        let falls =
            |edge: &f64| self.deviation.slope(*edge) < self.deviation.slope(edge.next_down());
        let inside = edges.iter().filter(|edge| **edge > low && **edge < high);
        let bulges = |(low, high): (f64, f64)| self.bulges(low, high, 0);
        inside.clone().all(falls) && super::smooth(edges, low, high).all(bulges)
    }

    /// Convexity by bounds over the stretch, or over its halves: a deviation of a few knots needs some dozens.
    fn bulges(&self, low: f64, high: f64, depth: u32) -> bool {
        // A thousandth of a flank without a decision counts as hollow.
        const DEEPEST: u32 = 10;
        let middle = 0.5 * (low + high);
        self.convexity(low, high)
            .is_some_and(|(least, _)| least > 0.0)
            || depth < DEEPEST
                && self
                    .convexity(middle, middle)
                    .is_some_and(|(least, _)| least > 0.0)
                && self.bulges(low, middle, depth + 1)
                && self.bulges(middle, high, depth + 1)
    }

    /// Greatest tilt of the normal from the involute's between two rolls, rad.
    pub fn tilt(&self, low: f64, high: f64) -> f64 {
        let steepest = most(self.deviation.bounds(low, high)[1]);
        steepest.atan2(self.arms(low, high)[0])
    }

    /// Least radius of curvature between two rolls, mm: 0 across an edge or where the flank is not convex.
    pub fn least_bend_radius(&self, low: f64, high: f64) -> f64 {
        // Tuned: bounds over 16 parts are tight enough.
        const PARTS: u32 = 16;
        let at = |k: u32| low + (high - low) * f64::from(k) / f64::from(PARTS);
        if self
            .deviation
            .edges()
            .iter()
            .any(|edge| *edge > low && *edge < high)
        {
            return 0.0;
        }
        let bounds = (0..PARTS).map(|k| self.convexity(at(k), at(k + 1)));
        let radius = |bounds: Option<(f64, f64)>| match bounds {
            Some((_, most)) if most > 0.0 => 1.0 / most,
            _ => 0.0,
        };
        bounds.map(radius).fold(f64::INFINITY, f64::min)
    }

    pub(super) fn point(&self, xi: f64) -> Point2<f64> {
        self.at(xi).0
    }

    pub(super) fn normal(&self, xi: f64) -> Vector2<f64> {
        self.at(xi).1
    }

    pub(super) fn radius(&self, xi: f64) -> f64 {
        match self.deviation.at(xi) {
            // The involute's radius to the last bit.
            0.0 => self.base * (1.0 + xi * xi).sqrt(),
            value => self.base.hypot(self.base * xi + value),
        }
    }

    pub(super) fn speed(&self, xi: f64) -> f64 {
        let [value, slope, _] = self.deviation.jet(xi);
        (self.base * xi + value).hypot(slope)
    }

    /// The longer half is at most its greatest speed times its width. The normal turns with `E` and by the change of `atan(δ'/a)`.
    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        let half = 0.5 * (high - low);
        let [_, slopes, _] = self.deviation.bounds(low, high);
        let arms = self.arms(low, high);
        let reach = arms[1].hypot(most(slopes)) * half;
        let tilts = slopes.map(|slope| {
            // The greater tilt has the shorter arm.
            [arms[0], arms[1]].map(|arm| slope.atan2(arm))
        });
        let tilt = tilts[1][0].max(tilts[1][1]) - tilts[0][0].min(tilts[0][1]);
        (reach, (half + tilt).min(PI))
    }

    pub(super) fn bend(&self, xi: f64) -> (f64, f64) {
        (self.base * xi + self.bend.0, self.bend.1)
    }

    pub(super) fn convexity(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        let [near, far] = self.arms(low, high);
        if near <= 0.0 {
            return None;
        }
        let [_, slopes, seconds] = self.deviation.bounds(low, high);
        let bent = [
            (seconds[0] * near).min(seconds[0] * far),
            (seconds[1] * near).max(seconds[1] * far),
        ];
        let tilted = slopes.map(|slope| slope * (self.base + slope));
        let rest = [bent[0] - tilted[1], bent[1] - tilted[0]];
        let gentlest = if slopes[0] <= 0.0 && slopes[1] >= 0.0 {
            0.0
        } else {
            slopes[0].abs().min(slopes[1].abs())
        };
        let speeds = [near.hypot(gentlest), far.hypot(most(slopes))];
        let squares = speeds.map(|speed| speed * speed);
        let least = 1.0 - (rest[1] / squares[0]).max(rest[1] / squares[1]);
        let greatest = 1.0 - (rest[0] / squares[0]).min(rest[0] / squares[1]);
        Some((
            (least / speeds[0]).min(least / speeds[1]),
            (greatest / speeds[0]).max(greatest / speeds[1]),
        ))
    }

    pub(super) fn curvature(&self, from: f64, to: f64) -> Option<f64> {
        self.convexity(from.min(to), from.max(to))
            .map(|bounds| most(bounds.into()))
    }
}

/// The greatest absolute value in an interval.
fn most([least, most]: [f64; 2]) -> f64 {
    least.abs().max(most.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Flanks of 40 mm base radius: 20 µm of crowning, and a hollow of 30 µm.
    fn flanks() -> [ModifiedFlank; 2] {
        [[-0.02, 0.08, -0.08, 0.0], [0.01, -0.12, 0.12, 0.02]].map(|coefficients| {
            let curve = Arc::new(DeviationCurve::polynomial([0.0, 1.0], coefficients));
            ModifiedFlank::new(40.0, 0.03, curve, [0.02, 0.9]).unwrap()
        })
    }

    /// Turn of the normal per length, and length per roll, from points 2e-5 rad apart.
    fn differences(flank: &ModifiedFlank, xi: f64) -> [f64; 2] {
        let [(from, before), (to, behind)] = [xi - 1e-5, xi + 1e-5].map(|xi| flank.at(xi));
        let length = (to - from).norm();
        [before.perp(&behind).asin() / length, length / 2e-5]
    }

    #[test]
    fn an_osculating_circle_touches_where_the_flank_is() {
        for flank in flanks() {
            for xi in [0.03, 0.1, 0.3, 0.5, 0.8] {
                let (point, normal) = flank.at(xi);
                let found = flank.osculating(xi);
                assert!((found.point - point).norm() < 1e-13, "{xi}");
                assert!((found.normal - normal).norm() < 1e-13, "{xi}");
                let [curvature, speed] = differences(&flank, xi);
                assert!((found.curvature / curvature - 1.0).abs() < 1e-6, "{xi}");
                assert!((found.speed / speed - 1.0).abs() < 1e-6, "{xi}");
            }
        }
    }

    /// The radius is 0 across an edge and positive beside it. Without one it holds at every place between and is tight for a short stretch.
    #[test]
    fn no_place_of_a_flank_bends_with_less_radius() {
        for flank in flanks() {
            for ([low, high], near) in [
                ([0.1, 0.11], 0.97),
                ([0.05, 0.2], 0.85),
                ([0.3, 0.85], 0.85),
            ] {
                let places = (0..=100).map(|k| low + (high - low) * f64::from(k) / 100.0);
                let turned = places.map(|xi| differences(&flank, xi)[0]);
                let roundest = 1.0 / turned.fold(0.0, f64::max);
                let radius = flank.least_bend_radius(low, high);
                assert!(
                    radius < roundest + 1e-6 && radius > near * roundest,
                    "{radius}, {roundest}"
                );
            }
        }
        let curve = DeviationCurve::polynomial([0.0, 1.0], [0.01, -0.12, 0.12, 0.02]);
        let curve = Arc::new(curve.with_edge(0.4));
        let flank = ModifiedFlank::new(40.0, 0.03, curve, [0.02, 0.9]).unwrap();
        assert_eq!(flank.least_bend_radius(0.3, 0.5), 0.0);
        assert!(flank.least_bend_radius(0.2, 0.3) > 0.0);
        assert!(flank.least_bend_radius(0.5, 0.8) > 0.0);
    }
}

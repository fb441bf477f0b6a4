//! Arcs of circles and ellipses as segments.

use super::limits::{FIT_MM, SAME_MM};
use gearlash::outline::PathSegment;
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::TAU;

/// Segments without a gap, and a bound on their distance from the drawn curve, mm.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Curve {
    pub segments: Vec<PathSegment>,
    pub bound: f64,
}

impl Curve {
    pub fn exact(segment: PathSegment) -> Curve {
        Curve {
            segments: vec![segment],
            bound: 0.0,
        }
    }

    pub fn add(&mut self, more: Curve) {
        self.segments.extend(more.segments);
        self.bound = self.bound.max(more.bound);
    }
}

/// Below this bulge the centre is so far away (250 chords) that an arc from it would miss its ends by rounding; a cubic curve then
/// follows the arc to 4e-17 of the chord.
const FLATTEST_BULGE: f64 = 1e-3;

/// A bound on the distance of a cubic curve from an arc of the unit circle that sweeps `4 atan(quarter)`, with the same ends and
/// tangents.
///
/// With handles of 4/3 tan(θ/4) its squared distance from the centre exceeds 1 by at most 4/27 sin⁶(θ/4)/cos²(θ/4) (Dokken, Dæhlen,
/// Lyche, Mørken: Good approximation of circles by curvature-continuous Bézier curves, 1990), the distance by no more than half that.
fn circle_bound(quarter: f64) -> f64 {
    let sin_squared = quarter * quarter / (1.0 + quarter * quarter);
    2.0 / 27.0 * sin_squared.powi(3) * (1.0 + quarter * quarter)
}

/// The arc from `start` to `end` of the bulge tan(sweep/4), counter-clockwise positive.
pub fn bulged(start: Point2<f64>, end: Point2<f64>, bulge: f64) -> Curve {
    let chord = end - start;
    // Exporters leave 1e-16 of bulge on straight lines.
    let sagitta = 0.5 * bulge.abs() * chord.norm();
    if sagitta <= SAME_MM {
        return Curve {
            bound: sagitta,
            ..Curve::exact(PathSegment::Line([start, end]))
        };
    }
    let radius = chord.norm() * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
    if bulge.abs() < FLATTEST_BULGE {
        let handle = chord * (1.0 + bulge * bulge) / 3.0;
        let turn = Rotation2::new(2.0 * bulge.atan());
        let points = [
            start,
            start + turn.inverse() * handle,
            end - turn * handle,
            end,
        ];
        return Curve {
            bound: radius * circle_bound(bulge.abs()),
            ..Curve::exact(PathSegment::Cubic(points))
        };
    }
    let left = Vector2::new(-chord.y, chord.x);
    let centre = start + 0.5 * chord + left * ((1.0 - bulge * bulge) / (4.0 * bulge));
    let from = start - centre;
    Curve::exact(PathSegment::Arc {
        centre,
        radius,
        start: from.y.atan2(from.x),
        sweep: 4.0 * bulge.atan(),
    })
}

/// The arc `centre + u cos φ + v sin φ`, from `from` through `sweep`, up to a whole turn. A circle stays exact; a whole one has
/// two halves.
pub fn elliptic(centre: Point2<f64>, [u, v]: [Vector2<f64>; 2], from: f64, sweep: f64) -> Curve {
    // Its half axes are half the sum and half the difference of |u − iv| and |u + iv|.
    let side = |sign: f64| (u.x + sign * v.y).hypot(u.y - sign * v.x);
    let (same, other) = (side(1.0), side(-1.0));
    let greatest = 0.5 * (same + other);
    if same.min(other) <= SAME_MM {
        // u and v have equal length and are perpendicular; v is to the left of u where `same` is the one that remains.
        let hand = if same > other { 1.0 } else { -1.0 };
        let start = u.y.atan2(u.x) + hand * from;
        let halves = if sweep.abs() >= TAU { 2 } else { 1 };
        let sweep = hand * sweep / f64::from(halves);
        let arc = |half: i32| PathSegment::Arc {
            centre,
            radius: greatest,
            start: start + f64::from(half) * sweep,
            sweep,
        };
        return Curve {
            segments: (0..halves).map(arc).collect(),
            bound: 0.0,
        };
    }
    // The curve is the affine image of a unit circle's, which lengthens no distance by more than the greatest half axis.
    let bound = |steps: u32| greatest * circle_bound((sweep / f64::from(4 * steps)).tan());
    let mut steps = (4.0 * sweep.abs() / TAU).ceil().max(1.0) as u32;
    // Each doubling divides it by some 64; a half axis of a kilometre needs 256.
    while steps < 4096 && !(bound(steps) <= FIT_MM) {
        steps *= 2;
    }
    let step = sweep / f64::from(steps);
    let handle = 4.0 / 3.0 * (step / 4.0).tan();
    let point = |angle: f64| centre + u * angle.cos() + v * angle.sin();
    let tangent = |angle: f64| (v * angle.cos() - u * angle.sin()) * handle;
    let curve = |index: u32| {
        let ends = [index, index + 1].map(|index| from + f64::from(index) * step);
        let [start, end] = ends.map(point);
        PathSegment::Cubic([start, start + tangent(ends[0]), end - tangent(ends[1]), end])
    };
    Curve {
        segments: (0..steps).map(curve).collect(),
        bound: bound(steps),
    }
}

//! A segment of a drawn path.

use crate::gear::{Circle, Cubic, Line, PartCurve};
use nalgebra::{Point2, Vector2};

/// Chords of one segment at most.
const MOST_CHORDS: f64 = 4096.0;

/// A segment of a drawn path, mm, from its start to its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PathSegment {
    /// Straight between two points.
    Line([Point2<f64>; 2]),
    /// On a circle.
    Arc {
        /// Its centre.
        centre: Point2<f64>,
        /// Its radius.
        radius: f64,
        /// Direction from the centre to its start, rad.
        start: f64,
        /// The angle to its end, rad, counter-clockwise positive; at most a whole turn.
        sweep: f64,
    },
    /// Cubic Bézier curve of four control points.
    Cubic([Point2<f64>; 4]),
}

impl PathSegment {
    /// It as a part of a profile, the metal on its left: the curve, and its parameter from start to end.
    pub(super) fn part(&self) -> (PartCurve, [f64; 2]) {
        match *self {
            PathSegment::Line([from, to]) => (
                PartCurve::Line(Line::new(from, to)),
                [0.0, (to - from).norm()],
            ),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => (
                PartCurve::Circle(Circle::new(centre, radius, sweep > 0.0)),
                [start, start + sweep],
            ),
            PathSegment::Cubic(points) => (PartCurve::Cubic(Cubic::new(points)), [0.0, 1.0]),
        }
    }

    /// The point a share `u`, 0 to 1, of the parameter along.
    pub fn at(&self, u: f64) -> Point2<f64> {
        let (curve, [from, to]) = self.part();
        curve.point(from + (to - from) * u)
    }

    /// Points along it, its end left out: chords within `chord` mm of it.
    pub(super) fn cut(&self, chord: f64) -> Vec<Point2<f64>> {
        let (curve, [from, to]) = self.part();
        let length = (to - from).abs();
        let (a, b) = curve.bend(from.max(to));
        // A chord leaves the curve by `max |P''| Δ²/8` at most.
        let count = ((a + b * length) * length * length / (8.0 * chord))
            .sqrt()
            .ceil();
        let count = count.clamp(1.0, MOST_CHORDS);
        let at = |k: u32| curve.point(from + (to - from) * f64::from(k) / count);
        (0..count as u32).map(at).collect()
    }

    /// Where it starts.
    pub fn start(&self) -> Point2<f64> {
        match self {
            PathSegment::Line([start, _]) | PathSegment::Cubic([start, ..]) => *start,
            PathSegment::Arc { .. } => self.at(0.0),
        }
    }

    /// Where it ends.
    pub fn end(&self) -> Point2<f64> {
        match self {
            PathSegment::Line([_, end]) | PathSegment::Cubic([.., end]) => *end,
            PathSegment::Arc { .. } => self.at(1.0),
        }
    }

    /// The same, gone through the other way.
    pub fn reversed(&self) -> PathSegment {
        match *self {
            PathSegment::Line([from, to]) => PathSegment::Line([to, from]),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => PathSegment::Arc {
                centre,
                radius,
                start: start + sweep,
                sweep: -sweep,
            },
            PathSegment::Cubic([a, b, c, d]) => PathSegment::Cubic([d, c, b, a]),
        }
    }

    /// Moved by `by`, mm.
    pub fn moved(&self, by: Vector2<f64>) -> PathSegment {
        match *self {
            PathSegment::Line(points) => PathSegment::Line(points.map(|point| point + by)),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => PathSegment::Arc {
                centre: centre + by,
                radius,
                start,
                sweep,
            },
            PathSegment::Cubic(points) => PathSegment::Cubic(points.map(|point| point + by)),
        }
    }

    /// Seen from the other side: mirrored in the y axis.
    pub fn mirrored(&self) -> PathSegment {
        let mirror = |point: Point2<f64>| Point2::new(-point.x, point.y);
        match *self {
            PathSegment::Line(points) => PathSegment::Line(points.map(mirror)),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => PathSegment::Arc {
                centre: mirror(centre),
                radius,
                start: std::f64::consts::PI - start,
                sweep: -sweep,
            },
            PathSegment::Cubic(points) => PathSegment::Cubic(points.map(mirror)),
        }
    }

    /// A length not below its own, mm: of a cubic curve that of its control polygon.
    pub fn length(&self) -> f64 {
        match *self {
            PathSegment::Line([from, to]) => (to - from).norm(),
            PathSegment::Arc { radius, sweep, .. } => radius * sweep.abs(),
            PathSegment::Cubic(points) => {
                let steps = points.windows(2).map(|pair| (pair[1] - pair[0]).norm());
                steps.sum()
            }
        }
    }

    /// Whether all its numbers are finite.
    pub fn is_finite(&self) -> bool {
        let finite = |point: &Point2<f64>| point.x.is_finite() && point.y.is_finite();
        match self {
            PathSegment::Line(points) => points.iter().all(finite),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => finite(centre) && (radius + start + sweep).is_finite() && *radius > 0.0,
            PathSegment::Cubic(points) => points.iter().all(finite),
        }
    }
}

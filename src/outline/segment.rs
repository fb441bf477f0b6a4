//! A segment of a drawn path.

use crate::gear::{Circle, Cubic, Line, PartCurve};
use nalgebra::{Point2, Vector2};

/// Chords of one segment at most: a picture of a curve that leaves the drawing far behind has an end.
const MOST_CHORDS: f64 = 1e6;

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
        self.mapped(|point| point + by, |start, sweep| (start, sweep))
    }

    /// Seen from the other side: mirrored in the y axis.
    pub fn mirrored(&self) -> PathSegment {
        self.mapped(
            |point| Point2::new(-point.x, point.y),
            |start, sweep| (std::f64::consts::PI - start, -sweep),
        )
    }

    /// With its points elsewhere, and the start and sweep of an arc as those say.
    fn mapped(
        &self,
        place: impl Fn(Point2<f64>) -> Point2<f64>,
        turn: impl Fn(f64, f64) -> (f64, f64),
    ) -> PathSegment {
        match *self {
            PathSegment::Line(points) => PathSegment::Line(points.map(place)),
            PathSegment::Cubic(points) => PathSegment::Cubic(points.map(place)),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => {
                let (start, sweep) = turn(start, sweep);
                PathSegment::Arc {
                    centre: place(centre),
                    radius,
                    start,
                    sweep,
                }
            }
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

    /// Points from its start on, its end left out, whose chords are within `chordal_error` mm (> 0) of it.
    pub fn chords(&self, chordal_error: f64) -> impl Iterator<Item = Point2<f64>> {
        let pieces = match *self {
            PathSegment::Line(_) => 1.0,
            // The height of an arc above its chord is 2 r sin²(angle / 4).
            PathSegment::Arc { radius, sweep, .. } => {
                let half_sine = (chordal_error / (2.0 * radius)).sqrt().min(1.0);
                sweep.abs() / (4.0 * half_sine.asin())
            }
            // |P''| Δ²/8, the second derivative between its values at the ends.
            PathSegment::Cubic([a, b, c, d]) => {
                let bends = [(a - b) + (c - b), (b - c) + (d - c)];
                let bend = bends.map(|bend| 6.0 * bend.norm());
                (bend[0].max(bend[1]) / (8.0 * chordal_error)).sqrt()
            }
        };
        let pieces = pieces.ceil().clamp(1.0, MOST_CHORDS) as u32;
        (0..pieces).map(move |i| self.at(f64::from(i) / f64::from(pieces)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: points of the segment itself, 50 to a chord, against the chord between the points on both sides of them.
    #[test]
    fn chords_of_arcs_and_cubics_are_within_their_error() {
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, -1.0], [4.0, 1.0]];
        let arc = |sweep| PathSegment::Arc {
            centre: Point2::new(1.0, -2.0),
            radius: 5.0,
            start: 0.3,
            sweep,
        };
        let cubic = PathSegment::Cubic(points.map(Point2::from));
        for (part, least_share) in [(arc(2.9), 0.9), (arc(-0.7), 0.9), (cubic, 0.5)] {
            for error in [1e-1, 1e-3, 1e-6] {
                let mut points: Vec<Point2<f64>> = part.chords(error).collect();
                assert_eq!(points[0], part.start());
                points.push(part.end());
                let count = points.len() - 1;
                let mut most: f64 = 0.0;
                for i in 0..50 * count {
                    let at = part.at(i as f64 / (50 * count) as f64);
                    let chord = points[i / 50 + 1] - points[i / 50];
                    most = most.max((at - points[i / 50]).perp(&chord).abs() / chord.norm());
                }
                assert!(most <= error * (1.0 + 1e-6), "{most} of {error}");
                assert!(
                    most > least_share * error || count < 20,
                    "{most} of {error}"
                );
            }
        }
    }
}

//! Distances between chords, and from a point to them. The only file that names parry.
//!
//! parry gives the projection of a point on a segment. Its distance of two segments is not used: it compares with an
//! absolute epsilon and takes short, nearly parallel segments for parallel. In the plane the distance of two segments
//! is that of an end of one to the other, so four projections suffice, or it is zero where they cross.

use nalgebra::Point2;
use parry2d_f64::math::Vector;
use parry2d_f64::query::PointQueryWithLocation;
use parry2d_f64::shape::Segment;
use std::ops::Range;

/// A polyline prepared for finding the place nearest to a point.
pub struct PolylineShape {
    segments: Vec<Segment>,
}

/// The place of a shape nearest to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Distance, in the unit of the shape, accurate to the rounding of the coordinates.
    pub distance: f64,
    /// Segment `i` runs from vertex `i` to `i + 1`.
    pub segment: usize,
    /// The nearest point.
    pub at: Point2<f64>,
}

/// The closest approach of two chords; at the distance zero where they cross.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closest {
    /// Distance, in the unit of the chords, accurate to the rounding of the coordinates.
    pub distance: f64,
    /// The closest points, on the first and on the second.
    pub points: [Point2<f64>; 2],
}

/// Closest approach of two chords in one frame, each given by its ends.
pub fn closest(first: &[Point2<f64>; 2], second: &[Point2<f64>; 2]) -> Closest {
    let [first, second] = [first, second].map(|[a, b]| Segment::new(vector(a), vector(b)));
    let candidates = [
        (first.a, project(&second, first.a)),
        (first.b, project(&second, first.b)),
        (project(&first, second.a), second.a),
        (project(&first, second.b), second.b),
    ];
    let mut best = candidates[0];
    let mut least = (best.0 - best.1).length_squared();
    for candidate in &candidates[1..] {
        let squared = (candidate.0 - candidate.1).length_squared();
        if squared < least {
            (best, least) = (*candidate, squared);
        }
    }
    let distance = if cross(&first, &second) {
        0.0
    } else {
        least.sqrt()
    };
    Closest {
        distance,
        points: [best.0, best.1].map(|p| Point2::new(p.x, p.y)),
    }
}

fn vector(point: &Point2<f64>) -> Vector {
    Vector::new(point.x, point.y)
}

impl PolylineShape {
    /// The open polyline through `points`, at least two.
    pub fn new(points: &[Point2<f64>]) -> PolylineShape {
        let chord = |ends: &[Point2<f64>]| Segment::new(vector(&ends[0]), vector(&ends[1]));
        PolylineShape {
            segments: points.windows(2).map(chord).collect(),
        }
    }

    /// The place of `self` nearest to `point` on either side; the first of several.
    ///
    /// It examines all segments: for coarse polygons and short stretches.
    pub fn nearest(&self, point: &Point2<f64>) -> Nearest {
        let mut best = self.to_segment(0, point);
        for segment in 1..self.segments.len() {
            let found = self.to_segment(segment, point);
            if found.distance < best.distance {
                best = found;
            }
        }
        best
    }

    /// The range of segments outside which nothing is within `margin` of `point`; empty if there are none.
    pub fn near_point(&self, point: &Point2<f64>, margin: f64) -> Range<usize> {
        let near = |segment: &usize| self.to_segment(*segment, point).distance <= margin;
        let mut within = (0..self.segments.len()).filter(near);
        let Some(first) = within.next() else {
            return 0..0;
        };
        first..within.next_back().unwrap_or(first) + 1
    }

    fn to_segment(&self, segment: usize, point: &Point2<f64>) -> Nearest {
        let point = vector(point);
        let at = project(&self.segments[segment], point);
        Nearest {
            distance: (at - point).length(),
            segment,
            at: Point2::new(at.x, at.y),
        }
    }
}

/// Whether the ends of each segment lie strictly on both sides of the other.
fn cross(a: &Segment, b: &Segment) -> bool {
    let sides = |line: &Segment, ends: &Segment| {
        let along = line.b - line.a;
        along.perp_dot(ends.a - line.a) * along.perp_dot(ends.b - line.a)
    };
    sides(a, b) < 0.0 && sides(b, a) < 0.0
}

fn project(segment: &Segment, point: Vector) -> Vector {
    segment
        .project_local_point_and_get_location(point, false)
        .0
        .point
}

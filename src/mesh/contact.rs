//! Distance between two half teeth. The only file that names parry.
//!
//! parry gives the polylines, their bounding volume hierarchies, the traversal
//! of two of them at once and the projection of a point on a segment. It does
//! not give the distance of two segments: that one compares with an absolute
//! epsilon and takes short, nearly parallel segments for parallel. In the plane
//! the distance of two segments is that of an end of one to the other, so four
//! projections do, or zero where they cross.

use nalgebra::{Isometry2, Point2};
use parry2d_f64::math::{Pose2, Vector};
use parry2d_f64::partitioning::BvhNode;
use parry2d_f64::query::PointQueryWithLocation;
use parry2d_f64::shape::{Polyline, Segment};
use std::cell::Cell;
use std::ops::Range;

/// A polyline ready for distance queries.
pub struct Shape {
    polyline: Polyline,
}

/// The closest approach of two shapes; at the distance zero where they cross.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closest {
    /// Distance, in the unit of the shapes. Right to the rounding of the coordinates.
    pub distance: f64,
    /// Segment of the first and of the second shape; segment `i` runs from vertex `i` to `i + 1`.
    pub segments: [u32; 2],
    /// The closest points, both in the first shape's frame.
    pub points: [Point2<f64>; 2],
}

impl Shape {
    /// The open polyline through `points`, at least two.
    pub fn new(points: &[Point2<f64>]) -> Shape {
        let vertices = points.iter().map(|p| Vector::new(p.x, p.y)).collect();
        Shape {
            polyline: Polyline::new(vertices, None),
        }
    }

    /// Closest approach of `self` and `other`, which stands at `pose` in the frame of `self`.
    ///
    /// `hint`, the segments of an earlier answer nearby, makes it fast and changes nothing else:
    /// its distance is an upper bound, below which both hierarchies are searched.
    pub fn closest(&self, other: &Shape, pose: &Isometry2<f64>, hint: [u32; 2]) -> Closest {
        let pose = Pose2::from(*pose);
        let mut best = self.leaf(other, &pose, hint);
        let bound = Cell::new(best.distance);
        let nearer = |ours: &BvhNode, theirs: &BvhNode| gap(ours, theirs, &pose) < bound.get();
        let ours = self.polyline.bvh();
        for (ours, theirs) in ours.leaf_pairs(other.polyline.bvh(), nearer) {
            let found = self.leaf(other, &pose, [ours, theirs]);
            if found.distance < best.distance {
                best = found;
                bound.set(found.distance);
            }
        }
        best
    }

    /// The stretches of segments of `self` and of `other` outside which nothing is within `margin` of
    /// the other shape; `None` when nothing is.
    pub fn near(
        &self,
        other: &Shape,
        pose: &Isometry2<f64>,
        margin: f64,
    ) -> Option<[Range<usize>; 2]> {
        let pose = Pose2::from(*pose);
        let within = |ours: &BvhNode, theirs: &BvhNode| gap(ours, theirs, &pose) <= margin;
        let mut found: Option<[Range<usize>; 2]> = None;
        let ours = self.polyline.bvh();
        for (ours, theirs) in ours.leaf_pairs(other.polyline.bvh(), within) {
            if self.leaf(other, &pose, [ours, theirs]).distance > margin {
                continue;
            }
            let pair = [ours as usize, theirs as usize].map(|i| i..i + 1);
            found = Some(match found {
                None => pair,
                Some([a, b]) => [join(a, &pair[0]), join(b, &pair[1])],
            });
        }
        found
    }

    /// Closest approach of one segment of each.
    fn leaf(&self, other: &Shape, pose: &Pose2, segments: [u32; 2]) -> Closest {
        let ours = self.polyline.segment(segments[0]);
        let theirs = other.polyline.segment(segments[1]);
        let theirs = Segment::new(pose * theirs.a, pose * theirs.b);
        let candidates = [
            (ours.a, project(&theirs, ours.a)),
            (ours.b, project(&theirs, ours.b)),
            (project(&ours, theirs.a), theirs.a),
            (project(&ours, theirs.b), theirs.b),
        ];
        let mut best = candidates[0];
        for candidate in &candidates[1..] {
            if (candidate.0 - candidate.1).length_squared() < (best.0 - best.1).length_squared() {
                best = *candidate;
            }
        }
        let distance = match cross(&ours, &theirs) {
            true => 0.0,
            false => (best.0 - best.1).length(),
        };
        Closest {
            distance,
            segments,
            points: [
                Point2::new(best.0.x, best.0.y),
                Point2::new(best.1.x, best.1.y),
            ],
        }
    }
}

/// A lower bound on the distance of what two nodes hold, the second at `pose` in the first's frame.
fn gap(ours: &BvhNode, theirs: &BvhNode, pose: &Pose2) -> f64 {
    let theirs = theirs.aabb().transform_by(pose);
    let apart = (ours.center() - theirs.center()).abs()
        - (ours.maxs() - ours.mins()) / 2.0
        - theirs.half_extents();
    apart.max(Vector::ZERO).length()
}

/// Whether the ends of each segment lie strictly on both sides of the other.
fn cross(a: &Segment, b: &Segment) -> bool {
    let sides = |line: &Segment, ends: &Segment| {
        let along = line.b - line.a;
        along.perp_dot(ends.a - line.a) * along.perp_dot(ends.b - line.a)
    };
    sides(a, b) < 0.0 && sides(b, a) < 0.0
}

fn join(a: Range<usize>, b: &Range<usize>) -> Range<usize> {
    a.start.min(b.start)..a.end.max(b.end)
}

fn project(segment: &Segment, point: Vector) -> Vector {
    segment
        .project_local_point_and_get_location(point, false)
        .0
        .point
}

//! Distance between two half teeth. The only file that names parry.
//!
//! parry gives segments, their bounding volume hierarchies, the traversal of
//! two of them at once and the projection of a point on a segment. It does not give the distance of two segments: that one compares with an absolute
//! epsilon and takes short, nearly parallel segments for parallel. In the plane
//! the distance of two segments is that of an end of one to the other, so four
//! projections do, or zero where they cross.

use nalgebra::{Isometry2, Point2};
use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::{Pose2, Vector};
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode};
use parry2d_f64::query::PointQueryWithLocation;
use parry2d_f64::shape::Segment;
use std::cell::Cell;
use std::ops::Range;

/// A polyline ready for distance queries.
pub struct Shape {
    segments: Vec<Segment>,
    /// Of all segments; `None` where they are so few that going through all is faster.
    hierarchy: Option<Bvh>,
}

/// The place of a shape nearest to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Distance, in the unit of the shape. Right to the rounding of the coordinates.
    pub distance: f64,
    /// Segment `i` runs from vertex `i` to `i + 1`.
    pub segment: usize,
    /// The nearest point.
    pub at: Point2<f64>,
}

/// Up to this many segments all are gone through (tuned: 16 to 64 are alike).
const FEW: usize = 32;

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

/// How a second shape turns, in the frame of the first.
#[derive(Debug, Clone, Copy)]
pub struct Turning {
    /// About this point.
    pub axis: Point2<f64>,
    /// +1 counter-clockwise, −1 clockwise.
    pub sense: f64,
    /// Greatest distance of its points from the axis.
    pub reach: f64,
    /// Chordal error of both shapes.
    pub chord: f64,
    /// Distance that must remain.
    pub margin: f64,
}

impl Shape {
    /// The open polyline through `points`, at least two.
    pub fn new(points: &[Point2<f64>]) -> Shape {
        let vertex = |p: &Point2<f64>| Vector::new(p.x, p.y);
        let segments: Vec<Segment> = points
            .windows(2)
            .map(|ends| Segment::new(vertex(&ends[0]), vertex(&ends[1])))
            .collect();
        let hierarchy = (segments.len() > FEW).then(|| {
            let boxes: Vec<Aabb> = segments.iter().map(|s| s.local_aabb()).collect();
            Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes)
        });
        Shape {
            segments,
            hierarchy,
        }
    }

    /// Closest approach of `self` and `other`, which stands at `pose` in the frame of `self`.
    ///
    /// `hint`, the segments of an earlier answer nearby, makes it fast and changes nothing else:
    /// its distance is an upper bound, below which everything is searched.
    pub fn closest(&self, other: &Shape, pose: &Isometry2<f64>, hint: [u32; 2]) -> Closest {
        let pose = Pose2::from(*pose);
        let mut best = self.leaf(other, &pose, hint);
        let bound = Cell::new(best.distance);
        self.pairs(other, &pose, &bound, |pair| {
            let found = self.leaf(other, &pose, pair);
            if found.distance < best.distance {
                best = found;
                bound.set(found.distance);
            }
        });
        best
    }

    /// How far `other`, which stands at `pose` in the frame of `self`, may turn before it can touch, rad: at most `most`.
    ///
    /// Two segments a distance `d` apart are separated by a strip of that width across `n`, the direction from the
    /// one's nearest point to the other's. Turned by `φ` about the axis, a point at `r` from it moves along `n` by
    /// `sin φ n·(k × r) − (1 − cos φ) n·r ≤ φ l + φ² m/2`, `l` and `m` the greatest such parts (not below 0) of the two ends:
    /// of all between, too. A curve lies within `chord` of its segment, and so do its parts.
    pub fn safe_turn(
        &self,
        other: &Shape,
        pose: &Isometry2<f64>,
        turning: &Turning,
        most: f64,
    ) -> f64 {
        let pose = Pose2::from(*pose);
        let axis = Vector::new(turning.axis.x, turning.axis.y);
        let mut safe = most;
        let bound = Cell::new(turning.margin + most * turning.reach);
        self.pairs(other, &pose, &bound, |pair| {
            let found = self.leaf(other, &pose, pair);
            let room = found.distance - turning.margin;
            let plain = room / turning.reach;
            if plain >= safe {
                return;
            }
            let theirs = other.segments[pair[1] as usize].transformed(&pose);
            let [on_ours, on_theirs] = found.points.map(|p| Vector::new(p.x, p.y));
            let n = (on_ours - on_theirs) / found.distance;
            let (mut lever, mut bulge) = (0.0f64, 0.0f64);
            for end in [theirs.a, theirs.b] {
                let r = end - axis;
                lever = lever.max(turning.sense * r.perp_dot(n));
                bulge = bulge.max(-r.dot(n));
            }
            let (lever, bulge) = (lever + turning.chord, bulge + turning.chord);
            // The lesser root of φ l + φ² m/2 = room, NaN at the distance 0.
            let turn = 2.0 * room / (lever + (lever * lever + 2.0 * room * bulge).sqrt());
            safe = safe.min(turn.max(plain));
            bound.set(turning.margin + safe * turning.reach);
        });
        safe
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
        let mut found: Option<[Range<usize>; 2]> = None;
        self.pairs(other, &pose, &Cell::new(margin), |pair| {
            if self.leaf(other, &pose, pair).distance <= margin {
                let pair = pair.map(|i| i as usize..i as usize + 1);
                found = Some(match found.take() {
                    None => pair,
                    Some([a, b]) => [join(a, &pair[0]), join(b, &pair[1])],
                });
            }
        });
        found
    }

    /// The place of `self` nearest to `point`, which may stand on either side of it; of several the first.
    ///
    /// Goes through all segments: for coarse polygons and short stretches.
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

    /// The stretch of segments outside which nothing is within `margin` of `point`; empty when nothing is.
    pub fn near_point(&self, point: &Point2<f64>, margin: f64) -> Range<usize> {
        let near = |segment: &usize| self.to_segment(*segment, point).distance <= margin;
        let mut within = (0..self.segments.len()).filter(near);
        let Some(first) = within.next() else {
            return 0..0;
        };
        first..within.next_back().unwrap_or(first) + 1
    }

    fn to_segment(&self, segment: usize, point: &Point2<f64>) -> Nearest {
        let point = Vector::new(point.x, point.y);
        let at = project(&self.segments[segment], point);
        Nearest {
            distance: (at - point).length(),
            segment,
            at: Point2::new(at.x, at.y),
        }
    }

    /// Calls `visit` with every pair of segments that may be within `bound` of each other, and some others.
    fn pairs(
        &self,
        other: &Shape,
        pose: &Pose2,
        bound: &Cell<f64>,
        mut visit: impl FnMut([u32; 2]),
    ) {
        if let (Some(ours), Some(theirs)) = (&self.hierarchy, &other.hierarchy) {
            let near = |a: &BvhNode, b: &BvhNode| gap(&a.aabb(), &b.aabb(), pose) <= bound.get();
            ours.leaf_pairs(theirs, near)
                .for_each(|(a, b)| visit([a, b]));
            return;
        }
        let boxes: Vec<Aabb> = self.segments.iter().map(|s| s.local_aabb()).collect();
        for (j, theirs) in other.segments.iter().enumerate() {
            let theirs = theirs.transformed(pose).local_aabb();
            for (i, ours) in boxes.iter().enumerate() {
                if apart(ours, &theirs) <= bound.get() {
                    visit([i as u32, j as u32]);
                }
            }
        }
    }

    /// Closest approach of one segment of each.
    fn leaf(&self, other: &Shape, pose: &Pose2, segments: [u32; 2]) -> Closest {
        let ours = self.segments[segments[0] as usize];
        let theirs = other.segments[segments[1] as usize].transformed(pose);
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

/// A lower bound on the distance of what two boxes hold, the second at `pose` in the first's frame.
fn gap(ours: &Aabb, theirs: &Aabb, pose: &Pose2) -> f64 {
    apart(ours, &theirs.transform_by(pose))
}

/// Distance of two boxes.
fn apart(a: &Aabb, b: &Aabb) -> f64 {
    (a.mins - b.maxs)
        .max(b.mins - a.maxs)
        .max(Vector::ZERO)
        .length()
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

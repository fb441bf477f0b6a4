//! Closed polygons: area, centroid and winding number; the nearest point and the side on which a point lies.

use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// Each corner and the next, about the first one.
fn sides(corners: &[Point2<f64>]) -> impl Iterator<Item = [Vector2<f64>; 2]> {
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().zip(next);
    sides.map(|(a, b)| [a - corners[0], b - corners[0]])
}

/// The enclosed area, mm²; negative if clockwise.
pub fn area(corners: &[Point2<f64>]) -> f64 {
    sides(corners).map(|[a, b]| 0.5 * a.perp(&b)).sum()
}

/// The centroid of the area; `None` without area.
pub fn centroid(corners: &[Point2<f64>]) -> Option<Point2<f64>> {
    let (mut twice, mut moment) = (0.0, Vector2::zeros());
    for [a, b] in sides(corners) {
        twice += a.perp(&b);
        moment += (a + b) * (a.perp(&b) / 3.0);
    }
    (twice != 0.0).then(|| corners[0] + moment / twice)
}

/// The winding number about `point`, counter-clockwise positive. The point is on no side.
pub fn winding(corners: &[Point2<f64>], point: Point2<f64>) -> i32 {
    let turns = sides(corners).map(|side| {
        let [a, b] = side.map(|corner| corners[0] + corner - point);
        a.perp(&b).atan2(a.dot(&b))
    });
    (turns.sum::<f64>() / TAU).round() as i32
}

/// Most edges in a leaf: testing a box takes as long as testing an edge.
const LEAF: usize = 4;

/// A closed polygon, counter-clockwise, with a tree of bounding boxes of its edges.
#[derive(Debug)]
pub(super) struct Boundary {
    corners: Vec<Point2<f64>>,
    /// Least and greatest corner of each node. Node k has the children 2 k and 2 k + 1; node 1 contains all edges.
    boxes: Vec<[Point2<f64>; 2]>,
}

/// The point of a polygon nearest to a given point.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestPoint {
    /// Index of the edge, by its first corner.
    pub edge: usize,
    pub point: Point2<f64>,
    /// Distance from the given point, mm; positive if that lies inside, in the metal.
    pub signed: f64,
    /// Unit vector out of the metal in the direction of the distance.
    pub normal: Vector2<f64>,
}

impl Boundary {
    /// The polygon through `corners` (at least one), in either direction.
    pub fn new(mut corners: Vec<Point2<f64>>) -> Boundary {
        if area(&corners) < 0.0 {
            corners.reverse();
        }
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        let mut boundary = Boundary {
            boxes: vec![[Point2::origin(); 2]; 4 * corners.len().max(1)],
            corners,
        };
        boundary.enclose(1, 0, boundary.corners.len());
        boundary
    }

    /// The corners.
    pub fn corners(&self) -> &[Point2<f64>] {
        &self.corners
    }

    /// The ends of an edge.
    pub fn ends(&self, edge: usize) -> [Point2<f64>; 2] {
        [
            self.corners[edge],
            self.corners[(edge + 1) % self.corners.len()],
        ]
    }

    /// The unit normal of an edge, out of the metal.
    pub fn normal(&self, edge: usize) -> Vector2<f64> {
        let [from, to] = self.ends(edge);
        let along = to - from;
        Vector2::new(along.y, -along.x).normalize()
    }

    /// Distance of an edge from `point`, mm.
    pub fn distance_of_edge(&self, edge: usize, point: Point2<f64>) -> f64 {
        (point - self.foot(edge, point)).norm()
    }

    fn foot(&self, edge: usize, point: Point2<f64>) -> Point2<f64> {
        let [from, to] = self.ends(edge);
        let along = to - from;
        let share = (point - from).dot(&along) / along.norm_squared();
        match share {
            ..=0.0 => from,
            1.0.. => to,
            share => from + along * share,
        }
    }

    /// The point nearest to `point`.
    pub fn nearest(&self, point: Point2<f64>) -> NearestPoint {
        let mut best = (f64::INFINITY, 0);
        self.search(1, 0, self.corners.len(), point, &mut best);
        let (_, edge) = best;
        let foot = self.foot(edge, point);
        let [from, to] = self.ends(edge);
        let count = self.corners.len();
        // At a corner the sum of both edges' normals decides the side.
        let outwards = match foot {
            foot if foot == from => self.normal(edge) + self.normal((edge + count - 1) % count),
            foot if foot == to => self.normal(edge) + self.normal((edge + 1) % count),
            _ => self.normal(edge),
        };
        let off = point - foot;
        let (distance, side) = (off.norm(), off.dot(&outwards));
        let (signed, normal) = match (distance > 0.0, side > 0.0) {
            (false, _) => (0.0, self.normal(edge)),
            (true, true) => (-distance, off / distance),
            (true, false) => (distance, -off / distance),
        };
        NearestPoint {
            edge,
            point: foot,
            signed,
            normal,
        }
    }

    /// Updates `best`, squared distance and edge, with the edges `from` to `to`.
    fn search(
        &self,
        node: usize,
        from: usize,
        to: usize,
        point: Point2<f64>,
        best: &mut (f64, usize),
    ) {
        if to - from <= LEAF {
            for edge in from..to {
                let distance = (point - self.foot(edge, point)).norm_squared();
                if distance < best.0 {
                    *best = (distance, edge);
                }
            }
            return;
        }
        let middle = (from + to) / 2;
        let mut halves = [(2 * node, from, middle), (2 * node + 1, middle, to)];
        let away = |node: usize| {
            let [low, high] = self.boxes[node];
            let inside = point.sup(&low).inf(&high);
            (point - inside).norm_squared()
        };
        if away(2 * node + 1) < away(2 * node) {
            halves.reverse();
        }
        for (node, from, to) in halves {
            if away(node) < best.0 {
                self.search(node, from, to, point, best);
            }
        }
    }

    fn enclose(&mut self, node: usize, from: usize, to: usize) -> [Point2<f64>; 2] {
        let join = |a: [Point2<f64>; 2], b: [Point2<f64>; 2]| [a[0].inf(&b[0]), a[1].sup(&b[1])];
        let all = if to - from <= LEAF {
            let ends = (from..=to).map(|k| [self.corners[k % self.corners.len()]; 2]);
            ends.reduce(join).unwrap_or([Point2::origin(); 2])
        } else {
            let middle = (from + to) / 2;
            let halves = [
                self.enclose(2 * node, from, middle),
                self.enclose(2 * node + 1, middle, to),
            ];
            join(halves[0], halves[1])
        };
        self.boxes[node] = all;
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: half of base times height, and a third of the sum of the corners.
    #[test]
    fn a_triangle() {
        let corners = [[10.0, 20.0], [16.0, 20.0], [10.0, 29.0]].map(Point2::from);
        let back = [corners[2], corners[1], corners[0]];
        let inside = Point2::new(11.0, 21.0);
        for (corners, sense) in [(&corners, 1), (&back, -1)] {
            assert_eq!(area(corners), 27.0 * f64::from(sense));
            assert_eq!(centroid(corners), Some(Point2::new(12.0, 23.0)));
            assert_eq!(winding(corners, inside), sense);
            assert_eq!(winding(corners, Point2::origin()), 0);
        }
        assert_eq!(centroid(&corners[..2]), None);
    }

    /// Source: each edge by itself, and the winding number for the side.
    #[test]
    fn the_nearest_of_a_star_is_that_of_all_its_edges() {
        let corner = |k: u32| {
            let radius = if k.is_multiple_of(2) { 3.0 } else { 1.0 };
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 22.0).sin_cos();
            Point2::new(radius * cos, radius * sin)
        };
        let corners: Vec<Point2<f64>> = (0..22).map(corner).collect();
        let back = corners.iter().rev().copied().collect();
        for star in [corners, back].map(Boundary::new) {
            for k in 0..1600 {
                let point = Point2::new(
                    f64::from(k % 40) * 0.2 - 3.93,
                    f64::from(k / 40) * 0.2 - 3.97,
                );
                let near = star.nearest(point);
                let each = (0..22).map(|edge| star.distance_of_edge(edge, point));
                let least = each.fold(f64::INFINITY, f64::min);
                assert!((near.signed.abs() - least).abs() < 1e-12);
                let inside = winding(star.corners(), point) == 1;
                assert_eq!(near.signed > 0.0, inside, "{point}");
                assert!((point + near.normal * near.signed - near.point).norm() < 1e-12);
            }
        }
    }
}

//! The nearest place on a closed polygon, and on which side of it a point lies.

use super::polygon;
use nalgebra::{Point2, Vector2};

/// Up to so many edges are looked at one by one: a box takes as long as an edge.
const LEAF: usize = 4;

/// A closed polygon, counter-clockwise, in boxes of boxes of neighbouring edges.
#[derive(Debug)]
pub(super) struct Boundary {
    corners: Vec<Point2<f64>>,
    /// Of each node its least and greatest corner; node k has the children 2 k and 2 k + 1, node 1 has all edges.
    boxes: Vec<[Point2<f64>; 2]>,
}

/// A place on the polygon.
#[derive(Debug, Clone, Copy)]
pub(super) struct Near {
    /// From which corner to the next.
    pub edge: usize,
    pub point: Point2<f64>,
    /// From the point asked for, mm; positive where that lies inside, in the metal.
    pub signed: f64,
    /// Unit vector out of the metal, along which that is measured.
    pub normal: Vector2<f64>,
}

impl Boundary {
    /// Through `corners`, in either direction; at least one.
    pub fn new(mut corners: Vec<Point2<f64>>) -> Boundary {
        if polygon::area(&corners) < 0.0 {
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

    /// Its corners.
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

    /// The place nearest to `point`.
    pub fn nearest(&self, point: Point2<f64>) -> Near {
        let mut best = (f64::INFINITY, 0);
        self.search(1, 0, self.corners.len(), point, &mut best);
        let (_, edge) = best;
        let foot = self.foot(edge, point);
        let [from, to] = self.ends(edge);
        let count = self.corners.len();
        // At a corner the edges on both sides say which side it is: only the sum of their normals is sure to.
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
        Near {
            edge,
            point: foot,
            signed,
            normal,
        }
    }

    /// Squared distance and edge of the nearest of the edges `from` to `to`, where nearer than `best`.
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

    /// Source: each edge by itself, and the winding number for the side.
    #[test]
    fn the_nearest_of_a_star_is_that_of_all_its_edges() {
        let corner = |k: u32| {
            let radius = if k.is_multiple_of(2) { 3.0 } else { 1.0 };
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 22.0).sin_cos();
            Point2::new(radius * cos, radius * sin)
        };
        let mut corners: Vec<Point2<f64>> = (0..22).map(corner).collect();
        for _ in 0..2 {
            let star = Boundary::new(corners.clone());
            for k in 0..1600 {
                let point = Point2::new(
                    f64::from(k % 40) * 0.2 - 3.93,
                    f64::from(k / 40) * 0.2 - 3.97,
                );
                let near = star.nearest(point);
                let each = (0..22).map(|edge| star.distance_of_edge(edge, point));
                let least = each.fold(f64::INFINITY, f64::min);
                assert!((near.signed.abs() - least).abs() < 1e-12);
                let inside = polygon::winding(star.corners(), point) == 1;
                assert_eq!(near.signed > 0.0, inside, "{point}");
                assert!((point + near.normal * near.signed - near.point).norm() < 1e-12);
            }
            corners.reverse();
        }
    }
}

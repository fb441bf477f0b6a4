//! The overlap of two outlines: the common pieces of two polygons.
//!
//! Method: Weiler and Atherton (1977). From every point at which the first boundary enters the second polygon, walk
//! along the first boundary to its exit, then along the second to the next entry. Polygons that touch in a vertex may
//! give a piece without area or lose one; nested ones give nothing.

use crate::numeric::rank;
use nalgebra::Point2;

/// One piece of metal in both gears.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlap {
    /// Its boundary, mm, counter-clockwise.
    pub outline: Vec<Point2<f64>>,
    /// Its area, mm².
    pub area: f64,
}

impl Overlap {
    fn new(outline: Vec<Point2<f64>>) -> Overlap {
        // Relative to the first vertex: coordinates of metres would lose the digits of a thin piece.
        let from = outline[0];
        let next = outline.iter().cycle().skip(1);
        let twice: f64 = outline
            .iter()
            .zip(next)
            .map(|(p, q)| (p - from).perp(&(q - from)))
            .sum();
        Overlap {
            area: 0.5 * twice,
            outline,
        }
    }

    /// Mean width of a long thin piece, mm: `2 A/U`.
    pub fn width(&self) -> f64 {
        let next = self.outline.iter().cycle().skip(1);
        let around: f64 = self
            .outline
            .iter()
            .zip(next)
            .map(|(p, q)| (q - p).norm())
            .sum();
        2.0 * self.area / around
    }

    /// Distance of `point` from the nearest vertex, mm.
    pub fn distance(&self, point: Point2<f64>) -> f64 {
        let distances = self.outline.iter().map(|vertex| (vertex - point).norm());
        distances.fold(f64::INFINITY, f64::min)
    }
}

/// An intersection of both boundaries.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// Edge of each polygon, and the part of it before the intersection.
    edges: [usize; 2],
    parts: [f64; 2],
    at: Point2<f64>,
    /// Whether the first boundary enters the second polygon here.
    enters: bool,
}

/// The common pieces of two closed counter-clockwise polygons.
pub fn overlaps(first: &[Point2<f64>], second: &[Point2<f64>]) -> Vec<Overlap> {
    let crossings = crossings(first, second);
    let next = [0, 1].map(|which| following(&crossings, which));
    let mut walked = vec![false; crossings.len()];
    let mut pieces = Vec::new();
    for start in 0..crossings.len() {
        if !crossings[start].enters || walked[start] {
            continue;
        }
        let (mut outline, mut here) = (Vec::new(), start);
        let closed = loop {
            walked[here] = true;
            let leaves = next[0][here];
            walk(first, &crossings, [here, leaves], 0, &mut outline);
            here = next[1][leaves];
            walk(second, &crossings, [leaves, here], 1, &mut outline);
            if here == start {
                break true;
            }
            if walked[here] || !crossings[here].enters {
                break false;
            }
        };
        if closed {
            pieces.push(Overlap::new(outline));
        }
    }
    pieces
}

/// Adds the boundary of `polygon` number `which`, from one crossing to the next.
fn walk(
    polygon: &[Point2<f64>],
    crossings: &[Crossing],
    [from, to]: [usize; 2],
    which: usize,
    outline: &mut Vec<Point2<f64>>,
) {
    let (from, to) = (&crossings[from], &crossings[to]);
    outline.push(from.at);
    let (first, last) = (from.edges[which], to.edges[which]);
    let once_round = first == last && from.parts[which] >= to.parts[which];
    let count = if once_round {
        polygon.len()
    } else {
        (last + polygon.len() - first) % polygon.len()
    };
    let vertices = (1..=count).map(|step| polygon[(first + step) % polygon.len()]);
    outline.extend(vertices);
}

/// The next crossing along one boundary, for each crossing.
fn following(crossings: &[Crossing], which: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..crossings.len()).collect();
    // By their edges, those of one edge by their parts of it.
    order.sort_by_cached_key(|&i| rank(crossings[i].parts[which]));
    order.sort_by_cached_key(|&i| crossings[i].edges[which] as u64);
    let mut next = vec![0; order.len()];
    for (place, &crossing) in order.iter().enumerate() {
        next[crossing] = order[(place + 1) % order.len()];
    }
    next
}

/// Every crossing, found by a line that sweeps upwards over both boundaries.
fn crossings(first: &[Point2<f64>], second: &[Point2<f64>]) -> Vec<Crossing> {
    let polygons = [first, second];
    let edge = |which: usize, i: usize| {
        let polygon: &[Point2<f64>] = polygons[which];
        [polygon[i], polygon[(i + 1) % polygon.len()]]
    };
    let mut edges: Vec<(f64, f64, usize, usize)> = Vec::new();
    for (which, polygon) in polygons.iter().enumerate() {
        edges.extend((0..polygon.len()).map(|i| {
            let [from, to] = edge(which, i);
            (from.y.min(to.y), from.y.max(to.y), which, i)
        }));
    }
    edges.sort_by_cached_key(|edge| rank(edge.0));
    let mut open: [Vec<(f64, usize)>; 2] = [Vec::new(), Vec::new()];
    let mut found = Vec::new();
    for (low, high, which, i) in edges {
        let others = &mut open[1 - which];
        others.retain(|(top, _)| *top >= low);
        for &(_, j) in others.iter() {
            let pair = if which == 0 { [i, j] } else { [j, i] };
            found.extend(crossing(edge(0, pair[0]), edge(1, pair[1]), pair));
        }
        open[which].push((high, i));
    }
    found
}

fn crossing(a: [Point2<f64>; 2], b: [Point2<f64>; 2], edges: [usize; 2]) -> Option<Crossing> {
    let left_of =
        |line: &[Point2<f64>; 2], point: Point2<f64>| (line[1] - line[0]).perp(&(point - line[0]));
    let of_a = a.map(|end| left_of(&b, end));
    let of_b = b.map(|end| left_of(&a, end));
    // An end on the other line counts as left of it, so that a boundary crosses once there.
    let parted = |[from, to]: [f64; 2]| (from >= 0.0) != (to >= 0.0);
    if !(parted(of_a) && parted(of_b)) {
        return None;
    }
    let parts = [of_a, of_b].map(|[from, to]| from / (from - to));
    Some(Crossing {
        edges,
        parts,
        at: a[0] + parts[0] * (a[1] - a[0]),
        enters: of_a[1] >= 0.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn polygon(points: &[[f64; 2]]) -> Vec<Point2<f64>> {
        points.iter().map(|point| Point2::from(*point)).collect()
    }

    fn square(at: f64) -> Vec<Point2<f64>> {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        polygon(&corners.map(|corner| corner.map(|x| x + at)))
    }

    fn circle(x: f64) -> Vec<Point2<f64>> {
        let angle = |i: u32| f64::from(i) * TAU / 10_000.0 + 0.1;
        (0..10_000)
            .map(|i| Point2::new(x + angle(i).cos(), angle(i).sin()))
            .collect()
    }

    /// Two unit squares offset by a quarter in both directions share 9/16; a comb and a bar share one piece per tooth. Two unit circles a
    /// distance 1 apart share 2π/3 − √3/2: an inscribed polygon of n corners lacks the part 2π²/(3 n²) of its circle.
    #[test]
    fn pieces_have_the_area_of_elementary_geometry() {
        let comb = [
            [0.0, -1.0],
            [5.0, -1.0],
            [5.0, 1.0],
            [4.0, 1.0],
            [4.0, 0.0],
            [3.0, 0.0],
            [3.0, 1.0],
            [2.0, 1.0],
            [2.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
        ];
        let bar = [[-1.0, 0.5], [6.0, 0.5], [6.0, 2.0], [-1.0, 2.0]];
        let lens = 2.0 * PI / 3.0 - 0.5 * 3f64.sqrt();
        for (one, other, expected, within) in [
            (square(0.0), square(0.25), vec![0.5625], 0.0),
            (square(0.25), square(0.0), vec![0.5625], 0.0),
            (square(0.0), square(3.0), vec![], 0.0),
            (polygon(&comb), polygon(&bar), vec![0.5; 3], 0.0),
            (circle(0.0), circle(1.0), vec![lens], 1e-6),
        ] {
            let pieces = overlaps(&one, &other);
            assert_eq!(pieces.len(), expected.len());
            for (piece, area) in pieces.iter().zip(expected) {
                let off = (piece.area - area).abs();
                assert!(off <= within, "{} of {area}", piece.area);
            }
        }
    }
}

//! Comparison of two outlines, A and B, of one gear.
//!
//! The deviation at a point of A is its distance from the nearest point of B, positive where B has more metal. B is turned about its
//! centre to the least mean square of the deviations. A gear fits itself nearly as well after a turn by whole teeth, so every such
//! turn is tried. Both centres stay: an eccentricity between the outlines appears as deviation.
//!
//! Curves become chords. Mean and root mean square use the midpoint rule on short pieces of A. Greatest and least deviation cover all
//! points of A's chords: along a chord the distance from an edge of B is convex, so its greater end bounds it.

use super::gear::OutlineGear;
use super::polygon::{Boundary, NearestPoint};
use crate::error::OutlineError;
use crate::numeric::wrap_angle;
use crate::parallel;
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::{PI, TAU};

/// Least number of pieces per tooth for mean and root mean square. Tuned: a chord of 1 mm at module 2 has some 75 pieces; the error
/// of the mean is less than 1e-4 of the arc's height.
const PIECES: u32 = 1000;

/// Limit of the total number of pieces: a large gear takes some seconds.
const MOST_PIECES: u32 = 1_000_000;

/// Pieces per tooth for the choice of the turn. Tuned: a tooth 0.5 µm thicker is found among 80 drawn with chords of 1 µm.
const CHOOSING: u32 = 40;

/// Turns within this root mean square, mm, fit equally well: rounding of a drawing's decimals.
const EQUAL_FIT: f64 = 1e-6;

/// Most steps of the turn. Tuned: for similar outlines each leaves a small share of the error.
const STEPS: u32 = 12;

/// A smaller step of the turn, rad, is rounding.
const SETTLED: f64 = 1e-14;

/// Deviation of B from A at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Point of A from its centre, in the frame of its drawing, mm.
    pub point: Point2<f64>,
    /// Unit normal of A there, out of the metal.
    pub normal: Vector2<f64>,
    /// Distance of B beyond A, mm; negative where B has less metal.
    pub beyond: f64,
    /// A's tooth with the nearest even place, 1 to z.
    pub tooth: u32,
}

/// Deviations of outline B, turned to fit outline A.
#[derive(Debug, Clone)]
pub struct OutlineDifference {
    /// Turn of B's drawing about its centre, rad counter-clockwise, −π to π.
    pub rotation: f64,
    /// B's tooth that lies on A's tooth 1.
    pub tooth: u32,
    /// Number of turns by whole teeth that fit equally well, including this one, the least of them.
    pub alike: u32,
    /// Mean deviation, mm.
    pub mean: f64,
    /// Root of the mean square of the deviations, mm.
    pub root_mean_square: f64,
    /// The greatest deviation.
    pub greatest: Deviation,
    /// The least deviation.
    pub least: Deviation,
    /// Error bound of each deviation, mm: both outlines' bounds and their chords. For a gear given by data add 1e-6 of its tip radius.
    pub bound: f64,
    /// Deviations at short distances along A, counter-clockwise.
    pub along: Vec<Deviation>,
}

/// A point of A's chords and the nearest point of B.
#[derive(Clone, Copy)]
struct ComparedPoint {
    point: Point2<f64>,
    near: NearestPoint,
}

/// The middle of a piece of A's chords.
struct Midpoint {
    edge: usize,
    point: Point2<f64>,
    /// The piece's share of the whole length.
    share: f64,
}

/// The polygons of A and B.
struct Boundaries {
    a: Boundary,
    b: Boundary,
}

impl OutlineDifference {
    /// Deviations of `b` from `a`, with curves replaced by chords within `chordal_error` mm (> 0).
    ///
    /// # Errors
    /// [`OutlineError::OtherGear`]: the numbers of teeth differ.
    pub fn new(
        a: &OutlineGear,
        b: &OutlineGear,
        chordal_error: f64,
    ) -> Result<OutlineDifference, OutlineError> {
        let teeth = [a.teeth(), b.teeth()];
        if teeth[0] != teeth[1] {
            return Err(OutlineError::OtherGear { teeth });
        }
        let [z, _] = teeth;
        let drawn =
            |gear: &OutlineGear| Boundary::new(gear.points(gear.drawn_direction(), chordal_error));
        let both = Boundaries {
            a: drawn(a),
            b: drawn(b),
        };
        let first = a.drawn_direction() - b.drawn_direction();
        let turn = |k: u32| wrap_angle(first + f64::from(k) * a.pitch());
        let (near, _) = both.fit_turn(&both.points(z * CHOOSING), turn(0));
        let squares = both.mean_squares_of_turns(a, near);
        let least = squares.iter().copied().fold(f64::INFINITY, f64::min);
        let alike = |k: &u32| squares[*k as usize].sqrt() <= least.sqrt() + EQUAL_FIT;
        let alike: Vec<u32> = (0..z).filter(alike).collect();
        let chosen = alike.iter().copied();
        let chosen = chosen.min_by(|j, k| turn(*j).abs().total_cmp(&turn(*k).abs()));
        let chosen = turn(chosen.unwrap_or(0)) + near - turn(0);
        let points = both.points((z * PIECES).min(MOST_PIECES));
        let (rotation, square) = both.fit_turn(&points, chosen);
        let tooth_of = |point: Point2<f64>, direction: f64| {
            let on = (point.y.atan2(point.x) - direction) * a.face().ascending();
            (on / a.pitch()).round().rem_euclid(f64::from(z)) as u32 % z + 1
        };
        let deviation = |edge: usize, sample: ComparedPoint| Deviation {
            point: sample.point,
            normal: both.a.normal(edge),
            beyond: sample.near.signed,
            tooth: tooth_of(sample.point, a.drawn_direction()),
        };
        let along: Vec<Deviation> = parallel::map(points.iter(), |at| {
            deviation(at.edge, both.compare_point(at.point, rotation))
        });
        let found = points.iter().zip(&along);
        let mean = found.map(|(at, found)| at.share * found.beyond).sum();
        let corners: Vec<ComparedPoint> = parallel::map(both.a.corners().iter(), |point| {
            both.compare_point(*point, rotation)
        });
        let [greatest, least] = [1.0, -1.0].map(|sign| {
            let (edge, sample) = both.farthest(&corners, rotation, sign, chordal_error);
            deviation(edge, sample)
        });
        let towards = Rotation2::new(rotation) * Vector2::new(1.0, 0.0);
        let on_first = a.drawn_direction() - towards.y.atan2(towards.x);
        let (sin, cos) = on_first.sin_cos();
        Ok(OutlineDifference {
            rotation: rotation - TAU * ((rotation + PI) / TAU).floor(),
            tooth: tooth_of(Point2::new(cos, sin), b.drawn_direction()),
            alike: alike.len() as u32,
            mean,
            root_mean_square: square.sqrt(),
            greatest,
            least,
            bound: a.bound() + b.bound() + 3.0 * chordal_error,
            along,
        })
    }
}

impl Boundaries {
    /// Midpoints of at least `count` pieces of A. No piece crosses a corner.
    fn points(&self, count: u32) -> Vec<Midpoint> {
        let edges = 0..self.a.corners().len();
        let length = |edge: usize| {
            let [from, to] = self.a.ends(edge);
            (to - from).norm()
        };
        let all: f64 = edges.clone().map(length).sum();
        let of_edge = |edge: usize| {
            let [from, to] = self.a.ends(edge);
            let share = length(edge) / all;
            let pieces = (share * f64::from(count)).ceil();
            (0..pieces as u32).map(move |k| Midpoint {
                edge,
                point: from + (to - from) * ((f64::from(k) + 0.5) / pieces),
                share: share / pieces,
            })
        };
        edges.flat_map(of_edge).collect()
    }

    /// The mean square of the deviations with B turned by `turn` plus each whole number of teeth, 0 to z − 1, to first order.
    ///
    /// The points of tooth 1 of A are rotated to each other tooth, where A and B have the distances `a_j` and `b_j`. After a turn by k
    /// teeth the deviation is `b_(j−k) − a_j`. Its mean square depends on `k` only by the sum of the products `a_j b_(j−k)`.
    fn mean_squares_of_turns(&self, a: &OutlineGear, turn: f64) -> Vec<f64> {
        let z = a.teeth() as usize;
        let half_pitch = 0.5 * a.pitch();
        let (sin, cos) = a.drawn_direction().sin_cos();
        let on_first = |at: &Midpoint| {
            let along = Vector2::new(cos, sin);
            let point = at.point.coords;
            along.perp(&point).atan2(along.dot(&point)).abs() <= half_pitch
        };
        let mut points = self.points(a.teeth() * CHOOSING);
        points.retain(on_first);
        let all: f64 = points.iter().map(|at| at.share).sum();
        let teeth = parallel::map(0..z, |j| {
            let there = Rotation2::new(j as f64 * a.pitch());
            let of = |at: &Midpoint| {
                let point = there * at.point;
                let weight = (at.share / (all * z as f64)).sqrt();
                let off = [self.a.nearest(point), self.compare_point(point, turn).near];
                off.map(|near| weight * near.signed)
            };
            points.iter().map(of).collect::<Vec<[f64; 2]>>()
        });
        let [a_off, b_off] = [0, 1].map(|of| -> Vec<f64> {
            let values = teeth.iter().flatten().map(|off| off[of]);
            values.collect()
        });
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let squares = product(&a_off, &a_off) + product(&b_off, &b_off);
        parallel::map(0..z, |k| {
            // Tooth j takes the values of tooth j − k.
            let (head, tail) = a_off.split_at(k * points.len());
            let (before, after) = b_off.split_at(b_off.len() - head.len());
            (squares - 2.0 * (product(tail, before) + product(head, after))).max(0.0)
        })
    }

    /// The point of B, turned by `turn`, nearest to a point of A.
    fn compare_point(&self, point: Point2<f64>, turn: f64) -> ComparedPoint {
        ComparedPoint {
            point,
            near: self.b.nearest(Rotation2::new(-turn) * point),
        }
    }

    /// The turn near `turn` with the least mean square of the deviations at `points`, and that mean square (Gauss–Newton).
    fn fit_turn(&self, points: &[Midpoint], turn: f64) -> (f64, f64) {
        let (mut best, mut turn) = ((turn, f64::INFINITY), turn);
        for _ in 0..STEPS {
            let (mut square, mut product, mut arms) = (0.0, 0.0, 0.0);
            for at in points {
                let NearestPoint {
                    point,
                    signed,
                    normal,
                    ..
                } = self.compare_point(at.point, turn).near;
                // A turn by δ moves the metal by δ times the arm of its normal.
                let arm = point.coords.perp(&normal);
                square += at.share * signed * signed;
                product += at.share * signed * arm;
                arms += at.share * arm * arm;
            }
            if square < best.1 {
                best = (turn, square);
            }
            let step = -product / arms;
            if !(step.abs() > SETTLED) {
                break;
            }
            turn += step;
        }
        best
    }

    /// The point of A with the greatest deviation, or the least if `sign` is −1, within `tolerance` mm, and its edge.
    fn farthest(
        &self,
        corners: &[ComparedPoint],
        turn: f64,
        sign: f64,
        tolerance: f64,
    ) -> (usize, ComparedPoint) {
        let value = |sample: &ComparedPoint| sign * sample.near.signed;
        let mut best = (0, corners[0]);
        let mut look = |edge: usize, sample: ComparedPoint| {
            if value(&sample) > value(&best.1) {
                best = (edge, sample);
            }
            value(&best.1)
        };
        for (edge, sample) in corners.iter().enumerate() {
            look(edge, *sample);
        }
        // Without a crossing, the two nearest points are a corner of one outline and a point of the other.
        for corner in self.b.corners() {
            let near = self.a.nearest(Rotation2::new(turn) * corner);
            look(near.edge, self.compare_point(near.point, turn));
        }
        let count = corners.len();
        let mut open: Vec<(usize, [ComparedPoint; 2])> = (0..count)
            .map(|edge| (edge, [corners[edge], corners[(edge + 1) % count]]))
            .collect();
        let back = Rotation2::new(-turn);
        while let Some((edge, [from, to])) = open.pop() {
            let length = (to.point - from.point).norm();
            // A deviation changes by no more than the distance along A.
            let mut most = 0.5 * (value(&from) + value(&to) + length);
            for of in [from.near.edge, to.near.edge] {
                let ends = [from, to].map(|end| self.b.distance_of_edge(of, back * end.point));
                most = most.min(ends[0].max(ends[1]));
            }
            let known = look(edge, from);
            // The corners decide below zero.
            if most <= known + tolerance || known < 0.0 || length <= tolerance {
                continue;
            }
            let middle = self.compare_point(from.point + 0.5 * (to.point - from.point), turn);
            look(edge, middle);
            open.push((edge, [from, middle]));
            open.push((edge, [middle, to]));
        }
        best
    }
}

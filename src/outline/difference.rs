//! Two outlines of one gear: how far one lies from the other.
//!
//! The deviation at a point of A's outline is its distance from the nearest point of B's, along B's normal there, positive where B has
//! more metal. B is turned about its centre so that the mean square of the deviations is least; a gear lies nearly as well on itself turned
//! by any whole tooth, so each is tried. Both centres stay where they are: what eccentricity there is between the outlines is shown as
//! deviation.
//!
//! Curves are taken as chords. Mean and root mean square are over its length, by the middles of short pieces (midpoint rule); greatest
//! and least are those of all points of A's chords: from one point of a chord to another the distance from any one edge of B is convex, so
//! that its greater end bounds it.

use super::boundary::{Boundary, Near};
use super::error::OutlineError;
use super::gear::OutlineGear;
use crate::numeric::wrap_angle;
use crate::parallel;
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::{PI, TAU};

/// Pieces a tooth, or more, for mean and root mean square (tuned: of a chord 1 mm long, at module 2, some 75: the mean of what lies between
/// it and its arc is off by less than 1e-4 of the arc's height).
const PIECES: u32 = 1000;

/// Pieces in all, or more, where teeth are many: what a large gear takes is some seconds.
const MOST_PIECES: u32 = 1_000_000;

/// Pieces a tooth by which one tooth is chosen before another (tuned: a tooth 0.5 µm thicker is found among 80 drawn with chords of 1 µm).
const CHOOSING: u32 = 40;

/// Turns that fit as well within this root mean square, mm, are not distinguished: rounding of a drawing's decimals.
const ALIKE: f64 = 1e-6;

/// Steps of the turn at most (tuned): of outlines that are near each other each leaves a small share of what was left.
const STEPS: u32 = 12;

/// A step of the turn, rad, that is none: rounding.
const SETTLED: f64 = 1e-14;

/// How far B lies from A somewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Where on A: from its centre, as its drawing lies, mm.
    pub point: Point2<f64>,
    /// Unit normal of A there, out of the metal.
    pub normal: Vector2<f64>,
    /// How far B lies beyond it, mm; negative where B has less metal.
    pub beyond: f64,
    /// A's tooth whose even place is nearest, 1 to z.
    pub tooth: u32,
}

/// Two outlines of one gear, B turned to lie on A as well as it can.
#[derive(Debug, Clone)]
pub struct OutlineDifference {
    /// Turn of B's drawing about its centre, rad counter-clockwise, −π to π.
    pub rotation: f64,
    /// B's tooth that comes to lie on A's tooth 1.
    pub tooth: u32,
    /// How many turns by whole teeth fit as well, this one included; of these it is the least turn.
    pub alike: u32,
    /// Mean deviation, mm.
    pub mean: f64,
    /// Root of the mean square of the deviations, mm.
    pub root_mean_square: f64,
    /// Where B lies farthest beyond A.
    pub greatest: Deviation,
    /// Where B lies farthest within A.
    pub least: Deviation,
    /// How far each deviation may be off, mm: both outlines' bounds and their chords (of a gear by its data add 1e-6 of its tip radius).
    pub bound: f64,
    /// At short distances along A, counter-clockwise.
    pub along: Vec<Deviation>,
}

/// A point of A's chords, and the place of B that is nearest.
#[derive(Clone, Copy)]
struct ComparedPoint {
    point: Point2<f64>,
    near: Near,
}

/// The middle of a piece of A's chords.
struct Midpoint {
    edge: usize,
    point: Point2<f64>,
    /// The piece's share of the length of all.
    share: f64,
}

struct Both {
    a: Boundary,
    b: Boundary,
}

impl OutlineDifference {
    /// How far `b` lies from `a`, curves taken as chords within `chord` mm (> 0).
    ///
    /// # Errors
    /// [`OutlineError::OtherGear`]: their numbers of teeth differ.
    pub fn new(
        a: &OutlineGear,
        b: &OutlineGear,
        chord: f64,
    ) -> Result<OutlineDifference, OutlineError> {
        let teeth = [a.teeth(), b.teeth()];
        if teeth[0] != teeth[1] {
            return Err(OutlineError::OtherGear { teeth });
        }
        let [z, _] = teeth;
        let drawn = |gear: &OutlineGear| Boundary::new(gear.points(gear.drawn_direction(), chord));
        let both = Both {
            a: drawn(a),
            b: drawn(b),
        };
        let first = a.drawn_direction() - b.drawn_direction();
        let turn = |k: u32| wrap_angle(first + f64::from(k) * a.pitch());
        let (near, _) = both.settle(&both.points(z * CHOOSING), turn(0));
        let squares = both.by_whole_teeth(a, near);
        let least = squares.iter().copied().fold(f64::INFINITY, f64::min);
        let alike = |k: &u32| squares[*k as usize].sqrt() <= least.sqrt() + ALIKE;
        let alike: Vec<u32> = (0..z).filter(alike).collect();
        let chosen = alike.iter().copied();
        let chosen = chosen.min_by(|j, k| turn(*j).abs().total_cmp(&turn(*k).abs()));
        let chosen = turn(chosen.unwrap_or(0)) + near - turn(0);
        let points = both.points((z * PIECES).min(MOST_PIECES));
        let (rotation, square) = both.settle(&points, chosen);
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
            deviation(at.edge, both.sample(at.point, rotation))
        });
        let shares = points
            .iter()
            .zip(&along)
            .map(|(at, found)| at.share * found.beyond);
        let mean = shares.sum();
        let corners: Vec<ComparedPoint> = parallel::map(both.a.corners().iter(), |point| {
            both.sample(*point, rotation)
        });
        let [greatest, least] = [1.0, -1.0].map(|sign| {
            let (edge, sample) = both.farthest(&corners, rotation, sign, chord);
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
            bound: a.bound() + b.bound() + 3.0 * chord,
            along,
        })
    }
}

impl Both {
    /// Points along A, the middles of so many equal lengths or more, none of which is of two chords.
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

    /// The mean square of the deviations with B turned by `turn` and each whole number of teeth more, 0 to z − 1 (to first order).
    ///
    /// The points of one tooth of A are carried to each other tooth. There A lies some `a_j` and B some `b_j` from the first; of a turn by k
    /// teeth more `b_(j−k) − a_j` is left, whose mean square needs of `k` but the sum of products `a_j b_(j−k)`.
    fn by_whole_teeth(&self, a: &OutlineGear, turn: f64) -> Vec<f64> {
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
                let off = [self.a.nearest(point), self.sample(point, turn).near];
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
            // What stands at a tooth was k teeth before.
            let (head, tail) = a_off.split_at(k * points.len());
            let (before, after) = b_off.split_at(b_off.len() - head.len());
            (squares - 2.0 * (product(tail, before) + product(head, after))).max(0.0)
        })
    }

    /// The place of B, turned by `turn`, nearest to a point of A.
    fn sample(&self, point: Point2<f64>, turn: f64) -> ComparedPoint {
        ComparedPoint {
            point,
            near: self.b.nearest(Rotation2::new(-turn) * point),
        }
    }

    /// The turn near `turn` with the least mean square of the deviations at `points`, and that mean square (Gauss–Newton).
    fn settle(&self, points: &[Midpoint], turn: f64) -> (f64, f64) {
        let (mut best, mut turn) = ((turn, f64::INFINITY), turn);
        for _ in 0..STEPS {
            let (mut square, mut product, mut arms) = (0.0, 0.0, 0.0);
            for at in points {
                let Near {
                    point,
                    signed,
                    normal,
                    ..
                } = self.sample(at.point, turn).near;
                // A turn by δ moves the metal by δ × the arm of its normal.
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

    /// The point of A at which B lies farthest beyond it, or with `sign` −1 within it, to within `tolerance` mm, and its edge.
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
        // Where nothing crosses, the nearest two points are a corner of either and a point of the other.
        for corner in self.b.corners() {
            let near = self.a.nearest(Rotation2::new(turn) * corner);
            look(near.edge, self.sample(near.point, turn));
        }
        let count = corners.len();
        let mut open: Vec<(usize, [ComparedPoint; 2])> = (0..count)
            .map(|edge| (edge, [corners[edge], corners[(edge + 1) % count]]))
            .collect();
        let back = Rotation2::new(-turn);
        while let Some((edge, [from, to])) = open.pop() {
            let length = (to.point - from.point).norm();
            // No deviation changes by more than one moves along.
            let mut most = 0.5 * (value(&from) + value(&to) + length);
            for of in [from.near.edge, to.near.edge] {
                let ends = [from, to].map(|end| self.b.distance_of_edge(of, back * end.point));
                most = most.min(ends[0].max(ends[1]));
            }
            let known = look(edge, from);
            // Below zero the corners have said it.
            if most <= known + tolerance || known < 0.0 || length <= tolerance {
                continue;
            }
            let middle = self.sample(from.point + 0.5 * (to.point - from.point), turn);
            look(edge, middle);
            open.push((edge, [from, middle]));
            open.push((edge, [middle, to]));
        }
        best
    }
}

#[cfg(test)]
mod tests;

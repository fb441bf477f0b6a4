//! Which teeth of an outline are equal, so that one of them stands for the others.

use super::half::{HalfOutline, HalfPiece};
use crate::gear::{PartCurve, Side};
use nalgebra::{Complex, Point2};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// Greatest distance of a tooth from the first one that it equals, mm: two such gears change a backlash by a hundredth of a micrometre.
const EQUAL: f64 = 2e-6;

/// The classes of equal teeth of a gear.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct ToothClasses {
    /// The first tooth that each tooth equals, at even places.
    first: Vec<u32>,
    /// Bound on the distance between two teeth of a class, mm.
    pub difference_bound: f64,
}

impl ToothClasses {
    /// The classes of half teeth on both sides, tooth 1 first, that are equal at their even places. `place` is the angle of a tooth's.
    ///
    /// The curves of equal teeth are of the same kinds in the same order.
    pub(super) fn of(halves: &[Arc<[HalfOutline]>; 2], place: impl Fn(f64) -> f64) -> ToothClasses {
        let equal = |one: u32, other: u32| {
            let between = place(f64::from(other)) - place(f64::from(one));
            let sides = Side::BOTH.map(|side| {
                let half = |tooth: u32| &halves[side.index()][tooth as usize - 1];
                // The left side is mirrored.
                let turn = Complex::from_polar(1.0, -side.sense() * between);
                half_difference(half(one), half(other), turn)
            });
            let [right, left] = sides;
            Some(right?.max(left?))
        };
        let mut firsts: Vec<u32> = Vec::new();
        let mut most: f64 = 0.0;
        let first = (1..=halves[0].len() as u32).map(|tooth| {
            let mut known = firsts.iter();
            let known = known.find_map(|&first| Some((first, equal(first, tooth)?)));
            let (first, difference) = known.unwrap_or((tooth, 0.0));
            if first == tooth {
                firsts.push(tooth);
            }
            most = most.max(difference);
            first
        });
        ToothClasses {
            first: first.collect(),
            // Both are that far from the first one.
            difference_bound: 2.0 * most,
        }
    }

    /// Each tooth is a class of its own.
    pub(super) fn each(teeth: u32) -> ToothClasses {
        ToothClasses {
            first: (1..=teeth).collect(),
            difference_bound: 0.0,
        }
    }

    /// The first tooth that `tooth` equals.
    pub fn first(&self, tooth: u32) -> u32 {
        self.first[tooth as usize - 1]
    }

    /// Whether all teeth are of one class.
    pub fn is_one(&self) -> bool {
        self.first.iter().all(|&first| first == 1)
    }
}

/// A bound on the distance between a half tooth turned by `turn` and another one, up to [`EQUAL`]; `None` where they are not equal.
fn half_difference(one: &HalfOutline, other: &HalfOutline, turn: Complex<f64>) -> Option<f64> {
    if one.pieces.len() != other.pieces.len() {
        return None;
    }
    let mut pieces = one.pieces.iter().zip(&other.pieces);
    pieces.try_fold(0.0, |most: f64, (one, other)| {
        let difference = piece_difference(one, other, turn)?;
        (difference <= EQUAL).then(|| most.max(difference))
    })
}

fn is_short_arc(piece: &HalfPiece) -> bool {
    let (low, high) = piece.range();
    matches!(piece.curve, PartCurve::Circle(_)) && high - low <= FRAC_PI_2
}

fn piece_difference(one: &HalfPiece, other: &HalfPiece, turn: Complex<f64>) -> Option<f64> {
    if one.corners != other.corners {
        return None;
    }
    let places = |piece: &HalfPiece| {
        let [from, to] = piece.ends;
        [from, 0.5 * (from + to), to].map(|t| piece.point(t))
    };
    let (own, others) = (places(one), places(other));
    let off = own.iter().zip(&others).map(|(a, b)| (turn * a - b).norm());
    let ends = off.fold(0.0, f64::max);
    // Between arcs of up to a quarter turn it is at most 1.3 times that of ends and middles.
    if [one, other].iter().all(|piece| is_short_arc(piece)) {
        return Some(1.3 * ends);
    }
    let (Some((points, radius)), Some((other_points, other_radius))) =
        (one.curve.moved_by(), other.curve.moved_by())
    else {
        let is_same = one.curve == other.curve && one.mirrored == other.mirrored;
        let farthest = others.iter().map(|point| point.norm()).fold(0.0, f64::max);
        return is_same.then(|| ends + (turn * one.turn - other.turn).norm() * farthest);
    };
    if points.len() != other_points.len() {
        return None;
    }
    let place = |piece: &HalfPiece, point: &Point2<f64>| {
        let point = Complex::new(point.x, point.y);
        piece.turn * if piece.mirrored { point.conj() } else { point }
    };
    let both = points.iter().zip(&other_points);
    let off = both.map(|(a, b)| (turn * place(one, a) - place(other, b)).norm());
    Some(ends + off.fold(0.0, f64::max) + (radius - other_radius).abs())
}

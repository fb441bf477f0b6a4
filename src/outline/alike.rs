//! Whether all teeth of an outline are equal, so that one of them stands for all.

use super::gear::OutlineGear;
use super::half::{HalfOutline, HalfPiece};
use crate::gear::{PartCurve, Side};
use nalgebra::{Complex, Point2};
use std::f64::consts::FRAC_PI_2;

/// Greatest distance of equal teeth, mm: two such gears change a backlash by a hundredth of a micrometre.
const EQUAL: f64 = 2e-6;

impl OutlineGear {
    /// The greatest distance, mm, between tooth 1 and another tooth at its even place; `None` where teeth are not equal, or the gear is eccentric.
    ///
    /// Their curves have to be of the same kinds in the same order.
    pub(crate) fn unlikeness(&self) -> Option<f64> {
        if self.eccentricity() > 0.0 {
            return None;
        }
        let mut most: f64 = 0.0;
        for side in Side::BOTH {
            let first = self.half(side, 1);
            for tooth in 2..=self.teeth() {
                // The left side is mirrored.
                let angle = -side.sense() * self.tooth_angle(f64::from(tooth));
                let turn = Complex::from_polar(1.0, angle);
                most = most.max(apart(first, self.half(side, tooth), turn)?);
                if most > EQUAL {
                    return None;
                }
            }
        }
        Some(most)
    }
}

/// A bound on the distance between a half tooth turned by `turn` and another one; `None` where the kinds of their curves differ.
fn apart(one: &HalfOutline, other: &HalfOutline, turn: Complex<f64>) -> Option<f64> {
    if one.pieces.len() != other.pieces.len() {
        return None;
    }
    let mut pieces = one.pieces.iter().zip(&other.pieces);
    pieces.try_fold(0.0, |most: f64, (one, other)| {
        Some(most.max(pieces_apart(one, other, turn)?))
    })
}

fn is_short_arc(piece: &HalfPiece) -> bool {
    let (low, high) = piece.range();
    matches!(piece.curve, PartCurve::Circle(_)) && high - low <= FRAC_PI_2
}

fn pieces_apart(one: &HalfPiece, other: &HalfPiece, turn: Complex<f64>) -> Option<f64> {
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
    let off = points
        .iter()
        .zip(&other_points)
        .map(|(a, b)| (turn * place(one, a) - place(other, b)).norm());
    Some(ends + off.fold(0.0, f64::max) + (radius - other_radius).abs())
}

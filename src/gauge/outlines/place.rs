//! The place of a half tooth that is foremost in a direction, or nearest to a point.
//!
//! Branch and bound over the pieces as drawn. `PartCurve::spread` bounds how far points and normals of a stretch stray from its middle:
//! where the normals cannot point the way sought, the best place is an end; elsewhere what a stretch may gain falls with the square of its
//! length, so some twenty halvings reach the last bits.

use crate::contact::{ToothPlace, Touch};
use crate::gear::Side;
use crate::outline::{HalfOutline, HalfPiece, OutlineGear};
use nalgebra::Complex;
use std::f64::consts::FRAC_PI_2;

type C = Complex<f64>;

/// Stretches looked at before the rest is left to the error bound (tuned: a seat needs some hundred; a pin of the very radius of the arc it
/// lies in would need millions).
const MOST_STRETCHES: usize = 20_000;

/// A normal that may turn so far, rad, bounds nothing yet.
const WIDE: f64 = 1.0;

/// What is sought, in the gear's own frame.
#[derive(Debug, Clone, Copy)]
pub(super) enum Sought {
    /// Foremost in the direction of this unit vector.
    Foremost(C),
    /// Nearest to this point.
    Nearest(C),
}

/// What was found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// In the gear's own frame.
    pub at: C,
    /// How far behind the line through the origin, or the distance, mm.
    pub value: f64,
    /// The least value is not below `value` by more, mm.
    pub missed: f64,
}

/// Bound, mm, on the rounding of a place: 64 ulps of the greatest radius.
pub(super) fn rounding(gear: &OutlineGear) -> f64 {
    64.0 * f64::EPSILON * gear.tip_radius()
}

impl Sought {
    /// What is to be least, mm.
    fn value(self, point: C) -> f64 {
        match self {
            Sought::Foremost(along) => -(along.conj() * point).re,
            Sought::Nearest(to) => (to - point).norm(),
        }
    }

    /// The direction, a unit vector, in which it falls fastest at `point`, and how far that turns within `d` mm of it, rad.
    fn falls(self, point: C, d: f64) -> (C, f64) {
        match self {
            Sought::Foremost(along) => (along, 0.0),
            Sought::Nearest(to) => {
                let distance = (to - point).norm();
                if distance > d {
                    ((to - point) / distance, (d / distance).asin())
                } else {
                    (C::ONE, FRAC_PI_2)
                }
            }
        }
    }

    /// The best place of `pieces` of a half tooth of `side`, to within `fine` mm.
    pub fn on(self, pieces: &[HalfPiece], side: Side, fine: f64) -> Place {
        let own = match self {
            Sought::Foremost(along) => Sought::Foremost(mirrored(along, side)),
            Sought::Nearest(to) => Sought::Nearest(mirrored(to, side)),
        };
        let mut best = (f64::INFINITY, C::ZERO);
        let take = |best: &mut (f64, C), point: C| {
            let value = own.value(point);
            if value < best.0 {
                *best = (value, point);
            }
            value
        };
        let mut open: Vec<(&HalfPiece, f64, f64)> = Vec::new();
        for piece in pieces {
            let (low, high) = piece.range();
            take(&mut best, piece.point(low));
            take(&mut best, piece.point(high));
            open.push((piece, low, high));
        }
        let (mut floor, mut count) = (f64::INFINITY, 0);
        while let Some((piece, low, high)) = open.pop() {
            count += 1;
            let middle = 0.5 * (low + high);
            let point = piece.point(middle);
            let value = take(&mut best, point);
            let (d, turned) = piece.curve.spread(low, high);
            let (falls, turns) = own.falls(point, d);
            let (slack, lean) = (turned + turns, (falls.conj() * piece.normal(middle)).im);
            let off = lean.abs().min(1.0).asin();
            if off > slack && turned < FRAC_PI_2 {
                take(&mut best, piece.point(low));
                take(&mut best, piece.point(high));
                continue;
            }
            // A stretch is at most d/cos w long on either side of its middle; along it the value falls by no more than the sine of the
            // angle between what falls and the normal.
            let gain = if off + slack < WIDE {
                d.min(d / turned.cos() * (off + slack).sin())
            } else {
                d
            };
            let splits = low < middle && middle < high && count < MOST_STRETCHES;
            if value - gain >= best.0 - fine || !splits {
                floor = floor.min(value - gain);
                continue;
            }
            open.push((piece, low, middle));
            open.push((piece, middle, high));
        }
        Place {
            at: mirrored(best.1, side),
            value: best.0,
            missed: (best.0 - floor).max(0.0),
        }
    }
}

impl Place {
    /// As it is reported, on `tooth`.
    pub fn touch(&self, half: &HalfOutline, tooth: u32) -> Touch {
        let radius = self.at.norm();
        Touch {
            tooth,
            curve: match radius {
                _ if radius >= half.tip_limit => ToothPlace::Tip,
                _ if radius <= half.root_limit => ToothPlace::Root,
                _ => ToothPlace::Flank,
            },
            radius,
        }
    }
}

/// Between the gear's own frame and that of a half tooth of `side`.
fn mirrored(point: C, side: Side) -> C {
    match side {
        Side::Right => point,
        Side::Left => point.conj(),
    }
}

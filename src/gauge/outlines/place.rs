//! The place of a half tooth that is foremost in a direction, or nearest to a point.
//!
//! Branch and bound over the pieces as drawn. `PartCurve::spread` bounds how far points and normals of a stretch are
//! from those of its middle. If the normals cannot have the required direction, the best place is an end. Otherwise the
//! possible gain of a stretch falls with the square of its length, so about twenty halvings reach the last bits.

use crate::contact::{ToothPlace, Touch};
use crate::gear::Side;
use crate::outline::{HalfOutline, HalfPiece, OutlineGear};
use nalgebra::Complex;
use std::f64::consts::FRAC_PI_2;

type C = Complex<f64>;

/// Limit of stretches; the rest goes into the error bound (tuned: a seat needs about a hundred; a pin with exactly the
/// radius of the arc in which it lies would need millions).
const MOST_STRETCHES: usize = 20_000;

/// Range of a normal's direction, rad, that is too wide for a bound.
const WIDE: f64 = 1.0;

/// The target, in the gear's own frame.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal {
    /// Foremost in the direction of this unit vector.
    Foremost(C),
    /// Nearest to this point.
    Nearest(C),
}

/// The place found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// Position in the gear's own frame.
    pub at: C,
    /// Distance behind the line through the origin, or from the point, mm.
    pub value: f64,
    /// The least value is at most this much below `value`, mm.
    pub missed: f64,
}

/// Bound, mm, on the rounding of a place: 64 ulps of the greatest radius.
pub(super) fn rounding(gear: &OutlineGear) -> f64 {
    64.0 * f64::EPSILON * gear.tip_radius()
}

impl Goal {
    /// The quantity to minimise, mm.
    fn value(self, point: C) -> f64 {
        match self {
            Goal::Foremost(along) => -(along.conj() * point).re,
            Goal::Nearest(to) => (to - point).norm(),
        }
    }

    /// The unit vector of steepest descent at `point`, and the turn of that direction within `d` mm, rad.
    fn descent(self, point: C, d: f64) -> (C, f64) {
        match self {
            Goal::Foremost(along) => (along, 0.0),
            Goal::Nearest(to) => {
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
            Goal::Foremost(along) => Goal::Foremost(mirrored(along, side)),
            Goal::Nearest(to) => Goal::Nearest(mirrored(to, side)),
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
            let (descent, turns) = own.descent(point, d);
            let (slack, lean) = (turned + turns, (descent.conj() * piece.normal(middle)).im);
            let off = lean.abs().min(1.0).asin();
            if off > slack && turned < FRAC_PI_2 {
                take(&mut best, piece.point(low));
                take(&mut best, piece.point(high));
                continue;
            }
            // On either side of its middle a stretch is at most d/cos w long. Along it the value falls by at most the
            // sine of the angle between the direction of fall and the normal.
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
    /// The reported contact, on `tooth`.
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

/// Converts between the gear's own frame and that of a half tooth of `side`.
fn mirrored(point: C, side: Side) -> C {
    match side {
        Side::Right => point,
        Side::Left => point.conj(),
    }
}

//! The gap of two curves about the free gear's axis, for curves of any kind. The exact method and drawn outlines both search with it.

mod boxes;
mod branch;
mod paths;

pub(super) use boxes::{Bounding, Rectangle, RunContent, Tree};
pub(super) use branch::{CurveArc, CurveContact, MOST_NODES, OpenPairs, greatest};
pub(super) use paths::{LEAST_LEVEL, Path, PathSearch, PlacedRun, ROUNDING};

use crate::gear::PartCurve;
use nalgebra::Complex;
use std::f64::consts::{PI, TAU};

/// Point or vector of the plane.
pub(super) type C = Complex<f64>;

/// `e^{i angle}`.
#[inline]
pub(super) fn turn(angle: f64) -> C {
    let (sin, cos) = angle.sin_cos();
    C::new(cos, sin)
}

/// Length of a vector. Lengths that overflow are beyond any gear.
#[inline]
pub(super) fn length(vector: C) -> f64 {
    vector.norm_sqr().sqrt()
}

/// `a·b`.
#[inline]
pub(super) fn dot(a: C, b: C) -> f64 {
    a.re * b.re + a.im * b.im
}

/// The origin of gaps.
#[derive(Debug, Clone, Copy)]
pub(super) struct Origin {
    /// Direction at rotation 0 of the point that is on +x at a gap of 0.
    pub direction: C,
    /// Gaps are within half a turn of this, rad, the gap at which the free tooth faces the mate. In gears of three
    /// teeth a neighbouring tooth can touch more than half a turn from 0.
    pub about: f64,
}

impl Origin {
    /// The gap of a locked point `P` and a free point `Q` of one radius; `turned` is `P Q*`.
    #[inline]
    pub fn gap(self, turned: C) -> f64 {
        let gap = (turned * self.direction).arg();
        let off = gap - self.about;
        if off.abs() <= PI {
            gap
        } else {
            gap - TAU * (off / TAU).round()
        }
    }
}

/// A point of a curve, mm, and the unit normal there, out of the metal.
#[derive(Debug, Clone, Copy)]
pub(super) struct CurvePoint {
    pub point: C,
    pub normal: C,
}

/// `σ = ρ dθ/dρ = −Y/X`, `X = Q × n`, `Y = Q · n`.
#[inline]
pub(super) fn slope(sample: &CurvePoint) -> f64 {
    let z = sample.point.conj() * sample.normal;
    -z.re / z.im
}

/// The normal out of the locked metal at a contact, and the slope that converts a shift of a curve to a change of the gap. At a corner the
/// other curve gives both; between two corners the normal is their direction of approach. `opposite` is the free curve's normal, turned to
/// the contact and out of the locked metal. Between two smooth curves the steeper slope counts.
#[inline]
pub(super) fn common_normal(
    p: &CurvePoint,
    q: &CurvePoint,
    corners: [bool; 2],
    opposite: impl FnOnce() -> C,
) -> (C, f64) {
    match corners {
        [true, true] => (p.point * C::i() / p.point.norm_sqr().sqrt(), 0.0),
        [true, false] => (opposite(), slope(q)),
        [false, true] => (p.normal, slope(p)),
        [false, false] => (p.normal, slope(p).abs().max(slope(q).abs())),
    }
}

/// Bound on the rounding of a gap, rad. Its contact is at `radius` from the free axis, its curves have the slope `σ`,
/// and `size` is its greatest length, mm.
///
/// Positions come from a table direction (angle, sine and cosine: 6 ε), the locked rotation (reduction, sine and
/// cosine: 4 ε), the curve itself (4 ε) and sums. The total is within 16 ε of the largest length. A point off by `δ`
/// changes the gap by at most `(δ/ρ)(1 + |σ|)`. Angles up to π are added four times: 16 ε.
#[inline]
pub(super) fn rounding(size: f64, radius: f64, slope: f64) -> f64 {
    f64::EPSILON * (16.0 * size / radius * (1.0 + slope.abs()) + 16.0)
}

/// A curve at its position in a pose: `centre + direction · P`, from the free gear's axis. `P` is mirrored in the x axis where `mirrored`.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlacedCurve<'a> {
    pub curve: &'a PartCurve,
    pub mirrored: bool,
    pub centre: C,
    pub direction: C,
}

impl PlacedCurve<'_> {
    /// Point and normal at parameter `t`.
    #[inline]
    pub fn at(&self, t: f64) -> CurvePoint {
        let (point, normal) = self.curve.at(t);
        let mut sample = CurvePoint {
            point: C::new(point.x, point.y),
            normal: C::new(normal.x, normal.y),
        };
        if self.mirrored {
            sample.point = sample.point.conj();
            sample.normal = sample.normal.conj();
        }
        CurvePoint {
            point: self.centre + self.direction * sample.point,
            normal: self.direction * sample.normal,
        }
    }

    /// `dP/dt = i n · speed`, with its sign.
    #[inline]
    fn speed(&self, t: f64) -> f64 {
        let speed = self.curve.speed(t);
        if self.mirrored { -speed } else { speed }
    }

    /// The parameter between `inner` and `outer` at which the curve has the radius `rho`; `|P|` rises from one to the other.
    ///
    /// Newton's method on `|P|² − ρ²` from `start`, halved when it leaves its bracket. It ends when the step or the
    /// residual is lost in rounding.
    #[inline]
    pub fn invert(&self, rho: f64, ends: [f64; 2], start: f64) -> f64 {
        self.invert_counted(rho, ends, start).0
    }

    /// [`PlacedCurve::invert`] with its number of steps.
    #[inline]
    fn invert_counted(
        &self,
        rho: f64,
        [mut inner, mut outer]: [f64; 2],
        start: f64,
    ) -> (f64, usize) {
        let mut t = start;
        for steps in 1..=128 {
            let sample = self.at(t);
            let rest = sample.point.norm_sqr() - rho * rho;
            if rest <= 0.0 {
                inner = t;
            }
            if rest >= 0.0 {
                outer = t;
            }
            // d|P|²/dt = 2 P·(i n) speed.
            let along = sample.point.im * sample.normal.re - sample.point.re * sample.normal.im;
            let newton = t - rest / (2.0 * along * self.speed(t));
            let inside = newton > inner.min(outer) && newton < inner.max(outer);
            let next = if inside {
                newton
            } else {
                0.5 * (inner + outer)
            };
            let step = (next - t).abs();
            t = next;
            if step <= 2.0 * f64::EPSILON * t.abs() || rest == 0.0 {
                return (t, steps);
            }
        }
        (t, 128)
    }
}

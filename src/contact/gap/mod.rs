//! The gap of two curves about the free gear's axis, for curves of any kind: what both the exact method and outlines search by.

mod branch;

pub(super) use branch::{Arc, MOST_NODES, Meeting, greatest};

use crate::gear::PartCurve;
use nalgebra::Complex;

/// Point or vector of the plane.
pub(super) type C = Complex<f64>;

/// `e^{i angle}`.
#[inline]
pub(super) fn turn(angle: f64) -> C {
    let (sin, cos) = angle.sin_cos();
    C::new(cos, sin)
}

/// A point of a curve, mm, and the unit normal there, out of the metal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub point: C,
    pub normal: C,
}

/// `σ = ρ dθ/dρ = −Y/X`, `X = Q × n`, `Y = Q · n`.
#[inline]
pub(super) fn slope(sample: &Sample) -> f64 {
    let z = sample.point.conj() * sample.normal;
    -z.re / z.im
}

/// A curve where the pose puts it: `centre + direction · P`, from the free gear's axis; `P` the mirror image in the x axis where mirrored.
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
    pub fn at(&self, t: f64) -> Sample {
        let (point, normal) = self.curve.at(t);
        let mut sample = Sample {
            point: C::new(point.x, point.y),
            normal: C::new(normal.x, normal.y),
        };
        if self.mirrored {
            sample.point = sample.point.conj();
            sample.normal = sample.normal.conj();
        }
        Sample {
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

    /// The parameter between `inner` and `outer` at which the curve has the radius `rho`, `|P|` rising from one to the other.
    ///
    /// Newton's method on `|P|² − ρ²` from `start`, halved whenever it leaves its bracket. It
    /// ends when the step or the rest is lost in rounding.
    #[inline]
    pub fn invert(&self, rho: f64, [mut inner, mut outer]: [f64; 2], start: f64) -> f64 {
        let mut t = start;
        for _ in 0..128 {
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
                break;
            }
        }
        t
    }
}

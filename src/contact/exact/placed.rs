//! A half tooth where the pose puts it.

use super::shape::{C, Sample, Shape};
use crate::gear::ProfilePart;

/// A half tooth where the pose puts it: `centre + direction · P`, from the free gear's axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed<'a> {
    pub shape: &'a Shape,
    pub centre: C,
    pub direction: C,
    /// Far corner of the tip land, in the half tooth's own frame.
    pub far: C,
    /// Where the root land ends, its parameter.
    pub root_end: f64,
}

impl Placed<'_> {
    /// Radius about the free axis of a point of the half tooth's own frame.
    pub fn own_to_axis(&self, point: C) -> f64 {
        (self.centre + self.direction * point).norm_sqr().sqrt()
    }

    /// Parameters of a curve's two ends, the lesser first: the tip land is a whole one, down to its far corner, the
    /// root land reaches to the middle of the space as built. Equal ends: the curve has no length.
    pub fn range(&self, curve: ProfilePart) -> (f64, f64) {
        let (low, high) = self.shape.range(curve);
        match curve {
            ProfilePart::Tip => (-self.far.arg(), high),
            ProfilePart::Root => (low.min(self.root_end), self.root_end),
            _ => (low, high),
        }
    }

    /// Whether a curve has any length.
    pub fn has(&self, curve: ProfilePart) -> bool {
        let (low, high) = self.range(curve);
        low < high
    }

    /// Whether it is a point without one normal.
    pub fn is_corner(&self, (curve, t): (ProfilePart, f64)) -> bool {
        match curve {
            ProfilePart::Tip | ProfilePart::Root => {
                let (low, high) = self.range(curve);
                t >= high || curve == ProfilePart::Tip && t <= low
            }
            // Where no land follows, the half tooth ends at the bottom of the fillet.
            ProfilePart::Fillet if t <= 0.0 => !self.has(ProfilePart::Root),
            _ => self.shape.is_corner((curve, t)),
        }
    }

    #[inline]
    pub fn at(&self, curve: ProfilePart, t: f64) -> Sample {
        let sample = self.shape.at(curve, t);
        Sample {
            point: self.centre + self.direction * sample.point,
            normal: self.direction * sample.normal,
        }
    }
}

/// The parameter between `inner` and `outer` at which `curve` has the radius `rho`, `|P|` rising from one to the other.
///
/// Newton's method on `|P|² − ρ²` from `start`, halved whenever it leaves its bracket. It
/// ends when the step or the rest is lost in rounding.
pub(super) fn invert(
    placed: &Placed,
    curve: ProfilePart,
    rho: f64,
    [mut inner, mut outer]: [f64; 2],
    start: f64,
) -> f64 {
    let mut t = start;
    for _ in 0..128 {
        let sample = placed.at(curve, t);
        let rest = sample.point.norm_sqr() - rho * rho;
        if rest <= 0.0 {
            inner = t;
        }
        if rest >= 0.0 {
            outer = t;
        }
        // d|P|²/dt = 2 P·(i n) speed.
        let along = sample.point.im * sample.normal.re - sample.point.re * sample.normal.im;
        let newton = t - rest / (2.0 * along * placed.shape.speed(curve, t));
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

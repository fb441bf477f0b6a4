//! A half tooth where the pose puts it.

use super::shape::{C, Sample, Shape};
use crate::contact::gap::PlacedCurve;
use crate::gear::{Osculating, ProfilePart};

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

impl<'a> Placed<'a> {
    /// One of its curves.
    #[inline]
    pub fn curve(&self, part: ProfilePart) -> PlacedCurve<'a> {
        PlacedCurve {
            curve: self.shape.curve(part),
            mirrored: false,
            centre: self.centre,
            direction: self.direction,
        }
    }

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

    /// The flank at a roll, as the pose puts it; `None` of one that is no involute.
    #[inline]
    pub fn flank(&self, xi: f64) -> Option<(Sample, Osculating)> {
        let own = self.shape.curve(ProfilePart::Involute).osculating(xi)?;
        let sample = Sample {
            point: self.centre + self.direction * C::new(own.point.x, own.point.y),
            normal: self.direction * C::new(own.normal.x, own.normal.y),
        };
        Some((sample, own))
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

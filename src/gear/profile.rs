//! The exact curves of one half tooth on either side: tip land, involute, fillet, root land ([`super::Part`]).
//!
//! The left-hand half is the mirror image in the x axis of the right-hand one. The parts follow each
//! other from the middle of the tip land to the middle of the tooth space.

use super::part::{Part, ProfilePart};
use super::{Gear, Side};
use nalgebra::{Point2, Vector2};

/// The half tooth of a gear, on either side: its parts by their places.
#[derive(Debug, Clone, Copy)]
pub struct Profile<'a> {
    gear: &'a Gear,
    parts: &'a [Part; 4],
}

impl<'a> Profile<'a> {
    /// The half tooth of `gear`, its flanks without deviation.
    pub fn new(gear: &'a Gear) -> Profile<'a> {
        Profile::of(gear, gear.parts())
    }

    /// A half tooth of `gear` that has these parts.
    pub(super) fn of(gear: &'a Gear, parts: &'a [Part; 4]) -> Profile<'a> {
        Profile { gear, parts }
    }

    /// The gear.
    pub fn gear(&self) -> &'a Gear {
        self.gear
    }

    /// One of its parts.
    pub fn part(&self, part: ProfilePart) -> &'a Part {
        &self.parts[part as usize]
    }

    /// Parameters at the two ends of `part`, the end nearer the tip first.
    ///
    /// Involute and fillet descend, the lands ascend. A root land of a full tip round has no length.
    pub fn range(&self, part: ProfilePart) -> (f64, f64) {
        let [from, to] = self.part(part).ends;
        (from, to)
    }

    /// The point of `part` at `parameter`, mm, on the half tooth of `side`.
    pub fn point(&self, part: ProfilePart, parameter: f64, side: Side) -> Point2<f64> {
        let right = self.part(part).curve.point(parameter);
        Point2::new(right.x, -side.sense() * right.y)
    }

    /// The unit normal of `part` at `parameter`, out of the metal, on the half tooth of `side`.
    pub fn normal(&self, part: ProfilePart, parameter: f64, side: Side) -> Vector2<f64> {
        let right = self.part(part).curve.normal(parameter);
        Vector2::new(right.x, -side.sense() * right.y)
    }

    /// `(A, B)` such that over a piece of length `Δ` on the near side of `parameter` the part of
    /// the second derivative across the chord is at most `A + B Δ`; `parameter` is the piece's greater end.
    pub(super) fn bend(&self, part: ProfilePart, parameter: f64) -> (f64, f64) {
        self.part(part).curve.bend(parameter)
    }

    /// Bound, mm, on the distance of `part` between two parameters from the chord through its points there:
    /// `(A + B Δ) Δ²/8`, see [`super::HalfTooth`].
    pub fn chordal_error(&self, part: ProfilePart, from: f64, to: f64) -> f64 {
        let span = (to - from).abs();
        let (a, b) = self.bend(part, from.max(to));
        (a + b * span) * span * span / 8.0
    }

    /// Greatest curvature of `part` between two parameters, 1/mm; none is known of a fillet.
    pub(crate) fn curvature(&self, part: ProfilePart, from: f64, to: f64) -> Option<f64> {
        self.part(part).curve.curvature(from, to)
    }

    /// Radius about the gear's centre at `parameter` of `part`, mm.
    pub fn radius(&self, part: ProfilePart, parameter: f64) -> f64 {
        self.part(part).curve.radius(parameter)
    }
}

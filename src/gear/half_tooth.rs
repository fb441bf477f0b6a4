//! A half tooth: its exact curves, and the polygon cut from them with a proven chordal error.
//!
//! The parts follow each other from the middle of the tip land to the middle of the tooth space. The left-hand half is the
//! mirror image of the right-hand one in the x axis.
//!
//! Every vertex of the polygon lies on its curve. Between vertices of parameters `t − Δ` and `t` the curve leaves the chord by at
//! most `max |P''·u| Δ²/8`, `u` across the chord (the remainder of linear interpolation). With `|P''·u| ≤ A + B Δ` from
//! [`Profile`], a step that solves `(A + B Δ) Δ²/8 = δ` keeps the bound `δ`.

use super::part::{Part, ProfilePart};
use super::{Gear, Side};
use nalgebra::{Point2, Vector2};
use std::ops::Range;

/// The exact half tooth of a gear on either side.
#[derive(Debug, Clone, Copy)]
pub struct Profile<'a> {
    gear: &'a Gear,
    parts: &'a [Part; 4],
}

impl<'a> Profile<'a> {
    /// The half tooth of `gear` without profile deviation.
    pub fn new(gear: &'a Gear) -> Profile<'a> {
        Profile::of(gear, gear.parts())
    }

    /// A half tooth of `gear` with these parts.
    pub(super) fn of(gear: &'a Gear, parts: &'a [Part; 4]) -> Profile<'a> {
        Profile { gear, parts }
    }

    /// The gear.
    pub fn gear(&self) -> &'a Gear {
        self.gear
    }

    /// One part.
    pub fn part(&self, part: ProfilePart) -> &'a Part {
        &self.parts[part as usize]
    }

    /// Parameters at the two ends of `part`, the end nearer the tip first.
    ///
    /// Parameters descend along involute and fillet and ascend along the lands. The root land of a full tip round has no length.
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

    /// Bounds `(A, B)` of the second derivative across the chord of a piece of length `Δ`: at most `A + B Δ`.
    ///
    /// `parameter` is the greater end of the piece.
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

    /// Greatest curvature of `part` between two parameters, 1/mm; `None` for a fillet.
    pub(crate) fn curvature(&self, part: ProfilePart, from: f64, to: f64) -> Option<f64> {
        self.part(part).curve.curvature(from, to)
    }

    /// Radius about the gear's centre at `parameter` of `part`, mm.
    pub fn radius(&self, part: ProfilePart, parameter: f64) -> f64 {
        self.part(part).curve.radius(parameter)
    }
}

/// One chord of a half tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The part that it approximates.
    pub curve: ProfilePart,
    /// Parameters of the curve at its two ends, the one nearer the tip first.
    pub parameters: [f64; 2],
}

/// The polygon of one half tooth, from the middle of the tip land to the middle of the space.
///
/// It lies in the tooth's own frame, with the centre line on +x. All teeth of a gear share two half teeth and rotate them.
#[derive(Debug, Clone)]
pub struct HalfTooth {
    side: Side,
    chordal_error: f64,
    points: Vec<Point2<f64>>,
    segments: Vec<Segment>,
}

impl HalfTooth {
    /// Cuts the half tooth of `profile` on `side` with chords within `chordal_error` mm (> 0) of its curves.
    ///
    /// A land narrower than a chord still gets one; a land without length gets none.
    pub fn new(profile: &Profile, side: Side, chordal_error: f64) -> HalfTooth {
        let whole = ProfilePart::ALL.map(|curve| (curve, profile.range(curve)));
        HalfTooth::of_pieces(profile, side, chordal_error, &whole)
    }

    /// The vertices down to the root land. The tip land starts at the parameter `start`.
    pub fn from_land(
        profile: &Profile,
        side: Side,
        chordal_error: f64,
        start: f64,
    ) -> Vec<Point2<f64>> {
        let land = (start, profile.range(ProfilePart::Tip).1);
        let flank =
            [ProfilePart::Involute, ProfilePart::Fillet].map(|curve| (curve, profile.range(curve)));
        let pieces = [(ProfilePart::Tip, land), flank[0], flank[1]];
        HalfTooth::of_pieces(profile, side, chordal_error, &pieces).points
    }

    /// The vertices of a root land up to the parameter `end`; none if `end` is not beyond its start.
    pub fn root_land(
        profile: &Profile,
        side: Side,
        chordal_error: f64,
        end: f64,
    ) -> Vec<Point2<f64>> {
        let (start, _) = profile.range(ProfilePart::Root);
        let land = [(ProfilePart::Root, (start, end.max(start)))];
        HalfTooth::of_pieces(profile, side, chordal_error, &land).points
    }

    /// A finer polygon of the chords `window` (not empty), within `chordal_error` mm.
    pub fn recut(&self, profile: &Profile, window: Range<usize>, chordal_error: f64) -> HalfTooth {
        let mut pieces: Vec<(ProfilePart, (f64, f64))> = Vec::new();
        for &Segment { curve, parameters } in &self.segments[window] {
            match pieces.last_mut() {
                Some((last, range)) if *last == curve => range.1 = parameters[1],
                _ => pieces.push((curve, (parameters[0], parameters[1]))),
            }
        }
        HalfTooth::of_pieces(profile, self.side, chordal_error, &pieces)
    }

    fn of_pieces(
        profile: &Profile,
        side: Side,
        chordal_error: f64,
        pieces: &[(ProfilePart, (f64, f64))],
    ) -> HalfTooth {
        let mut points = Vec::new();
        let mut segments = Vec::new();
        let stretches = pieces.iter().filter(|(_, (start, end))| start != end);
        let stretches = stretches.flat_map(|&(curve, (start, end))| {
            let stretches = profile.part(curve).curve.between_edges(start, end);
            stretches.into_iter().map(move |ends| (curve, ends))
        });
        for (curve, [start, end]) in stretches {
            let mut cuts = cut(start.min(end), start.max(end), |t| {
                step(profile.bend(curve, t), chordal_error)
            });
            if start < end {
                cuts.reverse();
            }
            points.reserve(cuts.len());
            segments.reserve(cuts.len());
            if points.is_empty() {
                points.push(profile.point(curve, cuts[0], side));
            }
            for pair in cuts.windows(2) {
                points.push(profile.point(curve, pair[1], side));
                segments.push(Segment {
                    curve,
                    parameters: [pair[0], pair[1]],
                });
            }
        }
        HalfTooth {
            side,
            chordal_error,
            points,
            segments,
        }
    }

    /// The side of the tooth.
    pub fn side(&self) -> Side {
        self.side
    }

    /// Bound `δ` on the distance between chord and curve, mm.
    pub fn chordal_error(&self) -> f64 {
        self.chordal_error
    }

    /// The vertices, tip first; `segments()[i]` runs from point `i` to `i + 1`.
    pub fn points(&self) -> &[Point2<f64>] {
        &self.points
    }

    /// Number of vertices down to the root land, including its first.
    pub fn above_root(&self) -> usize {
        let mut segments = self.segments.iter();
        match segments.position(|segment| segment.curve == ProfilePart::Root) {
            Some(first) => first + 1,
            None => self.points.len(),
        }
    }

    /// The part and parameters of each chord.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Profile part and parameter of the point `at` of chord `segment`.
    ///
    /// The error is less than the chord's range of parameters.
    pub fn locate(&self, segment: usize, at: &Point2<f64>) -> (ProfilePart, f64) {
        let Segment { curve, parameters } = self.segments[segment];
        let chord = self.points[segment + 1] - self.points[segment];
        let part = (at - self.points[segment]).dot(&chord) / chord.norm_squared();
        // A chord without length: its start.
        let part = if part.is_finite() {
            part.clamp(0.0, 1.0)
        } else {
            0.0
        };
        (
            curve,
            parameters[0] + part * (parameters[1] - parameters[0]),
        )
    }
}

/// Parameters from `high` down to `low`. Each piece is at most as long as `step` of its upper end.
///
/// The bend rises with the parameter, so the step at the upper end suits all pieces below it. A stretch of a few such steps is cut
/// evenly, which is faster and adds few pieces.
fn cut(low: f64, high: f64, step: impl Fn(f64) -> f64) -> Vec<f64> {
    const FEW: f64 = 64.0;
    // A straight part is one chord.
    let pieces = ((high - low) / step(high)).ceil().max(1.0);
    if pieces <= FEW {
        let width = (high - low) / pieces;
        let pieces = pieces as u32;
        let at = |i| {
            if i < pieces {
                high - f64::from(i) * width
            } else {
                low
            }
        };
        return (0..=pieces).map(at).collect();
    }
    let mut cuts = vec![high];
    let mut t = high;
    loop {
        let next = t - step(t);
        if next <= low {
            cuts.push(low);
            return cuts;
        }
        cuts.push(next);
        t = next;
    }
}

/// The greatest `Δ` with `(A + B Δ) Δ² ≤ 8 δ`, to rounding.
///
/// Newton's method on the increasing convex left side, starting above the root.
fn step((a, b): (f64, f64), chordal_error: f64) -> f64 {
    if a == 0.0 && b == 0.0 {
        return f64::INFINITY;
    }
    let target = 8.0 * chordal_error;
    let mut delta = f64::min(
        if a > 0.0 {
            (target / a).sqrt()
        } else {
            f64::INFINITY
        },
        if b > 0.0 {
            (target / b).cbrt()
        } else {
            f64::INFINITY
        },
    );
    loop {
        let excess = (a + b * delta) * delta * delta - target;
        let next = delta - excess / ((2.0 * a + 3.0 * b * delta) * delta);
        // The last step may exceed the root by rounding: 1e-12 covers it.
        if !(next < delta * (1.0 - 1e-14)) {
            return delta * (1.0 - 1e-12);
        }
        delta = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::GearDesign;

    /// A point at a fraction of a chord has the parameter at that fraction, clamped to the chord's ends.
    #[test]
    fn a_part_of_a_chord_is_that_part_of_its_parameters() {
        let gear = GearDesign::plain(20, 2.0).gear();
        for side in Side::BOTH {
            let half = HalfTooth::new(&Profile::new(&gear), side, 1e-3);
            for (index, segment) in half.segments().iter().enumerate() {
                let [start, end] = [half.points()[index], half.points()[index + 1]];
                let [from, to] = segment.parameters;
                for (part, expected) in [(-0.5, 0.0), (0.25, 0.25), (0.5, 0.5), (1.5, 1.0)] {
                    let (curve, found) = half.locate(index, &(start + part * (end - start)));
                    let wanted = (1.0 - expected) * from + expected * to;
                    assert_eq!(curve, segment.curve);
                    assert!((found - wanted).abs() < 1e-9 * (to - from).abs(), "{found}");
                }
            }
        }
    }
}

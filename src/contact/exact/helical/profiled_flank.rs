//! A flank with a profile deviation, and its pieces between edges.

use crate::contact::exact::flank_heights::{amount, deviation};
use crate::contact::exact::placed::PlacedHalf;
use crate::gear::{DeviationCurve, ProfilePart};

/// A flank and its deviation.
pub(super) struct Flank<'a> {
    pub base: f64,
    deviation: Option<&'a DeviationCurve>,
    /// Rolls of its ends.
    pub range: [f64; 2],
    /// Whether it begins at an edge: undercut.
    begins_at_edge: bool,
}

/// A part of a flank without edges inside, continued straight beyond its ends.
pub(super) struct FlankPiece<'a> {
    deviation: Option<&'a DeviationCurve>,
    pub range: [f64; 2],
}

impl<'a> Flank<'a> {
    pub fn new(half: &PlacedHalf<'a>) -> Flank<'a> {
        let part = half.shape.part(ProfilePart::Involute);
        let (low, high) = part.range();
        Flank {
            base: half.shape.base,
            deviation: deviation(part),
            range: [low, high],
            begins_at_edge: half.shape.corners().len() > 1,
        }
    }

    /// Its greatest deviation, mm.
    pub fn most(&self) -> f64 {
        self.whole().bounds(self.range)[0][1]
    }

    /// Its greatest amount of deviation, mm.
    pub fn farthest(&self) -> f64 {
        amount(self.whole().bounds(self.range)[0])
    }

    /// The greatest amount of its slope, mm/rad.
    pub fn steepest(&self) -> f64 {
        amount(self.whole().bounds(self.range)[1])
    }

    /// The whole flank as one piece; no edge of it stands out.
    pub fn whole(&self) -> FlankPiece<'a> {
        FlankPiece {
            deviation: self.deviation,
            range: self.range,
        }
    }

    /// Rolls of the edges on it.
    fn edges(&self) -> impl Iterator<Item = f64> + use<'a> {
        let [low, high] = self.range;
        let edges = self.deviation.map_or(&[][..], |curve| curve.edges());
        let inside = edges.iter().copied();
        inside.filter(move |edge| *edge > low && *edge < high)
    }

    /// Rolls of its corners.
    pub fn corners(&self) -> impl Iterator<Item = f64> + use<'a> {
        let joint = self.begins_at_edge.then_some(self.range[0]);
        self.edges().chain([self.range[1]]).chain(joint)
    }

    pub fn pieces(&self) -> Vec<FlankPiece<'a>> {
        let mut ends = vec![self.range[0]];
        ends.extend(self.edges());
        ends.push(self.range[1]);
        let piece = |ends: &[f64]| FlankPiece {
            deviation: self.deviation,
            // Just before an edge, where the slope is that of the lesser rolls.
            range: [ends[0], ends[1].next_down()],
        };
        ends.windows(2).map(piece).collect()
    }
}

impl FlankPiece<'_> {
    pub fn jet(&self, xi: f64) -> [f64; 3] {
        let Some(curve) = self.deviation else {
            return [0.0; 3];
        };
        let end = xi.clamp(self.range[0], self.range[1]);
        let [value, slope, second] = curve.jet(end);
        if end == xi {
            [value, slope, second]
        } else {
            [value + slope * (xi - end), slope, 0.0]
        }
    }

    /// Intervals of the deviation on the piece, of its slope and of its second derivative, between two rolls.
    pub fn bounds(&self, [from, to]: [f64; 2]) -> [[f64; 2]; 3] {
        let Some(curve) = self.deviation else {
            return [[0.0; 2]; 3];
        };
        let [low, high] = self.range;
        let mut bounds = curve.bounds(from.clamp(low, high), to.clamp(low, high));
        if from < low || to > high {
            let [least, most] = bounds[2];
            bounds[2] = [least.min(0.0), most.max(0.0)];
        }
        bounds
    }

    /// Whether no roll between two others is on it.
    pub fn misses(&self, [from, to]: [f64; 2]) -> bool {
        to < self.range[0] || from > self.range[1]
    }
}

//! What a file draws, in mm, before its ends are joined.

use gearlash::outline::PathSegment;
use nalgebra::Point2;

/// One drawn line, curve or path, without gaps.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// At least one.
    pub segments: Vec<PathSegment>,
    /// Layer or id; empty without one.
    pub name: String,
    /// How far the segments may lie from what was drawn, mm.
    pub bound: f64,
    /// Where in the file it stands.
    pub place: String,
}

impl Piece {
    /// Where it starts and ends.
    pub fn ends(&self) -> [Point2<f64>; 2] {
        let last = self.segments.len() - 1;
        [self.segments[0].start(), self.segments[last].end()]
    }

    /// A length not below its own, mm.
    pub fn length(&self) -> f64 {
        self.segments.iter().map(PathSegment::length).sum()
    }
}

//! A drawn piece, in mm, before its ends are joined.

use gearlash::outline::PathSegment;
use nalgebra::Point2;

/// One drawn line, curve or path, without gaps.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// At least one.
    pub segments: Vec<PathSegment>,
    /// Layer or id; empty without one.
    pub name: String,
    /// Bound on the distance of the segments from the drawing, mm.
    pub bound: f64,
    /// Its place in the file.
    pub place: String,
}

impl Piece {
    /// Its start and end.
    pub fn ends(&self) -> [Point2<f64>; 2] {
        let last = self.segments.len() - 1;
        [self.segments[0].start(), self.segments[last].end()]
    }

    /// Points on it, in steps of 1e-6 mm, from the lesser end on. They are equal for pieces that are drawn twice.
    pub fn trace(&self) -> Vec<[i64; 2]> {
        const STEP: f64 = 1e-6;
        let at = |segment: &PathSegment| {
            let segment = *segment;
            [0.0, 0.25, 0.5, 0.75].map(|u| segment.at(u)).into_iter()
        };
        let points = self.segments.iter().flat_map(at).chain([self.ends()[1]]);
        let grid = |x: f64| (x / STEP).round() as i64;
        let mut trace: Vec<[i64; 2]> = points.map(|p| [grid(p.x), grid(p.y)]).collect();
        if trace.iter().rev().lt(trace.iter()) {
            trace.reverse();
        }
        trace
    }

    /// Its segments from the end `entry`: the first if that is even, else the last.
    pub fn along(&self, entry: usize) -> Vec<PathSegment> {
        if entry.is_multiple_of(2) {
            return self.segments.clone();
        }
        self.segments
            .iter()
            .rev()
            .map(PathSegment::reversed)
            .collect()
    }

    /// An upper bound on its length, mm.
    pub fn length(&self) -> f64 {
        self.segments.iter().map(PathSegment::length).sum()
    }
}

//! Flanks that are not convex, in pieces between the knots and turning points of their deviation: each piece curves to one side.

use crate::contact::gap::{Rectangle, Tree};
use crate::gear::{Part, PartCurve, smooth};
use nalgebra::Complex;

/// Least number of pieces of a flank (tuned): with few knots whole stretches are wide.
const LEAST_PIECES: f64 = 32.0;

/// A flank in pieces, each between two knots or turning points of its deviation, with bounding rectangles.
#[derive(Debug, Clone)]
pub(super) struct FlankPieces {
    /// Rolls of their ends.
    pub ends: Vec<(f64, f64)>,
    pub boxes: Tree<Rectangle>,
}

impl FlankPieces {
    pub fn new(flank: &Part) -> FlankPieces {
        let curve = &flank.curve;
        let (low, high) = flank.range();
        let bends = match curve {
            PartCurve::Modified(flank) => flank.deviation().bends(),
            _ => Vec::new(),
        };
        let width = (high - low) / LEAST_PIECES;
        let stretches = smooth(&bends, low, high).filter(|(from, to)| from < to);
        let divided = stretches.flat_map(|(from, to)| {
            let count = ((to - from) / width).ceil().max(1.0);
            let at = move |k: u32| {
                if f64::from(k) < count {
                    from + (to - from) * f64::from(k) / count
                } else {
                    to
                }
            };
            (0..count as u32).map(move |k| (at(k), at(k + 1)))
        });
        let ends: Vec<(f64, f64)> = divided.collect();
        let point = |roll: f64| {
            let point = curve.point(roll);
            Complex::new(point.x, point.y)
        };
        let round = |ends: &(f64, f64)| Rectangle::new(curve, *ends, point);
        FlankPieces {
            boxes: Tree::new(&ends.iter().map(round).collect::<Vec<Rectangle>>()),
            ends,
        }
    }
}

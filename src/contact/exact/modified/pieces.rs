//! Flanks in pieces at a pose.

use super::heights::greatest_gap_by_heights;
use crate::contact::Effort;
use crate::contact::exact::candidate::CandidateContact;
use crate::contact::exact::flank_pieces::FlankPieces;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::PlacedHalf;
use crate::contact::gap::{CurveArc, Path, PathSearch, PlacedRun, Rectangle, Tree};
use crate::gear::ProfilePart;

/// Effort of the bounds of heights, in nodes (tuned: about 10 µs, with or without a result).
const BY_HEIGHTS: u64 = 32;

/// A flank at its position in a pose.
struct FlankPath<'a> {
    half: PlacedHalf<'a>,
    pieces: &'a FlankPieces,
}

impl<'a> FlankPath<'a> {
    fn new(half: PlacedHalf<'a>) -> FlankPath<'a> {
        let pieces = half.shape.flank_pieces();
        FlankPath { half, pieces }
    }
}

impl<'a> Path<'a> for FlankPath<'a> {
    #[inline]
    fn boxes(&self) -> &Tree<Rectangle> {
        &self.pieces.boxes
    }

    #[inline]
    fn place(&self, run: usize) -> PlacedRun {
        let rectangle = self.pieces.boxes.shape(run);
        let placed = rectangle.placed(self.half.centre, self.half.direction);
        PlacedRun::new(run, placed)
    }

    fn arc(&self, piece: usize) -> CurveArc<'a> {
        let (low, high) = self.pieces.ends[piece];
        let part = ProfilePart::Involute;
        CurveArc::new(self.half.curve(part), part as usize, low, high)
    }
}

/// The greatest gap above `floor` of the flanks of a step, searched first near the gap `guess`. It comes from bounds of their heights, and
/// otherwise from branch and bound over all pairs of their pieces; `None` if neither settles it.
pub(in crate::contact::exact) fn greatest_gap_of_flanks(
    posed: &PosedFlanks,
    step: i64,
    floor: f64,
    guess: f64,
    effort: &Effort,
) -> Option<Option<CandidateContact>> {
    effort.spend(BY_HEIGHTS);
    let by_heights = greatest_gap_by_heights(posed, step, floor, guess);
    if by_heights.is_some() {
        return by_heights;
    }
    let (locked, free) = (posed.locked(step), posed.free(step));
    let size = 2.0 * posed.problem.distance;
    let origin = posed.origin_of(step);
    let mut search = PathSearch::new(origin, size, floor, guess, effort.left());
    let most = search.nodes_left();
    let found = search.greatest(&FlankPath::new(locked), &FlankPath::new(free));
    effort.spend(most - search.nodes_left());
    let part = ProfilePart::Involute;
    Some(found.ok()?.map(|found| {
        let on = ((part, found.locked.1), (part, found.free.1));
        CandidateContact::new((&locked, on.0), (&free, on.1), origin, found.slack)
    }))
}

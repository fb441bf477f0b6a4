//! Flanks that are not convex, as pieces between the knots of their deviation and its turns: such a piece bends to one side.

use crate::contact::exact::candidate::CandidateContact;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::Placed;
use crate::contact::exact::shape::C;
use crate::contact::gap::{Arc, Boxes, Path, PathSearch, PlacedRun, Rectangle};
use crate::gear::{Part, PartCurve, ProfilePart, smooth};

/// Pieces of a flank at least (tuned): of a few knots whole stretches are wide.
const LEAST_PIECES: f64 = 32.0;

/// A flank in pieces, each between two knots or turns of its deviation, and rectangles round them.
#[derive(Debug, Clone)]
pub(in crate::contact::exact) struct FlankPieces {
    /// Rolls of their ends.
    ends: Vec<(f64, f64)>,
    boxes: Boxes,
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
            let at = move |k: u32| match f64::from(k) < count {
                true => from + (to - from) * f64::from(k) / count,
                false => to,
            };
            (0..count as u32).map(move |k| (at(k), at(k + 1)))
        });
        let ends: Vec<(f64, f64)> = divided.collect();
        let point = |roll: f64| {
            let point = curve.point(roll);
            C::new(point.x, point.y)
        };
        let round = |ends: &(f64, f64)| Rectangle::new(curve, *ends, point);
        FlankPieces {
            boxes: Boxes::new(&ends.iter().map(round).collect::<Vec<Rectangle>>()),
            ends,
        }
    }
}

/// A flank where a pose has it.
struct FlankPath<'a> {
    half: Placed<'a>,
    pieces: &'a FlankPieces,
}

impl<'a> FlankPath<'a> {
    fn new(half: Placed<'a>) -> FlankPath<'a> {
        let pieces = half.shape.flank_pieces();
        FlankPath { half, pieces }
    }
}

impl<'a> Path<'a> for FlankPath<'a> {
    #[inline]
    fn boxes(&self) -> &Boxes {
        &self.pieces.boxes
    }

    #[inline]
    fn put(&self, run: usize) -> PlacedRun {
        let rectangle = self.pieces.boxes.rectangle(run);
        let placed = rectangle.placed(self.half.centre, self.half.direction);
        PlacedRun::new(run, placed)
    }

    fn arc(&self, piece: usize) -> Arc<'a> {
        let (low, high) = self.pieces.ends[piece];
        let part = ProfilePart::Involute;
        Arc::new(self.half.curve(part), part as usize, low, high)
    }
}

impl PosedFlanks<'_> {
    /// The greatest gap above `floor` of the flanks of a step, by branch and bound over all pairs of their pieces, looked for first near `guess`;
    /// `None` where it is not settled.
    pub(in crate::contact::exact) fn flanks_in_pieces(
        &self,
        step: i64,
        floor: f64,
        guess: f64,
    ) -> Option<Option<CandidateContact>> {
        let (locked, free) = (self.locked(step), self.free(step));
        let size = 2.0 * self.problem.distance;
        let mut search = PathSearch::new(self.origin, size, floor, guess);
        let found = search.greatest(&FlankPath::new(locked), &FlankPath::new(free));
        let part = ProfilePart::Involute;
        Some(found.ok()?.map(|found| {
            let on = ((part, found.locked.1), (part, found.free.1));
            CandidateContact::new((&locked, on.0), (&free, on.1), self.origin, found.slack)
        }))
    }
}

//! Half teeth of outlines as paths.

use super::teeth::{Frame, SideTeeth};
use crate::contact::gap::{CurveArc, Path, PlacedRun, Rectangle, Tree};
use crate::outline::HalfPiece;

/// A locked half tooth at its position in a pose.
pub(super) struct LockedHalf<'a> {
    pieces: &'a [HalfPiece],
    boxes: &'a Tree<Rectangle>,
    frame: Frame,
}

impl<'a> LockedHalf<'a> {
    pub fn new(teeth: &'a SideTeeth<'a>, tooth: u32, frame: Frame) -> LockedHalf<'a> {
        LockedHalf {
            pieces: &teeth.half(tooth).pieces,
            boxes: teeth.boxes(tooth),
            frame,
        }
    }
}

impl<'a> Path<'a> for LockedHalf<'a> {
    #[inline]
    fn boxes(&self) -> &Tree<Rectangle> {
        self.boxes
    }

    #[inline]
    fn place(&self, run: usize) -> PlacedRun {
        let Frame { centre, direction } = self.frame;
        PlacedRun::new(run, self.boxes.shape(run).placed(centre, direction))
    }

    fn arc(&self, piece: usize) -> CurveArc<'a> {
        self.frame.arc(&self.pieces[piece], piece)
    }
}

/// A free half tooth at rotation 0.
#[derive(Debug)]
pub(super) struct FreeHalf<'a> {
    boxes: Tree<Rectangle>,
    arcs: Vec<CurveArc<'a>>,
    runs: Vec<PlacedRun>,
}

impl<'a> FreeHalf<'a> {
    pub fn new(teeth: &SideTeeth<'a>, tooth: u32) -> FreeHalf<'a> {
        let still = teeth.still();
        let pieces = teeth.half(tooth).pieces.iter().enumerate();
        let boxes = teeth.boxes(tooth).clone();
        let runs = boxes.shapes().enumerate().map(|(run, rectangle)| {
            PlacedRun::new(run, rectangle.placed(still.centre, still.direction))
        });
        FreeHalf {
            arcs: pieces
                .map(|(name, piece)| still.free_arc(piece, name))
                .collect(),
            runs: runs.collect(),
            boxes,
        }
    }

    /// Round a run.
    pub fn rectangle(&self, run: usize) -> &Rectangle {
        self.runs[run].rectangle()
    }
}

impl<'a> Path<'a> for FreeHalf<'a> {
    #[inline]
    fn boxes(&self) -> &Tree<Rectangle> {
        &self.boxes
    }

    #[inline]
    fn place(&self, run: usize) -> PlacedRun {
        self.runs[run]
    }

    fn arc(&self, piece: usize) -> CurveArc<'a> {
        self.arcs[piece]
    }
}

//! The greatest gap of one side at one pose: rectangles round runs of pieces rule out what cannot touch, curves settle the rest.
//!
//! Of a pair of half teeth the pairs of runs are taken depth first, the one that stands farthest into its mate first, at the greatest gap so far:
//! it is near the contact after the first descent. A pair is dropped where the runs have no radius in common, or the locked one is behind
//! the free one.

use super::SideKernel;
use super::teeth::{Frame, SideTeeth};
use crate::contact::gap::{Arc, Boxes, C, Inside, MOST_NODES, Meeting, Rectangle, greatest, turn};
use crate::outline::OutlinePair;

/// Below this gap, rad, nothing is ruled out by rectangles: the gap of a pair seen within 120° of each other (see [`Rectangle::is_near`]) might be
/// below −π, and count as one near π.
const LEAST_LEVEL: f64 = -1.0;

/// Rounding of rectangles where a pose puts them, of the greatest length in them: positions are within 16 ε of it, as [`crate::contact::gap::rounding`]
/// says, and their projections and radii add as much.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A run shorter than this share of its mate is not divided (tuned).
const SHORT: f64 = 0.5;

/// A free half tooth at rotation 0.
#[derive(Debug)]
pub(super) struct FreeHalf<'a> {
    arcs: Vec<Arc<'a>>,
    /// Of each run its rectangle, and bounds of its radii squared, mm².
    runs: Vec<(Rectangle, (f64, f64))>,
}

impl<'a> FreeHalf<'a> {
    pub fn new(teeth: &SideTeeth<'a>, tooth: u32, still: &Frame) -> FreeHalf<'a> {
        let pieces = teeth.half(tooth).pieces.iter().enumerate();
        let placed = |rectangle: &Rectangle| {
            let placed = rectangle.placed(still.centre, still.direction);
            (placed, placed.squares())
        };
        FreeHalf {
            arcs: pieces
                .map(|(name, piece)| still.free_arc(piece, name))
                .collect(),
            runs: teeth.boxes(tooth).rectangles().map(placed).collect(),
        }
    }
}

/// A locked run of pieces where the pose has it.
#[derive(Debug, Clone, Copy)]
struct LockedRun {
    run: usize,
    rectangle: Rectangle,
    squares: (f64, f64),
}

/// A locked and a free run of pieces, not ruled out at the gap of `level`.
#[derive(Debug, Clone, Copy)]
struct Pair {
    locked: LockedRun,
    free: usize,
    level: f64,
    /// Whether both are seen within 120° of each other at a gap from [`LEAST_LEVEL`] on.
    is_near: bool,
    /// How far the locked run stood into its mate.
    over: f64,
}

/// The search over all pairs of half teeth of one side.
pub(super) struct Search<'k> {
    side: &'k SideKernel<'k>,
    frame: Frame,
    origin: C,
    /// Whether rectangles rule anything out.
    prunes: bool,
    /// Rounding of lengths, mm, and of their squares, mm².
    rounding: f64,
    squared_rounding: f64,
    /// The free gear's turn at the greatest gap so far; at the nominal rotation while there is none.
    turned: C,
    level: f64,
    best: Option<(Meeting, u32, u32)>,
    nodes_left: usize,
    open: Vec<Pair>,
    nodes: Vec<(Arc<'k>, Arc<'k>)>,
}

impl<'k> Search<'k> {
    pub fn new(
        side: &'k SideKernel<'k>,
        pair: &OutlinePair,
        frame: Frame,
        origin: C,
        prunes: bool,
    ) -> Search<'k> {
        let size = pair.center_distance() + side.locked.gear.reach() + side.free.gear.reach();
        Search {
            side,
            frame,
            origin,
            prunes,
            rounding: ROUNDING * size,
            squared_rounding: ROUNDING * size * size,
            turned: origin.conj(),
            level: f64::NEG_INFINITY,
            best: None,
            nodes_left: MOST_NODES,
            open: Vec::with_capacity(64),
            nodes: Vec::with_capacity(4),
        }
    }

    /// What touches first, and its teeth, of those looked at.
    pub fn best(self) -> Option<(Meeting, u32, u32)> {
        self.best
    }

    /// Looks at a locked and a free half tooth.
    ///
    /// # Errors
    /// The names of two curves whose search did not end.
    pub fn teeth(&mut self, (locked, free): (u32, u32)) -> Result<(), (usize, usize)> {
        let boxes = self.side.locked.boxes(locked);
        let whole = boxes.whole().zip(self.side.free.boxes(free).whole());
        let Some((locked_run, free_run)) = whole else {
            return Ok(());
        };
        let half = &self.side.still[free as usize - 1];
        let free_boxes = self.side.free.boxes(free);
        let first = self.put(boxes, locked_run);
        self.open
            .extend(self.looked_at(first, free_run, half, false));
        while let Some(mut pair) = self.open.pop() {
            if pair.level < self.level {
                match self.looked_at(pair.locked, pair.free, half, pair.is_near) {
                    Some(still) => pair = still,
                    None => continue,
                }
            }
            let inside = (boxes.inside(pair.locked.run), free_boxes.inside(pair.free));
            if let (Inside::Piece(name), Inside::Piece(mate)) = inside {
                self.pieces((locked, free), (name, mate))?;
                continue;
            }
            // Both are divided, but one far shorter than the other.
            let lengths = (
                pair.locked.rectangle.length(),
                half.runs[pair.free].0.length(),
            );
            let locked_runs = match inside {
                (Inside::Runs(runs), Inside::Piece(_)) => runs.map(Some),
                (Inside::Runs(runs), _) if !(lengths.0 < SHORT * lengths.1) => runs.map(Some),
                _ => [Some(pair.locked.run), None],
            };
            let free_runs = match inside {
                (Inside::Piece(_), Inside::Runs(runs)) => runs.map(Some),
                (_, Inside::Runs(runs)) if !(lengths.1 < SHORT * lengths.0) => runs.map(Some),
                _ => [Some(pair.free), None],
            };
            let from = self.open.len();
            for run in locked_runs.into_iter().flatten() {
                let locked = match run == pair.locked.run {
                    true => pair.locked,
                    false => self.put(boxes, run),
                };
                for free in free_runs.into_iter().flatten() {
                    let found = self.looked_at(locked, free, half, pair.is_near);
                    self.open.extend(found);
                }
            }
            // The one that stands farthest into its mate last, where it is taken first.
            self.open[from..].sort_by(|a, b| a.over.total_cmp(&b.over));
        }
        Ok(())
    }

    /// A locked run where the pose has it.
    #[inline]
    fn put(&self, boxes: &Boxes, run: usize) -> LockedRun {
        let Frame { centre, direction } = self.frame;
        let rectangle = boxes.rectangle(run).placed(centre, direction);
        LockedRun {
            run,
            squares: rectangle.squares(),
            rectangle,
        }
    }

    /// A pair as the greatest gap so far leaves it; `None` where it is ruled out.
    #[inline]
    fn looked_at(
        &self,
        locked: LockedRun,
        free: usize,
        half: &FreeHalf,
        is_near: bool,
    ) -> Option<Pair> {
        let (mate, squares) = &half.runs[free];
        let room = self.squared_rounding;
        let is_apart = locked.squares.0 > squares.1 + room || squares.0 > locked.squares.1 + room;
        if is_apart && self.prunes {
            return None;
        }
        let near = || locked.rectangle.is_near(mate, self.turned);
        let is_near = is_near || self.level >= LEAST_LEVEL && near();
        let over = locked.rectangle.beyond(mate, self.turned, self.rounding);
        // Not above 0 it is proof.
        let is_behind = is_near && over <= 0.0;
        (!(is_behind && self.prunes)).then_some(Pair {
            locked,
            free,
            level: self.level,
            is_near,
            over,
        })
    }

    /// Looks at two pieces.
    fn pieces(
        &mut self,
        (locked, free): (u32, u32),
        (name, mate): (usize, usize),
    ) -> Result<(), (usize, usize)> {
        let piece = &self.side.locked.half(locked).pieces[name];
        let arc = self.frame.arc(piece, name);
        let mate = self.side.still[free as usize - 1].arcs[mate];
        if !arc.meets(&mate) || arc.gap_with(&mate, self.origin).1 <= self.level {
            return Ok(());
        }
        self.nodes.push((arc, mate));
        let found = greatest(
            &mut self.nodes,
            self.origin,
            self.level,
            &mut self.nodes_left,
        )?;
        if let Some(meeting) = found {
            self.level = meeting.gap;
            self.turned = self.origin.conj() * turn(self.level);
            self.best = Some((meeting, locked, free));
        }
        Ok(())
    }
}

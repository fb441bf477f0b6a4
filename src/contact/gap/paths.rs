//! The greatest gap of two paths of many pieces. Rectangles around runs rule out what cannot touch; the curves settle the rest.
//!
//! Pairs of runs are taken depth first at the greatest gap so far, starting with the deepest penetration. After the first descent that gap
//! is near the contact. A pair is dropped if its runs share no radius, or if the locked one is behind the free one.

use super::boxes::{Rectangle, RunContent, Tree};
use super::{C, CurveArc, CurveContact, MOST_NODES, OpenPairs, Origin, greatest, turn};
use crate::numeric::rank;

/// Distance below the origin of gaps, rad, from which rectangles rule nothing out. The gap of a pair within 120° (see
/// [`Rectangle::is_near`]) could be more than half a turn below the origin there, and count as one a turn above.
pub(in crate::contact) const LEAST_LEVEL: f64 = -1.0;

/// Rounding of placed rectangles, per greatest length. Positions are within 16 ε ([`super::rounding`]); their
/// projections and radii add as much.
pub(in crate::contact) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Pairs of runs that take the time of one node (tuned: about 0.1 µs each, with up to four pairs from its division).
const PAIRS_A_NODE: usize = 4;

/// Ratio of lengths below which the shorter run of a pair is not divided (tuned).
const SHORT: f64 = 0.5;

/// Pieces in order at their positions in a pose, from the free gear's axis.
pub(in crate::contact) trait Path<'a> {
    /// The rectangles around its pieces.
    fn boxes(&self) -> &Tree<Rectangle>;
    /// A run at its position.
    fn place(&self, run: usize) -> PlacedRun;
    /// One of its pieces.
    fn arc(&self, piece: usize) -> CurveArc<'a>;
}

/// A run of pieces at its position in the pose.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct PlacedRun {
    run: usize,
    rectangle: Rectangle,
    squares: (f64, f64),
}

impl PlacedRun {
    /// A run in this rectangle.
    #[inline]
    pub fn new(run: usize, rectangle: Rectangle) -> PlacedRun {
        PlacedRun {
            run,
            squares: rectangle.squares(),
            rectangle,
        }
    }

    pub fn rectangle(&self) -> &Rectangle {
        &self.rectangle
    }
}

/// The search used up its nodes.
#[derive(Debug)]
pub(in crate::contact) struct Spent;

/// A locked and a free run that are not ruled out at the gap of `level`.
#[derive(Debug, Clone, Copy)]
struct RunPair {
    /// Indices of both among the placed runs.
    runs: [u32; 2],
    /// Whether both are within 120° of each other at all gaps from [`LEAST_LEVEL`] up.
    is_near: bool,
    level: f64,
    /// Penetration of the locked run into its mate.
    penetration: f64,
}

/// A search over pairs of paths. The greatest gap so far rules out the rest.
pub(in crate::contact) struct PathSearch<'a> {
    origin: Origin,
    /// Whether rectangles rule anything out.
    prunes: bool,
    /// Rounding of lengths, mm, and of their squares, mm².
    rounding: f64,
    squared_rounding: f64,
    /// The free gear's turn at the greatest gap so far, or at the first guess.
    turned: C,
    level: f64,
    nodes_left: usize,
    /// Pairs of runs examined since the count was last charged.
    pairs: usize,
    /// Runs placed so far for both paths. Pairs refer to them by index.
    placed: [Vec<PlacedRun>; 2],
    open: Vec<RunPair>,
    pieces: OpenPairs<'a>,
}

impl<'a> PathSearch<'a> {
    /// A search with at most `most` nodes for gaps from `origin` above `floor`, starting near `guess` without a floor; `size` is the greatest
    /// length, mm.
    pub fn new(origin: Origin, size: f64, floor: f64, guess: f64, most: u64) -> PathSearch<'a> {
        PathSearch {
            origin,
            prunes: true,
            rounding: ROUNDING * size,
            squared_rounding: ROUNDING * size * size,
            turned: origin.direction.conj() * turn(if floor.is_finite() { floor } else { guess }),
            level: floor,
            nodes_left: most.min(MOST_NODES as u64) as usize,
            pairs: 0,
            placed: [Vec::with_capacity(64), Vec::with_capacity(64)],
            open: Vec::with_capacity(64),
            pieces: OpenPairs::default(),
        }
    }

    /// Nodes left.
    pub fn nodes_left(&self) -> u64 {
        self.nodes_left as u64
    }

    /// This search without rectangles.
    pub fn without_rectangles(self) -> PathSearch<'a> {
        PathSearch {
            prunes: false,
            ..self
        }
    }

    /// The greatest gap of two paths, if it exceeds all so far.
    ///
    /// # Errors
    /// [`Spent`].
    pub fn greatest(
        &mut self,
        locked: &impl Path<'a>,
        free: &impl Path<'a>,
    ) -> Result<Option<CurveContact>, Spent> {
        let (locked_boxes, free_boxes) = (locked.boxes(), free.boxes());
        let Some(whole) = locked_boxes.whole().zip(free_boxes.whole()) else {
            return Ok(None);
        };
        self.placed.iter_mut().for_each(Vec::clear);
        let whole = [
            self.add(0, locked.place(whole.0)),
            self.add(1, free.place(whole.1)),
        ];
        let mut best = None;
        self.open.extend(self.pair(whole, false));
        while let Some(mut pair) = self.open.pop() {
            if pair.level < self.level {
                match self.pair(pair.runs, pair.is_near) {
                    Some(still) => pair = still,
                    None => continue,
                }
            }
            self.pairs += 1;
            if self.pairs == PAIRS_A_NODE {
                self.pairs = 0;
                if self.nodes_left == 0 {
                    return Err(Spent);
                }
                self.nodes_left -= 1;
            }
            let [one, other] = self.runs(pair.runs);
            let inside = (locked_boxes.inside(one.run), free_boxes.inside(other.run));
            if let (RunContent::Pieces([piece, _]), RunContent::Pieces([mate, _])) = inside {
                best = self.pieces(locked.arc(piece), free.arc(mate))?.or(best);
                continue;
            }
            // Both are divided, except one far shorter than the other.
            let lengths = [one, other].map(|run| run.rectangle.length());
            let parts = |inside, mate, [own, other]: [f64; 2]| match inside {
                RunContent::Runs(runs)
                    if matches!(mate, RunContent::Pieces(_)) || !(own < SHORT * other) =>
                {
                    Some(runs)
                }
                _ => None,
            };
            let locked_runs = parts(inside.0, inside.1, lengths);
            let free_runs = parts(inside.1, inside.0, [lengths[1], lengths[0]]);
            let from = self.open.len();
            let frees = match free_runs {
                Some(runs) => runs.map(|run| Some(self.add(1, free.place(run)))),
                None => [Some(pair.runs[1]), None],
            };
            let lockeds = match locked_runs {
                Some(runs) => runs.map(|run| Some(self.add(0, locked.place(run)))),
                None => [Some(pair.runs[0]), None],
            };
            for locked in lockeds.into_iter().flatten() {
                for free in frees.into_iter().flatten() {
                    let found = self.pair([locked, free], pair.is_near);
                    self.open.extend(found);
                }
            }
            // The deepest penetration goes last, because the last is taken first.
            self.open[from..].sort_by_cached_key(|pair| rank(pair.penetration));
        }
        Ok(best)
    }

    /// Adds a run of a path and returns its index.
    #[inline]
    fn add(&mut self, path: usize, run: PlacedRun) -> u32 {
        self.placed[path].push(run);
        self.placed[path].len() as u32 - 1
    }

    #[inline]
    fn runs(&self, [locked, free]: [u32; 2]) -> [&PlacedRun; 2] {
        [
            &self.placed[0][locked as usize],
            &self.placed[1][free as usize],
        ]
    }

    /// A pair at the greatest gap so far; `None` if it is ruled out.
    #[inline]
    fn pair(&self, runs: [u32; 2], is_near: bool) -> Option<RunPair> {
        let [locked, free] = self.runs(runs);
        let room = self.squared_rounding;
        let is_apart =
            locked.squares.0 > free.squares.1 + room || free.squares.0 > locked.squares.1 + room;
        if is_apart && self.prunes {
            return None;
        }
        let near = || locked.rectangle.is_near(&free.rectangle, self.turned);
        let is_near = is_near || self.level - self.origin.about >= LEAST_LEVEL && near();
        let penetration = locked
            .rectangle
            .beyond(&free.rectangle, self.turned, self.rounding);
        // A value of at most 0 is proof.
        let is_behind = is_near && penetration <= 0.0;
        (!(is_behind && self.prunes)).then_some(RunPair {
            runs,
            is_near,
            level: self.level,
            penetration,
        })
    }

    /// Examines two pieces.
    fn pieces(
        &mut self,
        arc: CurveArc<'a>,
        mate: CurveArc<'a>,
    ) -> Result<Option<CurveContact>, Spent> {
        if !arc.meets(&mate) || arc.gap_with(&mate, self.origin).1 <= self.level {
            return Ok(None);
        }
        let pair = [arc, mate].map(|arc| self.pieces.arc(arc));
        self.pieces.add(pair[0], pair[1]);
        let found = greatest(
            &mut self.pieces,
            self.origin,
            self.level,
            &mut self.nodes_left,
        );
        let found = found.map_err(|_| Spent)?;
        if let Some(meeting) = &found {
            self.level = meeting.gap;
            self.turned = self.origin.direction.conj() * turn(self.level);
        }
        Ok(found)
    }
}

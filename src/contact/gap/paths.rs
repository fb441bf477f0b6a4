//! The greatest gap of two paths of many pieces: rectangles round runs of them rule out what cannot touch, curves settle the rest.
//!
//! Pairs of runs are taken depth first, the one that stands farthest into its mate first, at the greatest gap so far: it is near the contact after
//! the first descent. A pair is dropped where the runs have no radius in common, or the locked one is behind the free one.

use super::boxes::{Boxes, Inside, Rectangle};
use super::{Arc, C, CurveContact, MOST_NODES, Origin, greatest, turn};

/// Farther below what gaps are about, rad, nothing is ruled out by rectangles: the gap of a pair seen within 120° of each other (see
/// [`Rectangle::is_near`]) might be more than half a turn below that, and count as one a turn above.
const LEAST_LEVEL: f64 = -1.0;

/// Rounding of rectangles where a pose puts them, of the greatest length in them: positions are within 16 ε of it, as [`super::rounding`]
/// says, and their projections and radii add as much.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Pairs of runs that take the time of one node (tuned: some 0.1 µs each, with the up to four pairs that each is divided into).
const PAIRS_A_NODE: usize = 4;

/// A run shorter than this share of its mate is not divided (tuned).
const SHORT: f64 = 0.5;

/// Pieces in order where a pose puts them, from the free gear's axis.
pub(in crate::contact) trait Path<'a> {
    /// Round its pieces.
    fn boxes(&self) -> &Boxes;
    /// Where a run is.
    fn put(&self, run: usize) -> PlacedRun;
    /// One of its pieces.
    fn arc(&self, piece: usize) -> Arc<'a>;
}

/// A run of pieces where the pose has it.
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
}

/// The nodes of a search are spent before it ended.
#[derive(Debug)]
pub(in crate::contact) struct Spent;

/// A locked and a free run, not ruled out at the gap of `level`.
#[derive(Debug, Clone, Copy)]
struct Pair {
    /// Places of both among the runs put.
    runs: [u32; 2],
    /// Whether both are seen within 120° of each other at a gap from [`LEAST_LEVEL`] on.
    is_near: bool,
    level: f64,
    /// How far the locked run stood into its mate.
    over: f64,
}

/// A search over pairs of paths, whose greatest gap so far rules out the rest.
pub(in crate::contact) struct PathSearch<'a> {
    origin: Origin,
    /// Whether rectangles rule anything out.
    prunes: bool,
    /// Rounding of lengths, mm, and of their squares, mm².
    rounding: f64,
    squared_rounding: f64,
    /// The free gear's turn at the greatest gap so far; while there is none, where one is looked for first.
    turned: C,
    level: f64,
    nodes_left: usize,
    /// Pairs of runs looked at since the last of them was counted.
    pairs: usize,
    /// Runs put so far of both paths: pairs are moved about, and name them by their places.
    put: [Vec<PlacedRun>; 2],
    open: Vec<Pair>,
    nodes: Vec<(Arc<'a>, Arc<'a>)>,
}

impl<'a> PathSearch<'a> {
    /// For gaps from `origin` above `floor`, first near `guess` where there is no floor; `size` is the greatest length in them, mm.
    pub fn new(origin: Origin, size: f64, floor: f64, guess: f64) -> PathSearch<'a> {
        PathSearch {
            origin,
            prunes: true,
            rounding: ROUNDING * size,
            squared_rounding: ROUNDING * size * size,
            turned: origin.direction.conj() * turn(if floor.is_finite() { floor } else { guess }),
            level: floor,
            nodes_left: MOST_NODES,
            pairs: 0,
            put: [Vec::with_capacity(64), Vec::with_capacity(64)],
            open: Vec::with_capacity(64),
            nodes: Vec::with_capacity(4),
        }
    }

    /// The same with no more nodes than `most`.
    pub fn within(self, most: u64) -> PathSearch<'a> {
        PathSearch {
            nodes_left: most.min(MOST_NODES as u64) as usize,
            ..self
        }
    }

    /// So many nodes are left of those it had.
    pub fn nodes_left(&self) -> u64 {
        self.nodes_left as u64
    }

    /// The same with nothing ruled out by rectangles.
    pub fn of_all(self) -> PathSearch<'a> {
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
        self.put.iter_mut().for_each(Vec::clear);
        let whole = [
            self.add(0, locked.put(whole.0)),
            self.add(1, free.put(whole.1)),
        ];
        let mut best = None;
        self.open.extend(self.looked_at(whole, false));
        while let Some(mut pair) = self.open.pop() {
            if pair.level < self.level {
                match self.looked_at(pair.runs, pair.is_near) {
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
            if let (Inside::Piece(piece), Inside::Piece(mate)) = inside {
                best = self.pieces(locked.arc(piece), free.arc(mate))?.or(best);
                continue;
            }
            // Both are divided, but one far shorter than the other.
            let lengths = [one, other].map(|run| run.rectangle.length());
            let parts = |inside, mate, [own, other]: [f64; 2]| match inside {
                Inside::Runs(runs)
                    if matches!(mate, Inside::Piece(_)) || !(own < SHORT * other) =>
                {
                    Some(runs)
                }
                _ => None,
            };
            let locked_runs = parts(inside.0, inside.1, lengths);
            let free_runs = parts(inside.1, inside.0, [lengths[1], lengths[0]]);
            let from = self.open.len();
            let frees = match free_runs {
                Some(runs) => runs.map(|run| Some(self.add(1, free.put(run)))),
                None => [Some(pair.runs[1]), None],
            };
            let lockeds = match locked_runs {
                Some(runs) => runs.map(|run| Some(self.add(0, locked.put(run)))),
                None => [Some(pair.runs[0]), None],
            };
            for locked in lockeds.into_iter().flatten() {
                for free in frees.into_iter().flatten() {
                    let found = self.looked_at([locked, free], pair.is_near);
                    self.open.extend(found);
                }
            }
            // The one that stands farthest into its mate last, where it is taken first.
            self.open[from..].sort_by(|a, b| a.over.total_cmp(&b.over));
        }
        Ok(best)
    }

    /// Adds a run of a path; its place.
    #[inline]
    fn add(&mut self, path: usize, run: PlacedRun) -> u32 {
        self.put[path].push(run);
        self.put[path].len() as u32 - 1
    }

    #[inline]
    fn runs(&self, [locked, free]: [u32; 2]) -> [&PlacedRun; 2] {
        [&self.put[0][locked as usize], &self.put[1][free as usize]]
    }

    /// A pair as the greatest gap so far leaves it; `None` where it is ruled out.
    #[inline]
    fn looked_at(&self, runs: [u32; 2], is_near: bool) -> Option<Pair> {
        let [locked, free] = self.runs(runs);
        let room = self.squared_rounding;
        let is_apart =
            locked.squares.0 > free.squares.1 + room || free.squares.0 > locked.squares.1 + room;
        if is_apart && self.prunes {
            return None;
        }
        let near = || locked.rectangle.is_near(&free.rectangle, self.turned);
        let is_near = is_near || self.level - self.origin.about >= LEAST_LEVEL && near();
        let over = locked
            .rectangle
            .beyond(&free.rectangle, self.turned, self.rounding);
        // Not above 0 it is proof.
        let is_behind = is_near && over <= 0.0;
        (!(is_behind && self.prunes)).then_some(Pair {
            runs,
            is_near,
            level: self.level,
            over,
        })
    }

    /// Looks at two pieces.
    fn pieces(&mut self, arc: Arc<'a>, mate: Arc<'a>) -> Result<Option<CurveContact>, Spent> {
        if !arc.meets(&mate) || arc.gap_with(&mate, self.origin).1 <= self.level {
            return Ok(None);
        }
        self.nodes.push((arc, mate));
        let found = greatest(
            &mut self.nodes,
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

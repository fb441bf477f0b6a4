//! The least and the greatest lost motion over a whole mesh cycle by branch and bound over cells of rotations.
//!
//! [`CycleCells`] bounds the lost motion of a cell. A cell whose bound is better than the best pose by more than the wanted width is divided.
//! In the end no cell is: the least is no less than the least bound, and no more than the best pose. Where the effort ends before, the bounds
//! left over are the bracket.
//!
//! Cells are divided in rounds of a fixed number, so that any number of threads finds the same.

use super::effort::Effort;
use super::exact::{Doubt, End, Extreme, Extremes};
use super::lost_motion::Status;
use crate::error::Tick;
use crate::numeric::rank;
use crate::pair::Mating;
use crate::parallel;
use std::collections::HashSet;

/// Limit of cells in the first round (tuned: some seconds). Longer cycles have wider cells.
const MOST_CELLS: u64 = 60_000;

/// Cells divided in one round: a quarter of the open ones, or this number (tuned: enough for a machine's cores, few enough that the best
/// pose is known soon).
const ROUND: usize = 96;

/// Half the width of a cell, pitches, below which a missing bound ends the search: the bracket then has no such end.
const UNBOUNDED: f64 = 1e-6;

/// Limit of the parts into which a cell is divided (tuned).
const MOST_PARTS: f64 = 4.0;

/// Share of the wanted bracket that the bounds of cells may leave.
const SHARE_OF_BOUNDS: f64 = 0.8;

/// Least effort of a cell, nodes (tuned: 10 µs).
const LEAST_EFFORT: u64 = 30;

/// Part of the wanted width. Poses beside the best one are added until they differ from it by less.
const SETTLED: f64 = 1e-3;

/// Limit of rounds of poses beside the best one. Some 15 are usual.
const MOST_ROUNDS: u32 = 64;

/// Resolution of places, per pitch. Cells beside each other share the pose between them.
pub(super) const GRID: f64 = (1_u64 << 40) as f64;

/// Values that differ by less, rad, are equal: rounding of different platforms.
const EQUAL: f64 = 1e-12;

/// A stretch of the cycle with bounds of its lost motion, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// The middle, pitches from the first pose.
    pub pitches: f64,
    /// Half its width, pitches.
    pub half: f64,
    /// The place of the pose that is known, pitches.
    pub known: f64,
    pub status: Status,
    /// The lost motion there, and its error.
    pub angle: Option<(f64, f64)>,
    /// Lower bound of the lost motion, −∞ without one, and the rest below it that no narrower cell excludes.
    pub low: (f64, f64),
    /// Upper bound of the lost motion, and the rest above it that no narrower cell excludes.
    pub high: (f64, f64),
    pub effort: u64,
}

impl Cell {
    /// A cell without bounds.
    pub fn unknown(pitches: f64, half: f64) -> Cell {
        Cell {
            pitches,
            half,
            known: pitches,
            status: Status::Unproven,
            angle: None,
            low: (f64::NEG_INFINITY, 0.0),
            high: (f64::INFINITY, 0.0),
            effort: 0,
        }
    }

    /// The lost motion of the known pose, with the sign that makes the searched extreme the least.
    fn value(&self, end: End) -> Option<f64> {
        let (angle, _) = self.angle?;
        Some(end.sign() * angle)
    }

    /// Lower bound of [`Cell::value`] over the cell, and the rest beyond it that no narrower cell excludes.
    fn bound(&self, end: End) -> (f64, f64) {
        match end {
            End::Least => self.low,
            End::Greatest => (-self.high.0, self.high.1),
        }
    }
}

/// The cell with the best known pose, the first of equal ones.
fn first_best(cells: &[Cell], end: End) -> Option<&Cell> {
    let values = cells.iter().filter_map(|cell| cell.value(end));
    let best = values.reduce(f64::min)?;
    let is_best = |cell: &&Cell| cell.value(end).is_some_and(|value| value <= best + EQUAL);
    let equal = cells.iter().filter(is_best);
    equal.min_by(|a, b| a.known.total_cmp(&b.known))
}

/// A mesh cycle whose cells can be bounded.
pub(super) trait CycleCells: Sync {
    /// The doubt of a bracket whose rest no narrower cell excludes.
    const DOUBT_OF_BOUNDS: Doubt;

    /// Cells of a pitch in the first round (tuned).
    fn cells_a_pitch(&self) -> u64 {
        4
    }

    /// The mating `pitches` after the first pose.
    fn mating(&self, pitches: f64) -> Mating;

    /// The teeth that can meet in the cell of half the width `half`, pitches, about `pitches`, each by the first tooth that it equals. Cells
    /// with equal lists at equal fractions of a pitch are equal. `None` where this is not known.
    fn teeth_in_reach(&self, _pitches: f64, _half: f64) -> Option<Vec<u32>> {
        None
    }

    /// The cell about `pitches`, `half` pitches wide on either side, with one of its poses and its bounds for `ends`. Bounds need not be closer
    /// than `width`, rad.
    fn examine(&self, pitches: f64, half: f64, ends: &[End], width: f64) -> Cell;
}

/// The search for the extremes of a cycle.
pub(super) struct CycleSearch<'a, T> {
    pub cells: &'a T,
    /// Matings after which all teeth meet again.
    pub distinct: u64,
    /// All matings of the cycle.
    pub matings: u64,
    /// Wanted width of a bracket, rad.
    pub width: f64,
    /// Arc of one radian, mm.
    pub radius: f64,
    /// Limit of [`Effort`] for one extreme, nodes.
    pub most_effort: u64,
    pub tick: &'a Tick<'a>,
}

impl<T: CycleCells> CycleSearch<'_, T> {
    /// The extremes `ends`, in brackets of the wanted width where no more effort is needed than a search may spend, and the effort used.
    pub fn extremes(&self, ends: &[End]) -> (Extremes, u64) {
        let cells = self.first_cells(ends);
        let mut used: u64 = cells.iter().map(|cell| cell.effort).sum();
        let first = |cells: &[Cell], status: Status| {
            let lost = cells.iter().filter(|cell| cell.status == status);
            let lost = lost.min_by(|a, b| a.known.total_cmp(&b.known));
            lost.map(|cell| self.cells.mating(cell.known))
        };
        let lost = [Status::Jammed, Status::NoContact];
        let [jammed, unmeshed] = lost.map(|status| first(&cells, status));
        let mut all = cells.clone();
        // Gears that nowhere touch have no pose with a lost motion.
        let any = cells.iter().any(|cell| cell.angle.is_some());
        let mut found = |end: End, lost: Option<Mating>| {
            if lost.is_some() || !any || !ends.contains(&end) {
                return None;
            }
            let mut cells = cells.clone();
            let effort = Effort::new(self.most_effort, self.tick);
            let is_closed = self.divide(&mut cells, end, &effort);
            used += effort.used();
            self.refine_best(&mut cells, end);
            let found = self.extreme(&cells, end, is_closed);
            all.extend(cells);
            found
        };
        let (least, greatest) = (found(End::Least, jammed), found(End::Greatest, unmeshed));
        let [jammed, unmeshed] = lost.map(|status| first(&all, status));
        let is_known = all.iter().any(|cell| cell.angle.is_some());
        let status = if jammed.is_some() {
            Status::Jammed
        } else if unmeshed.is_some() {
            Status::NoContact
        } else if all.iter().any(|cell| cell.status == Status::Interference) {
            Status::Interference
        } else if is_known {
            Status::Clear
        } else {
            Status::Unproven
        };
        let found = Extremes {
            matings: self.matings,
            status,
            least: least.filter(|_| jammed.is_none()),
            greatest: greatest.filter(|_| unmeshed.is_none()),
            lost: jammed.or(unmeshed),
        };
        (found, used)
    }

    /// The cells of the first round; of equal ones only the first.
    fn first_cells(&self, ends: &[End]) -> Vec<Cell> {
        let pitches = self.distinct;
        let count =
            (self.cells.cells_a_pitch() * pitches).min(MOST_CELLS.max(pitches.min(2 * MOST_CELLS)));
        let distance = pitches as f64 / count as f64;
        let mut seen = HashSet::new();
        let each = (0..count).map(|k| ((k as f64 + 0.5) * distance, 0.5 * distance));
        let each = each.filter(|&(at, half)| {
            let teeth_in_reach = self.cells.teeth_in_reach(at, half);
            teeth_in_reach.is_none_or(|teeth| seen.insert((rank(at.fract()), teeth)))
        });
        let each: Vec<(f64, f64)> = each.collect();
        let mut cells = Vec::new();
        for some in each.chunks(ROUND) {
            if (self.tick)(0).is_break() {
                break;
            }
            let some = some.iter().copied();
            cells.extend(parallel::map(some, |(at, half)| {
                self.examine(at, half, ends)
            }));
        }
        cells
    }

    /// Divides cells until none of them may be better than the best pose by the wanted width. Returns whether the effort sufficed.
    fn divide(&self, cells: &mut Vec<Cell>, end: End, effort: &Effort) -> bool {
        let width = SHARE_OF_BOUNDS * self.width;
        let values = |cells: &[Cell], best: f64| {
            let values = cells.iter().filter_map(|cell| cell.value(end));
            values.fold(best, f64::min)
        };
        let mut best = values(cells, f64::INFINITY);
        let mut left = std::mem::take(cells);
        loop {
            let enough = best - width;
            let (mut open, rest): (Vec<Cell>, Vec<Cell>) = left
                .into_iter()
                .partition(|cell| cell.bound(end).0 < enough);
            // A closed cell stays closed: the best pose only improves.
            cells.extend(rest);
            let is_lost = |cell: &Cell| !cell.bound(end).0.is_finite() && cell.half < UNBOUNDED;
            let is_closed = open.is_empty();
            let is_stopped = (self.tick)(0).is_break();
            if is_closed || is_stopped || effort.is_spent() || open.iter().any(is_lost) {
                cells.extend(open);
                return is_closed;
            }
            // By their bounds, equal ones by their places.
            open.sort_by_cached_key(|cell| rank(cell.pitches));
            open.sort_by_cached_key(|cell| rank(cell.bound(end).0));
            let count = ROUND.max(open.len() / 4);
            left = open.split_off(open.len().min(count));
            let parts = open.iter().flat_map(|cell| {
                let over = cell.value(end).map_or(f64::INFINITY, |value| {
                    (value - cell.bound(end).0) / (value - enough)
                });
                let parts = if over.is_finite() {
                    over.sqrt().ceil().clamp(2.0, MOST_PARTS)
                } else {
                    2.0
                };
                let half = cell.half / parts;
                (0..parts as u32).map(move |part| {
                    let at = cell.pitches - cell.half + (2.0 * f64::from(part) + 1.0) * half;
                    (at, half)
                })
            });
            let parts = parallel::map(parts, |(at, half)| self.examine(at, half, &[end]));
            effort.spend(parts.iter().map(|cell| cell.effort.max(LEAST_EFFORT)).sum());
            best = values(&parts, best);
            left.extend(parts);
        }
    }

    /// Examines a pose on either side of the best one, at half the distance once neither is better.
    fn refine_best(&self, cells: &mut Vec<Cell>, end: End) {
        let Some(mut best) = first_best(cells, end).copied() else {
            return;
        };
        let mut distance = best.half;
        for _ in 0..MOST_ROUNDS {
            let from = best;
            let beside = parallel::map([-distance, distance], |by| {
                self.examine(from.known + by, 0.0, &[])
            });
            let mut change: f64 = 0.0;
            for pose in beside {
                if let (Some(value), Some(own)) = (pose.value(end), from.value(end)) {
                    change = change.max((value - own).abs());
                }
                if pose.value(end) < best.value(end) && pose.value(end).is_some() {
                    best = pose;
                }
                // A pose bounds nothing else.
                cells.push(Cell {
                    low: (f64::INFINITY, 0.0),
                    high: (f64::NEG_INFINITY, 0.0),
                    ..pose
                });
            }
            if change <= SETTLED * self.width {
                break;
            }
            if best.known == from.known {
                distance *= 0.5;
            }
        }
    }

    /// The bracket that the cells leave, with the first of the poses that attain it.
    fn extreme(&self, cells: &[Cell], end: End, is_closed: bool) -> Option<Extreme> {
        let pose = first_best(cells, end)?;
        let (angle, error) = pose.angle?;
        let bounds = cells.iter().map(|cell| {
            let (bound, open) = cell.bound(end);
            bound - open
        });
        let bound = bounds.fold(end.sign() * angle - error, f64::min);
        let (low, high) = match end {
            End::Least => (bound, angle + error),
            End::Greatest => (angle - error, -bound),
        };
        let doubt = if !is_closed {
            Some(Doubt::Effort)
        } else if high - low > self.width {
            Some(T::DOUBT_OF_BOUNDS)
        } else {
            None
        };
        Some(Extreme {
            low: low * self.radius,
            high: high * self.radius,
            found: angle * self.radius,
            mating: self.cells.mating(pose.known),
            doubt,
        })
    }

    fn examine(&self, pitches: f64, half: f64, ends: &[End]) -> Cell {
        self.cells
            .examine(pitches, half, ends, SHARE_OF_BOUNDS * self.width)
    }
}

//! The search for one extreme: it cuts the stretches that can beat the best known pose, the most promising first.

use super::cell::MatingCell;
use super::extreme::{CycleBound, Doubt, End, ExaminedPoses, PoseValue};
use super::mesh_cycle::{MeshCycle, PARTS};
use super::sample;
use super::table::{CycleTable, PartBounds};
use crate::contact::ranked::Ranked;
use crate::error::Error;
use crate::numeric;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Limit of cells examined for one extreme (tuned: a hundred settle an ordinary one; the limit takes about 20 ms).
const MOST_CELLS: usize = 4_000;

/// Least width of a cell, pitches: the bound of a narrower one does not close.
const NARROWEST: f64 = 1e-9;

/// Limit of cells examined for one place that may equal the best.
const CELLS_OF_A_PLACE: usize = 24;

/// Limit of places that may equal the best (tuned: 300 kB).
const MOST_PLACES: usize = 4_096;

/// Part of the requested width that the proof may leave open. Rounding and equal places take the rest.
pub(super) const PROOF_SHARE: f64 = 0.95;

/// Part of the requested width within which two poses count as equal: far above rounding, and small enough for the first of them to be valid.
pub(super) const EQUAL_SHARE: f64 = 1e-3;

/// Matings whose stretches are collected before those are discarded that cannot beat the best (tuned: 160 kB).
const STRIDE: u64 = 512;

/// Stretches that can contain an extreme: they can reach the best guaranteed value so far.
struct Candidates<'a> {
    search: &'a Search<'a>,
    kept: Vec<PartBounds>,
    /// Stretches that cannot beat the best pose, but may equal it.
    near: Vec<PartBounds>,
    /// The most promising stretch.
    most_promising: Option<PartBounds>,
    /// Its key.
    key: f64,
    /// The best guaranteed value.
    guaranteed: f64,
    /// Number of stretches to keep before a pose is examined to drop some.
    capacity: usize,
    /// The best key of the dropped ones.
    dropped: f64,
}

impl Candidates<'_> {
    fn new<'a>(search: &'a Search<'a>) -> Candidates<'a> {
        Candidates {
            search,
            kept: Vec::new(),
            near: Vec::new(),
            most_promising: None,
            key: f64::NEG_INFINITY,
            guaranteed: f64::NEG_INFINITY,
            capacity: STRIDE as usize * PARTS,
            dropped: f64::NEG_INFINITY,
        }
    }

    fn take(&mut self, bounds: PartBounds) {
        let which = self.search.which;
        let key = which.key(bounds.low, bounds.high);
        self.guaranteed = self
            .guaranteed
            .max(which.guaranteed(bounds.low, bounds.high));
        if key < self.guaranteed - self.search.equal {
            return;
        }
        self.kept.push(bounds);
        if self.most_promising.is_none() || key > self.key {
            (self.most_promising, self.key) = (Some(bounds), key);
        }
    }

    /// Examines the most promising stretch in its middle.
    fn examine(&self, found: &mut ExaminedPoses) -> Result<(), Error> {
        let Some(most_promising) = self.most_promising else {
            return Ok(());
        };
        let cell = MatingCell::of_part(most_promising.mating, most_promising.part);
        let cycle = self.search.cycle;
        let middle = cycle.mating(most_promising.mating, 0.5 * (cell.from + cell.to));
        found.examine(cycle, middle)?;
        Ok(())
    }

    /// Examines the most promising stretch at its expected extreme, and drops the stretches that cannot beat that. In gears with equal
    /// teeth every mating is equally promising.
    fn prune(&mut self, found: &mut ExaminedPoses) -> Result<(), Error> {
        let Some(most_promising) = self.most_promising else {
            return Ok(());
        };
        let Search { cycle, table, .. } = self.search;
        let cell =
            MatingCell::of_part(most_promising.mating, most_promising.part).bounded(cycle, table);
        let at = self.search.expected(&cell);
        found.examine(cycle, cycle.mating(most_promising.mating, at))?;
        self.discard(found);
        let key = |bounds: &PartBounds| self.search.key(bounds.low, bounds.high);
        let most_promising = self.kept.iter().max_by(|a, b| key(a).total_cmp(&key(b)));
        (self.most_promising, self.key) = (
            most_promising.copied(),
            most_promising.map_or(f64::NEG_INFINITY, key),
        );
        // At least doubled, so that this costs no more than keeping.
        self.capacity = self.capacity.max(2 * self.kept.len());
        Ok(())
    }

    /// Discards the stretches that cannot beat the best pose by more than the width.
    fn discard(&mut self, found: &ExaminedPoses) {
        let search = self.search;
        let (which, dropped, near) = (search.which, &mut self.dropped, &mut self.near);
        let enough = search.best(found) + search.width;
        self.kept.retain(|kept| {
            let key = which.key(kept.low, kept.high);
            if key <= enough {
                *dropped = dropped.max(key);
                near.push(*kept);
            }
            key > enough
        });
        search.keep_near(near, found);
    }

    /// The stretches to examine.
    fn ranked(mut self, found: &ExaminedPoses) -> RankedCells {
        self.discard(found);
        let open = self.kept.iter().map(MatingCell::of_bounds);
        let near = self.near.iter().map(MatingCell::of_bounds);
        RankedCells {
            open: open.collect(),
            near: near.collect(),
            bound: self.search.best(found).max(self.dropped),
        }
    }
}

/// A search for one extreme, best bound first.
pub(super) struct Search<'a> {
    pub cycle: &'a MeshCycle<'a>,
    pub table: &'a CycleTable,
    /// The part of the bracket that the proof may leave open, rad.
    pub width: f64,
    /// Distance from the best within which places are equal, rad.
    pub equal: f64,
    pub which: End,
    /// Effort reserved for what follows this search.
    pub reserved: u64,
    /// The one extreme that is wanted, if not both.
    pub only: Option<End>,
}

/// A cell in the order of examination: the most promising first, of equal ones the first in the cycle.
type RankedCell = Ranked<(u64, Reverse<(u64, usize, u64)>), MatingCell>;

/// The cells that a search has to examine.
#[derive(Debug, Default)]
pub(super) struct RankedCells {
    open: Vec<MatingCell>,
    /// Cells that do not beat the best, but may equal it.
    pub near: Vec<MatingCell>,
    /// The best key of the others.
    bound: f64,
}

/// Examines the most promising pose of each of `searches` over one cycle, and ranks the stretches that may beat the best.
pub(super) fn rank(
    searches: &[Search],
    found: &mut ExaminedPoses,
) -> Result<Vec<RankedCells>, Error> {
    let Some(Search { table, .. }) = searches.first() else {
        return Ok(Vec::new());
    };
    let mut candidates: Vec<Candidates> = searches.iter().map(Candidates::new).collect();
    let matings = table.matings();
    for first in (0..matings).step_by(STRIDE as usize) {
        table.each(first..matings.min(first + STRIDE), &mut |bounds| {
            for candidates in &mut candidates {
                candidates.take(bounds);
            }
        });
        for candidates in &mut candidates {
            if candidates.kept.len() > candidates.capacity {
                candidates.prune(found)?;
            }
        }
    }
    for candidates in &candidates {
        candidates.examine(found)?;
    }
    let ranked = candidates.into_iter();
    Ok(ranked.map(|candidates| candidates.ranked(found)).collect())
}

impl Search<'_> {
    fn key(&self, low: f64, high: f64) -> f64 {
        self.which.key(low, high)
    }

    fn ranked(&self, cell: MatingCell) -> RankedCell {
        let place = (cell.mating, cell.part, numeric::rank(cell.from));
        Ranked {
            key: (numeric::rank(self.key(cell.low, cell.high)), Reverse(place)),
            item: cell,
        }
    }

    /// The place of the expected extreme in a cell with bounds.
    fn expected(&self, cell: &MatingCell) -> f64 {
        cell.expected[self.which as usize]
    }

    /// The best known pose, as a key.
    fn best(&self, found: &ExaminedPoses) -> f64 {
        let seen = found.best[self.which as usize];
        seen.map_or(f64::NEG_INFINITY, |seen| -self.which.sign() * seen.angle)
    }

    /// The bound for the whole cycle, rad, from the `ranked` stretches of this search.
    pub fn run(
        &self,
        ranked: &mut RankedCells,
        found: &mut ExaminedPoses,
    ) -> Result<CycleBound, Error> {
        let open = std::mem::take(&mut ranked.open).into_iter();
        let open: Vec<RankedCell> = open.map(|cell| self.ranked(cell)).collect();
        let mut open = BinaryHeap::from(open);
        let proof = self.settle(&mut open, ranked, found)?;
        ranked.near.extend(open.into_iter().map(|open| open.item));
        Ok(proof)
    }

    /// Cuts the most promising of `open` until none can beat the best pose.
    fn settle(
        &self,
        open: &mut BinaryHeap<RankedCell>,
        ranked: &mut RankedCells,
        found: &mut ExaminedPoses,
    ) -> Result<CycleBound, Error> {
        let mut bound = ranked.bound;
        // The best key of the cells that are too narrow to cut.
        let mut narrow = f64::NEG_INFINITY;
        for _ in 0..MOST_CELLS {
            if self.cycle.effort.left() <= self.reserved {
                break;
            }
            let Some(next) = open.pop() else {
                break;
            };
            let mut cell = next.item;
            let key = self.key(cell.low, cell.high);
            // Everything not examined is within `width` of the best.
            if key <= self.best(found) + self.width {
                bound = bound.max(key);
                open.push(next);
                break;
            }
            if cell.to - cell.from < NARROWEST {
                narrow = narrow.max(key);
                ranked.near.push(cell);
                continue;
            }
            let beats = |cell: &MatingCell, found: &ExaminedPoses| {
                self.key(cell.low, cell.high) > self.best(found) + self.width
            };
            if cell.seen.is_none() {
                cell = cell.bounded_by_line(self.cycle, self.table);
            }
            if beats(&cell, found) {
                cell = cell.bounded(self.cycle, self.table);
            }
            let at = self.expected(&cell);
            if beats(&cell, found) {
                if cell.seen != Some(at) {
                    found.examine(self.cycle, self.cycle.mating(cell.mating, at))?;
                }
                if found.lacks(Some(self.which)) {
                    // A jammed or unmeshed pose has no extreme.
                    return Ok((self.value(self.best(found)), None));
                }
            }
            let key = self.key(cell.low, cell.high);
            if !beats(&cell, found) {
                bound = bound.max(key);
                ranked.near.push(cell);
                continue;
            }
            open.extend(cell.cut(at).map(|half| self.ranked(half)));
        }
        let key = |first: &RankedCell| self.key(first.item.low, first.item.high);
        let left = open.peek().map_or(narrow, |first| narrow.max(key(first)));
        if left <= self.best(found) + self.width {
            return Ok((self.value(bound), None));
        }
        // The key of the most promising stretch is the valid bound.
        if self.only != Some(End::Least) {
            sample::sample(self.cycle, found, self.only)?;
        }
        let key = open.peek().map_or(bound, |first| bound.max(key(first)));
        let key = key.max(narrow);
        let doubt = if key.is_finite() {
            Doubt::Effort
        } else {
            Doubt::Unbounded
        };
        Ok((self.value(key), Some(doubt)))
    }

    /// Keeps the stretches of `near` that may equal the best pose; if these are too many, the first in the order of teeth.
    fn keep_near(&self, near: &mut Vec<PartBounds>, found: &ExaminedPoses) {
        let least = self.best(found) - self.equal;
        near.retain(|bounds| self.key(bounds.low, bounds.high) >= least);
        if near.len() > MOST_PLACES {
            near.sort_by_cached_key(|bounds| bounds.part as u64);
            near.sort_by_cached_key(|bounds| self.order_of_teeth(bounds.mating));
            near.truncate(MOST_PLACES);
        }
    }

    /// The key of a sort by wheel tooth, then by pinion tooth.
    fn order_of_teeth(&self, mating: u64) -> u64 {
        let (wheel, pinion) = self.teeth(mating);
        u64::from(wheel) << 32 | u64::from(pinion)
    }

    /// Wheel and pinion tooth of a mating.
    fn teeth(&self, mating: u64) -> (u32, u32) {
        self.cycle.teeth(self.cycle.first_equal(mating))
    }

    /// Reports the first of the places equal to the best: least wheel tooth, then least pinion tooth, then least fraction. Otherwise the
    /// last bit of a sine would decide.
    pub fn report_first_equal(
        &self,
        mut near: Vec<MatingCell>,
        found: &mut ExaminedPoses,
    ) -> Result<(), Error> {
        let least = self.best(found) - self.equal;
        let best = &mut found.best[self.which as usize];
        let Some(named) = best.map(|seen| seen.mating) else {
            return Ok(());
        };
        let teeth = (named.wheel_tooth, named.pinion_tooth);
        near.retain(|cell| self.key(cell.low, cell.high) >= least);
        near.sort_by_cached_key(|cell| numeric::rank(cell.from));
        near.sort_by_cached_key(|cell| self.order_of_teeth(cell.mating));
        for cell in near {
            let own = self.teeth(cell.mating);
            let is_later = own > teeth || own == teeth && cell.from >= named.fraction;
            if is_later || self.cycle.effort.left() <= self.reserved {
                break;
            }
            let holds_named = own == teeth && named.fraction <= cell.to;
            let first = if holds_named {
                let index = self.cycle.first_equal(cell.mating);
                self.equal_at(index, cell.from, least)?
            } else {
                self.first_within(cell, least)?
            };
            if first.is_some() {
                *best = first;
                break;
            }
        }
        Ok(())
    }

    /// The pose of a mating, if it reaches `least`.
    fn equal_at(&self, index: u64, at: f64, least: f64) -> Result<Option<PoseValue>, Error> {
        let mut seen = ExaminedPoses::default();
        seen.examine(self.cycle, self.cycle.mating(index, at))?;
        let one = seen.best[self.which as usize];
        Ok(one.filter(|_| self.best(&seen) >= least))
    }

    /// A pose of a cell that reaches `least`, in the first of its cells that has one.
    fn first_within(&self, cell: MatingCell, least: f64) -> Result<Option<PoseValue>, Error> {
        let index = self.cycle.first_equal(cell.mating);
        let mut open = vec![cell];
        for _ in 0..CELLS_OF_A_PLACE {
            let Some(cell) = open.pop() else {
                break;
            };
            let cell = cell.bounded(self.cycle, self.table);
            if self.key(cell.low, cell.high) < least {
                continue;
            }
            let at = self.expected(&cell);
            for at in [cell.from, at] {
                let seen = self.equal_at(index, at, least)?;
                if seen.is_some() {
                    return Ok(seen);
                }
            }
            let [before, after] = cell.cut(at);
            open.extend([after, before]);
        }
        Ok(None)
    }

    fn value(&self, key: f64) -> f64 {
        -self.which.sign() * key
    }
}

//! The search for one extreme: what may beat the best pose found is cut, the most promising stretch first.

use super::cell::Cell;
use super::course::{Course, PARTS};
use super::extreme::{Doubt, PosesSeen, Proof};
use super::sample::{self, Until};
use super::table::{Bounds, Table};
use crate::error::Error;
use std::collections::BinaryHeap;

/// Cells looked into for one extreme, at most (tuned: a hundred settle an ordinary one; so many take some 20 ms).
const MOST_CELLS: usize = 4_000;

/// Matings whose stretches are taken up before what was overtaken is dropped (tuned: 160 kB of stretches).
const STRIDE: u64 = 512;

/// Which extreme is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Which {
    Least,
    Greatest,
}

impl Which {
    /// How far beyond everything else a stretch with these bounds may reach: the sign makes the least a greatest.
    fn key(self, low: f64, high: f64) -> f64 {
        let key = match self {
            Which::Least => -low,
            Which::Greatest => high,
        };
        // Without a bound it may reach any distance.
        if key.is_nan() { f64::INFINITY } else { key }
    }

    /// How far it reaches for sure.
    fn sure(self, low: f64, high: f64) -> f64 {
        match self {
            Which::Least => -high,
            Which::Greatest => low,
        }
    }
}

/// Stretches that may hold an extreme: those which may reach as far as any that was seen reaches for sure.
struct Candidates<'a> {
    search: &'a Search<'a>,
    kept: Vec<Bounds>,
    /// The most promising.
    top: Option<Bounds>,
    /// How promising that is.
    key: f64,
    /// How far the best reaches for sure.
    sure: f64,
    /// So many may be kept before a pose is looked at, to drop what cannot beat it.
    room: usize,
    /// How promising the best of those dropped is.
    dropped: f64,
}

impl Candidates<'_> {
    fn new<'a>(search: &'a Search<'a>) -> Candidates<'a> {
        Candidates {
            search,
            kept: Vec::new(),
            top: None,
            key: f64::NEG_INFINITY,
            sure: f64::NEG_INFINITY,
            room: STRIDE as usize * PARTS,
            dropped: f64::NEG_INFINITY,
        }
    }

    fn take(&mut self, bounds: Bounds) {
        let which = self.search.which;
        let key = which.key(bounds.low, bounds.high);
        self.sure = self.sure.max(which.sure(bounds.low, bounds.high));
        if key < self.sure {
            return;
        }
        self.kept.push(bounds);
        if self.top.is_none() || key > self.key {
            (self.top, self.key) = (Some(bounds), key);
        }
    }

    /// Looks at the most promising stretch in its middle.
    fn look(&self, found: &mut PosesSeen) -> Result<(), Error> {
        let Some(top) = self.top else {
            return Ok(());
        };
        let cell = Cell::of_part(top.mating, top.part);
        let course = self.search.course;
        let middle = course.mating(top.mating, 0.5 * (cell.from + cell.to));
        found.look(course, middle)
    }

    /// Looks at the most promising stretch where its extreme is expected, and drops what cannot beat that: of gears that repeat themselves
    /// every mating is as promising as any.
    fn thin(&mut self, found: &mut PosesSeen) -> Result<(), Error> {
        let Some(top) = self.top else {
            return Ok(());
        };
        let Search { course, table, .. } = self.search;
        let cell = Cell::of_part(top.mating, top.part).bounded(course, table);
        let at = self.search.expected(&cell);
        found.look(course, course.mating(top.mating, at))?;
        self.drop(found);
        let key = |bounds: &Bounds| self.search.key(bounds.low, bounds.high);
        let top = self.kept.iter().max_by(|a, b| key(a).total_cmp(&key(b)));
        (self.top, self.key) = (top.copied(), top.map_or(f64::NEG_INFINITY, key));
        // Doubled at least, so that this costs no more than keeping.
        self.room = self.room.max(2 * self.kept.len());
        Ok(())
    }

    /// Drops what cannot beat the best found by more than the width.
    fn drop(&mut self, found: &PosesSeen) {
        let (which, dropped) = (self.search.which, &mut self.dropped);
        let enough = self.search.best(found) + self.search.width;
        self.kept.retain(|kept| {
            let key = which.key(kept.low, kept.high);
            if key <= enough {
                *dropped = dropped.max(key);
            }
            key > enough
        });
    }

    /// What has to be looked into.
    fn ranked(mut self, found: &PosesSeen) -> Ranked {
        self.drop(found);
        let open = self.kept.iter().map(|bounds| Open {
            key: self.search.which.key(bounds.low, bounds.high),
            cell: Cell {
                low: bounds.low,
                high: bounds.high,
                ..Cell::of_part(bounds.mating, bounds.part)
            },
        });
        Ranked {
            open: open.collect(),
            bound: self.search.best(found).max(self.dropped),
        }
    }
}

/// A search for one extreme, best bound first.
pub(super) struct Search<'a> {
    pub course: &'a Course<'a>,
    pub table: &'a Table,
    /// Of the bracket, rad.
    pub width: f64,
    pub which: Which,
    /// Effort that is left to what comes after this search.
    pub spare: u64,
    /// How far poses are sampled where the effort was too great.
    pub until: Until,
}

/// A cell in the order in which cells are looked into.
#[derive(Debug)]
struct Open {
    /// How promising it is.
    key: f64,
    cell: Cell,
}

impl PartialEq for Open {
    fn eq(&self, other: &Open) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Open {}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Open) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Open {
    /// The most promising first, of equal ones the first in the cycle.
    fn cmp(&self, other: &Open) -> std::cmp::Ordering {
        let place = |open: &Open| (open.cell.mating, open.cell.part);
        let key = self.key.total_cmp(&other.key);
        let place = key.then(place(other).cmp(&place(self)));
        place.then(other.cell.from.total_cmp(&self.cell.from))
    }
}

/// What one search has to look into.
#[derive(Debug, Default)]
pub(super) struct Ranked {
    open: Vec<Open>,
    /// How promising the best of the rest is.
    bound: f64,
}

/// Looks at the most promising pose of each of `searches` over one cycle, and ranks what may beat the best found.
pub(super) fn rank(searches: &[Search], found: &mut PosesSeen) -> Result<Vec<Ranked>, Error> {
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
            if candidates.kept.len() > candidates.room {
                candidates.thin(found)?;
            }
        }
    }
    for candidates in &candidates {
        candidates.look(found)?;
    }
    let ranked = candidates.into_iter();
    Ok(ranked.map(|candidates| candidates.ranked(found)).collect())
}

impl Search<'_> {
    fn key(&self, low: f64, high: f64) -> f64 {
        self.which.key(low, high)
    }

    /// Where in a cell with its bounds the extreme is expected.
    fn expected(&self, cell: &Cell) -> f64 {
        match self.which {
            Which::Least => cell.lowest,
            Which::Greatest => cell.highest,
        }
    }

    /// The best found, as a key.
    fn best(&self, found: &PosesSeen) -> f64 {
        let seen = match self.which {
            Which::Least => found.least.map(|seen| -seen.angle),
            Which::Greatest => found.greatest.map(|seen| seen.angle),
        };
        seen.unwrap_or(f64::NEG_INFINITY)
    }

    /// The bound that holds for the whole cycle, rad, of the `ranked` stretches of the same search.
    pub fn run(&self, ranked: Ranked, found: &mut PosesSeen) -> Result<Proof, Error> {
        let Ranked { open, mut bound } = ranked;
        let mut open = BinaryHeap::from(open);
        for _ in 0..MOST_CELLS {
            if self.course.effort.left() < self.spare {
                break;
            }
            let Some(next) = open.pop() else {
                return Ok((self.value(bound), None));
            };
            // What is kept is within `width` of the best, or looked into.
            if next.key <= self.best(found) + self.width {
                return Ok((self.value(bound.max(next.key)), None));
            }
            let cell = next.cell.bounded(self.course, self.table);
            let at = self.expected(&cell);
            if cell.seen != Some(at) {
                found.look(self.course, self.course.mating(cell.mating, at))?;
            }
            let without = match self.which {
                Which::Least => found.jammed,
                Which::Greatest => found.unmeshed,
            };
            if without.is_some() {
                // There is no bound of what has no value.
                return Ok((self.value(self.best(found)), None));
            }
            let key = self.key(cell.low, cell.high);
            let enough = self.best(found) + self.width;
            if key <= enough {
                bound = bound.max(key);
                continue;
            }
            for half in cell.cut(at) {
                open.push(Open { key, cell: half });
            }
        }
        // What holds is what the most promising stretch may come to.
        if self.until != Until::Jammed {
            sample::sample(self.course, found, self.until)?;
        }
        let top = open.peek().map_or(bound, |top| bound.max(top.key));
        let doubt = match top.is_finite() {
            true => Doubt::Effort,
            false => Doubt::Unbounded,
        };
        Ok((self.value(top), Some(doubt)))
    }

    fn value(&self, key: f64) -> f64 {
        match self.which {
            Which::Least => -key,
            Which::Greatest => key,
        }
    }
}

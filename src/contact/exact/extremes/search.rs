//! The search for one extreme: what may beat the best pose found is cut, the most promising stretch first.

use super::cell::Cell;
use super::course::Course;
use super::table::{Bounds, Table};
use super::{Doubt, Found, Proof, sample};
use crate::error::Error;
use std::collections::BinaryHeap;

/// Cells looked into for one extreme, at most (tuned: a hundred settle an ordinary one; so many take some 20 ms).
const MOST_CELLS: usize = 4_000;

/// Which extreme is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Which {
    Least,
    Greatest,
}

impl Which {
    /// How far beyond everything else a stretch with these bounds may reach: the sign makes the least a greatest.
    fn key(self, low: f64, high: f64) -> f64 {
        match self {
            Which::Least => -low,
            Which::Greatest => high,
        }
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
struct Candidates {
    which: Which,
    kept: Vec<Bounds>,
    /// The most promising.
    top: Option<Bounds>,
    /// How promising that is.
    key: f64,
    /// How far the best reaches for sure.
    sure: f64,
}

impl Candidates {
    fn new(which: Which) -> Candidates {
        Candidates {
            which,
            kept: Vec::new(),
            top: None,
            key: f64::NEG_INFINITY,
            sure: f64::NEG_INFINITY,
        }
    }

    fn take(&mut self, bounds: Bounds) {
        let key = self.which.key(bounds.low, bounds.high);
        self.sure = self.sure.max(self.which.sure(bounds.low, bounds.high));
        if key < self.sure {
            return;
        }
        self.kept.push(bounds);
        if self.top.is_none() || key > self.key {
            (self.top, self.key) = (Some(bounds), key);
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
    /// Whether poses are sampled where the effort was too great.
    pub samples: bool,
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
pub(super) fn rank(searches: &[Search], found: &mut Found) -> Result<Vec<Ranked>, Error> {
    let Some(Search { course, table, .. }) = searches.first() else {
        return Ok(Vec::new());
    };
    let mut candidates: Vec<Candidates> = searches
        .iter()
        .map(|search| Candidates::new(search.which))
        .collect();
    table.each(0..table.matings(), &mut |bounds| {
        for candidates in &mut candidates {
            candidates.take(bounds);
        }
    });
    for top in candidates.iter().filter_map(|candidates| candidates.top) {
        let middle = Cell::of_part(top.mating, top.part);
        let mating = course.mating(top.mating, 0.5 * (middle.from + middle.to));
        found.look(course, mating)?;
    }
    let ranked = searches.iter().zip(candidates);
    let ranked = ranked.map(|(search, candidates)| search.ranked(&candidates.kept, found));
    Ok(ranked.collect())
}

impl Search<'_> {
    fn key(&self, low: f64, high: f64) -> f64 {
        self.which.key(low, high)
    }

    /// What has to be looked into of all that may hold the extreme.
    fn ranked(&self, kept: &[Bounds], found: &Found) -> Ranked {
        let best = self.best(found);
        let mut ranked = Ranked {
            open: Vec::new(),
            bound: best,
        };
        for bounds in kept {
            let key = self.key(bounds.low, bounds.high);
            if key > best + self.width {
                let cell = Cell {
                    low: bounds.low,
                    high: bounds.high,
                    ..Cell::of_part(bounds.mating, bounds.part)
                };
                ranked.open.push(Open { key, cell });
            } else {
                ranked.bound = ranked.bound.max(key);
            }
        }
        ranked
    }

    /// The best found, as a key.
    fn best(&self, found: &Found) -> f64 {
        let seen = match self.which {
            Which::Least => found.least.map(|seen| -seen.angle),
            Which::Greatest => found.greatest.map(|seen| seen.angle),
        };
        seen.unwrap_or(f64::NEG_INFINITY)
    }

    /// The bound that holds for the whole cycle, rad, of the `ranked` stretches of the same search.
    pub fn run(&self, ranked: Ranked, found: &mut Found) -> Result<Proof, Error> {
        let Ranked { open, mut bound } = ranked;
        let mut open = BinaryHeap::from(open);
        for _ in 0..MOST_CELLS {
            let Some(next) = open.pop() else {
                return Ok((self.value(bound), None));
            };
            // What is kept is within `width` of the best, or looked into.
            if next.key <= self.best(found) + self.width {
                return Ok((self.value(bound.max(next.key)), None));
            }
            let cell = next.cell.bounded(self.course, self.table);
            let at = match self.which {
                Which::Least => cell.lowest,
                Which::Greatest => cell.highest,
            };
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
        if self.samples {
            sample::sample(self.course, found, false)?;
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

//! The least and the greatest lost motion of a pair over its whole mesh cycle and every rotation, proven.
//!
//! Each side has room until its tightest pair of half teeth touches; the lost motion is the sum of both. Two bounds hold over a stretch of
//! a mating: from below, that of each pair as if both were nothing but involutes and their ends, and below the form circle what the
//! fillets leave ([`separation`], [`dip`]); from above, that of any pair at all. Tables ([`table`]) rule out nearly every mating of a
//! long cycle; what is left is cut where its bound is worst until no stretch can beat the best pose found by more than the width
//! asked for. So the bracket holds every rotation of every mating, and one of its ends is a pose of the exact method.
//!
//! What the lower bound asks of a pair is what spares the exact method its searches ([`super::search_free_proof`]). Where that does not
//! hold, poses are sampled, and the result says so.

mod cell;
mod course;
mod dip;
mod fillet;
mod sample;
mod separation;
mod table;

use super::ExactKernel;
use crate::contact::lost_motion::Status;
use crate::error::Error;
use crate::pair::{GearPair, Mating, Pose};
use cell::Cell;
use course::Course;
use std::collections::BinaryHeap;
use table::{Bounds, Table};

/// Cells looked into for one extreme, at most (tuned: a hundred settle an ordinary one; so many take some 20 ms).
const MOST_CELLS: usize = 4_000;

/// Extremes of one assembly over its mesh cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extremes {
    /// Matings of the cycle.
    pub matings: u64,
    /// How the worst of its poses ends: jammed, else out of mesh, else with interference, else clear.
    pub status: Status,
    /// The least; `None` where a pose is jammed.
    pub least: Option<Extreme>,
    /// The greatest; `None` where a pose is out of mesh.
    pub greatest: Option<Extreme>,
    /// A pose that is jammed or out of mesh, where `status` says so.
    pub lost: Option<Mating>,
}

/// One extreme of `j_wt`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extreme {
    /// `j_wt` is no less, mm.
    pub low: f64,
    /// And no greater, mm.
    pub high: f64,
    /// Where the pose stands that attains the end of the bracket which was found.
    pub mating: Mating,
    /// Why the bracket is not proven; `None`: it is.
    pub doubt: Option<Doubt>,
}

impl Extreme {
    /// Whether no rotation of the cycle lies beyond the bracket.
    pub fn is_proven(&self) -> bool {
        self.doubt.is_none()
    }
}

/// Why an extreme is only what was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Doubt {
    /// Fillets or roots may be touched, or a tooth is not an involute: nothing bounds the lost motion between poses.
    OffInvolute,
    /// Too many stretches of the cycle come too near to each other.
    Effort,
    /// A contact was lost at a pose.
    ContactLost,
}

impl ExactKernel {
    /// The extremes of `assembly`, which is this kernel's, over `matings` pitches from `first` on, each bracket no wider than `width` mm
    /// where it is proven.
    ///
    /// # Errors
    /// None of a pair that has a kernel: a contact that is lost is a [`Doubt`].
    pub fn extremes(
        &self,
        assembly: &GearPair,
        first: Mating,
        matings: u64,
        width: f64,
    ) -> Result<Extremes, Error> {
        let course = Course::new(
            self,
            assembly,
            Mating {
                fraction: 0.0,
                ..first
            },
            matings,
        );
        let mut found = Found::default();
        // Without a solver flanks are no involutes, or base circles may overlap.
        if self.blocked || self.bodies.is_some() || self.solver.is_none() {
            sample::sample(&course, &mut found)?;
            return Ok(found.extremes(&course, [UNKNOWN; 2]));
        }
        let table = Table::new(&course);
        let width = width / course.per_radian();
        let greatest = Search::new(&course, &table, width, Which::Greatest).run(&mut found)?;
        let least = match self.stays_on_involutes(&course) {
            true => Search::new(&course, &table, width, Which::Least).run(&mut found)?,
            false => {
                sample::sample(&course, &mut found)?;
                UNKNOWN
            }
        };
        Ok(found.extremes(&course, [least, greatest]))
    }

    /// Whether nothing but involutes, their ends and tip lands can touch, but for corners on fillets, which [`dip`] bounds.
    fn stays_on_involutes(&self, course: &Course) -> bool {
        let side = &course.sides[0];
        let problem = side.problem;
        let forms = problem.locked.shape.form_radius() + problem.free.shape.form_radius();
        self.is_direct() && forms + side.off[0] + side.off[1] < problem.distance
    }
}

/// A bound that holds for the whole cycle, rad, and why it is not as near as it was wanted.
type Proof = (f64, Option<Doubt>);

/// No bound at all.
const UNKNOWN: Proof = (f64::NAN, Some(Doubt::OffInvolute));

/// Poses seen so far.
#[derive(Debug, Default)]
struct Found {
    least: Option<Seen>,
    greatest: Option<Seen>,
    jammed: Option<Mating>,
    unmeshed: Option<Mating>,
    lost: bool,
    /// Whether the cycle was sampled.
    sampled: bool,
}

/// The lost motion at a pose, rad.
#[derive(Debug, Clone, Copy)]
struct Seen {
    angle: f64,
    error: f64,
    mating: Mating,
}

impl Found {
    /// Looks at a pose.
    fn look(&mut self, course: &Course, mating: Mating) -> Result<(), Error> {
        let pose = Pose::new(course.assembly, mating);
        match course.kernel.lost_motion(&pose) {
            Ok(found) => {
                match found.status() {
                    Status::Jammed => self.jammed = self.jammed.or(Some(mating)),
                    Status::NoContact => self.unmeshed = self.unmeshed.or(Some(mating)),
                    _ => (),
                }
                if let Some((angle, error)) = found.angle().zip(found.error()) {
                    self.take(Seen {
                        angle,
                        error,
                        mating,
                    });
                }
                Ok(())
            }
            Err(error) if error.of_one_pose().is_some() => {
                self.lost = true;
                Ok(())
            }
            Err(error) => Err(error),
        }
    }

    fn take(&mut self, seen: Seen) {
        if self.least.is_none_or(|least| seen.angle < least.angle) {
            self.least = Some(seen);
        }
        if self.greatest.is_none_or(|most| seen.angle > most.angle) {
            self.greatest = Some(seen);
        }
    }

    /// The result, with the proofs of the least and the greatest.
    fn extremes(&self, course: &Course, [least, greatest]: [Proof; 2]) -> Extremes {
        let per_radian = course.per_radian();
        let extreme = |seen: Seen, (bound, doubt): Proof| {
            let (low, high) = (seen.angle - seen.error, seen.angle + seen.error);
            let bounds = match bound.is_finite() {
                true => (low.min(bound), high.max(bound)),
                false => (low, high),
            };
            Extreme {
                low: bounds.0 * per_radian,
                high: bounds.1 * per_radian,
                mating: seen.mating,
                doubt: match self.lost {
                    true => Some(Doubt::ContactLost),
                    false => doubt,
                },
            }
        };
        let low_end = self.least.map(|seen| extreme(seen, least));
        let high_end = self.greatest.map(|seen| extreme(seen, greatest));
        let interferes = self.least.is_some_and(|seen| seen.angle < -seen.error);
        let status = match (self.jammed, self.unmeshed) {
            (Some(_), _) => Status::Jammed,
            (None, Some(_)) => Status::NoContact,
            (None, None) if self.least.is_none() => Status::Unproven,
            (None, None) if interferes => Status::Interference,
            (None, None) => Status::Clear,
        };
        Extremes {
            matings: course.matings,
            status,
            least: low_end.filter(|_| self.jammed.is_none()),
            greatest: high_end.filter(|_| self.unmeshed.is_none()),
            lost: self.jammed.or(self.unmeshed),
        }
    }
}

/// Which extreme is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Which {
    Least,
    Greatest,
}

/// A search for one extreme, best bound first.
struct Search<'a> {
    course: &'a Course<'a>,
    table: &'a Table,
    width: f64,
    which: Which,
}

/// A cell in the order in which cells are looked into.
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

impl<'a> Search<'a> {
    fn new(course: &'a Course, table: &'a Table, width: f64, which: Which) -> Search<'a> {
        Search {
            course,
            table,
            width,
            which,
        }
    }

    /// How far beyond everything else a cell may reach: the sign makes the least a greatest.
    fn key(&self, low: f64, high: f64) -> f64 {
        match self.which {
            Which::Least => -low,
            Which::Greatest => high,
        }
    }

    /// The best found, as a key.
    fn best(&self, found: &Found) -> f64 {
        let seen = match self.which {
            Which::Least => found.least.map(|seen| -seen.angle),
            Which::Greatest => found.greatest.map(|seen| seen.angle),
        };
        seen.unwrap_or(f64::NEG_INFINITY)
    }

    /// The bound that holds for the whole cycle, rad.
    fn run(&self, found: &mut Found) -> Result<Proof, Error> {
        let range = 0..self.table.matings();
        let mut top: Option<Bounds> = None;
        self.table.each(range.clone(), &mut |bounds| {
            let key = self.key(bounds.low, bounds.high);
            if top.is_none_or(|top| key > self.key(top.low, top.high)) {
                top = Some(bounds);
            }
        });
        if let Some(top) = top {
            let middle = Cell::of_part(top.mating, top.part);
            let mating = self
                .course
                .mating(top.mating, 0.5 * (middle.from + middle.to));
            found.look(self.course, mating)?;
        }
        let enough = self.best(found) + self.width;
        let mut bound = self.best(found);
        let mut open = BinaryHeap::new();
        self.table.each(range, &mut |bounds| {
            let key = self.key(bounds.low, bounds.high);
            if key > enough {
                let cell = Cell::of_part(bounds.mating, bounds.part);
                open.push(Open {
                    key,
                    cell: Cell {
                        low: bounds.low,
                        high: bounds.high,
                        ..cell
                    },
                });
            } else {
                bound = bound.max(key);
            }
        });
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
            found.look(self.course, self.course.mating(cell.mating, at))?;
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
        sample::sample(self.course, found)?;
        let top = open.peek().map_or(bound, |top| bound.max(top.key));
        Ok((self.value(top), Some(Doubt::Effort)))
    }

    fn value(&self, key: f64) -> f64 {
        match self.which {
            Which::Least => -key,
            Which::Greatest => key,
        }
    }
}

//! The least and the greatest lost motion of outlines over their whole mesh cycle: branch and bound over cells of rotations.
//!
//! A side's contact lies between two lines all through a cell ([`SideCell`]), so the lost motion does too, with the difference of both rates. A cell
//! whose bound is better than the best pose by more than the wanted width is divided. In the end no cell is: the least is no less than the least bound,
//! and no more than the best pose. Where the effort ends before, the bounds left over are the bracket.
//!
//! Near an edge that passes an edge the bounds are off by the first order of a cell's width, elsewhere by the second: each division brings the
//! extreme nearer by a constant factor, and few cells stay open.
//!
//! Cells are divided in rounds of a fixed number, so that any number of threads finds the same.

use super::cell::{Bound, SideCell, Touching};
use super::teeth::Frame;
use super::{Meeting, OutlineKernel, SideKernel};
use crate::contact::effort::Effort;
use crate::contact::exact::{Doubt, End, Extreme, Extremes};
use crate::contact::gap::{C, turn};
use crate::contact::lost_motion::Status;
use crate::outline::OutlinePair;
use crate::pair::Mating;
use crate::parallel;
use std::cmp::Ordering;

/// Cells a pitch to begin with (tuned).
const CELLS_A_PITCH: u64 = 4;

/// Cells to begin with at most (tuned: some seconds). Longer cycles have wider cells.
const MOST_CELLS: u64 = 60_000;

/// Cells divided in one round: a quarter of the open ones, or this number (tuned: enough for a machine's cores, few enough that the best
/// pose is known soon).
const ROUND: usize = 96;

/// A cell of this width, pitches, that nothing bounds, ends the search: no bracket has that end.
const UNBOUNDED: f64 = 1e-6;

/// Parts of a cell at most (tuned).
const MOST_PARTS: f64 = 8.0;

/// Share of the wanted width at which bounds may stop.
const ENOUGH: f64 = 0.8;

/// Greatest rate of a contact over the ratio of the teeth. The ratio itself replaces greater rates.
const FASTEST: f64 = 4.0;

/// Units of [`Effort`] for one end (tuned: some seconds).
const MOST_EFFORT: u64 = 10_000_000;

/// A closed search goes on to this share of the wanted width, with this effort.
const FINER: f64 = 0.1;
const FINER_EFFORT: u64 = 500_000;

/// Comparisons of two rectangles per unit of effort (tuned).
const A_UNIT: u64 = 2;

/// Steps towards the best pose beside the best cell: 2⁻²⁰ of its width.
const POLISHED: u32 = 20;

/// Values that differ by less, rad, are equal: rounding of different platforms.
const EQUAL: f64 = 1e-12;

/// A mesh cycle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OutlineCycle {
    /// Where it begins.
    pub first: Mating,
    /// Matings after which all is as it was.
    pub distinct: u64,
    /// All of its matings.
    pub matings: u64,
    /// How far a tooth of a gear whose teeth count as equal may lie from the next one, mm; of both gears together.
    pub unlike: f64,
}

/// A stretch of the cycle and what is known of its lost motion, rad.
#[derive(Debug, Clone, Copy)]
struct Cell {
    /// The middle, pitches from the first pose.
    pitches: f64,
    /// Half its width, pitches.
    half: f64,
    status: Status,
    /// In the middle, and its error.
    angle: Option<(f64, f64)>,
    /// The lost motion is no less, −∞ where nothing bounds it, and what the drawings may take off that.
    low: (f64, f64),
    /// It is no greater, and what the drawings may add.
    high: (f64, f64),
    effort: u64,
}

impl Cell {
    /// The value in the middle, of which the least is sought.
    fn value(&self, end: End) -> Option<f64> {
        let (angle, _) = self.angle?;
        Some(end.sign() * angle)
    }

    /// No value of the cell is less, and what the drawings take off.
    fn bound(&self, end: End) -> (f64, f64) {
        match end {
            End::Least => self.low,
            End::Greatest => (-self.high.0, self.high.1),
        }
    }
}

impl OutlineKernel<'_> {
    /// The extremes `ends` of `pair`, these gears, over a cycle, in brackets of `width` mm where no more effort is needed than a search may spend.
    pub(crate) fn extremes(
        &self,
        pair: &OutlinePair,
        cycle: &OutlineCycle,
        ends: &[End],
        width: f64,
    ) -> Extremes {
        let radius = pair.operating_pitch_radius(pair.free());
        let search = CycleSearch {
            kernel: self,
            pair,
            cycle,
            width: ENOUGH * width / radius,
        };
        let cells = search.begin(ends);
        let lost = [Status::Jammed, Status::NoContact].map(|status| {
            let lost = cells.iter().find(|cell| cell.status == status);
            lost.map(|cell| search.mating(cell.pitches))
        });
        let [jammed, unmeshed] = lost;
        let mut all = cells.clone();
        let mut found = |end: End, lost: Option<Mating>| {
            if lost.is_some() || !ends.contains(&end) {
                return None;
            }
            let mut cells = cells.clone();
            let closed = search.close(&mut cells, end, search.width, &Effort::new(MOST_EFFORT));
            search.polish(&mut cells, end);
            if closed {
                let finer = Effort::new(FINER_EFFORT);
                search.close(&mut cells, end, FINER * search.width, &finer);
            }
            let found = search.extreme(&cells, end, closed, radius);
            all.extend(cells);
            found
        };
        let (least, greatest) = (found(End::Least, jammed), found(End::Greatest, unmeshed));
        let first = |status: Status| {
            let lost = all.iter().filter(|cell| cell.status == status);
            let lost = lost.min_by(|a, b| a.pitches.total_cmp(&b.pitches));
            lost.map(|cell| search.mating(cell.pitches))
        };
        let (jammed, unmeshed) = (first(Status::Jammed), first(Status::NoContact));
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
        Extremes {
            matings: cycle.matings,
            status,
            least: least.filter(|_| jammed.is_none()),
            greatest: greatest.filter(|_| unmeshed.is_none()),
            lost: jammed.or(unmeshed),
        }
    }
}

struct CycleSearch<'a> {
    kernel: &'a OutlineKernel<'a>,
    pair: &'a OutlinePair,
    cycle: &'a OutlineCycle,
    /// Wanted width of the bracket, rad.
    width: f64,
}

impl CycleSearch<'_> {
    fn mating(&self, pitches: f64) -> Mating {
        self.cycle.first.onward(self.pair, pitches)
    }

    /// The cells to begin with.
    fn begin(&self, ends: &[End]) -> Vec<Cell> {
        let pitches = self.cycle.distinct;
        let count = (CELLS_A_PITCH * pitches).min(MOST_CELLS.max(pitches.min(2 * MOST_CELLS)));
        let apart = pitches as f64 / count as f64;
        let each = (0..count).map(|k| ((k as f64 + 0.5) * apart, 0.5 * apart));
        parallel::map(each, |(at, half)| self.look(at, half, ends))
    }

    /// Divides cells until none of them may be better than the best pose by more than `width`, rad, or `effort` is spent; whether it is not.
    fn close(&self, cells: &mut Vec<Cell>, end: End, width: f64, effort: &Effort) -> bool {
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
            if is_closed || effort.is_spent() || open.iter().any(is_lost) {
                cells.extend(open);
                return is_closed;
            }
            open.sort_by(|a, b| {
                let [one, other] = [a, b].map(|cell| cell.bound(end).0);
                one.total_cmp(&other).then(a.pitches.total_cmp(&b.pitches))
            });
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
            let parts = parallel::map(parts, |(at, half)| self.look(at, half, &[end]));
            effort.spend(parts.iter().map(|cell| cell.effort).sum());
            best = values(&parts, best);
            left.extend(parts);
        }
    }

    /// Adds poses beside the best one, ever nearer to the best of them.
    fn polish(&self, cells: &mut Vec<Cell>, end: End) {
        let valued = cells.iter().filter(|cell| cell.value(end).is_some());
        let order = |a: &&Cell, b: &&Cell| a.value(end).partial_cmp(&b.value(end));
        let best = valued.min_by(|a, b| order(a, b).unwrap_or(Ordering::Equal));
        let Some(mut best) = best.copied() else {
            return;
        };
        let mut half = best.half;
        for _ in 0..POLISHED {
            let beside = parallel::map([-1.0, -0.5, 0.5, 1.0], |share| {
                self.look(best.pitches + share * half, 0.0, &[])
            });
            for pose in beside {
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
            half *= 0.5;
        }
    }

    /// The bracket that cells leave, the first of the equal poses with it.
    fn extreme(&self, cells: &[Cell], end: End, closed: bool, radius: f64) -> Option<Extreme> {
        let best = cells.iter().filter_map(|cell| cell.value(end));
        let best = best.reduce(f64::min)?;
        let equal = cells
            .iter()
            .filter(|cell| cell.value(end).is_some_and(|value| value <= best + EQUAL));
        let pose = equal.min_by(|a, b| a.pitches.total_cmp(&b.pitches))?;
        let (angle, error) = pose.angle?;
        let bounds = cells.iter().map(|cell| {
            let (bound, drawn) = cell.bound(end);
            bound - drawn
        });
        let bound = bounds.fold(end.sign() * angle - error, f64::min);
        let (low, high) = match end {
            End::Least => (bound, angle + error),
            End::Greatest => (angle - error, -bound),
        };
        let doubt = if !closed {
            Some(Doubt::Effort)
        } else if high - low > self.width / ENOUGH {
            Some(Doubt::Drawing)
        } else {
            None
        };
        Some(Extreme {
            low: low * radius,
            high: high * radius,
            found: angle * radius,
            mating: self.mating(pose.pitches),
            doubt,
        })
    }

    /// Looks at the pose in the middle of a cell, and bounds it.
    fn look(&self, pitches: f64, half: f64, ends: &[End]) -> Cell {
        let (kernel, pair) = (self.kernel, self.pair);
        let mating = self.mating(pitches);
        let spent = Effort::of_pose();
        let mut cell = Cell {
            pitches,
            half,
            status: Status::Unproven,
            angle: None,
            low: (f64::NEG_INFINITY, 0.0),
            high: (f64::INFINITY, 0.0),
            effort: 0,
        };
        let meetings = kernel
            .sides
            .each_ref()
            .map(|side| side.meeting(pair, &mating, true, &spent));
        cell.effort = spent.used();
        let [Ok(right), Ok(left)] = meetings else {
            return cell;
        };
        let meetings = [right, left];
        let found = kernel.lost_motion_of(pair, &mating, meetings.each_ref().map(Option::as_ref));
        cell.status = found.status();
        cell.angle = found.angle().zip(found.error());
        // Nothing bounds a cell wider than a pitch.
        if half > 0.5 {
            return cell;
        }
        let width = half * pair.gear(pair.locked()).pitch();
        let cells = [0, 1].map(|side: usize| {
            let meeting = meetings[side].as_ref();
            let mut cell = kernel.sides[side].cell(pair, &mating, meeting, width, self.width);
            cell.bound += self.cycle.unlike;
            cell
        });
        let drift = (cells[0].rate - cells[1].rate).abs() * width;
        if ends.contains(&End::Least) && !kernel.may_jam(pair, &mating, width) {
            let each = [0, 1].map(|side: usize| {
                let floor = meetings[side]
                    .map_or(-0.5 * pair.gear(pair.free()).pitch(), |meeting| {
                        meeting.found.gap
                    });
                let (bound, looked) =
                    kernel.sides[side].above(pair, &mating, &cells[side], floor.max(-0.5));
                cell.effort += u64::from(looked) / A_UNIT;
                bound
            });
            if let [Some(right), Some(left)] = each {
                cell.low = (-right.level - left.level - drift, right.drawn + left.drawn);
            }
        }
        if ends.contains(&End::Greatest) {
            let each = [0, 1].map(|side: usize| {
                let meeting = meetings[side].as_ref()?;
                cells[side].below(&kernel.sides[side].touch(meeting))
            });
            if let [Some(right), Some(left)] = each {
                cell.high = (-right.level - left.level + drift, right.drawn + left.drawn);
            }
        }
        cell
    }
}

impl OutlineKernel<'_> {
    /// Whether teeth may reach the solid body of the mate in a cell of half width `half`, rad.
    fn may_jam(&self, pair: &OutlinePair, mating: &Mating, half: f64) -> bool {
        let reach = pair.gear(pair.locked()).reach();
        // No point turns faster about the locked axis.
        pair.center_distance() - reach < self.solid
            && self.sides[0].reaches_within(pair, mating, self.solid + half * reach)
    }
}

impl<'a> SideKernel<'a> {
    /// The cell of half the width `half`, rad of the locked gear, about `mating`, for bounds that are `width` wide in the end, rad of the free gear.
    fn cell(
        &'a self,
        pair: &OutlinePair,
        mating: &Mating,
        meeting: Option<&Meeting>,
        half: f64,
        width: f64,
    ) -> SideCell<'a> {
        let (_, locked) = self.locked_frame(pair, mating);
        let free_rotation = -self.side.sense() * pair.rotation(pair.free(), mating);
        let ratio = -self.free.gear.pitch() / self.locked.gear.pitch();
        let distance = pair.center_distance();
        // Both points of a contact move equally fast along its normal.
        let rate = meeting.map_or(ratio, |meeting| {
            let ([p, _], n, _) = self.touching(meeting);
            let along = |arm: C| n.re * -arm.im + n.im * arm.re;
            along(p.point - distance) / along(p.point)
        });
        SideCell {
            teeth: [&self.locked, &self.free],
            still: &self.still,
            frames: [
                locked,
                Frame {
                    centre: self.free.displacement,
                    direction: C::ONE,
                },
            ],
            nominal: turn(free_rotation),
            distance,
            half,
            ratio,
            rate: if (rate / ratio).abs() <= FASTEST {
                rate
            } else {
                ratio
            },
            fine: (width / 16.0).max(half * half / 8.0),
            bound: self.locked.gear.bound() + self.free.gear.bound(),
        }
    }

    fn touch(&self, meeting: &Meeting) -> Touching {
        let ([p, q], normal, _) = self.touching(meeting);
        Touching {
            level: meeting.found.gap,
            teeth: meeting.teeth,
            at: [meeting.found.locked, meeting.found.free],
            normals: [
                normal,
                p.normal,
                -q.normal * turn(meeting.nominal + meeting.found.gap),
            ],
        }
    }

    fn above(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        cell: &SideCell,
        floor: f64,
    ) -> (Option<Bound>, u32) {
        let (rotation, _) = self.locked_frame(pair, mating);
        cell.above(self.facing(pair, mating, rotation, cell.half), floor)
    }
}

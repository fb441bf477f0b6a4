//! Bounds of every mating of a cycle from tables: a few sums each.
//!
//! Where two involutes touch on the line of action, the room a side has is `ρ + r δ_L + δ_F − ε`: what perfect gears would have, what both
//! flanks are off their places (`r = r_bL/r_bF`) and what the eccentricities take, which is the shift `b` of the centres along the line
//! of action: `ε = (−b_x sin α + b_y cos α)/r_bF`, but for its second order. Beside the line of action a pair has more room. How much more at least
//! depends on the part of the pitch alone, so it is worked out once for each of [`PARTS`]; and so is which pairs stand on
//! the line of action all through a part: these bound the room from above.

use super::super::line::Line;
use super::super::shape::{C, turn};
use super::super::teeth::Teeth;
use super::course::{Course, SideCourse};
use super::separation::lowest_roll;
use std::f64::consts::TAU;
use std::ops::Range;

/// Parts of a pitch (tuned: ordinary pairs, contact ratio 1.2 and more, have a pair on the line of action all through each).
pub(super) const PARTS: usize = 8;

/// One side's tables.
#[derive(Debug)]
struct SideTable {
    /// `r δ_L` and `δ_F` by place, some places more at both ends.
    locked: Vec<f64>,
    free: Vec<f64>,
    pad: i64,
    /// Places of step 0 where the cycle begins; the locked one falls by `sense` with each mating.
    first: [i64; 2],
    sense: i64,
    /// Steps that may be the tightest, and what they have beside the line of action at least.
    open: [Vec<(i64, f64)>; PARTS],
    /// Steps that are on the line of action all through.
    covering: [Vec<i64>; PARTS],
    /// `ρ`.
    nominal: f64,
}

/// Both sides'.
#[derive(Debug)]
pub(super) struct Table {
    sides: [SideTable; 2],
    /// `−ε` of both sides together, by the locked and by the free gear's turn, at the ends of the parts.
    shifts: [Vec<[f64; PARTS + 1]>; 2],
    /// What the sums are off at most: the second order of `ε`, and its bend between the ends of a part.
    slack: f64,
    matings: u64,
}

/// Bounds of the lost motion over a part of a mating, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    pub mating: u64,
    pub part: usize,
    pub low: f64,
    pub high: f64,
}

impl Table {
    pub fn new(course: &Course) -> Table {
        let sides = course
            .sides
            .each_ref()
            .map(|side| SideTable::new(course, side));
        let side = &course.sides[0];
        let problem = side.problem;
        let per_base = problem.per_free_base;
        let off = side.off[0] + side.off[1];
        let nearest = problem.distance - off;
        let sum = problem.sum();
        let length = ((nearest - sum) * (nearest + sum)).sqrt();
        let turning = (1.0 + sum / length) / nearest;
        // Of each side: the gap at which `b` is taken, the second order in `b`, the bend over a part.
        let spread = sides.iter().map(|side| side.spread()).fold(0.0, f64::max);
        let level = 0.5 * spread + off * per_base / (1.0 - side.off[1] * per_base);
        let moved = side.off[1] * per_base * level / (1.0 - side.off[1] * per_base);
        let pitches = [problem.locked.pitch, problem.free.pitch];
        let bends = [0, 1].map(|k| side.off[k] * pitches[k] * pitches[k]);
        let part = 1.0 / PARTS as f64;
        let slack = 2.0
            * (moved
                + 0.5 * turning * off * off * per_base
                + (bends[0] + bends[1]) * per_base * part * part / 8.0)
            + 4.0 * problem.rounding(problem.free.shape.base, 1.0);
        Table {
            shifts: shifts(course, &sides),
            sides,
            slack,
            matings: course.matings,
        }
    }

    /// Bounds of every part of every mating of `range`, in their order.
    pub fn each(&self, range: Range<u64>, take: &mut dyn FnMut(Bounds)) {
        let [locked, free] = &self.shifts;
        for mating in range {
            let x = &locked[(mating % locked.len() as u64) as usize];
            let y = &free[(mating % free.len() as u64) as usize];
            let places = self.sides.each_ref().map(|side| side.places(mating));
            for part in 0..PARTS {
                let shift = [x[part] + y[part], x[part + 1] + y[part + 1]];
                let (mut low, mut high) = (0.0, 0.0);
                for (side, places) in self.sides.iter().zip(places) {
                    let open = side.open[part].iter();
                    low += open
                        .map(|(step, more)| side.off(places, *step) + more)
                        .fold(f64::INFINITY, f64::min);
                    let covering = side.covering[part].iter();
                    high += covering
                        .map(|step| side.off(places, *step))
                        .fold(f64::INFINITY, f64::min);
                }
                let nominal = self.sides[0].nominal + self.sides[1].nominal;
                take(Bounds {
                    mating,
                    part,
                    low: low + nominal + shift[0].min(shift[1]) - self.slack,
                    high: high + nominal + shift[0].max(shift[1]) + self.slack,
                });
            }
        }
    }

    pub fn matings(&self) -> u64 {
        self.matings
    }

    /// Steps of a side that may be the tightest in a part of a mating, those that need not have more room than one on the line of action,
    /// and how much more than its own place on the line of action gives that would be.
    pub fn steps(
        &self,
        side: usize,
        mating: u64,
        part: usize,
    ) -> impl Iterator<Item = (i64, f64)> + '_ {
        let table = &self.sides[side];
        let places = table.places(mating);
        let covering = table.covering[part].iter();
        let limit = covering.map(|step| table.off(places, *step));
        let limit = limit.fold(f64::INFINITY, f64::min) + self.slack;
        let open = table.open[part].iter();
        open.filter_map(move |(step, more)| {
            let enough = limit - table.off(places, *step);
            (*more <= enough).then_some((*step, enough))
        })
    }
}

/// `−ε` of both sides, by turn and end of the parts.
fn shifts(course: &Course, sides: &[SideTable; 2]) -> [Vec<[f64; PARTS + 1]>; 2] {
    let posed = course.posed(0);
    let problem = course.sides[0].problem;
    let counts = [&problem.locked, &problem.free].map(|teeth| teeth.count() as usize);
    let mut shifts = counts.map(|count| vec![[0.0; PARTS + 1]; count]);
    for ((posed, side), table) in posed.iter().zip(&course.sides).zip(sides) {
        let problem = side.problem;
        let sum = problem.sum();
        let sin = (1.0 - (sum / problem.distance).powi(2)).sqrt();
        let toward = C::new(-sin, sum / problem.distance) * problem.per_free_base;
        // The middle of the gaps on the line of action.
        let gap = posed.nominal_gap() - table.nominal - table.middle();
        let locked = posed.flanks.centre - C::from(problem.distance);
        let free = -posed.flanks.free_centre * turn(gap);
        for (place, at, sense) in [(0, locked, side.sense), (1, free, -side.sense)] {
            if at == C::ZERO {
                continue;
            }
            let count = counts[place] as f64;
            for (index, ends) in shifts[place].iter_mut().enumerate() {
                for (part, end) in ends.iter_mut().enumerate() {
                    let pitches = index as f64 + part as f64 / PARTS as f64;
                    let b = at * turn(sense * TAU * pitches / count);
                    *end -= toward.re * b.re + toward.im * b.im;
                }
            }
        }
    }
    shifts
}

impl SideTable {
    fn new(course: &Course, side: &SideCourse) -> SideTable {
        let problem = side.problem;
        let index = usize::from(!std::ptr::eq(side, &raw const course.sides[0]));
        let posed = course.posed(0)[index];
        let steps = steps(side, posed.flanks.ahead);
        let pad = steps.start.abs().max(steps.end.abs());
        let ratio = problem.locked.shape.base * problem.per_free_base;
        let padded = |teeth: &Teeth, by: f64| -> Vec<f64> {
            let count = teeth.count();
            let places = -pad..count + pad;
            places
                .map(|place| by * teeth.offset(place.rem_euclid(count) as usize))
                .collect()
        };
        let places = posed.flanks.places(0);
        let mut table = SideTable {
            locked: padded(&problem.locked, ratio),
            free: padded(&problem.free, 1.0),
            pad,
            first: [places.0 as i64, places.1 as i64],
            sense: side.sense as i64,
            open: std::array::from_fn(|_| Vec::new()),
            covering: std::array::from_fn(|_| Vec::new()),
            nominal: 0.0,
        };
        let Some(line) = Line::new(C::from(problem.distance), problem.sum()) else {
            return table;
        };
        let pair = posed.flanks.pair(0);
        let gap = (problem.sum() * line.angle
            - line.length
            - problem.locked.shape.base * pair.locked_base)
            * problem.per_free_base
            - pair.free_base;
        table.nominal = posed.room(gap) - table.off(table.places(0), 0);
        let spread = table.spread();
        let rolls = Rolls::new(side, &line, posed.flanks.ahead, spread);
        for part in 0..PARTS {
            let found = steps.clone().map(|step| (step, rolls.of(step, part)));
            let found: Vec<(i64, Part)> = found.collect();
            // What has more room than any pair on the line of action can have is never the tightest.
            let limit = match found.iter().any(|(_, part)| part.covers) {
                true => spread,
                false => f64::INFINITY,
            };
            let open = found.iter().filter(|(_, part)| part.more <= limit);
            table.open[part] = open.map(|(step, part)| (*step, part.more)).collect();
            let covering = found.iter().filter(|(_, part)| part.covers);
            table.covering[part] = covering.map(|(step, _)| *step).collect();
        }
        table
    }

    /// Places of step 0 at a mating.
    fn places(&self, mating: u64) -> [i64; 2] {
        let counts = [&self.locked, &self.free].map(|offsets| offsets.len() as i64 - 2 * self.pad);
        let on = [-self.sense, self.sense];
        [0, 1].map(|k| {
            let turned = (mating % counts[k] as u64) as i64;
            (self.first[k] + on[k] * turned).rem_euclid(counts[k])
        })
    }

    /// `r δ_L + δ_F` of a step.
    fn off(&self, [locked, free]: [i64; 2], step: i64) -> f64 {
        self.locked[(self.pad + locked + step) as usize]
            + self.free[(self.pad + free - step) as usize]
    }

    fn ends(&self) -> [f64; 2] {
        let ends = |offsets: &[f64]| {
            let fold = |(low, high): (f64, f64), off: &f64| (low.min(*off), high.max(*off));
            offsets
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), fold)
        };
        let (locked, free) = (ends(&self.locked), ends(&self.free));
        [locked.0 + free.0, locked.1 + free.1]
    }

    /// How much `r δ_L + δ_F` differs over all flanks.
    fn spread(&self) -> f64 {
        let [low, high] = self.ends();
        high - low
    }

    fn middle(&self) -> f64 {
        let [low, high] = self.ends();
        0.5 * (low + high)
    }
}

/// Steps whose locked half tooth can reach the free gear somewhere in a pitch.
fn steps(side: &SideCourse, ahead: f64) -> Range<i64> {
    let problem = side.problem;
    let Some((low, high)) = problem.window() else {
        return 0..0;
    };
    let beyond = ahead + side.sense * problem.locked.pitch;
    let (first, last) = (ahead.min(beyond), ahead.max(beyond));
    let half = (problem.locked.count() - 1) / 2;
    let from = ((low - last) * problem.per_pitch).floor() as i64;
    let to = ((high - first) * problem.per_pitch).ceil() as i64;
    from.max(-half)..to.min(half + 1) + 1
}

/// What a part of a pitch means for a step.
struct Part {
    /// Room beside the line of action at least, rad.
    more: f64,
    covers: bool,
}

/// Rolls on the line of action at any pose of the cycle.
struct Rolls<'a> {
    side: &'a SideCourse<'a>,
    line: &'a Line,
    ahead: f64,
    /// What `arg B + α` and `T` change by, and the flanks' places.
    turning: f64,
    stretching: f64,
    places: f64,
    /// How much flanks differ: a clearance beyond that decides nothing.
    spread: f64,
}

impl<'a> Rolls<'a> {
    fn new(side: &'a SideCourse<'a>, line: &'a Line, ahead: f64, spread: f64) -> Rolls<'a> {
        let problem = side.problem;
        let off = side.off[0] + side.off[1];
        let (sum, nearest) = (problem.sum(), problem.distance - off);
        let length = ((nearest - sum) * (nearest + sum)).sqrt();
        let (low, high) = problem.locked.extremes;
        Rolls {
            side,
            line,
            ahead,
            turning: off * (1.0 + sum / length) / nearest,
            stretching: off * (problem.distance + off) / length,
            places: low.abs().max(high.abs()),
            spread,
        }
    }

    fn of(&self, step: i64, part: usize) -> Part {
        let problem = self.side.problem;
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let pitch = problem.locked.pitch;
        let width = pitch / PARTS as f64;
        let at = self.ahead + step as f64 * pitch + self.side.sense * (part as f64 + 0.5) * width;
        let play = 0.5 * width + self.places + self.turning;
        let roll = self.line.angle - (at - locked.half_base);
        let (low, high) = (roll - play, roll + play);
        let other = |roll: f64, length: f64| (length - locked.base * roll) * problem.per_free_base;
        let (free_low, free_high) = (
            other(high, self.line.length - self.stretching),
            other(low, self.line.length + self.stretching),
        );
        let covers = low >= locked.form_roll
            && high <= locked.tip_roll
            && free_low >= free.form_roll
            && free_high <= free.tip_roll;
        let rolls = [(low, high), (free_low, free_high)];
        let beside = self.beside(rolls);
        let dips = self.side.dips.iter();
        let off = self.side.off[0] + self.side.off[1];
        let distances = (problem.distance - off, problem.distance + off);
        let dips = dips
            .filter(|dip| dip.may_dip(at, play))
            .map(|dip| dip.clearance(at, play, distances, self.spread));
        Part {
            more: dips.fold(beside, f64::min),
            covers,
        }
    }

    /// What a pair with rolls in these ranges has beside the line of action at least, rad.
    ///
    /// In the direction `y` on from that of the line of action, `s` is less by `T (1 − cos y) + Σ (y − sin y)` and more by what the ends of the
    /// involutes give. Any `y` will do; three are tried: none, the one at which a tip corner alone would have the most, and the one that leaves
    /// no roll below the form roll.
    fn beside(&self, rolls: [(f64, f64); 2]) -> f64 {
        let problem = self.side.problem;
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let (sum, length) = (problem.sum(), self.line.length);
        let more = |y: f64| -> f64 {
            let loss = (length + self.stretching) * (1.0 - y.cos()) + sum * (y - y.sin()).max(0.0);
            let each = shapes.iter().zip(rolls);
            let gain: f64 = each
                .map(|(shape, (low, high))| {
                    shape.base * beside((low + y, high + y), (lowest_roll(shape), shape.tip_roll))
                })
                .sum();
            // The free gear turns by `s/(r_b q')`; q' is between 0.8 and 1.25 down to half a radian below the form roll.
            let apart = (gain - loss) * problem.per_free_base;
            if apart > 0.0 {
                0.8 * apart
            } else {
                1.25 * apart
            }
        };
        let each = || shapes.iter().zip(rolls);
        let below = each().map(|(shape, (low, high))| lowest_roll(shape) - 0.5 * (low + high));
        let below = below.fold(0.0, f64::max);
        let corner = each().map(|(shape, (low, _))| {
            let arm = shape.base * shape.tip_roll;
            (low - shape.tip_roll).max(0.0) * arm / (length - arm).max(0.1 * length)
        });
        let corner = corner.fold(0.0, f64::max);
        [0.0, corner, below]
            .map(more)
            .into_iter()
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

/// What an involute has less than all of it would, in the direction of a roll between `low` and `high`, at least: `ξ − q`.
///
/// Beyond the tip it grows, `δ − sin δ + ξ_a (1 − cos δ)`. Below the form roll it grows first and may then fall below 0: least at an end.
fn beside((low, high): (f64, f64), (form, tip): (f64, f64)) -> f64 {
    let at = |end: f64, roll: f64| {
        let beyond = roll - end;
        beyond - beyond.sin() + end * (1.0 - beyond.cos())
    };
    let tip_side = if low > tip { at(tip, low) } else { 0.0 };
    let form_side = match (low < form, high < form) {
        (false, _) => 0.0,
        (true, false) => at(form, low).min(0.0),
        (true, true) => at(form, low).min(at(form, high)),
    };
    tip_side + form_side
}

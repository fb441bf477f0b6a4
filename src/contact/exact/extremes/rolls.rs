//! Rolls of the half teeth of a step in a part of a pitch, and their room beside the line of action.

use super::super::line::Line;
use super::super::separation::land_roll;
use super::clearance::{HALVINGS, LinesAtDistances, stays_clear, tip_clearance};
use super::mesh_cycle::{CycleSide, PARTS};

/// Part of a turn that is examined together over a face of helical gears (tuned: no tip of 44 standard teeth seems to reach a fillet).
pub(super) const PIECE: f64 = 0.25;

/// A clearance that exceeds the spread of the flanks by this, rad, does not matter.
const BEYOND: f64 = 1e-12;

/// Halvings of a stretch before the path of the corner is followed instead. That takes as long as some 60 bounds (tuned).
const HALVINGS_BEFORE_PATH: u32 = 1;

/// Least room of a step in a part of a pitch.
#[derive(Debug, Clone, Copy)]
pub(super) struct StepRoom {
    /// Least room of the involutes and their ends beside the line of action, rad.
    pub beside: f64,
    /// Room of a tip corner and a fillet, at the least and at the greatest distance of the outlines' centres; `None`: none is near.
    pub at_fillet: Option<[f64; 2]>,
}

/// Rolls on the line of action at any pose of the cycle.
pub(super) struct RollsOnLine<'a> {
    side: &'a CycleSide<'a>,
    line: &'a Line,
    /// The lines at the least and the greatest distance of the outlines' centres.
    lines: Option<LinesAtDistances>,
    ahead: f64,
    /// Greatest change of `arg B + α` and of `T`, and of the flanks' places.
    turning: f64,
    stretching: f64,
    places: f64,
    /// Greatest difference between the flanks, rad: a larger clearance does not matter.
    spread: f64,
}

impl StepRoom {
    /// Least room, rad.
    pub fn least(&self) -> f64 {
        self.between([0.0, 1.0])
    }

    /// Least room, rad, if the centre distance stays between two shares of its range.
    pub fn between(&self, [low, high]: [f64; 2]) -> f64 {
        match self.at_fillet {
            None => self.beside,
            Some([a, b]) if a.is_finite() && b.is_finite() => {
                let at = |share: f64| a + share * (b - a);
                self.beside.min(at(low)).min(at(high))
            }
            Some([a, b]) => self.beside.min(a).min(b),
        }
    }

    /// Least room of a tip corner and a fillet, rad; ∞ if none is near.
    pub fn at_fillets(&self) -> f64 {
        self.at_fillet.map_or(f64::INFINITY, |[a, b]| a.min(b))
    }
}

impl<'a> RollsOnLine<'a> {
    pub fn new(
        side: &'a CycleSide<'a>,
        line: &'a Line,
        ahead: f64,
        spread: f64,
    ) -> RollsOnLine<'a> {
        let problem = side.problem;
        let off = side.off[0] + side.off[1];
        let (nearest, farthest) = side.distances();
        let sum = problem.sum();
        let length = ((nearest - sum) * (nearest + sum)).sqrt();
        let (low, high) = problem.locked.offset_range;
        RollsOnLine {
            side,
            line,
            lines: LinesAtDistances::new((nearest, farthest), sum),
            ahead,
            turning: off * (1.0 + sum / length) / nearest,
            stretching: off * farthest / length,
            places: low.abs().max(high.abs()),
            spread,
        }
    }

    /// The middle of a step's angles in a part of a pitch, in the measuring plane, and their distance from it.
    fn place(&self, step: i64, part: usize) -> (f64, f64) {
        let pitch = self.side.problem.locked.pitch;
        let width = pitch / PARTS as f64;
        let at = self.ahead + step as f64 * pitch + self.side.sense * (part as f64 + 0.5) * width;
        (at, 0.5 * width)
    }

    /// The room of a step in a part of a pitch. Above `enough` it is not refined.
    ///
    /// For helical gears it covers the whole common face: all sections, piece by piece of turn.
    pub fn of(&self, step: i64, part: usize, enough: f64) -> StepRoom {
        let (at, half) = self.place(step, part);
        let [from, to] = self.side.turns;
        if from == to {
            return self.around(at + from, half, enough);
        }
        // The range over the face and over the part.
        let all = to - from + 2.0 * half;
        let pieces = (all / (PIECE * 2.0 * half)).ceil();
        let first = at + from - half;
        let half = 0.5 * all / pieces;
        let each = (0..pieces as u64)
            .map(|piece| self.around(first + (2 * piece + 1) as f64 * half, half, enough));
        let all = each.reduce(|one, other| StepRoom {
            beside: one.beside.min(other.beside),
            at_fillet: match (one.at_fillet, other.at_fillet) {
                (Some(a), Some(b)) => Some([a[0].min(b[0]), a[1].min(b[1])]),
                (a, b) => a.or(b),
            },
        });
        all.expect("at least one piece")
    }

    /// Whether a step is on the line of action all through a part of a pitch, in some section of the face.
    ///
    /// In a section turned by `σ` the locked roll is less by `σ` and the free one more by `σ r_bL/r_bF`.
    pub fn is_on_line_throughout(&self, step: i64, part: usize) -> bool {
        let (at, half) = self.place(step, part);
        let play = half + self.places + self.turning;
        let problem = self.side.problem;
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let roll = self.line.angle - (at - locked.half_base);
        let (low, high) = (roll - play, roll + play);
        // The locked rolls at which the free roll is at its ends.
        let at_free = |end: f64, length: f64| (length - free.base * end) / locked.base;
        let (shortest, longest) = (
            self.line.length - self.stretching,
            self.line.length + self.stretching,
        );
        let most = at_free(free.form_roll, shortest).min(locked.tip_roll);
        let least = at_free(free.tip_roll, longest).max(locked.form_roll);
        let [from, to] = self.side.turns;
        from.max(high - most) <= to.min(low - least)
    }

    /// The room of a locked half tooth whose place without deviations is within `half` of the angle `at`, in its own section.
    fn around(&self, at: f64, half: f64, enough: f64) -> StepRoom {
        let problem = self.side.problem;
        let is_in_reach = |(low, high): (f64, f64)| at + half >= low && at - half <= high;
        if !problem.window.is_some_and(is_in_reach) {
            return StepRoom {
                beside: f64::INFINITY,
                at_fillet: None,
            };
        }
        let play = half + self.places + self.turning;
        let locked = &problem.locked.shape;
        let roll = self.line.angle - (at - locked.half_base);
        let (low, high) = (roll - play, roll + play);
        let other = |roll: f64, length: f64| (length - locked.base * roll) * problem.per_free_base;
        let (free_low, free_high) = (
            other(high, self.line.length - self.stretching),
            other(low, self.line.length + self.stretching),
        );
        let rolls = [(low, high), (free_low, free_high)];
        let beside = self.beside(rolls, enough);
        let tips_at_fillets = self.side.tips_at_fillets.iter();
        let tips_at_fillets = tips_at_fillets.filter(|tip| tip.may_be_below_form(at, play));
        let tips_at_fillets = tips_at_fillets.map(|tip| match &self.lines {
            Some(lines) => {
                let mate = self.side.mate(tip.owner);
                let beyond = self.side.clearance_for(self.spread + BEYOND);
                let clearance = |halvings| tip_clearance(tip, (at, play), lines, beyond, halvings);
                let is_beyond = |found: [f64; 2]| found[0].min(found[1]) >= beyond;
                let found = clearance(HALVINGS_BEFORE_PATH);
                let found = if is_beyond(found) {
                    found
                } else if stays_clear(tip, mate, (at, play), lines, beyond) {
                    [beyond; 2]
                } else {
                    clearance(HALVINGS)
                };
                found.map(|found| self.side.certain_clearance(found))
            }
            None => [f64::NEG_INFINITY; 2],
        });
        StepRoom {
            beside,
            at_fillet: tips_at_fillets.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1])]),
        }
    }

    /// Least room of a pair with rolls in these ranges beside the line of action, rad.
    ///
    /// In a direction `y` past that of the line of action, `s` is less by `T (1 − cos y) + Σ (y − sin y)`, and more by the contribution of
    /// the involutes' ends. Any `y` gives a bound. Three are tried: zero, the best for a tip corner alone, and the one that leaves no roll
    /// below the form roll. Above `enough` the first suffices.
    fn beside(&self, rolls: [(f64, f64); 2], enough: f64) -> f64 {
        let problem = self.side.problem;
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let (sum, length) = (problem.sum(), self.line.length);
        let more = |y: f64| -> f64 {
            let loss = (length + self.stretching) * (1.0 - y.cos()) + sum * (y - y.sin()).max(0.0);
            let each = shapes.iter().zip(rolls);
            let gain: f64 = each
                .map(|(shape, (low, high))| {
                    shape.base * beside((low + y, high + y), (shape.lowest_roll(), shape.tip_roll))
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
        let first = more(0.0);
        if first > enough {
            return first;
        }
        let each = || shapes.iter().zip(rolls);
        let below = each().map(|(shape, (low, high))| shape.lowest_roll() - 0.5 * (low + high));
        let below = below.fold(0.0, f64::max);
        let corner = each().map(|(shape, (low, _))| {
            let arm = shape.base * shape.tip_roll;
            (low - shape.tip_roll).max(0.0) * arm / (length - arm).max(0.1 * length)
        });
        let corner = corner.fold(0.0, f64::max);
        let others = [corner, below].into_iter().filter(|y| *y != 0.0);
        others.map(more).fold(first, f64::max)
    }
}

/// Lower bound of `ξ − q`, the deficit of an involute with ends against an endless one, in directions of rolls between `low` and `high`.
///
/// Past the tip it grows, `δ − sin δ + ξ_a (1 − cos δ)`, and from the normals of the land on `ξ − √(1 + ξ_a²)`. Below the form roll it grows
/// first and may then fall below 0: it is least at an end.
fn beside((low, high): (f64, f64), (form, tip): (f64, f64)) -> f64 {
    let at = |end: f64, roll: f64| {
        let beyond = roll - end;
        beyond - beyond.sin() + end * (1.0 - beyond.cos())
    };
    let tip_side = if low > land_roll(tip) {
        low - (1.0 + tip * tip).sqrt()
    } else if low > tip {
        at(tip, low)
    } else {
        0.0
    };
    let form_side = match (low < form, high < form) {
        (false, _) => 0.0,
        (true, false) => at(form, low).min(0.0),
        (true, true) => at(form, low).min(at(form, high)),
    };
    tip_side + form_side
}

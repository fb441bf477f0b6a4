//! The pairs that touch on the line of action at a pose; [`super::line`] has the equations.

use super::candidate::CandidateContact;
use super::flank_problem::PosedFlanks;
use super::line::{Line, ROLL_PLAY, TangentVariation};
use super::shape::{C, turn};
use super::tightest::TightestContacts;
use crate::gear::ProfilePart;
use std::ops::Range;

/// A pair that can touch on the line of action.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    /// `λ − ψ_bL`.
    pub locked_base: f64,
    /// `μ − ψ_bF` less the gap.
    pub free_base: f64,
}

impl Pair {
    /// This pair with the locked and the free tooth turned by `turns`, rad, about their own centres.
    #[inline]
    pub fn turned(self, turns: [f64; 2]) -> Pair {
        Pair {
            locked_base: self.locked_base + turns[0],
            free_base: self.free_base + turns[1],
        }
    }
}

impl PosedFlanks<'_> {
    #[inline]
    pub(super) fn pair(&self, step: i64) -> Pair {
        let (locked, free) = (&self.problem.locked, &self.problem.free);
        let (locked_place, free_place) = self.places(step);
        let steps = step as f64;
        Pair {
            locked_base: self.ahead + steps * locked.pitch + locked.offset(locked_place)
                - locked.shape.half_base,
            free_base: free.offset(free_place)
                - self.free_offset
                - steps * free.pitch
                - free.shape.half_base,
        }
    }

    /// `B` and its derivative by the gap, at the gap `mu`.
    #[inline]
    pub(super) fn between(&self, mu: f64) -> (C, C) {
        self.between_turned(turn(mu))
    }

    /// As [`PosedFlanks::between`]; `turned` is `e^{iμ}`.
    #[inline]
    pub(super) fn between_turned(&self, turned: C) -> (C, C) {
        let off = self.free_centre * turned;
        (self.centre - off, C::new(off.im, -off.re))
    }

    /// `G` of [`super::line`]: the gap `μ` of `pair` on `line`.
    pub(super) fn gap(&self, line: &Line, pair: &Pair) -> f64 {
        let problem = self.problem;
        (problem.sum() * line.angle - line.length - problem.locked.shape.base * pair.locked_base)
            * problem.per_free_base
            - pair.free_base
    }

    /// Rolls `(ξ_L, ξ_F)` of `pair` on `line`.
    pub(super) fn rolls(&self, line: &Line, pair: &Pair) -> (f64, f64) {
        let locked = line.angle - pair.locked_base;
        let rest = line.length - self.problem.locked.shape.base * locked;
        (locked, rest * self.problem.per_free_base)
    }

    /// Whether both rolls are on the involutes, within the tolerances.
    fn on_path(&self, rolls: (f64, f64), plays: (f64, f64)) -> bool {
        let (locked_shape, free_shape) = (&self.problem.locked.shape, &self.problem.free.shape);
        rolls.0 >= locked_shape.form_roll - plays.0
            && rolls.0 <= locked_shape.tip_roll + plays.0
            && rolls.1 >= free_shape.form_roll - plays.1
            && rolls.1 <= free_shape.tip_roll + plays.1
    }

    /// Steps whose rolls on `line` can be on the involutes, within the tolerances.
    pub(super) fn steps_on(&self, line: &Line, plays: (f64, f64)) -> Range<i64> {
        let problem = self.problem;
        let (locked_shape, free_shape) = (&problem.locked.shape, &problem.free.shape);
        let opposite = |roll: f64| (line.length - free_shape.base * roll) * problem.per_locked_base;
        let free_play = plays.1 * free_shape.base * problem.per_locked_base;
        let least =
            (locked_shape.form_roll - plays.0).max(opposite(free_shape.tip_roll) - free_play);
        let most =
            (locked_shape.tip_roll + plays.0).min(opposite(free_shape.form_roll) + free_play);
        // ξ_L = arg B + α − (λ_0 + s τ + δ − ψ_b), δ anywhere between the extremes.
        let (low, high) = problem.locked.extremes;
        let first =
            (line.angle - self.ahead + locked_shape.half_base - most - high) * problem.per_pitch;
        let last =
            (line.angle - self.ahead + locked_shape.half_base - least - low) * problem.per_pitch;
        // The cast rounds towards zero: never a step too few.
        let all = self.steps();
        (first as i64).max(all.start)..(last as i64 + 1).min(all.end)
    }

    /// The gap of `pair` and the line there, from the gap `first`.
    pub(super) fn settle(
        &self,
        pair: &Pair,
        variation: &TangentVariation,
        first: f64,
    ) -> Option<(f64, Line)> {
        let sum = self.problem.sum();
        let mut mu = first;
        // Two or three steps suffice; bisection would need sixty.
        for _ in 0..60 {
            let (between, rate) = self.between(mu);
            let line = Line::new(between, sum)?;
            let slope = line.slope(rate, sum) * self.problem.per_free_base;
            let step = (self.gap(&line, pair) - mu) / (1.0 - slope);
            mu += step;
            // The step leaves its square times the half_second_derivative; the line moves by its linear part.
            if variation.half_second_derivative.max(variation.turning) * step * step
                < 0.125 * f64::EPSILON
            {
                return Some((mu, line.moved(rate * step, sum)));
            }
        }
        None
    }

    fn candidate(&self, gap: f64, line: &Line, pair: &Pair) -> CandidateContact {
        let (locked_shape, free_shape) = (&self.problem.locked.shape, &self.problem.free.shape);
        let (locked, free) = self.rolls(line, pair);
        let locked = locked.clamp(locked_shape.form_roll, locked_shape.tip_roll);
        let free = free.clamp(free_shape.form_roll, free_shape.tip_roll);
        // E = −e^{i (arg B + α)} at the locked gear, cos α = Σ/|B|: P = C_L + r_b E (1 − iξ), n = −iE.
        let e = -line.between * C::new(self.problem.sum(), line.length) / line.between.norm_sqr();
        let point = self.centre + e * C::new(locked_shape.base, -locked_shape.base * locked);
        let normal = C::new(e.im, -e.re);
        let z = point.conj() * normal;
        CandidateContact {
            gap,
            slack: 0.0,
            slope: -z.re / z.im,
            locked: (ProfilePart::Involute, locked),
            free: (ProfilePart::Involute, free),
            point,
            normal,
        }
    }

    /// A line of action near those of all pairs, at the gap of the pair of step 0 between centred outlines, with the
    /// tolerances of both rolls on it. `None` if base circles overlap.
    #[inline]
    pub(super) fn start(&self, variation: &TangentVariation) -> Option<(Line, (f64, f64))> {
        let (guess, start) = match variation.fixed {
            Some(line) => (0.0, line),
            None => {
                let guess = self.gap(&variation.centred, &self.pair(0));
                (guess, Line::new(self.between(guess).0, self.problem.sum())?)
            }
        };
        let error = (self.gap(&start, &self.pair(0)) - guess).abs();
        Some((start, variation.plays(self.problem, error)))
    }

    /// Offers every pair that touches on the line of action and can be the tightest within a tie.
    ///
    /// False if one did not settle: then nothing is known.
    pub(super) fn on_line(
        &self,
        variation: &TangentVariation,
        tightest_contacts: &mut TightestContacts,
    ) -> bool {
        let Some((start, plays)) = self.start(variation) else {
            return false;
        };
        let mut tightest = f64::NEG_INFINITY;
        for step in self.steps_on(&start, plays) {
            let pair = self.pair(step);
            let first = self.gap(&start, &pair);
            // Between two pairs the true gaps differ in the same sense, by a factor of 1/2 … ∞.
            if first < tightest - 2.0 * tightest_contacts.width()
                || !self.on_path(self.rolls(&start, &pair), plays)
            {
                continue;
            }
            let (gap, line) = if variation.moves {
                let Some(settled) = self.settle(&pair, variation, first) else {
                    return false;
                };
                if !self.on_path(self.rolls(&settled.1, &pair), (ROLL_PLAY, ROLL_PLAY)) {
                    continue;
                }
                settled
            } else {
                (first, start)
            };
            tightest = tightest.max(first);
            if tightest_contacts.admits(gap) {
                tightest_contacts.offer(step, self.candidate(gap, &line, &pair));
            }
        }
        true
    }
}

#[cfg(test)]
mod tests;

//! The pairs that touch on the line of action at a pose; [`super::line`] has the equations.

use super::candidate::CandidateContact;
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::line::{Line, ROLL_PLAY, TangentVariation};
use super::shape::C;
use super::tightest::TightestContacts;
use crate::gear::ProfilePart;
use std::ops::Range;

/// The base directions of two facing involutes, which can touch on the line of action.
#[derive(Debug, Clone, Copy)]
pub(super) struct InvolutePair {
    /// `λ − ψ_bL`.
    pub locked_base: f64,
    /// `μ − ψ_bF` less the gap.
    pub free_base: f64,
}

impl InvolutePair {
    /// The pair of a step.
    #[inline]
    pub fn new(posed: &PosedFlanks, step: i64) -> InvolutePair {
        let (locked, free) = (&posed.problem.locked, &posed.problem.free);
        let (locked_place, free_place) = posed.places(step);
        let steps = step as f64;
        InvolutePair {
            locked_base: posed.ahead + steps * locked.pitch + locked.half(locked_place).offset
                - locked.shape.half_base,
            free_base: free.half(free_place).offset
                - posed.free_offset
                - steps * free.pitch
                - free.shape.half_base,
        }
    }

    /// This pair with the locked and the free tooth turned by `turns`, rad, about their own centres.
    #[inline]
    pub fn turned(self, turns: [f64; 2]) -> InvolutePair {
        InvolutePair {
            locked_base: self.locked_base + turns[0],
            free_base: self.free_base + turns[1],
        }
    }

    /// `G` of [`super::line`]: the gap `μ` on `line`.
    pub fn gap_on(&self, problem: &FlankProblem, line: &Line) -> f64 {
        (problem.sum() * line.angle - line.length - problem.locked.shape.base * self.locked_base)
            * problem.per_free_base
            - self.free_base
    }

    /// Rolls `(ξ_L, ξ_F)` on `line`.
    pub fn rolls_on(&self, problem: &FlankProblem, line: &Line) -> (f64, f64) {
        let locked = line.angle - self.locked_base;
        let rest = line.length - problem.locked.shape.base * locked;
        (locked, rest * problem.per_free_base)
    }
}

/// Whether both rolls are on the involutes, within the tolerances.
fn is_on_path(problem: &FlankProblem, rolls: (f64, f64), plays: (f64, f64)) -> bool {
    let (locked_shape, free_shape) = (&problem.locked.shape, &problem.free.shape);
    rolls.0 >= locked_shape.form_roll - plays.0
        && rolls.0 <= locked_shape.tip_roll + plays.0
        && rolls.1 >= free_shape.form_roll - plays.1
        && rolls.1 <= free_shape.tip_roll + plays.1
}

/// Steps whose rolls on `line` can be on the involutes, within the tolerances.
pub(super) fn steps_on(posed: &PosedFlanks, line: &Line, plays: (f64, f64)) -> Range<i64> {
    let problem = posed.problem;
    let (locked_shape, free_shape) = (&problem.locked.shape, &problem.free.shape);
    let opposite = |roll: f64| (line.length - free_shape.base * roll) * problem.per_locked_base;
    let free_play = plays.1 * free_shape.base * problem.per_locked_base;
    let least = (locked_shape.form_roll - plays.0).max(opposite(free_shape.tip_roll) - free_play);
    let most = (locked_shape.tip_roll + plays.0).min(opposite(free_shape.form_roll) + free_play);
    // ξ_L = arg B + α − (λ_0 + s τ + δ − ψ_b), δ anywhere between the extremes.
    let (low, high) = problem.locked.offset_range;
    let first =
        (line.angle - posed.ahead + locked_shape.half_base - most - high) * problem.per_pitch;
    let last =
        (line.angle - posed.ahead + locked_shape.half_base - least - low) * problem.per_pitch;
    // The cast rounds towards zero: never a step too few.
    let all = posed.steps();
    (first as i64).max(all.start)..(last as i64 + 1).min(all.end)
}

/// The gap of `pair` and the line there, from the gap `first`.
pub(super) fn settle(
    posed: &PosedFlanks,
    pair: &InvolutePair,
    variation: &TangentVariation,
    first: f64,
) -> Option<(f64, Line)> {
    let sum = posed.problem.sum();
    let mut mu = first;
    // Two or three steps suffice; bisection would need sixty.
    for _ in 0..60 {
        let (between, rate) = posed.centre_vector(mu);
        let line = Line::new(between, sum)?;
        let slope = line.slope(rate, sum) * posed.problem.per_free_base;
        let step = (pair.gap_on(posed.problem, &line) - mu) / (1.0 - slope);
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

fn candidate(posed: &PosedFlanks, gap: f64, line: &Line, pair: &InvolutePair) -> CandidateContact {
    let (locked_shape, free_shape) = (&posed.problem.locked.shape, &posed.problem.free.shape);
    let (locked, free) = pair.rolls_on(posed.problem, line);
    let locked = locked.clamp(locked_shape.form_roll, locked_shape.tip_roll);
    let free = free.clamp(free_shape.form_roll, free_shape.tip_roll);
    // E = −e^{i (arg B + α)} at the locked gear, cos α = Σ/|B|: P = C_L + r_b E (1 − iξ), n = −iE.
    let e = -line.between * C::new(posed.problem.sum(), line.length) / line.between.norm_sqr();
    let point = posed.centre + e * C::new(locked_shape.base, -locked_shape.base * locked);
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
pub(super) fn start_line(
    posed: &PosedFlanks,
    variation: &TangentVariation,
) -> Option<(Line, (f64, f64))> {
    let first = InvolutePair::new(posed, 0);
    let (guess, start) = match variation.fixed {
        Some(line) => (0.0, line),
        None => {
            let guess = first.gap_on(posed.problem, &variation.centred);
            (
                guess,
                Line::new(posed.centre_vector(guess).0, posed.problem.sum())?,
            )
        }
    };
    let error = (first.gap_on(posed.problem, &start) - guess).abs();
    Some((start, variation.plays(posed.problem, error)))
}

/// Offers every pair that touches on the line of action and can be the tightest within a tie.
///
/// False if one did not settle: then nothing is known.
pub(super) fn offer_pairs_on_line(
    posed: &PosedFlanks,
    variation: &TangentVariation,
    tightest_contacts: &mut TightestContacts,
) -> bool {
    let Some((start, plays)) = start_line(posed, variation) else {
        return false;
    };
    let mut tightest = f64::NEG_INFINITY;
    for step in steps_on(posed, &start, plays) {
        let pair = InvolutePair::new(posed, step);
        let first = pair.gap_on(posed.problem, &start);
        // Between two pairs the true gaps differ in the same sense, by a factor of 1/2 … ∞.
        if first < tightest - 2.0 * tightest_contacts.width()
            || !is_on_path(posed.problem, pair.rolls_on(posed.problem, &start), plays)
        {
            continue;
        }
        let (gap, line) = if variation.moves {
            let Some(settled) = settle(posed, &pair, variation, first) else {
                return false;
            };
            if !is_on_path(
                posed.problem,
                pair.rolls_on(posed.problem, &settled.1),
                (ROLL_PLAY, ROLL_PLAY),
            ) {
                continue;
            }
            settled
        } else {
            (first, start)
        };
        tightest = tightest.max(first);
        if tightest_contacts.admits(gap) {
            tightest_contacts.offer(step, candidate(posed, gap, &line, &pair));
        }
    }
    true
}

#[cfg(test)]
mod tests;

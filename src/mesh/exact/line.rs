//! Involute on involute: contact on the line of action, in closed form.
//!
//! Let `B = C_L − C_F` run from the free outline's centre to the locked one's,
//! `Σ = r_bL + r_bF`, `T = √(|B|² − Σ²)` the length of the common tangent of the base
//! circles, `α = atan(T/Σ)`. The contact normal is that tangent, so with the
//! tooth centres at the angles `λ` (locked) and `μ` (free) from the x axis the
//! rolls are
//!
//! ```text
//! ξ_L = arg B + α − (λ − ψ_bL),    ξ_F = arg B + α − (μ − ψ_bF),    r_bL ξ_L + r_bF ξ_F = T,
//! r_bF μ = Σ (arg B + α) − T − r_bL (λ − ψ_bL) + r_bF ψ_bF.
//! ```
//!
//! A step on moves `λ` by `τ_L` and `μ` by `−τ_F`, and `r_bL τ_L = r_bF τ_F`: all
//! pairs share this equation up to `w = r_bL δ_L + r_bF δ_F`, `δ` the offsets of their
//! flanks, and the pair of least `w` is the tightest. With an eccentric free gear `B`
//! depends on the gap `μ`: the right-hand side has the slope `(−T B·B' + Σ B×B')/(|B|² r_bF)`,
//! at most `e_F/r_bF < 1` by amount, so Newton's method converges from anywhere.

use super::branch::Hit;
use super::facing::Stand;
use super::shape::{C, turn};
use super::ties::Ties;
use crate::gear::Curve;

/// Rolls this far beyond an involute's end count as on it: contact moves off the line by the square of it.
const ROLL_PLAY: f64 = 1e-10;

/// The common tangent of both base circles at one place of both centres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// `arg B + α`.
    angle: f64,
    /// `T`.
    length: f64,
    /// `T + iΣ`, of length |B|; its angle is a right angle less α.
    tangent: C,
    between: C,
}

impl Line {
    /// The line for `B`; `None` where the base circles overlap.
    pub fn new(between: C, sum: f64) -> Option<Line> {
        let square = between.norm_sqr() - sum * sum;
        if !(square > 0.0) {
            return None;
        }
        let length = square.sqrt();
        Some(Line {
            angle: between.im.atan2(between.re) + length.atan2(sum),
            length,
            tangent: C::new(length, sum),
            between,
        })
    }
}

/// A pair that may touch on the line of action.
#[derive(Debug, Clone, Copy)]
struct Pair {
    /// `λ − ψ_bL` and the offset part of `μ − ψ_bF`.
    locked_base: f64,
    free_base: f64,
}

impl Stand<'_> {
    fn pair(&self, step: i64) -> Pair {
        let (locked, free) = (&self.facing.locked, &self.facing.free);
        let (ours, theirs) = self.places(step);
        let steps = step as f64;
        Pair {
            locked_base: self.ahead + steps * locked.pitch + locked.offset(ours)
                - locked.shape.half_base,
            free_base: free.offset(theirs) - steps * free.pitch - free.shape.half_base,
        }
    }

    fn sum(&self) -> f64 {
        self.facing.locked.shape.base + self.facing.free.shape.base
    }

    /// `B` and its derivative by the gap, at the gap `mu`.
    fn between(&self, mu: f64) -> (C, C) {
        let off = self.free_centre * turn(mu);
        (self.centre - off, C::new(off.im, -off.re))
    }

    /// `μ` by the right-hand side of the equation.
    fn gap(&self, line: &Line, pair: &Pair) -> f64 {
        let (ours, theirs) = (self.facing.locked.shape.base, self.facing.free.shape.base);
        (self.sum() * line.angle - line.length - ours * pair.locked_base) / theirs - pair.free_base
    }

    /// The gap of `pair` and the line there, from the gap `first` by the line at gap 0.
    fn settle(&self, pair: &Pair, swerve: &Swerve, first: f64) -> Option<(f64, Line)> {
        let (base, sum) = (self.facing.free.shape.base, self.sum());
        let mut mu = first;
        // Contraction by e/r_b alone would take 400 steps for the worst e/r_b, 0.9; Newton takes two or three.
        for _ in 0..60 {
            let (between, rate) = self.between(mu);
            let line = Line::new(between, sum)?;
            let slope = (-line.length * (between.re * rate.re + between.im * rate.im)
                + sum * (between.re * rate.im - between.im * rate.re))
                / (between.norm_sqr() * base);
            let step = (self.gap(&line, pair) - mu) / (1.0 - slope);
            mu += step;
            if swerve.curl * step * step < 0.25 * f64::EPSILON {
                return Some((mu, Line::new(self.between(mu).0, sum)?));
            }
        }
        None
    }

    /// Rolls `(ξ_L, ξ_F)` of `pair` on `line`.
    fn rolls(&self, line: &Line, pair: &Pair) -> (f64, f64) {
        let (ours, theirs) = (self.facing.locked.shape.base, self.facing.free.shape.base);
        let locked = line.angle - pair.locked_base;
        (locked, (line.length - ours * locked) / theirs)
    }

    /// Whether both rolls lie on the involutes, give or take `play`.
    fn on_path(&self, (locked, free): (f64, f64), play: f64) -> bool {
        let (ours, theirs) = (&self.facing.locked.shape, &self.facing.free.shape);
        locked >= ours.form_roll - play
            && locked <= ours.tip_roll + play
            && free >= theirs.form_roll - play * ours.base / theirs.base - ROLL_PLAY
            && free <= theirs.tip_roll + play * ours.base / theirs.base + ROLL_PLAY
    }

    fn hit(&self, gap: f64, line: &Line, pair: &Pair) -> Hit {
        let (ours, theirs) = (&self.facing.locked.shape, &self.facing.free.shape);
        let (locked, free) = self.rolls(line, pair);
        let locked = locked.clamp(ours.form_roll, ours.tip_roll);
        // E = −e^{i (arg B + α)} at the locked gear: P = C_L + r_b E (1 − iξ).
        let e =
            -line.between * C::new(line.tangent.im, line.tangent.re) / (line.between.norm_sqr());
        Hit {
            gap,
            slack: 0.0,
            locked: (Curve::Involute, locked),
            free: (
                Curve::Involute,
                free.clamp(theirs.form_roll, theirs.tip_roll),
            ),
            point: self.centre + e * C::new(1.0, -locked) * ours.base,
        }
    }

    /// Offers every pair that touches on the line of action and may be the tightest within `tie`.
    ///
    /// False when one did not settle: then nothing is known.
    pub(super) fn on_line(&self, swerve: &Swerve, ties: &mut Ties) -> bool {
        let Some(start) = Line::new(self.centre - self.free_centre, self.sum()) else {
            return false;
        };
        let mut tightest = f64::NEG_INFINITY;
        for step in self.steps() {
            let pair = self.pair(step);
            let first = self.gap(&start, &pair);
            // Gaps of any two pairs differ in the same sense as these, by a half to any factor.
            if first < tightest - 2.0 * ties.width() {
                continue;
            }
            let play = ROLL_PLAY + swerve.turning * first.abs();
            if !self.on_path(self.rolls(&start, &pair), play) {
                continue;
            }
            let (gap, line) = if swerve.turning == 0.0 {
                (first, start)
            } else {
                let Some(settled) = self.settle(&pair, swerve, first) else {
                    return false;
                };
                if !self.on_path(self.rolls(&settled.1, &pair), ROLL_PLAY) {
                    continue;
                }
                settled
            };
            tightest = tightest.max(first);
            if ties.admits(gap) {
                ties.offer(step, self.hit(gap, &line, &pair));
            }
        }
        true
    }
}

/// How an eccentric free gear moves the line of action.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swerve {
    /// Bound on the turn of the line between gap 0 and a pair's own gap, by that pair's gap as gap 0 has it.
    turning: f64,
    /// Bound on half the second derivative of the equation's right-hand side.
    curl: f64,
}

impl Swerve {
    /// For centres at least `least` apart, eccentricity `off` of the free gear of base radius `base`,
    /// and the sum `sum` of base radii; `None` where the base circles may overlap.
    ///
    /// `d(arg B + α)/dμ` is at most `e (1/|B| + Σ/(|B| T))`, and `|μ| ≤ |first|/(1 − e/r_b)`.
    /// The slope `(−T B·B' + Σ B×B')/(|B|² r_b)` is `(e/r_b)` times a sine; its own derivative at most
    /// `(e/r_b)(1 + e (1 + Σ/T)/|B|)`.
    pub fn new(least: f64, off: f64, base: f64, sum: f64) -> Option<Swerve> {
        if !(least > sum && base > off) {
            return None;
        }
        let length = ((least - sum) * (least + sum)).sqrt();
        let turn = off * (1.0 + sum / length) / least;
        let ratio = off / base;
        Some(Swerve {
            turning: turn / (1.0 - ratio),
            curl: 0.5 * ratio * (1.0 + turn) / (1.0 - ratio),
        })
    }
}

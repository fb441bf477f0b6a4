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
//! depends on the gap `μ`: the right-hand side `G(μ)` has the slope
//! `(−T B·B' + Σ B×B')/(|B|² r_bF)`, at most `e_F/r_bF < 1` by amount, so Newton's method
//! converges from anywhere.

use super::facing::{Facing, Stand};
use super::hit::Hit;
use super::shape::{C, turn};
use super::ties::Ties;
use crate::gear::Curve;

/// Rolls this far beyond an involute's end count as on it: contact moves off the line by the square of it.
const ROLL_PLAY: f64 = 1e-10;

/// The common tangent of both base circles at one place of both centres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// `B`.
    between: C,
    /// `arg B + α`.
    angle: f64,
    /// `T`.
    length: f64,
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
            between,
            angle: between.im.atan2(between.re) + length.atan2(sum),
            length,
        })
    }

    /// The line after `B` moved by `by`, to first order.
    fn moved(&self, by: C, sum: f64) -> Line {
        let z = self.between.conj() * by;
        let stretch = z.re / self.length;
        Line {
            between: self.between + by,
            angle: self.angle + (z.im + sum * stretch) / self.between.norm_sqr(),
            length: self.length + stretch,
        }
    }

    /// `dG/dμ` where `B` moves at `rate`, times `r_bF`.
    fn slope(&self, rate: C, sum: f64) -> f64 {
        let z = self.between.conj() * rate;
        (sum * z.im - self.length * z.re) / self.between.norm_sqr()
    }
}

/// How the line of action may move, for one pair of gears.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swerve {
    /// The line itself, where both outlines are centred on their axes.
    fixed: Option<Line>,
    /// The line of centred outlines, to start from.
    centred: Line,
    /// Whether the free outline is off its axis.
    moves: bool,
    /// Bounds on the turn of the line and on the change of its length, by the error of the gap it was taken at.
    turning: f64,
    stretching: f64,
    /// Bound on half the second derivative of `G`.
    curl: f64,
}

impl Swerve {
    /// `None` where the base circles may overlap.
    ///
    /// With `|B| ≥ b`: `d(arg B + α)/dμ` is at most `e (1 + Σ/T)/b` and `dT/dμ` at most `e |B|/T ≤ e b/T(b)`, while
    /// a gap is off by at most the change `G` makes to it over `1 − e/r_b`. The slope of `G` is `(e/r_b)`
    /// times a sine; its own derivative at most `(e/r_b)` times the turn of `B'` and of the line.
    pub fn new(facing: &Facing, locked_off: f64, off: f64) -> Option<Swerve> {
        let (base, sum) = (facing.free.shape.base, facing.sum());
        let least = facing.distance - locked_off - off;
        let centred = Line::new(C::from(facing.distance), sum)?;
        if !(least > sum && base > off) {
            return None;
        }
        let length = ((least - sum) * (least + sum)).sqrt();
        let shrink = 1.0 - off / base;
        let turn = off * (1.0 + sum / length) / least;
        Some(Swerve {
            fixed: (locked_off == 0.0 && off == 0.0).then_some(centred),
            centred,
            moves: off > 0.0,
            turning: turn / shrink,
            stretching: off * least / length / shrink,
            curl: 0.5 * (off / base) * (1.0 + turn) / shrink,
        })
    }
}

/// A pair that may touch on the line of action.
#[derive(Debug, Clone, Copy)]
struct Pair {
    /// `λ − ψ_bL`.
    locked_base: f64,
    /// `μ − ψ_bF` less the gap.
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
            free_base: free.offset(theirs)
                - self.free_offset
                - steps * free.pitch
                - free.shape.half_base,
        }
    }

    /// `B` and its derivative by the gap, at the gap `mu`.
    fn between(&self, mu: f64) -> (C, C) {
        let off = self.free_centre * turn(mu);
        (self.centre - off, C::new(off.im, -off.re))
    }

    /// `G`: `μ` by the equation above.
    fn gap(&self, line: &Line, pair: &Pair) -> f64 {
        let facing = self.facing;
        (facing.sum() * line.angle - line.length - facing.locked.shape.base * pair.locked_base)
            * facing.per_free_base
            - pair.free_base
    }

    /// Rolls `(ξ_L, ξ_F)` of `pair` on `line`.
    fn rolls(&self, line: &Line, pair: &Pair) -> (f64, f64) {
        let locked = line.angle - pair.locked_base;
        let rest = line.length - self.facing.locked.shape.base * locked;
        (locked, rest * self.facing.per_free_base)
    }

    /// Whether both rolls lie on the involutes, give or take the plays.
    fn on_path(&self, rolls: (f64, f64), plays: (f64, f64)) -> bool {
        let (ours, theirs) = (&self.facing.locked.shape, &self.facing.free.shape);
        rolls.0 >= ours.form_roll - plays.0
            && rolls.0 <= ours.tip_roll + plays.0
            && rolls.1 >= theirs.form_roll - plays.1
            && rolls.1 <= theirs.tip_roll + plays.1
    }

    /// The gap of `pair` and the line there, from the gap `first`.
    fn settle(&self, pair: &Pair, swerve: &Swerve, first: f64) -> Option<(f64, Line)> {
        let sum = self.facing.sum();
        let mut mu = first;
        // Two or three steps; sixty would do by bisection's pace.
        for _ in 0..60 {
            let (between, rate) = self.between(mu);
            let line = Line::new(between, sum)?;
            let slope = line.slope(rate, sum) * self.facing.per_free_base;
            let step = (self.gap(&line, pair) - mu) / (1.0 - slope);
            mu += step;
            // What the step leaves is its square times the curl; the line moves on by its linear part.
            if swerve.curl.max(swerve.turning) * step * step < 0.125 * f64::EPSILON {
                return Some((mu, line.moved(rate * step, sum)));
            }
        }
        None
    }

    fn hit(&self, gap: f64, line: &Line, pair: &Pair) -> Hit {
        let (ours, theirs) = (&self.facing.locked.shape, &self.facing.free.shape);
        let (locked, free) = self.rolls(line, pair);
        let locked = locked.clamp(ours.form_roll, ours.tip_roll);
        let free = free.clamp(theirs.form_roll, theirs.tip_roll);
        // E = −e^{i (arg B + α)} at the locked gear, cos α = Σ/|B|: P = C_L + r_b E (1 − iξ), n = −iE.
        let e = -line.between * C::new(self.facing.sum(), line.length) / line.between.norm_sqr();
        let point = self.centre + e * C::new(ours.base, -ours.base * locked);
        let normal = C::new(e.im, -e.re);
        let z = point.conj() * normal;
        Hit {
            gap,
            slack: 0.0,
            slope: -z.re / z.im,
            locked: (Curve::Involute, locked),
            free: (Curve::Involute, free),
            point,
            normal,
        }
    }

    /// Offers every pair that touches on the line of action and may be the tightest within a tie.
    ///
    /// False when one did not settle: then nothing is known.
    pub(super) fn on_line(&self, swerve: &Swerve, ties: &mut Ties) -> bool {
        // The gap the pair of step 0 has between centred outlines: a good place to take the line at.
        let (guess, start) = match swerve.fixed {
            Some(line) => (0.0, line),
            None => {
                let guess = self.gap(&swerve.centred, &self.pair(0));
                match Line::new(self.between(guess).0, self.facing.sum()) {
                    Some(line) => (guess, line),
                    None => return false,
                }
            }
        };
        let ratio = self.facing.locked.shape.base * self.facing.per_free_base;
        let mut tightest = f64::NEG_INFINITY;
        for step in self.steps() {
            let pair = self.pair(step);
            let first = self.gap(&start, &pair);
            // Between two pairs the true gaps differ in the same sense, by a factor of 1/2 … ∞.
            if first < tightest - 2.0 * ties.width() {
                continue;
            }
            let error = (first - guess).abs();
            let play = swerve.turning * error;
            let free_play = ratio * play + swerve.stretching * self.facing.per_free_base * error;
            let plays = (play + ROLL_PLAY, free_play + ROLL_PLAY);
            if !self.on_path(self.rolls(&start, &pair), plays) {
                continue;
            }
            let (gap, line) = if swerve.moves {
                let Some(settled) = self.settle(&pair, swerve, first) else {
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
            if ties.admits(gap) {
                ties.offer(step, self.hit(gap, &line, &pair));
            }
        }
        true
    }
}

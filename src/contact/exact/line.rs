//! Involute on involute: contact on the line of action, in closed form.
//!
//! `B = C_L − C_F` joins the centre of the free outline to that of the locked one, and `Σ = r_bL + r_bF`. The common
//! tangent of the base circles has the length `T = √(|B|² − Σ²)`; `α = atan(T/Σ)`. That tangent is the contact normal.
//! With the tooth centres at the angles `λ` (locked) and `μ` (free) from the x axis the rolls are
//!
//! ```text
//! ξ_L = arg B + α − (λ − ψ_bL),    ξ_F = arg B + α − (μ − ψ_bF);    r_bL ξ_L + r_bF ξ_F = T;
//! r_bF μ = Σ (arg B + α) − T − r_bL (λ − ψ_bL) + r_bF ψ_bF.
//! ```
//!
//! One step changes `λ` by `τ_L` and `μ` by `−τ_F`. If base pitches are equal, `r_bL τ_L = r_bF τ_F`. Then all pairs share this equation up
//! to `w = r_bL δ_L + r_bF δ_F`, where `δ` are the offsets of their flanks, and the pair of least `w` is the tightest.
//!
//! With an eccentric free gear `B` depends on the gap `μ`. The right-hand side `G(μ)` has the slope `(−T B·B' + Σ
//! B×B')/(|B|² r_bF)`. Its amount is at most `e_F/r_bF < 1`, so Newton's method converges from anywhere.

use super::flank_problem::FlankProblem;
use super::shape::C;

/// Rolls up to this far past an involute's end count as on it: contact leaves the line by the square of it.
pub(super) const ROLL_PLAY: f64 = 1e-10;

/// The common tangent of both base circles at one place of both centres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// `B`.
    pub between: C,
    /// `arg B + α`.
    pub angle: f64,
    /// `T`.
    pub length: f64,
}

impl Line {
    /// The line for `B`; `None` where the base circles overlap.
    #[inline]
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
    pub fn moved(&self, by: C, sum: f64) -> Line {
        let z = self.between.conj() * by;
        let stretch = z.re / self.length;
        Line {
            between: self.between + by,
            angle: self.angle + (z.im + sum * stretch) / self.between.norm_sqr(),
            length: self.length + stretch,
        }
    }

    /// `dG/dμ` where `B` moves at `rate`, times `r_bF`.
    pub fn slope(&self, rate: C, sum: f64) -> f64 {
        let z = self.between.conj() * rate;
        (sum * z.im - self.length * z.re) / self.between.norm_sqr()
    }
}

/// The variation of the line of action, for one pair of gears.
#[derive(Debug, Clone, Copy)]
pub(super) struct TangentVariation {
    /// The line itself, where both outlines are centred on their axes.
    pub fixed: Option<Line>,
    /// The line of centred outlines, to start from.
    pub centred: Line,
    /// Whether the free outline is off its axis.
    pub moves: bool,
    /// Bounds on the turn of the line and on its change of length, per error of the gap at which it was evaluated.
    pub turning: f64,
    stretching: f64,
    /// Bound on half the second derivative of `G`.
    pub half_second_derivative: f64,
}

impl TangentVariation {
    /// `None` where the base circles may overlap.
    ///
    /// With `|B| ≥ b`, `d(arg B + α)/dμ` is at most `e (1 + Σ/T)/b` and `dT/dμ` at most `e |B|/T ≤ e b/T(b)`. A gap is
    /// off by at most the change that `G` makes to it over `1 − e/r_b`. The slope of `G` is `(e/r_b)` times a sine. Its
    /// derivative is at most `(e/r_b)` times the turn of `B'` and of the line.
    pub fn new(problem: &FlankProblem, locked_off: f64, off: f64) -> Option<TangentVariation> {
        let (base, sum) = (problem.free.shape.base, problem.sum());
        let least = problem.distance - locked_off - off;
        let centred = Line::new(C::from(problem.distance), sum)?;
        if !(least > sum && base > off) {
            return None;
        }
        let length = ((least - sum) * (least + sum)).sqrt();
        let shrink = 1.0 - off / base;
        let turn = off * (1.0 + sum / length) / least;
        Some(TangentVariation {
            fixed: (locked_off == 0.0 && off == 0.0).then_some(centred),
            centred,
            moves: off > 0.0,
            turning: turn / shrink,
            stretching: off * least / length / shrink,
            half_second_derivative: 0.5 * (off / base) * (1.0 + turn) / shrink,
        })
    }

    /// Tolerances of both rolls on a line evaluated at a gap that is off by `error` for the pair of step 0.
    ///
    /// The gap of another pair differs by at most the offsets of all flanks plus the effect of unequal base pitches
    /// over the steps in reach.
    pub fn plays(&self, problem: &FlankProblem, error: f64) -> (f64, f64) {
        if !self.moves {
            return (ROLL_PLAY, ROLL_PLAY);
        }
        let spread = |(low, high): (f64, f64)| high - low;
        let ratio = problem.locked.shape.base * problem.per_free_base;
        let error = error
            + 2.0
                * (ratio * spread(problem.locked.offset_range) + spread(problem.free.offset_range))
            + problem.all_steps();
        let (play, free_play) = self.plays_at(problem, error);
        (play + ROLL_PLAY, free_play + ROLL_PLAY)
    }

    /// Bounds on the change of the locked and of the free roll on a line evaluated at a gap that is off by `error`.
    pub fn plays_at(&self, problem: &FlankProblem, error: f64) -> (f64, f64) {
        let ratio = problem.locked.shape.base * problem.per_free_base;
        let play = self.turning * error;
        (
            play,
            ratio * play + self.stretching * problem.per_free_base * error,
        )
    }
}

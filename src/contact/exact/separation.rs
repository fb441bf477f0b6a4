//! The rotation at which a pair of half teeth touches, in closed form for involutes with ends, from the direction that separates them.
//!
//! An arc of an involute is convex. Its support function in the direction of the normal at the roll `ξ` is `r_b q(ξ)`. On the arc `q = ξ`.
//! Past an end `ξ_e`, with `δ = ξ − ξ_e`, it is that of the end point,
//! ```text
//! q = ξ_e cos δ + sin δ        (q = ξ, q' = 1, q'' = 0 at most at δ = 0; q'' = −ξ_e cos δ − sin δ)
//! ```
//!
//! The normals of a tip land are a right angle less `α_a` past those of the corner; directions so far past the tip are not examined. With the
//! centres `B` apart ([`super::line`]) the arcs are on different sides of a line of the direction `β` if
//!
//! ```text
//! s(β) = Im(e^{iβ} B*) − r_bL q_L(β − λ_b) − r_bF q_F(β − μ − μ_b) ≥ 0,
//! ```
//!
//! They touch at the rotation `μ` at which the greatest `s` over all directions is 0. Any direction gives a rotation `μ_β` (where `s = 0`)
//! at which they are certainly apart.
//!
//! **Between two poses.** Let the locked gear turn by `x`. From `s(β; x, μ) = 0` at a fixed `β` follows `μ'' = −(s_xx + s_μμ μ'²)/s_μ`,
//! with `s_xx ≥ −e_L + …`: both arcs contribute only `−r_b q'' ≥ 0`, where `ξ_e cos δ + sin δ ≥ 0`. So `μ'' ≤ (e_L + e_F μ'²)/s_μ`. Every
//! `μ_β`, and their least, the rotation of the touch, are concave up to that small constant ([`Separation::bend`]). A tangent bounds it
//! from above between poses, a chord from below.

use super::flank_problem::{FlankProblem, PosedFlanks};
use super::line::Line;
use super::path::InvolutePair;
use super::shape::{C, HalfToothShape, turn};
use super::teeth::slightly_turned;
use std::f64::consts::PI;

/// Limit of Newton steps (3 to 6 are usual).
const STEPS: usize = 24;

/// Steps of `μ` and `β`, rad, after which only their squares are left, which are rounding.
const SETTLED: (f64, f64) = (1e-7, 1e-6);

/// Least curvature of `s`, as a part of `Σ`, if the direction of its maximum is known. Otherwise two corners meet, which touch in any
/// direction.
const LEVEL: f64 = -1e-3;

/// Gap, rad, within which two touches on the line of action are the same: some roundings.
const ROUNDED: f64 = 1e-15;

/// An arc of an involute, or the whole involute.
#[derive(Debug, Clone, Copy)]
pub(super) struct InvoluteArc {
    base: f64,
    /// Its lowest roll.
    pub form: f64,
    /// Its greatest roll.
    pub tip: f64,
}

impl InvoluteArc {
    /// The arcs of the locked and of the free half teeth.
    pub fn both(problem: &FlankProblem) -> [InvoluteArc; 2] {
        [&problem.locked, &problem.free].map(|teeth| InvoluteArc::new(&teeth.shape))
    }

    fn new(shape: &HalfToothShape) -> InvoluteArc {
        InvoluteArc {
            base: shape.base,
            form: shape.lowest_roll(),
            tip: shape.tip_roll,
        }
    }

    fn endless(shape: &HalfToothShape) -> InvoluteArc {
        InvoluteArc {
            base: shape.base,
            form: f64::NEG_INFINITY,
            tip: f64::INFINITY,
        }
    }

    /// Whether all rolls within `play` of `roll` are on it.
    pub fn holds(&self, roll: f64, play: f64) -> bool {
        roll - play >= self.form && roll + play <= self.tip
    }

    /// Room that it has more than an endless involute with this `roll` on the line of action, mm.
    pub fn room(&self, roll: f64) -> f64 {
        let slight = |angle: f64| {
            let turned = slightly_turned(angle);
            (turned.im, turned.re)
        };
        self.base * (roll - self.support_by(roll, slight)[0])
    }

    /// Lower bound of its room over all rolls within `play` of `roll`, mm.
    ///
    /// With `δ = ξ − ξ_e` beyond an end the room is `r_b (ξ_e (1 − cos δ) + δ − sin δ)`. The partial sums `δ²/2 − δ⁴/24` and `δ³/6 − |δ|⁵/120`
    /// are no greater than its terms. The room rises past the tip. Below the form roll both it and the sum rise, then fall.
    fn room_at_least(&self, roll: f64, play: f64) -> f64 {
        let room = |roll: f64| {
            let end = roll.clamp(self.form, self.tip);
            let beyond = (roll - end).min(1.0);
            let square = beyond * beyond;
            let cosine = end * (0.5 - square / 24.0);
            square * (cosine + beyond / 6.0 - square * beyond.abs() / 120.0)
        };
        self.base * room(roll - play).min(room(roll + play))
    }

    /// Lower bound of the room of `arcs`, mm, in the direction where it is about greatest, over all rolls within `plays` of `rolls`.
    ///
    /// Turned by `t` from the line of action, of length `T`, both rolls grow by `t`, and endless involutes come nearer by
    /// `T (1 − cos t) + Σ r_b (t − sin t)`. A roll that is `δ` past its end leaves room that rises by `r_b ξ_e δ` and bends by `r_b ξ_e`.
    pub fn room_of_both(arcs: &[InvoluteArc; 2], rolls: [f64; 2], plays: [f64; 2]) -> f64 {
        let (mut length, mut slope, mut bend) = (0.0, 0.0, 0.0);
        for k in 0..2 {
            let InvoluteArc { base, form, tip } = arcs[k];
            let end = rolls[k].clamp(form, tip);
            length += base * (rolls[k] + plays[k]);
            slope += base * end * (rolls[k] - end);
            bend += base * if end == rolls[k] { end } else { 0.0 };
        }
        let turn = (slope / bend).clamp(-0.1, 0.1);
        let turn = if turn.is_nan() { 0.0 } else { turn };
        let sum = arcs[0].base + arcs[1].base;
        let nearer = turn * turn * (0.5 * length + sum * turn.max(0.0) / 6.0);
        let room = |k: usize| arcs[k].room_at_least(rolls[k] + turn, plays[k]);
        room(0) + room(1) - nearer
    }

    /// `q` and its derivatives.
    fn support(&self, roll: f64) -> [f64; 3] {
        self.support_by(roll, f64::sin_cos)
    }

    #[inline]
    fn support_by(&self, roll: f64, sin_cos: impl Fn(f64) -> (f64, f64)) -> [f64; 3] {
        let end = roll.clamp(self.form, self.tip);
        let beyond = roll - end;
        if beyond == 0.0 {
            return [roll, 1.0, 0.0];
        }
        let (sin, cos) = sin_cos(beyond);
        [end * cos + sin, cos - end * sin, -end * cos - sin]
    }

    /// Over all rolls within `play` of this one: the least `q'`, the greatest, and the greatest `q''` or 0.
    fn range(&self, roll: f64, play: f64) -> [f64; 3] {
        let (low, high) = (roll - play, roll + play);
        let [l, h] = [low, high].map(|roll| self.support(roll));
        // q' falls past the tip; below the form roll it is at most √(1 + ξ_f²), without a minimum in between.
        let most = if low < self.form {
            (1.0 + self.form * self.form).sqrt()
        } else {
            l[1]
        };
        [l[1].min(h[1]), most, l[2].max(h[2]).max(0.0)]
    }
}

/// The roll up to which directions belong to the corner at the roll `tip`: the normals of the tip land follow.
pub(super) fn land_roll(tip: f64) -> f64 {
    tip + 0.5 * PI - tip.atan()
}

/// The touch of a pair of half teeth, with each represented by its involute.
#[derive(Debug, Clone, Copy)]
pub(super) struct Separation {
    /// The gap, as [`super::candidate::CandidateContact::gap`].
    pub gap: f64,
    /// Derivatives of the gap by the turn of the locked tooth and of the free tooth about their own centres.
    pub by_turn: [f64; 2],
    /// Its derivative by the rotation of the locked gear.
    pub slope: f64,
    /// Derivative of `s` by the gap, mm.
    pub turning: f64,
    /// Whether it is the touch itself; otherwise only a rotation at which they are apart.
    pub touches: bool,
    beta: f64,
    rolls: [f64; 2],
    arcs: [InvoluteArc; 2],
}

impl Separation {
    /// The pair at `step` with endless involutes, which touch on the line of action, found from about the gap `near`. Without a line nothing
    /// bounds the gap.
    pub fn endless(posed: &PosedFlanks, step: i64, near: f64) -> Separation {
        let start = Start {
            beta: f64::NAN,
            gap: near,
        };
        Separation::endless_from(posed, step, [0.0; 2], &start)
    }

    /// Like [`Separation::endless`], with the locked and the free tooth turned by `turns`, rad, about their own centres. The line to search from
    /// may be that of another pair or section.
    pub fn endless_near(
        posed: &PosedFlanks,
        step: i64,
        turns: [f64; 2],
        start: &NearStart,
    ) -> Separation {
        Separation::endless_from(posed, step, turns, start)
    }

    fn endless_from(
        posed: &PosedFlanks,
        step: i64,
        turns: [f64; 2],
        start: &impl Trigonometry,
    ) -> Separation {
        let pair = InvolutePair::new(posed, step).turned(turns);
        let arcs = arcs(posed, InvoluteArc::endless);
        if let Some(found) = Separation::on_line_of_action(posed, &pair, arcs, start) {
            return found;
        }
        Separation {
            gap: f64::INFINITY,
            by_turn: [f64::NAN; 2],
            slope: 0.0,
            turning: f64::NAN,
            touches: false,
            beta: f64::NAN,
            rolls: [f64::NAN; 2],
            arcs,
        }
    }

    /// The pair at `step`, found from about the gap `near`.
    pub fn new(posed: &PosedFlanks, step: i64, near: f64) -> Separation {
        Separation::turned(posed, step, near, [0.0; 2])
    }

    /// Like [`Separation::new`], with the locked and the free tooth turned by `turns`, rad, about their own centres.
    pub fn turned(posed: &PosedFlanks, step: i64, near: f64, turns: [f64; 2]) -> Separation {
        Separation::found(posed, step, turns, &Start::new(posed, near))
    }

    /// Like [`Separation::turned`], found from a direction and a gap that may be those of another pair or section.
    #[inline]
    pub fn near(posed: &PosedFlanks, step: i64, turns: [f64; 2], start: &NearStart) -> Separation {
        let pair = InvolutePair::new(posed, step).turned(turns);
        let arcs = arcs(posed, InvoluteArc::new);
        let Some(line) = Separation::on_line_of_action(posed, &pair, arcs, start) else {
            return Separation::found(posed, step, turns, start);
        };
        // Where both rolls are on their involutes, endless ones touch in the same point.
        if line.is_on_line([0.0; 2]) {
            line
        } else {
            Separation::found(posed, step, turns, &start.at(&line))
        }
    }

    /// The touch of `pair` on the line of action, where `arcs` that end are taken as endless; `None` without a line.
    #[inline]
    fn on_line_of_action(
        posed: &PosedFlanks,
        pair: &InvolutePair,
        arcs: [InvoluteArc; 2],
        start: &impl Trigonometry,
    ) -> Option<Separation> {
        let sum = posed.problem.sum();
        let (_, mut gap) = start.from();
        for _ in 0..STEPS {
            let (between, rate) = start.between(posed, gap);
            let (direction, beta, length) = start.line(between, sum)?;
            let turning = (direction * rate.conj()).im + arcs[1].base;
            let apart = length
                - arcs[0].base * (beta - pair.locked_base)
                - arcs[1].base * (beta - gap - pair.free_base);
            let step = -apart / turning;
            gap += step;
            // After such a step only rounding is left.
            if step.abs() < SETTLED.0 || rate == C::ZERO {
                let found = (turning, [1.0; 2]);
                return Some(Separation::at(posed, pair, (gap, beta), found, arcs, true));
            }
        }
        None
    }

    fn found(
        posed: &PosedFlanks,
        step: i64,
        turns: [f64; 2],
        start: &impl Trigonometry,
    ) -> Separation {
        let problem = posed.problem;
        let pair = InvolutePair::new(posed, step).turned(turns);
        let arcs = arcs(posed, InvoluteArc::new);
        let sum = problem.sum();
        let (mut beta, mut gap) = start.from();
        let at = |gap: f64| start.between(posed, gap);
        let (mut between, mut rate) = at(gap);
        let mut state = RoomDerivatives::new(&arcs, &pair, (between, rate), (beta, gap), start);
        let (mut touches, mut is_settled) = (false, false);
        let mut last = (0.0f64, 0.0);
        for _ in 0..STEPS {
            // One step for both: where `s` is greatest its derivative by the direction is 0. If it is not concave, the maximum is further
            // up the slope.
            let newton = (-state.tilt / state.bend.min(LEVEL * sum)).clamp(-0.3, 0.3);
            // At an end of an arc the curvature of `s` jumps, and two such steps can oscillate; the chord of both tilts does not.
            let returns = state.tilt * last.1 < 0.0 && newton.abs() >= last.0.abs();
            let turned = if returns {
                -last.0 * state.tilt / (state.tilt - last.1)
            } else {
                newton
            };
            last = (turned, state.tilt);
            let step = -state.apart / state.turning;
            beta += turned;
            gap += step;
            (between, rate) = at(gap);
            state = RoomDerivatives::new(&arcs, &pair, (between, rate), (beta, gap), start);
            if step.abs() < SETTLED.0 && newton.abs() < SETTLED.1 {
                (touches, is_settled) = (state.bend < LEVEL * sum, true);
                break;
            }
        }
        // Without a maximum, the rotation at which the last direction separates them.
        for _ in 0..STEPS {
            if is_settled {
                break;
            }
            let step = -state.apart / state.turning;
            gap += step;
            (between, rate) = at(gap);
            state = RoomDerivatives::new(&arcs, &pair, (between, rate), (beta, gap), start);
            is_settled = step.abs() < SETTLED.0 && state.turning > 0.0;
        }
        // The remainder of `s` is rounding, and is put on the safe side for both bounds.
        gap -= state.apart / state.turning;
        let rolls = [beta - pair.locked_base, beta - gap - pair.free_base];
        let is_before_lands = [0, 1].iter().all(|&k| rolls[k] <= land_roll(arcs[k].tip));
        if !(is_settled && is_before_lands) {
            // Nothing bounds the gap.
            gap = f64::INFINITY;
        }
        let slopes = state.slopes;
        let touches = touches && gap.is_finite();
        Separation::at(
            posed,
            &pair,
            (gap, beta),
            (state.turning, slopes),
            arcs,
            touches,
        )
    }

    /// The separation at a gap in the direction `beta`, where the arcs have the `slopes` `q'` and the free gear turns by `turning`.
    fn at(
        posed: &PosedFlanks,
        pair: &InvolutePair,
        (gap, beta): (f64, f64),
        (turning, slopes): (f64, [f64; 2]),
        arcs: [InvoluteArc; 2],
        touches: bool,
    ) -> Separation {
        let offset = posed.centre - C::from(posed.problem.distance);
        let moving = C::i() * offset;
        let along = (turn(beta) * moving.conj()).im + arcs[0].base * slopes[0];
        Separation {
            gap,
            by_turn: [0, 1].map(|k| -arcs[k].base * slopes[k] / turning),
            slope: -along / turning,
            turning,
            touches,
            beta,
            rolls: [beta - pair.locked_base, beta - gap - pair.free_base],
            arcs,
        }
    }

    /// `e^{iβ}` of the separating direction turned by `angle`, rad.
    pub fn direction_turned(&self, start: &NearStart, angle: f64) -> C {
        start.direction(self.beta + angle)
    }

    /// `e^{iμ}` of the gap.
    pub fn gap_turned(&self, start: &NearStart) -> C {
        Trigonometry::gap(start, self.gap)
    }

    /// Rolls of the locked and the free involute in the separating direction.
    pub fn rolls(&self) -> [f64; 2] {
        self.rolls
    }

    /// These rolls, or those of the ends of the involutes beyond which they are.
    pub fn rolls_on_arcs(&self) -> [f64; 2] {
        [0, 1].map(|k| self.rolls[k].clamp(self.arcs[k].form, self.arcs[k].tip))
    }

    /// Base radii of the locked and the free gear, mm.
    pub fn bases(&self) -> [f64; 2] {
        self.arcs.map(|arc| arc.base)
    }

    /// Rate of the direction of the line of action, rad per mm, where the locked centre moves by `moves` against the free one, mm per mm.
    ///
    /// On the line `Re(e^{iβ} B*) = Σ`, and `Im(e^{iβ} B*)` is its length.
    pub fn line_turning(&self, start: &NearStart, moves: C) -> f64 {
        (self.direction_turned(start, 0.0) * moves.conj()).re / self.line_length()
    }

    /// Length of the line of action of a touch on it, mm.
    pub fn line_length(&self) -> f64 {
        self.arcs[0].base * self.rolls[0] + self.arcs[1].base * self.rolls[1]
    }

    /// This touch on the line of action with its teeth turned further by `turns`, rad. `None` where the line ends, or where an eccentric free
    /// gear bends the gap by more than [`ROUNDED`].
    pub fn turned_further(&self, turns: [f64; 2], free_off: f64) -> Option<Separation> {
        let change = self.by_turn[0] * turns[0] + self.by_turn[1] * turns[1];
        let turned = Separation {
            gap: self.gap + change,
            rolls: [self.rolls[0] - turns[0], self.rolls[1] - change - turns[1]],
            ..*self
        };
        let bend = free_off * change * change / self.arcs[1].base;
        (bend < ROUNDED && self.is_on_line([0.0; 2]) && turned.is_on_line([0.0; 2]))
            .then_some(turned)
    }

    /// Whether a roll is within `play` of the form circle, or below it.
    pub fn is_below_form(&self, play: f64) -> bool {
        [0, 1]
            .iter()
            .any(|&k| self.rolls[k] <= self.arcs[k].form + play)
    }

    /// Whether it touches with both rolls on their involutes and at least `plays` from the ends.
    pub fn is_on_line(&self, plays: [f64; 2]) -> bool {
        self.touches && (0..2).all(|k| self.arcs[k].holds(self.rolls[k], plays[k]))
    }

    /// Greatest deficit of room of involutes with ends against endless ones, between this pose and `other`, rad of the free gear. For
    /// endless ones only the cube of the part below the form roll counts.
    pub fn greatest_deficit(&self, other: &Separation, plays: [f64; 2], forms: [f64; 2]) -> f64 {
        let bases = [self.arcs[0].base, self.arcs[1].base];
        let deficit = |k: usize| {
            let roll = self.rolls[k].min(other.rolls[k]) - plays[k];
            let below = (forms[k] - roll).max(0.0);
            // δ − sin δ − ξ_f (1 − cos δ) of δ = ξ_f − ξ, at most δ³/6.
            (below - below.sin() - forms[k] * (1.0 - below.cos())).max(0.0)
        };
        (bases[0] * deficit(0) + bases[1] * deficit(1)) / bases[1]
    }

    /// Bound on the second derivative of the rotation of the touch by that of the locked gear, while the rolls change by `plays`, with the
    /// eccentricities `off`. `None` if the free gear's arm can vanish.
    pub fn bend(&self, plays: [f64; 2], off: [f64; 2]) -> Option<f64> {
        let [locked, free] = [0, 1].map(|k| self.arcs[k].range(self.rolls[k], plays[k]));
        let bases = [self.arcs[0].base, self.arcs[1].base];
        let turning = bases[1] * free[0] - off[1];
        let rate = (bases[0] * locked[1] + off[0]) / turning;
        let bend = off[0] + bases[0] * locked[2] + (off[1] + bases[1] * free[2]) * rate * rate;
        // At least half an arm is left for all that can be the tightest.
        (turning > 0.5 * bases[1]).then_some(bend / turning)
    }
}

/// The involutes of `posed`, locked and free, each as `of` its half tooth.
fn arcs(posed: &PosedFlanks, of: fn(&HalfToothShape) -> InvoluteArc) -> [InvoluteArc; 2] {
    [&posed.problem.locked, &posed.problem.free].map(|teeth| of(&teeth.shape))
}

/// The room `s` in a direction, and its derivatives.
struct RoomDerivatives {
    apart: f64,
    /// By `β`, once and twice.
    tilt: f64,
    bend: f64,
    /// By `μ`.
    turning: f64,
    /// `q'` of both.
    slopes: [f64; 2],
}

impl RoomDerivatives {
    #[inline]
    fn new(
        [locked, free]: &[InvoluteArc; 2],
        pair: &InvolutePair,
        (between, rate): (C, C),
        (beta, gap): (f64, f64),
        by: &impl Trigonometry,
    ) -> RoomDerivatives {
        let direction = by.direction(beta);
        let seen = direction * between.conj();
        let l = locked.support_by(beta - pair.locked_base, |angle| by.sin_cos(angle));
        let f = free.support_by(beta - gap - pair.free_base, |angle| by.sin_cos(angle));
        RoomDerivatives {
            apart: seen.im - locked.base * l[0] - free.base * f[0],
            tilt: seen.re - locked.base * l[1] - free.base * f[1],
            bend: -seen.im - locked.base * l[2] - free.base * f[2],
            turning: (direction * rate.conj()).im + free.base * f[1],
            slopes: [l[1], f[1]],
        }
    }
}

/// The angle of a unit vector, rad.
fn small_angle(unit: C) -> f64 {
    let sin = unit.im;
    // The first term left out, 15/336 of the seventh power, is below rounding.
    if sin.abs() > 5e-3 || unit.re < 0.0 {
        return sin.atan2(unit.re);
    }
    let q = sin * sin;
    sin * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0)))
}

/// The start of a search for a separation, and the conversion of angles to vectors.
trait Trigonometry {
    /// The direction `β` and the gap to start from.
    fn from(&self) -> (f64, f64);
    /// `e^{iβ}` of a direction.
    fn direction(&self, beta: f64) -> C;
    /// `e^{iμ}` of a gap.
    fn gap(&self, gap: f64) -> C;
    fn sin_cos(&self, angle: f64) -> (f64, f64);
    /// `e^{iβ}`, `β` and the length of the line of action for `B`; `None` where the base circles overlap.
    fn line(&self, between: C, sum: f64) -> Option<(C, f64, f64)>;

    /// `B` at a gap, and its derivative by the gap.
    #[inline]
    fn between(&self, posed: &PosedFlanks, gap: f64) -> (C, C) {
        posed.centre_vector_turned(self.gap(gap))
    }
}

/// A line of action at a gap.
struct Start {
    beta: f64,
    gap: f64,
}

impl Start {
    fn new(posed: &PosedFlanks, gap: f64) -> Start {
        let (between, _) = posed.centre_vector(gap);
        let sum = posed.problem.sum();
        let length = (between.norm_sqr() - sum * sum).max(0.0).sqrt();
        let beta = between.im.atan2(between.re) + length.atan2(sum);
        Start { beta, gap }
    }
}

impl Trigonometry for Start {
    fn from(&self) -> (f64, f64) {
        (self.beta, self.gap)
    }

    fn direction(&self, beta: f64) -> C {
        turn(beta)
    }

    fn gap(&self, gap: f64) -> C {
        turn(gap)
    }

    fn sin_cos(&self, angle: f64) -> (f64, f64) {
        angle.sin_cos()
    }

    #[inline]
    fn line(&self, between: C, sum: f64) -> Option<(C, f64, f64)> {
        let line = Line::new(between, sum)?;
        Some((turn(line.angle), line.angle, line.length))
    }
}

/// A line of action of many pairs and sections that are near each other: their directions and gaps differ by slight angles.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearStart {
    /// The direction and the gap to search from.
    from: (f64, f64),
    beta: f64,
    gap: f64,
    direction: C,
    turned: C,
}

impl NearStart {
    /// The line of action of `posed` at a gap.
    pub fn new(posed: &PosedFlanks, gap: f64) -> NearStart {
        let Start { beta, .. } = Start::new(posed, gap);
        NearStart {
            from: (beta, gap),
            beta,
            gap,
            direction: turn(beta),
            turned: turn(gap),
        }
    }

    /// This line, with the search from the direction and gap of a touch.
    pub fn at(&self, found: &Separation) -> NearStart {
        NearStart {
            from: (found.beta, found.gap),
            ..*self
        }
    }
}

impl Trigonometry for NearStart {
    #[inline]
    fn from(&self) -> (f64, f64) {
        self.from
    }

    #[inline]
    fn direction(&self, beta: f64) -> C {
        self.direction * slightly_turned(beta - self.beta)
    }

    #[inline]
    fn gap(&self, gap: f64) -> C {
        self.turned * slightly_turned(gap - self.gap)
    }

    #[inline]
    fn sin_cos(&self, angle: f64) -> (f64, f64) {
        let turned = slightly_turned(angle);
        (turned.im, turned.re)
    }

    #[inline]
    fn line(&self, between: C, sum: f64) -> Option<(C, f64, f64)> {
        let all = between.norm_sqr();
        let square = all - sum * sum;
        if !(square > 0.0) {
            return None;
        }
        let length = square.sqrt();
        let direction = between * C::new(sum, length) / all;
        let beta = self.beta + small_angle(direction * self.direction.conj());
        Some((direction, beta, length))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: the reach of the end point, `ξ_f cos δ + sin δ`, and of an endless involute, `ξ`. The direction is that of a roll below the form
    /// roll, the least of all rolls in play.
    #[test]
    fn involutes_that_end_are_short_by_what_their_end_reaches_farther() {
        let separation = |rolls: [f64; 2]| Separation {
            gap: 0.0,
            by_turn: [0.0; 2],
            slope: 0.0,
            turning: 20.0,
            touches: true,
            beta: 0.0,
            rolls,
            arcs: [30.0, 20.0].map(|base| InvoluteArc {
                base,
                form: f64::NEG_INFINITY,
                tip: f64::INFINITY,
            }),
        };
        let (here, there) = (separation([0.03, -0.02]), separation([0.01, 0.05]));
        let farther = |form: f64, roll: f64| {
            let beyond: f64 = roll - form;
            form * beyond.cos() + beyond.sin() - roll
        };
        let [locked, free] = [farther(0.01, 0.01 - 0.08), farther(0.02, -0.02 - 0.06)];
        let expected = (30.0 * locked + 20.0 * free) / 20.0;
        assert!(locked > 0.0 && free > 0.0);
        let found = here.greatest_deficit(&there, [0.08, 0.06], [0.01, 0.02]);
        assert!((found - expected).abs() < 1e-16);
        assert_eq!(there.greatest_deficit(&there, [0.0, 0.0], [0.0, 0.0]), 0.0);
    }
}

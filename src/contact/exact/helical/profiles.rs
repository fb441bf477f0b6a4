//! Places along the face where flanks whose profiles deviate touch tightest.
//!
//! Hold the free gear at a gap. On the line of action of length `T` the rolls of a pair are `x_b` and `y_b` in the section at `b`. They are
//! linear in `b`, but for leads. The involutes are `a = T − r_L x_b − r_F y_b` apart, which is the same in every section, less the leads. A
//! point of the locked flank whose normal is turned by `η` from the line has the roll `x = x_b + η` and the string `s = r_L x + δ_L(x)`. With
//! the directions `e^{iη}` of its normal and `e^{iη_F}` of that of the free involute, and the string `s_F` of the free base circle,
//!
//! ```text
//! (s_F + i r_F) e^{iη_F} = T + i (r_L + r_F) − (s + i r_L) e^{iη},        y = y_b + η_F,
//! ```
//!
//! it is `D = r_F y + δ_F(y) − s_F` inside the free metal. The pair is clear if `D` is nowhere above 0. With `ζ = η − η_F`
//!
//! ```text
//! D = δ_L(x) + δ_F(y) − a + E(s, η),    E_η = r_L (1 − cos ζ) − s sin ζ,    E_s = cos ζ − 1,    E_ηη = −m (1 + m/s_F),
//! m = s cos ζ − r_L sin ζ;    η_F,η = −m/s_F,    η_F,s = −sin ζ/s_F.
//! ```
//!
//! `D` is a function of two variables, of `b` and `η`: its value and slopes at the middle of a box and bounds of its second derivatives bound
//! it over the box ([`Bounds`]). A box that cannot exceed the highest place so far is left out, others are halved. Where both flanks are smooth,
//! the highest place has a common normal, so that a box in which `D_η` cannot vanish is left out, too. A corner of either flank, its tip or the
//! edge of a relief, can also be highest. It is one point of its gear, with `η` a function of `b`, so that one variable is left. For a corner
//! of the free gear both gears change places.
//!
//! **Over a cell of rotations** ([`Plays`]) the free gear follows at a given gap. Rolls on the line move by the same angle in every section, so
//! a turn of helical teeth is a shift along the face: the face is longer by it. The rest is a play of the rolls, up to `p`, and of `T`, up to
//! `p T`, and the change of leads by the shift. A point of the first flank keeps its roll `x`, so that `η` and `y_b` move: `D` by up to
//! `|E_η| p + |δ_F'| (1 + |η_F,η|) p`, and by `T` no more than `(1 − cos η_F + |δ_F'| |sin η_F|/s_F) p T` ([`FlankPair::moved`]).
//!
//! Contacts in fillets are not found here, nor leaning axes: see [`super::leads`].

use super::profiled_flank::{Flank, FlankPiece};
use crate::contact::Effort;
use crate::contact::exact::flank_heights::amount;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::line::Line;
use crate::contact::exact::path::InvolutePair;
use crate::contact::exact::shape::{C, turn};
use crate::pair::{FacingTeeth, GearPair};
use std::ops::Range;

/// Difference of heights, mm, below which two places count as equally high: the tie of two pairs.
pub(super) const LEVEL: f64 = 1e-9;

/// Relative excess over the highest place so far that is ignored: the next round, at its gap, finds it.
const ROUGH: f64 = 1e-3;

/// Effort of the place at the middle of a box and of its bounds, nodes (tuned: 1 µs).
const BOX: u64 = 2;

/// Angle of normals, rad, beyond which a box is divided instead of bounded.
const WIDEST: f64 = 1.5;

/// Roll beyond a flank, rad, at which a pair on the line is too far away to touch: a corner leaves a room of some `r_b/5` there.
const FARTHEST: f64 = 1.0;

/// Moves of a pair over a cell of rotations, against its middle.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::contact::exact) struct Plays {
    /// Shift along the face, mm.
    pub along: f64,
    /// Change of the rolls on the line beside it, rad.
    pub roll: f64,
    /// Excess over the highest place, mm, that the bound of the heights may leave.
    pub open: f64,
}

/// The pairs of flanks of one side of a pose, with the free gear held at a gap.
pub(in crate::contact::exact) struct AlongFlanks<'a> {
    assembly: &'a GearPair,
    posed: &'a PosedFlanks<'a>,
    gap: f64,
    line: Line,
    plays: Plays,
    effort: &'a Effort<'a>,
}

/// The place of the greatest height.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact::exact) struct HighestPlace {
    pub height: f64,
    /// Mm along the face.
    pub b: f64,
    /// Excess over it that is ignored, mm.
    open: f64,
}

/// The effort of the pose is spent.
pub(in crate::contact::exact) struct Spent;

impl<'a> AlongFlanks<'a> {
    /// The flanks of `posed`, which is the measuring plane of `assembly`; `None` where there is no line of action.
    pub fn new(
        assembly: &'a GearPair,
        posed: &'a PosedFlanks<'a>,
        gap: f64,
        effort: &'a Effort<'a>,
    ) -> Option<AlongFlanks<'a>> {
        let line = Line::new(posed.centre_vector(gap).0, posed.problem.sum())?;
        Some(AlongFlanks {
            assembly,
            posed,
            gap,
            line,
            plays: Plays::default(),
            effort,
        })
    }

    /// The flanks over a cell of rotations.
    pub fn over(self, plays: Plays) -> AlongFlanks<'a> {
        AlongFlanks { plays, ..self }
    }

    /// The highest of all places above [`LEVEL`]; `None` if there is none.
    pub fn highest(&self) -> Result<Option<HighestPlace>, Spent> {
        let mut best = HighestPlace {
            height: LEVEL,
            b: f64::NAN,
            open: self.plays.open,
        };
        for step in self.steps() {
            self.search(step, &mut best)?;
        }
        Ok((best.height > LEVEL).then_some(best))
    }

    fn steps(&self) -> Range<i64> {
        let [twist, _] = self.twists();
        self.posed.steps_over(self.face().map(|b| twist * b))
    }

    /// Rolls of a step on the line in the section at 0, without leads.
    fn on_line(&self, step: i64) -> [f64; 2] {
        let pair = InvolutePair::new(self.posed, step);
        [
            self.line.angle - pair.locked_base,
            self.line.angle - self.gap - pair.free_base,
        ]
    }

    /// Upper bound of all heights over the cell, mm.
    pub fn height_bound(&self) -> Result<f64, Spent> {
        let highest = self.highest()?.map_or(LEVEL, |highest| highest.enough());
        Ok(highest.max(LEVEL + self.plays.open))
    }

    /// The greatest slope of the free gear's profiles, mm/rad; `None` if it is not below the base radius.
    pub fn steepest(&self) -> Option<f64> {
        let slope = |step| Flank::new(&self.posed.free(step)).steepest();
        let slope = self.steps().map(slope).fold(0.0, f64::max);
        (slope * self.posed.problem.per_free_base < 1.0).then_some(slope)
    }

    /// Bound of the height, mm, that the contact of a step in the section at `b` loses over the cell: either gear keeps its point, which stays
    /// on the flank of the other. Both points have these `radii` from their centres. `None` if they may leave the flanks.
    pub fn loss(&self, step: i64, b: f64, radii: [f64; 2]) -> Option<f64> {
        let (assembly, posed) = (self.assembly, self.posed);
        let halves = [posed.locked(step), posed.free(step)];
        let flanks = [Flank::new(&halves[0]), Flank::new(&halves[1])];
        let teeth = posed.facing_teeth(assembly, step);
        let twists = self.twists();
        let [from, to] = assembly.face();
        // Where the face is too short for the shift, the rolls turn instead.
        let short = (self.plays.along - (b - from).min(to - b)).max(0.0);
        let play = self.plays.roll + short * twists[0].abs().max(twists[1].abs());
        let (leads, on_line) = (teeth.leads(b), self.on_line(step));
        let each = [0, 1].map(|k| {
            let Flank { base, range, .. } = flanks[k];
            let roll = (radii[k] * radii[k] - base * base).max(0.0).sqrt() / base;
            let moved = flanks[k].farthest() / base;
            let turned = roll - (on_line[k] - twists[k] * b + leads[k] / base);
            (roll, moved, turned.abs() + moved, range)
        });
        let zeta = each[0].2 + each[1].2 + 2.0 * play;
        if zeta > WIDEST {
            return None;
        }
        let sin = zeta.sin();
        let losses = [[0, 1], [1, 0]].map(|[own, mate]| {
            let (roll, moved, ..) = each[own];
            let (mate_roll, mate_moved, _, [low, high]) = each[mate];
            let (base, slope) = (flanks[own].base, flanks[mate].steepest());
            let arm = base * (roll + moved);
            let reach = flanks[mate].base * (mate_roll - mate_moved) - arm * play;
            let follows = (arm + base * sin) / reach;
            let turned = mate_moved + (1.0 + follows) * play;
            let stays = reach > 0.0 && mate_roll - turned >= low && mate_roll + turned <= high;
            let tilted = ((base + self.line.length) * sin + arm) * sin;
            let loss = tilted + slope * (1.0 + follows + self.line.length * sin / reach);
            stays.then_some(loss * play)
        });
        let along = self.plays.along;
        let near = [b - along, b + along];
        let [one, other] = teeth.steepest(near);
        let least = losses.into_iter().flatten().reduce(f64::min)?;
        let fall = teeth.lead_sum(b) - teeth.lead_sum_bounds(near)[0];
        Some(least + fall.min(along * (one + other)))
    }

    fn twists(&self) -> [f64; 2] {
        let members = [self.assembly.locked(), self.assembly.free()];
        members.map(|member| self.posed.twist(self.assembly, member))
    }

    /// Both ends of the common face, extended by the shift along it, mm.
    fn face(&self) -> [f64; 2] {
        let [from, to] = self.assembly.face();
        [from - self.plays.along, to + self.plays.along]
    }

    /// Raises `best` to the highest place of a step.
    fn search(&self, step: i64, best: &mut HighestPlace) -> Result<(), Spent> {
        let (assembly, posed) = (self.assembly, self.posed);
        let halves = [posed.locked(step), posed.free(step)];
        let flanks = [Flank::new(&halves[0]), Flank::new(&halves[1])];
        let teeth = posed.facing_teeth(assembly, step);
        let rolls = self.on_line(step);
        let bases = flanks.each_ref().map(|flank| flank.base);
        let apart = self.line.length - bases[0] * rolls[0] - bases[1] * rolls[1];
        let face = self.face();
        self.effort.spend(BOX);
        let most = teeth.lead_sum_bound(face) + flanks[0].most() + flanks[1].most() - apart;
        if most <= best.enough() {
            return Ok(());
        }
        let twists = self.twists();
        let mut near = face;
        for (k, flank) in flanks.iter().enumerate().filter(|(k, _)| twists[*k] != 0.0) {
            let beyond = [flank.range[0] - FARTHEST, flank.range[1] + FARTHEST];
            let ends = beyond.map(|roll| (rolls[k] - roll) / twists[k]);
            near[0] = near[0].max(ends[0].min(ends[1]));
            near[1] = near[1].min(ends[0].max(ends[1]));
        }
        if near[0] > near[1] {
            return Ok(());
        }
        let knots = teeth.knots(near, |_, place| place);
        let pieces = flanks.each_ref().map(Flank::pieces);
        let flanks = flanks.each_ref();
        for ends in knots.windows(2) {
            let ends = [ends[0], ends[1]];
            let line = (&self.line, self.plays);
            let locked = FlankPair::new(&teeth, [0, 1], flanks, (rolls, twists), line, ends);
            let free = FlankPair::new(&teeth, [1, 0], flanks, (rolls, twists), line, ends);
            for one in &pieces[0] {
                for other in &pieces[1] {
                    locked.smooth([one, other], best, self.effort)?;
                }
            }
            for ordered in [&locked, &free] {
                for corner in ordered.flanks[0].corners() {
                    ordered.corner(corner, best, self.effort)?;
                }
            }
        }
        Ok(())
    }
}

/// A pair of flanks between two knots of its leads. The first one has the point whose height in the metal of the second is taken.
struct FlankPair<'a> {
    teeth: &'a FacingTeeth<'a>,
    order: [usize; 2],
    flanks: [&'a Flank<'a>; 2],
    bases: [f64; 2],
    twists: [f64; 2],
    /// Rolls on the line in the section at 0, without leads.
    rolls: [f64; 2],
    /// `T`, mm.
    length: f64,
    /// Play of the rolls on the line, rad.
    play: f64,
    /// Shift along the face, mm.
    along: f64,
    ends: [f64; 2],
    /// Greatest rates of the rolls on the line along the face, rad/mm.
    rates: [f64; 2],
    /// Greatest second derivative of the sum of the leads, mm per mm², or 0, and of each roll on the line.
    bends: (f64, [f64; 2]),
}

/// A point of the first flank in a section.
struct Point {
    b: f64,
    rolls: [f64; 2],
    /// Rates of the rolls on the line and of the leads along the face.
    rates: [f64; 2],
    lead_rate: f64,
    /// `s`, `s_F`, and the distance from the centre of the second gear.
    arm: f64,
    reach: f64,
    radius: f64,
    zeta: f64,
    slopes: [f64; 2],
    /// `D`.
    height: f64,
}

/// Bounds over points near another.
struct Bounds {
    /// `E_ηη` is at most `−least_bend`.
    least_bend: f64,
    /// Amounts of `η_F,η` and `η_F,s`.
    follows: f64,
    by_arm: f64,
    /// Amounts of the second derivatives of `η_F`: twice by `η`, by both, twice by `s`.
    bows: [f64; 3],
    /// Amount of `sin ζ`.
    sin: f64,
    /// Amount of `m`.
    along: f64,
    /// Greatest change of `η_F`.
    turned: f64,
}

impl<'a> FlankPair<'a> {
    fn new(
        teeth: &'a FacingTeeth<'a>,
        order: [usize; 2],
        flanks: [&'a Flank<'a>; 2],
        (rolls, twists): ([f64; 2], [f64; 2]),
        (line, plays): (&Line, Plays),
        ends: [f64; 2],
    ) -> FlankPair<'a> {
        let flanks = order.map(|k| flanks[k]);
        let bases = flanks.map(|flank| flank.base);
        let (steepest, bends) = (teeth.steepest(ends), teeth.second_derivative_bounds(ends));
        let [steepest, twists, rolls] = [steepest, twists, rolls].map(|of| order.map(|k| of[k]));
        let bends = order.map(|k| bends[k]);
        let bend = |k: usize| amount(bends[k]) / bases[k];
        FlankPair {
            teeth,
            order,
            flanks,
            bases,
            twists,
            rolls,
            length: line.length,
            play: plays.roll,
            along: plays.along,
            ends,
            rates: [0, 1].map(|k| twists[k].abs() + steepest[k] / bases[k]),
            bends: ((bends[0][1] + bends[1][1]).max(0.0), [bend(0), bend(1)]),
        }
    }

    /// Rolls on the line at `b`.
    fn on_line(&self, b: f64) -> [f64; 2] {
        let leads = self.teeth.leads(b);
        [0, 1].map(|k| self.rolls[k] - self.twists[k] * b + leads[self.order[k]] / self.bases[k])
    }

    /// The point at `b` whose normal is turned by `eta`; `None` inside the second base circle.
    fn point(&self, b: f64, eta: f64, pieces: [&FlankPiece; 2]) -> Option<Point> {
        let [one, other] = self.bases;
        let on_line = self.on_line(b);
        let rates = self.teeth.lead_rates(b);
        let roll = on_line[0] + eta;
        let [out, slope, _] = pieces[0].jet(roll);
        let arm = one * roll + out;
        let towards = C::new(self.length, one + other) - C::new(arm, one) * turn(eta);
        let square = towards.norm_sqr();
        let reach = square - other * other;
        if !(reach > 0.0) {
            return None;
        }
        let reach = reach.sqrt();
        let end = towards * C::new(reach, -other);
        let follows = end.im.atan2(end.re);
        let mate = on_line[1] + follows;
        let [mate_out, mate_slope, _] = pieces[1].jet(mate);
        Some(Point {
            b,
            rolls: [roll, mate],
            rates: [0, 1].map(|k| rates[self.order[k]] / self.bases[k] - self.twists[k]),
            lead_rate: rates[0] + rates[1],
            arm,
            reach,
            radius: square.sqrt(),
            zeta: eta - follows,
            slopes: [slope, mate_slope],
            height: other * mate + mate_out - reach,
        })
    }

    /// Bounds over points with normals turned by up to `eta`, rad, against that of `at`, and strings by up to `arm`, mm; `None` if they are
    /// too far away.
    fn bounds(&self, at: &Point, eta: f64, arm: f64) -> Option<Bounds> {
        let [one, other] = self.bases;
        let [least, most] = [at.arm - arm, at.arm + arm];
        let way = most.hypot(one) * eta + arm;
        let square = |radius: f64| radius * radius - other * other;
        let near = at.radius - way;
        if !(near > other && least > 0.0) {
            return None;
        }
        let [reach, far] = [square(near).sqrt(), square(at.radius + way).sqrt()];
        // A point that moves by a length turns the string by no more than that over the string.
        let turned = way / reach;
        let zeta = at.zeta.abs() + eta + turned;
        if zeta > WIDEST {
            return None;
        }
        let (sin, cos) = zeta.sin_cos();
        let along = [least * cos - one * sin, most + one * sin];
        let least_bend = if along[0] > 0.0 {
            along[0] * (1.0 + along[0] / far)
        } else {
            along[0]
        };
        let along = along[1].max(-along[0]);
        let (follows, by_arm) = (along / reach, sin / reach);
        // Amount of `s_F,η`.
        let stretch = one + most * sin + other * follows;
        Some(Bounds {
            least_bend,
            follows,
            by_arm,
            bows: [
                ((most * sin + one) * (1.0 + follows) + follows * stretch) / reach,
                (1.0 + follows + by_arm * stretch) / reach,
                by_arm * (2.0 + other * by_arm) / reach,
            ],
            sin,
            along,
            turned,
        })
    }

    /// Raises `best` to the highest common normal of two pieces, as the first and the second flank.
    fn smooth(
        &self,
        pieces: [&FlankPiece; 2],
        best: &mut HighestPlace,
        effort: &Effort,
    ) -> Result<(), Spent> {
        let all = pieces.map(|piece| piece.bounds(piece.range));
        let slopes = all.map(|bounds| amount(bounds[1]));
        let arms = [0, 1].map(|k| self.bases[k] * pieces[k].range[0] + all[k][0][0]);
        // A common normal has s sin ζ = δ_L' cos ζ + δ_F' η_F', with |η_F'| up to (s + |δ_L'|)/s_F, and |η| is at most |ζ|.
        let tilt = slopes[0] / arms[0] + slopes[1] * (1.0 + slopes[0] / arms[0]) / arms[1];
        let widest = if arms.iter().all(|arm| *arm > 0.0) && tilt < 0.5 {
            1.05 * tilt
        } else {
            WIDEST / 3.0
        };
        let [from, to] = self.ends;
        let widest = widest + self.play;
        let mut open = vec![[0.5 * (from + to), 0.5 * (to - from), 0.0, widest]];
        while let Some([b, half, eta, wide]) = open.pop() {
            effort.spend(BOX);
            if effort.is_spent() {
                return Err(Spent);
            }
            let rolls = self.on_line(b);
            let play = self.rates.map(|rate| rate * half);
            let first = play[0] + wide;
            let ranges = [rolls[0] + eta - first, rolls[0] + eta + first];
            if pieces[0].misses(ranges) {
                continue;
            }
            let own = pieces[0].bounds(ranges);
            let [lead, led] = self.leads(b, half);
            let shortest = self.bases[0] * ranges[0].max(pieces[0].range[0]) + own[0][0];
            let turned = eta.abs() - wide - self.play;
            let top = own[0][1] + lead - self.apart() - self.room(shortest, turned);
            if top + all[1][0][1] <= best.enough() {
                continue;
            }
            let at = self.point(b, eta, pieces);
            let steepest = amount(own[1]);
            let arm = (self.bases[0] + steepest) * first;
            let bounds = at
                .as_ref()
                .and_then(|at| self.bounds(at, wide + self.play, arm));
            // How much each half width may add.
            let mut adds = [half * self.bases[0] * self.rates[0], wide * self.bases[0]];
            if let Some((at, near)) = at.zip(bounds) {
                let second = play[1] + near.turned + self.play;
                let mates = [at.rolls[1] - second, at.rolls[1] + second];
                if pieces[1].misses(mates) {
                    continue;
                }
                let mate = pieces[1].bounds(mates);
                self.offer(&at, pieces, best);
                let moved = self.moved(&at, &near, mate[1]);
                let bound = self.box_of(&at, &near, [own, mate], &mut adds, [half, wide]);
                let bound = bound + moved + led;
                adds[1] += self.play * at.arm * (1.0 + near.follows) * wide;
                if bound.min(top + mate[0][1]) <= best.enough()
                    || self.has_no_normal(&at, &near, [own, mate], [half, wide])
                {
                    continue;
                }
                if at.height > best.enough() {
                    // The box is beyond the end of a piece. A smaller one is on it or misses it.
                    adds = [play[0], wide];
                }
            }
            let [along, across] = if adds[0] >= adds[1] && half > 0.0 {
                [0.5 * half, wide]
            } else {
                [half, 0.5 * wide]
            };
            for side in [-1.0, 1.0] {
                let moved = [b + side * (half - along), eta + side * (wide - across)];
                open.push([moved[0], along, moved[1], across]);
            }
        }
        Ok(())
    }

    /// Least amount of `E`, mm, from an angle `eta` of the normal on, with strings from `arm` on. It grows with the angle, as `|ζ| ≥ |η|`, while
    /// `m` is above 0.
    fn room(&self, arm: f64, eta: f64) -> f64 {
        let base = self.bases[0];
        if !(eta > 0.0 && arm > 0.0) {
            return 0.0;
        }
        let eta = eta.min(arm.atan2(base));
        arm * (1.0 - eta.cos()) - base * (eta - eta.sin())
    }

    /// Distance of the involutes at the held gap, mm, without leads.
    fn apart(&self) -> f64 {
        self.length - self.bases[0] * self.rolls[0] - self.bases[1] * self.rolls[1]
    }

    /// A bound of the height over a box of the half widths `halves`, mm and rad. `adds` becomes what each adds to the height at its middle.
    ///
    /// With `u` the change of `x_b` and `v` that of `η`, `x` changes by `u + v`, and `y` by up to `Y_b |Δb| + Y_η |v|`. Products are shared by
    /// `(u + v)² ≤ 2 u² + 2 v²` and `|v| |u + v| ≤ 3/2 v² + u²/2`.
    fn box_of(
        &self,
        at: &Point,
        near: &Bounds,
        deviations: [[[f64; 2]; 3]; 2],
        adds: &mut [f64; 2],
        [half, wide]: [f64; 2],
    ) -> f64 {
        let [own, mate] = deviations;
        let [steepest, mate_steepest] = [amount(own[1]), amount(mate[1])];
        let arm = self.bases[0] + steepest;
        let rate = self.rates[0];
        let outward = 1.0 + mate_steepest * near.by_arm;
        // The deviation also moves the point in E and in the direction of the string.
        let beside = (near.sin + mate_steepest * near.by_arm) * amount(own[2]);
        let square =
            own[2][1].max(0.0) * outward + beside + mate_steepest * near.bows[2] * arm * arm;
        let product = (near.sin * (1.0 + near.follows) + mate_steepest * near.bows[1]) * arm;
        let mate_moves = [
            self.rates[1] + near.by_arm * arm * rate,
            near.follows + near.by_arm * arm,
        ];
        let mate_square = 2.0 * mate[2][1].max(0.0);
        let (leads, [bend, mate_bend]) = self.bends;
        let by_b = (2.0 * square + product) * rate * rate
            + mate_square * mate_moves[0] * mate_moves[0]
            + leads
            + (steepest * outward + arm * (near.sin + mate_steepest * near.by_arm)) * bend
            + mate_steepest * mate_bend;
        let by_eta = 2.0 * square
            + 3.0 * product
            + mate_square * mate_moves[1] * mate_moves[1]
            + mate_steepest * near.bows[0]
            - near.least_bend;
        let slopes = self.slopes(at);
        *adds = [
            greatest(slopes[0], by_b, half),
            greatest(slopes[1], by_eta, wide),
        ];
        at.height + adds[0] + adds[1]
    }

    /// `D_b` and `D_η`.
    fn slopes(&self, at: &Point) -> [f64; 2] {
        let (sin, cos) = at.zeta.sin_cos();
        let [slope, mate_slope] = at.slopes;
        let moved = (self.bases[0] + slope) * at.rates[0];
        let by_b = at.lead_rate + mate_slope * at.rates[1] + slope * at.rates[0]
            - mate_slope * moved * sin / at.reach
            + moved * (cos - 1.0);
        let follows = -(slope * sin + at.arm * cos) / at.reach;
        [by_b, mate_slope * follows + slope * cos - at.arm * sin]
    }

    /// Whether no point of a box has a common normal with the second flank.
    fn has_no_normal(
        &self,
        at: &Point,
        near: &Bounds,
        deviations: [[[f64; 2]; 3]; 2],
        [half, wide]: [f64; 2],
    ) -> bool {
        let [own, mate] = deviations;
        let [steepest, mate_steepest] = [amount(own[1]), amount(mate[1])];
        let arm = self.bases[0] + steepest;
        let square = amount(own[2]) * (1.0 + mate_steepest * near.by_arm + near.sin)
            + mate_steepest * near.bows[2] * arm * arm
            + arm * arm * near.sin * near.by_arm;
        let product = (near.sin * (1.0 + near.follows) + mate_steepest * near.bows[1]) * arm;
        let mate_moves = [
            self.rates[1] + near.by_arm * arm * self.rates[0],
            near.follows + near.by_arm * arm,
        ];
        let mate_square = amount(mate[2]) * mate_moves[1];
        let by_b = (square + product) * self.rates[0] + mate_square * mate_moves[0];
        let by_eta = square
            + 2.0 * product
            + mate_square * mate_moves[1]
            + mate_steepest * near.bows[0]
            + near.along * (1.0 + near.follows);
        let by_play = by_eta + amount(mate[2]) * mate_moves[1];
        let open = by_b * half + by_eta * wide + by_play * self.play;
        // Its rounding is far below the level.
        self.slopes(at)[1].abs() > open + LEVEL
    }

    /// Bounds of the sum of the leads within `half` of `b`, over the cell, and of what the shift adds to it anywhere there, mm.
    fn leads(&self, b: f64, half: f64) -> [f64; 2] {
        let near = half + self.along;
        let near = [b - near, b + near];
        let most = self.teeth.lead_sum_bound(near);
        if !(self.along > 0.0) {
            return [most, 0.0];
        }
        let [one, other] = self.teeth.steepest(near);
        let rate = one + other;
        let rise = most - self.teeth.lead_sum(b) + half * rate;
        [most, rise.min(self.along * rate)]
    }

    /// Bound on what the play of the rolls adds to the height of a point near `at`, mm, where the second flank has slopes between `slopes`:
    /// the point keeps its place on the first flank.
    fn moved(&self, at: &Point, near: &Bounds, slopes: [f64; 2]) -> f64 {
        let tilted = ((self.bases[0] + self.length) * near.sin + at.arm) * near.sin;
        let followed = 1.0 + near.follows + near.by_arm * self.length;
        self.play * (tilted + amount(slopes) * followed)
    }

    /// Replaces `best` by a point that is on both flanks and higher, with what the play of the rolls adds.
    fn offer(&self, at: &Point, pieces: [&FlankPiece; 2], best: &mut HighestPlace) {
        let mut mates = [at.rolls[1]; 2];
        let mut height = at.height;
        if self.along > 0.0 {
            height += self.leads(at.b, 0.0)[1];
        }
        if self.play > 0.0 {
            let Some(near) = self.bounds(at, self.play, 0.0) else {
                return;
            };
            let second = near.turned + self.play;
            mates = [mates[0] - second, mates[1] + second];
            height += self.moved(at, &near, pieces[1].bounds(mates)[1]);
        }
        let is_on = !pieces[0].misses([at.rolls[0]; 2]) && !pieces[1].misses(mates);
        if height > best.height && is_on {
            (best.height, best.b) = (height, at.b);
        }
    }

    /// Raises `best` to the highest place of the corner of the first flank at a roll.
    fn corner(&self, roll: f64, best: &mut HighestPlace, effort: &Effort) -> Result<(), Spent> {
        let whole = [self.flanks[0].whole(), self.flanks[1].whole()];
        let pieces = whole.each_ref();
        let arm = self.bases[0] * roll + pieces[0].jet(roll)[0];
        let mate_most = self.flanks[1].most();
        let [from, to] = self.ends;
        let mut open = vec![[0.5 * (from + to), 0.5 * (to - from)]];
        while let Some([b, half]) = open.pop() {
            effort.spend(BOX);
            if effort.is_spent() {
                return Err(Spent);
            }
            let rolls = self.on_line(b);
            let (wide, eta) = (self.rates[0] * half, roll - rolls[0]);
            let [lead, led] = self.leads(b, half);
            let most = arm - self.bases[0] * roll + mate_most + lead - self.apart();
            if most - self.room(arm, eta.abs() - wide - self.play) <= best.enough() {
                continue;
            }
            let at = self.point(b, eta, pieces).map(|at| Point {
                // As rounding may leave it beyond the end.
                rolls: [roll, at.rolls[1]],
                ..at
            });
            let bounds = at
                .as_ref()
                .and_then(|at| self.bounds(at, wide + self.play, 0.0));
            if let Some((at, near)) = at.zip(bounds) {
                let second = self.rates[1] * half + near.turned + self.play;
                let mates = [at.rolls[1] - second, at.rolls[1] + second];
                if pieces[1].misses(mates) {
                    continue;
                }
                self.offer(&at, pieces, best);
                let mate = pieces[1].bounds(mates);
                let mate_steepest = amount(mate[1]);
                let (sin, cos) = at.zeta.sin_cos();
                let along = at.arm * cos - self.bases[0] * sin;
                let turning = -at.rates[0];
                // `E_η`, and what it can be.
                let by_eta = self.bases[0] * (1.0 - cos) - at.arm * sin;
                let most_by_eta = (self.bases[0] + at.arm) * near.sin;
                let slope = at.lead_rate
                    + at.slopes[1] * (at.rates[1] - along / at.reach * turning)
                    + by_eta * turning;
                let rate = self.rates[0];
                let moves = self.rates[1] + near.follows * rate;
                let (leads, [bend, mate_bend]) = self.bends;
                let second = mate[2][1].max(0.0) * moves * moves
                    + (mate_steepest * near.bows[0] - near.least_bend) * rate * rate
                    // A lead changes the rate of η, whose least amount bounds a falling bend.
                    + near.least_bend.max(0.0) * (rate * rate - self.least_rate().powi(2))
                    + leads
                    + (most_by_eta + mate_steepest * near.follows) * bend
                    + mate_steepest * mate_bend;
                let moved = self.moved(&at, &near, mate[1]);
                if at.height + greatest(slope, second, half) + moved + led <= best.enough() {
                    continue;
                }
            }
            if !(half > 0.0) {
                continue;
            }
            for side in [-1.0, 1.0] {
                open.push([b + 0.5 * side * half, 0.5 * half]);
            }
        }
        Ok(())
    }

    /// Least amount of the rate of the first roll on the line, rad/mm.
    fn least_rate(&self) -> f64 {
        (2.0 * self.twists[0].abs() - self.rates[0]).max(0.0)
    }
}

impl HighestPlace {
    /// The height above which a place matters.
    fn enough(&self) -> f64 {
        if self.b.is_nan() {
            self.height + self.open
        } else {
            self.height * (1.0 + ROUGH) + self.open
        }
    }
}

/// Greatest value of a parabola, from its slope and second derivative in the middle of an interval of this half width, above that there.
fn greatest(slope: f64, second: f64, half: f64) -> f64 {
    let slope = slope.abs();
    if second < 0.0 && slope < -second * half {
        -0.5 * slope * slope / second
    } else {
        half * (slope + 0.5 * second * half)
    }
}

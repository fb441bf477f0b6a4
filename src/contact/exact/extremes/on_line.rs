//! The room of pairs on the line of action over a stretch of a mating: a parabola, and a bound of what it leaves.
//!
//! With `S = T(B) − Σ β(B) + r_bL (λ_b + x) + r_bF (μ + μ_b)`, `B` the way between the outlines' centres and `β` the direction of the line, two endless
//! involutes touch where `S = 0`. Along that, with `b' = |B'|` and so on,
//!
//! ```text
//! dS/dB: Im(e^{iβ} dB*),   β' = Re(e^{iβ} B'*)/T,   T' = Im(e^{iβ} B'*) + Σ β'
//! −r_bF μ''  =  Im(e^{iβ} B''*) + β' Re(e^{iβ} B'*)
//! −r_bF μ''' =  Im(e^{iβ} B'''*) + 2 β' Re(e^{iβ} B''*) + β'' Re(e^{iβ} B'*) − β'² Im(e^{iβ} B'*)
//! ```
//!
//! `B` runs on the circles of both eccentricities alone, so `μ'''` is of their size, and over half a stretch of `w/2` the parabola through the middle is off
//! by `|μ'''| w³/48` at most.

use super::course::SideCourse;
use super::over::Over;
use super::room::Piece;
use super::separation::{Separation, lowest_roll};
use super::table::Table;

/// Effort of one pair.
const STEP: u64 = 4;

/// Pairs beside the line of action may lie so much below those on it, rad, by what endless involutes leave open: far below any width asked for.
const BELOW: f64 = 1e-12;

/// `middle + rate u + bend u²/2`, `u` from −1/2 to 1/2 over the stretch.
#[derive(Debug, Clone, Copy)]
struct Parabola {
    middle: f64,
    rate: f64,
    bend: f64,
}

/// The room of one side over a stretch.
#[derive(Debug)]
pub(super) struct OnLine {
    /// That of the pairs on the line of action all through: the least of them is the side's.
    pairs: Vec<Parabola>,
    /// What it may be off that, rad.
    rest: f64,
}

/// Bounds of what both sides have together, and shares of the stretch at which they are expected.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sum {
    pub low: f64,
    pub high: f64,
    pub lowest: f64,
    pub highest: f64,
}

impl Parabola {
    fn at(&self, u: f64) -> f64 {
        self.middle + u * (self.rate + 0.5 * self.bend * u)
    }

    /// The least value and where it is.
    fn least(&self) -> (f64, f64) {
        let turn = -self.rate / self.bend;
        let ends = [-0.5, 0.5].map(|u| (self.at(u), u));
        let end = if ends[0].0 <= ends[1].0 {
            ends[0]
        } else {
            ends[1]
        };
        if self.bend > 0.0 && turn.abs() < 0.5 {
            (self.at(turn), turn)
        } else {
            end
        }
    }

    /// This one and `times` another.
    fn plus(&self, times: f64, other: &Parabola) -> Parabola {
        Parabola {
            middle: self.middle + times * other.middle,
            rate: self.rate + times * other.rate,
            bend: self.bend + times * other.bend,
        }
    }
}

/// A bound of `|μ'''|` of the pairs of a side.
pub(super) fn jerk(side: &SideCourse) -> f64 {
    let problem = side.problem;
    let (locked, free) = (problem.locked.shape.base, problem.free.shape.base);
    let [own, other] = side.off;
    let (sum, nearest) = (problem.sum(), problem.distance - own - other);
    let length = ((nearest - sum) * (nearest + sum)).sqrt();
    let arm = free - other;
    let first = (locked + own) / arm;
    // |B'|, |μ''|, |B''|, |T'|, |β''|, and what of |B'''| does not come from μ'''.
    let speed = own + other * first;
    let second = (own + other * first * first + speed * speed / length) / arm;
    let turned = own + other * (first * first + second);
    let lengthening = speed * (1.0 + sum / length);
    let tilting = turned / length + speed * (speed + lengthening) / (length * length);
    let jolt = own + other * first * (first * first + 3.0 * second);
    let rest = 2.0 * speed * turned / length + speed * tilting + speed.powi(3) / (length * length);
    (jolt + rest) / arm
}

impl Over<'_> {
    /// The room of side `index` over a stretch of a `part` of `mating`; `None` where pairs beside the line of action may bound it, or tips on fillets.
    pub fn room_on_line(
        &self,
        table: &Table,
        (index, mating, part): (usize, u64, usize),
    ) -> Option<OnLine> {
        if !self.faces.is_empty() {
            return None;
        }
        let problem = self.side.problem;
        let forms = [&problem.locked.shape, &problem.free.shape].map(lowest_roll);
        let plays = self.plays().map(|play| 0.5 * play);
        let angle = problem.locked.pitch * self.width();
        let middle = self.ends[0].on(0.5 * self.width());
        let mut near = middle.nominal_gap();
        let (mut pairs, mut others) = (Vec::with_capacity(4), Vec::with_capacity(4));
        let mut dipping = Vec::new();
        for open in table.steps(index, mating, part) {
            self.effort.spend(STEP);
            let found = Separation::new(&middle.flanks, open.step, near, true);
            near = found.gap;
            let parabola = Parabola {
                middle: middle.room(found.gap),
                rate: middle.rate(found.slope) * self.width(),
                bend: -found.second(&middle.flanks) * angle * angle,
            };
            if table.covers(index, part, open.step) {
                pairs.push(parabola);
            } else {
                others.push((parabola, found.short(&found, plays, forms)));
            }
            if open.dips {
                dipping.push(open.step);
            }
        }
        let tightest = pairs.iter().min_by(|a, b| a.middle.total_cmp(&b.middle))?;
        let is_above = |(other, short): &(Parabola, f64)| {
            other.plus(-1.0, tightest).least().0 - short >= -BELOW
        };
        let rest = self.side.jerk * angle.abs().powi(3) / 48.0 + self.rounding() + BELOW;
        let above = rest + 0.125 * tightest.bend.abs();
        let line = Piece {
            over: [0.0, 1.0],
            room: [-0.5, 0.5].map(|u| tightest.at(u) + above),
        };
        let is_clear = |step: &i64| {
            let places = self.places(&self.ends, *step);
            let dips = self.side.dips.iter();
            let mut near = dips.filter(|dip| dip.may_dip(places.at, places.play));
            near.all(|dip| self.is_clear(*step, dip, &[line]))
        };
        let is_on_line =
            rest.is_finite() && others.iter().all(is_above) && dipping.iter().all(is_clear);
        is_on_line.then_some(OnLine { pairs, rest })
    }
}

impl OnLine {
    /// What both sides have together.
    pub fn sum([right, left]: &[OnLine; 2]) -> Sum {
        let rest = right.rest + left.rest;
        let both = |r: &Parabola| {
            left.pairs
                .iter()
                .map(|l| l.plus(1.0, r))
                .collect::<Vec<_>>()
        };
        let zero = Parabola {
            middle: 0.0,
            rate: 0.0,
            bend: 0.0,
        };
        let (mut low, mut high) = ((f64::INFINITY, 0.0), (f64::INFINITY, 0.0));
        for sum in right.pairs.iter().flat_map(both) {
            let least = sum.least();
            let (most, at) = zero.plus(-1.0, &sum).least();
            if least.0 < low.0 {
                low = least;
            }
            if -most < high.0 {
                high = (-most, at);
            }
        }
        Sum {
            low: low.0 - rest,
            high: high.0 + rest,
            lowest: 0.5 + low.1,
            highest: 0.5 + high.1,
        }
    }
}

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
            if !found.touches {
                return None;
            }
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

#[cfg(test)]
mod tests {
    use super::super::super::ExactKernel;
    use super::super::cell::Cell;
    use super::super::course::{Course, PARTS};
    use super::super::table::Table;
    use super::*;
    use crate::contact::Effort;
    use crate::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, Pitch};
    use crate::pair::{GearPair, Mating};

    fn pair(eccentricities: [f64; 2], pitch: f64) -> GearPair {
        let gear = |teeth: u32, k: usize, face| {
            let curve = |start: u32| -> Vec<f64> {
                let each = (0..teeth).map(|i| pitch * f64::from((i * 37 + start) % 11) / 11.0);
                each.collect()
            };
            let deviations = Deviations {
                pitch: Some(Pitch::from_cumulative(&curve(3), &curve(8))),
                eccentricity: eccentricities[k],
                high_tooth: 3.7,
                ..Deviations::default()
            };
            let gear = Gear::nominal(GearDesign::plain(teeth, 1.0)).unwrap();
            AsBuilt::new(gear, face, &deviations).unwrap()
        };
        let (wheel, pinion) = (gear(20, 0, Face::Front), gear(40, 1, Face::Back));
        GearPair::new(wheel, pinion, 30.1).unwrap()
    }

    /// No pose lies outside the bounds of its part, and where pairs on the line of action alone bound it the bounds are those of the poses, but for the
    /// poses' own distance. Source: poses of the exact method.
    #[test]
    fn bounds_of_parts_hold_their_poses_and_are_near() {
        for (eccentricities, pitch) in [([0.009, 0.011], 0.0), ([0.05, 0.02], 0.006)] {
            let pair = pair(eccentricities, pitch);
            let kernel = ExactKernel::new(&pair);
            let effort = Effort::endless();
            let course = Course::new(&kernel, &pair, (Mating::FIRST, 40), &effort);
            let table = Table::new(&course);
            let (mut near, mut all) = (0, 0);
            for mating in (0..40).step_by(3) {
                for part in 0..PARTS {
                    let cell = Cell::of_part(mating, part).bounded(&course, &table);
                    let places =
                        (0..=40).map(|k| cell.from + (cell.to - cell.from) * f64::from(k) / 40.0);
                    let angles: Vec<f64> = places
                        .map(|at| {
                            let mating = course.mating(mating, at);
                            let found = kernel.lost_motion_at(&pair, mating).unwrap().unwrap();
                            found.angle().unwrap()
                        })
                        .collect();
                    let low = angles.iter().copied().fold(f64::INFINITY, f64::min);
                    let high = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                    let case = format!("{mating} {part}: {low} … {high}, {cell:?}");
                    assert!(cell.low <= low && high <= cell.high, "{case}");
                    all += 1;
                    near += u32::from(low - cell.low < 2e-8 && cell.high - high < 2e-8);
                }
            }
            assert!(near > all / 3, "{near} of {all}");
        }
    }

    /// The third derivative of a gap stays within its bound, and comes within a fifth of it somewhere. Source: differences of gaps.
    #[test]
    fn no_gap_jerks_more_than_its_bound() {
        for eccentricities in [[0.4, 0.0], [0.0, 0.4], [0.2, 0.3]] {
            let pair = pair(eccentricities, 0.0);
            let kernel = ExactKernel::new(&pair);
            let effort = Effort::endless();
            let course = Course::new(&kernel, &pair, (Mating::FIRST, 40), &effort);
            let mut share = 0.0f64;
            for (side, index) in [(0, 0), (1, 5), (0, 11), (1, 23), (0, 34)] {
                let posed = course.posed(index)[side].flanks;
                let gap = |x: f64| Separation::new(&posed.turned_on(x), 0, 0.0, true).gap;
                for k in -20..20 {
                    const H: f64 = 4e-3;
                    let at = 0.05 * f64::from(k);
                    let [a, b, c, d] = [-1.5, -0.5, 0.5, 1.5].map(|step| gap(at + step * H));
                    let jerk = ((d - 3.0 * c + 3.0 * b - a) / (H * H * H)).abs();
                    let bound = course.sides[side].jerk;
                    assert!(jerk <= bound + 1e-6, "{index} {k}: {jerk} {bound}");
                    share = share.max(jerk / bound);
                }
            }
            assert!(share > 0.2, "{share}");
        }
    }
}

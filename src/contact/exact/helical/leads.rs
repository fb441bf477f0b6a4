//! Places along the face where teeth with lead deviations touch tightest.
//!
//! In the section at `b` a tooth is that of the measuring plane, turned by its twist and by `−δ(b)/r_b`. On the line of action the gap of a
//! pair is a constant plus `Σ δ(b)/r_bF`. Beyond its stretch on the line a tip corner touches, and without leads the gap falls concavely. So
//! between two knots of the leads, where `Σ δ` is straight or crowned, the gap is concave along the face. It is greatest at a knot, at an
//! end of the face, or where its rate `∂μ/∂λ λ' + ∂μ/∂φ φ'` vanishes. [`Separation`] has the gap and both derivatives, for involutes and their
//! ends. It is asked from the stretch on the line outwards, because far beyond it two teeth do not face each other. A pair whose endless
//! involutes cannot reach the known gap is left out.

use super::turning::TwistedTeeth;
use crate::contact::Effort;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::separation::{Separation, lowest_roll};
use crate::gear::AsBuilt;
use crate::pair::GearPair;
use std::ops::RangeInclusive;

/// Effort of one evaluation of a pair, nodes (tuned: 0.2 µs).
const LOOK: u64 = 1;

/// Distance from a knot at which the rate beside it is taken, as a part of the stretch between knots.
const BESIDE: f64 = 1e-7;

/// Parts in which a stretch is examined where the leads are hollow, so that the gap may have several maxima (tuned).
const HOLLOW_PARTS: usize = 8;

/// First step outwards from the stretch on the line, as a part of the rest of a stretch between knots (tuned).
const FIRST_STEP: f64 = 1.0 / 64.0;

/// Limit of steps to the maximum of a stretch. Six to twelve are usual.
const MOST_STEPS: usize = 60;

/// Gap, rad, by which a step to a maximum may still change it: rounding.
const SETTLED: f64 = 1e-15;

/// The teeth of one side of a pose over the common face.
pub(super) struct AlongFace<'a> {
    assembly: &'a GearPair,
    posed: &'a PosedFlanks<'a>,
    /// Twist of the locked and the free gear in the frame of `posed`, rad/mm.
    twists: [f64; 2],
    /// The gap at the free gear's nominal rotation.
    nominal: f64,
    effort: &'a Effort,
}

/// The gap of a pair in a section, and its rate along the face, rad/mm.
#[derive(Debug, Clone, Copy)]
struct Look {
    b: f64,
    gap: f64,
    rate: f64,
}

impl<'a> AlongFace<'a> {
    /// The teeth of `posed` in the measuring plane of `assembly`, where `nominal` is the gap at the nominal rotation.
    pub fn new(
        assembly: &'a GearPair,
        posed: &'a PosedFlanks<'a>,
        nominal: f64,
        effort: &'a Effort,
    ) -> AlongFace<'a> {
        let members = [assembly.locked(), assembly.free()];
        AlongFace {
            assembly,
            posed,
            twists: members.map(|member| TwistedTeeth::twist(assembly, posed, member)),
            nominal,
            effort,
        }
    }

    /// The places, mm, at which a pair is tightest and its gap exceeds `floor`, the tightest first. Ties within `tie` are included.
    pub fn places(&self, floor: f64, tie: f64) -> Vec<f64> {
        let mut found: Vec<Look> = Vec::new();
        let mut best = floor;
        for step in self.steps() {
            self.effort.spend(LOOK);
            let endless = Separation::endless(self.posed, step, self.nominal);
            if !endless.touches {
                continue;
            }
            let window = self.on_line(&endless);
            for ends in self.stretches(step, &endless, best - tie) {
                if let Some(look) = self.greatest(step, ends, window) {
                    best = best.max(look.gap);
                    found.push(look);
                }
            }
        }
        found.retain(|look| look.gap >= best - tie && look.gap > floor);
        found.sort_by(|one, other| {
            let nearer = one.b.abs().total_cmp(&other.b.abs());
            other.gap.total_cmp(&one.gap).then(nearer)
        });
        let mut places: Vec<f64> = found.into_iter().map(|look| look.b).collect();
        places.dedup();
        places
    }

    /// The stretch of the face, mm, on which a pair with these endless involutes is on the line of action, up to the slight turns by leads.
    /// Without one, the place nearest to it.
    fn on_line(&self, endless: &Separation) -> [f64; 2] {
        let face = self.assembly.face();
        let shapes = [
            &self.posed.problem.locked.shape,
            &self.posed.problem.free.shape,
        ];
        let mut window = [f64::NEG_INFINITY, f64::INFINITY];
        for k in 0..2 {
            let (roll, twist) = (endless.rolls()[k], self.twists[k]);
            let ends = [lowest_roll(shapes[k]), shapes[k].tip_roll];
            // Spur gears have the same rolls in every section.
            if twist == 0.0 {
                continue;
            }
            let ends = ends.map(|end| (roll - end) / twist);
            window[0] = window[0].max(ends[0].min(ends[1]));
            window[1] = window[1].min(ends[0].max(ends[1]));
        }
        let [from, to] = window;
        let middle = (0.5 * (from + to)).clamp(face[0], face[1]);
        if from <= to {
            [from, to].map(|end| end.clamp(face[0], face[1]))
        } else {
            [middle; 2]
        }
    }

    /// Steps whose locked tooth can reach the mate in some section.
    fn steps(&self) -> RangeInclusive<i64> {
        let plane = self.posed.steps();
        if plane.is_empty() {
            return 0..=-1;
        }
        let turns = self.assembly.face().map(|b| self.twists[0] * b);
        let per_pitch = self.posed.problem.per_pitch;
        let (least, most) = (turns[0].min(turns[1]), turns[0].max(turns[1]));
        let first = plane.start - (most.max(0.0) * per_pitch).ceil() as i64;
        let last = plane.end - 1 - (least.min(0.0) * per_pitch).floor() as i64;
        first..=last
    }

    /// Locked and free gear, and the numbers of the teeth of a step.
    fn teeth(&self, step: i64) -> [(&'a AsBuilt, u32); 2] {
        let problem = self.posed.problem;
        let (locked, free) = self.posed.places(step);
        let gear = |member| self.assembly.gear(member);
        [
            (gear(self.assembly.locked()), problem.locked.number(locked)),
            (gear(self.assembly.free()), problem.free.number(free)),
        ]
    }

    /// Sum of both leads of a step at `b`, less that in the measuring plane, mm.
    fn leads(&self, step: i64, b: f64) -> f64 {
        self.lead_of_each(step, b).iter().sum()
    }

    fn lead_of_each(&self, step: i64, b: f64) -> [f64; 2] {
        let side = self.posed.problem.side;
        self.teeth(step)
            .map(|(gear, tooth)| gear.lead(side, tooth, b) - gear.lead(side, tooth, 0.0))
    }

    /// Stretches of the face between knots of both leads of a step in which its gap may exceed `floor`.
    fn stretches(&self, step: i64, endless: &Separation, floor: f64) -> Vec<[f64; 2]> {
        let problem = self.posed.problem;
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let base = shapes[1].base;
        // An edge at the form circle reaches farther than the endless involute.
        let is_bound = shapes.iter().all(|shape| shape.corners().len() == 1);
        // A gap of an eccentric free gear changes by up to this much more than on a fixed line.
        let off = problem.free_off.norm();
        let more = off / (base - off);
        let may_exceed = |ends: &[f64; 2]| {
            if !is_bound {
                return true;
            }
            let leads = [ends[0], 0.5 * (ends[0] + ends[1]), ends[1]].map(|b| self.leads(step, b));
            // A crown between the ends rises above their chord by a quarter of the rise of twice the middle.
            let [from, middle, to] = leads;
            let bend = (middle - 0.5 * (from + to)).max(0.0);
            let most = from.max(to).max(middle) + bend;
            endless.gap + (most + more * most.abs()) / base > floor
        };
        let [from, to] = self.assembly.face();
        let side = problem.side;
        let mut knots = vec![from, to];
        for (gear, tooth) in self.teeth(step) {
            knots.extend(
                gear.lead_knots(side, tooth)
                    .filter(|b| (from..=to).contains(b)),
            );
        }
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        let all = knots.windows(2).map(|ends| [ends[0], ends[1]]);
        let hollow = all.flat_map(|ends| self.parts(step, ends));
        let may: Vec<[f64; 2]> = hollow.filter(may_exceed).collect();
        may
    }

    /// The stretch, in several parts where the leads are hollow.
    fn parts(&self, step: i64, [from, to]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> + use<> {
        let middle = 0.5 * (from + to);
        let chord = 0.5 * (self.leads(step, from) + self.leads(step, to));
        let sag = chord - self.leads(step, middle);
        // Above rounding of the leads.
        let count = if sag > 1e-12 { HOLLOW_PARTS } else { 1 };
        let at = move |part: usize| from + (to - from) * (part as f64 / count as f64);
        (0..count).map(move |part| [at(part), at(part + 1)])
    }

    /// The gap of a step at `b`, mm; `None` where the teeth do not face each other.
    fn look(&self, step: i64, b: f64) -> Option<Look> {
        self.effort.spend(LOOK);
        let problem = self.posed.problem;
        let bases = [problem.locked.shape.base, problem.free.shape.base];
        let leads = self.lead_of_each(step, b);
        let turns = [0, 1].map(|k| self.twists[k] * b - leads[k] / bases[k]);
        let found = Separation::turned(self.posed, step, self.nominal, turns);
        let teeth = self.teeth(step);
        let rate = |k: usize| {
            let (gear, tooth) = teeth[k];
            let turned = self.twists[k] - gear.lead_rate(problem.side, tooth, b) / bases[k];
            found.by_turn[k] * turned
        };
        found.touches.then(|| Look {
            b,
            gap: found.gap,
            rate: rate(0) + rate(1),
        })
    }

    /// The greatest gap of a step over a stretch in which it is concave, found from the part of the stretch nearest to `window`. `None` where
    /// the teeth do not face each other.
    fn greatest(&self, step: i64, [from, to]: [f64; 2], window: [f64; 2]) -> Option<Look> {
        let beside = BESIDE * (to - from);
        let inside = |b: f64| b.clamp(from + beside, to - beside);
        let [start, end] = window.map(inside);
        let low = self.look(step, start)?;
        let high = self.look(step, end)?;
        if low.rate > 0.0 && high.rate < 0.0 {
            return Some(self.between(step, low, high));
        }
        let (mut last, border) = if high.rate >= 0.0 {
            (high, to)
        } else {
            (low, from)
        };
        let outwards = (border - last.b).signum();
        let mut way = FIRST_STEP * (border - last.b).abs();
        // The gap rises outwards up to the border, or to a maximum before it.
        loop {
            let left = (border - last.b).abs();
            if left <= 2.0 * beside {
                return self.look(step, border);
            }
            let b = last.b + outwards * way.min(left - beside);
            let Some(next) = self.look(step, b) else {
                // Too far out.
                way *= 0.5;
                if way < beside {
                    return Some(last);
                }
                continue;
            };
            if next.rate * outwards <= 0.0 {
                let (low, high) = if outwards > 0.0 {
                    (last, next)
                } else {
                    (next, last)
                };
                return Some(self.between(step, low, high));
            }
            last = next;
            way *= 2.0;
        }
    }

    /// The greatest gap of a step between two places, from which it rises inwards.
    fn between(&self, step: i64, mut low: Look, mut high: Look) -> Look {
        // Regula falsi, halving the rate of an end that stays (Illinois).
        let mut rates = [low.rate, high.rate];
        for _ in 0..MOST_STEPS {
            if (high.b - low.b) * low.rate.abs().min(high.rate.abs()) < SETTLED {
                break;
            }
            let share = rates[0] / (rates[0] - rates[1]);
            let b = low.b + (high.b - low.b) * share.clamp(0.01, 0.99);
            let Some(look) = self.look(step, b) else {
                break;
            };
            if look.rate > 0.0 {
                (low, rates) = (look, [look.rate, 0.5 * rates[1]]);
            } else {
                (high, rates) = (look, [0.5 * rates[0], look.rate]);
            }
        }
        if low.gap >= high.gap { low } else { high }
    }
}

//! Extremes of pairs with lead deviations: bounds over cells of the mesh cycle, for [`CycleSearch`].
//!
//! **Above.** A pair of teeth is never tighter than its endless involutes, whose tightness over a cell is concave up to a small constant
//! ([`Separation`]): their values at both ends, raised by it, bound it by a line. In the section at `b` the leads add `Σ δ(b)` along the
//! base tangent. Where a tip of roll `ξ_a` is passed by `ω`, the direction of the endless touch leaves
//!
//! ```text
//! r_b (ξ_a (1 − cos ω) + ω − sin ω)
//! ```
//!
//! of room. `ω` is linear in `b`, and least at an end of the cell. So a pair adds at most the greatest value over the face of `Σ δ(b)`
//! less the room of both tips. Between knots of the leads that is concave, or bounded by a chord where the leads are hollow; its tangents at
//! two places bound its maximum. A side is bounded by the line between the greatest values of all pairs at either end.
//!
//! **Below.** The pair that touches in the middle, in its section, bounds the side by the chord between its values at both ends, less the
//! same constant.
//!
//! Both hold while only involutes and their ends can touch, and corners on fillets, whose additional room [`Over`] bounds. Gears whose flanks
//! spread over all values of their leads show that.

use super::course::{Course, Posed, SideCourse, posed_sides};
use super::over::Over;
use crate::contact::cycle_search::{Cell, CycleCells};
use crate::contact::effort::Effort;
use crate::contact::exact::End;
use crate::contact::exact::ExactKernel;
use crate::contact::exact::separation::Separation;
use crate::contact::lost_motion::Contact;
use crate::gear::Side;
use crate::pair::{FacingTeeth, GearPair, Mating, Member, Pose};
use std::ops::Range;

/// Effort of a pair of teeth in a cell, nodes (tuned: 1 µs).
const STEP: u64 = 3;

/// Steps to the maximum of a stretch between knots: each at least halves the bracket, and its square is what remains.
const STEPS: usize = 14;

/// Excess of a bound over the bracket's tangents at which a maximum is close enough, mm.
const CLOSE: f64 = 1e-10;

/// The cells of a cycle.
pub(super) struct AlongFaceCells<'a> {
    kernel: &'a ExactKernel,
    assembly: &'a GearPair,
    first: Mating,
    sides: [SideCourse<'a>; 2],
}

impl<'a> AlongFaceCells<'a> {
    /// The cells of `course`; `None` without lead deviations, where axes lean, or where other curves can touch.
    pub fn new(course: &Course<'a>) -> Option<AlongFaceCells<'a>> {
        let assembly = course.assembly;
        if !assembly.has_leads() || assembly.leans() || assembly.is_modified() {
            return None;
        }
        let spread = |member: Member| assembly.gear(member).spread_by_leads(assembly.face());
        let (wheel, pinion) = (spread(Member::Wheel).ok()?, spread(Member::Pinion).ok()?);
        let distance = assembly.center_distance();
        let pair = assembly.with_gears(wheel, pinion, distance).ok()?;
        let kernel = ExactKernel::new(&pair);
        let effort = Effort::endless();
        let spread = Course::new(&kernel, &pair, (course.first, 1), &effort);
        if !kernel.stays_on_involutes_and_fillets(&spread) {
            return None;
        }
        let mut sides = course.sides.clone();
        for (side, spread) in sides.iter_mut().zip(spread.sides) {
            side.dips = spread.dips;
        }
        Some(AlongFaceCells {
            kernel: course.kernel,
            assembly,
            first: course.first,
            sides,
        })
    }
}

impl CycleCells for AlongFaceCells<'_> {
    fn mating(&self, pitches: f64) -> Mating {
        self.first.onward(self.assembly, pitches)
    }

    fn look(&self, pitches: f64, half: f64, ends: &[End], _width: f64) -> Cell {
        let assembly = self.assembly;
        let mut cell = Cell::unknown(pitches, half);
        let effort = Effort::of_pose();
        let pose = Pose::new(assembly, self.mating(pitches));
        let found = self.kernel.found_within(&pose, &effort);
        cell.effort = effort.used();
        let Ok(found) = found.map(|found| found.lost_motion) else {
            return cell;
        };
        cell.status = found.status();
        cell.angle = found.angle().zip(found.error());
        if half > 0.5 || cell.angle.is_none() {
            return cell;
        }
        let posed = posed_sides(&self.sides, self.kernel.plane(), &pose);
        let sides = [0, 1].map(|k| SideCell {
            assembly,
            over: Over {
                stretch: [-half, half],
                side: &self.sides[k],
                ends: [posed[k].on(-half), posed[k].on(half)],
                faces: Vec::new(),
                effort: &effort,
            },
        });
        if ends.contains(&End::Least)
            && let [Some(right), Some(left)] = sides.each_ref().map(SideCell::above)
        {
            let tightest = (right[0] + left[0]).max(right[1] + left[1]);
            cell.low = (-tightest, 0.0);
        }
        if ends.contains(&End::Greatest) {
            let below = |k: usize| sides[k].below(&found.on(Side::BOTH[k])?);
            if let [Some(right), Some(left)] = [below(0), below(1)] {
                let loosest = (right[0] + left[0]).min(right[1] + left[1]);
                cell.high = (-loosest, 0.0);
            }
        }
        cell.effort = effort.used();
        cell
    }
}

/// One side of a cell.
struct SideCell<'a> {
    assembly: &'a GearPair,
    /// The cell in the measuring plane.
    over: Over<'a>,
}

impl<'a> SideCell<'a> {
    /// Steps whose locked tooth can reach the mate in some section.
    fn steps(&self) -> Range<i64> {
        let over = |end: &Posed| end.flanks.steps_over(self.over.side.turns);
        let [one, other] = self.over.ends.each_ref().map(over);
        one.start.min(other.start)..one.end.max(other.end)
    }

    /// Bound on what a pair's tightness rises above the chord between its ends, or falls below it, rad.
    fn bend(&self, found: &[Separation; 2]) -> Option<f64> {
        Some(self.over.bend(found)? / 8.0 + self.over.rounding())
    }

    /// The side is no tighter than the line between these values at the ends, rad of the free gear beyond nominal.
    fn above(&self) -> Option<[f64; 2]> {
        let mut most = [f64::NEG_INFINITY; 2];
        for step in self.steps() {
            self.over.effort.spend(STEP);
            let found = self.over.endless_separations(step);
            if !found.iter().all(|one| one.touches) {
                return None;
            }
            let bend = self.bend(&found)?;
            let line = [0, 1].map(|k| bend - self.over.ends[k].room(found[k].gap));
            let leads = Leads::new(self, step, &found);
            // Without the room of tips.
            let [base, off] = [
                self.over.side.problem.free.shape.base,
                self.over.side.off[1],
            ];
            let turned = |mm: f64| mm / if mm > 0.0 { base - off } else { base + off };
            let simple = turned(leads.teeth.greatest_lead(leads.face));
            if (0..2).all(|k| line[k] + simple <= most[k]) {
                continue;
            }
            // A corner on a fillet has at least its clearance more room than the endless involutes.
            let enough = simple - turned(leads.greatest());
            let clearance = self.over.least_clearance(step, enough, leads.turned);
            let more = simple - enough.min(clearance);
            for k in 0..2 {
                most[k] = most[k].max(line[k] + more);
            }
        }
        Some(most)
    }

    /// The side is no looser than the line between these values at the ends, as the pair of `contact` holds it in its section.
    fn below(&self, contact: &Contact) -> Option<[f64; 2]> {
        let problem = self.over.side.problem;
        let flanks = &self.over.ends[0].flanks;
        let members = [self.assembly.locked(), self.assembly.free()];
        let teeth = members.map(|member| contact.touch(member).tooth);
        let step = self.steps().find(|step| {
            let (locked, free) = flanks.places(*step);
            [problem.locked.number(locked), problem.free.number(free)] == teeth
        })?;
        let b = contact.section;
        let leads = flanks.facing_teeth(self.assembly, step).leads(b);
        let bases = [problem.locked.shape.base, problem.free.shape.base];
        let twists = members.map(|member| flanks.twist(self.assembly, member));
        let turns = [0, 1].map(|k| twists[k] * b - leads[k] / bases[k]);
        let found = self
            .over
            .ends
            .each_ref()
            .map(|end| Separation::turned(&end.flanks, step, end.nominal_gap(), turns));
        if !found.iter().all(|one| one.touches) {
            return None;
        }
        let bend = self.bend(&found)?;
        Some([0, 1].map(|k| -self.over.ends[k].room(found[k].gap) - bend))
    }
}

/// The leads of a pair over the face, which add to its tightness, and its tips, which leave room; mm along the base tangent.
struct Leads<'a> {
    teeth: FacingTeeth<'a>,
    face: [f64; 2],
    /// Knots of both leads on the face, ascending, with its ends.
    knots: Vec<f64>,
    /// Turn of both teeth by their leads at most, rad.
    turned: f64,
    /// Base radius, tip roll, least excess of the roll over it in the measuring plane, and its change per mm, for each gear.
    tips: [[f64; 4]; 2],
}

impl<'a> Leads<'a> {
    fn new(cell: &SideCell<'a>, step: i64, found: &[Separation; 2]) -> Leads<'a> {
        let problem = cell.over.side.problem;
        let flanks = &cell.over.ends[0].flanks;
        let teeth = flanks.facing_teeth(cell.assembly, step);
        let face = cell.assembly.face();
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let members = [cell.assembly.locked(), cell.assembly.free()];
        let twists = members.map(|member| flanks.twist(cell.assembly, member));
        // Between the ends a roll leaves its chord by less than the eccentricities turn the line; leads turn the teeth.
        let turned = teeth.teeth.map(|(gear, tooth)| {
            let own = gear.lead_curve(problem.side, tooth);
            own.map_or(0.0, |curve| curve.range()) / gear.gear().base_radius()
        });
        let turned = turned[0] + turned[1];
        let plays = cell.over.plays();
        // The line turns by less than a fifth of the gears, as [`Over::plays`] allows.
        let off = if cell.over.side.off == [0.0; 2] {
            0.0
        } else {
            plays[0] - plays[0] / 1.2
        };
        let tips = [0, 1].map(|k| {
            let roll = found[0].rolls()[k].min(found[1].rolls()[k]);
            let play = off + turned;
            [
                shapes[k].base,
                shapes[k].tip_roll,
                roll - shapes[k].tip_roll - play,
                -twists[k],
            ]
        });
        Leads {
            knots: teeth.knots(face, |_, place| place),
            teeth,
            face,
            turned,
            tips,
        }
    }

    /// The room that both tips leave at `b`, and its rate.
    fn room(&self, b: f64) -> [f64; 2] {
        let mut room = [0.0; 2];
        for [base, tip, excess, rate] in self.tips {
            let beyond = (excess + rate * b).max(0.0);
            if beyond > 0.0 {
                let (sin, cos) = beyond.sin_cos();
                room[0] += base * (tip * (1.0 - cos) + beyond - sin);
                room[1] += base * (tip * sin + 1.0 - cos) * rate;
            }
        }
        room
    }

    /// Bound of `Σ δ(b)` less the room of the tips, over the face.
    fn greatest(&self) -> f64 {
        if self.face[0] == self.face[1] {
            return self.teeth.lead(self.face[0]) - self.room(self.face[0])[0];
        }
        let stretches = self.knots.windows(2);
        let bounds = stretches.map(|ends| self.greatest_between([ends[0], ends[1]]));
        bounds.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The bound between two knots.
    fn greatest_between(&self, [from, to]: [f64; 2]) -> f64 {
        // Rates just inside, where each lead is one cubic.
        let beside = 1e-9 * (to - from);
        let [low, high] = [from + beside, to - beside];
        let values = [self.teeth.lead(from), self.teeth.lead(to)];
        let rates = [self.teeth.rate(low), self.teeth.rate(high)];
        let is_hollow = rates[1] > rates[0];
        let chord = (values[1] - values[0]) / (to - from);
        let at = |b: f64| {
            let (lead, rate) = if is_hollow {
                (values[0] + chord * (b - from), chord)
            } else {
                (self.teeth.lead(b), self.teeth.rate(b.clamp(low, high)))
            };
            let [room, closing] = self.room(b);
            (lead - room, rate - closing)
        };
        let (mut a, mut b) = ((from, at(from)), (to, at(to)));
        if a.1.1 <= 0.0 {
            return a.1.0;
        }
        if b.1.1 >= 0.0 {
            return b.1.0;
        }
        // Where the tangents of both ends cross.
        let crossing = |a: (f64, (f64, f64)), b: (f64, (f64, f64))| {
            let (x, (value, rate)) = a;
            let (y, (other, falling)) = b;
            let cross = (other - value + rate * x - falling * y) / (rate - falling);
            value + rate * (cross.clamp(x, y) - x)
        };
        let mut bound = crossing(a, b);
        for _ in 0..STEPS {
            if bound - a.1.0.max(b.1.0) < CLOSE {
                break;
            }
            let middle = 0.5 * (a.0 + b.0);
            let found = (middle, at(middle));
            if found.1.1 > 0.0 {
                a = found;
            } else {
                b = found;
            }
            bound = crossing(a, b);
        }
        bound
    }
}

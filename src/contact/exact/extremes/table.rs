//! Quick bounds of every mating of a cycle: a few sums of tabulated values each.
//!
//! Where two involutes touch on the line of action, a side has the room `ρ + r δ_L + δ_F − ε`. `ρ` is that of perfect gears, `r δ_L + δ_F`
//! the offset of both flanks (`r = r_bL/r_bF`), and `ε` the effect of the eccentricities. The shift `b` of the centres along the line of
//! action gives `ε = (−b_x sin α + b_y cos α)/r_bF`, except for its second order. In gears of unequal base pitch a pair `s` steps on, and
//! `f` of a pitch later, has `κ (s + sense f)` more, with `κ = r τ_L − τ_F`. A pair beside the line of action has more room. The least
//! addition depends only on the part of the pitch, so it is computed once for each of [`PARTS`]. So are the pairs on the line of action
//! throughout a part: these bound the room from above.

use super::super::shape::C;
use super::mesh_cycle::{CycleSide, MeshCycle, PARTS};
use super::shift::CentreShift;
use super::side_table::SideTable;
use crate::contact::body::FarFlanks;
use std::ops::Range;

/// The tables of both sides.
#[derive(Debug)]
pub(super) struct CycleTable {
    sides: [SideTable; 2],
    /// `−ε` of both sides together.
    shifts: CentreShift,
    /// Greatest error of the sums, rad: room that they give too much, and too little. It contains the second order of `ε`, which adds room, its
    /// third order, and its curvature between the ends of a part.
    slack: [f64; 2],
    /// The distances of the outlines' centres, for each side; `None` if no corner comes near a fillet.
    distances: Option<Distances>,
    /// Number of matings to examine.
    matings: u64,
}

/// A step that can be the tightest in a part of a mating.
#[derive(Debug, Clone, Copy)]
pub(super) struct OpenStep {
    pub step: i64,
    /// Upper bound of the room of the side in excess of this step's place on the line of action.
    pub enough: f64,
    /// Whether a tip corner can touch a fillet with less room than that.
    pub has_tips_at_fillets: bool,
    /// Least excess of its involutes and their ends over that place, anywhere in the part and on the face.
    pub beside: f64,
}

/// Room of a side in a part of a mating, in excess of the room of one step on the line of action, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct BesideLine {
    pub step: i64,
    pub least: f64,
    /// ∞ if no step stays on the line.
    pub most: f64,
}

/// Distances of the outlines' centres.
#[derive(Debug)]
struct Distances {
    /// Excess over the distance of the axes, for each side.
    sides: [CentreShift; 2],
    /// Upper bound of the excess, in both directions.
    off: f64,
    /// Error bound of the excess: its gap, its second order, and its curvature over a part.
    slack: f64,
}

/// Bounds of the lost motion over a part of a mating, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct PartBounds {
    pub mating: u64,
    pub part: usize,
    pub low: f64,
    pub high: f64,
}

/// The lesser of two numbers: one instruction, because neither is NaN.
#[inline]
fn lesser(one: f64, other: f64) -> f64 {
    if other < one { other } else { one }
}

impl CycleTable {
    pub fn new(cycle: &MeshCycle) -> CycleTable {
        let posed = cycle.posed(0);
        let sides = [0, 1].map(|index| SideTable::new(&cycle.sides[index], &posed[index]));
        let side = &cycle.sides[0];
        let problem = side.problem;
        let per_base = problem.per_free_base;
        let off = side.off[0] + side.off[1];
        let nearest = problem.distance - off;
        let sum = problem.sum();
        let length = ((nearest - sum) * (nearest + sum)).sqrt();
        // For each side: the gap of `b`, the second order in `b`, the curvature over a part.
        let level = sides.iter().map(|side| side.level).fold(0.0, f64::max);
        let level = level + off * per_base / (1.0 - side.off[1] * per_base);
        let moved = side.off[1] * per_base * level / (1.0 - side.off[1] * per_base);
        let pitches = [problem.locked.pitch, problem.free.pitch];
        let bends = [0, 1].map(|k| side.off[k] * pitches[k] * pitches[k]);
        let part = 1.0 / PARTS as f64;
        let bent = (bends[0] + bends[1]) * part * part / 8.0;
        // The second and the third derivative of ε by the place of the centres: see `line_bends`.
        let second = 0.5 * off * off / (problem.distance.powi(2) - sum * sum).sqrt();
        let steep = 2.0 + (problem.distance + off) / length;
        let third = off.powi(3) * steep / (6.0 * length * length);
        let less = 2.0 * (moved + (third + bent) * per_base)
            + 4.0 * problem.rounding(problem.free.shape.base, 1.0);
        let slack = [less, less + 2.0 * second * per_base];
        let along = |index: usize, toward: C| {
            let (table, posed) = (&sides[index], &posed[index]);
            // The middle of the gaps on the line of action.
            let gap = posed.nominal_gap() - table.nominal - table.middle();
            CentreShift::new(&cycle.sides[index], posed, gap, toward)
        };
        let cos = sum / problem.distance;
        let toward = C::new((1.0 - cos * cos).sqrt(), -cos) * per_base;
        let deepest = sides.iter().filter_map(SideTable::deepest);
        let distances = deepest.reduce(f64::max).map(|deepest| Distances {
            sides: [0, 1].map(|index| along(index, C::from(1.0))),
            off,
            slack: side.off[1] * (level + deepest) + 0.5 * off * off / nearest + bent,
        });
        CycleTable {
            shifts: along(0, toward).plus(&along(1, toward)),
            distances,
            sides,
            slack,
            matings: if cycle.has_equal_matings() {
                cycle.matings.min(1)
            } else {
                cycle.matings
            },
        }
    }

    /// Bounds of every part of every mating of `range`, in their order.
    pub fn each(&self, range: Range<u64>, take: &mut dyn FnMut(PartBounds)) {
        let parts = |side: &SideTable| std::array::from_fn(|part| side.drifts(part));
        let drifts: [[[f64; 2]; PARTS]; 2] = self.sides.each_ref().map(parts);
        let nominal = self.sides[0].nominal + self.sides[1].nominal;
        let mut offsets = [Vec::new(), Vec::new()];
        let is_uniform = self.sides.each_ref().map(SideTable::is_uniform);
        let mut rooms = [[[0.0; 2]; PARTS]; 2];
        for mating in range.clone() {
            for (index, side) in self.sides.iter().enumerate() {
                // Every mating is as the first.
                if is_uniform[index] && mating > range.start {
                    continue;
                }
                let offsets = &mut offsets[index];
                side.all_offsets(side.places(mating), offsets);
                let distances = self.distances.as_ref();
                let distances = distances.map(|distances| distances.sides[index].at(mating));
                rooms[index] = std::array::from_fn(|part| {
                    let off = |step: i64, _| side.offset_among(offsets, step);
                    self.rooms(side, part, distances.as_ref(), off)
                });
            }
            let shift = self.shifts.at(mating);
            for part in 0..PARTS {
                // All but the steps' own places changes along a straight line, but for the slack.
                let ends = [0, 1].map(|end| {
                    nominal + shift[part + end] + (drifts[0][part][end] + drifts[1][part][end])
                });
                let [low, high] = [0, 1].map(|bound| rooms[0][part][bound] + rooms[1][part][bound]);
                take(PartBounds {
                    mating,
                    part,
                    low: low + lesser(ends[0], ends[1]) - self.slack[0],
                    high: high - lesser(-ends[0], -ends[1]) + self.slack[1],
                });
            }
        }
    }

    /// Least and greatest room of a side beyond `nominal` and the shift of the centres. `off` is the offset of a step, at its least (−1) or
    /// greatest (+1).
    #[inline]
    fn rooms(
        &self,
        side: &SideTable,
        part: usize,
        distances: Option<&[f64; PARTS + 1]>,
        off: impl Fn(i64, f64) -> f64,
    ) -> [f64; 2] {
        let plain = side.plain[part].iter();
        let plain = plain.map(|(step, more)| off(*step, -1.0) + more);
        let mut least = plain.fold(f64::INFINITY, lesser);
        if !side.at_fillets[part].is_empty() {
            let shares = match (&self.distances, distances) {
                (Some(all), Some(ends)) => all.shares([ends[part], ends[part + 1]]),
                _ => [0.0, 1.0],
            };
            let at_fillets = side.at_fillets[part].iter();
            least = at_fillets
                .map(|(step, more)| off(*step, -1.0) + more.between(shares))
                .fold(least, lesser);
        }
        let on_line_throughout = side.on_line_throughout[part].iter();
        let most = on_line_throughout.map(|step| off(*step, 1.0));
        [least, most.fold(f64::INFINITY, lesser)]
    }

    /// The room of a side in a part of a mating, against that of a step on the line of action; `None` if no step is open.
    ///
    /// It is the step with the least room among those that stay on the line. The difference of any other room from that is uncertain
    /// ([`SideTable::room_error`]).
    pub fn beside_line(&self, side: usize, mating: u64, part: usize) -> Option<BesideLine> {
        let table = &self.sides[side];
        let places = table.places(mating);
        let distances = self.distances.as_ref();
        let distances = distances.map(|distances| distances.sides[side].at(mating));
        let on_line_throughout = table.on_line_throughout[part].iter().copied();
        let by_off = |a: &i64, b: &i64| table.off(places, *a).total_cmp(&table.off(places, *b));
        let step = on_line_throughout
            .min_by(by_off)
            .or_else(|| table.open[part].first().map(|(step, ..)| *step))?;
        let own = table.off(places, step);
        // The offset of another step beyond its own is certain up to a part of it.
        let beyond = |step: i64, sign: f64| {
            let off = table.off(places, step) - own;
            off + sign * table.room_error * off.abs()
        };
        let [least, most] = self.rooms(table, part, distances.as_ref(), beyond);
        Some(BesideLine { step, least, most })
    }

    /// Whether the far flank of a locked tooth never stops the free gear first. `most` bounds the lost motion of near half teeth over the cycle,
    /// rad; ∞ if unknown.
    ///
    /// A pair on the line of action stops the gear first if far flanks leave more room than the flanks differ. At other poses the room
    /// of a side is at most `most`, less the room of the other side.
    pub fn stops_before_far_flanks(&self, cycle: &MeshCycle, most: f64) -> bool {
        if cycle.kernel.section.far_flanks == FarFlanks::Clear {
            return true;
        }
        let mut sides = self.sides.iter().zip(&cycle.sides);
        let later = |(table, side): (&SideTable, &CycleSide)| table.before_far_flanks(side);
        let Some(later) = sides.try_fold(f64::INFINITY, |least: f64, side| {
            Some(least.min(later(side)?))
        }) else {
            return false;
        };
        // The far half of one more step than the table has can reach the mate.
        let one_more = |table: &SideTable| table.per_step.abs();
        let is_first =
            |table: &SideTable| table.is_always_on_line() && later > table.spread + one_more(table);
        if self.sides.iter().all(is_first) {
            return true;
        }
        if !most.is_finite() {
            return false;
        }
        let shifts = (0..self.matings).flat_map(|mating| self.shifts.at(mating));
        let shift = shifts.fold(f64::INFINITY, f64::min) - self.slack[0];
        let on_line = self
            .sides
            .each_ref()
            .map(|side| side.nominal + side.lowest() - one_more(side));
        let tip = self.sides.each_ref().map(SideTable::deepest_tip);
        most < on_line[0] + on_line[1] + shift + tip[0].min(tip[1]) + later
    }

    /// Whether a tip corner on a fillet can be the tightest somewhere.
    pub fn has_tips_at_fillets(&self) -> bool {
        self.sides.iter().any(|side| side.may_be_below_form)
    }

    pub fn matings(&self) -> u64 {
        self.matings
    }

    /// Steps of a side that can be the tightest in a part of a mating: those whose room may be less than that of one on the line of action.
    pub fn steps(
        &self,
        side: usize,
        mating: u64,
        part: usize,
    ) -> impl Iterator<Item = OpenStep> + '_ {
        let table = &self.sides[side];
        let places = table.places(mating);
        let on_line_throughout = table.on_line_throughout[part].iter();
        let limit = on_line_throughout.map(|step| table.off(places, *step));
        let limit = limit.fold(f64::INFINITY, f64::min) + self.slack[1];
        let open = table.open[part].iter();
        open.filter_map(move |(step, beside, at_fillets)| {
            let more = beside.min(*at_fillets);
            let enough = limit - table.off(places, *step);
            (more <= enough).then_some(OpenStep {
                step: *step,
                enough,
                has_tips_at_fillets: !(*at_fillets >= enough),
                beside: *beside,
            })
        })
    }
}

impl Distances {
    /// The centre distance in a part, as two shares of its range, for the shifts at both ends of the part.
    fn shares(&self, ends: [f64; 2]) -> [f64; 2] {
        if self.off == 0.0 {
            return [0.0, 1.0];
        }
        let share = |shift: f64| (0.5 + 0.5 * shift / self.off).clamp(0.0, 1.0);
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        [share(low - self.slack), share(high + self.slack)]
    }
}

#[cfg(test)]
mod tests {
    use super::super::keeps_to_involutes;
    use super::super::mesh_cycle::posed_sides;
    use super::super::side_table::steps;
    use super::*;
    use crate::contact::Effort;
    use crate::contact::ExactKernel;
    use crate::contact::exact::far_flanks::{far_contact, is_sideways};
    use crate::contact::exact::search::SideRequest;
    use crate::contact::exact::separation::Separation;
    use crate::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, ProfilePart};
    use crate::pair::{GearPair, Mating, Pose};

    /// A number from 0 to 1 of the random pair `k`.
    fn part(k: u32, step: u32) -> f64 {
        f64::from((k * step + 7 * (k % 97) * k) % 101) / 101.0
    }

    /// The random pair `k`, with at most this profile shift, range of the pitch deviations, eccentricity, and room beyond the pair without
    /// backlash.
    fn random(k: u32, teeth: [u32; 2], most: [f64; 4]) -> Option<GearPair> {
        let built = |kind: usize, face, step: u32| {
            let design = GearDesign::plain(teeth[kind], 2.0).shifted(most[0] * part(k, step));
            let list = |start: u32| -> Vec<f64> {
                let off = |tooth: u32| f64::from((tooth * 37 + start) % 11) / 11.0 - 0.5;
                let size = most[1] * part(k, step + 50);
                (0..teeth[kind]).map(|tooth| size * off(tooth)).collect()
            };
            let deviations = Deviations::off_axis(most[2] * part(k, step + 20), 1.5)
                .with_pitch(&list(step), &list(step + 5));
            AsBuilt::new(Gear::nominal(design).ok()?, face, &deviations).ok()
        };
        let (wheel, pinion) = (built(0, Face::Front, 17)?, built(1, Face::Back, 29)?);
        let formula = crate::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
        let closed = formula.center_distance(0.0)?;
        GearPair::new(wheel, pinion, closed + most[3] * part(k, 41)).ok()
    }

    /// 400/400 teeth with base pitches 0.001 % apart and profile shifts −6 and 6. They touch far from the pitch point, and their steps
    /// reach further to one side of it. κ (s + sense f) of any touching step is at most the level.
    #[test]
    fn the_level_holds_steps_to_one_side() {
        let gear = |module: f64, shift: f64, face| {
            let design = GearDesign::plain(400, module).shifted(shift);
            AsBuilt::perfect(design.gear(), face)
        };
        let wheel = gear(1.0, -6.0, Face::Front);
        let pair = GearPair::new(wheel, gear(1.00001, 6.0, Face::Back), 400.05).unwrap();
        let kernel = ExactKernel::new(&pair);
        let effort = Effort::endless();
        let cycle = MeshCycle::new(&kernel, &pair, (Mating::FIRST, 1), &effort);
        let table = CycleTable::new(&cycle);
        let posed = cycle.posed(0);
        let mut lopsided = 0;
        for (index, side) in table.sides.iter().enumerate() {
            assert!(side.per_step != 0.0);
            let steps = steps(&cycle.sides[index], posed[index].flanks.ahead);
            lopsided += u32::from(steps.start + steps.end - 1 != 0);
            for step in steps {
                for drift in side.drifts(0).into_iter().chain(side.drifts(PARTS - 1)) {
                    let more = side.per_step * step as f64 + drift;
                    assert!(more.abs() <= side.level, "{step}: {more}");
                }
            }
        }
        assert!(lopsided > 0);
    }

    /// No tip reaches a fillet where none is reported. Pinions of few teeth matter most: their involutes end at edges, whose room does not
    /// bound that of a fillet below. Source: the kernel's own contacts at 300 poses.
    #[test]
    fn no_tip_touches_a_fillet_where_none_is_said_to() {
        let (mut kept, mut touched) = (0, 0);
        for k in 0..2000u32 {
            let teeth = [20 + 3 * (k % 31), 6 + k % 9];
            let Some(pair) = random(k, teeth, [0.4, 0.08, 0.02, 0.6]) else {
                continue;
            };
            let kernel = ExactKernel::new(&pair);
            let keeps = keeps_to_involutes(&kernel, &pair);
            let on_fillet = (0..300).any(|at| {
                let mating = Mating::FIRST.onward(&pair, f64::from(at) * 0.237);
                let found = kernel.lost_motion_at(&pair, mating).unwrap().unwrap();
                let contacts = [found.right, found.left].into_iter().flatten();
                contacts
                    .flat_map(|contact| [contact.wheel.curve, contact.pinion.curve])
                    .any(|curve| curve == ProfilePart::Fillet)
            });
            assert!(!(keeps && on_fillet), "pair {k}");
            kept += u32::from(keeps);
            touched += u32::from(on_fillet);
        }
        assert!(kept > 20 && touched > 10, "{kept} {touched}");
    }

    /// No far flank touches before the bound of [`SideTable::before_far_flanks`]. Source: the search for contacts with far flanks, at ten
    /// poses of pairs of few teeth.
    #[test]
    fn far_flanks_are_as_late_as_their_bound() {
        let (mut examined, mut near) = (0, 0);
        for k in 0..3000u32 {
            let teeth = [3 + k % 17, 3 + k / 17 % 40];
            let Some(pair) = random(k, teeth, [0.8, 0.4, 0.2, 1.0]) else {
                continue;
            };
            let kernel = ExactKernel::new(&pair);
            let far_flanks = kernel.section.far_flanks;
            if kernel.section.solver.is_none() || far_flanks == FarFlanks::Clear {
                continue;
            }
            let effort = Effort::endless();
            let cycle = MeshCycle::new(&kernel, &pair, (Mating::FIRST, 1), &effort);
            let start = cycle.posed(0);
            let later = [0, 1].map(|side| {
                let table = SideTable::new(&cycle.sides[side], &start[side]);
                table.before_far_flanks(&cycle.sides[side])
            });
            for at in 0..10 {
                let mating = Mating::FIRST.onward(&pair, 0.237 * f64::from(at));
                let pose = Pose::new(&pair, mating);
                let posed = posed_sides(&cycle.sides, &kernel.section, &pose);
                for (side, later) in posed.iter().zip(later) {
                    let flanks = &side.flanks;
                    for step in flanks.steps_of_whole_teeth() {
                        if !is_sideways(flanks, step) {
                            continue;
                        }
                        let line = Separation::endless(flanks, step, side.nominal_gap());
                        let is_before = |floor: f64| {
                            let request = SideRequest {
                                effort: &effort,
                                floor,
                            };
                            let found = |normal| {
                                let found = far_contact(flanks, step, (floor, normal), request);
                                found.unwrap().map(|found| found.gap)
                            };
                            // No line is known to divide the two along x.
                            let gap = found(C::ONE);
                            let normals = (1..8).map(|k| C::cis(0.4 * f64::from(k)));
                            assert!(normals.map(found).all(|other| other == gap), "{teeth:?}");
                            gap.is_some()
                        };
                        let floor = line.gap - later.unwrap();
                        assert!(!is_before(floor + 1e-9), "{teeth:?}, pair {k}, step {step}");
                        examined += 1;
                        near += u32::from(is_before(floor - 0.05));
                    }
                }
            }
        }
        assert!(examined > 1000 && near > 3, "{examined} {near}");
    }
}

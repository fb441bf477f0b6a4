//! A mesh cycle of a pair: its matings, and the half teeth of both sides at the start of each.

use super::super::ExactKernel;
use super::super::flank_problem::{FlankProblem, PosedFlanks};
use super::super::placed::Role;
use super::super::section::Section;
use super::super::shape::HalfToothShape;
use super::super::teeth::reduced;
use super::line_bends::LineBends;
use super::tip_at_fillet::TipAtFillet;
use crate::contact::Effort;
use crate::pair::{GearPair, Mating, Pose};

/// Parts of a pitch (tuned: ordinary pairs, contact ratio 1.2 and more, have a pair on the line of action throughout each).
pub(super) const PARTS: usize = 8;

/// The matings of a cycle, from `first` on, each covering one pitch.
pub(super) struct MeshCycle<'a> {
    pub kernel: &'a ExactKernel,
    pub assembly: &'a GearPair,
    pub first: Mating,
    pub matings: u64,
    pub sides: [CycleSide<'a>; 2],
    /// The budget for its extremes.
    pub effort: &'a Effort<'a>,
}

/// One side of the cycle, in the frame of [`super::super::flank_problem`].
#[derive(Debug, Clone)]
pub(super) struct CycleSide<'a> {
    pub problem: &'a FlankProblem,
    mirror: f64,
    /// Sense in which the locked gear turns.
    pub sense: f64,
    /// Eccentricities of the locked and the free gear, where leaning axes shift the locked one of a section further.
    pub off: [f64; 2],
    pub on_line: Option<LineBends>,
    pub tips_at_fillets: Vec<TipAtFillet>,
    /// Angle of the locked teeth in a section of the common face relative to the measuring plane, rad: least and greatest.
    pub turns: [f64; 2],
}

impl CycleSide<'_> {
    /// The half tooth whose fillet a tip approaches.
    pub fn mate(&self, owner: Role) -> &HalfToothShape {
        match owner {
            Role::Locked => &self.problem.free.shape,
            Role::Free => &self.problem.locked.shape,
        }
    }

    /// Least and greatest distance of the outlines' centres, mm.
    pub fn distances(&self) -> (f64, f64) {
        let off = self.off[0] + self.off[1];
        (self.problem.distance - off, self.problem.distance + off)
    }

    /// A range of centre distances, cut to those that the cycle has: [`TipAtFillet::deepest`] holds for no other.
    pub fn possible(&self, (low, high): (f64, f64)) -> (f64, f64) {
        let (least, most) = self.distances();
        (low.max(least), high.min(most))
    }

    /// Greatest relative error of a difference of two rooms that is taken with the centres at rest.
    ///
    /// Both rooms have their own rotation of the free gear, whose eccentricity `e` displaces its centre between them. That changes the room of
    /// involutes at a rate of up to `e/r_bF`, so the difference changes by a factor between `1/(1 + e/r_bF)` and `1/(1 − e/r_bF)`.
    pub fn room_error(&self) -> f64 {
        let part = self.off[1] * self.problem.per_free_base;
        part / (1.0 - part)
    }

    /// Lower bound of a clearance, from the clearance with the centres at rest.
    pub fn certain_clearance(&self, clearance: f64) -> f64 {
        if clearance > 0.0 {
            clearance * (1.0 - self.room_error())
        } else {
            clearance * (1.0 + self.room_error())
        }
    }

    /// A clearance whose lower bound [`CycleSide::certain_clearance`] is at least `enough`.
    pub fn clearance_for(&self, enough: f64) -> f64 {
        if enough > 0.0 {
            enough * (1.0 + 2.0 * self.room_error())
        } else {
            enough
        }
    }
}

impl<'a> MeshCycle<'a> {
    pub fn new(
        kernel: &'a ExactKernel,
        assembly: &'a GearPair,
        (first, matings): (Mating, u64),
        effort: &'a Effort<'a>,
    ) -> MeshCycle<'a> {
        let gears = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        let mut off = gears.map(|gear| gear.eccentricity());
        off[0] += assembly.shift_bound();
        let onward = -gears[0].face().ascending();
        let turns = assembly
            .face()
            .map(|end| assembly.twist(assembly.locked(), end));
        let side = |problem: &'a FlankProblem| {
            let mirror = -problem.side.sense();
            let shapes = [&*problem.locked.shape, &*problem.free.shape];
            let least = problem.distance - off[0] - off[1];
            let proof = kernel.section.solver.as_ref().map(|solver| solver.proof);
            let reached = proof.map(|proof| {
                [
                    (Role::Locked, proof.free_fillet),
                    (Role::Free, proof.locked_fillet),
                ]
            });
            let tips_at_fillets = reached.into_iter().flatten();
            CycleSide {
                problem,
                mirror,
                sense: mirror * onward,
                off,
                on_line: LineBends::new(problem, off),
                tips_at_fillets: tips_at_fillets
                    .filter_map(|(owner, deepest)| TipAtFillet::new(owner, shapes, deepest?, least))
                    .collect(),
                turns: {
                    let [one, other] = turns.map(|turn| mirror * turn);
                    [one.min(other), one.max(other)]
                },
            }
        };
        MeshCycle {
            kernel,
            assembly,
            first: Mating {
                fraction: 0.0,
                ..first
            },
            matings,
            effort,
            sides: [side(&kernel.section.right), side(&kernel.section.left)],
        }
    }

    /// Whether all matings are equal: all teeth are equal, and there is no runout.
    pub fn has_equal_matings(&self) -> bool {
        self.has_equal_teeth(0) && self.has_equal_teeth(1)
    }

    /// Matings after which all half teeth meet as before.
    pub fn distinct_matings(&self) -> u64 {
        let teeth = |member| u64::from(self.assembly.teeth(member));
        match [0, 1].map(|k| self.has_equal_teeth(k)) {
            [true, true] => 1,
            [true, false] => self.matings.min(teeth(self.assembly.free())),
            [false, true] => self.matings.min(teeth(self.assembly.locked())),
            [false, false] => self.matings,
        }
    }

    /// Whether all teeth of the locked (0) or the free gear (1) are equal, and it has no runout.
    fn has_equal_teeth(&self, k: usize) -> bool {
        let gear = self
            .assembly
            .gear([self.assembly.locked(), self.assembly.free()][k]);
        let is_round = gear.eccentricity() == 0.0 && gear.wobble() == 0.0;
        let is_equal = |side: &CycleSide| {
            let teeth = [&side.problem.locked, &side.problem.free][k];
            let (least, most) = teeth.offset_range;
            least == most && gear.shapes(side.problem.side) == 1
        };
        is_round && gear.has_one_lead() && self.sides.iter().all(is_equal)
    }

    /// The mating `fraction` of a pitch past mating number `index`; a whole pitch is the next mating.
    pub fn mating(&self, index: u64, fraction: f64) -> Mating {
        let (index, fraction) = if fraction >= 1.0 {
            (index + 1, fraction - 1.0)
        } else {
            (index, fraction)
        };
        let onward = self.first.onward(self.assembly, index as f64);
        Mating { fraction, ..onward }
    }

    /// The first of all matings equal to mating number `index`, by least wheel tooth, then least pinion tooth. If all teeth of one gear are
    /// equal, each tooth of the other has several.
    pub fn first_equal(&self, index: u64) -> u64 {
        let counts = [self.assembly.locked(), self.assembly.free()]
            .map(|member| u64::from(self.assembly.teeth(member)));
        let others = match [0, 1].map(|k| self.has_equal_teeth(k)) {
            [true, false] if self.matings == counts[1] => counts[0],
            [false, true] if self.matings == counts[0] => counts[1],
            _ => 1,
        };
        let numbers = (0..others).map(|k| index + k * self.matings);
        let first = numbers.min_by_key(|index| self.teeth(*index));
        first.unwrap_or(index)
    }

    /// Wheel and pinion tooth of mating number `index`.
    pub fn teeth(&self, index: u64) -> (u32, u32) {
        let mating = self.mating(index, 0.0);
        (mating.wheel_tooth, mating.pinion_tooth)
    }

    /// Both sides at the start of mating number `index`.
    pub fn posed(&self, index: u64) -> [PosedSide<'a>; 2] {
        let pose = Pose::new(self.assembly, self.mating(index, 0.0));
        self.at(&self.kernel.section, &pose)
    }

    /// Both sides at the start of mating number `index`, in the sections at both ends of the common face; empty for spur gears.
    pub fn posed_at_ends(&self, index: u64) -> Vec<[FaceEnd<'a>; 2]> {
        let Some(helical) = &self.kernel.helical else {
            return Vec::new();
        };
        let pose = Pose::new(self.assembly, self.mating(index, 0.0));
        let plane = self.at(&self.kernel.section, &pose);
        let ends = helical.ends().map(|(b, section)| {
            let posed = self.at(section, &pose.in_section(self.assembly, b));
            let twist = self.assembly.twist(self.assembly.locked(), b);
            [0, 1].map(|k| {
                let turn = self.sides[k].mirror * twist;
                let on = turn + plane[k].flanks.ahead - posed[k].flanks.ahead;
                let steps = on * posed[k].flanks.problem.per_pitch;
                FaceEnd {
                    posed: posed[k],
                    turn,
                    steps: steps.round() as i64,
                }
            })
        });
        ends.into()
    }

    fn at(&self, section: &'a Section, pose: &Pose) -> [PosedSide<'a>; 2] {
        posed_sides(&self.sides, section, pose)
    }

    /// Operating pitch radius of the free gear, mm: the arc of one radian.
    pub fn per_radian(&self) -> f64 {
        self.assembly.operating_pitch_radius(self.assembly.free())
    }
}

/// Both sides of a section at a pose of it.
pub(super) fn posed_sides<'a>(
    cycle_sides: &[CycleSide; 2],
    section: &'a Section,
    pose: &Pose,
) -> [PosedSide<'a>; 2] {
    let sides = [&section.right, &section.left];
    [0, 1].map(|k| {
        let side = &cycle_sides[k];
        let flanks = section.posed(sides[k], pose);
        let nominal = side.mirror * pose.free_rotation();
        PosedSide {
            flanks,
            level: reduced(flanks.rotation(0.0) - reduced(nominal)),
            sense: side.sense,
        }
    })
}

/// One side at the start of a mating, in the section at an end of the face.
#[derive(Debug, Clone, Copy)]
pub(super) struct FaceEnd<'a> {
    pub posed: PosedSide<'a>,
    /// Angle of the locked teeth there relative to the measuring plane, rad.
    pub turn: f64,
    /// Additional steps of a pair of teeth there.
    pub steps: i64,
}

/// One side at the start of a mating.
#[derive(Debug, Clone, Copy)]
pub(super) struct PosedSide<'a> {
    pub flanks: PosedFlanks<'a>,
    /// Difference of the nominal rotation from a gap of 0.
    level: f64,
    sense: f64,
}

impl<'a> PosedSide<'a> {
    /// This side `fraction` of a pitch later.
    pub fn after(&self, fraction: f64) -> PosedSide<'a> {
        let problem = self.flanks.problem;
        PosedSide {
            flanks: self
                .flanks
                .turned_on(self.sense * fraction * problem.locked.pitch),
            level: self.level + self.sense * fraction * problem.free.pitch,
            sense: self.sense,
        }
    }

    /// The free gear's way from its nominal rotation to a gap, rad.
    pub fn room(&self, gap: f64) -> f64 {
        -(gap + self.level)
    }

    /// The gap for a room.
    pub fn gap(&self, room: f64) -> f64 {
        -(room + self.level)
    }

    /// Turn of the locked gear to another pose of the same mating, in this frame.
    pub fn angle_to(&self, other: &PosedSide) -> f64 {
        other.flanks.ahead - self.flanks.ahead
    }

    /// Rate of the room per pitch, if the gap changes at `slope` with the locked gear's rotation.
    pub fn rate(&self, slope: f64) -> f64 {
        let problem = self.flanks.problem;
        -self.sense * (slope * problem.locked.pitch + problem.free.pitch)
    }

    /// The gap for a room of 0.
    pub fn nominal_gap(&self) -> f64 {
        -self.level
    }
}

//! A mesh cycle as the exact method sees it: both sides of every mating, and what stands between them.

use super::super::ExactKernel;
use super::super::flank_problem::{FlankProblem, PosedFlanks};
use super::super::section::Section;
use super::super::shape::HalfToothShape;
use super::super::teeth::reduced;
use super::dip::{Dip, Tip};
use super::line_bends::LineBends;
use crate::contact::Effort;
use crate::gear::Side;
use crate::pair::{GearPair, Mating, Pose};

/// Parts of a pitch (tuned: ordinary pairs, contact ratio 1.2 and more, have a pair on the line of action all through each).
pub(super) const PARTS: usize = 8;

/// The matings of a cycle, from where `first` begins on, each pitch gone through once.
#[derive(Debug)]
pub(super) struct Course<'a> {
    pub kernel: &'a ExactKernel,
    pub assembly: &'a GearPair,
    pub first: Mating,
    pub matings: u64,
    pub sides: [SideCourse<'a>; 2],
    /// What may be done for its extremes.
    pub effort: &'a Effort,
}

/// One side of it, in the frame of [`super::super::flank_problem`].
#[derive(Debug)]
pub(super) struct SideCourse<'a> {
    pub problem: &'a FlankProblem,
    mirror: f64,
    /// Sense in which the locked gear turns.
    pub sense: f64,
    /// Eccentricities of the locked and the free gear.
    pub off: [f64; 2],
    pub on_line: Option<LineBends>,
    pub dips: Vec<Dip>,
    /// How much farther on the locked teeth stand in one section of the common face than in the measuring plane, rad: least and greatest.
    pub turns: [f64; 2],
}

impl SideCourse<'_> {
    /// The half tooth into whose fillet a tip dips.
    pub fn mate(&self, tip: Tip) -> &HalfToothShape {
        match tip {
            Tip::Locked => &self.problem.free.shape,
            Tip::Free => &self.problem.locked.shape,
        }
    }
}

impl<'a> Course<'a> {
    pub fn new(
        kernel: &'a ExactKernel,
        assembly: &'a GearPair,
        (first, matings): (Mating, u64),
        effort: &'a Effort,
    ) -> Course<'a> {
        let gears = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        let off = gears.map(|gear| gear.eccentricity());
        let onward = -gears[0].face().ascending();
        let turns = assembly
            .face()
            .map(|end| assembly.twist(assembly.locked(), end));
        let side = |problem: &'a FlankProblem| {
            let mirror = match problem.side {
                Side::Right => 1.0,
                Side::Left => -1.0,
            };
            let shapes = [&problem.locked.shape, &problem.free.shape];
            let least = problem.distance - off[0] - off[1];
            let proof = kernel.section.solver.as_ref().map(|solver| solver.proof);
            let reached = proof.map(|proof| {
                [
                    (Tip::Locked, proof.free_fillet),
                    (Tip::Free, proof.locked_fillet),
                ]
            });
            let dips = reached.into_iter().flatten();
            SideCourse {
                problem,
                mirror,
                sense: mirror * onward,
                off,
                on_line: LineBends::new(problem, off),
                dips: dips
                    .filter_map(|(tip, deepest)| Dip::new(tip, shapes, deepest?, least))
                    .collect(),
                turns: {
                    let [one, other] = turns.map(|turn| mirror * turn);
                    [one.min(other), one.max(other)]
                },
            }
        };
        Course {
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

    /// Whether one mating is as any other: all teeth are alike, and run true.
    pub fn repeats(&self) -> bool {
        self.sides.iter().all(|side| {
            let teeth = [&side.problem.locked, &side.problem.free];
            let alike = teeth
                .iter()
                .all(|teeth| teeth.extremes.0 == teeth.extremes.1);
            alike && side.off == [0.0; 2]
        })
    }

    /// The mating `fraction` of a pitch beyond mating number `index`; a whole pitch is the next mating.
    pub fn mating(&self, index: u64, fraction: f64) -> Mating {
        let (index, fraction) = if fraction >= 1.0 {
            (index + 1, fraction - 1.0)
        } else {
            (index, fraction)
        };
        let onward = self.first.onward(self.assembly, index as f64);
        Mating { fraction, ..onward }
    }

    /// Of all numbers of the mating that is as mating number `index`, the one with the least wheel tooth, then the least pinion tooth. Where the teeth
    /// of one gear are all alike, each tooth of the other meets several.
    pub fn first_alike(&self, index: u64) -> u64 {
        let alike = |k: usize| {
            self.sides.iter().all(|side| {
                let teeth = [&side.problem.locked, &side.problem.free][k];
                teeth.extremes.0 == teeth.extremes.1 && side.off[k] == 0.0
            })
        };
        let counts = [self.assembly.locked(), self.assembly.free()]
            .map(|member| u64::from(self.assembly.teeth(member)));
        let others = match [alike(0), alike(1)] {
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

    /// Both sides where mating number `index` begins.
    pub fn posed(&self, index: u64) -> [Posed<'a>; 2] {
        let pose = Pose::new(self.assembly, self.mating(index, 0.0));
        self.at(&self.kernel.section, &pose)
    }

    /// The same in the sections at both ends of the common face of helical gears; nothing of spur gears.
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

    /// Both sides of a section at a pose of it.
    fn at(&self, section: &'a Section, pose: &Pose) -> [Posed<'a>; 2] {
        let sides = [&section.right, &section.left];
        [0, 1].map(|k| {
            let side = &self.sides[k];
            let flanks = section.posed(sides[k], pose);
            let nominal = side.mirror * pose.free_rotation();
            Posed {
                flanks,
                level: reduced(flanks.rotation(0.0) - reduced(nominal)),
                sense: side.sense,
            }
        })
    }

    /// Arc on the free gear's operating pitch circle of one radian, mm.
    pub fn per_radian(&self) -> f64 {
        self.assembly.operating_pitch_radius(self.assembly.free())
    }
}

/// One side where a mating begins, in the section at an end of the face.
#[derive(Debug, Clone, Copy)]
pub(super) struct FaceEnd<'a> {
    pub posed: Posed<'a>,
    /// How much farther on the locked teeth stand there than in the measuring plane, rad.
    pub turn: f64,
    /// How many steps a pair of teeth has more there.
    pub steps: i64,
}

/// One side where a mating begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct Posed<'a> {
    pub flanks: PosedFlanks<'a>,
    /// What a gap of 0 is short of the nominal rotation.
    level: f64,
    sense: f64,
}

impl<'a> Posed<'a> {
    /// The same side `fraction` of a pitch on.
    pub fn on(&self, fraction: f64) -> Posed<'a> {
        let problem = self.flanks.problem;
        Posed {
            flanks: self
                .flanks
                .turned_on(self.sense * fraction * problem.locked.pitch),
            level: self.level + self.sense * fraction * problem.free.pitch,
            sense: self.sense,
        }
    }

    /// The way the free gear has from its nominal rotation to a gap, rad.
    pub fn room(&self, gap: f64) -> f64 {
        -(gap + self.level)
    }

    /// The gap at which it has a room.
    pub fn gap(&self, room: f64) -> f64 {
        -(room + self.level)
    }

    /// What the locked gear turns by to another pose of the same mating, in this frame.
    pub fn angle_to(&self, other: &Posed) -> f64 {
        other.flanks.ahead - self.flanks.ahead
    }

    /// How fast that grows with the pitches, where the gap changes at `slope` with the locked gear's rotation.
    pub fn rate(&self, slope: f64) -> f64 {
        let problem = self.flanks.problem;
        -self.sense * (slope * problem.locked.pitch + problem.free.pitch)
    }

    /// The gap at a room of 0.
    pub fn nominal_gap(&self) -> f64 {
        -self.level
    }
}

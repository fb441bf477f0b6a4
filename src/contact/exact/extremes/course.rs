//! A mesh cycle as the exact method sees it: both sides of every mating, and what stands between them.

use super::super::ExactKernel;
use super::super::flank_problem::{FlankProblem, PosedFlanks};
use super::super::shape::turn;
use super::super::teeth::reduced;
use super::dip::{Dip, Tip};
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
    pub dips: Vec<Dip>,
}

impl<'a> Course<'a> {
    pub fn new(
        kernel: &'a ExactKernel,
        assembly: &'a GearPair,
        first: Mating,
        matings: u64,
    ) -> Course<'a> {
        let gears = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        let off = gears.map(|gear| gear.eccentricity());
        let onward = -gears[0].face().ascending();
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
                dips: dips
                    .filter_map(|(tip, deepest)| Dip::new(tip, shapes, deepest?, least))
                    .collect(),
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
            sides: [side(&kernel.section.right), side(&kernel.section.left)],
        }
    }

    /// The mating `fraction` of a pitch beyond mating number `index`.
    pub fn mating(&self, index: u64, fraction: f64) -> Mating {
        let onward = self.first.onward(self.assembly, index as f64);
        Mating { fraction, ..onward }
    }

    /// Both sides where mating number `index` begins.
    pub fn posed(&self, index: u64) -> [Posed<'a>; 2] {
        let mating = self.mating(index, 0.0);
        let pose = Pose::new(self.assembly, mating);
        let (locked, free) = (self.assembly.locked(), self.assembly.free());
        let teeth = (mating.tooth(locked), mating.tooth(free));
        let rotation = reduced(pose.locked_rotation());
        let turned = turn(rotation);
        self.sides.each_ref().map(|side| {
            let flanks = side.problem.posed(&pose, teeth, rotation, turned);
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

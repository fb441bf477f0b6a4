//! One side of a section, with only those teeth that can reach the mate at a pose.
//!
//! A section of teeth that deviate along the face differs from the measuring plane by slight turns of its flanks and by the centres of its
//! outlines. A few teeth of either gear are in reach of the mate. Only these are turned.

use super::direct::{DirectSolver, far_corner_may_reach};
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::section::Section;
use super::shape::{C, turn};
use super::teeth::{Teeth, reduced};
use crate::gear::{AsBuilt, Side};
use crate::pair::{GearPair, Leaning, LeaningSide, Member, Pose};
use std::sync::Arc;

/// Steps examined beyond those in reach in the measuring plane. The turns of a section are below a tenth of a pitch.
const MORE_STEPS: i64 = 1;

/// One side of a section at a pose.
pub(super) struct SectionSide<'a> {
    /// The teeth of the measuring plane at the pose in the section.
    plane: PosedFlanks<'a>,
    problem: FlankProblem,
}

/// A section, and its pose.
#[derive(Clone, Copy)]
pub(super) struct SectionPlace<'a> {
    pub assembly: &'a GearPair,
    /// The pose of the measuring plane, and what it is in the section.
    pub whole: &'a Pose,
    pub here: &'a Pose,
    /// The section, mm from the measuring plane.
    pub b: f64,
    /// Places of the locked teeth that can be tightest. Leaning axes turn no others. `None`: perhaps all.
    pub near: Option<&'a [usize]>,
}

impl<'a> SectionSide<'a> {
    /// The side of `problem`, which is that of the measuring plane `section`, at a place. Leaning axes turn the far flanks of teeth where their
    /// corners may touch: `corners` has the solver of a contact, and the greatest move of corners from the measuring plane, mm. Without it they
    /// are always turned. `None` if teeth are in reach of more than one mate.
    pub fn new(
        section: &Section,
        problem: &'a FlankProblem,
        place: SectionPlace,
        corners: Option<(&DirectSolver, f64)>,
    ) -> Option<SectionSide<'a>> {
        let plane = section.posed(problem, place.here);
        let reach = plane.steps_of_whole_teeth();
        let (low, high) = (
            (reach.start - MORE_STEPS).min(0),
            (reach.end + MORE_STEPS).max(1),
        );
        let count = high - low;
        if count >= problem.locked.count().min(problem.free.count()) {
            return None;
        }
        let with_far = corners.is_none_or(|(solver, moved)| {
            let may_reach = |step| far_corner_may_reach(&plane, solver, step, moved);
            solver.proof.tangents || reach.clone().any(may_reach)
        });
        let flanks = FlanksInSection::new(&plane, place, with_far);
        // The far flank of the tooth before the first one ends a root land.
        let turns = (low - 1..=high).map(|step| flanks.turns(step));
        let (mut locked, mut free): (Vec<_>, Vec<_>) =
            turns.map(|[locked, free]| (locked, free)).unzip();
        locked.pop();
        free.reverse();
        free.pop();
        let (first_locked, _) = plane.places(low);
        let (_, first_free) = plane.places(high - 1);
        let teeth =
            |teeth: &Teeth, first, turns: &[[f64; 2]]| Arc::new(teeth.in_section(first, turns));
        let teeth = (
            teeth(&problem.locked, first_locked, &locked),
            teeth(&problem.free, first_free, &free),
        );
        let problem = problem.in_section(flanks.distance, flanks.offs, teeth);
        Some(SectionSide { plane, problem })
    }

    /// The flanks alone.
    pub fn into_problem(self) -> FlankProblem {
        self.problem
    }

    /// Its teeth at the pose.
    pub fn posed(&self) -> PosedFlanks<'_> {
        self.plane.of(&self.problem)
    }
}

/// The flanks of a section, in the frame of [`FlankProblem`].
struct FlanksInSection<'a> {
    plane: &'a PosedFlanks<'a>,
    place: SectionPlace<'a>,
    members: [Member; 2],
    distance: f64,
    /// Displacements of both outlines at rotation 0.
    offs: (C, C),
    /// Turns of this flank and of the other one by leads that all teeth of a gear share, rad in the picture.
    leads: [Option<[f64; 2]>; 2],
    /// Turn of the picture in which the line of centres is the x axis, rad.
    turned: f64,
    /// The teeth of this side of leaning axes, and of the other one if far flanks are needed.
    leaning: Option<(LeaningSide<'a>, Option<LeaningSide<'a>>)>,
}

impl<'a> FlanksInSection<'a> {
    fn new(
        plane: &'a PosedFlanks<'a>,
        place: SectionPlace<'a>,
        with_far: bool,
    ) -> FlanksInSection<'a> {
        let (assembly, problem) = (place.assembly, plane.problem);
        let members = [assembly.locked(), assembly.free()];
        let side = problem.side;
        let leads = members.map(|member| {
            let gear = assembly.gear(member);
            let turn = |flank| turn_by_lead(gear, flank, 1, place.b);
            gear.has_one_lead().then(|| [side, side.other()].map(turn))
        });
        if !assembly.leans() {
            // The eccentricity is constant along the axis, and teeth wind.
            let wound = |member| turn(-plane.twist(assembly, member) * place.b);
            return FlanksInSection {
                plane,
                place,
                members,
                distance: problem.distance,
                offs: (
                    problem.locked_off * wound(members[0]),
                    problem.free_off * wound(members[1]),
                ),
                leads,
                turned: 0.0,
                leaning: None,
            };
        }
        let leaning = Leaning::new(assembly, place.whole, place.here, place.b);
        let between = leaning.between();
        let turned = -between.y.atan2(between.x);
        let mirror = plane.mirror();
        let off = |member: Member| {
            let off = leaning.displacement(member);
            let tooth_1 = assembly.mate_direction(member) + place.here.rotation(assembly, member);
            C::new(off.x, mirror * off.y) * turn(mirror * (turned - reduced(tooth_1)))
        };
        FlanksInSection {
            plane,
            place,
            members,
            distance: between.norm(),
            offs: (off(members[0]), off(members[1])),
            leads,
            turned: mirror * turned,
            leaning: Some((
                leaning.touching(side),
                with_far.then(|| leaning.touching(side.other())),
            )),
        }
    }

    /// Turns of the locked and of the free tooth of a step: of this flank, and of the other one.
    fn turns(&self, step: i64) -> [[f64; 2]; 2] {
        let (assembly, b, side) = (self.place.assembly, self.place.b, self.plane.problem.side);
        let numbers = self.plane.numbers(step);
        let (leaning, mirror) = (self.leaning(step), self.plane.mirror());
        [0, 1].map(|k| {
            let gear = assembly.gear(self.members[k]);
            let lead = |flank| turn_by_lead(gear, flank, numbers[k], b);
            let leads = self.leads[k].unwrap_or_else(|| [side, side.other()].map(lead));
            [0, 1].map(|flank| self.turned + mirror * (leads[flank] + leaning[k][flank]))
        })
    }

    /// Turns by leaning axes of the locked and of the free tooth of a step, counter-clockwise: of this flank, and of the other one.
    fn leaning(&self, step: i64) -> [[f64; 2]; 2] {
        let Some((near, far)) = &self.leaning else {
            return [[0.0; 2]; 2];
        };
        let (locked, _) = self.plane.places(step);
        if far.is_none() && self.place.near.is_some_and(|near| !near.contains(&locked)) {
            return [[0.0; 2]; 2];
        }
        let step = self.plane.mirror() as i64 * (self.plane.onward + step);
        let own = near.turns(step);
        let Some(far) = far else {
            return own.map(|turned| [turned; 2]);
        };
        let side = self.plane.problem.side;
        // The other flank of a free tooth faces another locked tooth.
        let onward = self.place.here.mating().steps_between(side, side.other());
        [
            [own[0], far.turns(step)[0]],
            [own[1], far.turns(step + onward)[1]],
        ]
    }
}

/// Turn of a tooth's flank by its lead from the measuring plane to the section at `b`, rad, counter-clockwise.
fn turn_by_lead(gear: &AsBuilt, side: Side, tooth: u32, b: f64) -> f64 {
    let lead = gear.lead_change(side, tooth, [0.0, b]);
    side.sense() * lead / gear.gear().base_radius()
}

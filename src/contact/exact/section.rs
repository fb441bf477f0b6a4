//! One transverse section of a pair on its exact curves.

use super::curves::SearchExhausted;
use super::direct::{self, DirectSolver, Envelopes};
use super::far_flanks::with_far_flanks;
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::modified::OuterGears;
use super::report;
use super::search::{self, Asked};
use super::shape::turn;
use super::teeth::reduced;
use super::tightest::Touching;
use crate::contact::Effort;
use crate::contact::body::{is_solid, may_be_solid, may_meet_far_flanks, reaches_over_an_axis};
use crate::contact::lost_motion::{Contact, LostMotion};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Member, Pose};
use std::f64::consts::FRAC_PI_2;

/// What a side of a section takes, in nodes, and each of its steps beside (tuned: 1.1 µs a pose of ordinary spur gears).
const SIDE: u64 = 2;
const STEP: u64 = 1;

/// Of what other sections have shown, a floor is so many ties less: what ties with a contact above it is found all the same.
const TIES_BELOW: f64 = 4.0;

/// What is wanted of a section.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted<'a> {
    pub effort: &'a Effort,
    /// How far beyond its nominal rotation the free gear is known to stop, rad, the right and the left side; contacts that let it farther need
    /// not be found. −∞ and ∞: all are wanted.
    pub known: [f64; 2],
}

impl<'a> Wanted<'a> {
    /// Both contacts, whatever they are.
    pub fn all(effort: &'a Effort) -> Wanted<'a> {
        Wanted {
            effort,
            known: [f64::NEG_INFINITY, f64::INFINITY],
        }
    }
}

/// One transverse section of an assembly: all there is of a spur pair.
#[derive(Debug, Clone)]
pub(in crate::contact) struct Section {
    pub right: FlankProblem,
    pub left: FlankProblem,
    /// What is the same at every centre distance, beside the teeth.
    envelopes: Envelopes,
    /// What spares searching, the same for both sides; `None` where all must be searched.
    pub(super) solver: Option<DirectSolver>,
    /// The same where profiles deviate.
    outer: Option<Box<OuterGears>>,
    free: Member,
    /// The pair, where teeth may stand in the mate's body.
    pub bodies: Option<Box<GearPair>>,
    /// Whether no pose can be assembled.
    pub blocked: bool,
    /// Whether a free tooth may meet a locked tooth's far flank first.
    meets_far_flanks: bool,
}

impl Section {
    /// That of `assembly`.
    pub fn new(assembly: &GearPair) -> Section {
        let problems = Side::BOTH.map(|side| FlankProblem::new(assembly, side));
        let envelopes = Envelopes::new(&problems[0], assembly);
        let outer = OuterGears::new(assembly, &problems);
        Section::of(assembly, problems, envelopes, outer)
    }

    /// The same gears at another centre distance, to the last bit; `assembly` is one that [`GearPair::at`] made of this one's.
    pub fn at(&self, assembly: &GearPair) -> Section {
        let problems = [&self.right, &self.left].map(|problem| problem.at(assembly));
        let outer = self.outer.as_ref();
        let outer = outer.and_then(|outer| outer.at(&problems));
        Section::of(assembly, problems, self.envelopes.clone(), outer)
    }

    /// The section of a helical pair of which this is the measuring plane: `pair`, which [`GearPair::section`] made.
    pub fn turned(&self, pair: &GearPair) -> Section {
        Section {
            right: self.right.turned(pair),
            left: self.left.turned(pair),
            bodies: self.bodies.as_ref().map(|_| Box::new(pair.clone())),
            ..self.clone()
        }
    }

    /// One of its sides.
    pub fn side(&self, side: Side) -> &FlankProblem {
        match side {
            Side::Right => &self.right,
            Side::Left => &self.left,
        }
    }

    /// Which gear is free.
    pub fn free(&self) -> Member {
        self.free
    }

    /// Angular pitch of the free gear, rad.
    pub fn free_pitch(&self) -> f64 {
        self.right.free.pitch
    }

    /// The teeth of one of its sides at `pose`.
    pub fn posed<'a>(&self, problem: &'a FlankProblem, pose: &Pose) -> PosedFlanks<'a> {
        let mating = pose.mating();
        let teeth = (mating.tooth(self.free.mate()), mating.tooth(self.free));
        let rotation = reduced(pose.locked_rotation());
        problem.posed(pose, teeth, rotation, turn(rotation))
    }

    fn of(
        assembly: &GearPair,
        problems: [FlankProblem; 2],
        envelopes: Envelopes,
        outer: Option<OuterGears>,
    ) -> Section {
        let [right, left] = problems;
        // Of both gears the left half teeth mirror the right ones.
        let solver = DirectSolver::new(&right, assembly, envelopes.clone());
        Section {
            meets_far_flanks: may_meet_far_flanks(assembly),
            right,
            left,
            envelopes,
            solver,
            outer: outer.map(Box::new),
            free: assembly.free(),
            bodies: may_be_solid(assembly).then(|| Box::new(assembly.clone())),
            blocked: reaches_over_an_axis(assembly),
        }
    }

    /// As [`super::ExactKernel::lost_motion`].
    pub(super) fn lost_motion(&self, pose: &Pose, wanted: Wanted) -> Result<LostMotion, Error> {
        self.with(pose, wanted, |posed, asked| match &self.outer {
            None => direct::touching(posed, self.solver.as_ref(), asked),
            Some(outer) => outer.touching(posed, asked),
        })
    }

    /// As [`super::ExactKernel::lost_motion_by_search`].
    pub(super) fn lost_motion_by_search(
        &self,
        pose: &Pose,
        wanted: Wanted,
    ) -> Result<LostMotion, Error> {
        self.with(pose, wanted, search::by_search)
    }

    /// As [`super::ExactKernel::is_direct`].
    pub fn is_direct(&self) -> bool {
        self.solver
            .as_ref()
            .is_some_and(|solver| solver.proof.is_direct())
    }

    fn with(
        &self,
        pose: &Pose,
        wanted: Wanted,
        method: impl Fn(&PosedFlanks, Asked) -> Result<Option<Touching>, (i64, SearchExhausted)>,
    ) -> Result<LostMotion, Error> {
        if self.blocked {
            return Ok(LostMotion::JAMMED);
        }
        let mating = pose.mating();
        let teeth = (mating.tooth(self.free.mate()), mating.tooth(self.free));
        let rotation = reduced(pose.locked_rotation());
        let turned = turn(rotation);
        let contact = |problem: &FlankProblem| -> Result<Option<Contact>, Error> {
            let posed = problem.posed(pose, teeth, rotation, turned);
            let steps = posed.steps();
            let steps = (steps.end - steps.start).max(0) as u64;
            wanted.effort.spend(SIDE + STEP * steps);
            if wanted.effort.is_spent() {
                return Err(self.lost(&posed, 0, SPENT, pose));
            }
            let asked = Asked {
                effort: wanted.effort,
                floor: floor(&posed, wanted.known, pose),
            };
            let found = method(&posed, asked).and_then(|found| {
                if self.meets_far_flanks {
                    with_far_flanks(&posed, found, asked)
                } else {
                    Ok(found)
                }
            });
            match found {
                Ok(touching) => {
                    Ok(touching.map(|touching| report::contact(&posed, &touching, self.free)))
                }
                Err((step, lost)) => Err(self.lost(&posed, step, lost.reason(), pose)),
            }
        };
        let result = LostMotion {
            right: contact(&self.right)?,
            left: contact(&self.left)?,
            solid: self
                .bodies
                .as_ref()
                .is_some_and(|pair| is_solid(pair, pose)),
        };
        let result = result.normalised(pose.free_rotation());
        Ok(result.within(self.right.free.pitch))
    }

    fn lost(&self, posed: &PosedFlanks, step: i64, reason: &'static str, pose: &Pose) -> Error {
        let (locked_place, free_place) = posed.places(step);
        let locked = posed.problem.locked.number(locked_place);
        let free = posed.problem.free.number(free_place);
        let (wheel_tooth, pinion_tooth) = match self.free {
            Member::Pinion => (locked, free),
            Member::Wheel => (free, locked),
        };
        Error::ContactLost {
            wheel_tooth,
            pinion_tooth,
            flank: posed.problem.side.name(),
            locked_rotation_rad: pose.locked_rotation(),
            reason,
        }
    }
}

/// Why a contact is lost when the effort of a pose is.
const SPENT: &str = "the effort that a pose allows is spent";

/// The gap at which the free gear stands where it is `known` to stop, and some ties less; −∞ where it is far from there, or nothing is known.
pub(super) fn floor(posed: &PosedFlanks, [right, left]: [f64; 2], pose: &Pose) -> f64 {
    let problem = posed.problem;
    let beyond = match problem.side {
        Side::Right => right,
        Side::Left => -left,
    };
    if !beyond.is_finite() {
        return f64::NEG_INFINITY;
    }
    let nominal = match problem.side {
        Side::Right => pose.free_rotation(),
        Side::Left => -pose.free_rotation(),
    };
    let gap = reduced(reduced(nominal) + beyond - posed.rotation(0.0));
    // Farther off, a turn more or less might be meant.
    if gap.abs() < FRAC_PI_2 {
        gap - TIES_BELOW * problem.tie
    } else {
        f64::NEG_INFINITY
    }
}

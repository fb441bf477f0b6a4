//! One transverse section of a pair on its exact curves.

use super::direct::{self, DirectSolver, Envelopes};
use super::far_flanks::with_far_flanks;
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::modified::OuterGears;
use super::report;
use super::search::{self, SideFound, SideRequest};
use super::shape::turn;
use super::teeth::reduced;
use super::tightest::FirstContact;
use crate::contact::Effort;
use crate::contact::body::{
    FarFlanks, beside_root_circles, is_solid, may_be_solid, reaches_over_an_axis,
};
use crate::contact::lost_motion::{Contact, LostMotion, contact_lost};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Member, Pose};
use std::f64::consts::FRAC_PI_2;

/// Effort of one side of a section, and of each of its steps, in nodes (tuned: 1.1 µs per pose of ordinary spur gears).
const SIDE: u64 = 2;
const STEP: u64 = 1;

/// Margin, in tie widths, below a gap that another section has shown. Contacts that tie with it are still found.
const TIES_BELOW: f64 = 4.0;

/// The request to a section.
#[derive(Clone, Copy)]
pub(super) struct SectionRequest<'a> {
    pub effort: &'a Effort<'a>,
    /// Rotation beyond nominal, rad, at which other sections are known to stop the free gear, on the right and on the
    /// left. Looser contacts need not be found. −∞ and ∞ request every contact.
    pub known: [f64; 2],
}

impl<'a> SectionRequest<'a> {
    /// Requests both contacts without a limit.
    pub fn all(effort: &'a Effort<'a>) -> SectionRequest<'a> {
        SectionRequest {
            effort,
            known: [f64::NEG_INFINITY, f64::INFINITY],
        }
    }
}

/// One transverse section of an assembly: the whole of a spur pair.
#[derive(Debug, Clone)]
pub(in crate::contact) struct Section {
    pub right: FlankProblem,
    pub left: FlankProblem,
    /// The parts, beside the teeth, that are the same at every centre distance.
    envelopes: Envelopes,
    /// The solver without search, for both sides; `None` if all must be searched.
    pub(super) solver: Option<DirectSolver>,
    /// The solver for profiles that deviate.
    outer: Option<Box<OuterGears>>,
    free: Member,
    /// The pair, if its teeth can enter the mate's body.
    pub bodies: Option<Box<GearPair>>,
    /// Whether no pose can be assembled.
    pub never_assembles: bool,
    /// Where a free tooth can meet a locked tooth's far flank first.
    pub(super) far_flanks: FarFlanks,
}

impl Section {
    /// The section of a spur pair.
    pub fn new(assembly: &GearPair) -> Section {
        let problems = Side::BOTH.map(|side| FlankProblem::new(assembly, side));
        let envelopes = Envelopes::new(&problems[0], assembly, 0.0);
        let outer = OuterGears::new(assembly, &problems);
        Section::of(assembly, problems, envelopes, outer)
    }

    /// The section of these gears at another centre distance, exact to the last bit; [`GearPair::at`] made `assembly`.
    pub fn at(&self, assembly: &GearPair) -> Section {
        let problems = [&self.right, &self.left].map(|problem| problem.at(assembly));
        let outer = self.outer.as_ref();
        let outer = outer.and_then(|outer| outer.at(&problems));
        Section::of(assembly, problems, self.envelopes.clone(), outer)
    }

    /// Another section of the pair of parallel axes whose measuring plane this is; [`GearPair::section`] made `pair`. Only the places of teeth and
    /// the directions of eccentricities differ.
    pub fn turned(&self, pair: &GearPair) -> Section {
        let problems = [&self.right, &self.left].map(|problem| problem.turned(pair));
        let outer = self.outer.as_ref();
        Section {
            bodies: self.bodies.as_ref().map(|_| Box::new(pair.clone())),
            outer: outer.and_then(|outer| outer.turned(pair)).map(Box::new),
            ..self.with_sides(problems)
        }
    }

    /// A section of leaning axes of the pair whose measuring plane this is; [`section_at`](crate::pair::section_at) made `pair`.
    pub fn leaning(&self, pair: &GearPair) -> Section {
        let problems = Side::BOTH.map(|side| FlankProblem::new(pair, side));
        let outer = OuterGears::new(pair, &problems);
        Section::of(pair, problems, self.envelopes.clone(), outer)
    }

    /// The section with these flanks of both sides, right first.
    pub fn with_sides(&self, [right, left]: [FlankProblem; 2]) -> Section {
        Section {
            right,
            left,
            ..self.clone()
        }
    }

    /// The section with this solver for both sides.
    pub(super) fn with_solver(self, solver: DirectSolver) -> Section {
        Section {
            solver: Some(solver),
            ..self
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
        // The left half teeth of both gears mirror the right ones.
        let solver = DirectSolver::new(&right, assembly, envelopes.clone(), &right);
        Section {
            far_flanks: FarFlanks::of(assembly),
            right,
            left,
            envelopes,
            solver,
            outer: outer.map(Box::new),
            free: assembly.free(),
            bodies: may_be_solid(assembly).then(|| Box::new(assembly.clone())),
            never_assembles: reaches_over_an_axis(assembly),
        }
    }

    /// As [`super::ExactKernel::lost_motion`].
    pub(super) fn lost_motion(
        &self,
        pose: &Pose,
        request: SectionRequest,
    ) -> Result<LostMotion, Error> {
        self.solve(pose, request, |posed, side| match &self.outer {
            None => direct::first_contact(posed, self.solver.as_ref(), side),
            Some(outer) => outer.first_contact(posed, side),
        })
    }

    /// As [`super::ExactKernel::lost_motion_by_search`].
    pub(super) fn lost_motion_by_search(
        &self,
        pose: &Pose,
        request: SectionRequest,
    ) -> Result<LostMotion, Error> {
        self.solve(pose, request, search::by_search)
    }

    /// As [`super::ExactKernel::is_direct`].
    pub fn is_direct(&self) -> bool {
        self.solver
            .as_ref()
            .is_some_and(|solver| solver.proof.is_direct())
    }

    fn solve(
        &self,
        pose: &Pose,
        request: SectionRequest,
        method: impl Fn(&PosedFlanks, SideRequest) -> SideFound,
    ) -> Result<LostMotion, Error> {
        if self.never_assembles {
            return Ok(LostMotion::JAMMED);
        }
        let mating = pose.mating();
        let teeth = (mating.tooth(self.free.mate()), mating.tooth(self.free));
        let rotation = reduced(pose.locked_rotation());
        let turned = turn(rotation);
        let contact = |problem: &FlankProblem| -> Result<Option<Contact>, Error> {
            let posed = problem.posed(pose, teeth, rotation, turned);
            let lost = |step, reason: &str| {
                let teeth = posed.numbers(step);
                Err(contact_lost(self.free, teeth, problem.side, pose, reason))
            };
            charge_steps(&posed, request.effort);
            if request.effort.is_spent() {
                return lost(0, SPENT);
            }
            let side = SideRequest {
                effort: request.effort,
                floor: floor(&posed, request.known, pose),
            };
            let found = method(&posed, side)
                .and_then(|found| with_far_flanks(&posed, self.far_flanks, found, side));
            match found {
                Ok(first_contact) => Ok(first_contact
                    .map(|first_contact| report::contact(&posed, &first_contact, self.free))),
                Err((step, why)) => lost(step, &why.reason()),
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
        let result = result.within(self.right.free.pitch);
        match &self.bodies {
            Some(pair) => beside_root_circles(pair, pose, result),
            None => Ok(result),
        }
    }

    /// The contact of `posed`, teeth of one side in a section of this pair, that needs no search; `None` without one or without effort.
    pub(super) fn first_contact(
        &self,
        posed: &PosedFlanks,
        solver: &DirectSolver,
        effort: &Effort,
    ) -> Option<FirstContact> {
        charge_steps(posed, effort);
        let request = SideRequest {
            effort,
            floor: f64::NEG_INFINITY,
        };
        let found = direct::first_contact(posed, Some(solver), request).ok()?;
        found.filter(|_| !effort.is_spent())
    }

    /// The contact of `found` at `posed`.
    pub(super) fn contact(&self, posed: &PosedFlanks, found: &FirstContact) -> Contact {
        report::contact(posed, found, self.free)
    }
}

/// Charges the teeth of one side.
fn charge_steps(posed: &PosedFlanks, effort: &Effort) {
    let steps = posed.steps();
    let steps = (steps.end - steps.start).max(0) as u64;
    effort.spend(SIDE + STEP * steps);
}

/// The reason of a contact lost because its pose has no effort left.
const SPENT: &str = "the effort that a pose allows is spent";

/// A few tie widths less than the gap at which the free gear is `known` to stop; −∞ if that is unknown or far away.
pub(super) fn floor(posed: &PosedFlanks, [right, left]: [f64; 2], pose: &Pose) -> f64 {
    let problem = posed.problem;
    let mirror = posed.mirror();
    let beyond = mirror * [right, left][problem.side.index()];
    if !beyond.is_finite() {
        return f64::NEG_INFINITY;
    }
    let gap = reduced(reduced(mirror * pose.free_rotation()) + beyond - posed.rotation(0.0));
    // Further away, the gap is ambiguous by a turn.
    if gap.abs() < FRAC_PI_2 {
        gap - TIES_BELOW * problem.tie
    } else {
        f64::NEG_INFINITY
    }
}

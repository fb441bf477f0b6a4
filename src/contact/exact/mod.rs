//! Lost motion on the smooth curves: the default method.
//!
//! Turning the free gear shifts all its points by one angle. In polar
//! coordinates `(ρ, θ)` about its axis two facing half teeth therefore touch at
//! the extremum over `ρ` of `θ_locked(ρ) − θ_free(ρ)`, and a side's contact is
//! that of its tightest pair. Nothing is approximated: what a result leaves open
//! is rounding, and the bracket of a branch and bound where one was needed; both
//! stand in [`Contact::error`].
//!
//! A half tooth runs from the far corner of the tip land, where the tooth's other flank
//! begins, over the land and down to the middle of the space, turned flank by flank as measured;
//! right halves face right halves, left halves left. Tips that hardly reach each other meet on the far
//! half of a land: where the tip circles cross is then all that is left of the mesh.
//!
//! Where several pairs touch together (within 1e-9 mm at the free gear's base
//! circle, as all do between perfect gears) the contact named is the one
//! nearest to the operating pitch point; of two equally near ones (within
//! 1e-6 mm) in right-flank contact the one clockwise on the locked gear, in
//! left-flank contact its mirror image. The rotation is that of the tightest.
//!
//! `right.rotation` lies in (−π, π], `left.rotation` continues from it.

mod branch;
mod candidate;
mod corner;
mod curves;
mod direct;
mod envelope;
mod extremes;
mod flank_pieces;
mod flank_problem;
mod lands;
mod line;
mod modified;
mod path;
mod placed;
mod report;
mod search;
mod search_free_proof;
mod shape;
mod tangent;
mod teeth;
mod tightest;

pub use extremes::{Doubt, Extreme, Extremes};
pub(super) use flank_problem::lens_half;

use super::body::{is_solid, may_be_solid, reaches_over_an_axis};
use super::lost_motion::{Contact, LostMotion};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Mating, Member, Pose};
use curves::SearchExhausted;
use direct::{DirectSolver, Envelopes};
use flank_problem::{FlankProblem, PosedFlanks};
use modified::OuterGears;
use shape::turn;
use std::f64::consts::{PI, TAU};
use teeth::reduced;
use tightest::Touching;

/// Lost motion of one assembly on its exact curves.
///
/// Holds what does not depend on the pose, 48 bytes a tooth and side; poses may be asked for from any thread.
#[derive(Debug, Clone)]
pub struct ExactKernel {
    right: FlankProblem,
    left: FlankProblem,
    /// What is the same at every centre distance, beside the teeth.
    envelopes: Envelopes,
    /// What spares searching, the same for both sides; `None` where all must be searched.
    solver: Option<DirectSolver>,
    /// The same where profiles deviate.
    outer: Option<Box<OuterGears>>,
    free: Member,
    /// The pair, where teeth may stand in the mate's body.
    bodies: Option<Box<GearPair>>,
    /// Whether no pose can be assembled.
    blocked: bool,
}

impl ExactKernel {
    /// The kernel of `assembly`.
    pub fn new(assembly: &GearPair) -> ExactKernel {
        let problems = Side::BOTH.map(|side| FlankProblem::new(assembly, side));
        let envelopes = Envelopes::new(&problems[0], assembly);
        let outer = OuterGears::new(assembly, &problems);
        ExactKernel::of(assembly, problems, envelopes, outer)
    }

    /// The kernel of the same gears at another centre distance, in a time that does not depend on the number of teeth.
    ///
    /// It is that of [`ExactKernel::new`] to the last bit of any result. `assembly` is one that
    /// [`GearPair::at`] made of this kernel's.
    pub fn at(&self, assembly: &GearPair) -> ExactKernel {
        let problems = [&self.right, &self.left].map(|problem| problem.at(assembly));
        let outer = self.outer.as_ref();
        let outer = outer.and_then(|outer| outer.at(&problems));
        ExactKernel::of(assembly, problems, self.envelopes.clone(), outer)
    }

    fn of(
        assembly: &GearPair,
        problems: [FlankProblem; 2],
        envelopes: Envelopes,
        outer: Option<OuterGears>,
    ) -> ExactKernel {
        let [right, left] = problems;
        // Of both gears the left half teeth mirror the right ones.
        let solver = DirectSolver::new(&right, assembly, envelopes.clone());
        ExactKernel {
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

    /// Right- and left-flank contact at `pose`, a pose of the same assembly.
    ///
    /// The result depends on the pose alone, to the last bit.
    ///
    /// # Errors
    /// [`Error::ContactLost`] when a pair of flanks cannot be resolved; never a pair left out.
    pub fn lost_motion(&self, pose: &Pose) -> Result<LostMotion, Error> {
        self.with(pose, |posed| match &self.outer {
            None => direct::touching(posed, self.solver.as_ref()),
            Some(outer) => outer.touching(posed),
        })
    }

    /// The same at `mating` of `assembly`, which is this kernel's; `None` where a contact is lost.
    ///
    /// # Errors
    /// None but what is not of this one pose.
    pub(crate) fn lost_motion_at(
        &self,
        assembly: &GearPair,
        mating: Mating,
    ) -> Result<Option<LostMotion>, Error> {
        match self.lost_motion(&Pose::new(assembly, mating)) {
            Err(error) if error.of_one_pose().is_some() => Ok(None),
            found => found.map(Some),
        }
    }

    /// The same by branch and bound over all pairs and curves, no case told apart: a thousand times
    /// slower, to check [`ExactKernel::lost_motion`] by. Lands that touch between their corners may be more than it can settle.
    ///
    /// # Errors
    /// As [`ExactKernel::lost_motion`].
    pub fn lost_motion_by_search(&self, pose: &Pose) -> Result<LostMotion, Error> {
        self.with(pose, search::by_search)
    }

    /// Whether this pair needs no search: its contacts are on the line of action, at corners,
    /// or where a tip land touches an involute.
    pub fn is_direct(&self) -> bool {
        self.solver
            .as_ref()
            .is_some_and(|solver| solver.proof.is_direct())
    }

    fn with(
        &self,
        pose: &Pose,
        method: impl Fn(&PosedFlanks) -> Result<Option<Touching>, (i64, SearchExhausted)>,
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
            match method(&posed) {
                Ok(touching) => {
                    Ok(touching.map(|touching| report::contact(&posed, &touching, self.free)))
                }
                Err((step, lost)) => Err(self.lost(&posed, step, &lost, pose)),
            }
        };
        let mut result = LostMotion {
            right: contact(&self.right)?,
            left: contact(&self.left)?,
            solid: self
                .bodies
                .as_ref()
                .is_some_and(|pair| is_solid(pair, pose)),
        };
        normalise(&mut result, pose.free_rotation());
        Ok(result.within(self.right.free.pitch))
    }

    fn lost(&self, posed: &PosedFlanks, step: i64, lost: &SearchExhausted, pose: &Pose) -> Error {
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
            reason: lost.reason(),
        }
    }
}

/// Right into (−π, π]; left as many turns on as the two lie apart, each counted from the nominal rotation: gears of three
/// teeth that hardly reach each other may turn by more than half a turn.
fn normalise(result: &mut LostMotion, nominal: f64) {
    let turns = |angle: f64| (angle / TAU).round();
    let whole = |contact: &Contact| turns(contact.rotation - nominal);
    let onward = result.right.map_or(0.0, |right| -turns(right.rotation));
    let beside = match (&result.right, &result.left) {
        (Some(right), Some(left)) => onward + whole(right) - whole(left),
        (None, Some(left)) => -turns(left.rotation),
        _ => 0.0,
    };
    if let Some(right) = &mut result.right {
        right.rotation += TAU * onward;
        if right.rotation == -PI {
            right.rotation = PI;
        }
    }
    if let Some(left) = &mut result.left {
        left.rotation += TAU * beside;
    }
}

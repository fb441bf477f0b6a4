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
//! half of a land: where the tip circles cross is then all that is left of the mesh. Gears of three or four teeth may stand beside a tip land,
//! on the locked tooth's far flank (`far_flanks`).
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
mod deepest;
mod direct;
mod envelope;
mod extremes;
mod far_flanks;
mod flank_heights;
mod flank_pieces;
mod flank_problem;
mod helical;
mod lands;
mod line;
mod modified;
mod path;
mod placed;
mod report;
mod search;
mod search_free_proof;
mod section;
mod shape;
mod tangent;
mod teeth;
#[cfg(test)]
mod tests;
mod tightest;

pub(crate) use extremes::is_proven;
pub use extremes::{Doubt, Extreme, Extremes, PROVEN_WIDTH};
pub(super) use flank_problem::{FlankProblem, PosedFlanks, lens_half};
pub(super) use placed::Placed;
pub(super) use section::Section;
pub(super) use shape::HalfToothShape;
pub(super) use teeth::reduced;

use super::effort::Effort;
use super::lost_motion::LostMotion;
use super::over_face::FoundOverFace;
use crate::error::Error;
use crate::pair::{GearPair, Mating, Pose};
use helical::Helical;
use section::Wanted;

/// Lost motion of one assembly on its exact curves.
///
/// Holds what does not depend on the pose, 48 bytes a tooth and side; poses may be asked for from any thread.
#[derive(Debug, Clone)]
pub struct ExactKernel {
    /// The measuring plane: all of a spur pair.
    section: Section,
    helical: Option<Box<Helical>>,
}

impl ExactKernel {
    /// The kernel of `assembly`.
    pub fn new(assembly: &GearPair) -> ExactKernel {
        ExactKernel::of(assembly, Section::new(assembly))
    }

    /// The kernel of the same gears at another centre distance, in a time that does not depend on the number of teeth.
    ///
    /// It is that of [`ExactKernel::new`] to the last bit of any result. `assembly` is one that
    /// [`GearPair::at`] made of this kernel's.
    pub fn at(&self, assembly: &GearPair) -> ExactKernel {
        ExactKernel::of(assembly, self.section.at(assembly))
    }

    fn of(assembly: &GearPair, section: Section) -> ExactKernel {
        let helical = assembly
            .is_helical()
            .then(|| Box::new(Helical::new(assembly, &section)));
        ExactKernel { section, helical }
    }

    /// Right- and left-flank contact at `pose`, a pose of the same assembly; of helical gears over their common face.
    ///
    /// The result depends on the pose alone, to the last bit.
    ///
    /// # Errors
    /// [`Error::ContactLost`] when a pair of flanks cannot be resolved within the effort of a pose; never a pair left out.
    pub fn lost_motion(&self, pose: &Pose) -> Result<LostMotion, Error> {
        Ok(self.found_within(pose, &Effort::of_pose())?.lost_motion)
    }

    /// Units of effort, counted and not timed, that `pose` takes, and how many it may take before it is given up.
    pub fn effort(&self, pose: &Pose) -> [u64; 2] {
        let effort = Effort::of_pose();
        let most = effort.left();
        // What it came to is not asked for.
        let _ = self.found_within(pose, &effort);
        [effort.used(), most]
    }

    /// The same with what `effort` allows, which is of this pose alone, and which section of helical gears jams.
    pub(super) fn found_within(
        &self,
        pose: &Pose,
        effort: &Effort,
    ) -> Result<FoundOverFace, Error> {
        match &self.helical {
            None => {
                let lost_motion = self.section.lost_motion(pose, Wanted::all(effort))?;
                let jam = None;
                Ok(FoundOverFace { lost_motion, jam })
            }
            Some(helical) => helical.over(pose, effort, Section::lost_motion),
        }
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
        self.lost_motion_counted(assembly, mating).0
    }

    /// The same, and what it took.
    fn lost_motion_counted(
        &self,
        assembly: &GearPair,
        mating: Mating,
    ) -> (Result<Option<LostMotion>, Error>, u64) {
        let effort = Effort::of_pose();
        let found = self.found_within(&Pose::new(assembly, mating), &effort);
        let found = match found {
            Err(error) if error.pose_failure().is_some() => Ok(None),
            found => found.map(|found| Some(found.lost_motion)),
        };
        (found, effort.used())
    }

    /// The same by branch and bound over all pairs and curves, no case told apart: a thousand times
    /// slower, to check [`ExactKernel::lost_motion`] by. Lands that touch between their corners may be more than it can settle.
    ///
    /// # Errors
    /// As [`ExactKernel::lost_motion`].
    pub fn lost_motion_by_search(&self, pose: &Pose) -> Result<LostMotion, Error> {
        let effort = Effort::endless();
        match &self.helical {
            None => {
                let wanted = Wanted::all(&effort);
                self.section.lost_motion_by_search(pose, wanted)
            }
            Some(helical) => {
                let found = helical.over(pose, &effort, Section::lost_motion_by_search)?;
                Ok(found.lost_motion)
            }
        }
    }

    /// The measuring plane: all there is of a spur pair.
    pub(super) fn plane(&self) -> &Section {
        &self.section
    }

    /// The sections of helical gears that hold the tightest of all pairs of involutes, and their places along the face, mm; `None` of spur gears.
    pub(super) fn sections_over_face(&self) -> Option<&[(f64, Section)]> {
        self.helical.as_ref().map(|helical| helical.sections())
    }

    /// Places along the face, mm, whose sections hold the tightest of all pairs of involutes; that of the measuring plane of spur gears.
    pub fn sections(&self) -> Vec<f64> {
        let helical = self.helical.as_ref();
        helical.map_or(vec![0.0], |helical| helical.places().collect())
    }

    /// Whether this pair needs no search: its contacts are on the line of action, at corners,
    /// or where a tip land touches an involute.
    pub fn is_direct(&self) -> bool {
        self.section.is_direct()
    }
}

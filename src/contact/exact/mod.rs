//! Lost motion on the smooth curves: the default method.
//!
//! Turning the free gear shifts the angle of all its points equally. Two facing half teeth therefore touch at the
//! maximum over `ρ` of `θ_locked(ρ) − θ_free(ρ)`, in polar coordinates `(ρ, θ)` about the free axis. The contact of a
//! side is that of its tightest pair. Nothing is approximated. The remaining uncertainty is rounding, and the bracket
//! of a branch and bound where one is needed; [`Contact::error`] contains both.
//!
//! A half tooth starts at the far corner of the tip land, where the other flank begins. It follows the land and the flank down to the
//! middle of the space, each flank turned as measured. Right halves face right halves, left halves left. Tips that barely reach each other
//! meet on the far half of a land: only the crossing of the tip circles is left of the mesh. Gears of three or four teeth can touch beside
//! a tip land, on the locked tooth's far flank (`far_flanks`).
//!
//! Several pairs can touch together: within 1e-9 mm at the free gear's base circle, as all pairs of perfect gears do. The reported contact
//! is the one nearest the operating pitch point. If two are equally near (within 1e-6 mm), it is in right-flank contact the one clockwise
//! on the locked gear, and in left-flank contact its mirror image. The rotation is that of the tightest pair.
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
mod leaning;
mod line;
mod modified;
mod path;
mod placed;
mod report;
mod search;
mod search_free_proof;
mod section;
mod section_side;
mod separation;
mod shape;
mod tangent;
mod teeth;
#[cfg(test)]
mod tests;
mod tightest;

pub use extremes::{Doubt, Extreme, Extremes, PROVEN_WIDTH, PROVEN_WIDTH_DRAWN, cycle_extremes};
pub(crate) use extremes::{End, cycle_extremes_within, is_proven, keeps_to_involutes};
pub(super) use flank_problem::{FlankProblem, PosedFlanks};
pub(super) use placed::PlacedHalf;
pub(super) use section::Section;
pub(super) use shape::HalfToothShape;
pub(super) use teeth::reduced;

use super::effort::Effort;
use super::lost_motion::LostMotion;
use super::over_face::FoundOverFace;
use crate::error::Error;
use crate::pair::{GearPair, Mating, Pose};
use helical::Helical;
use section::SectionRequest;

/// Lost motion of one assembly on its exact curves.
///
/// Holds the data that do not depend on the pose, 48 bytes per tooth and side. Any thread may use it.
#[derive(Debug, Clone)]
pub struct ExactKernel {
    /// The measuring plane: the whole of a spur pair.
    section: Section,
    helical: Option<Box<Helical>>,
}

impl ExactKernel {
    /// The kernel of `assembly`.
    pub fn new(assembly: &GearPair) -> ExactKernel {
        ExactKernel::of(assembly, Section::new(assembly))
    }

    /// The kernel of these gears at another centre distance, in a time independent of the number of teeth.
    ///
    /// Every result equals that of [`ExactKernel::new`] to the last bit. [`GearPair::at`] must have made `assembly`
    /// from this kernel's pair.
    pub fn at(&self, assembly: &GearPair) -> ExactKernel {
        ExactKernel::of(assembly, self.section.at(assembly))
    }

    fn of(assembly: &GearPair, section: Section) -> ExactKernel {
        let helical = assembly
            .varies_along_face()
            .then(|| Box::new(Helical::new(assembly, &section)));
        ExactKernel { section, helical }
    }

    /// Right- and left-flank contact at `pose` of this assembly. For helical gears it is found over the common face.
    ///
    /// The result depends on the pose alone, to the last bit.
    ///
    /// # Errors
    /// [`Error::ContactLost`] if a pair of flanks cannot be resolved within the effort of a pose. No pair is ever omitted.
    pub fn lost_motion(&self, pose: &Pose) -> Result<LostMotion, Error> {
        Ok(self.found_within(pose, &Effort::of_pose())?.lost_motion)
    }

    /// Effort of `pose` in counted nodes, and the limit for one pose. Time is not measured.
    pub fn effort(&self, pose: &Pose) -> [u64; 2] {
        let effort = Effort::of_pose();
        let most = effort.left();
        // Only the effort matters here, not the contacts.
        let _ = self.found_within(pose, &effort);
        [effort.used(), most]
    }

    /// The contacts within the budget `effort` of this pose, and the section in which a helical pair jams.
    pub(super) fn found_within(
        &self,
        pose: &Pose,
        effort: &Effort,
    ) -> Result<FoundOverFace, Error> {
        match &self.helical {
            None => {
                let lost_motion = self
                    .section
                    .lost_motion(pose, SectionRequest::all(effort))?;
                let jam = None;
                Ok(FoundOverFace { lost_motion, jam })
            }
            Some(helical) => match helical.lost_motion_without_search(pose, effort) {
                Some(found) => Ok(found),
                None => helical.over(pose, effort, Section::lost_motion),
            },
        }
    }

    /// The lost motion at `mating` of this kernel's `assembly`; `None` if a contact is lost.
    ///
    /// # Errors
    /// Only errors that do not concern a single pose.
    pub(crate) fn lost_motion_at(
        &self,
        assembly: &GearPair,
        mating: Mating,
    ) -> Result<Option<LostMotion>, Error> {
        self.lost_motion_counted(assembly, mating).0
    }

    /// Also returns the effort used.
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

    /// The lost motion by branch and bound over all pairs and curves, without special cases. It checks [`ExactKernel::lost_motion`] and is
    /// a thousand times slower. It may fail on lands that touch between their corners.
    ///
    /// # Errors
    /// As [`ExactKernel::lost_motion`].
    pub fn lost_motion_by_search(&self, pose: &Pose) -> Result<LostMotion, Error> {
        let effort = Effort::endless();
        match &self.helical {
            None => {
                let request = SectionRequest::all(&effort);
                self.section.lost_motion_by_search(pose, request)
            }
            Some(helical) => {
                let found = helical.over(pose, &effort, Section::lost_motion_by_search)?;
                Ok(found.lost_motion)
            }
        }
    }

    /// The measuring plane: the whole of a spur pair.
    pub(super) fn plane(&self) -> &Section {
        &self.section
    }

    /// Calls `each` for every section that holds the tightest of all pairs of involutes, and for those at the `further` places. It gets the
    /// section, `pose` in it, and its place along the face, mm. A spur pair has one section.
    ///
    /// # Errors
    /// The first of `each`.
    pub(super) fn each_section<E>(
        &self,
        pose: &Pose,
        further: impl Iterator<Item = f64>,
        mut each: impl FnMut(&Section, &Pose, f64) -> Result<(), E>,
    ) -> Result<(), E> {
        match &self.helical {
            Some(helical) => helical.each_section(pose, further, each),
            None => each(&self.section, pose, 0.0),
        }
    }

    /// Places along the face, mm, whose sections hold the tightest of all pairs of involutes; for spur gears the measuring plane.
    pub fn sections(&self) -> Vec<f64> {
        let helical = self.helical.as_ref();
        helical.map_or(vec![0.0], |helical| helical.places().collect())
    }

    /// Whether the contacts need no search: all are on the line of action, at corners, or where a tip land touches an involute.
    pub fn is_direct(&self) -> bool {
        self.section.is_direct()
    }
}

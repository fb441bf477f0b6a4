//! The certificate: polygons confirm a rotation that another method found.
//!
//! At a slightly greater opening every pair of half teeth in reach must be clear. Chords prove that; they are cut finer only where they are
//! within both chordal errors of each other. At a slightly smaller opening one pair must touch. The step on either side is the error bound
//! of the result plus the resolution of the finest polygons. The certificate uses nothing of the method under test but its answer.

use super::examination::{Finding, examine};
use super::facing_pair::{CutTeeth, FacingPair};
use super::kernel::{PolygonKernel, finest_chord, steps_in_reach};
use super::search::search;
use crate::contact::Effort;
use crate::contact::lost_motion::{Contact, LostMotion, Status};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::Pose;
use std::f64::consts::TAU;

/// Limit of chord pairs examined on one side. In 9000 random poses the most was 202 and the mean 86, at about 0.1 µs each.
const EFFORT: u32 = 50_000;

/// Chord pairs per unit of effort. Placing two half teeth at a pose takes another unit.
const PAIRS_PER_UNIT: u32 = 3;

/// Widest bound, as a part of a pitch, that is checked at two openings. With a wider one, other teeth or none may be there.
const WIDEST_CHECKED: f64 = 1e-2;

/// Checks rotations on the polygons of a kernel.
pub struct Certifier<'a> {
    kernel: PolygonKernel<'a>,
}

impl<'a> Certifier<'a> {
    /// A certifier on the polygons of `kernel`, which may be coarse.
    pub fn new(kernel: PolygonKernel<'a>) -> Certifier<'a> {
        Certifier { kernel }
    }

    /// Confirms both contacts of `found` at `pose`, or fails. The rotations of a jammed pose have no meaning, because a tooth can meet the
    /// body of a gear of few teeth several times. The pose also passes if the polygons find it jammed.
    ///
    /// # Errors
    /// [`Error::CertificateFailed`] with the pose that reproduces it; [`Error::ContactLost`] from a search.
    pub fn check(&self, pose: &Pose, found: &LostMotion) -> Result<(), Error> {
        self.check_within(pose, found, &Effort::of_pose())
    }

    /// [`Certifier::check`] within the budget `effort` of this pose.
    pub(in crate::contact) fn check_within(
        &self,
        pose: &Pose,
        found: &LostMotion,
        effort: &Effort,
    ) -> Result<(), Error> {
        // Teeth inside the mate's body prove the jam by themselves.
        if found.solid {
            return Ok(());
        }
        let sides = [(Side::Right, &found.right), (Side::Left, &found.left)];
        let checked = sides
            .into_iter()
            .try_for_each(|(side, contact)| self.check_side(pose, side, contact.as_ref(), effort));
        if checked.is_err() && found.status() == Status::Jammed {
            let own = self.kernel.refined().lost_motion_within(pose, effort)?;
            if own.status() == Status::Jammed {
                return Ok(());
            }
        }
        checked
    }

    /// Confirms the contact of one side.
    pub(crate) fn check_side(
        &self,
        pose: &Pose,
        side: Side,
        contact: Option<&Contact>,
        effort: &Effort,
    ) -> Result<(), Error> {
        let assembly = self.kernel.teeth.assembly;
        let free = assembly.gear(assembly.free()).gear();
        let widest = WIDEST_CHECKED * free.basic_data().angular_pitch();
        let Some(contact) = contact else {
            return self.check_no_touch(pose, side, effort);
        };
        if contact.error > widest {
            self.check_touch_within(pose, side, contact, effort)
        } else if self.touching(pose, side, contact, effort)? {
            Ok(())
        } else {
            let rotation = contact.rotation;
            let reason = format!("nothing touches at the rotation {rotation} rad");
            Err(self.failed(pose, side, reason))
        }
    }

    /// Whether any pair touches at an opening slightly smaller than that of `contact`. Fails unless all are clear at a slightly greater one: that
    /// is the check of a section of a helical pair whose first contact is in another section.
    pub(crate) fn touching(
        &self,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        effort: &Effort,
    ) -> Result<bool, Error> {
        let assembly = self.kernel.teeth.assembly;
        let finest = finest_chord(assembly);
        let lever = contact.lever(assembly.axis(assembly.free()));
        let opening = side.sense() * (pose.free_rotation() - contact.rotation);
        let mut touching = false;
        let allowed = effort.left().saturating_mul(PAIRS_PER_UNIT.into());
        let mut left = allowed.min(EFFORT.into()) as u32;
        let steps = steps_in_reach(assembly, pose);
        for problem in FacingPair::all(&self.kernel.teeth, pose, side, steps) {
            // Clear polygons are 2δ apart, and a fillet's chords lie up to δ in front of it. Another δ and the rounding
            // complete the margin.
            let margin = contact.error + (4.0 * finest + problem.rounding()) / lever;
            let openings = [opening + margin, opening - margin];
            let before = left;
            let finding = examine(&problem, openings, finest, touching, &mut left);
            effort.spend(u64::from((before - left) / PAIRS_PER_UNIT) + 1);
            let (locked, free) = (problem.locked_tooth, problem.free_tooth);
            let reason = match finding {
                Finding::Clear => continue,
                Finding::Touch => {
                    touching = true;
                    continue;
                }
                Finding::Overlap => format!(
                    "tooth {locked} of the locked gear and tooth {free} of the free one touch before the rotation {} rad",
                    contact.rotation
                ),
                Finding::EffortSpent => format!(
                    "the effort of a pose ended at tooth {locked} of the locked gear and tooth {free} of the free one"
                ),
            };
            return Err(self.failed(pose, side, reason));
        }
        Ok(touching)
    }

    /// Confirms a contact with a wide bound: the polygons' own contact must lie within it. Lands that press on each
    /// other have almost no lever, and the bound on their rotation can be half a turn.
    fn check_touch_within(
        &self,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        effort: &Effort,
    ) -> Result<(), Error> {
        let Some(own) = self.kernel.refined().side(pose, side, effort)? else {
            return Err(self.failed(pose, side, "nothing touches".to_owned()));
        };
        let turns = (own.rotation - contact.rotation) / TAU;
        let off = (turns - turns.round()).abs() * TAU;
        if off <= own.error + contact.error {
            return Ok(());
        }
        Err(self.failed(
            pose,
            side,
            format!("the first to touch does so {off} rad off"),
        ))
    }

    /// Confirms that no pair in reach ever touches, or only by a distance below the rounding of the axes.
    fn check_no_touch(&self, pose: &Pose, side: Side, effort: &Effort) -> Result<(), Error> {
        let teeth = &self.kernel.teeth;
        if !first_touching(teeth, pose, side, effort)? {
            return Ok(());
        };
        let assembly = teeth.assembly;
        let doubt = 4.0 * finest_chord(assembly) + FacingPair::new(teeth, pose, side, 0).rounding();
        let wider = assembly.at(assembly.center_distance() + doubt)?;
        let wider = CutTeeth {
            assembly: &wider,
            cut: teeth.cut,
        };
        if first_touching(&wider, pose, side, effort)? {
            Err(self.failed(pose, side, "a pair does touch".to_owned()))
        } else {
            Ok(())
        }
    }

    pub(crate) fn failed(&self, pose: &Pose, side: Side, reason: String) -> Error {
        let mating = pose.mating();
        Error::CertificateFailed {
            wheel_tooth: mating.wheel_tooth,
            pinion_tooth: mating.pinion_tooth,
            flank: mating.flank.name(),
            fraction: mating.fraction,
            center_distance_mm: self.kernel.teeth.assembly.center_distance(),
            side: side.name(),
            reason,
        }
    }
}

/// Whether any pair's polygons touch.
fn first_touching(
    teeth: &CutTeeth,
    pose: &Pose,
    side: Side,
    effort: &Effort,
) -> Result<bool, Error> {
    let steps = steps_in_reach(teeth.assembly, pose);
    let facing = |steps| FacingPair::new(teeth, pose, side, steps);
    let problems: Vec<FacingPair> = steps.map(facing).collect();
    Ok(!search(&problems, finest_chord(teeth.assembly), effort)?.is_empty())
}

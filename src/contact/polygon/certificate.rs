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
        let checked = self.check_rotations(pose, found, effort);
        if checked.is_err() && found.status() == Status::Jammed {
            let own = self.refined().lost_motion_within(pose, effort)?;
            if own.status() == Status::Jammed {
                return Ok(());
            }
        }
        checked
    }

    /// The polygon method on the same polygons.
    fn refined(&self) -> PolygonKernel<'a> {
        PolygonKernel {
            finest: finest_chord(self.kernel.teeth.assembly),
            ..self.kernel
        }
    }

    fn check_rotations(
        &self,
        pose: &Pose,
        found: &LostMotion,
        effort: &Effort,
    ) -> Result<(), Error> {
        for (side, contact) in [(Side::Right, &found.right), (Side::Left, &found.left)] {
            self.check_side(pose, side, contact.as_ref(), effort)?;
        }
        Ok(())
    }

    /// Confirms the contact of one side.
    pub(crate) fn check_side(
        &self,
        pose: &Pose,
        side: Side,
        contact: Option<&Contact>,
        effort: &Effort,
    ) -> Result<(), Error> {
        let free = self.kernel.teeth.assembly.free();
        let pitch = self.kernel.teeth.assembly.gear(free);
        let pitch = pitch.gear().basic_data().angular_pitch();
        let checked = match contact {
            Some(contact) if contact.error > WIDEST_CHECKED * pitch => {
                self.check_touch_within(pose, side, contact, effort)?
            }
            Some(contact) => self.check_touch(pose, side, contact, effort),
            None => self.check_no_touch(pose, side, effort)?,
        };
        checked.map_err(|reason| self.failed(pose, side, reason))
    }

    /// Whether all pairs on `side` are clear at an opening slightly greater than that of `contact`, or why not. This is
    /// the check of a section of a helical pair whose first contact is in another section.
    pub(crate) fn clears(
        &self,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        effort: &Effort,
    ) -> Result<(), String> {
        self.touching(pose, side, contact, effort).map(|_| ())
    }

    /// Confirms that all pairs are clear at the greater opening and that one touches at the smaller.
    fn check_touch(
        &self,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        effort: &Effort,
    ) -> Result<(), String> {
        if self.touching(pose, side, contact, effort)? {
            Ok(())
        } else {
            Err(format!(
                "nothing touches at the rotation {} rad",
                contact.rotation
            ))
        }
    }

    /// Whether any pair touches at the smaller opening. Fails unless all are clear at the greater.
    fn touching(
        &self,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        effort: &Effort,
    ) -> Result<bool, String> {
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
            match finding {
                Finding::Clear => {}
                Finding::Touch => touching = true,
                Finding::Overlap => {
                    return Err(format!(
                        "tooth {} of the locked gear and tooth {} of the free one touch before the rotation {} rad",
                        problem.locked_tooth, problem.free_tooth, contact.rotation
                    ));
                }
                Finding::EffortSpent => {
                    return Err(format!(
                        "the effort of a pose ended at tooth {} of the locked gear and tooth {} of the free one",
                        problem.locked_tooth, problem.free_tooth
                    ));
                }
            }
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
    ) -> Result<Result<(), String>, Error> {
        let Some(own) = self.refined().side(pose, side, effort)? else {
            return Ok(Err("nothing touches".to_owned()));
        };
        let turns = (own.rotation - contact.rotation) / TAU;
        let off = (turns - turns.round()).abs() * TAU;
        Ok(if off <= own.error + contact.error {
            Ok(())
        } else {
            Err(format!("the first to touch does so {off} rad off"))
        })
    }

    /// Confirms that no pair in reach ever touches, or only by a distance below the rounding of the axes.
    fn check_no_touch(
        &self,
        pose: &Pose,
        side: Side,
        effort: &Effort,
    ) -> Result<Result<(), String>, Error> {
        if !first_touching(&self.kernel.teeth, pose, side, effort)? {
            return Ok(Ok(()));
        };
        let assembly = self.kernel.teeth.assembly;
        let doubt = 4.0 * finest_chord(assembly)
            + FacingPair::new(&self.kernel.teeth, pose, side, 0).rounding();
        let wider = assembly.at(assembly.center_distance() + doubt)?;
        Ok(
            if first_touching(&self.kernel.teeth.at(&wider), pose, side, effort)? {
                Err("a pair does touch".to_owned())
            } else {
                Ok(())
            },
        )
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
    let problems: Vec<FacingPair> = FacingPair::facing(teeth, pose, side, steps).collect();
    Ok(!search(&problems, finest_chord(teeth.assembly), effort)?.is_empty())
}

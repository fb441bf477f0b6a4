//! The certificate: polygons bear out a rotation that another method found.
//!
//! A little more open than the rotation in question every pair of half teeth in reach
//! must be clear, proven by chords that are cut again only where they are
//! within both chordal errors of each other; a little more closed one of them
//! must touch. "A little" is the result's own error bound and what the
//! finest polygons resolve. Nothing of the method under test is used but its answer.

use super::flank_problem::{CutTeeth, FlankProblem};
use super::kernel::{PolygonKernel, finest_chord, steps_in_reach};
use super::look::{Seen, seen};
use super::search::search;
use crate::contact::Effort;
use crate::contact::lost_motion::{Contact, LostMotion, Status};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::Pose;
use std::f64::consts::TAU;

/// Pairs of chords looked at before a side is given up. Of 9000 random poses no side took more than 202, 86 on average; each takes
/// some 0.1 µs.
const EFFORT: u32 = 50_000;

/// So many of them take the time of a unit of effort; putting two half teeth where a pose has them takes another.
const LOOKS_A_UNIT: u32 = 3;

/// A bound wider than this part of a pitch is no place to look at two openings: other teeth, or nothing, may stand there.
const NARROW: f64 = 1e-2;

/// Checks rotations on the polygons of a kernel.
pub struct Certifier<'a> {
    kernel: PolygonKernel<'a>,
}

impl<'a> Certifier<'a> {
    /// A certifier on the polygons of `kernel`; coarse ones do.
    pub fn new(kernel: PolygonKernel<'a>) -> Certifier<'a> {
        Certifier { kernel }
    }

    /// Bears out both contacts of `found` at `pose`, or fails. Of a jammed pose the rotations mean nothing: where they are not
    /// borne out (a tooth that goes through the body of a gear of few teeth meets it several times) it is enough that
    /// the polygons by themselves find the pose jammed.
    ///
    /// # Errors
    /// [`Error::CertificateFailed`] with the pose that reproduces it; [`Error::ContactLost`] from a search.
    pub fn check(&self, pose: &Pose, found: &LostMotion) -> Result<(), Error> {
        self.check_within(pose, found, &Effort::of_pose())
    }

    /// The same with what `effort` allows, that of this pose.
    pub(in crate::contact) fn check_within(
        &self,
        pose: &Pose,
        found: &LostMotion,
        effort: &Effort,
    ) -> Result<(), Error> {
        // Teeth in the mate's body prove it by themselves, whatever touches.
        if found.solid {
            return Ok(());
        }
        let seen = self.check_rotations(pose, found, effort);
        if seen.is_err() && found.status() == Status::Jammed {
            let own = self.refined().lost_motion_within(pose, effort)?;
            if own.status() == Status::Jammed {
                return Ok(());
            }
        }
        seen
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

    /// Bears out the contact on one side.
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
        let seen = match contact {
            Some(contact) if contact.error > NARROW * pitch => {
                self.touches_within(pose, side, contact, effort)?
            }
            Some(contact) => self.touches(pose, side, contact, effort),
            None => self.touches_nothing(pose, side, effort)?,
        };
        seen.map_err(|reason| self.failed(pose, side, reason))
    }

    /// Whether all pairs on `side` are clear of each other a little more open than `contact`, or why not: what a section of helical gears is in which
    /// another one touches first.
    pub(crate) fn clears(
        &self,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        effort: &Effort,
    ) -> Result<(), String> {
        self.touching(pose, side, contact, effort).map(|_| ())
    }

    /// Clear when a little more open, touching when a little more closed.
    fn touches(
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

    /// Whether any pair touches when a little more closed; all are clear when a little more open.
    fn touching(
        &self,
        pose: &Pose,
        side: Side,
        contact: &Contact,
        effort: &Effort,
    ) -> Result<bool, String> {
        let assembly = self.kernel.teeth.assembly;
        let finest = finest_chord(assembly);
        let arm = contact.point - assembly.axis(assembly.free());
        let lever = arm.perp(&contact.normal).abs();
        let opening = side.sense() * (pose.free_rotation() - contact.rotation);
        let mut touching = false;
        let allowed = effort.left().saturating_mul(LOOKS_A_UNIT.into());
        let mut left = allowed.min(EFFORT.into()) as u32;
        let steps = steps_in_reach(assembly, pose);
        for problem in FlankProblem::all(&self.kernel.teeth, pose, side, steps) {
            // Clear polygons are 2δ apart, and a fillet's chords stand up to δ in front of it;
            // another δ and the rounding leave no doubt.
            let little = contact.error + (4.0 * finest + problem.rounding()) / lever;
            let openings = [opening + little, opening - little];
            let before = left;
            let seen = seen(&problem, openings, finest, touching, &mut left);
            effort.spend(u64::from((before - left) / LOOKS_A_UNIT) + 1);
            match seen {
                Seen::Clear => {}
                Seen::Touch => touching = true,
                Seen::Overlap => {
                    return Err(format!(
                        "tooth {} of the locked gear and tooth {} of the free one touch before the rotation {} rad",
                        problem.locked_tooth, problem.free_tooth, contact.rotation
                    ));
                }
                Seen::TooMuch => {
                    return Err(format!(
                        "the effort of a pose ended at tooth {} of the locked gear and tooth {} of the free one",
                        problem.locked_tooth, problem.free_tooth
                    ));
                }
            }
        }
        Ok(touching)
    }

    /// The polygons' own contact lies within a bound that says little: lands that stand on each other have next to no lever,
    /// and the bound on their rotation may be half a turn.
    fn touches_within(
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

    /// No pair in reach ever touches, or only by what rounding may bring the axes together.
    fn touches_nothing(
        &self,
        pose: &Pose,
        side: Side,
        effort: &Effort,
    ) -> Result<Result<(), String>, Error> {
        if !first_touching(&self.kernel.teeth, pose, side, effort)? {
            return Ok(Ok(()));
        };
        let here = self.kernel.teeth.assembly;
        let doubt = 4.0 * finest_chord(here)
            + FlankProblem::new(&self.kernel.teeth, pose, side, 0).rounding();
        let apart = here.at(here.center_distance() + doubt)?;
        Ok(
            if first_touching(&self.kernel.teeth.at(&apart), pose, side, effort)? {
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
    let problems: Vec<FlankProblem> = FlankProblem::facing(teeth, pose, side, steps).collect();
    Ok(!search(&problems, finest_chord(teeth.assembly), effort)?.is_empty())
}

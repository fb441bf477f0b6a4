//! The certificate: polygons bear out a rotation that another method found.
//!
//! A little more open than the rotation in question every pair of half teeth in reach
//! must be clear, proven by polygons that are cut again only where they are
//! within both chordal errors of each other; a little more closed one of them
//! must touch. "A little" is the result's own error bound and what the
//! finest polygons resolve. Nothing of the method under test is used but its answer.

use super::facing::Facing;
use super::far_land::FarLands;
use super::{CutHalf, PolygonKernel, finest_chord, steps_in_reach};
use crate::error::Error;
use crate::gear::Side;
use crate::mesh::lost_motion::{Contact, LostMotion};
use crate::pair::Pose;

/// Each re-cut is this much finer: some ten chords over the stretch in question (tuned: 1e-1 and 1e-2
/// take a tenth longer).
const FINER: f64 = 3e-2;

/// Checks rotations on the polygons of a kernel.
pub struct Certifier<'a> {
    kernel: PolygonKernel<'a>,
}

impl<'a> Certifier<'a> {
    /// A certifier on the polygons of `kernel`; coarse ones do.
    pub fn new(kernel: PolygonKernel<'a>) -> Certifier<'a> {
        Certifier { kernel }
    }

    /// Bears out both contacts of `found` at `pose`, or fails.
    ///
    /// # Errors
    /// [`Error::CertificateFailed`] with the pose that reproduces it; [`Error::ContactLost`] from a search.
    pub fn check(&self, pose: &Pose, found: &LostMotion) -> Result<(), Error> {
        for (side, contact) in [(Side::Right, &found.right), (Side::Left, &found.left)] {
            let seen = match contact {
                Some(contact) => self.touches(pose, side, contact),
                None => self.touches_nothing(pose, side)?,
            };
            seen.map_err(|reason| self.failed(pose, side, reason))?;
        }
        Ok(())
    }

    /// Clear when a little more open, touching when a little more closed.
    fn touches(&self, pose: &Pose, side: Side, contact: &Contact) -> Result<(), String> {
        let assembly = self.kernel.assembly;
        let finest = finest_chord(assembly);
        let arm = contact.point - assembly.axis(assembly.free());
        let lever = arm.perp(&contact.normal).abs();
        let opening = side.sense() * (pose.free_rotation() - contact.rotation);
        let mut touching = false;
        for steps in steps_in_reach(assembly, pose) {
            let far = FarLands::new(&self.kernel, pose, side, steps);
            let facing = Facing::new(&self.kernel, pose, side, steps, &far);
            // Clear polygons are 2δ apart, and a fillet's chords stand up to δ in front of it;
            // another δ and the rounding leave no doubt.
            let little = contact.error + (4.0 * finest + facing.rounding()) / lever;
            match seen(&facing, [opening + little, opening - little], finest) {
                Seen::Clear => {}
                Seen::Touch => touching = true,
                Seen::Overlap => {
                    return Err(format!(
                        "a pair {steps} teeth on touches before the rotation {} rad",
                        contact.rotation
                    ));
                }
            }
        }
        if touching {
            Ok(())
        } else {
            Err(format!(
                "nothing touches at the rotation {} rad",
                contact.rotation
            ))
        }
    }

    /// No pair in reach ever touches, or only by what rounding may bring the axes together.
    fn touches_nothing(&self, pose: &Pose, side: Side) -> Result<Result<(), String>, Error> {
        let Some((steps, doubt)) = first_touching(&self.kernel, pose, side)? else {
            return Ok(Ok(()));
        };
        let here = self.kernel.assembly;
        let apart = here.at(here.center_distance() + doubt)?;
        let apart = PolygonKernel {
            assembly: &apart,
            ..self.kernel
        };
        Ok(match first_touching(&apart, pose, side)? {
            None => Ok(()),
            Some(_) => Err(format!("a pair {steps} teeth on does touch")),
        })
    }

    fn failed(&self, pose: &Pose, side: Side, reason: String) -> Error {
        let mating = pose.mating();
        Error::CertificateFailed {
            wheel_tooth: mating.wheel_tooth,
            pinion_tooth: mating.pinion_tooth,
            flank: mating.flank.name(),
            fraction: mating.fraction,
            center_distance_mm: self.kernel.assembly.center_distance(),
            side: side.name(),
            reason,
        }
    }
}

/// The first pair whose polygons touch, and what they and rounding leave in doubt, mm.
fn first_touching(
    kernel: &PolygonKernel,
    pose: &Pose,
    side: Side,
) -> Result<Option<(i64, f64)>, Error> {
    let finest = finest_chord(kernel.assembly);
    for steps in steps_in_reach(kernel.assembly, pose) {
        let far = FarLands::new(kernel, pose, side, steps);
        let facing = Facing::new(kernel, pose, side, steps, &far);
        if facing.search(finest)?.is_some() {
            return Ok(Some((steps, 4.0 * finest + facing.rounding())));
        }
    }
    Ok(None)
}

/// What polygons see of a pair between two openings.
enum Seen {
    /// Clear of each other at both.
    Clear,
    /// Clear at the first, not proven clear at the second.
    Touch,
    /// Not proven clear at the first.
    Overlap,
}

/// Looks at `facing` at two openings, the wider first, by polygons down to `finest`.
///
/// Polygons are cut again where they are within both chordal errors of each other and of what a point
/// moves between the two openings; where nothing is, both openings are clear.
fn seen(facing: &Facing, [open, closed]: [f64; 2], finest: f64) -> Seen {
    let between = facing.reach() * (open - closed);
    let mut cut: Option<[CutHalf; 2]> = None;
    loop {
        let on = facing.on(&cut);
        let chord = on.chord();
        if chord <= finest {
            let near = |opening| on.near(opening, 2.0 * chord).is_some();
            return match (near(open), near(closed)) {
                (true, _) => Seen::Overlap,
                (false, true) => Seen::Touch,
                (false, false) => Seen::Clear,
            };
        }
        match on.near(open, 2.0 * chord + between) {
            None => return Seen::Clear,
            Some(near) => cut = Some(on.recut(near, (chord * FINER).max(finest))),
        }
    }
}

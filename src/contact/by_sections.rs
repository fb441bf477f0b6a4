//! The polygon method for a helical pair, section by section.
//!
//! It checks [`super::ExactKernel`] in the sections that hold the tightest of all pairs of involutes, and in those with
//! a contact or a jam. (Between them a tip can be in the mate's body over a short stretch where nothing touches first.)

use super::effort::Effort;
use super::lost_motion::{Contact, LostMotion, Status};
use super::over_face::{FoundOverFace, OverFace};
use super::polygon::{Certifier, CutPair};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Pose, section_at};

/// Effort of building a section, nodes, without its polygons (tuned: about 0.5 µs).
const SECTION: u64 = 2;

/// A helical pair, its gears cut into polygons.
pub(super) struct CutSections<'a> {
    pub assembly: &'a GearPair,
    pub cut: &'a CutPair,
    /// Places along the face, mm.
    pub places: Vec<f64>,
}

impl CutSections<'_> {
    /// Both contacts at `pose` by the polygon method, within the budget `effort` for all sections. It also examines the
    /// sections of `found`, the result of another method.
    ///
    /// # Errors
    /// As the polygon method.
    pub fn lost_motion(
        &self,
        pose: &Pose,
        found: Option<&FoundOverFace>,
        effort: &Effort,
    ) -> Result<LostMotion, Error> {
        let mut over = OverFace::default();
        let further = found.into_iter().flat_map(|found| {
            let touching = [found.lost_motion.right, found.lost_motion.left];
            let touching = touching.map(|contact| contact.map(|contact| contact.section));
            touching.into_iter().flatten().chain(found.jam)
        });
        for b in self.places.iter().copied().chain(further) {
            let (here, lost_motion) = self.in_section(pose, b, effort)?;
            over.add(b, &here, lost_motion);
            if over.is_solid() {
                break;
            }
        }
        let free = self.assembly.gear(self.assembly.free()).gear();
        let pitch = free.basic_data().angular_pitch();
        Ok(over.found(pose.free_rotation(), pitch).lost_motion)
    }

    /// Both contacts in the section at `b`, mm, at that section's pose of `pose`.
    fn in_section(
        &self,
        pose: &Pose,
        b: f64,
        effort: &Effort,
    ) -> Result<(Pose, LostMotion), Error> {
        let (section, here) = section_at(self.assembly, pose, b);
        let kernel = self.cut.refined_kernel(&section);
        effort.spend(SECTION);
        let found = kernel.lost_motion_within(&here, effort)?;
        Ok((here, found))
    }

    /// Confirms both contacts of `found`: each touches in its section, and all other sections are clear. For a jammed
    /// pose it is enough that one section jams. If `found` reports a jammed section, that section must jam.
    ///
    /// # Errors
    /// As [`Certifier::check`].
    pub fn check(&self, pose: &Pose, found: &FoundOverFace, effort: &Effort) -> Result<(), Error> {
        let lost_motion = &found.lost_motion;
        if lost_motion.status() == Status::Jammed {
            let own = self.lost_motion(pose, Some(found), effort)?;
            if own.status() == Status::Jammed {
                return Ok(());
            }
        }
        if let Some(b) = found.jam.filter(|_| lost_motion.solid) {
            let (section, _) = section_at(self.assembly, pose, b);
            let (here, own) = self.in_section(pose, b, effort)?;
            // The sign of the overlap may be uncertain.
            let is_open = own.angle().zip(own.error());
            if is_open.is_none_or(|(angle, bound)| angle.abs() > bound) {
                let certifier = Certifier::new(self.cut.kernel(&section));
                let reason = format!("the section at {b} mm is not jammed");
                return Err(certifier.failed(&here, Side::Right, reason));
            }
        }
        for (side, contact) in [
            (Side::Right, lost_motion.right),
            (Side::Left, lost_motion.left),
        ] {
            let at = contact.map(|contact| contact.section);
            let others = self.places.iter().copied().filter(|&b| Some(b) != at);
            for b in at.into_iter().chain(others) {
                let (section, here) = section_at(self.assembly, pose, b);
                let certifier = Certifier::new(self.cut.kernel(&section));
                effort.spend(SECTION);
                // The distance from the nominal rotation there is the same as here.
                let turned = here.free_rotation() - pose.free_rotation();
                let contact = contact.map(|contact| Contact {
                    rotation: contact.rotation + turned,
                    ..contact
                });
                match contact {
                    Some(contact) if Some(b) != at => {
                        certifier.touching(&here, side, &contact, effort)?;
                    }
                    contact => certifier.check_side(&here, side, contact.as_ref(), effort)?,
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::ExactKernel;
    use crate::error::go_on;
    use crate::gear::{Deviations, Face, GearDesign, Hand};
    use crate::pair::Mating;

    /// All sections of a face share one budget. If it is spent, neither method nor certificate has a result, and both report why.
    #[test]
    fn polygons_of_a_wide_face_end_by_the_effort_of_a_pose() {
        let gear = |hand, face| {
            let design = GearDesign::plain(20, 2.0).helical(30.0, hand);
            design.built(face, &Deviations::default())
        };
        let (wheel, pinion) = (
            gear(Hand::Right, Face::Front),
            gear(Hand::Left, Face::Front),
        );
        let cut = &CutPair::new(&wheel, &pinion, 1e-3);
        let distance = 40.0 / 30f64.to_radians().cos() + 0.1;
        let pair = GearPair::new(wheel, pinion, distance).unwrap();
        let pair = pair.with_face([-100.0, 100.0]).unwrap();
        let kernel = ExactKernel::new(&pair);
        let sections = CutSections {
            assembly: &pair,
            cut,
            places: kernel.sections(),
        };
        let pose = Pose::new(&pair, Mating::FIRST);
        let exact = kernel.found_within(&pose, &Effort::of_pose()).unwrap();
        let effort = Effort::of_pose();
        sections.lost_motion(&pose, Some(&exact), &effort).unwrap();
        let polygons = effort.used();
        sections.check(&pose, &exact, &effort).unwrap();
        // Every section costs its share: half of it is not enough for all.
        assert!(polygons > sections.places.len() as u64);
        for least in [1, polygons / 2] {
            let short = Effort::new(least, &go_on);
            let lost = sections.lost_motion(&pose, Some(&exact), &short);
            assert!(lost.unwrap_err().to_string().contains("effort"));
        }
        let short = Effort::new((effort.used() - polygons) / 2, &go_on);
        let failed = sections.check(&pose, &exact, &short).unwrap_err();
        assert!(failed.to_string().contains("effort"), "{failed}");
    }
}

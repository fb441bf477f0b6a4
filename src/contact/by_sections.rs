//! Polygons of a helical pair, section by section.
//!
//! A witness beside [`super::ExactKernel`]: in the sections that hold the tightest of all pairs of involutes, and in those in which a contact was found.

use super::lost_motion::{Contact, LostMotion, Status};
use super::over_face::OverFace;
use super::polygon::{Certifier, CutGear, PolygonKernel};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Pose};

/// A helical pair, its gears cut into polygons.
pub(super) struct Sections<'a> {
    pub assembly: &'a GearPair,
    pub cut: [&'a CutGear; 2],
    /// Where along the face, mm.
    pub places: Vec<f64>,
}

impl Sections<'_> {
    /// Both contacts at `pose` by the polygon method; `found` is what another method found, whose sections are looked at, too.
    ///
    /// # Errors
    /// As the polygon method.
    pub fn lost_motion(
        &self,
        pose: &Pose,
        found: Option<&LostMotion>,
    ) -> Result<LostMotion, Error> {
        let mut over = OverFace::default();
        let touching = found
            .into_iter()
            .flat_map(|found| [found.right, found.left]);
        let touching = touching.flatten().map(|contact| contact.section);
        for b in self.places.iter().copied().chain(touching) {
            let section = self.assembly.section(b);
            let here = pose.in_section(self.assembly, b);
            let [wheel, pinion] = self.cut;
            let kernel = PolygonKernel::refined(&section, wheel, pinion);
            over.take(b, &here, kernel.lost_motion(&here)?);
        }
        let free = self.assembly.gear(self.assembly.free()).gear();
        Ok(over.lost_motion(pose.free_rotation(), free.basic_data().angular_pitch()))
    }

    /// Bears out both contacts of `found`: each touches in its section, and all other sections are clear. A jammed pose has one that jams.
    ///
    /// # Errors
    /// As [`Certifier::check`].
    pub fn check(&self, pose: &Pose, found: &LostMotion) -> Result<(), Error> {
        if found.status() == Status::Jammed {
            let own = self.lost_motion(pose, Some(found))?;
            if own.status() == Status::Jammed {
                return Ok(());
            }
        }
        for (side, contact) in [(Side::Right, found.right), (Side::Left, found.left)] {
            let at = contact.map(|contact| contact.section);
            let others = self.places.iter().copied().filter(|&b| Some(b) != at);
            for b in at.into_iter().chain(others) {
                let section = self.assembly.section(b);
                let here = pose.in_section(self.assembly, b);
                let [wheel, pinion] = self.cut;
                let certifier = Certifier::new(PolygonKernel::new(&section, wheel, pinion));
                // As far from the nominal rotation there as here.
                let turned = here.free_rotation() - pose.free_rotation();
                let contact = contact.map(|contact| Contact {
                    rotation: contact.rotation + turned,
                    ..contact
                });
                match contact {
                    Some(contact) if Some(b) != at => certifier
                        .clears(&here, side, &contact)
                        .map_err(|reason| certifier.failed(&here, side, reason))?,
                    contact => certifier.check_side(&here, side, contact.as_ref())?,
                }
            }
        }
        Ok(())
    }
}

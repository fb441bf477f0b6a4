//! Polygons of a helical pair, section by section.
//!
//! A witness beside [`super::ExactKernel`]: in the sections that hold the tightest of all pairs of involutes, and in those in which a contact was found.

use super::effort::Effort;
use super::lost_motion::{Contact, LostMotion, Status};
use super::over_face::OverFace;
use super::polygon::{Certifier, CutGear, PolygonKernel};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Pose};

/// What a section takes beside its polygons, in units of effort (tuned: some 0.5 µs).
const SECTION: u64 = 2;

/// A helical pair, its gears cut into polygons.
pub(super) struct Sections<'a> {
    pub assembly: &'a GearPair,
    pub cut: [&'a CutGear; 2],
    /// Where along the face, mm.
    pub places: Vec<f64>,
}

impl Sections<'_> {
    /// Both contacts at `pose` by the polygon method, with what `effort` allows for all sections; `found` is what another method found, whose
    /// sections are looked at, too.
    ///
    /// # Errors
    /// As the polygon method.
    pub fn lost_motion(
        &self,
        pose: &Pose,
        found: Option<&LostMotion>,
        effort: &Effort,
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
            effort.spend(SECTION);
            over.take(b, &here, kernel.lost_motion_within(&here, effort)?);
        }
        let free = self.assembly.gear(self.assembly.free()).gear();
        Ok(over.lost_motion(pose.free_rotation(), free.basic_data().angular_pitch()))
    }

    /// Bears out both contacts of `found`: each touches in its section, and all other sections are clear. A jammed pose has one that jams.
    ///
    /// # Errors
    /// As [`Certifier::check`].
    pub fn check(&self, pose: &Pose, found: &LostMotion, effort: &Effort) -> Result<(), Error> {
        if found.status() == Status::Jammed {
            let own = self.lost_motion(pose, Some(found), effort)?;
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
                effort.spend(SECTION);
                // As far from the nominal rotation there as here.
                let turned = here.free_rotation() - pose.free_rotation();
                let contact = contact.map(|contact| Contact {
                    rotation: contact.rotation + turned,
                    ..contact
                });
                match contact {
                    Some(contact) if Some(b) != at => certifier
                        .clears(&here, side, &contact, effort)
                        .map_err(|reason| certifier.failed(&here, side, reason))?,
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
    use crate::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign, Hand};
    use crate::pair::Mating;

    /// All sections of a face share one effort: where it is spent neither method nor certificate says anything, and both say why.
    #[test]
    fn polygons_of_a_wide_face_end_by_the_effort_of_a_pose() {
        let gear = |hand, face| {
            let data = BasicGearData::new(20, 2.0, 20f64.to_radians()).unwrap();
            let data = data.with_helix(30f64.to_radians(), hand).unwrap();
            AsBuilt::perfect(Gear::nominal(GearDesign::standard(data)).unwrap(), face)
        };
        let gears = [
            gear(Hand::Right, Face::Front),
            gear(Hand::Left, Face::Front),
        ];
        let [wheel, pinion] = &gears;
        let cut = [wheel, pinion].map(|gear| CutGear::new(gear, 1e-3));
        let distance = 40.0 / 30f64.to_radians().cos() + 0.1;
        let pair = GearPair::new(wheel.clone(), pinion.clone(), distance).unwrap();
        let pair = pair.with_face([-100.0, 100.0]).unwrap();
        let kernel = ExactKernel::new(&pair);
        let sections = Sections {
            assembly: &pair,
            cut: [&cut[0], &cut[1]],
            places: kernel.sections(),
        };
        let pose = Pose::new(&pair, Mating::FIRST);
        let exact = kernel.lost_motion(&pose).unwrap();
        let effort = Effort::of_pose();
        let polygon = sections.lost_motion(&pose, Some(&exact), &effort).unwrap();
        let polygons = effort.used();
        sections.check(&pose, &exact, &effort).unwrap();
        let both = [&exact, &polygon].map(|found| found.angle().unwrap());
        let bounds = exact.error().unwrap() + polygon.error().unwrap();
        assert!((both[0] - both[1]).abs() <= bounds, "{both:?}");
        // Every section costs its share: half of it is not enough for all.
        assert!(polygons > sections.places.len() as u64);
        for least in [1, polygons / 2] {
            let short = Effort::new(least);
            let lost = sections.lost_motion(&pose, Some(&exact), &short);
            assert!(lost.unwrap_err().to_string().contains("effort"));
        }
        let short = Effort::new((effort.used() - polygons) / 2);
        let failed = sections.check(&pose, &exact, &short).unwrap_err();
        assert!(failed.to_string().contains("effort"), "{failed}");
    }
}

//! One transverse section of helical gears, as they stand in contact over their common face: what pictures of helical pairs draw.
//!
//! Where over the face teeth touch is [`Field`](crate::analysis::curves::Field), what the width costs [`crate::analysis::face_width`].

use super::lost_motion::LostMotion;
use super::pose_result::PoseResult;
use crate::error::{Error, GearError};
use crate::gear::Side;
use crate::outline::AssembledPair;
use crate::pair::{GearPair, Pose};
use std::f64::consts::TAU;

/// The teeth of a helical pair in one transverse section, at a pose whose contacts over the common face are known.
///
/// The free gear stands where it is held over the whole face: in a section where nothing touches a gap is left.
#[derive(Debug, Clone)]
pub struct MeshSection {
    at: f64,
    pair: AssembledPair,
    pose: Pose,
    alone: Option<LostMotion>,
    held: Option<f64>,
}

impl MeshSection {
    /// The section of `assembly` at `at`, mm along the axis from the measuring plane, at `pose`; `over_face` is what was found at
    /// it over the common face, `None` where that is not proven.
    ///
    /// # Errors
    /// [`GearError::OutsideFace`] beyond the common face.
    pub fn new(
        assembly: &GearPair,
        pose: &Pose,
        over_face: Option<&LostMotion>,
        at: f64,
    ) -> Result<MeshSection, Error> {
        let [from_mm, to_mm] = assembly.face();
        if !(from_mm..=to_mm).contains(&at) {
            return Err(Error::Gear(GearError::OutsideFace {
                at_mm: at,
                from_mm,
                to_mm,
            }));
        }
        let (pair, here) = (assembly.section(at), pose.in_section(assembly, at));
        let alone = match over_face {
            Some(_) => pair.lost_motion(*here.mating())?.found.ok(),
            None => None,
        };
        let flank = pose.mating().flank;
        let on = |found: &LostMotion| match flank {
            Side::Right => found.right,
            Side::Left => found.left,
        };
        let contact = over_face.and_then(|found| found.angle().and(on(found)));
        let held = contact.map(|contact| {
            // As far from the nominal rotation there as here.
            let rotation = here.free_rotation() + (contact.rotation - pose.free_rotation());
            let touching = alone.as_ref().and_then(on).map(|alone| {
                let off = rotation - alone.rotation;
                let off = off - TAU * (off / TAU).round();
                (off.abs() <= contact.error + alone.error, alone.rotation)
            });
            match touching {
                Some((true, touching)) => touching,
                _ => rotation,
            }
        });
        Ok(MeshSection {
            at,
            pair: pair.into(),
            pose: here,
            alone,
            held,
        })
    }

    /// The section in which the flank of a pose of `assembly` touches; `None` of spur gears, whose sections are all alike.
    ///
    /// # Errors
    /// None: it lies on the common face.
    pub fn binding(assembly: &GearPair, pose: &PoseResult) -> Result<Option<MeshSection>, Error> {
        if !assembly.is_helical() {
            return Ok(None);
        }
        let found = pose.proven();
        let at = MeshSection::of_contact(assembly, &pose.pose, found);
        MeshSection::new(assembly, &pose.pose, found, at).map(Some)
    }

    /// Where the flank of `pose` touches over the face of `assembly`, mm; without contact the place of the face nearest to the measuring plane.
    pub fn of_contact(assembly: &GearPair, pose: &Pose, over_face: Option<&LostMotion>) -> f64 {
        let contact = over_face.and_then(|found| match pose.mating().flank {
            Side::Right => found.right,
            Side::Left => found.left,
        });
        let [from, to] = assembly.face();
        contact.map_or(0f64.clamp(from, to), |contact| contact.section)
    }

    /// Where it is, mm along the axis from the measuring plane, away from the viewer.
    pub fn at(&self) -> f64 {
        self.at
    }

    /// The pair of this section alone.
    pub fn pair(&self) -> &AssembledPair {
        &self.pair
    }

    /// The pose in it, which names the teeth that are in mesh there.
    pub fn pose(&self) -> &Pose {
        &self.pose
    }

    /// What the teeth of this section would allow by themselves; `None` where it is not proven.
    pub fn alone(&self) -> Option<&LostMotion> {
        self.alone.as_ref()
    }

    /// Rotation of the free gear, rad, at which some section holds it on the pose's flank; `None` without a lost motion.
    pub fn held(&self) -> Option<f64> {
        self.held
    }
}

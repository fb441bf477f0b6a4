//! One transverse section of helical gears at their contact over the common face, for pictures of helical pairs.
//!
//! [`Field`](crate::analysis::curves::Field) shows where over the face teeth touch, and [`crate::analysis::face_width`]
//! the effect of the face width.

use super::lost_motion::LostMotion;
use super::pose_result::PoseResult;
use super::sweep::lost_motion_at;
use crate::error::{Error, GearError};
use crate::outline::AssembledPair;
use crate::pair::{GearPair, Pose, section_at};
use std::f64::consts::TAU;

/// The teeth of a helical pair in one transverse section, at a pose with known contacts over the common face.
///
/// The whole face determines the rotation of the free gear. A section without contact has a gap.
#[derive(Debug, Clone)]
pub struct MeshSection {
    at: f64,
    pair: AssembledPair,
    pose: Pose,
    alone: Option<LostMotion>,
    held: Option<f64>,
}

impl MeshSection {
    /// The section of `assembly` at `at`, mm along the axis from the measuring plane, at `pose`. `over_face` is the
    /// result over the common face, `None` if unproven.
    ///
    /// # Errors
    /// [`GearError::OutsideFace`] outside the common face.
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
        let (pair, here) = section_at(assembly, pose, at);
        let alone = match over_face {
            Some(_) => lost_motion_at(&pair.clone().into(), *here.mating())?
                .found
                .ok(),
            None => None,
        };
        let flank = pose.mating().flank;
        let on = |found: &LostMotion| found.on(flank);
        let contact = over_face.and_then(|found| found.angle().and(on(found)));
        let held = contact.map(|contact| {
            // The distance from the nominal rotation there is the same as here.
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

    /// The section in which the flank of a pose of `assembly` touches; `None` for spur gears, whose sections are all equal.
    ///
    /// # Errors
    /// None: the section is on the common face.
    pub fn binding(
        assembly: &AssembledPair,
        pose: &PoseResult,
    ) -> Result<Option<MeshSection>, Error> {
        let pair = assembly.data().filter(|pair| pair.varies_along_face());
        let Some(assembly) = pair else {
            return Ok(None);
        };
        let found = pose.proven();
        let at = MeshSection::of_contact(assembly, &pose.pose, found);
        MeshSection::new(assembly, &pose.pose, found, at).map(Some)
    }

    /// Place over the face of `assembly` where the flank of `pose` touches, mm; without contact the place nearest to the measuring plane. Teeth
    /// that lean can touch a little beyond the common face: then its end.
    pub fn of_contact(assembly: &GearPair, pose: &Pose, over_face: Option<&LostMotion>) -> f64 {
        let contact = over_face.and_then(|found| found.on(pose.mating().flank));
        let [from, to] = assembly.face();
        contact
            .map_or(0.0, |contact| contact.section)
            .clamp(from, to)
    }

    /// Its place along the axis from the measuring plane, mm, away from the viewer.
    pub fn at(&self) -> f64 {
        self.at
    }

    /// The pair of this section alone.
    pub fn pair(&self) -> &AssembledPair {
        &self.pair
    }

    /// The pose in this section, which names the teeth in mesh there.
    pub fn pose(&self) -> &Pose {
        &self.pose
    }

    /// The lost motion of this section alone; `None` if unproven.
    pub fn alone(&self) -> Option<&LostMotion> {
        self.alone.as_ref()
    }

    /// Rotation of the free gear, rad, at which some section stops it on the pose's flank; `None` without a lost motion.
    pub fn held(&self) -> Option<f64> {
        self.held
    }
}

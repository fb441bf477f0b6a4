//! Pairs of which one gear at least is an outline: lost motion through the whole mesh cycle, where it binds, where it turns freely.
//!
//! Nothing bounds the lost motion of any curves between two poses, so extremes are those of sampled poses and of more round the best, and
//! say so; each pose itself is proven ([`crate::contact::OutlineKernel`]), and checked by polygons ([`crate::contact::OutlineCertifier`]).

mod cycle;
mod map;
mod required;
mod turns_from;

pub use cycle::OutlinePose;
pub use map::{OUTLINE_MAP_ROWS, OutlineMap};
pub use turns_from::TurnsFrom;

use super::requirement::Requirements;
use super::study::Material;
use crate::contact::{OutlineCertifier, OutlineKernel, Status};
use crate::error::Error;
use crate::outline::{OutlineGear, OutlinePair};
use crate::pair::{BacklashUnit, Mating, Member, SweepPlan};
use cycle::Cycle;
use std::ops::ControlFlow;

/// What is asked of two gears.
#[derive(Debug, Clone)]
pub struct OutlineStudy {
    /// Shown in results and pictures.
    pub title: String,
    /// Wheel and pinion of each material: of gears by their data these may be two.
    pub materials: Vec<(Material, OutlineGear, OutlineGear)>,
    /// The gear that stands still.
    pub locked: Member,
    /// Centre distances `a`, mm, ascending.
    pub center_distances: Vec<f64>,
    /// The mating of the first pose.
    pub start: Mating,
    /// Poses a pitch.
    pub steps_per_pitch: u32,
    /// What it must keep: of `j_wt`, lost motions and radial clearance.
    pub requirements: Requirements,
}

impl OutlineStudy {
    /// How many steps [`OutlineStudy::runs`] counts: the poses of all runs. (Where a pair binds, as many again some times, uncounted.)
    pub fn steps(&self) -> u64 {
        let poses = |(_, wheel, pinion): &(Material, OutlineGear, OutlineGear)| {
            let matings = SweepPlan::hunting_pitches(wheel.teeth(), pinion.teeth());
            Cycle::new(matings, self.steps_per_pitch).poses()
        };
        let all: u64 = self.materials.iter().map(poses).sum();
        all * self.center_distances.len() as u64
    }

    /// Lost motion in arcmin at a gear: its part of the centre distance is that of its teeth.
    pub fn arcmin(&self, at: Member) -> Option<BacklashUnit> {
        let (_, wheel, pinion) = self.materials.first()?;
        let [wheel, pinion] = [wheel, pinion].map(|gear| f64::from(gear.teeth()));
        let own = match at {
            Member::Wheel => wheel,
            Member::Pinion => pinion,
        };
        let share = own / (wheel + pinion);
        Some(BacklashUnit::Arcmin { at, share })
    }

    /// Every centre distance and material, in order; where `certify`, polygons bear out each pose that is kept.
    ///
    /// # Errors
    /// [`Error::Outline`]: a centre distance at which a gear reaches over an axis; `tick` asked to stop.
    pub fn runs(
        &self,
        certify: bool,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Vec<OutlineRun>, Error> {
        let mut runs = Vec::new();
        for &distance in &self.center_distances {
            for (material, wheel, pinion) in &self.materials {
                let pair = OutlinePair::new(wheel.clone(), pinion.clone(), distance, self.locked)?;
                runs.push(OutlineRun::new(*material, pair, self, certify, tick)?);
            }
        }
        Ok(runs)
    }
}

/// One centre distance and material, through the whole mesh cycle.
#[derive(Debug, Clone)]
pub struct OutlineRun {
    /// Which thickness.
    pub material: Material,
    /// As assembled.
    pub pair: OutlinePair,
    /// Matings of the cycle: lcm(z_1, z_2).
    pub matings: u64,
    /// Whether polygons bear out its poses.
    pub certified: bool,
    /// Sampled poses, in order.
    pub poses: Vec<OutlinePose>,
    /// The pose with the least lost motion that was found, one more closely looked at included; `None` where a pose is jammed.
    pub least: Option<OutlinePose>,
    /// With the greatest; `None` where a pose is out of mesh.
    pub greatest: Option<OutlinePose>,
    /// A pose that is jammed, out of mesh or not settled, in this order.
    pub lost: Option<OutlinePose>,
    /// Where the pair does not turn: from which centre distance on it does, found by the same poses; `None` where none was found.
    pub turns_from: Option<TurnsFrom>,
}

impl OutlineRun {
    fn new(
        material: Material,
        pair: OutlinePair,
        study: &OutlineStudy,
        certify: bool,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<OutlineRun, Error> {
        let teeth = |member| pair.gear(member).teeth();
        let matings = SweepPlan::hunting_pitches(teeth(Member::Wheel), teeth(Member::Pinion));
        let cycle = Cycle::new(matings, study.steps_per_pitch);
        let kernel = OutlineKernel::new(&pair);
        let certifier = certify.then(|| OutlineCertifier::new(&kernel));
        let by = (&kernel, certifier.as_ref());
        let poses = cycle.sampled(by, &pair, &study.start, tick)?;
        let extremes = cycle.extremes(&kernel, &pair, &poses);
        let [least, greatest] =
            extremes.map(|pose| pose.map(|pose| pose.certified(certifier.as_ref())));
        let closer = || least.iter().chain(&greatest);
        let first = |status| {
            let mut all = poses.iter().chain(closer());
            all.find(|pose| pose.status() == status)
        };
        let lost = [Status::Jammed, Status::NoContact, Status::Unproven]
            .into_iter()
            .find_map(first);
        let (lost, jams) = (lost.cloned(), first(Status::Jammed).is_some());
        let apart = first(Status::NoContact).is_some();
        let proven = |pose: &OutlinePose| pose.found.is_ok();
        let mut run = OutlineRun {
            material,
            matings,
            certified: certify,
            least: least.filter(|least| !jams && proven(least)),
            greatest: greatest.filter(|greatest| !apart && proven(greatest)),
            lost,
            turns_from: None,
            poses,
            pair: pair.clone(),
        };
        if run.turns() == Some(false) {
            run.turns_from = turns_from::find(&run, &kernel, &cycle, &study.start)?;
        }
        Ok(run)
    }

    /// The zero-backlash distance: from which centre distance on it turns, be that above its own (known where it binds) or below; `None` where none
    /// was found.
    ///
    /// # Errors
    /// [`Error::Outline`].
    pub fn zero_backlash(&self, study: &OutlineStudy) -> Result<Option<TurnsFrom>, Error> {
        if self.turns() != Some(true) {
            return Ok(self.turns_from.clone());
        }
        let cycle = Cycle::new(self.matings, study.steps_per_pitch);
        turns_from::find(self, &OutlineKernel::new(&self.pair), &cycle, &study.start)
    }

    /// Whether it turns through the whole cycle: of the poses looked at none overlaps; `None` where it is out of mesh or not settled.
    pub fn turns(&self) -> Option<bool> {
        if self.poses.iter().chain(&self.least).any(OutlinePose::binds) {
            return Some(false);
        }
        self.lost.is_none().then_some(true)
    }

    /// The wheel teeth that bind, each with the pose at which it binds most; the tightest first.
    pub fn binding_teeth(&self) -> Vec<(u32, &OutlinePose)> {
        let mut worst: Vec<(u32, &OutlinePose)> = Vec::new();
        let poses = self.poses.iter().chain(&self.least);
        for pose in poses.filter(|pose| pose.binds()) {
            let contacts = pose.contacts().into_iter().flatten();
            let mut teeth: Vec<u32> = contacts.map(|contact| contact.wheel.tooth).collect();
            if teeth.is_empty() {
                teeth.push(pose.mating.wheel_tooth);
            }
            for tooth in teeth {
                match worst.iter_mut().find(|(known, _)| *known == tooth) {
                    Some((_, known)) if pose.room() < known.room() => *known = pose,
                    Some(_) => (),
                    None => worst.push((tooth, pose)),
                }
            }
        }
        worst.sort_by(|a, b| a.1.room().total_cmp(&b.1.room()).then(a.0.cmp(&b.0)));
        worst
    }

    /// How many of its sampled poses end so.
    pub fn count(&self, status: Status) -> usize {
        let poses = self.poses.iter();
        poses.filter(|pose| pose.status() == status).count()
    }
}

/// Whether all turn; of several, one that binds decides, then one of which nothing is known.
pub fn turns(runs: &[OutlineRun]) -> Option<bool> {
    let each = runs.iter().map(OutlineRun::turns);
    let first = each.min_by_key(|turns| match turns {
        Some(false) => 0,
        None => 1,
        Some(true) => 2,
    });
    first.flatten()
}

/// How many of the sampled poses are not settled.
pub fn unproven(runs: &[OutlineRun]) -> usize {
    runs.iter().map(|run| run.count(Status::Unproven)).sum()
}

/// The pose with the greatest backlash, and its run.
pub fn greatest(runs: &[OutlineRun]) -> Option<(&OutlineRun, &OutlinePose)> {
    let poses = runs
        .iter()
        .filter_map(|run| Some((run, run.greatest.as_ref()?)));
    poses.min_by(|a, b| b.1.room().total_cmp(&a.1.room()))
}

/// The pose that binds most, or has the least backlash, and its run.
pub fn worst(runs: &[OutlineRun]) -> Option<(&OutlineRun, &OutlinePose)> {
    let poses = runs.iter().filter_map(|run| {
        let jammed = run.lost.iter().find(|pose| pose.status() == Status::Jammed);
        Some((run, jammed.or(run.least.as_ref())?))
    });
    poses.min_by(|a, b| a.1.room().total_cmp(&b.1.room()))
}

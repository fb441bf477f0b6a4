//! Sampled poses of a mesh cycle, and more round the best of them.

use crate::contact::{
    OutlineCertifier, OutlineContact, OutlineDoubt, OutlineKernel, OutlineLostMotion, Status,
};
use crate::error::Error;
use crate::outline::OutlinePair;
use crate::pair::Mating;
use crate::parallel;
use std::ops::ControlFlow;

/// Poses of a cycle at most (tuned: some seconds); longer cycles are sampled more thinly, every mating still once up to here.
const MOST: u64 = 100_000;

/// Poses handed out at once.
const BLOCK: usize = 1024;

/// Sampled poses that are looked at more closely, at either end.
const BEST: usize = 6;

/// Times the neighbourhood of such a pose is cut into a quarter: down to 1/16 000 of a step.
const ROUNDS: u32 = 7;

/// One pose of two outlines.
#[derive(Debug, Clone)]
pub struct OutlinePose {
    /// Pitches from the first pose.
    pub pitches: f64,
    /// Which teeth mate.
    pub mating: Mating,
    /// Its contacts, or why they are not proven.
    pub found: Result<OutlineLostMotion, OutlineDoubt>,
    /// Circumferential backlash `j_wt`, mm, an arc of the operating pitch circles, and the bound on its error; `None` where jammed, out of
    /// mesh or not settled.
    pub j_wt: Option<(f64, f64)>,
}

impl OutlinePose {
    /// The pose of `mating`, so many pitches from the first one.
    fn new(
        kernel: &OutlineKernel,
        pair: &OutlinePair,
        mating: Mating,
        pitches: f64,
    ) -> OutlinePose {
        let found = kernel
            .lost_motion_at(pair, &mating)
            .map_err(OutlineDoubt::from);
        let radius = pair.operating_pitch_radius(pair.free());
        let j_wt = found.as_ref().ok().and_then(|found| {
            let (angle, error) = found.angle().zip(found.error())?;
            Some((angle * radius, error * radius))
        });
        OutlinePose {
            pitches,
            mating,
            found,
            j_wt,
        }
    }

    /// The pose of `mating`, by itself.
    pub fn of(pair: &OutlinePair, mating: Mating) -> OutlinePose {
        OutlinePose::new(&OutlineKernel::new(pair), pair, mating, 0.0)
    }

    /// The same, checked by polygons where `certifier` is given: a pose they refuse is not proven.
    #[must_use]
    pub(super) fn certified(self, certifier: Option<&OutlineCertifier>) -> OutlinePose {
        let seen = certifier.zip(self.found.as_ref().ok());
        match seen.map(|(certifier, found)| certifier.check(&self.mating, found)) {
            Some(Err(reason)) => OutlinePose {
                found: Err(reason.into()),
                j_wt: None,
                ..self
            },
            _ => self,
        }
    }

    /// How it ended.
    pub fn status(&self) -> Status {
        match &self.found {
            Ok(found) => found.status(),
            Err(_) => Status::Unproven,
        }
    }

    /// Lost motion, rad.
    pub fn angle(&self) -> Option<f64> {
        self.found.as_ref().ok()?.angle()
    }

    /// Its contacts on right and left flanks.
    pub fn contacts(&self) -> [Option<OutlineContact>; 2] {
        let found = self.found.as_ref().ok();
        found.map_or([None; 2], |found| [found.right, found.left])
    }

    /// Whether it overlaps.
    pub fn binds(&self) -> bool {
        matches!(self.status(), Status::Interference | Status::Jammed)
    }

    /// The room it has, rad: its lost motion; below all where it has none, as jammed.
    pub fn room(&self) -> f64 {
        self.angle().unwrap_or(f64::NEG_INFINITY)
    }
}

/// How a cycle is sampled.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cycle {
    matings: u64,
    per_pitch: u32,
}

impl Cycle {
    pub fn new(matings: u64, per_pitch: u32) -> Cycle {
        Cycle { matings, per_pitch }
    }

    pub fn poses(&self) -> u64 {
        (self.matings * u64::from(self.per_pitch)).min(MOST)
    }

    /// Pitches from the first pose to each sampled one.
    fn places(&self) -> impl Iterator<Item = f64> {
        let poses = self.poses();
        let apart = self.matings as f64 / poses as f64;
        (0..poses).map(move |k| k as f64 * apart)
    }

    pub fn pose(
        kernel: &OutlineKernel,
        pair: &OutlinePair,
        start: &Mating,
        pitches: f64,
    ) -> OutlinePose {
        let beyond = start.fraction + pitches;
        let whole = beyond.floor();
        // A little before the first pose is the end of the cycle.
        let mating = Mating {
            fraction: beyond - whole,
            ..pair.onward(start, whole as i64)
        };
        OutlinePose::new(kernel, pair, mating, pitches)
    }

    /// All sampled poses of `pair`, whose gears are the kernel's; `certifier`, where it is to bear them out, of a kernel of the same pair.
    pub fn sampled(
        &self,
        (kernel, certifier): (&OutlineKernel, Option<&OutlineCertifier>),
        pair: &OutlinePair,
        start: &Mating,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Vec<OutlinePose>, Error> {
        let places: Vec<f64> = self.places().collect();
        let mut poses = Vec::with_capacity(places.len());
        for block in places.chunks(BLOCK) {
            let found = parallel::map(block.iter().copied(), |pitches| {
                let go_on = tick().is_continue();
                go_on.then(|| Cycle::pose(kernel, pair, start, pitches).certified(certifier))
            });
            for pose in found {
                poses.push(pose.ok_or(Error::Interrupted)?);
            }
        }
        Ok(poses)
    }

    /// The poses with the least and the greatest lost motion of `poses` and of more round the best of them.
    pub fn extremes(
        &self,
        kernel: &OutlineKernel,
        pair: &OutlinePair,
        poses: &[OutlinePose],
    ) -> [Option<OutlinePose>; 2] {
        let Some(first) = poses.first() else {
            return [None, None];
        };
        let step = self.matings as f64 / poses.len() as f64;
        [1.0, -1.0].map(|sign| {
            let value = |pose: &OutlinePose| pose.angle().map(|angle| sign * angle);
            let order = |a: &OutlinePose, b: &OutlinePose| {
                value(a)
                    .partial_cmp(&value(b))
                    .unwrap_or(std::cmp::Ordering::Equal)
            };
            let mut best: Vec<&OutlinePose> =
                poses.iter().filter(|pose| value(pose).is_some()).collect();
            best.sort_by(|a, b| order(a, b));
            best.truncate(BEST);
            let closer = parallel::map(best, |pose| {
                let (mut found, mut width) = (pose.clone(), step);
                for _ in 0..ROUNDS {
                    let middle = found.pitches;
                    for part in [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0] {
                        let pitches = middle + part * 0.25 * width;
                        let near = Cycle::pose(kernel, pair, &first.mating, pitches);
                        if value(&near)
                            .is_some_and(|near| value(&found).is_none_or(|best| near < best))
                        {
                            found = near;
                        }
                    }
                    width *= 0.25;
                }
                found
            });
            closer.into_iter().min_by(order)
        })
    }
}

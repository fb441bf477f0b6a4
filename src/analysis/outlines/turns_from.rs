//! From which centre distance on a pair of outlines turns through its cycle.
//!
//! At a distance the tightest pose binds; a distance at which that pose is free is found by growing steps and halving, and the cycle looked at there: where
//! another pose binds it is the tightest next. A few rounds end at a distance at which none does.

use super::OutlineRun;
use super::cycle::{Cycle, OutlinePose};
use crate::contact::{OutlineKernel, Status};
use crate::error::Error;
use crate::pair::{Mating, Member};
use std::ops::ControlFlow;

/// Rounds at most: each rules out a pose that bound.
const ROUNDS: u32 = 40;

/// The distance is found to within this, mm: a tenth of what is shown.
const WIDTH: f64 = 1e-5;

/// First step towards a greater distance, mm: what many pairs are short of (tuned).
const FIRST_STEP: f64 = 0.01;

/// A centre distance from which on a pair turns.
#[derive(Debug, Clone)]
pub struct TurnsFrom {
    /// A distance, mm, at which no pose looked at binds.
    pub high: f64,
    /// One at most 1e-5 mm below, at which `pose` binds.
    pub low: f64,
    /// The pose that binds last.
    pub pose: OutlinePose,
}

/// The distance from which on the pair of `run`, which binds, turns, its gears those of the kernel; `None` where it binds until tips pass each other, or a pose is not settled.
pub(super) fn find(
    run: &OutlineRun,
    kernel: &OutlineKernel,
    cycle: &Cycle,
    start: &Mating,
) -> Result<Option<TurnsFrom>, Error> {
    let pair = &run.pair;
    let apart: f64 = [Member::Wheel, Member::Pinion]
        .map(|member| pair.gear(member).reach())
        .iter()
        .sum();
    let tightest = |poses: &[OutlinePose]| {
        let binding = poses.iter().filter(|pose| pose.binds());
        let tightest = binding.min_by(|a, b| a.room().total_cmp(&b.room()));
        tightest.cloned()
    };
    let least = run.least.iter().filter(|pose| pose.binds()).cloned();
    let mut next = least.chain(tightest(&run.poses)).next();
    let mut found: Option<TurnsFrom> = None;
    let mut floor = pair.center_distance();
    for _ in 0..ROUNDS {
        let Some(pose) = next else {
            return Ok(found);
        };
        let binds_at = |distance: f64| -> Result<bool, Error> {
            let there = pair.at(distance)?;
            Ok(Cycle::pose(kernel, &there, start, pose.pitches).binds())
        };
        // In growing steps: the nearest distance at which it is free, not one where tips pass each other.
        let (mut low, mut step) = (floor, FIRST_STEP);
        let mut high = low + step;
        while binds_at(high)? {
            if high > apart {
                return Ok(None);
            }
            step *= 2.0;
            (low, high) = (high, high + step);
        }
        while high - low > WIDTH {
            let middle = 0.5 * (low + high);
            match binds_at(middle)? {
                true => low = middle,
                false => high = middle,
            }
        }
        floor = high;
        let there = pair.at(high)?;
        let poses = cycle.sampled(kernel, &there, start, &|| ControlFlow::Continue(()))?;
        // Out of mesh it does not turn the mate, and of a pose that is not settled nobody knows.
        let is_lost =
            |pose: &OutlinePose| matches!(pose.status(), Status::NoContact | Status::Unproven);
        if poses.iter().any(is_lost) {
            return Ok(None);
        }
        let [closest, _] = cycle.extremes(kernel, &there, &poses);
        next = closest
            .filter(OutlinePose::binds)
            .or_else(|| tightest(&poses));
        found = Some(TurnsFrom { high, low, pose });
    }
    Ok(None)
}

//! From which centre distance on a pair of outlines turns through its cycle.
//!
//! Where the tightest pose of a distance begins to bind is found by growing steps and halving, and the cycle looked at there: where another pose binds
//! it is the tightest next. A few rounds end at a distance at which none does.

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

impl TurnsFrom {
    /// The distance as it is reported: rounded up to 1e-4 mm, so that it turns there.
    pub fn rounded(&self) -> f64 {
        (self.high * 1e4).ceil() * 1e-4
    }
}

/// The distance from which on the pair of `run` turns, its gears those of the kernel: above its own where it binds, else below; `None` where
/// it is out of mesh, where it binds until tips pass each other, or where a pose is not settled.
pub(super) fn find(
    run: &OutlineRun,
    kernel: &OutlineKernel,
    cycle: &Cycle,
    start: &Mating,
) -> Result<Option<TurnsFrom>, Error> {
    let pair = &run.pair;
    let apart: f64 = Member::BOTH
        .map(|member| pair.gear(member).reach())
        .iter()
        .sum();
    let tightest = |poses: &[OutlinePose]| {
        let binding = poses.iter().filter(|pose| pose.binds());
        let tightest = binding.min_by(|a, b| a.room().total_cmp(&b.room()));
        tightest.cloned()
    };
    let mut next = match run.turns() {
        Some(true) => run.least.clone(),
        Some(false) => {
            let least = run.least.iter().filter(|pose| pose.binds()).cloned();
            least.chain(tightest(&run.poses)).next()
        }
        None => return Ok(None),
    };
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
        let within = [pair.least_distance(), apart];
        let Some([mut low, mut high]) = bracket(&binds_at, floor, within)? else {
            return Ok(None);
        };
        while high - low > WIDTH {
            let middle = 0.5 * (low + high);
            match binds_at(middle)? {
                true => low = middle,
                false => high = middle,
            }
        }
        floor = high;
        let there = pair.at(high)?;
        let poses = cycle.sampled((kernel, None), &there, start, &|| ControlFlow::Continue(()))?;
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

/// Two distances, mm, at the lower of which a pose binds and at the upper not: upwards of `from` where it binds there, else downwards, in growing
/// steps, so that it is the nearest such place and not one where tips pass each other. `None`: there is none within these ends.
fn bracket(
    binds_at: &dyn Fn(f64) -> Result<bool, Error>,
    from: f64,
    [nearest, farthest]: [f64; 2],
) -> Result<Option<[f64; 2]>, Error> {
    let binds = binds_at(from)?;
    let mut step = if binds { FIRST_STEP } else { -FIRST_STEP };
    let mut last = from;
    while nearest < last + step && last <= farthest {
        let next = last + step;
        if binds_at(next)? != binds {
            return Ok(Some([last.min(next), last.max(next)]));
        }
        (last, step) = (next, 2.0 * step);
    }
    Ok(None)
}

//! Extremes of a pair with a drawn gear: those of sampled poses of its mesh cycle, and of more round the best of them.
//!
//! Nothing bounds the lost motion of arbitrary curves between two poses. Each pose is right within its own error ([`OutlineKernel`]).
//!
//! The centre distance from which the pair assembles is found by the tightest pose: where it begins to interfere is bracketed, and the cycle is
//! sampled there. Where another pose interferes, that is the tightest next. A few rounds end at a distance at which none does.

use super::assembles_from::AssemblesFrom;
use crate::contact::{Doubt, Extreme, Extremes, OutlineKernel, Status};
use crate::error::Error;
use crate::outline::OutlinePair;
use crate::pair::{Mating, Member, SweepPlan};
use crate::parallel;
use std::cmp::Ordering;

/// Sampled poses of a cycle at most (tuned: some seconds). Longer cycles are sampled more thinly.
const MOST: u64 = 100_000;

/// Sampled poses that are looked at more closely, at either end.
const BEST: usize = 6;

/// Times the neighbourhood of such a pose is cut into a quarter: down to 1/16 000 of a step.
const ROUNDS: u32 = 7;

/// Rounds at most of the search for a distance: each rules out a pose that interfered.
const MOST_TIGHTEST: u32 = 40;

/// Width of the bracket of the distance, mm: a tenth of what is shown.
const DISTANCE_WIDTH: f64 = 1e-5;

/// First step towards a greater distance, mm: what many pairs are short of (tuned).
const FIRST_STEP: f64 = 0.01;

/// A mesh cycle and how densely it is sampled.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cycle {
    first: Mating,
    matings: u64,
    poses: u64,
}

/// A pose and its lost motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Pitches from the first pose.
    pub pitches: f64,
    pub mating: Mating,
    pub status: Status,
    /// Lost motion and the bound on its error, rad.
    pub angle: Option<(f64, f64)>,
}

impl Sample {
    pub fn new(kernel: &OutlineKernel, pair: &OutlinePair, first: &Mating, pitches: f64) -> Sample {
        // A little before the first pose is the end of the cycle.
        let mating = first.onward(pair, pitches);
        let found = kernel.lost_motion_at(pair, &mating);
        let found = found.as_ref().ok();
        Sample {
            pitches,
            mating,
            status: found.map_or(Status::Unproven, |found| found.status()),
            angle: found.and_then(|found| found.angle().zip(found.error())),
        }
    }

    fn value(&self) -> Option<f64> {
        self.angle.map(|(angle, _)| angle)
    }

    fn interferes(&self) -> bool {
        matches!(self.status, Status::Interference | Status::Jammed)
    }

    /// Lost motion, rad; below all where the pose is jammed.
    pub fn room(&self) -> f64 {
        self.value().unwrap_or(f64::NEG_INFINITY)
    }
}

/// The tightest of `samples` that interfere.
fn tightest(samples: &[Sample]) -> Option<Sample> {
    let interfering = samples.iter().filter(|sample| sample.interferes());
    let tightest = interfering.min_by(|a, b| a.room().total_cmp(&b.room()));
    tightest.copied()
}

impl Cycle {
    /// The cycle of `pair` from `first` on, sampled `per_pitch` times a pitch.
    pub fn new(pair: &OutlinePair, first: Mating, per_pitch: u32) -> Cycle {
        let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member).teeth());
        let matings = SweepPlan::hunting_pitches(wheel, pinion);
        Cycle {
            first,
            matings,
            poses: (matings * u64::from(per_pitch)).min(MOST),
        }
    }

    /// The extremes of `pair`, and, where it interferes, the distance from which it assembles; `None` where none was found.
    ///
    /// # Errors
    /// None of a pair that was read.
    pub fn search(&self, pair: &OutlinePair) -> Result<(Extremes, Option<AssemblesFrom>), Error> {
        let kernel = OutlineKernel::new(pair);
        let samples = self.samples(&kernel, pair);
        let ends = self.ends(&kernel, pair, &samples);
        let all = || samples.iter().chain(ends.iter().flatten());
        let lost = [Status::Jammed, Status::NoContact, Status::Unproven]
            .into_iter()
            .find_map(|status| all().find(|sample| sample.status == status));
        let interferes = all().any(Sample::interferes);
        let status = match lost.map(|lost| lost.status) {
            Some(Status::Unproven) | None if interferes => Status::Interference,
            Some(status) => status,
            None => Status::Clear,
        };
        let radius = pair.operating_pitch_radius(pair.free());
        let extreme = |end: Option<Sample>| {
            let end = end?;
            let (angle, error) = end.angle?;
            Some(Extreme {
                low: (angle - error) * radius,
                high: (angle + error) * radius,
                found: angle * radius,
                mating: end.mating,
                doubt: Some(Doubt::Sampled),
            })
        };
        let [least, greatest] = ends;
        let is_known = |status: Status| all().all(|sample| sample.status != status);
        let found = Extremes {
            matings: self.matings,
            status,
            least: extreme(least).filter(|_| is_known(Status::Jammed)),
            greatest: extreme(greatest).filter(|_| is_known(Status::NoContact)),
            lost: lost.map(|lost| lost.mating),
        };
        let from = match interferes {
            true => {
                let least = least.filter(Sample::interferes);
                let tightest = least
                    .filter(|_| found.least.is_some())
                    .or(tightest(&samples));
                self.assembles_from(&kernel, pair, tightest)?
            }
            false => None,
        };
        Ok((found, from))
    }

    fn samples(&self, kernel: &OutlineKernel, pair: &OutlinePair) -> Vec<Sample> {
        let apart = self.matings as f64 / self.poses as f64;
        let sample = |k: u64| Sample::new(kernel, pair, &self.first, k as f64 * apart);
        parallel::map(0..self.poses, sample)
    }

    /// The samples with the least and the greatest lost motion of `samples` and of more round the best of them.
    fn ends(
        &self,
        kernel: &OutlineKernel,
        pair: &OutlinePair,
        samples: &[Sample],
    ) -> [Option<Sample>; 2] {
        let step = self.matings as f64 / self.poses as f64;
        [1.0, -1.0].map(|sign| {
            let value = |sample: &Sample| sample.value().map(|angle| sign * angle);
            let order =
                |a: &Sample, b: &Sample| value(a).partial_cmp(&value(b)).unwrap_or(Ordering::Equal);
            let valued = samples.iter().filter(|sample| value(sample).is_some());
            let mut best: Vec<&Sample> = valued.collect();
            best.sort_by(|a, b| order(a, b));
            best.truncate(BEST);
            let closer = parallel::map(best, |sample| {
                let (mut found, mut width) = (*sample, step);
                for _ in 0..ROUNDS {
                    let middle = found.pitches;
                    for part in [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0] {
                        let pitches = middle + part * 0.25 * width;
                        let near = Sample::new(kernel, pair, &self.first, pitches);
                        let is_better = |near: f64| value(&found).is_none_or(|best| near < best);
                        if value(&near).is_some_and(is_better) {
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

    /// From where on `pair` assembles, of which `tightest` is the tightest pose; `None` where it interferes until tips pass each other, or a
    /// pose is not settled.
    fn assembles_from(
        &self,
        kernel: &OutlineKernel,
        pair: &OutlinePair,
        mut tightest: Option<Sample>,
    ) -> Result<Option<AssemblesFrom>, Error> {
        let reach = Member::BOTH.map(|member| pair.gear(member).reach());
        let farthest: f64 = reach.iter().sum();
        let mut found: Option<AssemblesFrom> = None;
        let mut floor = pair.center_distance();
        for _ in 0..MOST_TIGHTEST {
            let Some(tight) = tightest else {
                return Ok(found);
            };
            let interferes_at = |distance: f64| -> Result<bool, Error> {
                let there = pair.at(distance)?;
                let sample = Sample::new(kernel, &there, &self.first, tight.pitches);
                Ok(sample.interferes())
            };
            // In growing steps, so that it is the nearest such place and not one where tips pass each other.
            let (mut low, mut step) = (floor, FIRST_STEP);
            while low + step <= farthest && interferes_at(low + step)? {
                (low, step) = (low + step, 2.0 * step);
            }
            let mut high = low + step;
            if high > farthest {
                return Ok(None);
            }
            while high - low > DISTANCE_WIDTH {
                let middle = 0.5 * (low + high);
                match interferes_at(middle)? {
                    true => low = middle,
                    false => high = middle,
                }
            }
            floor = high;
            let there = pair.at(high)?;
            let samples = self.samples(kernel, &there);
            // Out of mesh it does not turn the mate, and of a pose that is not settled nobody knows.
            let is_lost =
                |sample: &Sample| matches!(sample.status, Status::NoContact | Status::Unproven);
            if samples.iter().any(is_lost) {
                return Ok(None);
            }
            let [closest, _] = self.ends(kernel, &there, &samples);
            tightest = closest
                .filter(Sample::interferes)
                .or_else(|| self::tightest(&samples));
            found = Some(AssemblesFrom {
                low,
                high,
                doubt: Some(Doubt::Sampled),
                mating: tight.mating,
            });
        }
        Ok(None)
    }
}

//! Extremes of a pair with a drawn gear: those of sampled poses of its mesh cycle, and of more round the best of them.
//!
//! Nothing bounds the lost motion of arbitrary curves between two poses. Each pose is right within its own error ([`OutlineKernel`]).
//!
//! The centre distance from which the pair assembles is found by the tightest pose: where it begins to interfere is bracketed, and the cycle is
//! sampled there. Where another pose interferes, that is the tightest next. A few rounds end at a distance at which none does.

use super::assembles_from::AssemblesFrom;
use crate::contact::{Doubt, Extreme, Extremes, OutlineKernel, Status};
use crate::error::Error;
use crate::gear::Side;
use crate::outline::OutlinePair;
use crate::pair::{Mating, Member, SweepPlan};
use crate::parallel;
use std::cmp::Ordering;

/// Sampled poses of a cycle at most (tuned: some seconds). Longer cycles are sampled more thinly.
const MOST: u64 = 100_000;

/// Samples for each part of a tooth that a mate's part can pass (tuned: peaks of chords are narrower than a part).
const A_PART: u64 = 4;

/// Samples a pitch at most for the parts of its teeth: of finer parts the peaks are lower than is shown.
const MOST_A_PITCH: u64 = 256;

/// Steps that are halved at once, at either end (tuned: 96 like teeth of 8 chords a flank need 400).
const HALVED: usize = 1000;

/// Times a step is halved: down to 1/16 000.
const ROUNDS: u32 = 14;

/// Lost motion below which a better pose is not searched for, rad: 0.01 µm at a radius of 100 mm.
const FINE: f64 = 1e-7;

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
    /// Samples of a search for a distance.
    poses: u64,
    /// Samples of a search for extremes: several between the places at which the parts in contact change.
    fine: u64,
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
        let parts = Member::BOTH.map(|member| {
            let gear = pair.gear(member);
            let of_tooth = |tooth| Side::BOTH.map(|side| gear.half(side, tooth).pieces.len());
            let parts = (1..=gear.teeth()).map(|tooth| of_tooth(tooth).iter().sum());
            parts.max().unwrap_or(0) as u64
        });
        let per_pitch = u64::from(per_pitch);
        let fine = per_pitch.max((A_PART * (parts[0] + parts[1])).min(MOST_A_PITCH));
        Cycle {
            first,
            matings,
            poses: (matings * per_pitch).min(MOST),
            fine: (matings * fine).min(MOST),
        }
    }

    /// The extremes of `pair`, and, where it interferes, the distance from which it assembles; `None` where none was found.
    ///
    /// # Errors
    /// None of a pair that was read.
    pub fn search(&self, pair: &OutlinePair) -> Result<(Extremes, Option<AssemblesFrom>), Error> {
        let (found, tightest) = self.extremes(pair);
        let from = match tightest {
            Some(tightest) => {
                self.assembles_from(&OutlineKernel::new(pair), pair, Some(tightest))?
            }
            None => None,
        };
        Ok((found, from))
    }

    /// The extremes of `pair`, and, where it interferes, the tightest pose.
    pub fn extremes(&self, pair: &OutlinePair) -> (Extremes, Option<Sample>) {
        let kernel = OutlineKernel::new(pair);
        let samples = self.samples(&kernel, pair, self.fine);
        let ends = [1.0, -1.0].map(|sign| self.end(&kernel, pair, &samples, sign));
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
        let least = least.filter(|least| found.least.is_some() && least.interferes());
        let tightest = least.or_else(|| tightest(&samples)).filter(|_| interferes);
        (found, tightest)
    }

    /// `count` even samples of the cycle.
    fn samples(&self, kernel: &OutlineKernel, pair: &OutlinePair, count: u64) -> Vec<Sample> {
        let apart = self.matings as f64 / count as f64;
        // The last is the first of the next cycle, so that the last step is one.
        let sample = |k: u64| Sample::new(kernel, pair, &self.first, k as f64 * apart);
        parallel::map(0..count + 1, sample)
    }

    /// The sample with the least lost motion (`sign` 1) or the greatest (−1) of `samples` and of more between the best of them.
    ///
    /// A step that may hold a better pose is halved. The lost motion is taken to change within a step at most as fast as from one end to the other
    /// of it, or of either neighbour.
    fn end(
        &self,
        kernel: &OutlineKernel,
        pair: &OutlinePair,
        samples: &[Sample],
        sign: f64,
    ) -> Option<Sample> {
        let value = |sample: &Sample| sample.value().map(|angle| sign * angle);
        let mut samples = samples.to_vec();
        for _ in 0..ROUNDS {
            let best = samples.iter().filter_map(value).reduce(f64::min)?;
            let rise = |step: &[Sample]| {
                let rise = (value(&step[1])? - value(&step[0])?).abs();
                Some(rise / (step[1].pitches - step[0].pitches))
            };
            let slopes: Vec<f64> = samples
                .windows(2)
                .map(|step| rise(step).unwrap_or(0.0))
                .collect();
            // The value that a step may attain, and its middle.
            let promise = |(k, step): (usize, &[Sample])| {
                let near = &slopes[k.saturating_sub(1)..slopes.len().min(k + 2)];
                let slope = near.iter().copied().fold(0.0, f64::max);
                let width = step[1].pitches - step[0].pitches;
                let attained = 0.5 * (value(&step[0])? + value(&step[1])? - slope * width);
                let middle = step[0].pitches + 0.5 * width;
                (attained < best - FINE).then_some((attained, middle))
            };
            let mut promising: Vec<(f64, f64)> =
                samples.windows(2).enumerate().filter_map(promise).collect();
            if promising.is_empty() {
                break;
            }
            promising.sort_by(|a, b| a.0.total_cmp(&b.0));
            promising.truncate(HALVED);
            let at = |(_, pitches)| Sample::new(kernel, pair, &self.first, pitches);
            samples.extend(parallel::map(promising, at));
            samples.sort_by(|a, b| a.pitches.total_cmp(&b.pitches));
        }
        let order =
            |a: &&Sample, b: &&Sample| value(a).partial_cmp(&value(b)).unwrap_or(Ordering::Equal);
        let valued = samples.iter().filter(|sample| sample.value().is_some());
        valued.min_by(order).copied()
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
            let samples = self.samples(kernel, &there, self.poses);
            // Out of mesh it does not turn the mate, and of a pose that is not settled nobody knows.
            let is_lost =
                |sample: &Sample| matches!(sample.status, Status::NoContact | Status::Unproven);
            if samples.iter().any(is_lost) {
                return Ok(None);
            }
            tightest = self
                .end(kernel, &there, &samples, 1.0)
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

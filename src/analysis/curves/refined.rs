//! Additional poses where curves over the teeth bend, so that a chart shows each peak.
//!
//! A sweep at 16 steps per pitch misses the tip of a peak narrower than a step. The poses added here are only drawn:
//! means and counts use the even sweep. In order:
//!
//! 1. The proven extremes, at their own teeth, or at every pitch if all teeth are equal. They are on the curves of both flanks,
//!    because both cover the same rotations.
//! 2. The middle of each step over which other teeth or other parts of them come into contact, once.
//! 3. The middles of the steps beside a bend, and of those at the edge of a gap, repeatedly: until a point lies within [`FLAT`] of
//!    the chord of its neighbours, or the step is [`FINEST`].

use super::course::flank_poses;
use crate::analysis::compare::{ComparedPose, ComparedRun};
use crate::analysis::extremes::{RunExtreme, RunExtremes};
use crate::analysis::simulate::simulate_plans;
use crate::analysis::study::{RunPlan, Study};
use crate::contact::{Contact, Method, ToothPlace};
use crate::error::{Error, Tick};
use crate::gear::Side;
use crate::numeric::rank;
use crate::outline::AssembledPair;
use crate::pair::{Mating, ToothNumbers};
use std::f64::consts::TAU;

/// Bend that is not drawn, as a part of the range of all curves at its centre distance: a chart is about 300 units high.
const FLAT: f64 = 1.0 / 300.0;
/// The least range of a chart, mm: below it rounding would bend a curve.
const LEAST_RANGE: f64 = 1e-3;
/// The least step, pitches (tuned: a peak that rises 100 µm in a pitch is drawn to 0.1 µm).
const FINEST: f64 = 1.0 / 1024.0;
/// Limit of poses added to all curves together.
const MOST: usize = 100_000;
/// A curve over more pitches is not refined, because a pitch is less than a unit wide on a chart.
const MOST_PITCHES: f64 = 700.0;

/// `revolution`, whose runs cover whole revolutions at even steps, with the additional poses of its curves. They
/// include the proven extremes of `cycle`.
///
/// # Errors
/// As [`crate::analysis::simulate::simulate`].
pub fn refined(
    study: &Study,
    revolution: &[ComparedRun],
    cycle: &[RunExtremes],
    method: Method,
    tick: &Tick,
) -> Result<Vec<ComparedRun>, Error> {
    let mut curves: Vec<Curve> = revolution.iter().flat_map(Curve::of).collect();
    let mut remaining = MOST;
    let mut round = 0;
    loop {
        let flat = flat(&curves);
        let wanted: Vec<Vec<(f64, Mating)>> = curves
            .iter()
            .map(|curve| match round {
                0 => curve.at_extremes(cycle),
                _ => curve.middles(&flat, round == 1),
            })
            .collect();
        let count: usize = wanted.iter().map(Vec::len).sum();
        if count > remaining || (count == 0 && round > 1) {
            break;
        }
        remaining -= count;
        round += 1;
        let plans = curves.iter().zip(&wanted).map(|(curve, wanted)| RunPlan {
            run: curve.run.run.clone(),
            matings: wanted.iter().map(|(_, mating)| *mating).collect(),
        });
        let found = simulate_plans(study, plans.collect(), method, tick)?;
        for ((curve, wanted), found) in curves.iter_mut().zip(wanted).zip(found) {
            curve.insert(wanted, found.poses);
        }
    }
    let mut curves = curves.into_iter();
    let refined = revolution.iter().map(|run| {
        let points = curves.by_ref().take(2).flat_map(|curve| curve.points);
        ComparedRun {
            run: run.run.clone(),
            poses: points.map(|point| point.pose).collect(),
        }
    });
    Ok(refined.collect())
}

/// The invisible bend at each centre distance, mm.
fn flat(curves: &[Curve]) -> impl Fn(f64) -> f64 + use<> {
    let mut ranges: Vec<(f64, [f64; 2])> = Vec::new();
    for curve in curves {
        let a = curve.run.run.assembly.center_distance();
        let found = ranges.iter().position(|range| range.0 == a);
        let index = found.unwrap_or_else(|| {
            ranges.push((a, [f64::INFINITY, f64::NEG_INFINITY]));
            ranges.len() - 1
        });
        let [low, high] = &mut ranges[index].1;
        for value in curve.points.iter().filter_map(Point::value) {
            (*low, *high) = (low.min(value), high.max(value));
        }
    }
    move |a| {
        let range = ranges.iter().find(|range| range.0 == a);
        let width = range.map_or(0.0, |(_, [low, high])| high - low);
        FLAT * width.max(LEAST_RANGE)
    }
}

/// The poses of one run and flank, in order.
struct Curve<'a> {
    run: &'a ComparedRun,
    flank: Side,
    points: Vec<Point>,
}

/// A pose, and its pitches past the first.
struct Point {
    pitches: f64,
    pose: ComparedPose,
}

/// Touching tooth and part, on wheel and pinion.
type Touching = [(u32, ToothPlace); 2];

impl Point {
    fn value(&self) -> Option<f64> {
        self.pose.simulated.backlash
    }

    /// Touching teeth and parts, right and left.
    fn touching(&self) -> Option<[Option<Touching>; 2]> {
        let found = self.pose.simulated.proven()?;
        let of = |contact: &Contact| {
            [&contact.wheel, &contact.pinion].map(|touch| (touch.tooth, touch.curve))
        };
        Some([found.right.as_ref().map(of), found.left.as_ref().map(of)])
    }
}

impl<'a> Curve<'a> {
    /// The curves of both flanks of a run.
    fn of(run: &'a ComparedRun) -> [Curve<'a>; 2] {
        Side::BOTH.map(|flank| {
            let points = flank_poses(run, flank).into_iter();
            let points = points.map(|(pitches, pose)| Point {
                pitches,
                pose: pose.clone(),
            });
            Curve {
                run,
                flank,
                points: points.collect(),
            }
        })
    }

    fn assembly(&self) -> &'a AssembledPair {
        &self.run.run.assembly
    }

    /// Places and matings of the extremes of `cycle` on this curve.
    fn at_extremes(&self, cycle: &[RunExtremes]) -> Vec<(f64, Mating)> {
        let assembly = self.assembly();
        let here = cycle
            .iter()
            .filter(|of| of.group_key() == self.run.run.group_key());
        let mut wanted: Vec<(f64, Mating)> = Vec::new();
        for of in here {
            let ends = of.least.iter().chain(&of.greatest);
            for extreme in ends.filter(|extreme| extreme.assembly == *assembly) {
                let at = mating_of(extreme, assembly, self.flank);
                // The whole pitches: each has one point with the fraction 0.
                for point in &self.points {
                    let own = point.pose.simulated.pose.mating();
                    let is_at =
                        (own.wheel_tooth, own.pinion_tooth) == (at.wheel_tooth, at.pinion_tooth);
                    if own.fraction == 0.0 && (is_at || of.has_like_teeth()) {
                        let fraction = at.fraction;
                        wanted.push((point.pitches + fraction, Mating { fraction, ..*own }));
                    }
                }
            }
        }
        wanted.sort_by_cached_key(|(at, _)| rank(*at));
        wanted.dedup_by(|one, other| one.0 == other.0);
        wanted.retain(|(at, _)| {
            let next = self.points.partition_point(|point| point.pitches < *at);
            self.points
                .get(next)
                .is_none_or(|point| point.pitches > *at)
        });
        wanted
    }

    /// Places and matings in the middles of the steps that need one: beside a bend, at the edge of a gap and, with
    /// `changes`, where another part comes into contact.
    fn middles(&self, flat: &impl Fn(f64) -> f64, changes: bool) -> Vec<(f64, Mating)> {
        let flat = flat(self.assembly().center_distance());
        let points = &self.points;
        if points.last().is_none_or(|last| last.pitches > MOST_PITCHES) {
            return Vec::new();
        }
        let mut marked = vec![false; points.len().saturating_sub(1)];
        for (step, pair) in points.windows(2).enumerate() {
            let edge = pair[0].value().is_some() != pair[1].value().is_some();
            marked[step] |= edge || (changes && pair[0].touching() != pair[1].touching());
        }
        for (step, three) in points.windows(3).enumerate() {
            let [Some(before), Some(here), Some(after)] = [0, 1, 2].map(|i| three[i].value())
            else {
                continue;
            };
            let width = three[2].pitches - three[0].pitches;
            let part = (three[1].pitches - three[0].pitches) / width;
            if (here - before - part * (after - before)).abs() > flat {
                marked[step] = true;
                marked[step + 1] = true;
            }
        }
        let steps = points.windows(2).zip(marked);
        let wanted = steps.filter_map(|(pair, marked)| {
            let half = 0.5 * (pair[1].pitches - pair[0].pitches);
            if !marked || half < FINEST {
                return None;
            }
            let mating = pair[0].pose.simulated.pose.mating();
            Some((pair[0].pitches + half, mating.onward(self.assembly(), half)))
        });
        wanted.collect()
    }

    /// Adds the poses found at `wanted`; unproven ones are not drawn.
    fn insert(&mut self, wanted: Vec<(f64, Mating)>, found: Vec<ComparedPose>) {
        let proven = wanted.into_iter().zip(found);
        let proven = proven.filter(|(_, pose)| !pose.simulated.is_unproven());
        self.points
            .extend(proven.map(|((pitches, _), pose)| Point { pitches, pose }));
        self.points.sort_by_cached_key(|point| rank(point.pitches));
    }
}

/// The mating at `flank` with the locked gear's rotation in the pose of `extreme`.
fn mating_of(extreme: &RunExtreme, assembly: &AssembledPair, flank: Side) -> Mating {
    let pose = &extreme.pose.simulated.pose;
    let there = pose.mating().at_flank(assembly, flank);
    let locked = assembly.locked();
    let pitch = -assembly.shown_face(locked).ascending() * TAU / f64::from(assembly.teeth(locked));
    let turned = pose.locked_rotation() - assembly.pose(there).locked_rotation();
    there.onward(assembly, turned / pitch)
}

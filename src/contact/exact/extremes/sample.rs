//! Extremes of a pair without a bound from curves: from sampled poses, and a bound of the change between two poses.
//!
//! On either side of a tooth the radius about its own centre rises from root to tip. So a tooth that turns back leaves no metal in front of
//! its flank, and one that turns forward keeps metal wherever it had some. The free gear's rotation at contact follows the locked gear, on
//! both sides, and never turns back. Let `R` and `L` be these rotations at two poses, less the nominal ones, which differ by `δ`. For every
//! pose between them,
//!
//! ```text
//! min(L_0 − R_1, L_1 − R_0) − δ  ≤  j  ≤  max(L_0 − R_1, L_1 − R_0) + δ.
//! ```
//!
//! An eccentric locked outline can carry a land, whose normal passes its centre, back by `e_L` per radian. The free gear's arm is at least
//! half its base radius where lands touch flanks. Poses with tips on tips or in roots bound nothing. The stretch with the worst bound is
//! halved.

use super::extreme::{End, ExaminedPoses};
use super::mesh_cycle::MeshCycle;
use crate::contact::ranked::Ranked;
use crate::contact::{Contact, LostMotion};
use crate::error::Error;
use crate::numeric::rank;
use crate::pair::{Mating, Pose};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::{PI, TAU};

/// Limit of poses, for a pair that needs no search and for one that does (tuned: about 0.2 s, and 1 s).
const MOST: [u64; 2] = [200_000, 6_000];

/// Limit of poses per pitch on average, and number of poses that any cycle may have.
const PER_PITCH: u64 = 32;
const FEW: u64 = 2_000;

/// Rounds that divide the neighbourhood of the best poses by four: down to 1/32 000 of a pitch.
const ROUNDS: u32 = 5;

/// Poses from which the effort of one pose is measured (tuned: a thousandth of all).
const POSES_TO_MEASURE: u64 = 8;

/// Least number of poses, as long as any effort is left: a helical one takes below 0.1 s.
const FEWEST: u64 = 16;

/// Length of a stretch, pitches, below which it has no bound if its ends have none.
const NARROWEST: f64 = 1e-3;

/// Free rotations at contact, less the nominal one, rad; `None` if they bound nothing.
#[derive(Debug, Clone, Copy)]
struct FreeRotations {
    right: f64,
    left: f64,
    error: f64,
}

/// A stretch between two poses, pitches from the start of the cycle.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    places: [f64; 2],
    ends: [Option<FreeRotations>; 2],
}

/// A cycle with its bound between poses.
struct SampledCycle<'a, 'b> {
    cycle: &'a MeshCycle<'b>,
    /// Nominal turn of the free gear per pitch, plus what an eccentric locked outline can take back, rad.
    per_pitch: f64,
}

impl SampledCycle<'_, '_> {
    fn examine(
        &self,
        found: &mut ExaminedPoses,
        place: f64,
    ) -> Result<Option<FreeRotations>, Error> {
        let cycle = self.cycle;
        let mating = cycle.mating(place.floor() as u64, place.fract());
        let Some(seen) = found.examine(cycle, mating)? else {
            return Ok(None);
        };
        let nominal = Pose::new(cycle.assembly, mating).free_rotation();
        Ok(free_rotations(&seen, nominal))
    }

    /// Bounds of the lost motion over a stretch.
    fn bounds(&self, stretch: &Stretch) -> [f64; 2] {
        let [Some(a), Some(b)] = stretch.ends else {
            return [f64::NEG_INFINITY, f64::INFINITY];
        };
        let way = (stretch.places[1] - stretch.places[0]) * self.per_pitch + a.error + b.error;
        let across = [a.left - b.right, b.left - a.right];
        [
            across[0].min(across[1]) - way,
            across[0].max(across[1]) + way,
        ]
    }

    /// Halves the stretch with the worst bound up to `most` times; returns the remaining bound.
    fn refine(
        &self,
        which: End,
        stretches: &mut Vec<Stretch>,
        most: u64,
        found: &mut ExaminedPoses,
        only: Option<End>,
    ) -> Result<f64, Error> {
        let worse = |stretch: &Stretch| {
            let [low, high] = self.bounds(stretch);
            which.key(low, high)
        };
        // The worst first, of equal ones the first.
        let ranked = |(number, item): (usize, Stretch)| Ranked {
            key: (rank(worse(&item)), Reverse(number)),
            item,
        };
        let mut heap: BinaryHeap<_> = stretches.drain(..).enumerate().map(ranked).collect();
        let mut number = heap.len();
        for _ in 0..most {
            if self.cycle.effort.is_spent() || found.lacks(only) {
                break;
            }
            let Some(Ranked { item: stretch, .. }) = heap.pop() else {
                break;
            };
            let [from, to] = stretch.places;
            if worse(&stretch) == f64::INFINITY && to - from < NARROWEST {
                heap.push(ranked((number, stretch)));
                break;
            }
            let middle = 0.5 * (from + to);
            let between = self.examine(found, middle)?;
            for (places, ends) in [
                ([from, middle], [stretch.ends[0], between]),
                ([middle, to], [between, stretch.ends[1]]),
            ] {
                heap.push(ranked((number, Stretch { places, ends })));
                number += 1;
            }
        }
        let worst = heap.peek().map_or(f64::INFINITY, |top| worse(&top.item));
        stretches.extend(heap.into_iter().map(|ranked| ranked.item));
        Ok(-which.sign() * worst)
    }
}

/// The free rotations at a pose, for the bounds of its neighbours.
fn free_rotations(seen: &LostMotion, nominal: f64) -> Option<FreeRotations> {
    let (angle, error) = seen.angle().zip(seen.error())?;
    let (right, left) = (seen.right.as_ref()?, seen.left.as_ref()?);
    let on_lands =
        |contact: &Contact| contact.wheel.curve.is_land() && contact.pinion.curve.is_land();
    if on_lands(right) || on_lands(left) {
        return None;
    }
    let off = right.rotation - nominal;
    let off = off - TAU * (off / TAU).round();
    // Half a turn from nominal, the contact may be that of a neighbour.
    (off.abs() < 0.5 * PI).then_some(FreeRotations {
        right: off,
        left: off + angle,
        error,
    })
}

/// Samples the cycle, more densely where its bounds are worst and around the least and the greatest, with as many poses as the effort
/// allows. Sampling for `only` one extreme stops at the first pose that has none.
pub(super) fn sample(
    cycle: &MeshCycle,
    found: &mut ExaminedPoses,
    only: Option<End>,
) -> Result<(), Error> {
    if found.sampled.is_some() {
        return Ok(());
    }
    found.sampled = Some([f64::NEG_INFINITY, f64::INFINITY]);
    let most = MOST[usize::from(!cycle.kernel.is_direct())];
    let poses = most
        .min((cycle.matings * PER_PITCH).max(FEW))
        .min(affordable_poses(cycle)?);
    let problem = cycle.sides[0].problem;
    let back = cycle.sides[0].off[0] * problem.locked.pitch * 2.0 * problem.per_free_base;
    let sampled = SampledCycle {
        cycle,
        // A lean turns with its gear, and with it what it turns flanks by: at most its own part of the rotation.
        per_pitch: (problem.free.pitch + 2.0 * back) * (1.0 + 4.0 * cycle.assembly.lean_bound()),
    };
    // A third of the poses throughout the cycle, a third for each extreme.
    let cells = (poses / 3).clamp(1, cycle.matings * PER_PITCH);
    let place = |cell: u64| cell as f64 / cells as f64 * cycle.matings as f64;
    let mut stretches = Vec::with_capacity(cells as usize);
    let mut last = sampled.examine(found, 0.0)?;
    for cell in 0..cells {
        if found.lacks(only) || cycle.effort.is_spent() {
            return Ok(());
        }
        let next = sampled.examine(found, place(cell + 1))?;
        stretches.push(Stretch {
            places: [place(cell), place(cell + 1)],
            ends: [last, next],
        });
        last = next;
    }
    let mut bounds = [f64::NEG_INFINITY, f64::INFINITY];
    // A touching body is no flank.
    let section = &cycle.kernel.section;
    let has_bounds = section.bodies.is_none() && !section.never_assembles;
    let ends = [End::Greatest, End::Least].into_iter();
    for end in ends.filter(|end| has_bounds && only.is_none_or(|only| only == *end)) {
        bounds[end as usize] = sampled.refine(end, &mut stretches, poses / 3, found, only)?;
    }
    found.sampled = Some(bounds);
    let mut width = 0.5 * cycle.matings as f64 / cells as f64;
    for _ in 0..ROUNDS {
        for seen in found.best.into_iter().flatten() {
            for part in -4..=4 {
                if cycle.effort.is_spent() {
                    return Ok(());
                }
                let mating = seen.mating;
                let beyond = f64::from(part) * 0.25 * width;
                let near: Mating = mating.onward(cycle.assembly, beyond);
                found.examine(cycle, near)?;
            }
        }
        width *= 0.25;
    }
    Ok(())
}

/// Number of poses that the remaining effort allows, measured by a few poses throughout the cycle. Half of the effort is for places near
/// the best.
fn affordable_poses(cycle: &MeshCycle) -> Result<u64, Error> {
    let mut tried = ExaminedPoses::default();
    let before = cycle.effort.left();
    for k in 0..POSES_TO_MEASURE {
        if cycle.effort.is_spent() {
            break;
        }
        let place = (k as f64 + 0.5) / POSES_TO_MEASURE as f64 * cycle.matings as f64;
        tried.examine(cycle, cycle.mating(place as u64, place.fract()))?;
    }
    let left = cycle.effort.left();
    let each = ((before - left) / POSES_TO_MEASURE).max(1);
    Ok((left / 2 / each).max(FEWEST))
}

#[cfg(test)]
mod tests {
    use super::super::super::ExactKernel;
    use super::*;
    use crate::contact::Effort;
    use crate::pair::{GearPair, Member, Pose};

    /// The result is no worse than the least and the greatest of sixteen poses of every pitch of the cycle.
    #[test]
    fn every_pitch_is_sampled() {
        let pair = GearPair::plain([20; 2], [0.05, 0.04], 40.4, Member::Wheel);
        let kernel = ExactKernel::new(&pair);
        let first = Mating::FIRST;
        let effort = Effort::endless();
        let cycle = MeshCycle::new(&kernel, &pair, (first, 20), &effort);
        let mut found = ExaminedPoses::default();
        sample(&cycle, &mut found, None).unwrap();
        let poses = (0..320).map(|k| {
            let mating = first.onward(&pair, f64::from(k) / 16.0);
            let lost = kernel.lost_motion(&Pose::new(&pair, mating)).unwrap();
            lost.angle().unwrap()
        });
        let (least, greatest) = poses.fold((f64::MAX, f64::MIN), |(least, greatest), angle| {
            (least.min(angle), greatest.max(angle))
        });
        let [low, high] = found.best.map(|seen| seen.unwrap().angle);
        for beyond in [least - low, high - greatest] {
            assert!((-1e-9..1e-5).contains(&beyond), "{beyond}");
        }
    }
}

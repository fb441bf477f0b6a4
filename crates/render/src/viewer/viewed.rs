//! Which poses a page holds: all, or so many of each run that the page stays in hand.

use gearlash::analysis::compare::{ComparedPose, ComparedRun};
use gearlash::contact::{Status, first_least, worst_pose};
use std::collections::BTreeSet;

/// A run, and which of its poses the page holds.
pub struct Viewed<'a> {
    /// The run.
    pub run: &'a ComparedRun,
    /// Their numbers, from 0, ascending.
    pub numbers: Vec<usize>,
}

impl<'a> Viewed<'a> {
    /// The poses, in order.
    pub fn poses(&self) -> impl Iterator<Item = &'a ComparedPose> {
        self.numbers.iter().map(|number| &self.run.poses[*number])
    }
}

/// Every run of `runs` with every n-th of its poses, `n` (the second value) the least with which they are `most`
/// together; where `n` is above 1, with its least and its greatest backlash and its first jammed, unmeshed and unproven
/// pose beside them.
pub fn viewed(runs: &[ComparedRun], most: usize) -> (Vec<Viewed<'_>>, usize) {
    let all: usize = runs.iter().map(|run| run.poses.len()).sum();
    let every = all.div_ceil(most.max(1)).max(1);
    let runs = runs.iter().map(|run| {
        let mut numbers: BTreeSet<usize> = (0..run.poses.len()).step_by(every).collect();
        numbers.extend(extremes(run));
        Viewed {
            run,
            numbers: numbers.into_iter().collect(),
        }
    });
    (runs.collect(), every)
}

/// Run and pose, from 0, of the worst pose as [`worst_pose`] chooses it; the first of all when none is in mesh. It is among those of [`viewed`].
pub fn worst(runs: &[ComparedRun]) -> Option<[usize; 2]> {
    let poses = || {
        let numbered = runs.iter().enumerate();
        numbered.flat_map(|(r, run)| {
            let poses = run.poses.iter().enumerate();
            poses.map(move |(p, pose)| ([r, p], &pose.simulated))
        })
    };
    worst_pose(poses()).or_else(|| poses().next().map(|(at, _)| at))
}

/// The poses of a run that must not be left out.
fn extremes(run: &ComparedRun) -> impl Iterator<Item = usize> {
    let numbered = || run.poses.iter().map(|pose| &pose.simulated).enumerate();
    let extreme = |sign: f64| {
        first_least(numbered().filter_map(move |(number, pose)| {
            Some((number, sign * pose.backlash?, pose.error_bound?))
        }))
    };
    let first = |status: Status| {
        let mut poses = numbered();
        poses.position(|(_, pose)| pose.status() == status)
    };
    [
        extreme(1.0),
        extreme(-1.0),
        first(Status::Jammed),
        first(Status::NoContact),
        first(Status::Unproven),
    ]
    .into_iter()
    .flatten()
}

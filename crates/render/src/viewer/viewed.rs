//! The poses of a page: all of whole revolutions, or a limited number of them, and the worst of the mesh cycle.

use gearlash::analysis::Analysis;
use gearlash::analysis::compare::{ComparedPose, ComparedRun};
use gearlash::analysis::study::{Material, Run};
use gearlash::contact::{Status, first_least, worst_pose};
use gearlash::outline::AssembledPair;

/// A run, and the selection of its poses.
pub struct Viewed<'a> {
    pub run: &'a ComparedRun,
    /// Whether it is the worst pose of the mesh cycle, in addition to the even poses of the revolutions.
    pub is_worst_of_cycle: bool,
    /// Indices of the selected poses, ascending.
    pub numbers: Vec<usize>,
}

impl<'a> Viewed<'a> {
    /// `run` with all its poses.
    pub fn all(run: &'a ComparedRun, is_worst_of_cycle: bool) -> Viewed<'a> {
        Viewed {
            run,
            is_worst_of_cycle,
            numbers: (0..run.poses.len()).collect(),
        }
    }

    pub fn poses(&self) -> impl Iterator<Item = &'a ComparedPose> {
        let poses = &self.run.poses;
        self.numbers.iter().map(|number| &poses[*number])
    }
}

/// The number of selected poses.
pub fn count(runs: &[Viewed]) -> usize {
    runs.iter().map(|run| run.numbers.len()).sum()
}

/// Selects every n-th pose of every run of `runs`; returns n, the least with at most `most` poses in all.
///
/// Each run also keeps its least and its greatest backlash and its first jammed, unmeshed and unproven pose. The pose at `start`
/// (index of run and pose) is always selected.
pub fn select(runs: &mut [Viewed], most: usize, start: [usize; 2]) -> usize {
    let every = count(runs).div_ceil(most.max(1)).max(1);
    for (index, viewed) in runs.iter_mut().enumerate() {
        let evenly = viewed.numbers.iter().copied().step_by(every);
        let mut numbers: Vec<usize> = evenly.chain(extremes(viewed.run)).collect();
        numbers.extend((index == start[0]).then_some(start[1]));
        numbers.sort_unstable();
        numbers.dedup();
        viewed.numbers = numbers;
    }
    every
}

pub fn run_of(
    (material, assembly): (Material, AssembledPair),
    phase: Option<(u32, u32)>,
    pose: ComparedPose,
) -> ComparedRun {
    ComparedRun {
        run: Run {
            material,
            assembly,
            phase,
        },
        poses: vec![pose],
    }
}

/// A run with the worst pose of the whole mesh cycle, where it is outside the revolutions' runs.
pub fn worst_outside_runs(analysis: &Analysis) -> Option<ComparedRun> {
    let verdict = analysis.verdict();
    let (extremes, pair, pose) = verdict.worst()?;
    let mut curves = analysis.curves.iter();
    let is_in_runs = curves.any(|run| number_of(run, pair, pose).is_some());
    let pair = (extremes.material, pair.clone());
    (!is_in_runs).then(|| run_of(pair, extremes.phase, pose.clone()))
}

/// The index of `pose` of `pair` in a run.
fn number_of(run: &ComparedRun, pair: &AssembledPair, pose: &ComparedPose) -> Option<usize> {
    let is_it = |own: &ComparedPose| own.simulated.pose == pose.simulated.pose;
    let number = run.poses.iter().position(is_it)?;
    (run.run.assembly == *pair).then_some(number)
}

/// Indices of run and pose of the worst pose of the whole mesh cycle; without one, of the worst of `runs` by [`worst_pose`], or
/// the first where none is in mesh.
pub fn start(runs: &[Viewed], analysis: &Analysis) -> Option<[usize; 2]> {
    let verdict = analysis.verdict();
    let proven = verdict.worst().and_then(|(_, pair, pose)| {
        let mut numbered = runs.iter().enumerate();
        numbered.find_map(|(index, viewed)| Some([index, number_of(viewed.run, pair, pose)?]))
    });
    let poses = || {
        let numbered = runs.iter().enumerate();
        numbered.flat_map(|(r, viewed)| {
            let poses = viewed.run.poses.iter().enumerate();
            poses.map(move |(p, pose)| ([r, p], &pose.simulated))
        })
    };
    proven
        .or_else(|| worst_pose(poses()))
        .or_else(|| poses().next().map(|(at, _)| at))
}

/// The pairs whose outlines a page draws: one for each two gears.
pub fn outlines<'a>(pairs: impl Iterator<Item = &'a AssembledPair>) -> Vec<&'a AssembledPair> {
    pairs.fold(Vec::new(), |mut outlines, pair| {
        if !outlines.iter().any(|known| known.has_gears_of(pair)) {
            outlines.push(pair);
        }
        outlines
    })
}

/// The poses of a run that must be selected.
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

//! What a study comes to: the least and the greatest backlash at each centre distance, the teeth that bind there,
//! and how far the formulas lie off. Lengths in mm, as `j_wt`.

use crate::compare::{ComparedPose, ComparedRun, Verdict};
use crate::mesh::{Status, first_least};
use crate::study::Material;

/// A pose and the run it belongs to.
#[derive(Debug, Clone, Copy)]
pub struct Found<'a> {
    /// The run.
    pub run: &'a ComparedRun,
    /// The pose.
    pub pose: &'a ComparedPose,
}

/// A number of poses and what they come to.
#[derive(Debug, Clone)]
pub struct Outcome<'a> {
    /// How many there are.
    pub poses: usize,
    /// How many have negative backlash.
    pub interfering: usize,
    /// How many are jammed: a tip sits in a root.
    pub jammed: usize,
    /// How many are out of mesh.
    pub apart: usize,
    /// The least backlash; of those that their error bounds cannot tell apart, the first.
    pub least: Option<Found<'a>>,
    /// The greatest, chosen likewise.
    pub greatest: Option<Found<'a>>,
    /// Mean of those that have a value.
    pub mean: Option<f64>,
    /// Least at `a − c`, greatest at `a + c`, `c` the bearing clearance; without it least and greatest.
    pub with_clearance: [Option<f64>; 2],
    /// Greatest error bound.
    pub error_bound: Option<f64>,
}

/// The poses of one centre distance: all of them, and material by material.
#[derive(Debug, Clone)]
pub struct AtDistance<'a> {
    /// `a`, mm.
    pub center_distance: f64,
    /// Both materials together.
    pub all: Outcome<'a>,
    /// Each material, in the order of the study.
    pub materials: Vec<(Material, Outcome<'a>)>,
}

/// Simulated minus a formula, over the poses that have both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Poses that have both.
    pub poses: usize,
    /// The greatest in amount, with its sign.
    pub largest: f64,
    /// Mean, with its sign.
    pub mean: f64,
}

/// The three formulas.
pub const MODELS: [fn(&ComparedPose) -> Option<f64>; 3] = [
    |pose| pose.michalec,
    |pose| pose.involute,
    |pose| pose.line_of_action,
];

impl<'a> Outcome<'a> {
    /// Of all poses of `runs`.
    pub fn of(runs: &[&'a ComparedRun]) -> Outcome<'a> {
        let all = || {
            let runs = runs.iter().copied();
            runs.flat_map(|run| run.poses.iter().map(move |pose| Found { run, pose }))
        };
        let count = |status: Status| {
            let of_status = |found: &Found| found.pose.swept.lost_motion.status() == status;
            all().filter(of_status).count()
        };
        let extreme = |sign: f64| {
            first_least(all().filter_map(|found| {
                let swept = &found.pose.swept;
                Some((found, sign * swept.backlash?, swept.error_bound?))
            }))
        };
        let backlash = || all().filter_map(|found| found.pose.swept.backlash);
        let valued = backlash().count();
        let end = |end: usize| all().filter_map(move |found| found.pose.swept.range()[end]);
        Outcome {
            poses: all().count(),
            interfering: count(Status::Interference),
            jammed: count(Status::Jammed),
            apart: count(Status::NoContact),
            least: extreme(1.0),
            greatest: extreme(-1.0),
            mean: (valued > 0).then(|| backlash().sum::<f64>() / valued as f64),
            with_clearance: [end(0).reduce(f64::min), end(1).reduce(f64::max)],
            error_bound: all()
                .filter_map(|found| found.pose.swept.error_bound)
                .reduce(f64::max),
        }
    }

    /// Whether every pose has room to turn.
    pub fn assembles(&self) -> bool {
        self.poses > 0 && self.interfering + self.jammed + self.apart == 0
    }
}

/// `runs` by centre distance and material, in order of first appearance.
pub fn by_distance<'a>(runs: &[&'a ComparedRun]) -> Vec<AtDistance<'a>> {
    let distance = |run: &ComparedRun| run.run.assembly.center_distance();
    let mut distances: Vec<f64> = Vec::new();
    for run in runs {
        if !distances.contains(&distance(run)) {
            distances.push(distance(run));
        }
    }
    let at = |center_distance: f64| {
        let here: Vec<&ComparedRun> = runs
            .iter()
            .copied()
            .filter(|run| distance(run) == center_distance)
            .collect();
        let of = |material: Material| {
            let runs = here.iter().copied();
            let runs: Vec<_> = runs.filter(|run| run.run.material == material).collect();
            (!runs.is_empty()).then(|| (material, Outcome::of(&runs)))
        };
        let materials = [Material::Most, Material::Least, Material::AsMeasured];
        AtDistance {
            center_distance,
            all: Outcome::of(&here),
            materials: materials.into_iter().filter_map(of).collect(),
        }
    };
    distances.into_iter().map(at).collect()
}

/// Simulated minus `model` over `runs`; `None` where no pose has both.
pub fn deviation(
    runs: &[&ComparedRun],
    model: fn(&ComparedPose) -> Option<f64>,
) -> Option<Deviation> {
    let differences = || {
        let poses = runs.iter().flat_map(|run| &run.poses);
        poses.filter_map(|pose| Some(pose.swept.backlash? - model(pose)?))
    };
    let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
    let poses = differences().count();
    Some(Deviation {
        poses,
        largest: differences().reduce(larger)?,
        mean: differences().sum::<f64>() / poses as f64,
    })
}

/// How many poses of `runs` have `verdict`.
pub fn count(runs: &[&ComparedRun], verdict: Verdict) -> usize {
    runs.iter().map(|run| run.count(verdict)).sum()
}

//! Outcome of a study: the least and the greatest backlash at each centre distance, the binding teeth, and the
//! differences from the formulas. Lengths in mm, as `j_wt`.

use crate::analysis::compare::{ComparedPose, ComparedRun, PoseVerdict, touches_off_line};
use crate::analysis::study::Material;
use crate::contact::{PoseResult, Status, first_least, worst_pose};

/// A pose and the run it belongs to.
#[derive(Debug, Clone, Copy)]
pub struct PoseOfRun<'a> {
    /// The run.
    pub run: &'a ComparedRun,
    /// The pose.
    pub pose: &'a ComparedPose,
}

/// A set of poses and its outcome.
#[derive(Debug, Clone)]
pub struct Outcome<'a> {
    /// Number of poses.
    pub poses: usize,
    /// Number of poses with negative backlash beyond their error bounds.
    pub interfering: usize,
    /// Number of poses whose backlash cannot be distinguished from zero.
    pub touching: usize,
    /// Number of jammed poses: a tip is in a root.
    pub jammed: usize,
    /// Number of poses out of mesh.
    pub out_of_mesh: usize,
    /// Number of unproven poses, whose values do not count.
    pub unproven: usize,
    /// Number of poses that are unproven at `a − c`, and at `a + c`.
    pub unproven_ends: [usize; 2],
    /// The worst: the first that is jammed, otherwise the one with the least backlash; unproven poses are excluded.
    pub worst: Option<PoseOfRun<'a>>,
    /// The pose with the least backlash; among those within their error bounds, the first.
    pub least: Option<PoseOfRun<'a>>,
    /// The pose with the greatest backlash, chosen in the same way.
    pub greatest: Option<PoseOfRun<'a>>,
    /// Whether every pose has a backlash and all are equal within their error bounds.
    pub uniform: bool,
    /// Mean of the values.
    pub mean: Option<f64>,
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
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
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
    /// The outcome of all poses of `runs`, and of the `picked` ones, which do not count for the mean.
    pub fn of(runs: &[&'a ComparedRun], picked: &[&'a ComparedRun]) -> Outcome<'a> {
        let all = picked.iter().chain(runs).copied();
        let all = all.flat_map(|run| run.poses.iter().map(move |pose| PoseOfRun { run, pose }));
        let all: Vec<(PoseOfRun, &PoseResult)> =
            all.map(|found| (found, &found.pose.simulated)).collect();
        let count = |holds: &dyn Fn(&PoseResult) -> bool| {
            let held = all.iter().filter(|(_, result)| holds(result));
            held.count()
        };
        let is = |status: Status| move |pose: &PoseResult| pose.status() == status;
        let bounded = all
            .iter()
            .filter_map(|(found, result)| Some((*found, result.backlash?, result.error_bound?)));
        let bounded: Vec<(PoseOfRun, f64, f64)> = bounded.collect();
        let extreme = |sign: f64| {
            let signed = bounded.iter();
            first_least(signed.map(|(found, value, bound)| (*found, sign * value, *bound)))
        };
        let upper_ends = bounded.iter().map(|(_, value, bound)| value + bound);
        let lower_ends = bounded.iter().map(|(_, value, bound)| value - bound);
        let lowest_and_highest = upper_ends.reduce(f64::min).zip(lower_ends.reduce(f64::max));
        let together = lowest_and_highest.is_some_and(|(high, low)| low <= high);
        let poses = runs.iter().flat_map(|run| &run.poses);
        let values: Vec<f64> = poses.filter_map(|pose| pose.simulated.backlash).collect();
        Outcome {
            poses: all.len(),
            interfering: count(&PoseResult::interferes),
            touching: count(&PoseResult::just_touches),
            jammed: count(&is(Status::Jammed)),
            out_of_mesh: count(&is(Status::NoContact)),
            unproven: count(&is(Status::Unproven)),
            unproven_ends: [0, 1].map(|end| count(&|pose| pose.is_end_unproven(end))),
            uniform: together && bounded.len() == all.len(),
            least: extreme(1.0),
            greatest: extreme(-1.0),
            mean: (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64),
            error_bound: all
                .iter()
                .filter_map(|(_, result)| result.error_bound)
                .reduce(f64::max),
            worst: worst_pose(all.iter().copied()),
        }
    }
}

/// `runs` and the poses `picked` out of others, as in [`Outcome::of`], by centre distance and material, in order of
/// first appearance.
pub fn by_distance<'a>(
    runs: &[&'a ComparedRun],
    picked: &[&'a ComparedRun],
) -> Vec<AtDistance<'a>> {
    let mut distances: Vec<f64> = Vec::new();
    for run in runs {
        let (distance, _) = run.run.group_key();
        if !distances.contains(&distance) {
            distances.push(distance);
        }
    }
    let at = |center_distance: f64| {
        let of = |material: Option<Material>| {
            let is_here = |run: &ComparedRun| {
                let (distance, own) = run.run.group_key();
                distance == center_distance && material.is_none_or(|wanted| wanted == own)
            };
            let [runs, picked] = [runs, picked].map(|runs| {
                let here = runs.iter().copied().filter(|run| is_here(run));
                here.collect::<Vec<_>>()
            });
            (!runs.is_empty()).then(|| Outcome::of(&runs, &picked))
        };
        let materials = [Material::Most, Material::Least, Material::AsMeasured].into_iter();
        Some(AtDistance {
            center_distance,
            all: of(None)?,
            materials: materials
                .filter_map(|material| Some((material, of(Some(material))?)))
                .collect(),
        })
    };
    distances.into_iter().filter_map(at).collect()
}

/// Simulated minus `model` over `runs`; `None` where no pose has both.
pub fn deviation(
    runs: &[&ComparedRun],
    model: fn(&ComparedPose) -> Option<f64>,
) -> Option<Deviation> {
    let differences = || {
        let poses = runs.iter().flat_map(|run| &run.poses);
        poses.filter_map(|pose| Some(pose.simulated.backlash? - model(pose)?))
    };
    let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
    let poses = differences().count();
    Some(Deviation {
        poses,
        largest: differences().reduce(larger)?,
        mean: differences().sum::<f64>() / poses as f64,
    })
}

/// Relation between simulation and model 3, in poses.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Agreement {
    /// All of them.
    pub poses: usize,
    /// Poses with both values.
    pub both: usize,
    /// Poses with both values that agree within tolerance and error bound.
    pub agree: usize,
    /// Poses below the formula that touch off the line of action.
    pub off_line: usize,
    /// Poses below the formula although involutes touch.
    pub below: usize,
    /// Poses above the formula.
    pub above: usize,
    /// Poses with only a simulated value: no involutes reach each other.
    pub simulated_alone: usize,
    /// Poses with only a formula value: the simulation finds them jammed.
    pub jammed: usize,
    /// Poses with only a formula value: the simulation finds them out of mesh. The formula is wrong there.
    pub apart: usize,
    /// Poses without either value.
    pub neither: usize,
    /// Unproven poses, which are not compared.
    pub unproven: usize,
    /// Poses that have a backlash and in which a tip corner, an undercut edge, a fillet or a root touches.
    pub touch_off_line: usize,
}

impl Agreement {
    /// The agreement of `runs`.
    pub fn of<'a>(runs: &[&'a ComparedRun]) -> Agreement {
        let mut count = Agreement::default();
        let with_pair = |run: &&'a ComparedRun| {
            let assembly = &run.run.assembly;
            run.poses.iter().map(move |pose| (assembly, pose))
        };
        for (assembly, pose) in runs.iter().flat_map(with_pair) {
            let simulated = pose.simulated.backlash.is_some();
            count.poses += 1;
            count.both += usize::from(pose.has_both());
            *match (simulated, pose.line_of_action.is_some(), pose.verdict) {
                (_, _, PoseVerdict::Unproven) => &mut count.unproven,
                (true, true, PoseVerdict::OffLine) => &mut count.off_line,
                (true, true, PoseVerdict::Below) => &mut count.below,
                (true, true, PoseVerdict::Above) => &mut count.above,
                (true, true, _) => &mut count.agree,
                (true, false, _) => &mut count.simulated_alone,
                (false, true, PoseVerdict::Above) => &mut count.apart,
                (false, true, _) => &mut count.jammed,
                (false, false, _) => &mut count.neither,
            } += 1;
            let found = assembly.data().zip(pose.simulated.proven());
            let off_line = found.is_some_and(|(pair, found)| touches_off_line(pair, found));
            count.touch_off_line += usize::from(simulated && off_line);
        }
        count
    }

    /// Poses with a simulated value.
    pub fn valued(&self) -> usize {
        self.both + self.simulated_alone
    }

    /// Poses at which the two disagree without a known reason.
    pub fn unexplained(&self) -> usize {
        self.below + self.above + self.apart
    }

    /// Poses for which the formula is wrong or has no value because the teeth touch off the line of action.
    pub fn formula_fails(&self) -> usize {
        self.off_line + self.simulated_alone
    }
}

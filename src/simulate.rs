//! From what a pair file asks for to what was found: every run of a study.

use crate::error::Error;
use crate::mesh::{CutPair, Method, SweptPose, sweep, worst_pose};
use crate::pair::Assembly;
use crate::study::{Material, RunPlan, Study};
use std::ops::ControlFlow;

/// One centre distance, material and, where they are run apart, assembly phase.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Which end of the thickness tolerances.
    pub material: Material,
    /// The gears at this centre distance.
    pub assembly: Assembly,
    /// Wheel and pinion tooth that name the assembly phase.
    pub phase: Option<(u32, u32)>,
    /// What was found, in order.
    pub poses: Vec<SweptPose>,
}

/// How many poses [`simulate`] will take.
///
/// # Errors
/// As [`Study::runs`].
pub fn pose_count(study: &Study) -> Result<usize, Error> {
    Ok(study.runs()?.iter().map(|run| run.matings.len()).sum())
}

/// Simulates every run of `study` by `method`. `tick` is called as each pose begins, from any thread; a break ends the work.
///
/// # Errors
/// [`Error::Interrupted`]. A contact that is lost or a certificate that fails leaves its pose [`crate::mesh::Unproven`].
pub fn simulate(
    study: &Study,
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<Run>, Error> {
    simulate_plans(study, study.runs()?, method, tick)
}

/// Simulates `plans` with the gears, clearance and chord of `study`; else as [`simulate`].
///
/// # Errors
/// As [`simulate`].
pub fn simulate_plans(
    study: &Study,
    plans: Vec<RunPlan>,
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<Run>, Error> {
    let cut = |material: Material| {
        let gears = study.materials.iter().find(|gears| gears.0 == material);
        gears.map(|(_, wheel, pinion)| match method {
            Method::Exact { .. } => CutPair::for_certificates(wheel, pinion),
            Method::Polygon | Method::Both => CutPair::new(wheel, pinion, study.chord),
        })
    };
    let cuts = [Material::Most, Material::Least, Material::AsMeasured].map(|m| (m, cut(m)));
    let mut runs = Vec::new();
    for plan in plans {
        let cut = cuts.iter().find(|(material, _)| *material == plan.material);
        let Some((_, Some(cut))) = cut else {
            continue;
        };
        let clearance = study.bearing_clearance;
        let poses = sweep(&plan.assembly, cut, method, &plan.matings, clearance, tick)?;
        runs.push(Run {
            material: plan.material,
            assembly: plan.assembly,
            phase: plan.phase,
            poses,
        });
    }
    Ok(runs)
}

/// The worst pose of all `runs`, as [`worst_pose`] chooses it, and its run; `None` when no pose is proven to be in mesh.
pub fn worst(runs: &[Run]) -> Option<(&Run, &SweptPose)> {
    worst_pose(runs.iter().flat_map(|run| {
        let poses = run.poses.iter();
        poses.map(move |pose| ((run, pose), pose))
    }))
}

//! Simulation of every run of a study.

use super::compare::{ComparedPose, ComparedRun, compared};
use super::study::{Material, RunPlan, Study};
use crate::contact::{CutPair, Method, sweep_blocks};
use crate::error::{Error, Tick};
use crate::parallel;

/// Simulates every run of `study` by `method`, compares its poses and keeps them (half a kilobyte each). For many poses see
/// [`crate::analysis::tally::simulate_by_blocks`].
///
/// `tick` is called as each pose begins, from any thread; a break ends the work.
///
/// # Errors
/// [`Error::Interrupted`]. A lost contact or a failed certificate leaves its pose [`crate::contact::Unproven`].
pub fn simulate(study: &Study, method: Method, tick: &Tick) -> Result<Vec<ComparedRun>, Error> {
    simulate_plans(study, study.runs()?, method, tick)
}

/// Simulates `plans` with the gears, clearance, chord and tolerance of `study`; else as [`simulate`].
///
/// # Errors
/// As [`simulate`].
pub fn simulate_plans(
    study: &Study,
    plans: Vec<RunPlan>,
    method: Method,
    tick: &Tick,
) -> Result<Vec<ComparedRun>, Error> {
    let mut runs: Vec<ComparedRun> = Vec::new();
    each_block::<Error>(
        study,
        plans,
        method,
        study.tolerance_um,
        tick,
        &mut |block| {
            if block.is_first {
                runs.push(ComparedRun {
                    run: block.plan.run.clone(),
                    poses: Vec::with_capacity(block.plan.matings.len()),
                });
            }
            if let Some(run) = runs.last_mut() {
                run.poses.extend(block.poses);
            }
            Ok(())
        },
    )?;
    Ok(runs)
}

/// Some poses of one run.
pub(super) struct Block<'a> {
    pub plan: &'a RunPlan,
    /// The poses in order, after those of the previous block; empty for a run without poses.
    pub poses: Vec<ComparedPose>,
    /// Whether the run begins.
    pub is_first: bool,
    /// Whether it ends.
    pub is_last: bool,
}

/// As [`simulate_plans`], its poses compared within `tolerance_um` and delivered to `take` block by block, so that they need not be kept.
///
/// # Errors
/// As [`simulate`], and of `take`.
pub(super) fn each_block<E: From<Error>>(
    study: &Study,
    plans: Vec<RunPlan>,
    method: Method,
    tolerance_um: f64,
    tick: &Tick,
    take: &mut dyn FnMut(Block) -> Result<(), E>,
) -> Result<(), E> {
    let cut = |material: Material| {
        let gears = study.materials.iter().find(|gears| gears.0 == material);
        gears.map(|(_, wheel, pinion)| match method {
            Method::Exact { .. } | Method::Checked => CutPair::for_certificates(wheel, pinion),
            Method::Polygon | Method::Both => CutPair::new(wheel, pinion, study.chordal_error),
        })
    };
    let cuts = [Material::Most, Material::Least, Material::AsMeasured].map(|m| (m, cut(m)));
    for plan in &plans {
        let (assembly, matings) = (&plan.run.assembly, &plan.matings);
        let mut done = 0;
        let mut each = |poses: Vec<_>| {
            let is_first = done == 0;
            done += poses.len();
            take(Block {
                plan,
                poses: parallel::map(poses, |found| compared(assembly, found, tolerance_um)),
                is_first,
                is_last: done == matings.len(),
            })
        };
        if matings.is_empty() {
            each(Vec::new())?;
            continue;
        }
        let mut cuts = cuts.iter();
        let cut = cuts.find(|(material, _)| *material == plan.run.material);
        let cut = cut.and_then(|(_, cut)| cut.as_ref());
        let clearance = study.bearing_clearance;
        sweep_blocks(assembly, cut, method, matings, clearance, tick, &mut each)?;
    }
    Ok(())
}

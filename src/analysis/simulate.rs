//! Simulation of every run of a study.

use crate::analysis::study::{Material, RunPlan, Study};
use crate::contact::{CutPair, Method, PoseResult, sweep_blocks};
use crate::error::{Error, Tick};
use crate::outline::AssembledPair;

/// One centre distance, material and, where they are run apart, assembly phase.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Which end of the thickness tolerances.
    pub material: Material,
    /// The gears at this centre distance.
    pub assembly: AssembledPair,
    /// Wheel and pinion tooth that name the assembly phase.
    pub phase: Option<(u32, u32)>,
    /// Results of the poses, in order.
    pub poses: Vec<PoseResult>,
}

/// Simulates every run of `study` by `method`, and keeps every pose (half a kilobyte each). For many poses see
/// [`crate::analysis::tally::simulate_by_blocks`].
///
/// `tick` is called as each pose begins, from any thread; a break ends the work.
///
/// # Errors
/// [`Error::Interrupted`]. A lost contact or a failed certificate leaves its pose [`crate::contact::Unproven`].
pub fn simulate(study: &Study, method: Method, tick: &Tick) -> Result<Vec<Run>, Error> {
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
    tick: &Tick,
) -> Result<Vec<Run>, Error> {
    let mut runs: Vec<Run> = Vec::new();
    each_block::<Error>(study, plans, method, tick, &mut |block| {
        if block.first {
            runs.push(Run {
                material: block.material,
                assembly: block.assembly.clone(),
                phase: block.phase,
                poses: Vec::with_capacity(block.of),
            });
        }
        if let Some(run) = runs.last_mut() {
            run.poses.extend(block.poses);
        }
        Ok(())
    })?;
    Ok(runs)
}

/// Some poses of one run, with their results.
pub struct Block<'a> {
    /// As [`Run::material`].
    pub material: Material,
    /// As [`Run::assembly`].
    pub assembly: &'a AssembledPair,
    /// As [`Run::phase`].
    pub phase: Option<(u32, u32)>,
    /// The results in order, after those of the previous block; empty for a run without poses.
    pub poses: Vec<PoseResult>,
    /// How many poses the run has.
    pub of: usize,
    /// Whether the run begins.
    pub first: bool,
    /// Whether it ends.
    pub last: bool,
}

/// As [`simulate_plans`], its poses delivered to `take` block by block, so that they need not be kept.
///
/// # Errors
/// As [`simulate`], and of `take`.
pub fn each_block<E: From<Error>>(
    study: &Study,
    plans: Vec<RunPlan>,
    method: Method,
    tick: &Tick,
    take: &mut dyn FnMut(Block) -> Result<(), E>,
) -> Result<(), E> {
    let cut = |material: Material| {
        let gears = study.materials.iter().find(|gears| gears.0 == material);
        gears.map(|(_, wheel, pinion)| match method {
            Method::Exact { .. } | Method::Checked => CutPair::for_certificates(wheel, pinion),
            Method::Polygon | Method::Both => CutPair::new(wheel, pinion, study.chord),
        })
    };
    let cuts = [Material::Most, Material::Least, Material::AsMeasured].map(|m| (m, cut(m)));
    for plan in plans {
        let of = plan.matings.len();
        let block = |poses, done| Block {
            material: plan.material,
            assembly: &plan.assembly,
            phase: plan.phase,
            first: done == 0,
            last: false,
            of,
            poses,
        };
        if of == 0 {
            let empty = block(Vec::new(), 0);
            take(Block {
                last: true,
                ..empty
            })?;
            continue;
        }
        let (clearance, mut done) = (study.bearing_clearance, 0);
        let each = &mut |poses: Vec<PoseResult>| {
            let found = poses.len();
            let next = block(poses, done);
            done += found;
            take(Block {
                last: done == of,
                ..next
            })
        };
        let cut = cuts.iter().find(|(material, _)| *material == plan.material);
        let cut = cut.and_then(|(_, cut)| cut.as_ref());
        let (assembly, matings) = (&plan.assembly, &plan.matings);
        sweep_blocks(assembly, cut, method, matings, clearance, tick, each)?;
    }
    Ok(())
}

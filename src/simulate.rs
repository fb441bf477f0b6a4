//! From what a pair file asks for to what was found: every run of a study.

use crate::error::Error;
use crate::mesh::{CutPair, SweptPose, sweep};
use crate::pair::Assembly;
use crate::study::{Material, Study};
use std::ops::ControlFlow;

/// One centre distance and material: its poses in the order of the study.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Which end of the thickness tolerances.
    pub material: Material,
    /// The gears at this centre distance.
    pub assembly: Assembly,
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

/// Simulates every run of `study`. `tick` is called after each pose, from any thread; a break ends the work.
///
/// # Errors
/// A contact that was lost, or [`Error::Interrupted`].
pub fn simulate(
    study: &Study,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<Run>, Error> {
    let cuts: Vec<(Material, CutPair)> = study
        .materials
        .iter()
        .map(|(material, wheel, pinion)| (*material, CutPair::new(wheel, pinion, study.chord)))
        .collect();
    let mut runs = Vec::new();
    for plan in study.runs()? {
        for (material, cut) in &cuts {
            if *material == plan.material {
                runs.push(Run {
                    material: plan.material,
                    poses: sweep(
                        &plan.assembly,
                        cut,
                        &plan.matings,
                        study.bearing_clearance,
                        tick,
                    )?,
                    assembly: plan.assembly.clone(),
                });
            }
        }
    }
    Ok(runs)
}

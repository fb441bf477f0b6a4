//! Simulation of every run of a study.

use super::compare::{ComparedPose, ComparedRun, compared};
use super::study::{Material, RunPlan, Study};
use crate::contact::{CutPair, Method, PoseResult, sweep_blocks};
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
    Simulation::new(study, method, study.tolerance_um, tick).runs(plans)
}

/// The simulation of runs of a study.
pub(super) struct Simulation<'a> {
    study: &'a Study,
    method: Method,
    tolerance_um: f64,
    tick: &'a Tick<'a>,
    /// The gears of each material, cut for polygons.
    cuts: Vec<(Material, CutPair)>,
}

impl<'a> Simulation<'a> {
    /// Runs with the gears, clearance and chord of `study`, whose poses are compared within `tolerance_um`. `tick` as of [`simulate`].
    pub fn new(
        study: &'a Study,
        method: Method,
        tolerance_um: f64,
        tick: &'a Tick<'a>,
    ) -> Simulation<'a> {
        let cuts = study.materials.iter().map(|(material, wheel, pinion)| {
            let cut = match method {
                Method::Exact { .. } | Method::Checked => CutPair::for_certificates(wheel, pinion),
                Method::Polygon | Method::Both => CutPair::new(wheel, pinion, study.chordal_error),
            };
            (*material, cut)
        });
        Simulation {
            cuts: cuts.collect(),
            study,
            method,
            tolerance_um,
            tick,
        }
    }

    /// The runs of `plans` with their poses.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn runs(
        &self,
        plans: impl IntoIterator<Item = RunPlan>,
    ) -> Result<Vec<ComparedRun>, Error> {
        let run = |plan: RunPlan| {
            let mut poses = Vec::with_capacity(plan.matings.len());
            let mut keep = |block: Vec<ComparedPose>| {
                poses.extend(block);
                Ok::<(), Error>(())
            };
            self.each_block(&plan, &mut keep)?;
            let run = plan.run;
            Ok(ComparedRun { run, poses })
        };
        plans.into_iter().map(run).collect()
    }

    /// Delivers the poses of a run to `take` block by block, in order, so that they need not be kept.
    ///
    /// # Errors
    /// As [`simulate`], and of `take`.
    pub fn each_block<E: From<Error>>(
        &self,
        plan: &RunPlan,
        take: &mut dyn FnMut(Vec<ComparedPose>) -> Result<(), E>,
    ) -> Result<(), E> {
        let (run, matings) = (&plan.run, &plan.matings);
        let (material, assembly) = (&run.material, &run.assembly);
        if matings.is_empty() {
            return Ok(());
        }
        let cut = self.cuts.iter().find(|(of, _)| of == material);
        let (cut, clearance) = (cut.map(|(_, cut)| cut), self.study.clearance_of_poses());
        let tolerance_um = self.tolerance_um;
        let mut each = |mut poses: Vec<PoseResult>| {
            if self.study.bearing_ends.is_some() {
                for pose in &mut poses {
                    pose.with_clearance = Some([Ok(None), Ok(None)]);
                }
            }
            take(parallel::map(poses, |found| {
                compared(assembly, found, tolerance_um)
            }))
        };
        sweep_blocks(
            assembly,
            cut,
            self.method,
            matings,
            clearance,
            self.tick,
            &mut each,
        )
    }
}

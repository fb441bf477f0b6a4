//! Data for the verdict where a command keeps no poses: the extremes of the mesh cycle, and the failing checks.

use super::progress::Progress;
use crate::error::Error;
use gearlash::analysis::diagnosis::{self, CheckName, PoseEvidence};
use gearlash::analysis::extremes::{CycleExtremes, extremes, run_count};
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{Piece, RunTally, simulate_by_blocks};
use gearlash::contact::Method;
use std::ops::ControlFlow;

/// The certified extremes of `study`, and the checks that fail at its poses, under a progress bar.
pub(super) fn extremes_and_failed_checks(
    study: &Study,
) -> Result<(CycleExtremes, Vec<CheckName>), Error> {
    let progress = Progress::of(run_count(study)? + study.pose_count(), "steps");
    let method = Method::Exact { certify: true };
    let cycle = progress.searching(|| extremes(study, method, &|| progress.tick()))?;
    let exact = Method::Exact { certify: false };
    let tick = || progress.tick();
    let none = &mut |_: Piece| Ok::<(), Error>(());
    let runs = simulate_by_blocks(study, exact, study.tolerance_um, 0, &tick, none)?;
    let failed = failed_checks(study, &runs, &cycle)?;
    Ok((cycle, failed))
}

/// The checks that fail at the poses of `runs`.
pub(super) fn failed_checks(
    study: &Study,
    runs: &[RunTally],
    cycle: &CycleExtremes,
) -> Result<Vec<CheckName>, Error> {
    let evidence: Vec<PoseEvidence> = runs.iter().filter_map(|run| run.evidence.clone()).collect();
    let on = || ControlFlow::Continue(());
    Ok(diagnosis::failed_checks(study, &evidence, cycle, &on)?)
}

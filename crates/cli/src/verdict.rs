//! What the verdict needs where a command keeps no poses: the checks that fail.

use super::progress::Progress;
use crate::error::Error;
use gearlash::analysis::diagnosis::{self, Seen};
use gearlash::analysis::extremes::CycleExtremes;
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{Piece, simulate_by_blocks};
use gearlash::contact::Method;
use std::ops::ControlFlow;

/// Ids of the checks of `study` that fail at its poses; `cycle` are its extremes. A tick for each pose.
pub(super) fn failed_checks(
    study: &Study,
    cycle: &CycleExtremes,
    progress: &Progress,
) -> Result<Vec<&'static str>, Error> {
    let exact = Method::Exact { certify: false };
    let tick = || progress.tick();
    let none = &mut |_: Piece| Ok::<(), Error>(());
    let runs = simulate_by_blocks(study, exact, study.tolerance_um, 0, &tick, none)?;
    let seen: Vec<Seen> = runs.into_iter().map(|run| run.seen).collect();
    let on = || ControlFlow::Continue(());
    Ok(diagnosis::failed_checks(study, &seen, cycle, &on)?)
}

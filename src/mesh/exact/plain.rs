//! The plain path: branch and bound over every facing pair, nothing left out.

use super::branch::{Curves, Unsettled, search};
use super::facing::Stand;
use super::ties::{Ties, Touching};

/// The pair that touches first, from the greatest gap of every pair in reach.
///
/// # Errors
/// The step whose pair could not be settled.
pub(super) fn touching(stand: &Stand) -> Result<Option<Touching>, (i64, Unsettled)> {
    let mut ties = Ties::new(stand.facing);
    for step in stand.steps() {
        let (ours, theirs) = (stand.locked(step), stand.free(step));
        let found = search(&ours, &theirs, stand.origin, ties.level(), Curves::ALL);
        if let Some(hit) = found.map_err(|lost| (step, lost))? {
            ties.offer(step, hit);
        }
    }
    Ok(ties.choose())
}

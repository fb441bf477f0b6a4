//! The plain path: branch and bound over every facing pair, nothing left out.

use super::branch::{Hit, Unsettled, search};
use super::facing::{Stand, Touching};

/// The pair that touches first, from the greatest gap of every pair in reach.
///
/// # Errors
/// The step whose pair could not be settled.
pub(super) fn touching(stand: &Stand) -> Result<Option<Touching>, (i64, Unsettled)> {
    let tie = stand.facing.tie();
    let mut hits: Vec<(i64, Hit)> = Vec::new();
    let mut greatest = f64::NEG_INFINITY;
    for step in stand.steps() {
        let found = search(
            &stand.locked(step),
            &stand.free(step),
            stand.origin,
            greatest - tie,
        )
        .map_err(|lost| (step, lost))?;
        if let Some(hit) = found {
            greatest = greatest.max(hit.gap);
            hits.push((step, hit));
        }
    }
    Ok(stand.choose(&hits))
}

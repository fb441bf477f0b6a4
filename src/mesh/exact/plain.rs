//! The plain path: branch and bound over every facing pair, nothing left out.

use super::branch::{MOST_NODES, search};
use super::curves::{Curves, Unsettled};
use super::facing::Stand;
use super::lands::without_lands;
use super::ties::{Ties, Touching};

/// The pair that touches first, from the greatest gap of every pair in reach; lands in closed form.
///
/// # Errors
/// The step whose pair could not be settled.
#[cold]
pub(super) fn touching(stand: &Stand) -> Result<Option<Touching>, (i64, Unsettled)> {
    let mut ties = Ties::new(stand.facing);
    stand.on_lands(Curves::ALL, &mut ties);
    over(stand, ties, without_lands(Curves::ALL), MOST_NODES)
}

/// The same by nothing but the search, with more patience.
///
/// # Errors
/// As [`touching`].
#[cold]
pub(super) fn by_search(stand: &Stand) -> Result<Option<Touching>, (i64, Unsettled)> {
    over(stand, Ties::new(stand.facing), Curves::ALL, 16 * MOST_NODES)
}

fn over(
    stand: &Stand,
    mut ties: Ties,
    curves: Curves,
    mut nodes_left: usize,
) -> Result<Option<Touching>, (i64, Unsettled)> {
    for step in stand.steps() {
        let (ours, theirs) = (stand.locked(step), stand.free(step));
        let found = search(
            &ours,
            &theirs,
            stand.origin,
            ties.level(),
            curves,
            &mut nodes_left,
        );
        if let Some(hit) = found.map_err(|lost| (step, lost))? {
            ties.offer(step, hit);
        }
    }
    Ok(ties.choose())
}

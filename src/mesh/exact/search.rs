//! The plain path: branch and bound over every facing pair, nothing left out.

use super::branch::{MOST_NODES, search};
use super::curves::{Curves, SearchExhausted};
use super::flank_problem::PosedFlanks;
use super::lands::without_lands;
use super::tightest::{TightestContacts, Touching};

/// The pair that touches first, from the greatest gap of every pair in reach; lands in closed form.
///
/// # Errors
/// The step whose pair could not be settled.
#[cold]
pub(super) fn touching(stand: &PosedFlanks) -> Result<Option<Touching>, (i64, SearchExhausted)> {
    let mut ties = TightestContacts::new(stand.problem);
    stand.on_lands(Curves::ALL, &mut ties);
    over(stand, ties, without_lands(Curves::ALL), MOST_NODES)
}

/// The same by nothing but the search, with more patience.
///
/// # Errors
/// As [`touching`].
#[cold]
pub(super) fn by_search(stand: &PosedFlanks) -> Result<Option<Touching>, (i64, SearchExhausted)> {
    over(
        stand,
        TightestContacts::new(stand.problem),
        Curves::ALL,
        16 * MOST_NODES,
    )
}

fn over(
    stand: &PosedFlanks,
    mut ties: TightestContacts,
    curves: Curves,
    mut nodes_left: usize,
) -> Result<Option<Touching>, (i64, SearchExhausted)> {
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

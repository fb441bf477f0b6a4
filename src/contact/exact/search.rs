//! The plain path: branch and bound over every facing pair, nothing left out.

use super::branch::search;
use super::curves::{Curves, SearchExhausted};
use super::flank_problem::PosedFlanks;
use super::lands::without_lands;
use super::placed::Placed;
use super::tightest::{TightestContacts, Touching};
use crate::contact::Effort;
use crate::contact::gap::MOST_NODES;
use crate::gear::ProfilePart;

/// What a caller wants of a side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asked<'a> {
    /// What is done is taken from here.
    pub effort: &'a Effort,
    /// A gap no greater than this need not be found.
    pub floor: f64,
}

/// The pair that touches first, from the greatest gap of every pair in reach; lands in closed form.
///
/// # Errors
/// The step whose pair could not be settled.
#[cold]
pub(super) fn touching(
    posed: &PosedFlanks,
    asked: Asked,
) -> Result<Option<Touching>, (i64, SearchExhausted)> {
    let mut tightest_contacts = TightestContacts::new(posed.problem);
    posed.on_lands(Curves::ALL, &mut tightest_contacts);
    let mut curves = without_lands(Curves::ALL);
    let (locked, free) = (&posed.problem.locked, &posed.problem.free);
    if locked.is_modified() || free.is_modified() {
        // Of a measured flank the search of the whole has no bound that is near.
        let part = ProfilePart::Involute;
        for step in posed.steps() {
            let found = posed.flanks_anyhow(step, tightest_contacts.level(), 0.0, asked.effort);
            if let Some(candidate) = found.ok_or((step, SearchExhausted(part, part)))? {
                tightest_contacts.offer(step, candidate);
            }
        }
        curves = curves.without(part, part);
    }
    over(posed, tightest_contacts, |_| curves, asked, MOST_NODES)
}

/// The same by nothing but the search, with more patience.
///
/// # Errors
/// As [`touching`].
#[cold]
pub(super) fn by_search(
    posed: &PosedFlanks,
    asked: Asked,
) -> Result<Option<Touching>, (i64, SearchExhausted)> {
    over(
        posed,
        TightestContacts::new(posed.problem),
        |_| Curves::ALL,
        asked,
        16 * MOST_NODES,
    )
}

/// The pair that touches first, of what is known and what a search finds over the `curves` of each step's locked half tooth.
///
/// # Errors
/// As [`touching`].
pub(super) fn over(
    posed: &PosedFlanks,
    mut tightest_contacts: TightestContacts,
    curves: impl Fn(&Placed) -> Curves,
    asked: Asked,
    most_nodes: usize,
) -> Result<Option<Touching>, (i64, SearchExhausted)> {
    let most_nodes = asked.effort.left().min(most_nodes as u64) as usize;
    let mut nodes_left = most_nodes;
    for step in posed.steps() {
        let locked = posed.locked(step);
        let curves = curves(&locked);
        if curves.is_empty() {
            continue;
        }
        let found = search(
            &locked,
            &posed.free(step),
            posed.origin_of(step),
            tightest_contacts.level().max(asked.floor),
            curves,
            &mut nodes_left,
        );
        if found.is_err() {
            asked.effort.spend((most_nodes - nodes_left) as u64);
        }
        if let Some(candidate) = found.map_err(|lost| (step, lost))? {
            tightest_contacts.offer(step, candidate);
        }
    }
    asked.effort.spend((most_nodes - nodes_left) as u64);
    Ok(tightest_contacts.choose())
}

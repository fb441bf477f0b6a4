//! The general method: branch and bound over every facing pair.

use super::branch::search;
use super::curves::{CurvePairs, SearchExhausted};
use super::flank_problem::PosedFlanks;
use super::lands::{offer_lands, without_lands};
use super::modified::pieces::greatest_gap_of_flanks;
use super::placed::PlacedHalf;
use super::tightest::{FirstContact, TightestContacts};
use crate::contact::Effort;
use crate::contact::gap::MOST_NODES;
use crate::gear::ProfilePart;

/// The first contact of a side, or the step of the pair that stays undecided.
pub(super) type SideFound = Result<Option<FirstContact>, (i64, SearchExhausted)>;

/// The request for one side.
#[derive(Clone, Copy)]
pub(super) struct SideRequest<'a> {
    /// Budget to charge.
    pub effort: &'a Effort<'a>,
    /// Gaps up to this need not be found.
    pub floor: f64,
}

/// The first contact, from the greatest gap of every pair in reach. Lands use the closed form.
#[cold]
pub(super) fn first_contact(posed: &PosedFlanks, request: SideRequest) -> SideFound {
    let mut tightest_contacts = TightestContacts::new(posed.problem);
    offer_lands(posed, CurvePairs::ALL, &mut tightest_contacts);
    let mut curves = without_lands(CurvePairs::ALL);
    let (locked, free) = (&posed.problem.locked, &posed.problem.free);
    if locked.is_modified() || free.is_modified() {
        // A search over a whole measured flank has no tight bound.
        let part = ProfilePart::Involute;
        for step in posed.steps() {
            let found = greatest_gap_of_flanks(
                posed,
                step,
                tightest_contacts.least_tied_gap(),
                0.0,
                request.effort,
            );
            if let Some(candidate) = found.ok_or((step, SearchExhausted(part, part)))? {
                tightest_contacts.offer(step, candidate);
            }
        }
        curves = curves.without(part, part);
    }
    over(posed, tightest_contacts, |_| curves, request, MOST_NODES)
}

/// Branch and bound alone, with a larger budget.
#[cold]
pub(super) fn by_search(posed: &PosedFlanks, request: SideRequest) -> SideFound {
    over(
        posed,
        TightestContacts::new(posed.problem),
        |_| CurvePairs::ALL,
        request,
        16 * MOST_NODES,
    )
}

/// The first contact, from the known candidates and a search over the `curves` of each step's locked half tooth.
pub(super) fn over(
    posed: &PosedFlanks,
    mut tightest_contacts: TightestContacts,
    curves: impl Fn(&PlacedHalf) -> CurvePairs,
    request: SideRequest,
    most_nodes: usize,
) -> SideFound {
    let most_nodes = request.effort.left().min(most_nodes as u64) as usize;
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
            tightest_contacts.least_tied_gap().max(request.floor),
            curves,
            &mut nodes_left,
        );
        if found.is_err() {
            request.effort.spend((most_nodes - nodes_left) as u64);
        }
        if let Some(candidate) = found.map_err(|lost| (step, lost))? {
            tightest_contacts.offer(step, candidate);
        }
    }
    request.effort.spend((most_nodes - nodes_left) as u64);
    Ok(tightest_contacts.choose())
}

//! The least and the greatest lost motion of a pair over its whole mesh cycle and every rotation, proven.
//!
//! Each side has room until its tightest pair of half teeth touches; the lost motion is the sum of both. Two bounds hold over a stretch of
//! a mating. The lower bound treats each pair as nothing but involutes and their ends, and adds what fillets leave below the form circle
//! ([`separation`](super::separation), [`tip_at_fillet`]). The upper bound is the room of any one pair. Tables ([`table`]) rule out nearly
//! every mating of a long cycle. The rest is cut where its bound is worst, until no stretch can beat the best known pose by more than the
//! requested width. So the bracket covers every rotation of every mating, and one of its ends is a pose of the exact method.
//!
//! The lower bound has the same conditions under which the exact method needs no search ([`super::super::search_free_proof`]). If they
//! fail, poses are sampled, and the result reports it.

mod along_face;
mod cell;
mod clearance;
mod corner_path;
mod enclosed;
mod extreme;
mod fillet;
mod held_side;
mod line_bends;
mod mesh_cycle;
mod passed_tip;
mod rolls;
mod room;
mod sample;
mod search;
mod shift;
mod side_over_face;
mod side_stretch;
mod side_table;
mod table;
mod tip_at_fillet;
mod tips_at_fillets_over_face;

use super::ExactKernel;
use crate::contact::body::FarFlanks;
use crate::contact::cycle_search::CycleSearch;
use crate::contact::effort::Effort;
use crate::error::{Error, go_on};
use crate::pair::{GearPair, Mating};
use along_face::AlongFaceCells;
pub use extreme::{Doubt, Extreme, Extremes, PROVEN_WIDTH, PROVEN_WIDTH_DRAWN};
pub(crate) use extreme::{End, is_proven};
use extreme::{ExaminedPoses, UNKNOWN};
use mesh_cycle::MeshCycle;
use search::Search;
use table::CycleTable;

/// Parts of the remaining effort: a search of one cycle may use one part in the first number. A search for a single end, at each of about
/// ten other centre distances, may use one part in the second (tuned).
const PARTS_OF_EFFORT: [u64; 2] = [2, 4];

/// The extremes of the `assembly` of `kernel`, over `matings` pitches from `first` on. Each proven bracket is at most `width` mm wide.
///
/// # Errors
/// None for a pair with a kernel: a lost contact is a [`Doubt`].
pub fn cycle_extremes(
    kernel: &ExactKernel,
    assembly: &GearPair,
    first: Mating,
    matings: u64,
    width: f64,
) -> Result<Extremes, Error> {
    let (over, effort) = ((first, matings), &Effort::of_extremes(assembly, &go_on));
    cycle_extremes_within(kernel, assembly, over, width, effort, &End::BOTH)
}

/// Whether a quick test shows that no tip reaches a fillet or a root at any pose of the `assembly` of `kernel`, or at any greater centre
/// distance. Then involutes, their ends and tip lands touch first.
pub(crate) fn keeps_to_involutes(kernel: &ExactKernel, assembly: &GearPair) -> bool {
    if assembly.is_modified()
        || assembly.deviates_along_face()
        || kernel.section.never_assembles
        || kernel.section.bodies.is_some()
        || !kernel.is_direct()
    {
        return false;
    }
    let effort = Effort::endless();
    let cycle = MeshCycle::new(kernel, assembly, (Mating::FIRST, 1), &effort);
    if !stays_on_involutes(&cycle) {
        return false;
    }
    let table = CycleTable::new(&cycle);
    table.stops_before_far_flanks(&cycle, f64::INFINITY) && !table.has_tips_at_fillets()
}

/// The extremes `of` a cycle, within a part ([`PARTS_OF_EFFORT`]) of the budget `effort`; other ends are `None`. A search for the least
/// alone stops at the first jammed pose, one for the greatest alone at the first pose that is out of mesh.
///
/// # Errors
/// As [`cycle_extremes`].
pub(crate) fn cycle_extremes_within(
    kernel: &ExactKernel,
    assembly: &GearPair,
    over: (Mating, u64),
    width: f64,
    effort: &Effort,
    of: &[End],
) -> Result<Extremes, Error> {
    let parts = match of {
        [_] => PARTS_OF_EFFORT[1],
        _ => PARTS_OF_EFFORT[0],
    };
    let own = effort.part(parts);
    let found = search_extremes(&MeshCycle::new(kernel, assembly, over, &own), width, of);
    effort.spend(own.used());
    let found = found?;
    Ok(Extremes {
        least: found.least.filter(|_| of.contains(&End::Least)),
        greatest: found.greatest.filter(|_| of.contains(&End::Greatest)),
        ..found
    })
}

fn search_extremes(cycle: &MeshCycle, width: f64, of: &[End]) -> Result<Extremes, Error> {
    let only = match of {
        [end] => Some(*end),
        _ => None,
    };
    let mut found = ExaminedPoses::default();
    if let Some(cells) = AlongFaceCells::new(cycle) {
        let found = of_cells(cycle, &cells, width, of);
        return if cycle.assembly.is_modified() {
            enclosed::narrowed(cycle, found, width, of)
        } else {
            Ok(found)
        };
    }
    if cycle.assembly.is_modified() || cycle.assembly.deviates_along_face() {
        sample::sample(cycle, &mut found, only)?;
        let bounds = if cycle.assembly.leans() {
            [UNKNOWN; 2]
        } else {
            enclosed::bounds(cycle, width, of)?
        };
        return Ok(found.extremes(cycle, bounds));
    }
    // Without a solver flanks are no involutes, or base circles may overlap.
    let ExactKernel { section, helical } = cycle.kernel;
    if section.never_assembles
        || section.bodies.is_some()
        || section.solver.is_none()
        || helical
            .as_ref()
            .is_some_and(|helical| !helical.has_line_contact())
    {
        sample::sample(cycle, &mut found, only)?;
        return Ok(found.extremes(cycle, [UNKNOWN; 2]));
    }
    let table = CycleTable::new(cycle);
    let width = width / cycle.per_radian();
    let search = |which| Search {
        cycle,
        table: &table,
        width: search::PROOF_SHARE * width,
        equal: search::EQUAL_SHARE * width,
        which,
        // A third each for both searches and for the poses that are sampled if the searches do not close. A search for the least alone
        // samples none.
        reserved: match which {
            End::Greatest => cycle.effort.left() / 3 * 2,
            End::Least if only.is_some() => 0,
            End::Least => cycle.effort.left() / 3,
        },
        only,
    };
    let mut stays = stays_on_involutes(cycle);
    // Where far flanks are in reach, the greatest may show that the free gear stops before them.
    let asks_greatest =
        stays && of.contains(&End::Least) && !table.stops_before_far_flanks(cycle, f64::INFINITY);
    let wanted = [End::Greatest, End::Least];
    let wanted = wanted.into_iter().filter(|which| match which {
        End::Greatest => asks_greatest || of.contains(which),
        End::Least => stays && of.contains(which),
    });
    let searches: Vec<Search> = wanted.map(search).collect();
    let (mut least, mut greatest) = (UNKNOWN, UNKNOWN);
    let mut ranked = search::rank(&searches, &mut found)?;
    for (search, ranked) in searches.iter().zip(&mut ranked) {
        if asks_greatest && search.which == End::Least {
            let most = found.most(greatest) + width;
            stays = table.stops_before_far_flanks(cycle, most);
            if !stays {
                continue;
            }
        }
        let proof = search.run(ranked, &mut found)?;
        match search.which {
            End::Least => least = proof,
            End::Greatest => greatest = proof,
        }
    }
    if !stays && of.contains(&End::Least) {
        sample::sample(cycle, &mut found, only)?;
    }
    for (search, ranked) in searches.iter().zip(ranked) {
        search.report_first_equal(ranked.near, &mut found)?;
    }
    Ok(found.extremes(cycle, [least, greatest]))
}

/// The extremes `of` a pair that deviates along the face, by bounds over cells.
fn of_cells(cycle: &MeshCycle, cells: &AlongFaceCells, width: f64, of: &[End]) -> Extremes {
    let search = CycleSearch {
        cells,
        distinct: cycle.distinct_matings(),
        matings: cycle.matings,
        width: width / cycle.per_radian(),
        radius: cycle.per_radian(),
        // Each extreme may use twice the part: for a verdict some seconds (tuned).
        most_effort: cycle.effort.left().saturating_mul(PARTS_OF_EFFORT[0]),
        tick: cycle.effort.tick,
    };
    let (found, used) = search.extremes(of);
    cycle.effort.spend(used);
    found
}

/// Whether only involutes, their ends and tip lands can touch, and corners on fillets, and pairs of helical teeth have line contact.
fn stays_on_involutes_and_fillets(cycle: &MeshCycle) -> bool {
    let ExactKernel { section, helical } = cycle.kernel;
    !section.never_assembles
        && section.bodies.is_none()
        && section.solver.is_some()
        && helical
            .as_ref()
            .is_none_or(|helical| helical.has_line_contact())
        && stays_on_involutes(cycle)
        && (section.far_flanks == FarFlanks::Clear
            || CycleTable::new(cycle).stops_before_far_flanks(cycle, f64::INFINITY))
}

/// Whether of near half teeth only involutes, their ends and tip lands can touch, and corners on fillets, which [`tip_at_fillet`] bounds.
fn stays_on_involutes(cycle: &MeshCycle) -> bool {
    let side = &cycle.sides[0];
    let problem = side.problem;
    let forms = problem.locked.shape.form_radius() + problem.free.shape.form_radius();
    cycle.kernel.is_direct() && forms + side.off[0] + side.off[1] < problem.distance
}

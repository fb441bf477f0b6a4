//! Extremes of pairs whose outlines are the same all along the face, where curves other than involutes may bind.
//!
//! The bounds of [`super::exact`] hold for involutes, their ends, and fillets that a tip reaches. Profiles that deviate, and contacts deep in
//! fillets and roots, have none there. The cells of [`super::outline`] bound the exact curves of any outline.

use super::effort::Effort;
use super::exact::{self, End, ExactKernel, Extreme, Extremes, is_proven};
use super::lost_motion::Status;
use super::outline::{OutlineCycle, OutlineKernel};
use crate::error::Error;
use crate::outline::OutlinePair;
use crate::pair::{GearPair, Mating};

/// Parts of the effort of an outline search that a search for both ends may use, and one for a single end (tuned: half a second, and 0.1 s).
/// Single ends are sought at some ten other centre distances.
const PARTS_OF_EFFORT: [u64; 2] = [20, 150];

/// Least budget of a search, nodes, that goes on to outlines (tuned: all phases of gears of 80 teeth, live answers of pairs with one phase).
const LEAST_BUDGET: u64 = 70_000;

/// As [`exact::cycle_extremes_within`], by the outlines where the bounds of involutes do not hold.
///
/// # Errors
/// As [`exact::cycle_extremes`].
pub(crate) fn cycle_extremes_within(
    kernel: &ExactKernel,
    assembly: &GearPair,
    over: (Mating, u64),
    width: f64,
    effort: &Effort,
    of: &[End],
) -> Result<Extremes, Error> {
    let by_involutes = || exact::cycle_extremes_within(kernel, assembly, over, width, effort, of);
    if assembly.varies_along_face() || effort.left() < LEAST_BUDGET {
        return by_involutes();
    }
    let by_outlines = || {
        of_outlines(assembly, over, width, effort, of)
            .filter(|found| found.each().all(|one| is_confirmed(kernel, assembly, &one)))
    };
    if assembly.is_modified() {
        return by_outlines().map_or_else(by_involutes, Ok);
    }
    let found = by_involutes()?;
    let has_values = matches!(found.status, Status::Clear | Status::Interference);
    let is_proven = |one: Extreme| is_proven(one.low, one.high, width);
    if !has_values || found.each().all(is_proven) {
        return Ok(found);
    }
    Ok(by_outlines().map_or(found, |other| narrower(found, other)))
}

/// Whether the exact method confirms the bracket at its pose. Where the lost motion jumps, rounding can move the pose across the jump.
fn is_confirmed(kernel: &ExactKernel, assembly: &GearPair, extreme: &Extreme) -> bool {
    let Ok(Some(found)) = kernel.lost_motion_at(assembly, extreme.mating) else {
        return false;
    };
    let Some((angle, error)) = found.angle().zip(found.error()) else {
        return false;
    };
    let radius = assembly.operating_pitch_radius(assembly.free());
    let [low, high] = [angle - error, angle + error].map(|angle| angle * radius);
    low <= extreme.high && extreme.low <= high
}

/// The narrower bracket of either result for each extreme.
fn narrower(found: Extremes, other: Extremes) -> Extremes {
    let width = |extreme: &Extreme| extreme.high - extreme.low;
    let of = |one: Option<Extreme>, other: Option<Extreme>| match (one, other) {
        (Some(one), Some(other)) if width(&other) < width(&one) => Some(other),
        (one, _) => one,
    };
    Extremes {
        least: of(found.least, other.least),
        greatest: of(found.greatest, other.greatest),
        ..found
    }
}

/// The extremes by the gears' outlines; `None` if they are no pair of outlines.
fn of_outlines(
    assembly: &GearPair,
    (first, matings): (Mating, u64),
    width: f64,
    effort: &Effort,
    of: &[End],
) -> Option<Extremes> {
    let pair = OutlinePair::of_data(assembly).ok()?;
    let cycle = OutlineCycle {
        first,
        distinct: matings,
        matings,
        classes: [pair.locked(), pair.free()].map(|member| pair.gear(member).tooth_classes()),
        parts_of_effort: PARTS_OF_EFFORT[usize::from(of.len() == 1)],
        tick: effort.tick,
    };
    Some(cycle.extremes(&OutlineKernel::new(&pair), &pair, of, width))
}

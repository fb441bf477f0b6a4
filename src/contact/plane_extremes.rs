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

/// Parts of the effort of an outline search that a search for both ends may use, and one for a single end, at each of some ten other centre
/// distances (tuned: half a second, and 0.1 s).
const PARTS_OF_EFFORT: [u64; 2] = [20, 150];

/// Least budget of a search, nodes, that goes on to outlines (tuned: all phases of gears of 70 teeth, and no live answer of the page).
const LEAST_EFFORT: u64 = 80_000;

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
    // The exact method confirms the poses. Where the lost motion jumps, both may stand on either side of the jump.
    let is_confirmed = |extreme: Option<Extreme>| {
        extreme.is_none_or(|extreme| {
            let found = kernel.lost_motion_at(assembly, extreme.mating);
            let angle = found
                .ok()
                .flatten()
                .and_then(|found| found.angle().zip(found.error()));
            angle.is_some_and(|(angle, error)| {
                let radius = assembly.operating_pitch_radius(assembly.free());
                let [low, high] = [angle - error, angle + error].map(|angle| angle * radius);
                low <= extreme.high && extreme.low <= high
            })
        })
    };
    let outlines = || {
        of_outlines(assembly, over, width, effort, of)
            .filter(|found| is_confirmed(found.least) && is_confirmed(found.greatest))
    };
    let is_plane = !assembly.varies_along_face() && effort.left() >= LEAST_EFFORT;
    if is_plane
        && assembly.is_modified()
        && let Some(found) = outlines()
    {
        return Ok(found);
    }
    let found = exact::cycle_extremes_within(kernel, assembly, over, width, effort, of)?;
    let has_values = matches!(found.status, Status::Clear | Status::Interference);
    let is_wide = |extreme: Option<Extreme>| {
        extreme.is_some_and(|extreme| !is_proven(extreme.low, extreme.high, width))
    };
    if is_plane && has_values && (is_wide(found.least) || is_wide(found.greatest)) {
        return Ok(outlines().map_or(found, |by_outlines| narrower(found, by_outlines)));
    }
    Ok(found)
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

//! Bounds of gears whose profiles or leads deviate, from enclosing gears without such deviations.
//!
//! Every half tooth lies within that of an outer gear and contains that of an inner one. These have the greatest and the least deviation of
//! its flank everywhere, over its profile and over the common face. Additional metal never adds play, so at any pose the lost motion is
//! between those of the outer and of the inner gears.

use super::extreme::{CycleBound, Doubt, End, Extreme, Extremes, UNKNOWN};
use super::mesh_cycle::MeshCycle;
use crate::contact::ExactKernel;
use crate::error::Error;
use crate::pair::Member;

/// The extremes `found`, within the bounds of the enclosing gears where they are not proven.
pub(super) fn narrowed(
    cycle: &MeshCycle,
    found: Extremes,
    width: f64,
    of: &[End],
) -> Result<Extremes, Error> {
    if found.each().all(|one| one.is_proven()) {
        return Ok(found);
    }
    let [(low, _), (high, _)] = bounds(cycle, width, of)?;
    let per_radian = cycle.per_radian();
    // `max` and `min` skip an unknown bound, which is NaN.
    let least = found.least.map(|least| Extreme {
        low: least.low.max(low * per_radian).min(least.high),
        ..least
    });
    let greatest = found.greatest.map(|greatest| Extreme {
        high: greatest.high.min(high * per_radian).max(greatest.low),
        ..greatest
    });
    Ok(Extremes {
        least,
        greatest,
        ..found
    })
}

/// Lower bound of the least and upper bound of the greatest.
pub(super) fn bounds(cycle: &MeshCycle, width: f64, of: &[End]) -> Result<[CycleBound; 2], Error> {
    let assembly = cycle.assembly;
    let enclosing = |member: Member| assembly.gear(member).enclosing(assembly.face()).ok();
    let Some((wheels, pinions)) = enclosing(Member::Wheel).zip(enclosing(Member::Pinion)) else {
        return Ok([UNKNOWN; 2]);
    };
    let extremes = |which: usize| {
        let (wheel, pinion) = (wheels.0[which].clone(), pinions.0[which].clone());
        let pair = assembly.with_gears(wheel, pinion, assembly.center_distance())?;
        let over = (cycle.first, cycle.matings);
        super::cycle_extremes_within(
            &ExactKernel::new(&pair),
            &pair,
            over,
            width,
            cycle.effort,
            &End::BOTH,
        )
    };
    let per_radian = cycle.per_radian();
    let least = if of.contains(&End::Least) {
        proof(extremes(0)?.least, |least| least.low / per_radian)
    } else {
        UNKNOWN
    };
    let greatest = if of.contains(&End::Greatest) {
        proof(extremes(1)?.greatest, |most| most.high / per_radian)
    } else {
        UNKNOWN
    };
    Ok([least, greatest])
}

/// The bound of an enclosing or enclosed pair.
fn proof(extreme: Option<Extreme>, end: impl Fn(&Extreme) -> f64) -> CycleBound {
    match extreme {
        Some(extreme) => (end(&extreme), Some(extreme.doubt.unwrap_or(Doubt::Profile))),
        None => UNKNOWN,
    }
}

//! The centre distance up to which a pair is in mesh: farther apart, tips pass each other somewhere in the mesh cycle.

use super::directions::Search;
use crate::analytic::InvolutePair;
use crate::contact::{Doubt, Effort, ExactKernel, Extremes, Status};
use crate::error::Error;
use crate::pair::{GearPair, Mating};

/// Width of the bracket, mm: a tip leaves its mate at some speed, so more would say nothing.
const WIDTH: f64 = 1e-5;

/// Steps of the search: halving a reach of 10 m alone.
const STEPS: usize = 40;

/// Searches with an effort of their own that an unproven distance has to pass (tuned: one or two find what halved efforts missed).
const CONFIRMED: usize = 8;

/// Steps of one length along the cycle (tuned: runouts move the place by a few pitches).
const MOVES: usize = 64;

/// The centre distance up to which a pair is in mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshesTo {
    /// Here every pose has its contacts, mm.
    pub low: f64,
    /// Here one has not, mm.
    pub high: f64,
    /// Why that is not proven.
    pub doubt: Option<Doubt>,
}

impl MeshesTo {
    /// The distance of `assembly`, which is out of mesh at a pose of `found`. `search` looks for the greatest over the whole cycle of another distance with what
    /// is left of `effort`; `confirm` does so with an effort of its own, as a run at that distance would. `None` where the pair is not in mesh at its
    /// distance without backlash either.
    ///
    /// # Errors
    /// As `search`.
    pub(super) fn new(
        assembly: &GearPair,
        found: &Extremes,
        [search, confirm]: [&Search<'_>; 2],
        effort: &Effort,
    ) -> Result<Option<MeshesTo>, Error> {
        let (Some(nearest), Some(lost)) =
            (InvolutePair::of(assembly).center_distance(0.0), found.lost)
        else {
            return Ok(None);
        };
        let (mut low, mut doubt) = (nearest, None);
        let mut high = leaves_first(assembly, lost, [nearest, assembly.center_distance()])?;
        let mut at = low;
        for _ in 0..STEPS {
            if !(low < high) {
                return Ok(None);
            }
            if effort.is_nearly_spent() {
                doubt = doubt.or(Some(Doubt::Effort));
                break;
            }
            let there = search(&assembly.at(at)?)?;
            match (there.greatest, there.lost) {
                (Some(greatest), _) => {
                    low = at;
                    doubt = greatest.doubt;
                }
                (None, Some(lost)) => high = leaves_first(assembly, lost, [nearest, at])?,
                (None, None) => high = at,
            }
            if high <= low {
                // What was not proven there is refuted here.
                low = nearest;
            }
            if high - low <= WIDTH {
                break;
            }
            at = 0.5 * (low + high);
        }
        for _ in 0..CONFIRMED {
            if doubt.is_none() || !(low > nearest) {
                break;
            }
            let there = confirm(&assembly.at(low)?)?;
            let (None, Some(lost)) = (there.greatest, there.lost) else {
                break;
            };
            high = leaves_first(assembly, lost, [nearest, low])?;
            low = (high - WIDTH).max(nearest);
        }
        Ok((high > nearest).then_some(MeshesTo { low, high, doubt }))
    }
}

/// The least distance found, between `nearest` and `farthest`, at which the pair is out of mesh at a pose near `lost`, where it is out of mesh at `farthest`.
///
/// The place is followed in steps of a pitch down to 1/4096 of one, towards the poses that leave at a lesser distance.
fn leaves_first(
    assembly: &GearPair,
    lost: Mating,
    [nearest, farthest]: [f64; 2],
) -> Result<f64, Error> {
    let leaves = |mating: Mating, farthest: f64| -> Result<f64, Error> {
        let (mut low, mut high) = (nearest, farthest);
        while high - low > WIDTH {
            let middle = 0.5 * (low + high);
            match passes(&assembly.at(middle)?, mating)? {
                true => high = middle,
                false => low = middle,
            }
        }
        Ok(high)
    };
    let (mut at, mut least) = (lost, leaves(lost, farthest)?);
    for step in (0..=6).map(|power| 0.25_f64.powi(power)) {
        for _ in 0..MOVES {
            let nearer = least - WIDTH;
            if nearer <= nearest {
                return Ok(least);
            }
            let pair = assembly.at(nearer)?;
            let sides = [step, -step].map(|by| at.onward(assembly, by));
            let mut moved = false;
            for mating in sides {
                if !moved && passes(&pair, mating)? {
                    (at, least, moved) = (mating, leaves(mating, nearer)?, true);
                }
            }
            if !moved {
                break;
            }
        }
    }
    Ok(least)
}

/// Whether the pair is out of mesh at `mating`.
fn passes(pair: &GearPair, mating: Mating) -> Result<bool, Error> {
    let found = ExactKernel::new(pair).lost_motion_at(pair, mating)?;
    Ok(found.is_some_and(|found| found.status() == Status::NoContact))
}

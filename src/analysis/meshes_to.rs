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

/// The centre distance up to which a pair is in mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshesTo {
    /// Here every pose has its contacts, mm.
    pub low: f64,
    /// Here one has not, mm.
    pub high: f64,
    /// That pose.
    pub mating: Mating,
    /// Why that is not proven.
    pub doubt: Option<Doubt>,
}

impl MeshesTo {
    /// That of `assembly`, out of mesh at a pose of which `found` tells; `search` looks for the greatest over the whole cycle of another distance, with what `effort`
    /// allows. `None` where
    /// the pair is not in mesh at its distance without backlash either.
    ///
    /// # Errors
    /// As `search`.
    pub(super) fn new(
        assembly: &GearPair,
        found: &Extremes,
        search: &Search<'_>,
        effort: &Effort,
    ) -> Result<Option<MeshesTo>, Error> {
        let (Some(nearest), Some(mut lost)) =
            (InvolutePair::of(assembly).center_distance(0.0), found.lost)
        else {
            return Ok(None);
        };
        let (mut low, mut high, mut doubt) = (nearest, assembly.center_distance(), None);
        let mut apart = vec![lost];
        let mut at = low;
        let kernel = ExactKernel::new(assembly);
        for _ in 0..STEPS {
            if !(low < high) {
                return Ok(None);
            }
            if effort.is_nearly_spent() {
                doubt = doubt.or(Some(Doubt::Effort));
                break;
            }
            let pair = assembly.at(at)?;
            let kernel = kernel.at(&pair);
            if let Some(mating) = first_out_of_mesh(&pair, &kernel, &apart)? {
                (high, lost) = (at, mating);
            } else {
                let there = search(&pair, &kernel)?;
                match there.greatest {
                    None => {
                        high = at;
                        lost = there.lost.unwrap_or(lost);
                        apart.extend(there.lost);
                    }
                    Some(greatest) => {
                        low = at;
                        doubt = greatest.doubt;
                    }
                }
            }
            if high - low <= WIDTH {
                break;
            }
            at = 0.5 * (low + high);
        }
        Ok((high > nearest).then_some(MeshesTo {
            low,
            high,
            mating: lost,
            doubt,
        }))
    }
}

/// The first of `matings` at which the pair is out of mesh.
fn first_out_of_mesh(
    pair: &GearPair,
    kernel: &ExactKernel,
    matings: &[Mating],
) -> Result<Option<Mating>, Error> {
    for mating in matings {
        let found = kernel.lost_motion_at(pair, *mating)?;
        if found.is_some_and(|found| found.status() == Status::NoContact) {
            return Ok(Some(*mating));
        }
    }
    Ok(None)
}

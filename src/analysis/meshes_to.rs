//! The centre distance up to which a pair is in mesh: above it tips pass each other somewhere in the mesh cycle.

use super::directions::Search;
use crate::analytic::InvolutePair;
use crate::contact::{Doubt, Effort, ExactKernel, Extremes, Status};
use crate::error::Error;
use crate::pair::{GearPair, Mating};

/// Width of the bracket, mm. A tip leaves its mate at some speed, so a narrower one has no meaning.
const WIDTH: f64 = 1e-5;

/// Limit of steps: bisection of a range of 10 m alone.
const STEPS: usize = 40;

/// The centre distance up to which a pair is in mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshesTo {
    /// A distance at which every pose has its contacts, mm.
    pub low: f64,
    /// A distance at which one has not, mm.
    pub high: f64,
    /// That pose.
    pub mating: Mating,
    /// The reason why it is unproven.
    pub doubt: Option<Doubt>,
}

impl MeshesTo {
    /// The result for `assembly`, which is out of mesh at a pose according to `found`. `search` finds the greatest over the whole cycle at
    /// another distance, within the budget `effort`. `None` if the pair is not in mesh at its distance without backlash either.
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

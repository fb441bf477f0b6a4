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
    /// Here every pose has its contacts, mm: proven, but where it is the distance without backlash.
    pub low: f64,
    /// Here one has not, mm.
    pub high: f64,
    /// Why the bracket is wider than wanted.
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
        let (Some(nearest), Some(lost)) =
            (InvolutePair::of(assembly).center_distance(0.0), found.lost)
        else {
            return Ok(None);
        };
        let kernel = ExactKernel::new(assembly);
        let (mut in_mesh, mut high) = (nearest, assembly.center_distance());
        let (mut low, mut doubt) = (nearest, Some(Doubt::Effort));
        let mut apart = vec![lost];
        let mut at = nearest;
        for _ in 0..STEPS {
            if !(in_mesh < high) {
                return Ok(None);
            }
            if effort.is_nearly_spent() {
                break;
            }
            let pair = assembly.at(at)?;
            let kernel = kernel.at(&pair);
            if passes(&pair, &kernel, &apart)? {
                high = at;
            } else {
                let there = search(&pair, &kernel)?;
                match there.greatest {
                    None => {
                        high = at;
                        apart.extend(there.lost);
                    }
                    Some(greatest) => {
                        in_mesh = at;
                        doubt = greatest.doubt.filter(|_| !greatest.high.is_finite());
                        // A greatest backlash that is bounded is one of poses that all have contacts.
                        if doubt.is_none() {
                            low = at;
                        }
                    }
                }
            }
            if high - in_mesh <= WIDTH {
                break;
            }
            at = 0.5 * (in_mesh + high);
        }
        let is_wide = high - low > WIDTH;
        let doubt = is_wide.then(|| doubt.unwrap_or(Doubt::Effort));
        Ok((high > nearest).then_some(MeshesTo { low, high, doubt }))
    }
}

/// Whether the pair is out of mesh at one of `matings`.
fn passes(pair: &GearPair, kernel: &ExactKernel, matings: &[Mating]) -> Result<bool, Error> {
    for mating in matings {
        let found = kernel.lost_motion_at(pair, *mating)?;
        if found.is_some_and(|found| found.status() == Status::NoContact) {
            return Ok(true);
        }
    }
    Ok(false)
}

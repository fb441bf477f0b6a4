//! Where the searches for a centre distance start, over all poses of a material.

use crate::analysis::compare::ComparedRun;
use crate::analysis::diagnosis::onset::{Onset, non_involute_onset};
use crate::analysis::diagnosis::seen::Seen;
use crate::analysis::diagnosis::zero_distance::{ZeroDistance, zero_distance};
use crate::analysis::directions::is_open;
use crate::analysis::study::Material;
use crate::error::Error;
use crate::pair::{GearPair, Mating};

/// What a search over poses came to: found or not there; or why that is not proven.
pub type Searched<T> = Result<Option<T>, String>;

/// Where searches over the poses of a material start.
pub(super) struct Start {
    assembly: GearPair,
    matings: Vec<Mating>,
    /// A search from poses that are not proven would be no better than they are.
    doubt: Option<String>,
}

impl Start {
    /// From `matings` of `assembly`, and `extremes` of its material; `seen` is what all poses have shown.
    pub fn new(
        assembly: &GearPair,
        material: Material,
        matings: impl Iterator<Item = Mating>,
        seen: &[Seen],
        extremes: &[ComparedRun],
    ) -> Start {
        let beside = || extremes.iter().filter(|run| run.run.material == material);
        // Of a runout without a direction the one that is worst.
        let worst = beside().find_map(|run| run.run.assembly.data());
        let worst = worst.filter(|_| is_open(assembly)).unwrap_or(assembly);
        Start {
            assembly: worst.clone(),
            matings: distinct(matings.chain(beside().flat_map(matings_of))),
            doubt: Seen::doubt(seen.iter().filter(|seen| seen.material == material)),
        }
    }

    pub fn zero(&self) -> Result<Searched<ZeroDistance>, Error> {
        search(&self.doubt, || zero_distance(&self.assembly, &self.matings))
    }

    pub fn onset(&self) -> Result<Searched<Onset>, Error> {
        search(&self.doubt, || {
            non_involute_onset(&self.assembly, &self.matings)
        })
    }
}

/// What `look` finds, unless there is `doubt` about the poses it starts from or it loses a contact.
fn search<T>(
    doubt: &Option<String>,
    look: impl FnOnce() -> Result<Option<T>, Error>,
) -> Result<Searched<T>, Error> {
    if let Some(reason) = doubt {
        return Ok(Err(reason.clone()));
    }
    match look() {
        Ok(found) => Ok(Ok(found)),
        Err(error) => match error.pose_failure() {
            Some(reason) => Ok(Err(format!(
                "the search met a pose without proof: {reason}"
            ))),
            None => Err(error),
        },
    }
}

pub(super) fn matings_of(run: &ComparedRun) -> impl Iterator<Item = Mating> + '_ {
    run.poses.iter().map(|pose| *pose.simulated.pose.mating())
}

/// `matings`, each once.
pub(super) fn distinct(matings: impl Iterator<Item = Mating>) -> Vec<Mating> {
    let mut met = std::collections::HashSet::new();
    matings
        .filter(|m| met.insert((m.wheel_tooth, m.pinion_tooth, m.flank, m.fraction.to_bits())))
        .collect()
}

//! The starts of the searches for a centre distance, over all poses of a material.

use crate::analysis::compare::ComparedRun;
use crate::analysis::diagnosis::onset::{Onset, non_involute_onset};
use crate::analysis::diagnosis::pose_evidence::PoseEvidence;
use crate::analysis::diagnosis::zero_distance::{ZeroDistance, zero_distance};
use crate::analysis::directions::is_open;
use crate::analysis::study::Material;
use crate::error::Error;
use crate::pair::{GearPair, Mating};

/// The result of a search over poses, if any; or the reason why it is unproven.
pub type Searched<T> = Result<Option<T>, String>;

/// The start of searches over the poses of a material.
pub(super) struct Start {
    assembly: GearPair,
    matings: Vec<Mating>,
    /// The reason for doubt: a search from unproven poses is unproven too.
    doubt: Option<String>,
}

impl Start {
    /// The start from `matings` of `assembly` and `extremes` of its material; `seen` is the evidence of all poses.
    pub fn new(
        assembly: &GearPair,
        material: Material,
        matings: impl Iterator<Item = Mating>,
        evidence: &[PoseEvidence],
        extremes: &[ComparedRun],
    ) -> Start {
        let beside = || extremes.iter().filter(|run| run.run.material == material);
        // For a runout without direction, the worst direction.
        let worst = beside().find_map(|run| run.run.assembly.data());
        let worst = worst.filter(|_| is_open(assembly)).unwrap_or(assembly);
        Start {
            assembly: worst.clone(),
            matings: distinct(matings.chain(beside().flat_map(matings_of))),
            doubt: PoseEvidence::doubt(evidence.iter().filter(|run| run.material == material)),
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

/// The result of `look`, unless there is `doubt` about its starting poses or it loses a contact.
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

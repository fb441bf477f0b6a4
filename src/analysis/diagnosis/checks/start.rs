//! The poses from which a centre distance is searched.

use crate::analysis::compare::ComparedRun;
use crate::analysis::diagnosis::pose_evidence::PoseEvidence;
use crate::analysis::directions::has_open_runout;
use crate::analysis::study::{Material, Run, RunPlan, Study};
use crate::error::{Error, Tick};
use crate::pair::{GearPair, Mating};
use std::collections::HashSet;
use std::sync::OnceLock;

/// The result of a search over poses, if any; or the reason why it is unproven.
pub type Searched<T> = Result<Option<T>, String>;

/// The poses from which a study is searched. The results are those of all centre distances of a material.
pub(super) struct Starts<'a> {
    pub study: &'a Study,
    /// The evidence of all poses.
    pub evidence: &'a [PoseEvidence],
    /// The poses with the least and the greatest backlash of the mesh cycle.
    pub extremes: &'a [ComparedRun],
    /// The runs of the study, listed when first needed.
    pub plans: OnceLock<Vec<RunPlan>>,
}

impl Starts<'_> {
    /// The reason for doubt about the poses of `material`: a search from unproven poses is unproven too.
    pub fn doubt(&self, material: Material) -> Option<String> {
        PoseEvidence::doubt(self.evidence.iter().filter(|run| run.material == material))
    }

    /// The matings of the runs that are `wanted`, each once.
    pub fn matings(&self, wanted: impl Fn(&Run) -> bool) -> Result<Vec<Mating>, Error> {
        let plans = match self.plans.get() {
            Some(plans) => plans,
            None => {
                let plans = self.study.runs()?;
                self.plans.get_or_init(|| plans)
            }
        };
        let plans = plans.iter().filter(|plan| wanted(&plan.run));
        Ok(distinct(
            plans.flat_map(|plan| plan.matings.iter().copied()),
        ))
    }

    /// The result of `look` from the poses and the extremes of `material`, unless there is doubt about them or it loses a contact.
    pub fn search<T>(
        &self,
        assembly: &GearPair,
        material: Material,
        look: impl Fn(&GearPair, &[Mating], &Tick) -> Result<Option<T>, Error>,
        tick: &Tick,
    ) -> Result<Searched<T>, Error> {
        if let Some(reason) = self.doubt(material) {
            return Ok(Err(reason));
        }
        let beside = || {
            self.extremes
                .iter()
                .filter(|run| run.run.material == material)
        };
        // For a runout without direction, the worst direction.
        let worst = beside().find_map(|run| run.run.assembly.data());
        let is_open = has_open_runout(assembly);
        let worst = worst.filter(|_| is_open).unwrap_or(assembly);
        let own = self.matings(|run| run.material == material)?;
        let poses = beside().flat_map(|run| &run.poses);
        let extremes = poses.map(|pose| *pose.simulated.pose.mating());
        let matings = distinct(own.into_iter().chain(extremes));
        match look(worst, &matings, tick) {
            Ok(found) => Ok(Ok(found)),
            Err(error) => match error.pose_failure() {
                Some(reason) => Ok(Err(format!(
                    "the search met a pose without proof: {reason}"
                ))),
                None => Err(error),
            },
        }
    }
}

/// `matings`, each once.
pub(super) fn distinct(matings: impl Iterator<Item = Mating>) -> Vec<Mating> {
    let mut met = HashSet::new();
    matings
        .filter(|m| met.insert((m.wheel_tooth, m.pinion_tooth, m.flank, m.fraction.to_bits())))
        .collect()
}

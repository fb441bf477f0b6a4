//! Every check of a pair, for each centre distance and material.

mod context;

use super::check::{Check, CheckName, CheckVerdict};
use super::clearance::pitches;
use super::contact_count::ContactCount;
use super::onset::{Onset, non_involute_onset};
use super::pose_evidence::PoseEvidence;
use super::zero_distance::{ZeroDistance, zero_distance};
use crate::analysis::compare::ComparedRun;
use crate::analysis::directions::has_open_runout;
use crate::analysis::extremes::{CycleExtremes, WIDTH};
use crate::analysis::study::{Material, Run, RunPlan, Study};
use crate::contact::{ExactKernel, Status, keeps_to_involutes};
use crate::error::{Error, Tick};
use crate::pair::{GearPair, Mating, Member};
use context::{CheckContext, LimitState};
use std::collections::HashSet;
use std::sync::OnceLock;

pub use context::Searched;

/// The diagnosis of a study's pair.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Diagnosis {
    /// Each centre distance and material, in the order of the study.
    pub groups: Vec<CheckedPair>,
    /// Contacts over all runs.
    pub contact: ContactCount,
}

/// The pair at one centre distance and of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckedPair {
    /// The pair as assembled.
    pub assembly: GearPair,
    /// The thickness.
    pub material: Material,
    /// Every check.
    pub checks: Vec<Check>,
    /// Contacts over its poses.
    pub contact: ContactCount,
    /// `a_0` on the outlines for this material, the same at each centre distance.
    pub zero: Searched<ZeroDistance>,
    /// Onset of non-involute contact for this material, the same at each centre distance.
    pub onset: Searched<Onset>,
}

impl Diagnosis {
    /// The most severe verdict.
    pub fn verdict(&self) -> CheckVerdict {
        let checks = self.groups.iter().flat_map(|group| &group.checks);
        let worst = checks.map(|check| check.verdict).max();
        worst.unwrap_or(CheckVerdict::Pass)
    }

    /// The checks that fail, each once.
    pub fn failed(&self) -> Vec<CheckName> {
        let mut failed = Vec::new();
        for check in self.groups.iter().flat_map(|group| &group.checks) {
            let name = check.name();
            if check.verdict == CheckVerdict::Fail && !failed.contains(&name) {
                failed.push(name);
            }
        }
        failed
    }
}

/// Number of ticks of [`diagnose`] for the runs of `plans`: the pitches over which the clearance of both gears' tips is searched.
pub fn pitch_count(plans: &[RunPlan]) -> usize {
    let of_group = |plans: &[RunPlan]| {
        let first = plans.first();
        let planned = plans.iter().flat_map(|plan| &plan.matings).copied();
        let pair = first.and_then(|first| first.run.assembly.data());
        pair.map_or(0, |pair| pitches(pair, &distinct(planned)).len())
    };
    let groups = plans.chunk_by(|one, other| one.run.group_key() == other.run.group_key());
    groups
        .map(|plans| Member::BOTH.len() * of_group(plans))
        .sum()
}

/// Checks the pair of `study`, whose `runs` were simulated and compared. Centre distances are also searched from the
/// poses of `extremes`, those with the least and the greatest backlash of the mesh cycle.
///
/// `step` is called before each search over the poses of a material, with its subject. `tick` is called as each pitch
/// of the clearance begins, from any thread; a break ends the work.
///
/// A search with unproven poses, or one that loses a contact, leaves its checks unproven.
///
/// # Errors
/// Errors of `step`; [`Error::Interrupted`] after a break.
pub fn diagnose(
    study: &Study,
    runs: &[ComparedRun],
    extremes: &CycleExtremes,
    step: &mut Step,
    tick: &Tick,
) -> Result<Diagnosis, Error> {
    let evidence: Vec<PoseEvidence> = runs.iter().filter_map(PoseEvidence::of).collect();
    Ok(Diagnosis {
        groups: groups(study, &evidence, extremes, Some(step), tick)?,
        contact: PoseEvidence::sum(&evidence).map_or_else(Default::default, |all| all.contact),
    })
}

/// The checks that fail, as [`Diagnosis::failed`]. A search is made only if it is needed to decide whether a limit is met.
///
/// `evidence` is that of the poses of each run of `study`, in the order of [`Study::runs`]; `cycle` are its extremes.
///
/// # Errors
/// As [`diagnose`].
pub fn failed_checks(
    study: &Study,
    evidence: &[PoseEvidence],
    cycle: &CycleExtremes,
    tick: &Tick,
) -> Result<Vec<CheckName>, Error> {
    let needed = Diagnosis {
        groups: groups(study, evidence, cycle, None, tick)?,
        contact: ContactCount::default(),
    };
    Ok(needed.failed())
}

/// Receives the subject of a search before it is made.
type Step<'a> = dyn FnMut(&str) -> Result<(), Error> + 'a;

/// The groups of `study` with every check. Without a `step` to call before each search, only with the checks and searches that tell whether
/// a limit is missed.
fn groups(
    study: &Study,
    evidence: &[PoseEvidence],
    cycle: &CycleExtremes,
    mut step: Option<&mut Step>,
    tick: &Tick,
) -> Result<Vec<CheckedPair>, Error> {
    let may_skip = step.is_none();
    let mut step = |doing: &str| step.as_mut().map_or(Ok(()), |step| step(doing));
    let starts = Starts {
        study,
        evidence,
        extremes: &cycle.runs,
        plans: OnceLock::new(),
    };
    let (mut zeros, mut onsets) = (Vec::new(), Vec::new());
    let mut groups = Vec::new();
    for runs in evidence.chunk_by(|one, other| one.group_key() == other.group_key()) {
        let Some(group) = PoseEvidence::sum(runs) else {
            continue;
        };
        let mut group = group.with_least_of(&cycle.runs);
        let (distance, material) = group.group_key();
        let matings = || starts.matings(|run| run.group_key() == (distance, material));
        if !may_skip
            && !study.sweeps()
            && group.assembly.deviates_along_face()
            && let Some(first) = matings()?.first()
        {
            group = group.with_places_from(first, tick)?;
        }
        let assembly = &group.assembly;
        let is_proven = starts.doubt(material).is_none();
        let zero = match assembles(&group, cycle).filter(|_| may_skip && is_proven) {
            Some(true) => LimitState::Kept,
            Some(false) => LimitState::Missed,
            None => LimitState::Found(cached(&mut zeros, material, || {
                step("zero-backlash centre distance")?;
                starts.search(assembly, material, zero_distance, tick)
            })?),
        };
        let onset = if may_skip && keeps_to_involutes(&ExactKernel::new(assembly), assembly) {
            LimitState::Kept
        } else {
            LimitState::Found(cached(&mut onsets, material, || {
                step("onset of non-involute contact")?;
                starts.search(assembly, material, non_involute_onset, tick)
            })?)
        };
        step("radial clearance")?;
        let pitches = || Ok(pitches(assembly, &matings()?));
        let context = CheckContext {
            assembly,
            evidence: &group,
            face_loss: cycle.face_loss(distance, material),
            allow_off_line: study.allow_off_line_contact,
            skip_clear_tips: may_skip,
            pitches: &pitches,
            zero,
            onset,
        };
        groups.push(CheckedPair {
            assembly: assembly.clone(),
            material,
            checks: context.checks(tick)?,
            contact: group.contact.clone(),
            zero: context.zero.found(),
            onset: context.onset.found(),
        });
    }
    Ok(groups)
}

/// Whether the pair of `group` assembles over the whole cycle; `None` if that is uncertain or within rounding.
fn assembles(group: &PoseEvidence, cycle: &CycleExtremes) -> Option<bool> {
    let here = group.group_key();
    let runs = cycle.each.iter().filter(|run| run.group_key() == here);
    // For all directions of a runout the search follows one of them.
    let beyond = if has_open_runout(&group.assembly) {
        10.0 * WIDTH
    } else {
        0.01 * WIDTH
    };
    let each = runs.map(|run| {
        let least = run.least.as_ref().filter(|least| least.holds())?;
        match run.status {
            Status::Clear if least.low >= beyond => Some(true),
            Status::Interference if least.high <= -beyond => Some(false),
            _ => None,
        }
    });
    let each = each.collect::<Option<Vec<bool>>>()?;
    (!each.is_empty()).then(|| !each.contains(&false))
}

/// The result for `material`, searched now if it is missing.
fn cached<T: Clone>(
    found: &mut Vec<(Material, Searched<T>)>,
    material: Material,
    search: impl FnOnce() -> Result<Searched<T>, Error>,
) -> Result<Searched<T>, Error> {
    if let Some((_, known)) = found.iter().find(|entry| entry.0 == material) {
        return Ok(known.clone());
    }
    let now = search()?;
    found.push((material, now.clone()));
    Ok(now)
}

/// The poses from which a study is searched. The results are those of all centre distances of a material.
struct Starts<'a> {
    study: &'a Study,
    /// The evidence of all poses.
    evidence: &'a [PoseEvidence],
    /// The poses with the least and the greatest backlash of the mesh cycle.
    extremes: &'a [ComparedRun],
    /// The runs of the study, listed when first needed.
    plans: OnceLock<Vec<RunPlan>>,
}

impl Starts<'_> {
    /// The reason for doubt about the poses of `material`: a search from unproven poses is unproven too.
    fn doubt(&self, material: Material) -> Option<String> {
        PoseEvidence::doubt(self.evidence.iter().filter(|run| run.material == material))
    }

    /// The matings of the runs that are `wanted`, each once.
    fn matings(&self, wanted: impl Fn(&Run) -> bool) -> Result<Vec<Mating>, Error> {
        let plans = match self.plans.get() {
            Some(plans) => plans,
            None => {
                let plans = self.study.runs()?;
                self.plans.get_or_init(|| plans)
            }
        };
        let plans = plans.iter().filter(|plan| wanted(&plan.run));
        let matings = plans.flat_map(|plan| &plan.matings);
        Ok(distinct(matings.copied()))
    }

    /// The result of `look` from the poses and the extremes of `material`, unless there is doubt about them or it loses a contact.
    fn search<T>(
        &self,
        assembly: &GearPair,
        material: Material,
        look: impl Fn(&GearPair, &[Mating], &Tick) -> Result<Option<T>, Error>,
        tick: &Tick,
    ) -> Result<Searched<T>, Error> {
        if let Some(reason) = self.doubt(material) {
            return Ok(Err(reason));
        }
        let is_of = |run: &&ComparedRun| run.run.material == material;
        let beside = || self.extremes.iter().filter(is_of);
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
                Some(why) => Ok(Err(format!("the search met a pose without proof: {why}"))),
                None => Err(error),
            },
        }
    }
}

/// `matings`, each once.
fn distinct(matings: impl Iterator<Item = Mating>) -> Vec<Mating> {
    let mut met = HashSet::new();
    matings
        .filter(|m| met.insert((m.wheel_tooth, m.pinion_tooth, m.flank, m.fraction.to_bits())))
        .collect()
}

//! Every check of a pair (design section 7), for each centre distance and material.

mod along_face;
mod clearance;
mod context;
mod interference;
mod limits;
mod off_line;
mod start;

use super::check::{Check, CheckName, Verdict};
use super::clearance::pitches;
use super::contact_count::ContactCount;
use super::onset::Onset;
use super::pose_evidence::PoseEvidence;
use super::zero_distance::ZeroDistance;
use crate::analysis::compare::ComparedRun;
use crate::analysis::extremes::CycleExtremes;
use crate::analysis::study::{Material, RunPlan, Study};
use crate::contact::ExactKernel;
use crate::error::{Error, Tick};
use crate::pair::{GearPair, Member};
use context::{CheckContext, LimitState, SearchedDistances};
use start::{Start, distinct, matings_of};

pub use start::Searched;

/// The diagnosis of a study's pair.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Diagnosis {
    /// Each centre distance and material, in the order of the study.
    pub groups: Vec<Group>,
    /// Contacts over all runs.
    pub contact: ContactCount,
}

/// The pair at one centre distance and of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
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
    pub fn verdict(&self) -> Verdict {
        let checks = self.groups.iter().flat_map(|group| &group.checks);
        let worst = checks.map(|check| check.verdict).max();
        worst.unwrap_or(Verdict::Pass)
    }

    /// The checks that fail, each once.
    pub fn failed(&self) -> Vec<CheckName> {
        let mut failed = Vec::new();
        for group in &self.groups {
            add_failed(&mut failed, &group.checks);
        }
        failed
    }
}

/// Number of ticks of [`diagnose`] for the runs of `plans`: the pitches over which the clearance of both gears' tips is searched.
pub fn pitch_count(plans: &[RunPlan]) -> usize {
    let of_group = |plans: &[RunPlan]| {
        let first = plans.first();
        let planned = plans.iter().flat_map(|plan| &plan.matings).copied();
        let pair = first.and_then(|first| first.assembly.data());
        pair.map_or(0, |pair| pitches(pair, &distinct(planned)).len())
    };
    let key = |plan: &RunPlan| (plan.assembly.center_distance(), plan.material);
    let groups = plans.chunk_by(|one, other| key(one) == key(other));
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
    step: &mut dyn FnMut(&str) -> Result<(), Error>,
    tick: &Tick,
) -> Result<Diagnosis, Error> {
    let evidence: Vec<PoseEvidence> = runs.iter().filter_map(PoseEvidence::of).collect();
    let mut groups: Vec<Group> = Vec::new();
    let mut searched: Vec<(Material, Searched<ZeroDistance>, Searched<Onset>)> = Vec::new();
    let place = |run: &ComparedRun| (run.run.assembly.center_distance(), run.run.material);
    let each = runs.chunk_by(|one, other| place(one) == place(other));
    for (group_runs, group) in each.zip(evidence.chunk_by(same_group)) {
        let Some(group) = PoseEvidence::sum(group) else {
            continue;
        };
        let group = group.with_least_of(&extremes.runs);
        let (assembly, material) = (&group.assembly, group.material);
        let known = searched.iter().find(|entry| entry.0 == material).cloned();
        let (_, zero, onset) = match known {
            Some(known) => known,
            None => {
                let of_material = runs.iter().filter(|run| run.run.material == material);
                let matings = of_material.flat_map(matings_of);
                let start = Start::new(assembly, material, matings, &evidence, &extremes.runs);
                step("zero-backlash centre distance")?;
                let zero = start.zero()?;
                step("onset of non-involute contact")?;
                let onset = start.onset()?;
                searched.push((material, zero.clone(), onset.clone()));
                (material, zero, onset)
            }
        };
        step("radial clearance")?;
        let context = CheckContext {
            assembly,
            evidence: &group,
            face_loss: extremes.face_loss(assembly.center_distance(), material),
            allow_off_line: study.allow_off_line_contact,
        };
        let pitches = pitches(assembly, &distinct(group_runs.iter().flat_map(matings_of)));
        let all = SearchedDistances {
            clear: false,
            pitches: &|| Ok(pitches.clone()),
            zero: LimitState::Found(zero.clone()),
            onset: LimitState::Found(onset.clone()),
        };
        groups.push(Group {
            assembly: assembly.clone(),
            material,
            checks: context.checks(&all, tick)?,
            contact: group.contact.clone(),
            zero,
            onset,
        });
    }
    Ok(Diagnosis {
        groups,
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
    let mut failed = Vec::new();
    let mut zeros: Vec<(Material, Searched<ZeroDistance>)> = Vec::new();
    let mut onsets: Vec<(Material, Searched<Onset>)> = Vec::new();
    for group in evidence.chunk_by(same_group) {
        let Some(group) = PoseEvidence::sum(group) else {
            continue;
        };
        let group = group.with_least_of(&cycle.runs);
        let (assembly, material) = (&group.assembly, group.material);
        let context = CheckContext {
            assembly,
            evidence: &group,
            face_loss: cycle.face_loss(assembly.center_distance(), material),
            allow_off_line: study.allow_off_line_contact,
        };
        let start = || -> Result<Start, Error> {
            let runs = study.runs()?;
            let of_material = runs.iter().filter(|run| run.material == material);
            let matings = of_material.flat_map(|run| run.matings.iter().copied());
            Ok(Start::new(
                assembly,
                material,
                matings,
                evidence,
                &cycle.runs,
            ))
        };
        let doubt = PoseEvidence::doubt(evidence.iter().filter(|run| run.material == material));
        let zero = match (&doubt, context.assembles(cycle)) {
            (None, Some(true)) => LimitState::Kept,
            (None, Some(false)) => LimitState::Missed,
            _ => LimitState::Found(cached(&mut zeros, material, || start()?.zero())?),
        };
        let onset = if ExactKernel::new(assembly).keeps_to_involutes(assembly) {
            LimitState::Kept
        } else {
            LimitState::Found(cached(&mut onsets, material, || start()?.onset())?)
        };
        let pitches = || {
            let runs = study.runs()?;
            let here = (assembly.center_distance(), material);
            let place = |run: &RunPlan| (run.assembly.center_distance(), run.material);
            let runs = runs.iter().filter(|run| place(run) == here);
            let matings = runs.flat_map(|run| run.matings.iter().copied());
            Ok(pitches(assembly, &distinct(matings)))
        };
        let needed = SearchedDistances {
            clear: true,
            pitches: &pitches,
            zero,
            onset,
        };
        add_failed(&mut failed, &context.checks(&needed, tick)?);
    }
    Ok(failed)
}

/// Adds to `failed` those of `checks` that fail, each once.
fn add_failed(failed: &mut Vec<CheckName>, checks: &[Check]) {
    for check in checks {
        let name = check.name();
        if check.verdict == Verdict::Fail && !failed.contains(&name) {
            failed.push(name);
        }
    }
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
    let found_now = search()?;
    found.push((material, found_now.clone()));
    Ok(found_now)
}

/// Whether two runs are of one centre distance and material.
fn same_group(one: &PoseEvidence, other: &PoseEvidence) -> bool {
    let place = |run: &PoseEvidence| (run.assembly.center_distance(), run.material);
    place(one) == place(other)
}

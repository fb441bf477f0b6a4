//! Every check of a pair (design section 7), for each centre distance and material.

mod clearance;
mod here;
mod interference;
mod limits;
mod off_line;
mod start;

use super::check::{Check, CheckName, Verdict};
use super::clearance::pitches;
use super::contact_count::ContactCount;
use super::onset::Onset;
use super::seen::Seen;
use super::zero_distance::ZeroDistance;
use crate::analysis::compare::ComparedRun;
use crate::analysis::extremes::CycleExtremes;
use crate::analysis::study::{Material, RunPlan, Study};
use crate::contact::ExactKernel;
use crate::error::Error;
use crate::pair::{GearPair, Member};
use here::{Here, Known, Sought};
use start::{Start, distinct, matings_of};
use std::ops::ControlFlow;

pub use start::Searched;

/// All that is to be said of a study's pair.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Diagnosis {
    /// Each centre distance and material, in the order of the study.
    pub groups: Vec<Group>,
    /// What touched over all runs.
    pub contact: ContactCount,
}

/// The pair at one centre distance and of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// As assembled.
    pub assembly: GearPair,
    /// Which thickness.
    pub material: Material,
    /// Every check.
    pub checks: Vec<Check>,
    /// What touched over its poses.
    pub contact: ContactCount,
    /// `a_0` on the outlines: of the material, the same at each centre distance.
    pub zero: Searched<ZeroDistance>,
    /// Onset of non-involute contact: of the material, the same at each centre distance.
    pub onset: Searched<Onset>,
}

impl Diagnosis {
    /// The gravest verdict.
    pub fn verdict(&self) -> Verdict {
        let checks = self.groups.iter().flat_map(|group| &group.checks);
        checks
            .map(|check| check.verdict)
            .max()
            .unwrap_or(Verdict::Pass)
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

/// How often [`diagnose`] will tick for the runs of `plans`: the pitches over which the clearance of both gears' tips is looked for.
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

/// Checks the pair of `study`, whose `runs` were simulated and compared; `extremes` are poses from which centre distances are sought too,
/// those with the least and the greatest backlash of the mesh cycle.
///
/// `step` is called before each search over the poses of a material, with what is looked for; `tick` as each pitch of
/// the clearance is begun, from any thread: a break ends the work.
///
/// A search whose poses are not proven, or which loses a contact, leaves the checks that need it unproven.
///
/// # Errors
/// What `step` returns; [`Error::Interrupted`] after a break.
pub fn diagnose(
    study: &Study,
    runs: &[ComparedRun],
    extremes: &[ComparedRun],
    step: &mut dyn FnMut(&str) -> Result<(), Error>,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Diagnosis, Error> {
    let seen: Vec<Seen> = runs.iter().filter_map(Seen::of).collect();
    let mut groups: Vec<Group> = Vec::new();
    let mut searched: Vec<(Material, Searched<ZeroDistance>, Searched<Onset>)> = Vec::new();
    let each = runs.chunk_by(|one, other| same_place(place_of(one), place_of(other)));
    for (runs_here, seen_here) in each.zip(seen.chunk_by(same_group)) {
        let Some(seen_here) = Seen::sum(seen_here) else {
            continue;
        };
        let seen_here = seen_here.with_least_of(extremes);
        let (assembly, material) = (&seen_here.assembly, seen_here.material);
        let known = searched.iter().find(|entry| entry.0 == material).cloned();
        let (_, zero, onset) = match known {
            Some(known) => known,
            None => {
                let of_material = runs.iter().filter(|run| run.run.material == material);
                let matings = of_material.flat_map(matings_of);
                let start = Start::new(assembly, material, matings, &seen, extremes);
                step("zero-backlash centre distance")?;
                let zero = start.zero()?;
                step("onset of non-involute contact")?;
                let onset = start.onset()?;
                searched.push((material, zero.clone(), onset.clone()));
                (material, zero, onset)
            }
        };
        step("radial clearance")?;
        let here = Here {
            assembly,
            seen: &seen_here,
            allow_off_line: study.allow_off_line_contact,
        };
        let pitches = pitches(assembly, &distinct(runs_here.iter().flat_map(matings_of)));
        let all = Sought {
            clear: false,
            pitches: &|| Ok(pitches.clone()),
            zero: Known::Found(zero.clone()),
            onset: Known::Found(onset.clone()),
        };
        groups.push(Group {
            assembly: assembly.clone(),
            material,
            checks: here.checks(&all, tick)?,
            contact: seen_here.contact.clone(),
            zero,
            onset,
        });
    }
    Ok(Diagnosis {
        groups,
        contact: Seen::sum(&seen).map_or_else(Default::default, |all| all.contact),
    })
}

/// The checks that fail, as [`Diagnosis::failed`] has them. No search is made where it is clear without one whether a limit is kept.
///
/// `seen` is what the poses of each run of `study` have shown, in the order of [`Study::runs`]; `cycle` are its extremes.
///
/// # Errors
/// As [`diagnose`].
pub fn failed_checks(
    study: &Study,
    seen: &[Seen],
    cycle: &CycleExtremes,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<CheckName>, Error> {
    let mut failed = Vec::new();
    let mut zeros: Vec<(Material, Searched<ZeroDistance>)> = Vec::new();
    let mut onsets: Vec<(Material, Searched<Onset>)> = Vec::new();
    for seen_here in seen.chunk_by(same_group) {
        let Some(seen_here) = Seen::sum(seen_here) else {
            continue;
        };
        let seen_here = seen_here.with_least_of(&cycle.runs);
        let (assembly, material) = (&seen_here.assembly, seen_here.material);
        let here = Here {
            assembly,
            seen: &seen_here,
            allow_off_line: study.allow_off_line_contact,
        };
        let start = || -> Result<Start, Error> {
            let runs = study.runs()?;
            let of_material = runs.iter().filter(|run| run.material == material);
            let matings = of_material.flat_map(|run| run.matings.iter().copied());
            Ok(Start::new(assembly, material, matings, seen, &cycle.runs))
        };
        let doubt = Seen::doubt(seen.iter().filter(|seen| seen.material == material));
        let zero = match (&doubt, here.assembles(cycle)) {
            (None, Some(true)) => Known::Kept,
            (None, Some(false)) => Known::Missed,
            _ => Known::Found(once(&mut zeros, material, || start()?.zero())?),
        };
        let onset = if ExactKernel::new(assembly).keeps_to_involutes(assembly) {
            Known::Kept
        } else {
            Known::Found(once(&mut onsets, material, || start()?.onset())?)
        };
        let pitches = || {
            let runs = study.runs()?;
            let here = |run: &&RunPlan| {
                same_place(
                    (run.assembly.center_distance(), run.material),
                    (assembly.center_distance(), material),
                )
            };
            let runs = runs.iter().filter(here);
            let matings = runs.flat_map(|run| run.matings.iter().copied());
            Ok(pitches(assembly, &distinct(matings)))
        };
        let needed = Sought {
            clear: true,
            pitches: &pitches,
            zero,
            onset,
        };
        add_failed(&mut failed, &here.checks(&needed, tick)?);
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

/// What was found of `material`, sought now if it was not.
fn once<T: Clone>(
    found: &mut Vec<(Material, Searched<T>)>,
    material: Material,
    seek: impl FnOnce() -> Result<Searched<T>, Error>,
) -> Result<Searched<T>, Error> {
    if let Some((_, known)) = found.iter().find(|entry| entry.0 == material) {
        return Ok(known.clone());
    }
    let sought = seek()?;
    found.push((material, sought.clone()));
    Ok(sought)
}

/// Centre distance and material.
type Place = (f64, Material);

fn place_of(run: &ComparedRun) -> Place {
    (run.run.assembly.center_distance(), run.run.material)
}

fn same_place(one: Place, other: Place) -> bool {
    one == other
}

/// Whether two runs are of one centre distance and material.
fn same_group(one: &Seen, other: &Seen) -> bool {
    let place = |seen: &Seen| (seen.assembly.center_distance(), seen.material);
    same_place(place(one), place(other))
}

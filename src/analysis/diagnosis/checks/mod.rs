//! Every check of a pair (design section 7), for each centre distance and material.

mod clearance;
mod interference;
mod limits;
mod off_line;

use super::check::{Check, Verdict};
use super::clearance::pitches;
use super::contact_count::ContactCount;
use super::onset::{Onset, non_involute_onset};
use super::zero_distance::{ZeroDistance, zero_distance};
use crate::analysis::compare::ComparedRun;
use crate::analysis::directions::is_open;
use crate::analysis::study::{Material, RunPlan, Study};
use crate::contact::{Contact, Touch};
use crate::error::Error;
use crate::gear::{Gear, Side};
use crate::pair::{GearPair, Mating, Member};
use std::ops::ControlFlow;

const MEMBERS: [Member; 2] = [Member::Wheel, Member::Pinion];

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
    /// `a_0` measured: of the material, the same at each centre distance.
    pub zero: Searched<ZeroDistance>,
    /// Onset of non-involute contact: of the material, the same at each centre distance.
    pub onset: Searched<Onset>,
}

/// What a search over poses came to: found or not there; or why that is not proven.
pub type Searched<T> = Result<Option<T>, String>;

impl Diagnosis {
    /// The gravest verdict.
    pub fn verdict(&self) -> Verdict {
        let checks = self.groups.iter().flat_map(|group| &group.checks);
        checks
            .map(|check| check.verdict)
            .max()
            .unwrap_or(Verdict::Pass)
    }
}

/// How often [`diagnose`] will tick for the runs of `plans`: the pitches over which the clearance of both gears' tips is looked for.
pub fn pitch_count(plans: &[RunPlan]) -> usize {
    let of_group = |plans: &[RunPlan]| {
        let first = plans.first();
        let planned = plans.iter().flat_map(|plan| &plan.matings).copied();
        first.map_or(0, |first| {
            pitches(&first.assembly, &distinct(planned)).len()
        })
    };
    let key = |plan: &RunPlan| (plan.assembly.center_distance(), plan.material);
    let groups = plans.chunk_by(|one, other| key(one) == key(other));
    groups.map(|plans| MEMBERS.len() * of_group(plans)).sum()
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
    let mut groups: Vec<Group> = Vec::new();
    let mut searched: Vec<(Material, Searched<ZeroDistance>, Searched<Onset>)> = Vec::new();
    for runs_here in runs.chunk_by(same_group) {
        let Some(first) = runs_here.first() else {
            continue;
        };
        let (assembly, material) = (&first.run.assembly, first.run.material);
        let known = searched.iter().find(|entry| entry.0 == material).cloned();
        let (_, zero, onset) = match known {
            Some(known) => known,
            None => {
                let of_material = || runs.iter().filter(|run| run.run.material == material);
                let beside = || extremes.iter().filter(|run| run.run.material == material);
                let matings = matings(of_material().chain(beside()));
                // Of a runout without a direction the one that is worst.
                let worst = beside().next().map(|run| &run.run.assembly);
                let assembly = worst.filter(|_| is_open(assembly)).unwrap_or(assembly);
                // A search from poses that are not proven would be no better than they are.
                let doubt = doubt(of_material());
                step("zero-backlash centre distance")?;
                let zero = search(&doubt, || zero_distance(assembly, &matings))?;
                step("onset of non-involute contact")?;
                let onset = search(&doubt, || non_involute_onset(assembly, &matings))?;
                searched.push((material, zero.clone(), onset.clone()));
                (material, zero, onset)
            }
        };
        step("radial clearance")?;
        let contact = ContactCount::sum(runs_here);
        let here = Here {
            assembly,
            runs: runs_here,
            contact: &contact,
            allow_off_line: study.allow_off_line_contact,
        };
        groups.push(Group {
            assembly: assembly.clone(),
            material,
            checks: here.checks(&zero, &onset, tick)?,
            contact,
            zero,
            onset,
        });
    }
    Ok(Diagnosis {
        groups,
        contact: ContactCount::sum(runs),
    })
}

/// Whether two runs are of one centre distance and material.
fn same_group(one: &ComparedRun, other: &ComparedRun) -> bool {
    let key = |run: &ComparedRun| (run.run.assembly.center_distance(), run.run.material);
    key(one) == key(other)
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
        Err(error) => match error.of_one_pose() {
            Some(reason) => Ok(Err(format!(
                "the search met a pose without proof: {reason}"
            ))),
            None => Err(error),
        },
    }
}

/// How many poses of `runs` are not proven, and why the first is not; `None` where all are.
fn doubt<'a>(runs: impl Iterator<Item = &'a ComparedRun> + Clone) -> Option<String> {
    let poses = runs.clone().map(|run| run.poses.len()).sum::<usize>();
    let unproven = runs.flat_map(ComparedRun::unproven);
    let count = unproven.clone().count();
    let first = unproven.into_iter().next()?;
    let why = first.swept.unproven().next()?;
    Some(format!(
        "{count} of {poses} poses are unproven; the first is {}: {}",
        place(first.swept.pose.mating()),
        why.reason
    ))
}

/// The matings of `runs`, each once, in order.
fn matings<'a>(runs: impl Iterator<Item = &'a ComparedRun>) -> Vec<Mating> {
    let poses = runs.flat_map(|run| &run.poses);
    distinct(poses.map(|pose| *pose.swept.pose.mating()))
}

/// `matings`, each once.
fn distinct(matings: impl Iterator<Item = Mating>) -> Vec<Mating> {
    let mut met = std::collections::HashSet::new();
    matings
        .filter(|m| met.insert((m.wheel_tooth, m.pinion_tooth, m.flank, m.fraction.to_bits())))
        .collect()
}

/// One pair as assembled, with what was found for it.
struct Here<'a> {
    assembly: &'a GearPair,
    runs: &'a [ComparedRun],
    contact: &'a ContactCount,
    allow_off_line: bool,
}

impl Here<'_> {
    fn checks(
        &self,
        zero: &Searched<ZeroDistance>,
        onset: &Searched<Onset>,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Vec<Check>, Error> {
        let doubt = doubt(self.runs.iter());
        let of_poses = |check: Check| match &doubt {
            Some(reason) => check.not_proven(reason),
            None => check,
        };
        let mut checks = Vec::new();
        for member in MEMBERS {
            checks.push(self.clearance(member, tick)?);
        }
        checks.extend(MEMBERS.map(|member| of_poses(self.k_8(member))));
        checks.extend(MEMBERS.map(|member| of_poses(self.form(member))));
        checks.push(match onset {
            Ok(onset) => self.onset(onset.as_ref()),
            Err(reason) => self.onset(None).not_proven(reason),
        });
        checks.push(of_poses(self.off_line()));
        checks.push(match zero {
            Ok(zero) => self.zero(zero.as_ref()),
            Err(reason) => self.zero(None).not_proven(reason),
        });
        checks.push(of_poses(self.backlash()));
        checks.extend(MEMBERS.map(|member| self.undercut(member)));
        checks.push(self.contact_ratio());
        checks.extend(MEMBERS.map(|member| self.tip(member)));
        Ok(checks)
    }

    fn gear(&self, member: Member) -> &Gear {
        self.assembly.gear(member).gear()
    }

    fn module(&self) -> f64 {
        self.gear(Member::Wheel).basic_data().module()
    }

    fn pitches(&self) -> Vec<Mating> {
        pitches(self.assembly, &matings(self.runs.iter()))
    }

    /// Every contact of this pair that has a rotation to it.
    fn contacts(&self) -> impl Iterator<Item = (Side, &Contact)> {
        let poses = self.runs.iter().flat_map(|run| &run.poses);
        poses
            .filter_map(|pose| pose.swept.proven())
            .flat_map(|found| {
                let right = found.right.as_ref().map(|c| (Side::Right, c));
                right
                    .into_iter()
                    .chain(found.left.as_ref().map(|c| (Side::Left, c)))
            })
    }
}

fn touch(contact: &Contact, member: Member) -> Touch {
    match member {
        Member::Wheel => contact.wheel,
        Member::Pinion => contact.pinion,
    }
}

fn percent(part: usize, whole: usize) -> f64 {
    match whole {
        0 => 0.0,
        _ => 100.0 * part as f64 / whole as f64,
    }
}

/// A pose in words: mating, flank, fraction.
fn place(mating: &Mating) -> String {
    let beyond = match mating.fraction {
        0.0 => String::new(),
        fraction => format!(", {fraction:.4} pitch beyond"),
    };
    format!(
        "wheel {} with pinion {} at the {} flank{beyond}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name()
    )
}

/// A length in mm as µm with two decimals, never `-0.00`.
fn hundredths(length: f64) -> String {
    let text = format!("{:.2}", length * 1e3);
    match text.as_str() {
        "-0.00" => "0.00".to_owned(),
        _ => text,
    }
}

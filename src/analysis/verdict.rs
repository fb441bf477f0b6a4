//! The verdict: whether a pair assembles over its whole mesh cycle, and whether it meets its requirements.

use super::assembles_from::Threshold;
use super::compare::ComparedPose;
use super::diagnosis::{CheckName, CheckVerdict};
use super::extremes::{RunExtreme, RunExtremes, WIDTH};
use super::requirement::{Quantity, Requirements};
use super::study::Study;
use super::uncertainty::Uncertainty;
use crate::contact::{End, Status};
use crate::outline::AssembledPair;
use crate::pair::Member;

/// A limit that is missed, or not proven to be kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unmet {
    /// The limited quantity.
    pub quantity: Quantity,
    /// The limit, in the quantity's unit.
    pub limit: f64,
    /// Whether it is an upper limit.
    pub is_max: bool,
    /// The bracket of the pair's value; `None` without a value, jammed or out of mesh.
    pub found: Option<[f64; 2]>,
    /// Whether the whole bracket misses the limit. Otherwise a part of it does, or the bracket is not proven to hold.
    pub is_missed: bool,
    /// Whether the value includes the bearing clearance.
    pub with_clearance: bool,
}

/// Whether the pair keeps all its limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum RequirementOutcome {
    /// There is no limit.
    None,
    /// Each whole bracket keeps its limit.
    Met,
    /// The whole bracket of a value misses its limit.
    NotMet,
    /// No bracket misses its limit as a whole, but one is not proven to keep it.
    NotProven,
}

impl RequirementOutcome {
    /// The outcome of the limits `required`, of which `unmet` are not met.
    fn of(required: &Requirements, unmet: &[Unmet]) -> RequirementOutcome {
        if required.is_empty() {
            RequirementOutcome::None
        } else if unmet.is_empty() {
            RequirementOutcome::Met
        } else if unmet.iter().any(|unmet| unmet.is_missed) {
            RequirementOutcome::NotMet
        } else {
            RequirementOutcome::NotProven
        }
    }

    /// Whether there is no limit, or all limits are met.
    pub fn is_kept(self) -> bool {
        matches!(self, RequirementOutcome::None | RequirementOutcome::Met)
    }

    /// Its name in results.
    pub fn name(self) -> &'static str {
        match self {
            RequirementOutcome::None => "none",
            RequirementOutcome::Met => "met",
            RequirementOutcome::NotMet => "not_met",
            RequirementOutcome::NotProven => "not_proven",
        }
    }
}

/// The verdict on a pair.
#[derive(Debug, Clone)]
pub struct Verdict<'a> {
    /// The extremes of each centre distance, material and assembly phase.
    pub runs: &'a [RunExtremes],
    /// Whether the pair keeps all its limits.
    pub requirement: RequirementOutcome,
    /// The limits that it does not keep, each with its worst value; the worst limit first.
    pub unmet: Vec<Unmet>,
    /// The gear whose lost motion is limited, if any.
    pub lost_motion_of: Option<Member>,
    /// The checks that fail, each once.
    pub failed_checks: Vec<CheckName>,
    /// Standard uncertainties of the measurements, if stated.
    pub uncertainty: Option<Uncertainty>,
    /// Whether the limits also hold with the expanded uncertainty of `j_wt`. A radial clearance has none.
    pub is_kept_within_uncertainty: bool,
}

impl<'a> Verdict<'a> {
    /// The verdict from the extremes of `runs`, the limits `required`, the uncertainties of the measurements and the checks that fail.
    pub fn new(
        runs: &'a [RunExtremes],
        required: &Requirements,
        uncertainty: Option<Uncertainty>,
        failed_checks: Vec<CheckName>,
    ) -> Verdict<'a> {
        let missed = unmet(required, runs, None);
        let is_within = || uncertainty.is_none() || unmet(required, runs, uncertainty).is_empty();
        Verdict {
            runs,
            requirement: RequirementOutcome::of(required, &missed),
            is_kept_within_uncertainty: missed.is_empty() && is_within(),
            unmet: missed,
            lost_motion_of: required.iter().find_map(|(quantity, _)| match quantity {
                Quantity::LostMotion(member) => Some(*member),
                _ => None,
            }),
            failed_checks,
            uncertainty,
        }
    }

    /// The verdict on `study`, from the extremes of its `runs` and the checks that fail.
    pub fn of_study(
        study: &Study,
        runs: &'a [RunExtremes],
        failed_checks: Vec<CheckName>,
    ) -> Verdict<'a> {
        Verdict::new(runs, &study.requirements, study.uncertainty, failed_checks)
    }

    /// Expanded uncertainty of an extreme's `j_wt`, mm, if uncertainties are stated.
    pub fn expanded(&self, extreme: &RunExtreme) -> Option<f64> {
        self.uncertainty?
            .of(&extreme.assembly, &extreme.pose.simulated)
    }

    /// Whether the pair assembles at every run; `None` if unproven.
    pub fn assembles(&self) -> Option<bool> {
        let mut each = self.runs.iter().map(RunExtremes::assembles);
        if each.clone().any(|one| one == Some(false)) {
            return Some(false);
        }
        let all = !self.runs.is_empty() && each.all(|one| one == Some(true));
        all.then_some(true)
    }

    /// Whether the pair passes: it meets its limits, or, without limits, it is proven to assemble. Checks are judged separately.
    pub fn passes(&self) -> bool {
        match self.requirement {
            RequirementOutcome::None => self.assembles() == Some(true),
            requirement => requirement.is_kept(),
        }
    }

    /// Whether a value of the pair misses a limit, or is not proven to keep it. A pair that jams has no value.
    pub fn misses_limit(&self) -> bool {
        self.unmet.iter().any(|unmet| unmet.found.is_some())
    }

    /// The verdict for a heading, from assembly and limits. Checks are judged separately.
    pub fn state(&self) -> CheckVerdict {
        match (self.assembles(), self.requirement) {
            (Some(false), _) | (_, RequirementOutcome::NotMet) => CheckVerdict::Fail,
            (None, _) | (_, RequirementOutcome::NotProven) => CheckVerdict::Unproven,
            (Some(true), _) => CheckVerdict::Pass,
        }
    }

    /// Matings of the cycle; 0 without runs.
    pub fn matings(&self) -> u64 {
        let each = self.runs.iter().map(|run| run.matings);
        each.max().unwrap_or(0)
    }

    /// The run with the least backlash, the first of those that are equal for practical purposes.
    pub fn least(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        self.foremost(-1.0, |run| run.least.as_ref())
    }

    /// The run with the greatest backlash.
    pub fn greatest(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        self.foremost(1.0, |run| run.greatest.as_ref())
    }

    /// The run with the least backlash when the axes are pressed together within their bearings; `None` without bearing clearance.
    pub fn least_pressed(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        let pressed = |run: &'a RunExtremes| run.bearings.as_ref()?.pressed.extreme.as_ref();
        self.foremost(-1.0, pressed)
    }

    /// The run with the greatest backlash when the axes are pulled apart.
    pub fn greatest_apart(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        let apart = |run: &'a RunExtremes| run.bearings.as_ref()?.pulled_apart.extreme.as_ref();
        self.foremost(1.0, apart)
    }

    /// The run whose extreme is the greatest, or with `sign` −1 the least.
    fn foremost(
        &self,
        sign: f64,
        of: impl Fn(&'a RunExtremes) -> Option<&'a RunExtreme>,
    ) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        let each = self.runs.iter();
        let each = each.filter_map(|run| Some((run, of(run)?)));
        each.reduce(|one, other| {
            if sign * (other.1.found() - one.1.found()) > WIDTH {
                other
            } else {
                one
            }
        })
    }

    /// The worst pose of all, its run and its pair: a jammed one before the least backlash; `None` if none is in mesh.
    pub fn worst(&self) -> Option<(&'a RunExtremes, &'a AssembledPair, &'a ComparedPose)> {
        let mut jammed = self.runs.iter().filter(|run| run.status == Status::Jammed);
        let jammed = jammed.find_map(|run| {
            let lost = run.lost.as_ref()?;
            Some((run, &lost.assembly, &lost.pose))
        });
        let least = || {
            let (run, least) = self.least()?;
            Some((run, &least.assembly, &least.pose))
        };
        jammed.or_else(least)
    }

    /// The distance from which all runs assemble, among those that do not; `None` if one never does.
    pub fn assembles_from(&self) -> Option<Threshold> {
        let fails = |run: &&RunExtremes| run.assembles() == Some(false);
        let failing = self.runs.iter().filter(fails);
        let failing = failing.filter(|run| run.status != Status::NoContact);
        let from = failing.map(|run| run.assembles_from);
        Threshold::farthest(from.collect::<Option<Vec<_>>>()?.into_iter())
    }

    /// The distance up to which all runs are in mesh, among those out of mesh; `None` if one never is.
    pub fn meshes_to(&self) -> Option<Threshold> {
        let runs = self.runs.iter();
        let apart = runs.filter(|run| run.status == Status::NoContact);
        let to = apart.map(|run| run.meshes_to);
        Threshold::nearest(to.collect::<Option<Vec<_>>>()?.into_iter())
    }
}

/// The limits of `required` that some of `runs` do not meet, each with its worst value, widened by the expanded `uncertainty`;
/// certainly missed ones first.
fn unmet(
    required: &Requirements,
    runs: &[RunExtremes],
    uncertainty: Option<Uncertainty>,
) -> Vec<Unmet> {
    let limits = required.iter().flat_map(|(quantity, limits)| {
        let ends = [(limits.min, false), (limits.max, true)];
        ends.map(|(limit, is_max)| (*quantity, limit, is_max))
    });
    let worst = |(quantity, limit, is_max): (Quantity, Option<f64>, bool)| {
        let limit = limit?;
        let each = runs.iter();
        let each = each.filter_map(|run| unmet_by(run, quantity, (limit, is_max), uncertainty));
        let key = |(unmet, most): &(Unmet, f64)| (unmet.is_missed, *most);
        each.max_by(|one, other| {
            let ((missed, most), (other_missed, other_most)) = (key(one), key(other));
            missed.cmp(&other_missed).then(most.total_cmp(&other_most))
        })
    };
    let mut unmet: Vec<Unmet> = limits.filter_map(worst).map(|(unmet, _)| unmet).collect();
    unmet.sort_by_cached_key(|unmet| u64::from(!unmet.is_missed));
    unmet
}

/// The limit of a quantity that `run` does not keep, and the distance of the worse end of its bracket past the limit; `None` if it keeps it. With
/// bearing clearance the axes are pressed together, or pulled apart.
fn unmet_by(
    run: &RunExtremes,
    quantity: Quantity,
    (limit, is_max): (f64, bool),
    uncertainty: Option<Uncertainty>,
) -> Option<(Unmet, f64)> {
    let (assembly, extreme) = run.with_clearance(if is_max { End::Greatest } else { End::Least });
    // The radial clearance needs no contact.
    let extreme = extreme.filter(|_| quantity != Quantity::RadialClearance);
    let j_wt = match quantity {
        Quantity::RadialClearance => Some([0.0; 2]),
        _ => extreme.map(|found| {
            let off = uncertainty.and_then(|of| of.of(&found.assembly, &found.pose.simulated));
            let off = off.unwrap_or(0.0);
            [found.low - off, found.high + off]
        }),
    };
    let found = j_wt.and_then(|j_wt| quantity.bracket(assembly, j_wt, is_max));
    let [most, least] = match found {
        None => [f64::INFINITY; 2],
        Some([low, high]) if is_max => [high - limit, low - limit],
        Some([low, high]) => [limit - low, limit - high],
    };
    // Whether a pose attains a value inside the bracket, and whether the bracket covers every pose.
    let is_attained = extreme.is_none_or(|extreme| extreme.pose.simulated.found.is_ok());
    let holds = extreme.is_none_or(RunExtreme::holds);
    let unmet = Unmet {
        quantity,
        limit,
        is_max,
        found,
        is_missed: is_attained && least > 0.0,
        with_clearance: run.bearings.is_some(),
    };
    (!(holds && most <= 0.0)).then_some((unmet, most))
}

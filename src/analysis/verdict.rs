//! The verdict: whether a pair assembles over its whole mesh cycle, and whether it keeps what is required of it.

use super::assembles_from::AssemblesFrom;
use super::compare::ComparedPose;
use super::diagnosis;
use super::extremes::{RunExtreme, RunExtremes, WIDTH};
use super::meshes_to::MeshesTo;
use super::requirement::{Limits, Quantity, Requirements};
use super::study::Study;
use super::uncertainty::Uncertainty;
use crate::contact::Status;
use crate::pair::GearPair;

/// A limit that is not kept, or not surely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unmet {
    /// What is limited.
    pub quantity: Quantity,
    /// The limit, in the quantity's unit.
    pub limit: f64,
    /// Whether it is the greatest allowed.
    pub is_max: bool,
    /// What the pair has there: a bracket; `None` where it has no value, jammed or out of mesh.
    pub found: Option<[f64; 2]>,
    /// Whether the limit lies inside the bracket.
    pub straddles: bool,
    /// Whether the bracket holds every pose; else what was found may be kept, and others not.
    pub holds: bool,
    /// Whether what was found is of axes that their bearings let move.
    pub with_play: bool,
}

/// Whether what is required is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Requirement {
    /// Nothing is required.
    None,
    /// All is kept.
    Met,
    /// Something is not, or not surely.
    NotMet,
}

impl Requirement {
    /// What `unmet` says of what is `required`.
    pub(super) fn of(required: &Requirements, unmet: &[Unmet]) -> Requirement {
        match (required.is_empty(), unmet.is_empty()) {
            (true, _) => Requirement::None,
            (false, true) => Requirement::Met,
            (false, false) => Requirement::NotMet,
        }
    }

    /// The name results use.
    pub fn name(self) -> &'static str {
        match self {
            Requirement::None => "none",
            Requirement::Met => "met",
            Requirement::NotMet => "not_met",
        }
    }
}

/// What is to be said of a pair first.
#[derive(Debug, Clone)]
pub struct Verdict<'a> {
    /// The extremes it rests on.
    pub runs: &'a [RunExtremes],
    /// Whether what is required is kept.
    pub requirement: Requirement,
    /// What is not: of each limit the worst.
    pub unmet: Vec<Unmet>,
    /// Ids of the checks that fail, no id twice.
    pub failed_checks: Vec<&'static str>,
    /// What the measurements may be off, where that is stated.
    pub uncertainty: Option<Uncertainty>,
}

impl<'a> Verdict<'a> {
    /// Of `runs`, what is `required` of them and what their measurements may be off, and of the ids of the checks that fail.
    pub fn new(
        runs: &'a [RunExtremes],
        required: &Requirements,
        uncertainty: Option<Uncertainty>,
        failed_checks: Vec<&'static str>,
    ) -> Verdict<'a> {
        let unmet: Vec<Unmet> = required
            .iter()
            .flat_map(|(quantity, limits)| {
                let found = |run: &RunExtremes, is_max| FoundEnd {
                    bracket: found(*quantity, run, is_max),
                    holds: *quantity == Quantity::RadialClearance
                        || extreme(run, is_max).1.is_none_or(RunExtreme::holds),
                    with_play: run.bearings.is_some(),
                };
                unmet(*quantity, limits, runs, found)
            })
            .collect();
        Verdict {
            runs,
            requirement: Requirement::of(required, &unmet),
            unmet,
            failed_checks,
            uncertainty,
        }
    }

    /// Of the runs of `study`, and of the ids of its checks that fail.
    pub fn of_study(
        study: &Study,
        runs: &'a [RunExtremes],
        failed_checks: Vec<&'static str>,
    ) -> Verdict<'a> {
        Verdict::new(runs, &study.requirements, study.uncertainty, failed_checks)
    }

    /// Expanded uncertainty of an extreme's `j_wt`, mm, where uncertainties are stated.
    pub fn expanded(&self, extreme: &RunExtreme) -> Option<f64> {
        self.uncertainty?
            .of(&extreme.assembly, &extreme.pose.simulated)
    }

    /// Whether the pair assembles everywhere; `None` where that is not proven.
    pub fn assembles(&self) -> Option<bool> {
        let each = || self.runs.iter().map(RunExtremes::assembles);
        match each().any(|one| one == Some(false)) {
            true => Some(false),
            false => {
                let all = !self.runs.is_empty() && each().all(|one| one == Some(true));
                all.then_some(true)
            }
        }
    }

    /// Whether that and what is required speak for the pair: what a heading shows. Checks are told apart.
    pub fn state(&self) -> diagnosis::Verdict {
        match (self.assembles(), self.requirement) {
            (Some(false), _) | (_, Requirement::NotMet) => diagnosis::Verdict::Fail,
            (None, _) => diagnosis::Verdict::Unproven,
            (Some(true), _) => diagnosis::Verdict::Pass,
        }
    }

    /// Matings of the cycle; 0 where nothing was run.
    pub fn matings(&self) -> u64 {
        let each = self.runs.iter().map(|run| run.matings);
        each.max().unwrap_or(0)
    }

    /// The run with the least backlash of all that have one, the first of those that differ by nothing that counts.
    pub fn least(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        self.foremost(-1.0, |run| run.least.as_ref())
    }

    /// The run with the greatest.
    pub fn greatest(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        self.foremost(1.0, |run| run.greatest.as_ref())
    }

    /// The run with the least, the axes pressed together as far as their bearings allow; `None` where no play of them is stated.
    pub fn least_pressed(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        let pressed = |run: &'a RunExtremes| run.bearings.as_ref()?.pressed.extreme.as_ref();
        self.foremost(-1.0, pressed)
    }

    /// The run with the greatest, the axes pulled apart likewise.
    pub fn greatest_apart(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        let apart = |run: &'a RunExtremes| run.bearings.as_ref()?.apart.extreme.as_ref();
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
        each.reduce(
            |one, other| match sign * (other.1.found() - one.1.found()) > WIDTH {
                true => other,
                false => one,
            },
        )
    }

    /// The worst pose of all, its run and the pair in it: jammed before the least backlash; `None` where nothing is in mesh.
    pub fn worst(&self) -> Option<(&'a RunExtremes, &'a GearPair, &'a ComparedPose)> {
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

    /// The distance from which the runs that do not assemble all do; `None` where one never does.
    pub fn assembles_from(&self) -> Option<AssemblesFrom> {
        let failing = self
            .runs
            .iter()
            .filter(|run| run.assembles() == Some(false) && run.status != Status::NoContact);
        let from = failing.map(|run| run.assembles_from);
        from.collect::<Option<Vec<AssemblesFrom>>>()?
            .into_iter()
            .reduce(|a, b| if b.high > a.high { b } else { a })
    }

    /// The distance up to which the runs that are out of mesh are all in mesh; `None` where one is at no distance.
    pub fn meshes_to(&self) -> Option<MeshesTo> {
        let runs = self.runs.iter();
        let apart = runs.filter(|run| run.status == Status::NoContact);
        let to = apart.map(|run| run.meshes_to);
        to.collect::<Option<Vec<MeshesTo>>>()?
            .into_iter()
            .reduce(|a, b| if b.low < a.low { b } else { a })
    }
}

/// What a run has of a quantity at an end.
pub(super) struct FoundEnd {
    /// As [`Unmet::found`].
    pub bracket: Option<[f64; 2]>,
    /// As [`Unmet::holds`].
    pub holds: bool,
    /// As [`Unmet::with_play`].
    pub with_play: bool,
}

/// What of `limits` is not kept by all of `runs`; `found` says what a run has at its least, and, `true`, at its greatest.
pub(super) fn unmet<R>(
    quantity: Quantity,
    limits: &Limits,
    runs: &[R],
    found: impl Fn(&R, bool) -> FoundEnd,
) -> Vec<Unmet> {
    let ends = [(limits.min, false), (limits.max, true)];
    let ends = ends
        .into_iter()
        .filter_map(|(limit, is_max)| Some((limit?, is_max)));
    ends.filter_map(|(limit, is_max)| {
        let each = runs.iter().map(|run| {
            let FoundEnd {
                bracket,
                holds,
                with_play,
            } = found(run, is_max);
            Unmet {
                quantity,
                limit,
                is_max,
                found: bracket,
                straddles: bracket.is_some_and(|[low, high]| low < limit && limit < high),
                holds,
                with_play,
            }
        });
        let beyond = |unmet: &Unmet| match unmet.found {
            None => f64::INFINITY,
            Some([_, high]) if is_max => high - limit,
            Some([low, _]) => limit - low,
        };
        let kept = |unmet: &Unmet| beyond(unmet) <= 0.0 && unmet.holds;
        let each = each.filter(|unmet| !kept(unmet));
        each.max_by(|one, other| beyond(one).total_cmp(&beyond(other)))
    })
    .collect()
}

/// The pair with its least or its greatest backlash: where the bearings let the axes move, pressed together or pulled apart.
fn extreme(run: &RunExtremes, is_max: bool) -> (&GearPair, Option<&RunExtreme>) {
    match (&run.bearings, is_max) {
        (Some(play), true) => (&play.apart.assembly, play.apart.extreme.as_ref()),
        (Some(play), false) => (&play.pressed.assembly, play.pressed.extreme.as_ref()),
        (None, true) => (&run.assembly, run.greatest.as_ref()),
        (None, false) => (&run.assembly, run.least.as_ref()),
    }
}

/// The least or the greatest of a quantity over a run.
fn found(quantity: Quantity, run: &RunExtremes, is_max: bool) -> Option<[f64; 2]> {
    let (assembly, extreme) = extreme(run, is_max);
    let of = |j_wt| quantity.value(assembly, j_wt, is_max);
    match (quantity, extreme) {
        // Which needs no contact.
        (Quantity::RadialClearance, _) => Some([of(0.0); 2]),
        (_, extreme) => extreme.map(|extreme| [extreme.low, extreme.high].map(of)),
    }
}

//! The verdict: whether a pair assembles over its whole mesh cycle, and whether it keeps what is required of it.

use super::diagnosis::{self, Diagnosis};
use super::extremes::{RunExtreme, RunExtremes};
use super::study::Study;
use super::uncertainty::Uncertainty;
use crate::contact::Status;
use crate::pair::{GearPair, Member};

/// Ends of what is allowed; `None`: none.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Limits {
    /// No less than this.
    pub min: Option<f64>,
    /// No more than this.
    pub max: Option<f64>,
}

/// What of a pair is limited.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Quantity {
    /// Circumferential backlash on the operating pitch circle, `j_wt`, mm.
    OperatingBacklash,
    /// The same on the reference circle of the gear that turns, `j_t = j_wt r/r_w`, mm.
    ReferenceBacklash,
    /// Normal backlash, `j_bn = j_wt cos α_wt`, mm.
    NormalBacklash,
    /// Radial backlash, `j_r = j_wt/(2 tan α_wt)`, mm.
    RadialBacklash,
    /// Lost motion of a gear, `j_wt/r_w`, rad.
    LostMotion(Member),
    /// Radial clearance between the tips of one gear and the roots of the other, the least of both, mm.
    RadialClearance,
}

impl Quantity {
    /// What `j_wt`, mm, comes to on `assembly`.
    fn of(self, assembly: &GearPair, j_wt: f64) -> f64 {
        let backlash = assembly.backlash(j_wt);
        match self {
            Quantity::OperatingBacklash | Quantity::RadialClearance => backlash.j_wt,
            Quantity::ReferenceBacklash => backlash.j_t,
            Quantity::NormalBacklash => backlash.j_bn,
            Quantity::RadialBacklash => backlash.j_r,
            Quantity::LostMotion(member) => (backlash.arcmin(member) / 60.0).to_radians(),
        }
    }
}

/// What a pair must keep, each over the whole mesh cycle and at every centre distance and material.
pub type Requirements = Vec<(Quantity, Limits)>;

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
    /// Ids of the checks that fail, where checks were made; no id twice.
    pub failed_checks: Vec<&'static str>,
    /// What the measurements may be off, where that is stated.
    pub uncertainty: Option<Uncertainty>,
}

impl<'a> Verdict<'a> {
    /// Of `runs`, `required`, and of the checks if there are any.
    pub fn new(
        runs: &'a [RunExtremes],
        required: &Requirements,
        checks: Option<&Diagnosis>,
    ) -> Verdict<'a> {
        let unmet: Vec<Unmet> = required
            .iter()
            .flat_map(|(quantity, limits)| unmet(*quantity, limits, runs))
            .collect();
        let requirement = match (required.is_empty(), unmet.is_empty()) {
            (true, _) => Requirement::None,
            (false, true) => Requirement::Met,
            (false, false) => Requirement::NotMet,
        };
        let mut failed_checks = Vec::new();
        let groups = checks.into_iter().flat_map(|diagnosis| &diagnosis.groups);
        for check in groups.flat_map(|group| &group.checks) {
            if check.verdict == diagnosis::Verdict::Fail && !failed_checks.contains(&check.id) {
                failed_checks.push(check.id);
            }
        }
        Verdict {
            runs,
            requirement,
            unmet,
            failed_checks,
            uncertainty: None,
        }
    }

    /// Of the runs of `study`.
    pub fn of_study(
        study: &Study,
        runs: &'a [RunExtremes],
        checks: Option<&Diagnosis>,
    ) -> Verdict<'a> {
        Verdict {
            uncertainty: study.uncertainty,
            ..Verdict::new(runs, &study.requirements, checks)
        }
    }

    /// Expanded uncertainty of an extreme's `j_wt`, mm, where uncertainties are stated.
    pub fn expanded(&self, run: &RunExtremes, extreme: &RunExtreme) -> Option<f64> {
        self.uncertainty?.of(run, extreme)
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

    /// The run with the least backlash of all, a jammed one before.
    pub fn least(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        let each = self.runs.iter();
        let each = each.filter_map(|run| Some((run, run.least.as_ref()?)));
        each.min_by(|one, other| one.1.found().total_cmp(&other.1.found()))
    }

    /// The run with the greatest.
    pub fn greatest(&self) -> Option<(&'a RunExtremes, &'a RunExtreme)> {
        let each = self.runs.iter();
        let each = each.filter_map(|run| Some((run, run.greatest.as_ref()?)));
        // The first of equals, as with the least.
        each.rev()
            .max_by(|one, other| one.1.found().total_cmp(&other.1.found()))
    }

    /// The worst pose of all: jammed before the least backlash; `None` where nothing is in mesh.
    pub fn worst(&self) -> Option<(&'a RunExtremes, &'a super::compare::ComparedPose)> {
        let mut jammed = self.runs.iter().filter(|run| run.status == Status::Jammed);
        let jammed = jammed.find_map(|run| Some((run, run.lost.as_ref()?)));
        let least = || self.least().map(|(run, least)| (run, &least.pose));
        jammed.or_else(least)
    }

    /// The least and the greatest distance, mm, from which the runs that do not assemble do; `None` where one never does.
    pub fn assembles_from(&self) -> Option<f64> {
        let failing = self
            .runs
            .iter()
            .filter(|run| run.assembles() == Some(false));
        let from = failing.map(|run| run.assembles_from.map(|[_, high]| high));
        from.collect::<Option<Vec<f64>>>()?
            .into_iter()
            .reduce(f64::max)
    }
}

/// What of `limits` is not kept by all of `runs`.
fn unmet(quantity: Quantity, limits: &Limits, runs: &[RunExtremes]) -> Vec<Unmet> {
    let ends = [(limits.min, false), (limits.max, true)];
    let ends = ends
        .into_iter()
        .filter_map(|(limit, is_max)| Some((limit?, is_max)));
    ends.filter_map(|(limit, is_max)| {
        let each = runs.iter().map(|run| {
            let found = found(quantity, run, is_max);
            Unmet {
                quantity,
                limit,
                is_max,
                found,
                straddles: found.is_some_and(|[low, high]| low < limit && limit < high),
            }
        });
        let beyond = |unmet: &Unmet| match unmet.found {
            None => f64::INFINITY,
            Some([_, high]) if is_max => high - limit,
            Some([low, _]) => limit - low,
        };
        let worst = each.max_by(|one, other| beyond(one).total_cmp(&beyond(other)))?;
        (beyond(&worst) > 0.0).then_some(worst)
    })
    .collect()
}

/// The least or the greatest of a quantity over a run.
fn found(quantity: Quantity, run: &RunExtremes, is_max: bool) -> Option<[f64; 2]> {
    if quantity == Quantity::RadialClearance {
        let value = radial_clearance(&run.assembly, is_max);
        return Some([value; 2]);
    }
    let extreme = match is_max {
        true => run.greatest.as_ref(),
        false => run.least.as_ref(),
    }?;
    Some([extreme.low, extreme.high].map(|j_wt| quantity.of(&run.assembly, j_wt)))
}

/// Radial clearance of both tips, mm: `a − r_a − r_f` of the other gear, both off their axes to the worse, or to the better side.
fn radial_clearance(assembly: &GearPair, best: bool) -> f64 {
    let gear = |member| assembly.gear(member);
    let of = |member: Member| {
        let (one, mate) = (gear(member), gear(member.mate()));
        let off = one.eccentricity() + mate.eccentricity();
        let mean = assembly.center_distance() - one.gear().tip_radius() - mate.gear().root_radius();
        if best { mean + off } else { mean - off }
    };
    of(Member::Wheel).min(of(Member::Pinion))
}

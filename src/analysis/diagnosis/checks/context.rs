//! Every check of one assembled pair, from the evidence of its poses and the searched distances.

use super::start::Searched;
use crate::analysis::diagnosis::check::{Check, Verdict};
use crate::analysis::diagnosis::onset::Onset;
use crate::analysis::diagnosis::pose_evidence::PoseEvidence;
use crate::analysis::diagnosis::zero_distance::ZeroDistance;
use crate::analysis::directions::is_open;
use crate::analysis::extremes::{CycleExtremes, WIDTH};
use crate::analysis::face_loss::FaceLoss;
use crate::contact::Status;
use crate::error::{Error, Tick};
use crate::gear::Gear;
use crate::pair::{GearPair, Mating, Member};

/// The state of a check whose value is a searched distance.
pub(super) enum LimitState<T> {
    /// The limit is known to be met without a search.
    Kept,
    /// The limit is known to be missed without a search.
    Missed,
    /// The result of the search.
    Found(Searched<T>),
}

impl<T> LimitState<T> {
    /// The result of the search; nothing without one.
    pub fn found(self) -> Searched<T> {
        match self {
            LimitState::Found(found) => found,
            LimitState::Kept | LimitState::Missed => Ok(None),
        }
    }
}

/// The data of checks besides the evidence of poses.
pub(super) struct SearchedDistances<'a> {
    /// Whether to skip tips that are clear of all roots in any direction.
    pub clear: bool,
    /// The starts of the pitches over which the clearance of the tips is searched.
    pub pitches: &'a dyn Fn() -> Result<Vec<Mating>, Error>,
    pub zero: LimitState<ZeroDistance>,
    pub onset: LimitState<Onset>,
}

/// One assembled pair with the evidence of its poses.
pub(super) struct CheckContext<'a> {
    pub assembly: &'a GearPair,
    pub evidence: &'a PoseEvidence,
    /// Loss of the least by deviations along the face; `None` if unknown or for a pair without any.
    pub face_loss: Option<FaceLoss>,
    pub allow_off_line: bool,
}

impl CheckContext<'_> {
    /// Every check, except those known to be met.
    pub fn checks(&self, searched: &SearchedDistances, tick: &Tick) -> Result<Vec<Check>, Error> {
        let doubt = PoseEvidence::doubt([self.evidence]);
        let of_poses = |check: Check| match &doubt {
            Some(reason) => check.not_proven(reason),
            None => check,
        };
        let mut checks = Vec::new();
        let look = |member: &Member| !searched.clear || !self.is_surely_clear(*member);
        for member in Member::BOTH.into_iter().filter(look) {
            checks.push(self.clearance(member, &(searched.pitches)()?, tick)?);
        }
        checks.extend(Member::BOTH.map(|member| of_poses(self.k_8(member))));
        checks.extend(Member::BOTH.map(|member| of_poses(self.form(member))));
        checks.extend(of(&searched.onset, |onset| self.onset(onset)));
        checks.push(of_poses(self.off_line()));
        checks.extend(of(&searched.zero, |zero| self.zero(zero)));
        checks.push(of_poses(self.backlash()));
        checks.extend(Member::BOTH.map(|member| self.undercut(member)));
        checks.push(self.contact_ratio());
        checks.extend(Member::BOTH.map(|member| self.tip(member)));
        if self.assembly.deviates_along_face() {
            checks.push(of_poses(self.edge_contact()));
            checks.extend(self.face_use());
            checks.extend(
                Member::BOTH
                    .iter()
                    .filter_map(|member| self.lead_covers(*member)),
            );
            checks.extend(self.tilt());
        }
        Ok(checks)
    }

    pub fn gear(&self, member: Member) -> &Gear {
        self.assembly.gear(member).gear()
    }

    pub fn module(&self) -> f64 {
        self.gear(Member::Wheel).basic_data().module()
    }

    /// Whether the pair assembles over the whole cycle; `None` if that is uncertain or within rounding.
    pub fn assembles(&self, cycle: &CycleExtremes) -> Option<bool> {
        let here = self.evidence.place();
        let runs = cycle.each.iter().filter(|run| run.place() == here);
        // For all directions of a runout the search follows one of them.
        let beyond = if is_open(self.assembly) {
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
        (!each.is_empty()).then(|| each.into_iter().all(|assembles| assembles))
    }
}

/// The check of a searched distance: `of_found` of its result; `None` if the limit is known to be met.
fn of<T>(known: &LimitState<T>, of_found: impl Fn(Option<&T>) -> Check) -> Option<Check> {
    match known {
        LimitState::Kept => None,
        LimitState::Missed => Some(Check {
            verdict: Verdict::Fail,
            ..of_found(None)
        }),
        LimitState::Found(Ok(found)) => Some(of_found(found.as_ref())),
        LimitState::Found(Err(reason)) => Some(of_found(None).not_proven(reason)),
    }
}

pub(super) fn percent(part: usize, whole: usize) -> f64 {
    match whole {
        0 => 0.0,
        _ => 100.0 * part as f64 / whole as f64,
    }
}

/// A length in mm as µm with two decimals, never `-0.00`.
pub(super) fn hundredths(length: f64) -> String {
    let text = format!("{:.2}", length * 1e3);
    match text.as_str() {
        "-0.00" => "0.00".to_owned(),
        _ => text,
    }
}

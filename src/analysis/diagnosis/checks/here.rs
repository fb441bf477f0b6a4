//! Every check of one pair as assembled, of what was seen of it and of what was sought.

use super::start::Searched;
use crate::analysis::diagnosis::check::{Check, Verdict};
use crate::analysis::diagnosis::onset::Onset;
use crate::analysis::diagnosis::seen::Seen;
use crate::analysis::diagnosis::zero_distance::ZeroDistance;
use crate::analysis::directions::is_open;
use crate::analysis::extremes::{CycleExtremes, WIDTH};
use crate::contact::Status;
use crate::error::Error;
use crate::gear::Gear;
use crate::pair::{GearPair, Mating, Member};
use std::ops::ControlFlow;

/// What is known of a distance that is sought.
pub(super) enum Known<T> {
    /// That its check's limit is kept: nothing was sought.
    Kept,
    /// That it is not.
    Missed,
    /// What was found.
    Found(Searched<T>),
}

/// What checks need beside what poses have shown.
pub(super) struct Sought<'a> {
    /// Whether tips that are clear of all roots in any direction need no further look.
    pub clear: bool,
    /// Where the pitches begin over which the clearance of the tips is looked for.
    pub pitches: &'a dyn Fn() -> Result<Vec<Mating>, Error>,
    pub zero: Known<ZeroDistance>,
    pub onset: Known<Onset>,
}

/// One pair as assembled, with what was seen of it.
pub(super) struct Here<'a> {
    pub assembly: &'a GearPair,
    pub seen: &'a Seen,
    pub allow_off_line: bool,
}

impl Here<'_> {
    /// Every check, but for those that are known to be kept.
    pub fn checks(
        &self,
        sought: &Sought,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Vec<Check>, Error> {
        let doubt = Seen::doubt([self.seen]);
        let of_poses = |check: Check| match &doubt {
            Some(reason) => check.not_proven(reason),
            None => check,
        };
        let mut checks = Vec::new();
        let look = |member: &Member| !sought.clear || !self.is_surely_clear(*member);
        for member in Member::BOTH.into_iter().filter(look) {
            checks.push(self.clearance(member, &(sought.pitches)()?, tick)?);
        }
        checks.extend(Member::BOTH.map(|member| of_poses(self.k_8(member))));
        checks.extend(Member::BOTH.map(|member| of_poses(self.form(member))));
        checks.extend(of(&sought.onset, |onset| self.onset(onset)));
        checks.push(of_poses(self.off_line()));
        checks.extend(of(&sought.zero, |zero| self.zero(zero)));
        checks.push(of_poses(self.backlash()));
        checks.extend(Member::BOTH.map(|member| self.undercut(member)));
        checks.push(self.contact_ratio());
        checks.extend(Member::BOTH.map(|member| self.tip(member)));
        Ok(checks)
    }

    pub fn gear(&self, member: Member) -> &Gear {
        self.assembly.gear(member).gear()
    }

    pub fn module(&self) -> f64 {
        self.gear(Member::Wheel).basic_data().module()
    }

    /// Whether the pair assembles over the whole cycle, where that is beyond doubt and rounding.
    pub fn assembles(&self, cycle: &CycleExtremes) -> Option<bool> {
        let distance = self.assembly.center_distance();
        let runs = cycle.each.iter().filter(|run| {
            run.material == self.seen.material && run.assembly.center_distance() == distance
        });
        // Over all directions of a runout the search follows one of them.
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

/// The check of what is known of a distance: `of_found` of what was found; none where it is known to be kept.
fn of<T>(known: &Known<T>, of_found: impl Fn(Option<&T>) -> Check) -> Option<Check> {
    match known {
        Known::Kept => None,
        Known::Missed => Some(Check {
            verdict: Verdict::Fail,
            ..of_found(None)
        }),
        Known::Found(Ok(found)) => Some(of_found(found.as_ref())),
        Known::Found(Err(reason)) => Some(of_found(None).not_proven(reason)),
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

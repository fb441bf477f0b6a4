//! The limits that pairs of outlines do not keep, at the poses that were looked at.

use super::{OutlineRun, OutlineStudy};
use crate::analysis::requirement::{Quantity, clearance_off_axes};
use crate::analysis::verdict::{FoundEnd, Requirement, Unmet, lost_motion_of, unmet};
use crate::contact::Status;
use crate::pair::Member;

impl OutlineStudy {
    /// The limits that `runs` do not keep, each with its worst value. Only `j_wt`, lost motions and radial clearance have a value; of the
    /// first two a run has none where a pose is jammed, out of mesh or unproven.
    pub fn unmet(&self, runs: &[OutlineRun]) -> Vec<Unmet> {
        unmet(&self.requirements, runs, |quantity, run, is_max| FoundEnd {
            bracket: found(quantity, run, is_max),
            holds: true,
            is_attained: run
                .lost
                .as_ref()
                .is_none_or(|pose| pose.status() != Status::Unproven),
            with_play: false,
        })
    }

    /// Whether `runs` keep all limits.
    pub fn requirement(&self, runs: &[OutlineRun]) -> Requirement {
        Requirement::of(&self.requirements, &self.unmet(runs))
    }

    /// The gear whose lost motion is limited, if any.
    pub fn lost_motion_of(&self) -> Option<Member> {
        lost_motion_of(&self.requirements)
    }
}

fn found(quantity: Quantity, run: &OutlineRun, is_max: bool) -> Option<[f64; 2]> {
    if quantity == Quantity::RadialClearance {
        return Some(clearance(run, is_max));
    }
    let pose = if is_max { &run.greatest } else { &run.least };
    let pose = pose.as_ref().filter(|_| run.lost.is_none())?;
    let (j_wt, error) = pose.j_wt?;
    let per = match quantity {
        Quantity::OperatingBacklash => 1.0,
        Quantity::LostMotion(member) => 1.0 / run.pair.operating_pitch_radius(member),
        _ => return None,
    };
    Some([j_wt - error, j_wt + error].map(|mm| mm * per))
}

/// The least or the greatest radial clearance, mm, within what the drawings are off.
fn clearance(run: &OutlineRun, is_max: bool) -> [f64; 2] {
    let both = Member::BOTH;
    let ends = both.map(|member| run.pair.radial_clearance(member)[usize::from(is_max)]);
    let off = both.map(|member| run.pair.gear(member).eccentricity());
    let bound: f64 = both
        .map(|member| run.pair.gear(member).bound())
        .iter()
        .sum();
    let value = clearance_off_axes(ends, off, is_max);
    [value - bound, value + bound]
}

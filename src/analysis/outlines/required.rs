//! What pairs of outlines do not keep of what is required, at the poses that were looked at.

use super::{OutlineRun, OutlineStudy};
use crate::analysis::requirement::{Quantity, clearance_off_axes};
use crate::analysis::verdict::{FoundEnd, Requirement, Unmet, unmet};
use crate::pair::Member;

impl OutlineStudy {
    /// The limits that `runs` do not keep, of each the worst. Only `j_wt`, lost motions and radial clearance have a value; of the first two a run with a pose that is jammed, out of mesh or
    /// not settled has none.
    pub fn unmet(&self, runs: &[OutlineRun]) -> Vec<Unmet> {
        let each = self.requirements.iter();
        let each = each.flat_map(|(quantity, limits)| {
            let found = |run: &OutlineRun, is_max| FoundEnd {
                bracket: found(*quantity, run, is_max),
                holds: true,
                with_play: false,
            };
            unmet(*quantity, limits, runs, found)
        });
        each.collect()
    }

    /// Whether `runs` keep what is required.
    pub fn requirement(&self, runs: &[OutlineRun]) -> Requirement {
        Requirement::of(&self.requirements, &self.unmet(runs))
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

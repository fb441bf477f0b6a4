//! The least and the greatest of a cycle as a result, and the poses seen on the way to it.

use super::course::Course;
use crate::contact::lost_motion::Status;
use crate::error::Error;
use crate::pair::Mating;

/// Extremes of one assembly over its mesh cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extremes {
    /// Matings of the cycle.
    pub matings: u64,
    /// How the worst of its poses ends: jammed, else out of mesh, else with interference, else clear.
    pub status: Status,
    /// The least; `None` where a pose is jammed.
    pub least: Option<Extreme>,
    /// The greatest; `None` where a pose is out of mesh.
    pub greatest: Option<Extreme>,
    /// A pose that is jammed or out of mesh, where `status` says so.
    pub lost: Option<Mating>,
}

/// One extreme of `j_wt`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extreme {
    /// `j_wt` is no less, mm.
    pub low: f64,
    /// And no greater, mm.
    pub high: f64,
    /// Where the pose stands that attains the end of the bracket which was found.
    pub mating: Mating,
    /// Why the bracket is not proven; `None`: it is.
    pub doubt: Option<Doubt>,
}

impl Extreme {
    /// Whether no rotation of the cycle lies beyond the bracket.
    pub fn is_proven(&self) -> bool {
        self.doubt.is_none()
    }
}

/// Why an extreme is only what was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Doubt {
    /// Fillets or roots may be touched, or a tooth is not an involute: nothing bounds the lost motion between poses.
    OffInvolute,
    /// Too many stretches of the cycle come too near to each other: the bracket holds, and is wider than was wanted.
    Effort,
    /// Too many stretches of the cycle have no bound: no pair stays on the line of action all through them.
    Unbounded,
    /// What a runout of any direction does is bounded to the second order of the lost motion: the bracket holds, and is wider than was wanted.
    SecondOrder,
    /// Profile deviations are bounded by the greatest and the least of each flank: the bracket holds, and is wider than was wanted.
    Profile,
    /// A contact was lost at a pose.
    ContactLost,
    /// A gear is drawn: extremes are those of sampled poses, and of more round the best.
    Sampled,
}

/// A bound that holds for the whole cycle, rad, and why it is not as near as it was wanted.
pub(super) type Proof = (f64, Option<Doubt>);

/// No bound at all.
pub(super) const UNKNOWN: Proof = (f64::NAN, Some(Doubt::OffInvolute));

/// Poses seen so far.
#[derive(Debug, Default)]
pub(super) struct PosesSeen {
    pub least: Option<Seen>,
    pub greatest: Option<Seen>,
    pub jammed: Option<Mating>,
    pub unmeshed: Option<Mating>,
    lost: bool,
    /// Whether the cycle was sampled.
    pub sampled: bool,
}

/// The lost motion at a pose, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    pub angle: f64,
    error: f64,
    pub mating: Mating,
}

impl PosesSeen {
    /// Looks at a pose.
    pub fn look(&mut self, course: &Course, mating: Mating) -> Result<(), Error> {
        let (found, effort) = course.kernel.lost_motion_counted(course.assembly, mating);
        course.effort.spend(effort);
        let Some(found) = found? else {
            self.lost = true;
            return Ok(());
        };
        match found.status() {
            Status::Jammed => self.jammed = self.jammed.or(Some(mating)),
            Status::NoContact => self.unmeshed = self.unmeshed.or(Some(mating)),
            _ => (),
        }
        if let Some((angle, error)) = found.angle().zip(found.error()) {
            self.take(Seen {
                angle,
                error,
                mating,
            });
        }
        Ok(())
    }

    fn take(&mut self, seen: Seen) {
        if self.least.is_none_or(|least| seen.angle < least.angle) {
            self.least = Some(seen);
        }
        if self.greatest.is_none_or(|most| seen.angle > most.angle) {
            self.greatest = Some(seen);
        }
    }

    /// The result, with the proofs of the least and the greatest.
    pub fn extremes(&self, course: &Course, [least, greatest]: [Proof; 2]) -> Extremes {
        let per_radian = course.per_radian();
        let extreme = |seen: Seen, (bound, doubt): Proof| {
            let (low, high) = (seen.angle - seen.error, seen.angle + seen.error);
            let bounds = match bound.is_finite() {
                true => (low.min(bound), high.max(bound)),
                false => (low, high),
            };
            Extreme {
                low: bounds.0 * per_radian,
                high: bounds.1 * per_radian,
                mating: seen.mating,
                doubt: match self.lost {
                    true => Some(Doubt::ContactLost),
                    false => doubt,
                },
            }
        };
        let low_end = self.least.map(|seen| extreme(seen, least));
        let high_end = self.greatest.map(|seen| extreme(seen, greatest));
        let interferes = self.least.is_some_and(|seen| seen.angle < -seen.error);
        let status = match (self.jammed, self.unmeshed) {
            (Some(_), _) => Status::Jammed,
            (None, Some(_)) => Status::NoContact,
            (None, None) if self.least.is_none() => Status::Unproven,
            (None, None) if interferes => Status::Interference,
            (None, None) => Status::Clear,
        };
        Extremes {
            matings: course.matings,
            status,
            least: low_end.filter(|_| self.jammed.is_none()),
            greatest: high_end.filter(|_| self.unmeshed.is_none()),
            lost: self.jammed.or(self.unmeshed),
        }
    }
}

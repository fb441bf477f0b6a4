//! One assembly of a population, and its extremes over the whole mesh cycle.

use crate::analysis::extremes::{WIDTH, extremes_of_phase, proven_width};
use crate::contact::{Extreme, Extremes, Status, is_proven};
use crate::error::Error;
use crate::outline::AssembledPair;

/// One pair as assembled.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembly {
    /// The pair.
    pub pair: AssembledPair,
    /// Radial play of both bearings together, mm.
    pub clearance: f64,
    /// The pinion tooth whose right flank meets that of wheel tooth 1.
    pub phase: u32,
}

/// How an assembly ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum OutcomeKind {
    /// Backlash at every pose.
    Clear,
    /// Negative backlash at a pose.
    Interference,
    /// A pose at which a tip sits in a root: no free rotation.
    Jammed,
    /// A pose out of mesh: nothing touches.
    NoContact,
    /// No extreme found.
    Unproven,
    /// Numbers that no gear or no pair has.
    Impossible,
}

impl OutcomeKind {
    /// All of them, in the order of their codes.
    pub const ALL: [OutcomeKind; 6] = [
        OutcomeKind::Clear,
        OutcomeKind::Interference,
        OutcomeKind::Jammed,
        OutcomeKind::NoContact,
        OutcomeKind::Unproven,
        OutcomeKind::Impossible,
    ];

    /// The word for it in results.
    pub fn name(self) -> &'static str {
        match self {
            OutcomeKind::Clear => "clear",
            OutcomeKind::Interference => "interference",
            OutcomeKind::Jammed => "jammed",
            OutcomeKind::NoContact => "no_contact",
            OutcomeKind::Unproven => "unproven",
            OutcomeKind::Impossible => "impossible",
        }
    }
}

/// The backlash of one assembly over its whole mesh cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Its kind.
    pub kind: OutcomeKind,
    /// Least `j_wt`, mm: no pose has less. `None` if a pose is jammed, or none was found.
    pub least: Option<f64>,
    /// Greatest `j_wt`, mm: no pose has more. `None` if a pose is out of mesh, or none was found.
    pub greatest: Option<f64>,
    /// Whether its extremes are proven; `false` without any.
    pub is_proven: bool,
}

impl Assembly {
    /// The pair with its least and that with its greatest backlash: the axes as near, and as far apart, as the bearings
    /// allow. `None` if one of them is impossible.
    pub(crate) fn ends(&self) -> Option<[AssembledPair; 2]> {
        let distance = self.pair.center_distance();
        if self.clearance > 0.0 {
            let near = self.pair.at(distance - self.clearance).ok()?;
            Some([near, self.pair.at(distance + self.clearance).ok()?])
        } else {
            Some([self.pair.clone(), self.pair.clone()])
        }
    }

    /// Its proven extremes. With bearing clearance the axes are as near as possible for the least, and as far apart as possible for the greatest.
    ///
    /// # Errors
    /// Only a stopped calculation is an error: a pose that fails is an outcome.
    pub fn outcome(&self) -> Result<Outcome, Error> {
        let at = |farther: f64| {
            let pair = if farther == 0.0 {
                self.pair.clone()
            } else {
                self.pair.at(self.pair.center_distance() + farther)?
            };
            extremes_of_phase(&pair, self.phase, WIDTH)
        };
        let found = if self.clearance > 0.0 {
            at(-self.clearance).and_then(|near| {
                let far = at(self.clearance)?;
                Ok(Extremes {
                    status: status_of_ends(near.status, far.status),
                    greatest: far.greatest,
                    ..near
                })
            })
        } else {
            at(0.0)
        };
        match found {
            Ok(found) => Ok(Outcome::of(&found, proven_width(&self.pair))),
            Err(Error::Gear(_) | Error::Outline(_)) => {
                Ok(Outcome::without(OutcomeKind::Impossible))
            }
            Err(error) if error.pose_failure().is_some() => {
                Ok(Outcome::without(OutcomeKind::Unproven))
            }
            Err(error) => Err(error),
        }
    }
}

/// Jammed when the axes are near; otherwise out of mesh when they are far; otherwise as when they are near.
fn status_of_ends(near: Status, far: Status) -> Status {
    match (near, far) {
        (Status::Jammed, _) => Status::Jammed,
        (_, Status::NoContact) => Status::NoContact,
        _ => near,
    }
}

impl Outcome {
    /// The least of the pair with near axes (this outcome) and the greatest of the pair with far axes (`far`).
    #[cfg(feature = "matching")]
    pub(crate) fn with_far(&self, far: &Outcome) -> Outcome {
        let kind = match (self.kind, far.kind) {
            (OutcomeKind::Jammed, _) => OutcomeKind::Jammed,
            (_, OutcomeKind::NoContact | OutcomeKind::Impossible) => far.kind,
            (near, _) => near,
        };
        Outcome {
            kind,
            least: self.least,
            greatest: far.greatest,
            is_proven: match (self.least, far.greatest) {
                (None, None) => false,
                (Some(_), None) => self.is_proven,
                (None, Some(_)) => far.is_proven,
                (Some(_), Some(_)) => self.is_proven && far.is_proven,
            },
        }
    }

    /// An outcome without extremes.
    pub(super) fn without(kind: OutcomeKind) -> Outcome {
        Outcome {
            kind,
            least: None,
            greatest: None,
            is_proven: false,
        }
    }

    /// The outcome of extremes whose brackets are proven within `width`, mm.
    fn of(found: &Extremes, width: f64) -> Outcome {
        let is_proven = |extreme: &Extreme| is_proven(extreme.low, extreme.high, width);
        // The safe end of a proven bracket; the attained value of a wide one.
        let value = |extreme: Extreme, safe: f64| {
            if is_proven(&extreme) {
                safe
            } else {
                extreme.found
            }
        };
        let both = [found.least, found.greatest];
        Outcome {
            kind: match found.status {
                Status::Clear => OutcomeKind::Clear,
                Status::Interference => OutcomeKind::Interference,
                Status::Jammed => OutcomeKind::Jammed,
                Status::NoContact => OutcomeKind::NoContact,
                Status::Unproven => OutcomeKind::Unproven,
            },
            least: found.least.map(|least| value(least, least.low)),
            greatest: found
                .greatest
                .map(|greatest| value(greatest, greatest.high)),
            is_proven: both.iter().any(Option::is_some) && both.iter().flatten().all(is_proven),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Doubt;
    use crate::pair::Mating;

    /// An outcome without extremes is unproven; a jammed pair is proven if its one extreme is.
    #[test]
    fn nothing_is_proven_of_an_outcome_without_values() {
        let extreme = |doubt: Option<Doubt>| Extreme {
            low: 0.1,
            high: if doubt.is_some() { 0.2 } else { 0.1 },
            found: 0.1,
            mating: Mating::FIRST,
            doubt,
        };
        let doubted = Some(Some(Doubt::Effort));
        for (status, least, greatest, expected) in [
            (Status::Jammed, None, None, false),
            (Status::Jammed, None, Some(None), true),
            (Status::Jammed, None, doubted, false),
            (Status::Clear, Some(None), doubted, false),
            (Status::Clear, Some(None), Some(None), true),
        ] {
            let found = Extremes {
                matings: 1,
                status,
                least: least.map(extreme),
                greatest: greatest.map(extreme),
                lost: None,
            };
            assert_eq!(Outcome::of(&found, WIDTH).is_proven, expected);
        }
    }
}

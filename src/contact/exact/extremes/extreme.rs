//! The least and the greatest of a cycle as a result, and the poses examined during the search.

use super::mesh_cycle::MeshCycle;
use crate::contact::lost_motion::{LostMotion, Status};
use crate::error::Error;
use crate::pair::Mating;

/// Extremes of one assembly over its mesh cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extremes {
    /// Matings of the cycle.
    pub matings: u64,
    /// The status of its worst pose: jammed, otherwise out of mesh, otherwise interference, otherwise clear.
    pub status: Status,
    /// The least; `None` if a pose is jammed.
    pub least: Option<Extreme>,
    /// The greatest; `None` if a pose is out of mesh.
    pub greatest: Option<Extreme>,
    /// A pose that is jammed or out of mesh, if `status` reports one.
    pub lost: Option<Mating>,
}

impl Extremes {
    /// The least and the greatest, where known.
    pub(crate) fn each(&self) -> impl Iterator<Item = Extreme> {
        self.least.into_iter().chain(self.greatest)
    }

    /// The least or the greatest.
    pub(crate) fn at(&self, end: End) -> Option<Extreme> {
        match end {
            End::Least => self.least,
            End::Greatest => self.greatest,
        }
    }
}

/// Width of a proven bracket of `j_wt`, mm: a nanometre, a hundredth of the accuracy of any measured gear.
pub const PROVEN_WIDTH: f64 = 1e-6;

/// Width of a proven bracket of `j_wt` of a pair with a drawn gear, mm: below what any drawing is made to.
pub const PROVEN_WIDTH_DRAWN: f64 = 5e-5;

/// One extreme of `j_wt`. Its bracket contains the extreme of the whole cycle, at any width.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extreme {
    /// Lower bound, mm; −∞ without one.
    pub low: f64,
    /// Upper bound, mm; ∞ without one.
    pub high: f64,
    /// `j_wt` at `mating`, mm: the best of all examined poses.
    pub found: f64,
    /// The pose that attains `found`.
    pub mating: Mating,
    /// The reason why the bracket is too wide.
    pub doubt: Option<Doubt>,
}

impl Extreme {
    /// Whether the bracket is at most [`PROVEN_WIDTH`] wide.
    pub fn is_proven(&self) -> bool {
        is_proven(self.low, self.high, PROVEN_WIDTH)
    }
}

/// Whether a bracket of `j_wt`, mm, is proven: at most `width` wide.
pub(crate) fn is_proven(low: f64, high: f64, width: f64) -> bool {
    // Rounding of a difference of two lengths.
    high - low <= width * (1.0 + 1e-3)
}

/// The reason why a bracket is too wide.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Doubt {
    /// Fillets or roots may touch, or a tooth is no involute: nothing bounds the lost motion between poses.
    OffInvolute,
    /// Too many stretches of the cycle are near the extreme.
    Effort,
    /// Too many stretches of the cycle have no bound: no pair stays on the line of action throughout them.
    Unbounded,
    /// A runout of any direction is bounded to the second order of the lost motion.
    SecondOrder,
    /// Profile deviations are bounded by the greatest and the least of each flank.
    Profile,
    /// A contact was lost at a pose: nothing bounds the extreme.
    ContactLost,
    /// The uncertainty of the drawings is wider than the requested bracket.
    Drawing,
    /// The bound over the face, with the error by sections of leaning axes, is wider than the requested bracket.
    Sections,
    /// Axes without a stated place are bounded all together.
    Axes,
}

/// A bound for the whole cycle, rad, and the reason why it is too far away.
pub(super) type CycleBound = (f64, Option<Doubt>);

/// No bound.
pub(super) const UNKNOWN: CycleBound = (f64::NAN, Some(Doubt::OffInvolute));

/// The best poses examined so far.
#[derive(Debug, Default)]
pub(super) struct ExaminedPoses {
    /// The least and the greatest.
    pub best: [Option<PoseValue>; 2],
    /// The first pose without a least, which is jammed, and the first without a greatest, which is out of mesh.
    without: [Option<Mating>; 2],
    lost: bool,
    /// Lower bound of the least and upper bound of the greatest from sampling the cycle, rad.
    pub sampled: Option<[f64; 2]>,
}

/// The lost motion at a pose, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct PoseValue {
    pub angle: f64,
    error: f64,
    pub mating: Mating,
}

impl ExaminedPoses {
    /// Examines a pose; `None` if the contact is lost.
    pub fn examine(
        &mut self,
        cycle: &MeshCycle,
        mating: Mating,
    ) -> Result<Option<LostMotion>, Error> {
        let (found, effort) = cycle.kernel.lost_motion_counted(cycle.assembly, mating);
        cycle.effort.spend(effort);
        let Some(found) = found? else {
            self.lost = true;
            return Ok(None);
        };
        match found.status() {
            Status::Jammed => _ = self.without[0].get_or_insert(mating),
            Status::NoContact => _ = self.without[1].get_or_insert(mating),
            _ => (),
        }
        if let Some((angle, error)) = found.angle().zip(found.error()) {
            let seen = PoseValue {
                angle,
                error,
                mating,
            };
            for (best, end) in self.best.iter_mut().zip(End::BOTH) {
                if best.is_none_or(|best| end.sign() * angle < end.sign() * best.angle) {
                    *best = Some(seen);
                }
            }
        }
        Ok(Some(found))
    }

    /// Whether a pose has no such extreme.
    pub fn lacks(&self, end: Option<End>) -> bool {
        end.is_some_and(|end| self.without[end as usize].is_some())
    }

    /// Upper bound of the lost motion over the cycle, rad, by a search for the greatest with the result `proof`; ∞ without one.
    pub fn most(&self, (bound, _): CycleBound) -> f64 {
        match self.best[1] {
            Some(seen) if !self.lost && self.without[1].is_none() && bound.is_finite() => {
                bound.max(seen.angle + seen.error)
            }
            _ => f64::INFINITY,
        }
    }

    /// The result, with the `proofs` of the least and the greatest.
    pub fn extremes(&self, cycle: &MeshCycle, proofs: [CycleBound; 2]) -> Extremes {
        let per_radian = cycle.per_radian();
        // The attained value bounds one end, the proof the other.
        let extreme = |end: End| -> Option<Extreme> {
            let seen = self.best[end as usize].filter(|_| !self.lacks(Some(end)))?;
            let (bound, doubt) = proofs[end as usize];
            // The better bound of the search and of the poses.
            let sampled = self.sampled.map_or(f64::NAN, |bounds| bounds[end as usize]);
            let (bound, doubt) = match end {
                _ if self.lost => (f64::NAN, Some(Doubt::ContactLost)),
                End::Least => (bound.max(sampled), doubt),
                End::Greatest => (bound.min(sampled), doubt),
            };
            let (mut low, mut high) = (seen.angle - seen.error, seen.angle + seen.error);
            match (end, bound.is_finite()) {
                (End::Least, true) => low = low.min(bound),
                (End::Least, false) => low = f64::NEG_INFINITY,
                (End::Greatest, true) => high = high.max(bound),
                (End::Greatest, false) => high = f64::INFINITY,
            }
            Some(Extreme {
                low: low * per_radian,
                high: high * per_radian,
                found: seen.angle * per_radian,
                mating: seen.mating,
                doubt,
            })
        };
        let [jammed, unmeshed] = self.without;
        let status = match self.best[0] {
            _ if jammed.is_some() => Status::Jammed,
            _ if unmeshed.is_some() => Status::NoContact,
            None => Status::Unproven,
            Some(least) if least.angle < -least.error => Status::Interference,
            Some(_) => Status::Clear,
        };
        let [least, greatest] = End::BOTH.map(extreme);
        Extremes {
            matings: cycle.matings,
            status,
            least,
            greatest,
            lost: jammed.or(unmeshed),
        }
    }
}

/// The extreme that is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    Least,
    Greatest,
}

impl End {
    pub const BOTH: [End; 2] = [End::Least, End::Greatest];

    /// The sign that makes the least of the values the extreme.
    pub fn sign(self) -> f64 {
        match self {
            End::Least => 1.0,
            End::Greatest => -1.0,
        }
    }

    /// Greatest excess of a stretch with these bounds over everything else: the sign makes the least a greatest.
    pub fn key(self, low: f64, high: f64) -> f64 {
        let key = match self {
            End::Least => -low,
            End::Greatest => high,
        };
        // Without a bound any excess is possible.
        if key.is_nan() { f64::INFINITY } else { key }
    }

    /// The guaranteed value of a stretch with these bounds.
    pub fn guaranteed(self, low: f64, high: f64) -> f64 {
        match self {
            End::Least => -high,
            End::Greatest => low,
        }
    }
}

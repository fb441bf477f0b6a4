//! Extremes of the curve `a''` of a roll test between its poses.
//!
//! `a''` is the greatest of the distances at which single pairs of contacts are closed. So it has kinks between smooth
//! stretches where the contacts change. Even poses hit neither the kinks nor the maxima. Three steps find them:
//!
//! 1. Between two even poses with different teeth or curves in contact, the step is halved [`HALVINGS`] times. This finds a
//!    minimum between two level stretches, where one pair has left and the next has not come.
//! 2. A piece of length `h` has the values `f_0, f_1` and slopes `m_0, m_1` at its ends; the contacts of a pose give its slope.
//!    The slope of `f` between them is assumed to be at most `L = max(m_0, m_1, 2 |f_1 − f_0|/h) + |m_1 − m_0|`.
//!    The function then stays within `(f_0 + f_1)/2 ± L h/2`. (A smooth stretch needs `max(m_0, m_1)` and half their difference.
//!    A ramp between two level stretches needs its own slope, doubled in case it takes half of the piece.)
//! 3. Pieces that may exceed a known extreme are halved until none may by more than the accepted error. That is [`TOTAL`] for
//!    the range of the revolution and then [`WITHIN_PITCH`] for that within a pitch. The number of poses is limited to [`MOST`]
//!    times the even ones. The remaining uncertainty is reported.
//!
//! With the assumed `L` the bracket is proven. The slopes between the poses are not: a feature narrower than a halved
//! step that no pose touches would be missed.

use crate::contact::{PoseClass, ToothPlace};
use crate::error::Error;
use crate::numeric::rank;
use crate::pair::Mating;
use crate::parallel;
use std::collections::BTreeMap;

/// Accepted error of F_i'', mm: a thousandth of a micrometre, far below the resolution of roll testers.
const TOTAL: f64 = 1e-6;
/// Accepted error of f_i'', mm. A window of one pitch has two free ends on the steepest part of the curve, so a smaller
/// error would need many poses.
const WITHIN_PITCH: f64 = 1e-5;
/// Halvings of steps in which the contact changes (tuned: a hundredth of a pitch at the usual 16 poses).
const HALVINGS: u32 = 3;
/// Limit of all poses, as a multiple of the even ones (tuned: the usual gear takes twice as many).
const MOST: usize = 8;
/// Parts of an even step: places are whole numbers of them.
const PARTS: u64 = 1 << 30;

/// One pose of the roll test.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RollPose {
    /// The gear is the wheel, the master the pinion.
    pub mating: Mating,
    /// Rotation of the gear, rad, from the position in which its tooth 1 points at the master.
    pub rotation: f64,
    /// `a''`, mm.
    pub distance: f64,
    /// Bound on its error, mm.
    pub error: f64,
    /// Class of the contacts.
    pub class: PoseClass,
}

/// A range of `a''`, between `found` and `found + missed`, except for twice the error of a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RollRange {
    /// Range over the poses, mm.
    pub found: f64,
    /// Bound on the part of the range between poses, mm.
    pub missed: f64,
}

/// The even poses of a curve.
pub(super) struct DeviationCurve {
    /// Even poses of one revolution.
    pub steps: usize,
    pub steps_per_pitch: usize,
    /// Rotation from one to the next, rad.
    pub step: f64,
}

/// A pose with the slope of the curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct RollSample {
    pub pose: RollPose,
    /// Amount of the slope, mm/rad.
    pub slope: f64,
    /// Right and left contact: teeth and curves of the gear and of the master.
    pub touched: [Option<[(u32, ToothPlace); 2]>; 2],
}

/// The even poses of a test, the others, and its ranges.
pub(super) type Rolled = ([Vec<RollPose>; 2], Ranges);

/// A piece between two neighbouring poses.
struct CurvePiece {
    /// Places of its ends.
    from: u64,
    to: u64,
    /// Values at its ends, the lesser first.
    ends: [f64; 2],
    /// Bounds of the curve.
    within: [f64; 2],
    /// Whether both ends have contacts of one class.
    same_contacts: bool,
}

impl CurvePiece {
    fn slack(&self) -> f64 {
        self.within[1] - self.within[0]
    }
}

/// Takes the even poses of `curve` with `take` (step, part of a step beyond it), and as many more as its ranges need.
/// `more` is called with the number of each further round.
///
/// `None` if a pose has no distance.
pub(super) fn bracketed(
    curve: &DeviationCurve,
    more: &dyn Fn(usize),
    take: &(dyn Fn(usize, f64) -> Result<Option<RollSample>, Error> + Sync),
) -> Result<Option<Rolled>, Error> {
    let mut samples: BTreeMap<u64, RollSample> = BTreeMap::new();
    let mut wanted: Vec<u64> = (0..curve.steps as u64).map(|step| step * PARTS).collect();
    for round in 0.. {
        let taken = parallel::map(&wanted, |place| {
            let beyond = (place % PARTS) as f64 / PARTS as f64;
            take((place / PARTS) as usize, beyond)
        });
        for (place, sample) in wanted.iter().zip(taken) {
            let Some(sample) = sample? else {
                return Ok(None);
            };
            samples.insert(*place, sample);
        }
        let pieces = pieces(curve, &samples);
        let ranges = Ranges::of(curve, &pieces);
        let mut halved: Vec<&CurvePiece> = if round < HALVINGS {
            pieces.iter().filter(|piece| !piece.same_contacts).collect()
        } else {
            ranges.open(&pieces)
        };
        halved.retain(|piece| piece.to - piece.from > 1);
        // The pieces with the greatest possible excess first, because their number is limited.
        halved.sort_by_cached_key(|piece| rank(-piece.slack()));
        halved.truncate((MOST * curve.steps).saturating_sub(samples.len()));
        let middle = |piece: &&CurvePiece| piece.from + (piece.to - piece.from) / 2;
        wanted = halved.iter().map(middle).collect();
        more(wanted.len());
        if round >= HALVINGS && wanted.is_empty() {
            let (even, between): (Vec<_>, Vec<_>) =
                samples.iter().partition(|(place, _)| *place % PARTS == 0);
            let poses = |list: Vec<(&u64, &RollSample)>| list.iter().map(|(_, s)| s.pose).collect();
            return Ok(Some(([poses(even), poses(between)], ranges)));
        }
    }
    Ok(None)
}

fn pieces(curve: &DeviationCurve, samples: &BTreeMap<u64, RollSample>) -> Vec<CurvePiece> {
    let round = curve.steps as u64 * PARTS;
    let first = samples.first_key_value();
    let next = samples
        .iter()
        .skip(1)
        .map(|(place, sample)| (*place, sample))
        .chain(first.map(|(place, sample)| (place + round, sample)));
    let piece = |((from, one), (to, other)): ((&u64, &RollSample), (u64, &RollSample))| {
        let length = curve.step * (to - from) as f64 / PARTS as f64;
        let (f_0, f_1) = (one.pose.distance, other.pose.distance);
        let climb = (f_1 - f_0).abs();
        let steepest =
            one.slope.max(other.slope).max(2.0 * climb / length) + (one.slope - other.slope).abs();
        let (middle, reach) = (0.5 * (f_0 + f_1), 0.5 * steepest * length);
        CurvePiece {
            from: *from,
            to,
            ends: [f_0.min(f_1), f_0.max(f_1)],
            within: [middle - reach, middle + reach],
            same_contacts: one.touched == other.touched,
        }
    };
    samples.iter().zip(next).map(piece).collect()
}

/// Both ranges, and the pieces that leave them uncertain.
pub(super) struct Ranges {
    pub total: RollRange,
    pub tooth_to_tooth: RollRange,
    /// Whether each piece must be halved, for the one and the other range.
    open: [Vec<bool>; 2],
}

impl Ranges {
    fn of(curve: &DeviationCurve, pieces: &[CurvePiece]) -> Ranges {
        let all = RangeOfPieces::of(pieces.iter());
        let mut within = vec![false; pieces.len()];
        let total: Vec<bool> = pieces
            .iter()
            .map(|piece| {
                piece.within[0] < all.found[0] - 0.5 * TOTAL
                    || piece.within[1] > all.found[1] + 0.5 * TOTAL
            })
            .collect();
        let pitch = curve.steps_per_pitch as u64 * PARTS;
        let round = curve.steps as u64 * PARTS;
        // Pieces from `first` on that a window of one pitch starting within piece `first` can reach.
        let reached = |first: usize| {
            let end = pieces[first].to + pitch;
            (first..first + pieces.len())
                .map(|index| {
                    let lap = if index < pieces.len() { 0 } else { round };
                    (index % pieces.len(), lap)
                })
                .take_while(move |(index, lap)| pieces[*index].from + lap < end)
        };
        let mut found: f64 = 0.0;
        let mut windows = Vec::with_capacity(pieces.len());
        for (first, piece) in pieces.iter().enumerate() {
            // Poses of the window that starts with the piece.
            let last = piece.from + pitch;
            let inside = reached(first)
                .filter(|(index, lap)| pieces[*index].to + lap <= last)
                .map(|(index, _)| &pieces[index]);
            found = found.max(RangeOfPieces::of(inside).range());
            windows.push(RangeOfPieces::of(
                reached(first).map(|(index, _)| &pieces[index]),
            ));
        }
        let mut most = found;
        for (first, window) in windows.iter().enumerate() {
            let reach = window.within[1] - window.within[0];
            most = most.max(reach);
            if reach <= found + WITHIN_PITCH {
                continue;
            }
            // Pieces with the possible extremes of the window, and its two free ends, increase its possible range.
            let mut last = first;
            for (index, _) in reached(first) {
                let piece = &pieces[index];
                let extreme =
                    piece.within[0] <= window.found[0] || piece.within[1] >= window.found[1];
                within[index] |= extreme && piece.slack() > 0.25 * WITHIN_PITCH;
                last = index;
            }
            for index in [first, last] {
                let [low, high] = pieces[index].ends;
                within[index] |= high - low > 0.25 * WITHIN_PITCH;
            }
        }
        Ranges {
            total: RollRange {
                found: all.range(),
                missed: (all.within[1] - all.within[0] - all.range()).max(0.0),
            },
            tooth_to_tooth: RollRange {
                found,
                missed: most - found,
            },
            open: [total, within],
        }
    }

    /// The pieces to halve. The few pieces of the revolution are first.
    fn open<'a>(&self, pieces: &'a [CurvePiece]) -> Vec<&'a CurvePiece> {
        let of = |open: &[bool]| -> Vec<&'a CurvePiece> {
            let marked = pieces.iter().zip(open);
            marked.filter(|(_, open)| **open).map(|(p, _)| p).collect()
        };
        let [total, within] = self.open.each_ref().map(|open| of(open));
        if total.is_empty() { within } else { total }
    }
}

/// Least and greatest value of some pieces: found, and possible.
struct RangeOfPieces {
    found: [f64; 2],
    within: [f64; 2],
}

impl RangeOfPieces {
    fn of<'a>(pieces: impl Iterator<Item = &'a CurvePiece>) -> RangeOfPieces {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let wider =
            |[low, high]: [f64; 2], other: [f64; 2]| [low.min(other[0]), high.max(other[1])];
        let mut span = RangeOfPieces {
            found: nothing,
            within: nothing,
        };
        for piece in pieces {
            span.found = wider(span.found, piece.ends);
            span.within = wider(span.within, piece.within);
        }
        span
    }

    fn range(&self) -> f64 {
        (self.found[1] - self.found[0]).max(0.0)
    }
}

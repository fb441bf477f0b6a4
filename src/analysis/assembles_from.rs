//! The centre distances between which a pair works: from the one at which the least backlash of its whole mesh cycle is 0, up to the one
//! above which tips pass each other somewhere in the cycle.
//!
//! Backlash grows with the distance (`dj_wt/da = 2 tan α_wt`), so the root can be bracketed. A secant leads to it, or a
//! tangent if one end has no value. At each distance the matings that were tightest before are tested first. The whole
//! cycle is searched only if none of them interferes.

use crate::contact::{
    Doubt, Effort, End, ExactKernel, Extreme, Extremes, LostMotion, OutlineCycle, OutlineKernel,
    Status, cycle_extremes_within,
};
use crate::error::{Error, Tick};
use crate::numeric::try_bisect;
use crate::outline::OutlinePair;
use crate::pair::{GearPair, Mating, Member};

/// Width of the bracket, mm.
const DISTANCE_WIDTH: f64 = 1e-6;

/// Limit of steps (about ten are usual, about thirty by bisection alone).
const STEPS: usize = 60;

/// A centre distance at which a pair begins or ceases to work over its whole mesh cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Threshold {
    /// A distance below it, mm.
    pub low: f64,
    /// A distance above it, mm.
    pub high: f64,
    /// The reason why it is unproven.
    pub doubt: Option<Doubt>,
    /// A pose that does not work on the side where the pair does not: the tightest, or one out of mesh.
    pub mating: Mating,
}

impl Threshold {
    /// This distance, increased by `by`, mm.
    pub(super) fn farther(self, by: f64) -> Threshold {
        Threshold {
            low: self.low + by,
            high: self.high + by,
            ..self
        }
    }

    /// The greatest of these, by its upper end.
    pub(super) fn farthest(each: impl Iterator<Item = Threshold>) -> Option<Threshold> {
        each.reduce(|one, other| if other.high > one.high { other } else { one })
    }

    /// The least of these, by its lower end.
    pub(super) fn nearest(each: impl Iterator<Item = Threshold>) -> Option<Threshold> {
        each.reduce(|one, other| if other.low < one.low { other } else { one })
    }
}

/// The centre distance from which `assembly` assembles. Its least `j_wt` over `matings` pitches from `first` on is
/// `least`, mm, or `None` if a pose is jammed. The search goes from its own centre distance to tips that pass each
/// other, within the budget `effort`. At other distances its least is found to within `width`, mm.
pub(super) fn assembles_from(
    assembly: &GearPair,
    over: (Mating, u64),
    least: Option<f64>,
    width: f64,
    effort: &Effort,
) -> Result<Option<Threshold>, Error> {
    let gear = |member| assembly.gear(member);
    let reach = gear(Member::Wheel).reach() + gear(Member::Pinion).reach();
    let per_mm = |at: f64| {
        let at = assembly.at(at).ok();
        at.map_or(f64::NAN, |at| 2.0 * at.operating_pressure_angle().tan())
    };
    let kernel = ExactKernel::new(assembly);
    let mut tight: Vec<Mating> = Vec::new();
    let value = |at: f64| -> Result<Option<(f64, Option<Extreme>)>, Error> {
        let pair = assembly.at(at)?;
        let kernel = kernel.at(&pair);
        if let Some(there) = interference(&kernel, &pair, &tight)? {
            return Ok(Some((there, None)));
        }
        let there = cycle_extremes_within(&kernel, &pair, over, width, effort, &[End::Least])?;
        let least = there.least;
        tight.extend(there.lost.or(least.map(|least| least.mating)));
        // Without a proof the attained value counts.
        let value = least.map(|least| {
            if least.is_proven() {
                least.low
            } else {
                least.high
            }
        });
        Ok(Some((value.unwrap_or(f64::NEG_INFINITY), least)))
    };
    let is_close = |_: f64, _: f64| false;
    let between = [assembly.center_distance(), reach];
    let below = least.unwrap_or(f64::NEG_INFINITY);
    let Some((low, high, Some(least))) =
        threshold(between, below, per_mm, value, is_close, effort)?
    else {
        return Ok(None);
    };
    Ok(Some(Threshold {
        low,
        high,
        doubt: least
            .doubt
            .or((high - low > DISTANCE_WIDTH).then_some(Doubt::Effort)),
        mating: least.mating,
    }))
}

/// The threshold at which a rising `value` becomes 0 or more. The results are a place, mm, where it is below 0, a place where it is not, and
/// the second result of `value` at the latter. The places are at most [`DISTANCE_WIDTH`] apart, or close enough by `is_close`, unless the
/// effort ran out. `None` if the value is below 0 everywhere.
///
/// `below` is the value at the lower place, or −∞. `slope` is the value's derivative at a place. `value` returns `None`
/// at a place that is not possible.
pub(super) fn threshold<T>(
    [mut low, mut high]: [f64; 2],
    mut below: f64,
    slope: impl Fn(f64) -> f64,
    mut value: impl FnMut(f64) -> Result<Option<(f64, T)>, Error>,
    is_close: impl Fn(f64, f64) -> bool,
    effort: &Effort,
) -> Result<Option<(f64, f64, T)>, Error> {
    if !(low < high) {
        return Ok(None);
    }
    // The value at the upper end; ∞ until a place is evaluated.
    let mut above = f64::INFINITY;
    let (mut found, mut last) = (None, None);
    for _ in 0..STEPS {
        if effort.is_nearly_spent() {
            break;
        }
        // Slightly further, towards the more distant end, so that both ends converge.
        let nudge = 0.4 * DISTANCE_WIDTH.copysign(below + above);
        let at = match (below.is_finite(), above.is_finite()) {
            (true, true) => low - below * (high - low) / (above - below) + nudge,
            (true, false) => low - below / slope(low) + nudge.abs(),
            (false, true) => high - above / slope(high) - nudge.abs(),
            (false, false) => f64::NAN,
        };
        let at = if at > low && at < high {
            at
        } else {
            0.5 * (low + high)
        };
        let (value, looked) = match value(at)? {
            Some((value, looked)) => (value, Some(looked)),
            None => (f64::INFINITY, None),
        };
        // An end that stays twice gets half its weight (the Illinois rule).
        let free = value >= 0.0;
        let stays = if last.replace(free) == Some(free) {
            0.5
        } else {
            1.0
        };
        if free {
            (high, above, found) = (at, value, looked);
            below *= stays;
        } else {
            (low, below) = (at, value);
            above *= stays;
        }
        if high - low <= DISTANCE_WIDTH || found.is_some() && is_close(low, high) {
            break;
        }
    }
    Ok(found.map(|found| (low, high, found)))
}

/// First step towards a greater distance, mm: what many drawn pairs are short of (tuned).
const FIRST_STEP: f64 = 0.01;

/// Width of the bracket of a pair with a drawn gear, mm: a tenth of what is shown.
const DISTANCE_WIDTH_DRAWN: f64 = 1e-5;

/// A wider bracket, mm, is not proven to the last digit shown.
const SHOWN: f64 = 1e-4;

/// Rounds at most of the search for a distance: each rules out a pose that interfered.
const MOST_TIGHTEST: u32 = 40;

/// Times a distance is raised by what the bracket of the least leaves open: the least grows by half of it or more.
const MOST_RAISED: u32 = 6;

/// The distance from which a pair with a drawn gear assembles. `found` are the extremes at its own distance. `None` if it
/// interferes until tips pass each other, is out of mesh, or has no extremes there.
///
/// The tightest pose gives a distance. If another pose interferes there, it is the tightest pose of the next round.
pub(super) fn assembles_from_of_outlines(
    kernel: &OutlineKernel,
    pair: &OutlinePair,
    cycle: &OutlineCycle,
    found: &Extremes,
) -> Result<Option<Threshold>, Error> {
    let tightest = |found: &Extremes| match (found.status, found.least) {
        (Status::Jammed, _) => found.lost,
        (_, Some(least)) if least.found < 0.0 => Some(least.mating),
        _ => None,
    };
    let farthest = Member::BOTH.map(|member| pair.gear(member).reach());
    let farthest: f64 = farthest.iter().sum();
    let mut floor = pair.center_distance();
    let Some(mut tight) = tightest(found) else {
        return Ok(None);
    };
    for _ in 0..MOST_TIGHTEST {
        let interferes_at = |distance: f64| -> Result<bool, Error> {
            let there = pair.at(distance)?;
            let found = kernel.lost_motion_at(&there, &tight);
            let status = found.map_or(Status::Unproven, |found| found.status());
            Ok(matches!(status, Status::Interference | Status::Jammed))
        };
        // In growing steps, so that it is the nearest such place and not one where tips pass each other.
        let (mut low, mut step) = (floor, FIRST_STEP);
        while low + step <= farthest && interferes_at(low + step)? {
            (low, step) = (low + step, 2.0 * step);
        }
        if low + step > farthest {
            return Ok(None);
        }
        let [low, mut high] = try_bisect(low, low + step, DISTANCE_WIDTH_DRAWN, interferes_at)?;
        // A greater distance makes up for the width of the bracket.
        let (mut there, mut raised) = (pair.at(high)?, 0);
        let least = loop {
            let width = 0.5 * DISTANCE_WIDTH_DRAWN;
            let found = cycle.extremes(kernel, &there, &[End::Least], width);
            if found.status == Status::NoContact {
                return Ok(None);
            }
            if let Some(next) = tightest(&found) {
                tight = next;
                break None;
            }
            let Some(least) = found.least else {
                return Ok(None);
            };
            if least.low >= 0.0 || !least.low.is_finite() || raised == MOST_RAISED {
                break Some(least);
            }
            raised += 1;
            high = there.center_distance() - 2.0 * least.low;
            there = pair.at(high)?;
        };
        floor = there.center_distance();
        if let Some(least) = least {
            let is_free = least.low >= 0.0 && floor - low <= SHOWN;
            return Ok(Some(Threshold {
                low,
                high: floor,
                doubt: (!is_free).then_some(least.doubt.unwrap_or(Doubt::Effort)),
                mating: tight,
            }));
        }
    }
    Ok(None)
}

/// The least `j_wt` of `matings`, mm, if it is negative: −∞ if one is jammed; `None` if none interferes.
fn interference(
    kernel: &ExactKernel,
    pair: &GearPair,
    matings: &[Mating],
) -> Result<Option<f64>, Error> {
    let per_radian = pair.operating_pitch_radius(pair.free());
    let mut least = 0.0f64;
    for mating in matings {
        let Some(found) = kernel.lost_motion_at(pair, *mating)? else {
            continue;
        };
        if found.status() == Status::Jammed {
            return Ok(Some(f64::NEG_INFINITY));
        }
        if let Some((angle, error)) = found.angle().zip(found.error()) {
            least = least.min((angle + error) * per_radian);
        }
    }
    Ok((least < 0.0).then_some(least))
}

/// Width of the bracket, mm. A tip leaves its mate at some speed, so a narrower one has no meaning.
const MESH_WIDTH: f64 = 1e-5;

/// Limit of searches of the cycle (one or two are usual).
const MESH_STEPS: usize = 40;

/// Poses of a pitch that are examined beside a pose out of mesh, and their limit in all (tuned).
const POSES_A_PITCH: f64 = 8.0;
const MOST_POSES_BESIDE: u64 = 8192;

/// Least step, pitches, to a pose beside one out of mesh (tuned).
const LEAST_STEP: f64 = 1e-4;

/// The lost motion at a distance, mm, where the teeth of a mating meet.
type PoseAt<'a> = &'a dyn Fn(f64, &Mating) -> Result<Option<LostMotion>, Error>;

/// A pair at any centre distance, mm.
pub(super) struct AtDistance<'a> {
    pub pose: PoseAt<'a>,
    /// The greatest over the whole cycle at a distance.
    pub search: &'a dyn Fn(f64) -> Result<Extremes, Error>,
    /// A mating turned on by a number of pitches.
    pub onward: &'a dyn Fn(&Mating, f64) -> Mating,
    /// Pitches of the cycle.
    pub pitches: u64,
    /// Called before each pose. A break ends the search.
    pub tick: &'a Tick<'a>,
}

impl AtDistance<'_> {
    fn is_in_mesh(&self, at: f64, mating: &Mating) -> Result<bool, Error> {
        Error::if_stopped((self.tick)(0))?;
        let found = (self.pose)(at, mating)?;
        Ok(found.is_none_or(|found| found.status() != Status::NoContact))
    }

    /// The first of `lost` turned by each of `pitches` that is out of mesh at the distance `at`.
    fn beside(&self, at: f64, lost: &Mating, pitches: [f64; 2]) -> Result<Option<Mating>, Error> {
        for pitches in pitches {
            let mating = (self.onward)(lost, pitches);
            if !self.is_in_mesh(at, &mating)? {
                return Ok(Some(mating));
            }
        }
        Ok(None)
    }
}

/// The distance up to which a pair is in mesh: above the distance `nearest`, mm, below its own one, where a pose is out of mesh according to
/// `found`. `None` if it is in mesh at its own distance, or out of mesh at `nearest` too. Searches end with the budget `effort`.
///
/// A pose out of mesh gives the distance up to which it is in mesh. Another pose of the cycle that is out of mesh there gives the next
/// distance. Where no examined pose is, the whole cycle is searched.
pub(super) fn meshes_to(
    [nearest, own]: [f64; 2],
    found: &Extremes,
    pair: &AtDistance,
    effort: &Effort,
) -> Result<Option<Threshold>, Error> {
    let Some(mut lost) = found.lost.filter(|_| found.status == Status::NoContact) else {
        return Ok(None);
    };
    let mut high = own;
    // Places of a pitch to examine: all of them once, then the place of the pose that was found.
    let mut places = POSES_A_PITCH;
    for _ in 0..MESH_STEPS {
        let mut step = 0.5 / POSES_A_PITCH;
        let mut at = high;
        let mut next = Some(lost);
        while at > nearest && step > LEAST_STEP {
            if let Some(first) = next.take() {
                let poses = (places as u64 * pair.pitches).min(MOST_POSES_BESIDE);
                for pose in 0..poses {
                    let other = (pair.onward)(&first, pose as f64 / places);
                    // A pose that is in mesh is so at lesser distances, too.
                    if at > nearest && !pair.is_in_mesh(at, &other)? {
                        lost = other;
                        let in_mesh = |at| pair.is_in_mesh(at, &lost);
                        [at, high] = try_bisect(nearest, at, MESH_WIDTH, in_mesh)?;
                    }
                }
                places = 1.0;
            } else {
                next = pair.beside(at, &lost, [-step, step])?;
                step *= 0.5;
            }
        }
        let there = (pair.search)(at)?;
        let doubt = match (there.greatest, there.lost) {
            (Some(greatest), _) => greatest.doubt,
            (None, _) if at <= nearest => return Ok(None),
            (None, Some(next)) if !effort.is_nearly_spent() => {
                (lost, high) = (next, at);
                continue;
            }
            (None, _) => Some(Doubt::Effort),
        };
        return Ok(Some(Threshold {
            low: at,
            high,
            mating: lost,
            doubt,
        }));
    }
    Ok(None)
}

//! The centre distance below which something other than involutes touches.

use crate::analytic::limits;
use crate::contact::{PairAtDistance, PoseClass, reach};
use crate::error::{Error, Tick};
use crate::pair::{GearPair, Mating, Member};
use crate::parallel;

/// Width of the bracket, mm: a nanometre, far below any adjustment of a centre distance.
const WIDTH: f64 = 1e-6;
/// Range, in pitches, in which the rotation is refined about the last pose that touches: wider than the steps of a default sweep.
const BESIDE: f64 = 1.0 / 8.0;
/// Refinements of the rotation, each eight times finer: the last steps are 1/32768 of a pitch.
const REFINEMENTS: usize = 4;

/// The centre distance at which non-involute contact begins.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Onset {
    /// Centre distance, mm: below it some pose touches a fillet, a root or the edge of an undercut flank.
    pub distance: f64,
    /// A distance at which such a pose was found, and one without any; 1e-6 mm apart.
    pub bracket: [f64; 2],
    /// The pose that touches first as the gears approach.
    pub mating: Mating,
    /// Class of its contact.
    pub class: PoseClass,
}

/// Centre distance, mm, below which the mate's tip reaches inside `member`'s form circle on the line of action.
///
/// [`limits::form_margin`] is zero if `(r_b1 + r_b2) tan α_wt = √(r_a² − r_b²) + r_b ξ_Ff`. The centre distance is the
/// hypotenuse of that and `r_b1 + r_b2`.
pub fn form_onset(assembly: &GearPair, member: Member) -> f64 {
    let gear = assembly.gear(member).gear();
    let mate = assembly.gear(member.mate()).gear();
    let tangent = limits::tip_tangent(mate) + gear.base_radius() * gear.form_roll();
    tangent.hypot(assembly.least_distance())
}

/// The greater [`form_onset`] of both gears: that of the gear at risk first.
pub(super) fn first_form_onset(assembly: &GearPair) -> f64 {
    let [wheel, pinion] = Member::BOTH.map(|member| form_onset(assembly, member));
    wheel.max(pinion)
}

/// Finds the onset over `matings`, then turns the gears from the pose that touches first.
///
/// A pose that touches below an involute is assumed to do so at every lesser distance. So a pose that does not at the onset of the earlier
/// poses needs no search of its own. `None` if no pose has such contact even at the least distance that the base circles allow.
///
/// # Errors
/// A lost contact; [`Error::Interrupted`].
pub fn non_involute_onset(
    assembly: &GearPair,
    matings: &[Mating],
    tick: &Tick,
) -> Result<Option<Onset>, Error> {
    let [nearest, farthest] = reach(assembly);
    let guess = first_form_onset(assembly);
    let mut from = guess.clamp(nearest, farthest);
    let module = assembly.gear(Member::Wheel).gear().basic_data().module();
    let search = &OnsetSearch {
        pair: PairAtDistance::new(assembly),
        tick,
    };

    // An odd number, so that each group has poses from all over a pitch.
    let groups = matings.len().isqrt() | 1;
    let mut found = None;
    for group in 0..groups {
        let group = matings.iter().skip(group).step_by(groups);
        let group: Vec<Mating> = group.copied().collect();
        let mut low = from;
        let mut active = touching(search, low, &group)?;
        let mut stride = 0.02 * module;
        while active.is_empty() && found.is_none() && low > nearest {
            low = (low - stride).max(nearest);
            stride *= 2.0;
            active = touching(search, low, &group)?;
        }
        if active.is_empty() {
            // Without an onset, `low` is the least distance.
            from = low;
            continue;
        }
        from = narrow_to_onset(search, &mut low, from, &mut active)?;
        found = Some(low);
    }
    let Some(mut low) = found else {
        return Ok(None);
    };
    let mut high = from;
    let mut active = Vec::new();
    for some in matings.chunks(groups) {
        active = touching(search, low, some)?;
        if !active.is_empty() {
            break;
        }
    }
    let mut span = BESIDE;
    for _ in 0..REFINEMENTS {
        let first = active[0];
        let steps = (-8..=8).filter(|step| *step != 0);
        let beside: Vec<Mating> = steps
            .map(|step| first.onward(assembly, f64::from(step) * span / 8.0))
            .collect();
        let mut sooner = touching(search, high, &beside)?;
        if !sooner.is_empty() {
            low = high;
            high = narrow_to_onset(search, &mut low, high, &mut sooner)?;
            active = sooner;
        }
        span /= 8.0;
    }
    let mating = active[0];
    Ok(Some(Onset {
        distance: 0.5 * (low + high),
        bracket: [low, high],
        mating,
        class: search.pair.at(low)?.class(&mating)?,
    }))
}

/// The pair at any distance, and the tick of the search.
struct OnsetSearch<'a> {
    pair: PairAtDistance,
    tick: &'a Tick<'a>,
}

/// Raises `low`, where all of `active` (not empty) touch, until none does at the returned distance, [`WIDTH`] above it.
fn narrow_to_onset(
    search: &OnsetSearch,
    low: &mut f64,
    known: f64,
    active: &mut Vec<Mating>,
) -> Result<f64, Error> {
    let [_, farthest] = reach(search.pair.assembly());
    let mut stride = f64::max(2.0 * (known - *low), 16.0 * WIDTH);
    let mut high = loop {
        let high = *low + stride;
        // Tips that do not reach each other touch nothing.
        if high >= farthest {
            break farthest;
        }
        let still = touching(search, high, active)?;
        if still.is_empty() {
            break high;
        }
        (*low, *active) = (high, still);
        stride *= 2.0;
    };
    while high - *low > WIDTH {
        let middle = 0.5 * (*low + high);
        let still = touching(search, middle, active)?;
        if still.is_empty() {
            high = middle;
        } else {
            (*low, *active) = (middle, still);
        }
    }
    Ok(high)
}

/// The poses of `matings` with contact below an involute at `distance`, in order.
fn touching(search: &OnsetSearch, distance: f64, matings: &[Mating]) -> Result<Vec<Mating>, Error> {
    Error::if_stopped((search.tick)(0))?;
    let there = search.pair.at(distance)?;
    let classes = parallel::map(matings, |mating| there.class(mating));
    let mut touching = Vec::new();
    for (class, mating) in classes.into_iter().zip(matings) {
        if class?.is_non_involute() {
            touching.push(*mating);
        }
    }
    Ok(touching)
}

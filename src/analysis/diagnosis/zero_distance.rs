//! The centre distance at which the worst pose of a pair as built has no play.

use crate::analytic::limits;
use crate::contact::{BRACKET_WIDTH, PairAtDistance, root_of_play};
use crate::error::{Error, Tick};
use crate::numeric::{GOLDEN, rank, try_bisect};
use crate::pair::{GearPair, Mating};

/// Accuracy of a rotation, pitches: play changes by less than a module per pitch.
const PITCHES: f64 = 1e-9;
/// Steps in which the rotation descends, pitches (tuned: as a default sweep).
const STRIDE: f64 = 1.0 / 16.0;
/// Local minima of a sweep that are always followed. Others are followed while they may be as deep as the deepest.
const FOLLOWED: usize = 8;
/// Limit of alternations of distance and rotation. Each reduces the error by the play's relative curvature, about 1e-3;
/// for jammed gears by about a half.
const STEPS_BESIDE: usize = 100;
/// Maximum restarts from a lower pose.
const ROUNDS: usize = 16;
/// Play that counts as zero, mm: the remainder of the bracket of a distance.
const NO_PLAY: f64 = 0.1 * BRACKET_WIDTH;

/// `a_0` of a pair as built, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ZeroDistance {
    /// `a_0` of the worst pose, the rotation continuous.
    pub distance: f64,
    /// A distance at which the play is negative, and one at which it is not: 1e-10 mm apart, about `distance`.
    pub bracket: [f64; 2],
    /// The worst pose.
    pub mating: Mating,
    /// `a_0` of the worst of the given poses.
    pub of_poses: f64,
    /// That pose.
    pub pose: Mating,
    /// Wheel and pinion tooth in right-flank and in left-flank contact there.
    pub teeth: [(u32, u32); 2],
}

/// Finds `a_0` of the gears of `assembly`. The search first compares `matings`. It then turns the gears from the one with the least play until
/// the play rises, and repeats this at the distance without play. It misses a minimum between two matings that neither of them shows.
///
/// Play rises with the centre distance, so the root is bracketed. `None` without matings, or without a root between
/// touching base circles and tips that pass each other.
///
/// # Errors
/// A lost contact; [`Error::Interrupted`].
pub fn zero_distance(
    assembly: &GearPair,
    matings: &[Mating],
    tick: &Tick,
) -> Result<Option<ZeroDistance>, Error> {
    let as_assembled = PairAtDistance::new(assembly);
    let least_of = |matings: &[Mating], distance| -> Result<f64, Error> {
        Error::if_stopped(tick(0))?;
        let plays = as_assembled.at(distance)?.plays(matings)?;
        Ok(plays.into_iter().fold(f64::INFINITY, f64::min))
    };
    let guess = limits::zero_backlash_distance(assembly);
    let guess = guess.unwrap_or(assembly.center_distance());
    let Some(bracket) = root_of_play(assembly, guess, |distance| least_of(matings, distance))?
    else {
        return Ok(None);
    };
    let plays = as_assembled.at(bracket[0])?.plays(matings)?;
    // The first of equal plays is named, on every platform.
    let least = plays.iter().copied().fold(f64::INFINITY, f64::min);
    let Some(first) = plays.iter().position(|play| *play <= least + NO_PLAY) else {
        return Ok(None);
    };
    let (mut last, mut worst) = (bracket, matings[first]);
    // Continues with a pose whose root is at a greater distance. Returns whether it is greater by more than a bracket's width.
    let follow = |last: &mut [f64; 2], worst: &mut Mating, one: Mating| -> Result<_, Error> {
        let next = root_of_play(assembly, last[0], |distance| least_of(&[one], distance))?;
        Ok(next.map(|next| {
            let farther = next[0] - last[0];
            if farther > 0.0 {
                (*last, *worst) = (next, one);
            }
            farther > BRACKET_WIDTH
        }))
    };
    for _ in 0..ROUNDS {
        for _ in 0..STEPS_BESIDE {
            let pair = as_assembled.at(last[0])?;
            let (_, one) = lowest(&pair, worst, pair.play(&worst)?)?;
            match follow(&mut last, &mut worst, one)? {
                None => return Ok(None),
                Some(false) => break,
                Some(true) => (),
            }
        }
        let (play, one) = lowest_of_all(&as_assembled.at(last[1])?, matings, tick)?;
        if play >= -NO_PLAY {
            break;
        }
        match follow(&mut last, &mut worst, one)? {
            None => return Ok(None),
            Some(false) => break,
            Some(true) => (),
        }
    }
    let at = as_assembled.at(last[1])?.lost_motion(&worst)?;
    let teeth = [at.right, at.left].map(|contact| {
        contact.map_or((0, 0), |contact| {
            (contact.wheel.tooth, contact.pinion.tooth)
        })
    });
    Ok(Some(ZeroDistance {
        distance: 0.5 * (last[0] + last[1]),
        bracket: last,
        mating: worst,
        of_poses: 0.5 * (bracket[0] + bracket[1]),
        pose: matings[first],
        teeth,
    }))
}

/// Indices of values not above their neighbours in the list, the lowest first.
fn local_minima(values: &[f64]) -> Vec<usize> {
    let count = values.len();
    let mut minima: Vec<usize> = (0..count)
        .filter(|&i| {
            let (before, after) = ((i + count - 1) % count, (i + 1) % count);
            values[i] <= values[before] && values[i] <= values[after]
        })
        .collect();
    minima.sort_by_cached_key(|i| rank(values[*i]));
    minima
}

/// The least play, descending from the lowest of `matings`, and its mating.
fn lowest_of_all(
    pair: &PairAtDistance,
    matings: &[Mating],
    tick: &Tick,
) -> Result<(f64, Mating), Error> {
    let plays = pair.plays(matings)?;
    let mut found = (f64::INFINITY, matings[0]);
    // Greatest change of play from one to the next: no minimum between them is deeper.
    let next = plays.iter().cycle().skip(1);
    let changes = plays.iter().zip(next).map(|(one, next)| (next - one).abs());
    let steepest = changes
        .filter(|change| change.is_finite())
        .fold(0.0, f64::max);
    for (count, index) in local_minima(&plays).into_iter().enumerate() {
        let play = plays[index];
        if count >= FOLLOWED && play - steepest > found.0 - NO_PLAY {
            break;
        }
        Error::if_stopped(tick(0))?;
        let here = lowest(pair, matings[index], play)?;
        if here.0 < found.0 {
            found = here;
        }
    }
    Ok(found)
}

/// The middle of the range of rotations about `place`, pitches, at which the gears jam. It is the worst pose, because
/// the range shrinks towards the worst pose from both ends.
fn middle_of_jam(
    play: impl Fn(f64) -> Result<f64, Error>,
    place: f64,
    period: f64,
) -> Result<f64, Error> {
    let end = |sense: f64| -> Result<f64, Error> {
        let (mut inside, mut outside) = (place, place + sense * STRIDE);
        while (outside - place).abs() < period && play(outside)? == f64::NEG_INFINITY {
            inside = outside;
            outside += sense * STRIDE;
        }
        let jams = |place| Ok::<_, Error>(play(place)? == f64::NEG_INFINITY);
        Ok(try_bisect(inside, outside, PITCHES, jams)?[0])
    };
    Ok(0.5 * (end(1.0)? + end(-1.0)?))
}

/// The least play, descending from `start` with the play `play`, and its mating.
fn lowest(pair: &PairAtDistance, start: Mating, play: f64) -> Result<(f64, Mating), Error> {
    let assembly = pair.assembly();
    let at = |pitches: f64| pair.play(&start.onward(assembly, pitches));
    let period = f64::from(assembly.teeth(assembly.locked()));
    let (mut best, mut place) = (play, 0.0);
    for sense in [1.0, -1.0] {
        let mut next = place + sense * STRIDE;
        while next.abs() <= period {
            let value = at(next)?;
            // Less by more than rounding: the play of perfect gears is constant.
            if !(value < best - 1e-12) {
                break;
            }
            (best, place) = (value, next);
            next += sense * STRIDE;
        }
    }
    if best == f64::NEG_INFINITY {
        let middle = middle_of_jam(at, place, period)?;
        return Ok((best, start.onward(assembly, middle)));
    }
    // Golden section between the neighbours of the lowest step.
    let (mut low, mut high) = (place - STRIDE, place + STRIDE);
    let mut inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let mut values = [at(inner[0])?, at(inner[1])?];
    while high - low > PITCHES {
        if values[0] <= values[1] {
            high = inner[1];
            inner = [high - GOLDEN * (high - low), inner[0]];
            values = [at(inner[0])?, values[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + GOLDEN * (high - low)];
            values = [values[1], at(inner[1])?];
        }
        for (value, pitches) in values.into_iter().zip(inner) {
            if value < best {
                (best, place) = (value, pitches);
            }
        }
    }
    Ok((best, start.onward(assembly, place)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pair::Member;
    use std::cell::Cell;

    #[test]
    fn minima_are_no_higher_than_both_neighbours_round_the_list() {
        assert_eq!(local_minima(&[3.0, 1.0, 2.0, 4.0, 5.0]), [1]);
        assert_eq!(local_minima(&[1.0, 2.0, 3.0, 0.0]), [3]);
        assert_eq!(local_minima(&[2.0, 4.0, 1.0, 4.0, 3.0, 5.0]), [2, 0, 4]);
    }

    /// Straight play, play with a bend at or beside its root, and play that jams below it, from near and far. The bracket contains the sign
    /// change and has the requested width after few evaluations: two secants for straight play, at most two per halving for any.
    #[test]
    fn a_sign_change_is_bracketed_in_few_evaluations() {
        let pair = GearPair::plain([20; 2], [0.0; 2], 40.5, Member::Wheel);
        let cases = [
            ("straight", 0.0, f64::INFINITY, 8),
            ("bent at the root", 0.4, f64::INFINITY, 80),
            ("jams", 0.0, 0.3, 20),
        ];
        for (root_at, guess) in [39.6, 40.0, 40.7]
            .into_iter()
            .flat_map(|root_at| [39.3, 39.9, 40.0, 40.2, 40.5].map(|guess| (root_at, guess)))
        {
            for (name, bend, jam, most) in cases {
                let looks = Cell::new(0);
                let play = |distance: f64| {
                    looks.set(looks.get() + 1);
                    assert!(looks.get() <= most, "{name} at {root_at} from {guess}");
                    let over = distance - root_at;
                    Ok(if over < -jam {
                        f64::NEG_INFINITY
                    } else {
                        0.7 * over + bend * over.max(0.0)
                    })
                };
                let [low, high] = root_of_play(&pair, guess, play).unwrap().unwrap();
                let case = format!("{name} at {root_at} from {guess}: {low} {high}");
                assert!(low < root_at && root_at <= high, "{case}");
                assert!(high - low <= BRACKET_WIDTH, "{case}");
            }
        }
        for play in [1.0, -1.0] {
            assert_eq!(root_of_play(&pair, 40.0, |_| Ok(play)).unwrap(), None);
        }
    }
}

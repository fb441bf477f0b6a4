//! The search for the contact of one side. It takes the tightest pair of chords, turns it in, cuts it, and repeats.
//!
//! Every pair of chords has an opening down to which its curves are proven clear of each other. The search takes the pair with the greatest
//! opening and turns it in by safe steps until the chords are within their errors of each other. Then it cuts the chord with the larger
//! error, and both new pairs start from that opening. A pair of the finest chords is turned in until the chords touch. The first of them is
//! the contact: every other pair is proven clear down to it.
//!
//! No pair of teeth and no curve is a special case. Nothing is turned in beyond the tightest contact.
//!
//! # The bracket
//!
//! The outer end of the bracket is the opening at which the first of its finest pairs is within its errors: every greater opening is clear.
//! At the inner end the curves certainly touch or overlap. Involutes and lands bulge out of their chords, so they touch before the chords
//! do. A fillet is hollow: its chords lie in front of it by up to `δ`. If two chords are `d` apart, the gap of their curves is at most `h =
//! d + δ` (`d + 2 δ` for two fillets) plus rounding. Turning the free gear in by `s` changes the gap to
//!
//! ```text
//! g(s) ≤ h − X s + M s²/2,   M = ρ + ρ² κ
//! ```
//!
//! `X` is the lever of the contact normal about the free axis and `ρ` the distance of the contact from it. A point moves along the normal
//! by `X s − ρ_n s²/2`, where `ρ_n ≤ ρ` is its arm along the normal. It moves along the other curve by up to `ρ s`, where that curve is up
//! to `κ` times half the square of the way off its tangent. `κ` is `κ_1 κ_2/(κ_1 + κ_2)` of the two curvatures, not above the lesser; at an
//! edge it is the curvature of the other curve. Thus `g` is at most 0 at `s = 2 h/(X + √(X² − 2 M h))`. The first order `s = h/X` alone is
//! too short where tips graze: there `X` is small and vanishes after `X/M`. If the root is not real, nothing proves a contact, and the
//! inner end is half a turn away.

use super::chord::Chord;
use super::facing_pair::FacingPair;
use super::place::Place;
use crate::contact::Effort;
use crate::contact::parry::closest;
use crate::contact::ranked::Ranked;
use crate::error::Error;
use crate::numeric::rank;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

/// Polygons count as touching at this part of the chordal error. It adds a thousandth to the error.
const STOP: f64 = 1e-3;

/// Steps of a pair before it is cut. A step is safe for the largest lever of the whole chord, and a shorter chord
/// wastes less of it (tuned: 2 to 8 take equally long).
const STEPS: usize = 4;

/// Steps of a pair of the finest chords. A few suffice; where a lever nearly vanishes a dozen are needed.
const FINEST_STEPS: usize = 64;

/// Limit of chord pairs examined on one side. In 27 000 sides of random pairs (in mesh, grazing, on roots) the most was
/// 630 and the mean 130, at about 0.3 µs each. The limit leaves a factor of 80, and costs at most 30 ms for a pose.
const EFFORT: usize = 50_000;

/// Uncut chords that are paired in the time of examining one pair (tuned: about 0.15 µs each).
const PAIRED: u64 = 2;

/// The contact of one pair of half teeth.
pub(super) struct FoundTouch {
    /// Index of the problem.
    pub problem: usize,
    /// The curves are clear at every opening down to this one.
    pub clear: f64,
    /// The polygons touch at this opening, to the accuracy of the search.
    pub touching: f64,
    /// The curves touch or overlap at this opening.
    pub closed: f64,
    pub place: Place,
}

/// Two chords of a facing pair in the queue.
struct QueuedPair {
    problem: u32,
    /// Both chords are fine enough and within their errors of each other at `opening`.
    finest: bool,
    /// The curves are clear of each other down to this opening.
    opening: f64,
    /// Below this opening the chords share no direction.
    end: f64,
    chords: [Chord; 2],
}

/// The pairs still to be examined, the greatest opening first.
type Queue = BinaryHeap<Ranked<u64, QueuedPair>>;

fn ranked(pair: QueuedPair) -> Ranked<u64, QueuedPair> {
    Ranked {
        key: rank(pair.opening),
        item: pair,
    }
}

/// The outcome of turning a pair in.
enum Turned {
    /// Within the requested distance, at this opening.
    Near(f64),
    /// Not yet near; clear down to this opening.
    Waiting(f64),
    /// The chords have passed each other without contact.
    Clear,
}

/// The contacts of one side that are not proven looser than another, at most one for each pair of teeth, on chords
/// within `finest` mm. The work is charged to `effort`, the budget of the pose.
///
/// # Errors
/// [`Error::ContactLost`] when the effort is spent.
pub(super) fn search(
    problems: &[FacingPair],
    finest: f64,
    effort: &Effort,
) -> Result<Vec<FoundTouch>, Error> {
    let mut waiting = Queue::new();
    for (index, problem) in problems.iter().enumerate() {
        start(index, problem, &mut waiting);
    }
    effort.spend(waiting.len() as u64 / PAIRED);
    let mut clear: Vec<Option<f64>> = vec![None; problems.len()];
    let mut found: Vec<FoundTouch> = Vec::new();
    // A pair below this opening is no tighter than a contact already found.
    let mut closed = f64::NEG_INFINITY;
    let mut examined = 0;
    while let Some(Ranked { item: pair, .. }) = waiting.pop() {
        if pair.opening < closed {
            break;
        }
        let index = pair.problem as usize;
        let problem = &problems[index];
        examined += 1;
        effort.spend(1);
        if examined > EFFORT || effort.is_spent() {
            return Err(problem.lost(SPENT));
        }
        if found.iter().any(|found| found.problem == index) {
            continue;
        }
        if pair.finest {
            // The first finest pair that is the tightest of all: every other pair is clear down to here.
            clear[index].get_or_insert(pair.opening);
        }
        match turn_in(problem, &pair, finest) {
            Turned::Clear => {}
            Turned::Waiting(opening) if pair.finest => {
                waiting.push(ranked(QueuedPair { opening, ..pair }));
            }
            Turned::Near(opening) if pair.finest => {
                let clear = clear[index].unwrap_or(opening);
                let bracket = bracket(index, problem, &pair.chords, clear, opening, finest);
                closed = closed.max(bracket.closed);
                found.push(bracket);
            }
            Turned::Near(opening) if pair.chords.iter().all(|chord| chord.error <= finest) => {
                waiting.push(ranked(QueuedPair {
                    opening,
                    finest: true,
                    ..pair
                }));
            }
            Turned::Near(opening) | Turned::Waiting(opening) => {
                cut(problem, &pair, opening, &mut waiting);
            }
        }
    }
    Ok(found)
}

const SPENT: &str = "the effort allowed for one pose was spent: too many stretches of the outlines are too near each \
                     other to be told apart";

/// Queues all pairs of uncut chords of a facing pair that can meet, from the opening where they share no direction.
fn start(index: usize, problem: &FacingPair, waiting: &mut Queue) {
    let (locked, free) = (&problem.locked, &problem.free);
    for free_chord in free.shared().iter().chain(free.own()) {
        let radii = problem.radii(free_chord);
        for locked_chord in locked.shared().iter().chain(locked.own()) {
            if !problem.passes(locked_chord, radii) {
                let (opening, end) = problem.shared_directions(locked_chord, free_chord);
                waiting.push(ranked(QueuedPair {
                    problem: index as u32,
                    finest: false,
                    opening,
                    end,
                    chords: [*locked_chord, *free_chord],
                }));
            }
        }
    }
}

/// Cuts the chord with the larger error.
fn cut(problem: &FacingPair, pair: &QueuedPair, opening: f64, waiting: &mut Queue) {
    let [locked_chord, free_chord] = pair.chords;
    let mut made = None;
    let cut_locked = locked_chord.error >= free_chord.error;
    let halves = if cut_locked {
        problem.locked.halves(&locked_chord, &mut made)
    } else {
        problem.free.halves(&free_chord, &mut made)
    };
    for &half in halves {
        let chords = if cut_locked {
            [half, free_chord]
        } else {
            [locked_chord, half]
        };
        if !problem.passes(&chords[0], problem.radii(&chords[1])) {
            waiting.push(ranked(QueuedPair {
                opening,
                chords,
                ..*pair
            }));
        }
    }
}

/// Turns the chords of `pair` in by safe steps.
fn turn_in(problem: &FacingPair, pair: &QueuedPair, finest: f64) -> Turned {
    let [locked_chord, free_chord] = &pair.chords;
    // A distance below its own rounding carries no information.
    let rounding = problem.rounding() / 8.0;
    // Curves are clear if their chords are further apart than both errors; the finest chords are turned until they touch.
    let (margin, near, steps) = if pair.finest {
        (0.0, (STOP * finest).max(rounding), FINEST_STEPS)
    } else {
        let margin = locked_chord.error + free_chord.error;
        // Steps of d − margin never arrive: 5 % above the margin is near enough.
        (margin, 1.05 * margin + rounding, STEPS)
    };
    let mut opening = pair.opening;
    for _ in 0..steps {
        if opening < pair.end {
            return Turned::Clear;
        }
        let free_chord = free_chord.seen_in(&problem.at(opening));
        let closest = closest(&locked_chord.ends, &free_chord.ends);
        if closest.distance <= near {
            return Turned::Near(opening);
        }
        opening -= problem.safe_turn(locked_chord, &free_chord, &closest, margin);
    }
    Turned::Waiting(opening)
}

/// The bracket of a contact whose finest chords touch at the opening `touching`.
fn bracket(
    index: usize,
    problem: &FacingPair,
    chords: &[Chord; 2],
    clear: f64,
    touching: f64,
    finest: f64,
) -> FoundTouch {
    let free_chord = chords[1].seen_in(&problem.at(touching));
    let closest = closest(&chords[0].ends, &free_chord.ends);
    let place = Place::new(problem, touching, chords, &closest);
    let arm = place.point - problem.assembly.axis(problem.assembly.free());
    let (lever, rho) = (arm.perp(&place.normal).abs(), arm.norm());
    let bulge = rho + rho * rho * place.curvature;
    // A bracket wider than half a turn has no meaning.
    let turned = |depth: f64| {
        let square = lever * lever - 2.0 * bulge * depth;
        if square >= 0.0 && lever > 0.0 {
            (2.0 * depth / (lever + square.sqrt())).min(PI)
        } else {
            PI
        }
    };
    let rounding = problem.rounding();
    let depth = place.hollow as f64 * finest + closest.distance + rounding;
    FoundTouch {
        problem: index,
        // Rounding can hide the same distance on the way in.
        clear: clear + turned(rounding),
        touching,
        closed: touching - turned(depth),
        place,
    }
}

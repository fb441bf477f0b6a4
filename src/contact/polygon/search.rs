//! The search of one side's contact: the tightest pair of chords is turned in, cut, and turned in again.
//!
//! Every pair of chords waits at an opening down to which it is proven clear of each other, curves and all. The pair
//! that waits at the greatest opening is taken: it is turned in by safe steps until the chords are within
//! their errors of each other; then the one that may be farther off its curve is cut in two, and both new pairs
//! wait from there. A pair of chords as fine as can be is turned in on until the chords touch. What is taken first there is
//! the contact: everything else is proven clear down to it.
//!
//! No pair of teeth and no curve is told apart from another, and nothing is turned in farther than the tightest contact.
//!
//! # The bracket
//!
//! The contact's outer end is the opening at which the first of its finest pairs came within its errors: all above is clear.
//! At its inner end the curves surely touch or overlap. Involute and lands bulge out of their chords,
//! so where those touch the curves do already; a fillet's chords stand in front of their hollow curve by up to `δ`. So the gap
//! of two curves whose chords are the distance `d` apart is at most `h = d + δ` (`+ 2 δ` of two fillets) `+` rounding. To turn the free gear
//! in by `s` changes it to
//!
//! ```text
//! g(s) ≤ h − X s + M s²/2,   M = ρ + ρ² κ
//! ```
//!
//! `X` the lever of the contact normal about the free axis, `ρ` the contact's distance from it: a point moves along the normal
//! by `X s − ρ_n s²/2`, `ρ_n ≤ ρ` its arm along the normal, and along the other curve by up to `ρ s`, away from whose tangent it
//! bulges by `κ` (of two curves `κ_1 κ_2/(κ_1 + κ_2)`, not above the lesser, of an edge the other curve's). `g` is at most 0 at
//! `s = 2 h/(X + √(X² − 2 M h))`. Without the second order, `s = h/X` is too short where a tip grazes a tip: `X` is small there, and
//! is gone after `X/M`. Where the root is not real nothing proves that there is a contact at all: the inner end is then half a turn off.

use super::chord::Chord;
use super::flank_problem::FlankProblem;
use super::place::Place;
use crate::contact::Effort;
use crate::contact::parry::closest;
use crate::error::Error;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

/// Polygons touch at this part of the chordal error: it adds a thousandth to the error.
const STOP: f64 = 1e-3;

/// Steps of a pair before it is cut: each is safe by the largest lever of the whole chord, and a shorter one has less to waste
/// (tuned: 2 to 8 are alike).
const STEPS: usize = 4;

/// Steps of a pair of the finest chords. They roll over each other in a few; a dozen are needed where a lever nearly vanishes.
const FINEST_STEPS: usize = 64;

/// Pairs of chords looked at before a side is given up. Of 27 000 sides of random pairs (in mesh, grazing, on roots) none took
/// more than 630, 130 on average; each takes some 0.3 µs. So there is a hundredfold to spare, and a pose that is given up has taken
/// some 30 ms by both sides.
const EFFORT: usize = 50_000;

/// Longest chords that are paired in the time in which one pair is looked at (tuned: some 0.15 µs each).
const PAIRED: u64 = 2;

/// Where a pair of half teeth touches.
pub(super) struct FoundTouch {
    /// Which of the problems.
    pub problem: usize,
    /// The curves are clear of each other at every opening down to this one.
    pub clear: f64,
    /// The polygons touch, as near as the search goes.
    pub touching: f64,
    /// The curves touch or overlap.
    pub closed: f64,
    pub place: Place,
}

/// Two chords of a facing pair, waiting.
struct Pair {
    problem: u32,
    /// As fine as asked for, and within their errors of each other at `opening`.
    finest: bool,
    /// Clear of each other down to here.
    opening: f64,
    /// Below it they share no direction.
    end: f64,
    chords: [Chord; 2],
}

impl PartialEq for Pair {
    fn eq(&self, other: &Pair) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Pair {}

impl PartialOrd for Pair {
    fn partial_cmp(&self, other: &Pair) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Pair {
    fn cmp(&self, other: &Pair) -> Ordering {
        self.opening.total_cmp(&other.opening)
    }
}

/// How turning in ended.
enum Turned {
    /// Within the distance asked for, at this opening.
    Near(f64),
    /// On the way, clear down to this opening.
    Waiting(f64),
    /// Past each other.
    Clear,
}

/// The contacts of one side that no other is proven to be tighter than, one a pair of teeth, on chords within `finest` mm; what is done is taken
/// from `effort`, that of the pose.
///
/// # Errors
/// [`Error::ContactLost`] when the effort is spent.
pub(super) fn search(
    problems: &[FlankProblem],
    finest: f64,
    effort: &Effort,
) -> Result<Vec<FoundTouch>, Error> {
    let mut waiting = BinaryHeap::new();
    for (index, problem) in problems.iter().enumerate() {
        start(index, problem, &mut waiting);
    }
    effort.spend(waiting.len() as u64 / PAIRED);
    let mut clear: Vec<Option<f64>> = vec![None; problems.len()];
    let mut found: Vec<FoundTouch> = Vec::new();
    // What waits below this is no tighter than a contact already found.
    let mut closed = f64::NEG_INFINITY;
    let mut looked = 0;
    while let Some(pair) = waiting.pop() {
        if pair.opening < closed {
            break;
        }
        let index = pair.problem as usize;
        let problem = &problems[index];
        looked += 1;
        effort.spend(1);
        if looked > EFFORT || effort.is_spent() {
            return Err(problem.lost(SPENT));
        }
        if found.iter().any(|found| found.problem == index) {
            continue;
        }
        if pair.finest {
            // The first of its finest pairs to be the tightest of all: everything else is clear down to here.
            clear[index].get_or_insert(pair.opening);
        }
        match turn_in(problem, &pair, finest) {
            Turned::Clear => {}
            Turned::Waiting(opening) if pair.finest => waiting.push(Pair { opening, ..pair }),
            Turned::Near(opening) if pair.finest => {
                let clear = clear[index].unwrap_or(opening);
                let bracket = bracket(index, problem, &pair.chords, clear, opening, finest);
                closed = closed.max(bracket.closed);
                found.push(bracket);
            }
            Turned::Near(opening) if pair.chords.iter().all(|chord| chord.error <= finest) => {
                waiting.push(Pair {
                    opening,
                    finest: true,
                    ..pair
                });
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

/// All pairs of the longest chords of a facing pair that may meet, from where they share no direction.
fn start(index: usize, problem: &FlankProblem, waiting: &mut BinaryHeap<Pair>) {
    let (locked, free) = (&problem.locked, &problem.free);
    for free_chord in free.shared().iter().chain(free.own()) {
        let radii = problem.radii(free_chord);
        for locked_chord in locked.shared().iter().chain(locked.own()) {
            if !problem.passes(locked_chord, radii) {
                let (opening, end) = problem.shared_directions(locked_chord, free_chord);
                waiting.push(Pair {
                    problem: index as u32,
                    finest: false,
                    opening,
                    end,
                    chords: [*locked_chord, *free_chord],
                });
            }
        }
    }
}

/// Cuts the chord that may be farther off its curve.
fn cut(problem: &FlankProblem, pair: &Pair, opening: f64, waiting: &mut BinaryHeap<Pair>) {
    let [locked_chord, free_chord] = pair.chords;
    let mut made = None;
    let is_ours = locked_chord.error >= free_chord.error;
    let halves = if is_ours {
        problem.locked.halves(&locked_chord, &mut made)
    } else {
        problem.free.halves(&free_chord, &mut made)
    };
    for &half in halves {
        let chords = if is_ours {
            [half, free_chord]
        } else {
            [locked_chord, half]
        };
        if !problem.passes(&chords[0], problem.radii(&chords[1])) {
            waiting.push(Pair {
                opening,
                chords,
                ..*pair
            });
        }
    }
}

/// Turns the chords of `pair` in by safe steps.
fn turn_in(problem: &FlankProblem, pair: &Pair, finest: f64) -> Turned {
    let [locked_chord, free_chord] = &pair.chords;
    // Below its own rounding a distance says nothing.
    let rounding = problem.rounding() / 8.0;
    // Two curves are clear where their chords are farther apart than both errors; finest chords go on until they touch.
    let (margin, near, steps) = if pair.finest {
        (0.0, (STOP * finest).max(rounding), FINEST_STEPS)
    } else {
        let margin = locked_chord.error + free_chord.error;
        // Steps of d − margin never arrive: 5 % above it is near enough.
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
    problem: &FlankProblem,
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
    // Half a turn is as far as a bracket means anything.
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
        // Rounding may hide as much of the way in.
        clear: clear + turned(rounding),
        touching,
        closed: touching - turned(depth),
        place,
    }
}

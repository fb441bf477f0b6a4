//! Whether a pair of half teeth is clear at one opening. Chords are cut finer only where they are near each other.

use super::chord::Chord;
use super::facing_pair::FacingPair;
use super::graphs;
use crate::contact::parry::closest;
use nalgebra::{Isometry2, Point2};

/// Limit of pairs that are cut round their nearest place; further pairs are halved, which always shortens them. (Three to ten are usual.)
const ROUNDS: u32 = 64;

/// The result for one pair at two openings.
pub(super) enum Finding {
    /// Clear at both.
    Clear,
    /// Clear at the greater, not proven clear at the smaller.
    Touch,
    /// Not proven clear at the greater.
    Overlap,
    /// Unknown: the budget is spent.
    EffortSpent,
}

/// Examines `problem` at two openings, the greater first, with polygons down to `finest`.
///
/// If at the greater opening nothing is within both chordal errors plus the movement of a point to the smaller, both
/// are clear. If a touch is `known` already, the smaller opening is not examined.
pub(super) fn examine(
    problem: &FacingPair,
    [open, closed]: [f64; 2],
    finest: f64,
    known: bool,
    left: &mut u32,
) -> Finding {
    let look = |opening: f64, slack: f64, left: &mut u32| {
        let mut examination = Examination {
            problem,
            finest,
            slack,
            close: false,
            left,
            rounds: ROUNDS,
        };
        let clear = examination.at(opening);
        (clear, examination.close)
    };
    let between = if known {
        0.0
    } else {
        problem.reach() * (open - closed)
    };
    let (clear, close) = look(open, between, left);
    let finding = match (clear, close && !known) {
        (false, _) => Finding::Overlap,
        (true, false) => Finding::Clear,
        (true, true) => {
            if look(closed, 0.0, left).0 {
                Finding::Clear
            } else {
                Finding::Touch
            }
        }
    };
    match *left {
        0 => Finding::EffortSpent,
        _ => finding,
    }
}

/// The examination of one pair of half teeth at one opening.
struct Examination<'a> {
    problem: &'a FacingPair<'a>,
    finest: f64,
    /// A clearance up to this much counts as close.
    slack: f64,
    close: bool,
    /// Chord pairs that may still be examined.
    left: &'a mut u32,
    /// Pairs that may still be cut round their nearest place.
    rounds: u32,
}

impl Examination<'_> {
    /// Whether the half teeth are proven clear.
    fn at(&mut self, opening: f64) -> bool {
        let (locked, free) = (&self.problem.locked, &self.problem.free);
        let frame = self.problem.at(opening);
        let [(here, radius), (there, other)] = [locked.disc(), free.disc()];
        let locked_reach = radius + self.slack;
        let apart = |point: Point2<f64>, reach: f64| {
            let within = reach + locked_reach;
            (point - here).norm_squared() > within * within
        };
        if apart(frame * there, other) {
            return true;
        }
        for free_chord in free.outline().iter().chain(free.own()) {
            let seen = free_chord.ends.map(|end| frame * end);
            let middle = nalgebra::center(&seen[0], &seen[1]);
            if apart(middle, free_chord.half_length + free_chord.error) {
                continue;
            }
            for locked_chord in locked.outline().iter().chain(locked.own()) {
                if !self.clear(&frame, locked_chord, free_chord, &seen) {
                    return false;
                }
            }
        }
        true
    }

    /// Whether the curves of two chords are proven clear; `seen` are the ends of the free chord in the locked frame.
    fn clear(
        &mut self,
        frame: &Isometry2<f64>,
        locked_chord: &Chord,
        free_chord: &Chord,
        seen: &[Point2<f64>; 2],
    ) -> bool {
        let tube = locked_chord.error + free_chord.error;
        let within = locked_chord.half_length + free_chord.half_length + tube + self.slack;
        let apart = (locked_chord.ends[0] - seen[0]) + (locked_chord.ends[1] - seen[1]);
        if apart.norm_squared() > 4.0 * within * within {
            return true;
        }
        if *self.left == 0 {
            return false;
        }
        *self.left -= 1;
        let finest = locked_chord.error <= self.finest && free_chord.error <= self.finest;
        if finest {
            let distance = closest(&locked_chord.ends, seen).distance;
            // The errors of the finest chords can be smaller than the rounding of a distance.
            self.close |= distance <= 2.0 * self.finest + self.slack;
            return distance > 2.0 * self.finest;
        }
        let gap = self.gap(locked_chord, free_chord, seen);
        let apart = match gap {
            Some(gap) => 0.75 * gap.width - 2.0 * self.finest,
            // It suffices that one chord lies beyond the line of the other; otherwise shorter chords decide.
            None => {
                let [line, other] = [
                    off_line(&locked_chord.ends, seen, locked_chord.half_length),
                    off_line(seen, &locked_chord.ends, free_chord.half_length),
                ];
                line.max(other) - tube
            }
        };
        if apart > 0.0 {
            self.close |= apart <= self.slack;
            return true;
        }
        if let Some(gap) = gap
            && self.rounds > 0
            && !locked_chord.is_cut()
            && !free_chord.is_cut()
        {
            self.rounds -= 1;
            return self.clear_round(frame, locked_chord, free_chord, gap.cuts(-apart));
        }
        let mut made = None;
        if locked_chord.error >= free_chord.error {
            let halves = self.problem.locked.halves(locked_chord, &mut made);
            let [first, second] = nearer_first([halves[0].ends, halves[1].ends], seen);
            self.clear(frame, &halves[first], free_chord, seen)
                && self.clear(frame, &halves[second], free_chord, seen)
        } else {
            let halves = self.problem.free.halves(free_chord, &mut made);
            let ends = [0, 1].map(|i| halves[i].ends.map(|end| frame * end));
            let [first, second] = nearer_first(ends, &locked_chord.ends);
            self.clear(frame, locked_chord, &halves[first], &ends[first])
                && self.clear(frame, locked_chord, &halves[second], &ends[second])
        }
    }

    /// Whether the curves of two chords are proven clear, with both cut on either side of their nearest place.
    fn clear_round(
        &mut self,
        frame: &Isometry2<f64>,
        locked_chord: &Chord,
        free_chord: &Chord,
        cuts: [[f64; 2]; 2],
    ) -> bool {
        let locked = self.problem.locked.cut_at(locked_chord, cuts[0]);
        let free = self.problem.free.cut_at(free_chord, cuts[1]);
        free.chords().iter().all(|free_chord| {
            let seen = free_chord.ends.map(|end| frame * end);
            let mut pieces = locked.chords().iter();
            pieces.all(|locked_chord| self.clear(frame, locked_chord, free_chord, &seen))
        })
    }

    /// A lower bound of the distance between the curves of two chords from their curvature ([`graphs::gap`]).
    fn gap(
        &self,
        locked_chord: &Chord,
        free_chord: &Chord,
        seen: &[Point2<f64>; 2],
    ) -> Option<graphs::Gap> {
        let stretch = |ends, chord: &Chord, curvature| graphs::Stretch {
            ends,
            half_length: chord.half_length,
            curvature,
        };
        let [locked, free] = [&self.problem.locked, &self.problem.free];
        let locked_chord = stretch(
            &locked_chord.ends,
            locked_chord,
            locked.curvature(locked_chord)?,
        );
        let free_chord = stretch(seen, free_chord, free.curvature(free_chord)?);
        graphs::gap(&locked_chord, &free_chord)
    }
}

/// How far a chord lies to one side of another chord's line; 0 or less if it crosses the line.
fn off_line(line: &[Point2<f64>; 2], ends: &[Point2<f64>; 2], half_length: f64) -> f64 {
    let along = line[1] - line[0];
    let [one, other] = ends.map(|end| along.perp(&(end - line[0])));
    one.min(other).max(-one.max(other)) / (2.0 * half_length)
}

/// Which of two chords has its middle nearer to that of another. Starting with it finds a touch sooner.
fn nearer_first(halves: [[Point2<f64>; 2]; 2], other: &[Point2<f64>; 2]) -> [usize; 2] {
    let middle = other[0].coords + other[1].coords;
    let [one, two] = halves.map(|[a, b]| (a.coords + b.coords - middle).norm_squared());
    if two < one { [1, 0] } else { [0, 1] }
}

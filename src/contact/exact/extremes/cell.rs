//! Bounds of the lost motion over a stretch of one mating, which close with the square of its length.

use super::course::{Course, PARTS, Posed, SideCourse};
use super::dip::Lines;
use super::fillet::{self, OnFillet, Reached};
use super::separation::{Separation, lowest_roll};
use super::table::{OpenStep, Table};
use std::f64::consts::PI;

/// A stretch of one mating and what its lost motion is at least and at most, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub mating: u64,
    pub part: usize,
    /// Fractions of the pitch.
    pub from: f64,
    pub to: f64,
    pub low: f64,
    pub high: f64,
    /// Where, between `from` and `to`, the lost motion is expected to be least and greatest.
    pub lowest: f64,
    pub highest: f64,
    /// A pose in it or at its end that has been looked at.
    pub seen: Option<f64>,
}

/// The room of one pair of half teeth over a cell, `u` from 0 to 1.
///
/// With `bend/2 (u − 1/2)²` added it is convex, above both of its tangents and, where it is known to touch at both ends, below its chord.
/// (The chord takes the directions that separate the pair between the ends to lie between those at the ends: the contact of a pair moves one
/// way along its flanks.)
#[derive(Debug, Clone, Copy)]
struct PairRoom {
    tangents: [(f64, f64); 2],
    bend: f64,
    chord: Option<(f64, f64)>,
}

/// Angles of a locked half tooth and distances of the outlines' centres over a cell.
struct Places {
    at: f64,
    play: f64,
    distances: (f64, f64),
}

impl PairRoom {
    /// Of the room `a`, `b` at both ends, the rates there, and the bend.
    fn convex([a, b]: [f64; 2], rates: [f64; 2], bend: f64, touches: bool) -> PairRoom {
        let up = bend / 8.0;
        let (at_a, at_b) = (rates[0] - 0.5 * bend, rates[1] + 0.5 * bend);
        PairRoom {
            tangents: [(a + up, at_a), (b + up - at_b, at_b)],
            bend,
            chord: touches.then_some((a + up, b - a)),
        }
    }

    /// At least a straight line between the ends; without a bound, NaN or −∞, no more than half a turn of interference.
    fn straight(ends: [f64; 2]) -> PairRoom {
        let [a, b] = ends.map(|end| end.max(-PI));
        PairRoom {
            tangents: [(a, b - a); 2],
            bend: 0.0,
            chord: None,
        }
    }

    fn low(&self, u: f64) -> f64 {
        let [a, b] = self.tangents.map(|(start, rate)| start + rate * u);
        a.max(b) - 0.5 * self.bend * (u - 0.5) * (u - 0.5)
    }

    /// Where its tangents cross, if between the ends.
    fn turns(&self) -> Option<f64> {
        let [a, b] = self.tangents;
        let u = (b.0 - a.0) / (a.1 - b.1);
        (u > 0.0 && u < 1.0).then_some(u)
    }
}

impl Cell {
    /// The cell of a part of a mating; its bounds are still to be found.
    pub fn of_part(mating: u64, part: usize) -> Cell {
        let from = part as f64 / PARTS as f64;
        Cell {
            mating,
            part,
            from,
            to: (part as f64 + 1.0) / PARTS as f64,
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            lowest: from,
            highest: from,
            seen: None,
        }
    }

    /// The two cells to both sides of `at`, a pose that has been looked at; the cut is kept off the ends.
    pub fn cut(&self, at: f64) -> [Cell; 2] {
        let width = self.to - self.from;
        let border = at.clamp(self.from + 0.25 * width, self.to - 0.25 * width);
        let whole = Cell {
            seen: Some(at),
            ..*self
        };
        [
            Cell {
                to: border,
                ..whole
            },
            Cell {
                from: border,
                ..whole
            },
        ]
    }

    /// The same cell with its bounds.
    pub fn bounded(self, course: &Course, table: &Table) -> Cell {
        let posed = course.posed(self.mating);
        let rooms = [0, 1].map(|k| {
            self.rooms(
                &course.sides[k],
                &posed[k],
                table.steps(k, self.mating, self.part),
            )
        });
        let (lowest, low) = least(&rooms);
        let (highest, high) = greatest(&rooms);
        let width = self.to - self.from;
        Cell {
            low: low.max(self.low),
            high: high.min(self.high),
            lowest: self.from + lowest * width,
            highest: self.from + highest * width,
            ..self
        }
    }

    fn rooms(
        &self,
        side: &SideCourse,
        posed: &Posed,
        steps: impl Iterator<Item = OpenStep>,
    ) -> Vec<PairRoom> {
        let ends = [posed.on(self.from), posed.on(self.to)];
        let mut rooms = Vec::with_capacity(8);
        for step in steps {
            self.add(side, &ends, step, &mut rooms);
        }
        rooms
    }

    /// Adds what bounds the room of the pair at `step`: that of its involutes, and that of a corner and a fillet.
    fn add(
        &self,
        side: &SideCourse,
        ends: &[Posed; 2],
        OpenStep { step, enough, dips }: OpenStep,
        rooms: &mut Vec<PairRoom>,
    ) {
        let problem = side.problem;
        let width = self.to - self.from;
        // Rolls change with the pitches, and a little with what the eccentricities do in this time.
        let plays = [problem.locked.pitch, problem.free.pitch].map(|pitch| 1.2 * pitch * width);
        let rounding = 2.0 * problem.rounding(problem.free.shape.base, 1.0);
        let pitch = problem.locked.pitch * width;
        let separations = |endless| {
            ends.map(|end| Separation::new(&end.flanks, step, end.nominal_gap(), endless))
        };
        let room =
            |found: &[Separation; 2], less: f64| [0, 1].map(|k| ends[k].room(found[k].gap) - less);
        let bend = |found: &[Separation; 2]| {
            let [a, b] = found.each_ref().map(|one| one.bend(plays, side.off));
            Some(a?.max(b?) * pitch * pitch)
        };
        let found = separations(false);
        let known = bend(&found);
        if let Some(bend) = known {
            let rates = [0, 1].map(|k| ends[k].rate(found[k].slope) * width);
            let touches = found.iter().all(|one| one.touches);
            let room = room(&found, rounding);
            rooms.push(PairRoom::convex(room, rates, bend, touches));
        } else {
            // Endless involutes are never farther apart, but for what lies below the form rolls; they are all but straight.
            let found = separations(true);
            let slack = bend(&found).unwrap_or(f64::INFINITY) / 8.0 + rounding;
            let forms = [&problem.locked.shape, &problem.free.shape].map(lowest_roll);
            let short = found[0].short(&found[1], plays, forms);
            rooms.push(PairRoom::straight(room(&found, slack + short)));
        }
        if !dips {
            return;
        }
        let places = self.places(side, ends, step);
        let lines = Lines::new(places.distances, problem.sum());
        for dip in side
            .dips
            .iter()
            .filter(|dip| dip.may_dip(places.at, places.play))
        {
            let clearance = match &lines {
                Some(lines) => {
                    let [a, b] = dip.clearance(places.at, places.play, lines, enough);
                    a.min(b)
                }
                None => f64::NEG_INFINITY,
            };
            if clearance >= enough {
                continue;
            }
            let near = [0, 1].map(|k| found[k].gap);
            let corners = ends.map(|end| OnFillet::new(end.flanks, step, dip.tip));
            let angle = problem.locked.pitch * width;
            match fillet::bounds(corners, near, angle, dip.deepest) {
                Some(bounds) => {
                    let bend = bounds.bend * pitch * pitch;
                    let room = |found: [Reached; 2]| [0, 1].map(|k| ends[k].room(found[k].gap));
                    let rates = [0, 1].map(|k| ends[k].rate(bounds.clear[k].slope) * width);
                    let [a, b] = room(bounds.clear);
                    let clear = PairRoom::convex([a - rounding, b - rounding], rates, bend, false);
                    let chord = bounds.inside.map(|inside| {
                        let [a, b] = room(inside);
                        (a + bend / 8.0 + rounding, b - a)
                    });
                    rooms.push(PairRoom { chord, ..clear });
                }
                None => {
                    let found = separations(true);
                    let slack = bend(&found).unwrap_or(f64::INFINITY) / 8.0 + rounding;
                    rooms.push(PairRoom::straight(room(&found, slack - clearance)));
                }
            }
        }
    }

    /// Where the locked half tooth of a step stands, seen from the line of the outlines' centres.
    fn places(&self, side: &SideCourse, ends: &[Posed; 2], step: i64) -> Places {
        let problem = side.problem;
        let places = ends.map(|end| {
            let (between, _) = end.flanks.between(end.nominal_gap());
            let at = end.flanks.pair(step).locked_base + problem.locked.shape.half_base;
            (at - between.arg(), between.norm())
        });
        // Between the ends, and as far as the free gear may stand from where `between` was taken: a hundredth of a radian.
        let off = side.off[0] * problem.locked.pitch * (self.to - self.from)
            + side.off[1] * (problem.free.pitch * (self.to - self.from) + 0.01);
        Places {
            at: 0.5 * (places[0].0 + places[1].0),
            play: 0.5 * (places[0].0 - places[1].0).abs() + 2.0 * off / problem.distance,
            distances: (
                places[0].1.min(places[1].1) - off,
                places[0].1.max(places[1].1) + off,
            ),
        }
    }
}

/// Where the sum of both sides is least, and its bound there.
fn least(rooms: &[Vec<PairRoom>; 2]) -> (f64, f64) {
    let [right, left] = rooms;
    let mut least = (0.5, f64::INFINITY);
    for r in right {
        for l in left {
            let turns = [Some(0.0), Some(1.0), r.turns(), l.turns()];
            for u in turns.into_iter().flatten() {
                let sum = r.low(u) + l.low(u);
                if sum < least.1 {
                    least = (u, sum);
                }
            }
        }
    }
    least
}

/// Where the least of each side's chords, summed up, is greatest, and that.
fn greatest(rooms: &[Vec<PairRoom>; 2]) -> (f64, f64) {
    let mut breaks = vec![0.0, 1.0];
    for side in rooms {
        let chords: Vec<(f64, f64)> = side.iter().filter_map(|room| room.chord).collect();
        for (k, a) in chords.iter().enumerate() {
            for b in &chords[k + 1..] {
                let u = (b.0 - a.0) / (a.1 - b.1);
                if u > 0.0 && u < 1.0 {
                    breaks.push(u);
                }
            }
        }
    }
    let high = |u: f64| -> f64 {
        let least = |side: &Vec<PairRoom>| {
            let chords = side.iter().filter_map(|room| room.chord);
            chords
                .map(|(start, rate)| start + rate * u)
                .fold(f64::INFINITY, f64::min)
        };
        rooms.iter().map(least).sum()
    };
    let each = breaks.into_iter().map(|u| (u, high(u)));
    each.fold((0.5, f64::NEG_INFINITY), |most, one| {
        if one.1 > most.1 { one } else { most }
    })
}

//! The room of pairs of half teeth over a stretch of a mating, and what both sides come to together.

use std::f64::consts::PI;

/// The room of one pair of half teeth over a cell, `u` from 0 to 1.
///
/// With `bend/2 (u − 1/2)²` added it is convex, above both of its tangents and, where it is known to touch at both ends, below its chord.
/// (The chord takes the directions that separate the pair between the ends to lie between those at the ends: the contact of a pair moves one
/// way along its flanks.)
#[derive(Debug, Clone, Copy)]
pub(super) struct PairRoom {
    tangents: [(f64, f64); 2],
    bend: f64,
    chord: Option<(f64, f64)>,
}

impl PairRoom {
    /// Of the room `a`, `b` at both ends, the rates there, and the bend.
    pub fn convex([a, b]: [f64; 2], rates: [f64; 2], bend: f64, touches: bool) -> PairRoom {
        let up = bend / 8.0;
        let (at_a, at_b) = (rates[0] - 0.5 * bend, rates[1] + 0.5 * bend);
        PairRoom {
            tangents: [(a + up, at_a), (b + up - at_b, at_b)],
            bend,
            chord: touches.then_some((a + up, b - a)),
        }
    }

    /// At least a straight line between the ends; without a bound, NaN or −∞, no more than half a turn of interference.
    pub fn straight(ends: [f64; 2]) -> PairRoom {
        let [a, b] = ends.map(|end| end.max(-PI));
        PairRoom {
            tangents: [(a, b - a); 2],
            bend: 0.0,
            chord: None,
        }
    }

    /// The same below `chord`, its start and rate with the bend added, where there is one.
    pub fn within(self, chord: Option<(f64, f64)>) -> PairRoom {
        PairRoom { chord, ..self }
    }

    /// Takes `by` off what it is at least.
    pub fn lower(&mut self, by: f64) {
        for (start, _) in &mut self.tangents {
            *start -= by;
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

/// A straight piece of [`lines_above`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// `u` where it begins and ends.
    pub over: [f64; 2],
    /// Its room at `u = 0` and at `u = 1`, prolonged.
    pub room: [f64; 2],
}

/// A broken line that the least of the touching rooms stays below: the least of their chords, each raised by what the room bends. It has no pieces where no room is
/// known to touch.
///
/// A pair with more room than this changes neither bound. Only touching rooms count, as the others bound nothing from above.
pub(super) fn lines_above(rooms: &[PairRoom]) -> Vec<Piece> {
    let touching = rooms.iter().filter(|room| room.chord.is_some());
    let lines = touching.map(|room| [0.0, 1.0].map(|end| room.low(end) + room.bend / 8.0));
    let lines: Vec<[f64; 2]> = lines.collect();
    let rate = |line: &[f64; 2]| line[1] - line[0];
    let first = lines.iter().min_by(|a, b| {
        let at_start = a[0].total_cmp(&b[0]);
        at_start.then(rate(a).total_cmp(&rate(b)))
    });
    let Some(mut line) = first else {
        return Vec::new();
    };
    let (mut pieces, mut from) = (Vec::new(), 0.0);
    loop {
        // The next line that falls below.
        let steeper = lines.iter().filter(|other| rate(other) < rate(line));
        let crossed =
            steeper.map(|other| ((other[0] - line[0]) / (rate(line) - rate(other)), other));
        let next = crossed.min_by(|a, b| {
            let place = a.0.total_cmp(&b.0);
            place.then(rate(a.1).total_cmp(&rate(b.1)))
        });
        let to = next.map_or(1.0, |(place, _)| place.clamp(from, 1.0));
        pieces.push(Piece {
            over: [from, to],
            room: *line,
        });
        match next {
            Some((_, other)) if to < 1.0 => (line, from) = (other, to),
            _ => return pieces,
        }
    }
}

/// Where the sum of both sides is least, and its bound there.
pub(super) fn least(rooms: &[Vec<PairRoom>; 2]) -> (f64, f64) {
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
pub(super) fn greatest(rooms: &[Vec<PairRoom>; 2]) -> (f64, f64) {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The broken line is the least of the chords at every place. Source: the chords themselves.
    #[test]
    fn the_broken_line_is_the_least_of_all_chords() {
        let ends = [
            [0.0, 3.0],
            [0.75, 0.75],
            [2.0, -1.0],
            [5.0, 5.0],
            [0.0, 4.0],
        ];
        let room =
            |ends: [f64; 2], touches| PairRoom::convex(ends, [ends[1] - ends[0]; 2], 0.0, touches);
        let rooms: Vec<PairRoom> = ends.iter().map(|ends| room(*ends, true)).collect();
        let pieces = lines_above(&rooms);
        assert_eq!(pieces.len(), 3);
        assert_eq!((pieces[0].over[0], pieces[2].over[1]), (0.0, 1.0));
        for piece in &pieces {
            for part in [0.0, 0.3, 1.0] {
                let u = piece.over[0] + part * (piece.over[1] - piece.over[0]);
                let at = |[a, b]: [f64; 2]| a + (b - a) * u;
                let least = ends.into_iter().map(at).fold(f64::INFINITY, f64::min);
                assert!((at(piece.room) - least).abs() < 1e-15, "{piece:?} at {u}");
            }
        }
        assert_eq!(lines_above(&[room([0.0, 1.0], false)]), []);
    }
}

//! The room of pairs of half teeth over a stretch of a mating, and the sum of both sides.

use std::f64::consts::PI;

/// The room of one pair of half teeth over a cell, `u` from 0 to 1.
///
/// With `bend/2 (u − 1/2)²` added it is convex. It is then above both of its tangents and, if the pair touches at both ends, below its
/// chord. (The chord assumes that the separating directions between the ends lie between those at the ends: the contact of a pair moves in
/// one direction along its flanks.)
#[derive(Debug, Clone, Copy)]
pub(super) struct PairRoom {
    tangents: [(f64, f64); 2],
    bend: f64,
    chord: Option<RoomAbove>,
}

/// A bound from above, `start + rate u + bend/2 u (1 − u)`.
#[derive(Debug, Clone, Copy)]
pub(super) struct RoomAbove {
    start: f64,
    rate: f64,
    /// Bounds how much the room bends downwards.
    bend: f64,
    /// Whether `bend` is the curvature of the room itself, up to the third order, and not only a bound of it.
    has_known_bend: bool,
}

impl PairRoom {
    /// The bound from the room `a`, `b` at both ends, the rates there, and the curvature `bend`.
    pub fn convex([a, b]: [f64; 2], rates: [f64; 2], bend: f64, touches: bool) -> PairRoom {
        let up = bend / 8.0;
        let (at_a, at_b) = (rates[0] - 0.5 * bend, rates[1] + 0.5 * bend);
        PairRoom {
            tangents: [(a + up, at_a), (b + up - at_b, at_b)],
            bend,
            chord: touches.then_some(RoomAbove {
                start: a,
                rate: b - a,
                bend,
                has_known_bend: false,
            }),
        }
    }

    /// The room has these `ends` and `rates`, and a third derivative of at most `third`, which bounds its bend by the mean of the rates.
    pub fn smooth(ends: [f64; 2], rates: [f64; 2], third: f64, rounding: f64) -> PairRoom {
        let bend = rates[0] - rates[1] + third;
        let mut room = PairRoom::convex(ends, rates, bend, true);
        room.lower(rounding);
        room.chord = room.chord.map(|chord| RoomAbove {
            start: chord.start + rounding,
            has_known_bend: true,
            ..chord
        });
        room
    }

    /// At least a straight line between the ends; without a bound, NaN or −∞, at most half a turn of interference.
    pub fn straight(ends: [f64; 2]) -> PairRoom {
        let [a, b] = ends.map(|end| end.max(-PI));
        PairRoom {
            tangents: [(a, b - a); 2],
            bend: 0.0,
            chord: None,
        }
    }

    /// This room, bounded from above by the straight line between `ends` if there are any.
    pub fn within(self, ends: Option<[f64; 2]>) -> PairRoom {
        let chord = ends.map(|[a, b]| RoomAbove {
            start: a,
            rate: b - a,
            bend: 0.0,
            has_known_bend: false,
        });
        PairRoom { chord, ..self }
    }

    /// Bounds from below by the one of both rooms that is higher in the middle, from above by this one.
    pub fn above(self, other: PairRoom) -> PairRoom {
        if self.low(0.5) >= other.low(0.5) {
            return self;
        }
        PairRoom {
            chord: self.chord,
            ..other
        }
    }

    /// Bounds of a room that is this and `least` to `most` more.
    pub fn between(mut self, least: f64, most: f64) -> PairRoom {
        self.lower(-least);
        self.chord = self.chord.filter(|_| most.is_finite());
        if let Some(chord) = &mut self.chord {
            chord.start += most;
        }
        self
    }

    /// Lowers the bound by `by`.
    pub fn lower(&mut self, by: f64) {
        for (start, _) in &mut self.tangents {
            *start -= by;
        }
    }

    fn low(&self, u: f64) -> f64 {
        let [a, b] = self.tangents.map(|(start, rate)| start + rate * u);
        a.max(b) - 0.5 * self.bend * (u - 0.5) * (u - 0.5)
    }

    /// The place where its tangents cross, if it is between the ends.
    fn turns(&self) -> Option<f64> {
        let [a, b] = self.tangents;
        let u = (b.0 - a.0) / (a.1 - b.1);
        (u > 0.0 && u < 1.0).then_some(u)
    }
}

impl RoomAbove {
    /// A straight line above it: its start and rate.
    fn raised(&self) -> (f64, f64) {
        (self.start + self.bend.max(0.0) / 8.0, self.rate)
    }
}

/// A straight piece of [`lines_above`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LinePiece {
    /// `u` at its ends.
    pub over: [f64; 2],
    /// Its room at `u = 0` and at `u = 1`, extended.
    pub room: [f64; 2],
}

/// A broken line above the least of the touching rooms: the least of their chords, each raised by its curvature. It has no pieces if no
/// room is known to touch.
///
/// A pair with more room than this changes neither bound. Only touching rooms count, because the others have no upper bound.
pub(super) fn lines_above(rooms: &[PairRoom]) -> Vec<LinePiece> {
    let chords = rooms.iter().filter_map(|room| room.chord);
    let lines = chords.map(|chord| {
        let (start, rate) = chord.raised();
        [start, start + rate]
    });
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
        // The next line that is lower.
        let steeper = lines.iter().filter(|other| rate(other) < rate(line));
        let crossed =
            steeper.map(|other| ((other[0] - line[0]) / (rate(line) - rate(other)), other));
        let next = crossed.min_by(|a, b| {
            let place = a.0.total_cmp(&b.0);
            place.then(rate(a.1).total_cmp(&rate(b.1)))
        });
        let to = next.map_or(1.0, |(place, _)| place.clamp(from, 1.0));
        pieces.push(LinePiece {
            over: [from, to],
            room: *line,
        });
        match next {
            Some((_, other)) if to < 1.0 => (line, from) = (other, to),
            _ => return pieces,
        }
    }
}

/// The place where the sum of both sides is least, and its bound.
pub(super) fn least(rooms: &[Vec<PairRoom>; 2]) -> (f64, f64) {
    let [right, left] = rooms;
    let mut least = (0.5, f64::INFINITY);
    for r in right {
        for l in left {
            let mut take = |u: f64| {
                let sum = r.low(u) + l.low(u);
                if sum < least.1 {
                    least = (u, sum);
                }
            };
            for u in [Some(0.0), Some(1.0), r.turns(), l.turns()] {
                u.map(&mut take);
            }
            // A sum that bends upwards is least where a pair of tangents has the rate to balance that.
            let up = -(r.bend + l.bend);
            if up > 0.0 {
                for rate in r.tangents.map(|(_, rate)| rate) {
                    for other in l.tangents.map(|(_, rate)| rate) {
                        take((0.5 - (rate + other) / up).clamp(0.0, 1.0));
                    }
                }
            }
        }
    }
    least
}

/// The place at which the sum of the least rooms of both sides is greatest, and an upper bound of that sum.
pub(super) fn greatest(rooms: &[Vec<PairRoom>; 2]) -> (f64, f64) {
    let every = rooms.each_ref().map(|side| Above::of_every(side));
    let sum = sum_of(&every);
    let sharp = rooms.each_ref().map(|side| Above::of_known_bends(side));
    if sharp.iter().all(Option::is_none) {
        return sum;
    }
    let [right, left] = every;
    let [sharp_right, sharp_left] = sharp;
    let sharp = sum_of(&[sharp_right.unwrap_or(right), sharp_left.unwrap_or(left)]);
    if sharp.1 < sum.1 { sharp } else { sum }
}

/// An upper bound of one side's room: the least of straight lines, plus `bend/2 u (1 − u)`.
#[derive(Debug)]
struct Above {
    lines: Vec<(f64, f64)>,
    bend: f64,
}

impl Above {
    fn of_every(side: &[PairRoom]) -> Above {
        let chords = side.iter().filter_map(|room| room.chord);
        Above {
            lines: chords.map(|chord| chord.raised()).collect(),
            bend: 0.0,
        }
    }

    /// The bound by the sharp chords, if there are any. It takes the greatest of their bends, which hardly differ.
    fn of_known_bends(side: &[PairRoom]) -> Option<Above> {
        let chords = side.iter().filter_map(|room| room.chord);
        let chords: Vec<RoomAbove> = chords.filter(|chord| chord.has_known_bend).collect();
        let bend = chords.iter().map(|chord| chord.bend).reduce(f64::max)?;
        Some(Above {
            lines: chords
                .iter()
                .map(|chord| (chord.start, chord.rate))
                .collect(),
            bend,
        })
    }

    /// The least of the lines.
    fn line(&self, u: f64) -> f64 {
        let lines = self.lines.iter().map(|(start, rate)| start + rate * u);
        lines.fold(f64::INFINITY, f64::min)
    }
}

/// The place at which the sum of both sides is greatest, and that sum.
fn sum_of(sides: &[Above; 2]) -> (f64, f64) {
    let mut breaks = vec![0.0, 1.0];
    for side in sides {
        for (k, a) in side.lines.iter().enumerate() {
            for b in &side.lines[k + 1..] {
                let u = (b.0 - a.0) / (a.1 - b.1);
                if u > 0.0 && u < 1.0 {
                    breaks.push(u);
                }
            }
        }
    }
    let bend = sides[0].bend + sides[1].bend;
    if bend > 0.0 {
        // Between two breaks the sum is a parabola.
        breaks.sort_unstable_by(f64::total_cmp);
        for k in 1..breaks.len() {
            let (from, to) = (breaks[k - 1], breaks[k]);
            let line = |u| sides[0].line(u) + sides[1].line(u);
            let rate = (line(to) - line(from)) / (to - from);
            if to > from && rate.is_finite() {
                breaks.push((0.5 + rate / bend).clamp(from, to));
            }
        }
    }
    let high = |u: f64| sides[0].line(u) + sides[1].line(u) + 0.5 * bend * u * (1.0 - u);
    let each = breaks.into_iter().map(|u| (u, high(u)));
    each.fold((0.5, f64::NEG_INFINITY), |most, one| {
        if one.1 > most.1 { one } else { most }
    })
}

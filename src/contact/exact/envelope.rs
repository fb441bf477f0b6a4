//! A cheap test whether a point is clear of a half tooth.
//!
//! `f(x)` is the half thickness of the tooth over its centre line; beyond the tip corner it stays at the corner's value. One straight line
//! in each of a few cells of `x` bounds it from above. A point below all these lines has not touched yet, so its gap is less than the
//! rotation of the test. It cannot have come through the metal. A point that turns in crosses the flank only inwards, because its polar
//! radius is monotone there ([`super::search_free_proof`]). Past the corner it approaches the centre line while the axis is further out
//! along the tooth than the point (for the gear that turns, further in). The land itself is no useful border: a point that entered through
//! the flank may leave through the land and be beside `f(x)` again.

use super::shape::C;
use crate::gear::{Gear, HalfTooth, Profile, ProfilePart, Segment, Side};

/// Cells over the tooth depth (tuned: 24 leave 1 point in 60 to the exact test on ordinary gears, 12 twice as many).
const CELLS: usize = 32;

/// Chordal error, in tooth depths, of the polygon that the lines bound (tuned: points so near to a flank are rare, and the polygon is built in a
/// third of the time that a tenth of this takes).
const CHORDAL_ERROR: f64 = 4e-4;

/// Upper bounds `f(x) ≤ intercept + slope x`, cell by cell.
#[derive(Debug, Clone)]
pub(super) struct Envelope {
    start: f64,
    cells_per_mm: f64,
    end: f64,
    /// The cells, between one for all lower `x` and one for all higher `x`.
    lines: [(f64, f64); CELLS + 2],
}

impl Envelope {
    /// The envelope of the half tooth of `gear`. A point is clear only by more than `margin` mm, and only if it is more
    /// than `least` mm from the gear's centre along the tooth.
    pub fn new(gear: &Gear, margin: f64, least: f64) -> Envelope {
        let depth = gear.tip_radius() - gear.root_radius();
        let chordal_error = CHORDAL_ERROR * depth;
        let polygon = HalfTooth::new(&Profile::new(gear), Side::Right, chordal_error);
        let end = gear.tip_radius() + margin;
        let start = polygon
            .points()
            .iter()
            .fold(end, |least, point| least.min(point.x))
            .max(least);
        let width = (end - start) / CELLS as f64;
        let mut envelope = Envelope {
            start,
            cells_per_mm: 1.0 / width,
            end,
            lines: [(f64::INFINITY, 0.0); CELLS + 2],
        };
        let half_tip = gear.tip_half_angle();
        let corner = gear.tip_radius() * half_tip.sin();
        envelope.lines[CELLS + 1] = (corner + margin, 0.0);
        // A cell includes the distance by which the curve may leave the polygon.
        let border = |cell: usize| start + cell as f64 * width;
        let mut pieces: [Vec<(f64, f64)>; CELLS] = std::array::from_fn(|_| Vec::with_capacity(16));
        let on_land = |segment: &Segment| segment.curve == ProfilePart::Tip;
        let flank = polygon.segments().iter().take_while(|s| on_land(s)).count();
        let beyond = [(end, corner), (gear.tip_radius() * half_tip.cos(), corner)];
        let below = polygon.points()[flank..]
            .iter()
            .map(|point| (point.x, -point.y));
        let border_points: Vec<(f64, f64)> = beyond.into_iter().chain(below).collect();
        for pair in border_points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            if a.0.max(b.0) <= start - chordal_error {
                continue;
            }
            let cell = |x: f64| ((x - start) / width) as usize;
            let first = cell(a.0.min(b.0) - chordal_error);
            let last = cell(a.0.max(b.0) + chordal_error).min(CELLS - 1);
            for (cell, piece) in (first..=last).zip(&mut pieces[first..=last]) {
                for (x, f) in [a, b] {
                    let inside = x.clamp(
                        border(cell) - chordal_error,
                        border(cell + 1) + chordal_error,
                    );
                    let share = if a.0 == b.0 {
                        0.0
                    } else {
                        (inside - x) / (b.0 - a.0)
                    };
                    piece.push((inside, f + share * (b.1 - a.1)));
                }
            }
        }
        for (line, piece) in envelope.lines[1..].iter_mut().zip(&pieces) {
            *line = above(piece, chordal_error + margin).unwrap_or(*line);
        }
        envelope
    }

    /// Whether `point`, in the frame of the tooth, is outside the metal on the side of the flank.
    #[inline]
    pub fn clears(&self, point: C) -> bool {
        let cell = (point.re - self.start) * self.cells_per_mm + 1.0;
        let (intercept, slope) = self.lines[cell.clamp(0.0, (CELLS + 1) as f64) as u32 as usize];
        -point.im > intercept + slope * point.re
    }

    /// Whether `point` is outside the tip circle, over the tip or past it.
    pub fn is_beyond_tip(&self, point: C) -> bool {
        point.re > self.end
    }
}

/// A line above `points` `(x, f)` by at least `room`, measured perpendicular to it; `None` without points.
fn above(points: &[(f64, f64)], room: f64) -> Option<(f64, f64)> {
    let low = points
        .iter()
        .copied()
        .reduce(|a, b| if b.0 < a.0 { b } else { a })?;
    let high = points
        .iter()
        .copied()
        .reduce(|a, b| if b.0 > a.0 { b } else { a })?;
    let slope = if high.0 > low.0 {
        (high.1 - low.1) / (high.0 - low.0)
    } else {
        0.0
    };
    let rest = points.iter().map(|(x, f)| f - slope * x);
    let intercept = rest.fold(f64::NEG_INFINITY, f64::max);
    Some((intercept + room * (1.0 + slope.abs()), slope))
}

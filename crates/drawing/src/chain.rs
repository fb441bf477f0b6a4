//! Joins the loose ends of drawn pieces into loops.
//!
//! Ends that are one point but for rounding are joined first. Then the remaining ends at most `join` apart are. This keeps a short
//! line between two others. Ends are looked up in a grid of squares of that size, so that n pieces take O(n).

use super::DrawingError;
use super::error::at;
use super::limits::SAME_MM;
use gearlash::outline::PathSegment;
use gearlash_text::numbers::ascii;
use nalgebra::Point2;
use std::collections::HashMap;

/// Most ends in one square of the grid: of nine, three are in one of its quarters, whose diagonal is below the tolerance.
const MAX_IN_A_SQUARE: usize = 8;

/// A drawn path without gaps: a line, a curve, or several of them; closed or not.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnPath {
    /// At least one. Each starts where the one before ends, to 1e-9 mm; the first of a closed path where the last ends. Either
    /// direction is possible.
    pub segments: Vec<PathSegment>,
    /// Layer or id; empty without one.
    pub name: String,
    /// Bound on the distance of the segments from the drawing, mm: fitted curves, closed gaps.
    pub bound_mm: f64,
    /// Where in the file it begins.
    pub place: String,
}

impl DrawnPath {
    /// The centre of a path that is one circle, perhaps drawn twice.
    pub fn circle(&self) -> Option<Point2<f64>> {
        let mut arcs = self.segments.iter().map(|segment| match segment {
            PathSegment::Arc { centre, radius, .. } => Some((*centre, *radius)),
            _ => None,
        });
        let (first, radius) = arcs.next()??;
        let is_same = |arc: Option<(Point2<f64>, f64)>| {
            arc.is_some_and(|(centre, other)| {
                (centre - first).norm() <= 1e-6 * radius && (other - radius).abs() <= 1e-6 * radius
            })
        };
        arcs.all(is_same).then_some(first)
    }
}

#[derive(Debug, Default)]
pub struct Chains {
    /// Closed paths.
    pub found: Vec<DrawnPath>,
    pub open: Vec<Open>,
    /// Places of loops that are too small and were left out.
    pub specks: Vec<String>,
}

#[derive(Debug)]
pub struct Open {
    pub ends: [Point2<f64>; 2],
    /// From the first end to the second, gaps left open.
    pub path: DrawnPath,
    pieces: usize,
}

impl Open {
    /// The fault of this open path, among the `open` paths of its layer.
    pub fn error(&self, open: &[Open]) -> DrawingError {
        let others = open.iter().filter(|other| !std::ptr::eq(*other, self));
        let others: Vec<Point2<f64>> = others.flat_map(|other| other.ends).collect();
        let from_start = others.iter().chain(&self.ends[1..]);
        let from_end = others.iter().chain(&self.ends[..1]);
        let pairs = from_start
            .map(|other| ("start", *other, (other - self.ends[0]).norm()))
            .chain(from_end.map(|other| ("end", *other, (other - self.ends[1]).norm())));
        let alone = ("end", self.ends[0], f64::INFINITY);
        let nearest = pairs.min_by(|a, b| a.2.total_cmp(&b.2));
        let (end, nearest, gap_mm) = nearest.unwrap_or(alone);
        let reason = format!(
            "{}: the path from {} to {}, of {} drawn elements, is open: from its {end} the nearest other end is {} mm away, at {}",
            self.path.place,
            at(&self.ends[0]),
            at(&self.ends[1]),
            self.pieces,
            ascii(gap_mm, 6),
            at(&nearest)
        );
        DrawingError::open(reason, gap_mm)
    }
}

/// Joins `pieces`. Ends at most `join` mm apart are one point; a gap larger than rounding is closed by a straight line.
pub fn chain(pieces: Vec<DrawnPath>, join: f64) -> Result<Chains, DrawingError> {
    let ends: Vec<Point2<f64>> = pieces.iter().flat_map(DrawnPath::ends).collect();
    let mut mates = vec![None; ends.len()];
    for (index, pair) in ends.chunks(2).enumerate() {
        if (pair[1] - pair[0]).norm() <= SAME_MM {
            (mates[2 * index], mates[2 * index + 1]) = (Some(2 * index + 1), Some(2 * index));
        }
    }
    for tolerance in [SAME_MM, join] {
        if tolerance >= SAME_MM {
            mate(&ends, &mut mates, tolerance, &pieces)?;
        }
    }
    let mut chains = Chains::default();
    let mut seen = vec![false; pieces.len()];
    for first in 0..pieces.len() {
        if seen[first] {
            continue;
        }
        let (forward, closed) = walk(2 * first, &mates);
        let backward = if closed {
            Vec::new()
        } else {
            walk(2 * first + 1, &mates).0
        };
        for entry in forward.iter().chain(&backward) {
            seen[entry / 2] = true;
        }
        if closed {
            chains.close(&forward, &pieces, join);
            continue;
        }
        let last = |way: &[usize]| ends[way[way.len() - 1] ^ 1];
        let ends = [last(&backward), last(&forward)];
        // The first piece is in both directions.
        let before = backward[1..].iter().rev().map(|entry| entry ^ 1);
        let way: Vec<usize> = before.chain(forward).collect();
        let mut path = pieces[first].empty();
        for &entry in &way {
            let piece = &pieces[entry / 2];
            path.segments.extend(piece.along(entry));
            path.bound_mm = path.bound_mm.max(piece.bound_mm);
        }
        chains.open.push(Open {
            ends,
            path,
            pieces: way.len(),
        });
    }
    Ok(chains)
}

/// The ends by which each piece is entered, from `entry` on, and whether the path closes.
fn walk(entry: usize, mates: &[Option<usize>]) -> (Vec<usize>, bool) {
    let mut way = vec![entry];
    let mut at = entry;
    while let Some(next) = mates[at ^ 1] {
        if next == entry {
            return (way, true);
        }
        way.push(next);
        at = next;
    }
    (way, false)
}

/// Pairs the ends that have no mate and lie within `tolerance` of each other.
fn mate(
    ends: &[Point2<f64>],
    mates: &mut [Option<usize>],
    tolerance: f64,
    pieces: &[DrawnPath],
) -> Result<(), DrawingError> {
    let branch = |end: usize| DrawingError::branch(&pieces[end / 2].place, &ends[end]);
    let square = |point: &Point2<f64>| {
        let index = |x: f64| (x / tolerance).floor() as i64;
        (index(point.x), index(point.y))
    };
    let free: Vec<usize> = (0..ends.len())
        .filter(|&end| mates[end].is_none())
        .collect();
    let mut grid: HashMap<(i64, i64), Vec<usize>> = HashMap::with_capacity(free.len());
    for &end in &free {
        let there = grid.entry(square(&ends[end])).or_default();
        there.push(end);
        if there.len() > MAX_IN_A_SQUARE {
            return Err(branch(end));
        }
    }
    for &end in &free {
        let (column, row) = square(&ends[end]);
        let squares = (-1..=1).flat_map(|x| (-1..=1).map(move |y| (column + x, row + y)));
        let near = |other: &usize| *other != end && (ends[*other] - ends[end]).norm() <= tolerance;
        let mut others = squares
            .filter_map(|square| grid.get(&square))
            .flatten()
            .copied()
            .filter(near);
        match (others.next(), others.next()) {
            (Some(_), Some(_)) => return Err(branch(end)),
            (other, _) => mates[end] = other,
        }
    }
    Ok(())
}

impl Chains {
    /// Adds the loop through the pieces entered at `way`.
    fn close(&mut self, way: &[usize], pieces: &[DrawnPath], join: f64) {
        let first = &pieces[way[0] / 2];
        let mut made = first.empty();
        for &entry in way {
            let piece = &pieces[entry / 2];
            piece
                .along(entry)
                .into_iter()
                .for_each(|segment| made.push(segment));
            made.bound_mm = made.bound_mm.max(piece.bound_mm);
        }
        if let Some(start) = made.segments.first().map(PathSegment::start) {
            made.reach(start);
        }
        let length: f64 = way.iter().map(|entry| pieces[entry / 2].length()).sum();
        // A line drawn there and back, with both gaps closed, is no loop.
        if length > 4.0 * join {
            self.found.push(made);
        } else {
            self.specks.push(first.place.clone());
        }
    }
}

impl DrawnPath {
    /// Adds a segment, joined to the one before.
    fn push(&mut self, segment: PathSegment) {
        self.reach(segment.start());
        self.segments.push(segment);
    }

    /// A straight line from the last end to `point`, where a gap is.
    fn reach(&mut self, point: Point2<f64>) {
        let Some(end) = self.segments.last().map(PathSegment::end) else {
            return;
        };
        let gap = (point - end).norm();
        if gap > SAME_MM {
            self.segments.push(PathSegment::Line([end, point]));
            // The drawn lines, continued, meet somewhere between.
            self.bound_mm = self.bound_mm.max(0.5 * gap);
        }
    }

    /// A path of its name and place, without segments.
    fn empty(&self) -> DrawnPath {
        DrawnPath {
            segments: Vec::new(),
            name: self.name.clone(),
            bound_mm: 0.0,
            place: self.place.clone(),
        }
    }

    fn ends(&self) -> [Point2<f64>; 2] {
        let last = self.segments.len() - 1;
        [self.segments[0].start(), self.segments[last].end()]
    }

    /// Points on it, in steps of 1e-6 mm, from the lesser end on. They are equal for pieces that are drawn twice.
    pub(super) fn trace(&self) -> Vec<[i64; 2]> {
        const STEP: f64 = 1e-6;
        let at = |segment: &PathSegment| {
            let segment = *segment;
            [0.0, 0.25, 0.5, 0.75].map(|u| segment.at(u)).into_iter()
        };
        let points = self.segments.iter().flat_map(at).chain([self.ends()[1]]);
        let grid = |x: f64| (x / STEP).round() as i64;
        let mut trace: Vec<[i64; 2]> = points.map(|p| [grid(p.x), grid(p.y)]).collect();
        if trace.iter().rev().lt(trace.iter()) {
            trace.reverse();
        }
        trace
    }

    /// Its segments from the end `entry`: the first if that is even, else the last.
    fn along(&self, entry: usize) -> Vec<PathSegment> {
        if entry.is_multiple_of(2) {
            return self.segments.clone();
        }
        self.segments
            .iter()
            .rev()
            .map(PathSegment::reversed)
            .collect()
    }

    /// An upper bound on its length, mm.
    pub(super) fn length(&self) -> f64 {
        self.segments.iter().map(PathSegment::length).sum()
    }
}

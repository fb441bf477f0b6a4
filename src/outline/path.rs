//! A closed path about a centre, counter-clockwise, that does not cross itself.

use super::error::OutlineError;
use super::polygon;
use super::segment::PathSegment;
use crate::gear::PartCurve;
use nalgebra::Point2;

/// Ends of neighbouring segments nearer than this share of the outline's size are one: rounding of decimals in a file.
const CLOSED: f64 = 1e-9;

/// A chord for each so much that a curve turns, rad (tuned: chords of a fillet stay within 0.05 % of its radius).
const CHORD_TURN: f64 = 0.06;

/// Chords of one segment at most.
const MOST_CHORDS: f64 = 512.0;

/// A segment of the path about its centre, the metal on its left.
#[derive(Debug, Clone)]
pub(super) struct PathPart {
    pub curve: PartCurve,
    /// Parameters where it starts and ends.
    pub ends: [f64; 2],
}

/// A point of the path: which part, at which parameter, and where.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    pub part: usize,
    pub t: f64,
    pub point: Point2<f64>,
}

/// The path, its centre at the origin.
#[derive(Debug, Clone)]
pub(super) struct ClosedPath {
    pub parts: Vec<PathPart>,
    /// Points along it; each chord from one to the next (and from the last to the first) is of one part, that of its first point.
    pub marks: Vec<Mark>,
}

impl ClosedPath {
    /// `segments` in order, each starting where the one before ends, in either direction, about `centre`.
    pub fn new(segments: &[PathSegment], centre: Point2<f64>) -> Result<ClosedPath, OutlineError> {
        if let Some(index) = segments.iter().position(|segment| !segment.is_finite()) {
            return Err(OutlineError::NotFinite { index });
        }
        let size = segments.iter().map(PathSegment::length).sum::<f64>();
        // Segments without length are no part of the path.
        let there = segments
            .iter()
            .filter(|segment| segment.length() > CLOSED * size);
        let about: Vec<PathSegment> = there.map(|segment| segment.moved(-centre.coords)).collect();
        if about.is_empty() {
            return Err(OutlineError::NotFinite { index: 0 });
        }
        for (k, segment) in about.iter().enumerate() {
            let (from, to) = (segment.end(), about[(k + 1) % about.len()].start());
            let gap_mm = (to - from).norm();
            // Segments left out may have bridged as much each.
            if gap_mm > CLOSED * size * segments.len() as f64 {
                let (from, to) = (from + centre.coords, to + centre.coords);
                return Err(OutlineError::Open { from, to, gap_mm });
            }
        }
        let mut path = ClosedPath::of(&about);
        if polygon::area(&path.corners()) < 0.0 {
            let back: Vec<PathSegment> = about.iter().rev().map(PathSegment::reversed).collect();
            path = ClosedPath::of(&back);
        }
        if let Some(near) = path.crossing() {
            let near = near + centre.coords;
            return Err(OutlineError::SelfCrossing { near });
        }
        if polygon::winding(&path.corners(), Point2::origin()) != 1 {
            return Err(OutlineError::CentreOutside { centre });
        }
        Ok(path)
    }

    fn of(segments: &[PathSegment]) -> ClosedPath {
        let mut path = ClosedPath {
            parts: Vec::with_capacity(segments.len()),
            marks: Vec::new(),
        };
        for segment in segments {
            let (curve, ends) = segment.part();
            let part = path.parts.len();
            for t in cuts(&curve, ends) {
                let point = curve.point(t);
                path.marks.push(Mark { part, t, point });
            }
            path.parts.push(PathPart { curve, ends });
        }
        path
    }

    /// The chord from a mark to the next: where it starts and ends in the parameter of its part.
    pub fn chord(&self, mark: usize) -> [f64; 2] {
        let Mark { part, t, .. } = self.marks[mark];
        match self.marks.get(mark + 1) {
            Some(next) if next.part == part => [t, next.t],
            _ => [t, self.parts[part].ends[1]],
        }
    }

    /// Its points, as the corners of a polygon.
    fn corners(&self) -> Vec<Point2<f64>> {
        self.marks.iter().map(|mark| mark.point).collect()
    }

    /// Near where two chords cross, those that share an end apart. Chords are compared while their ranges of x overlap.
    fn crossing(&self) -> Option<Point2<f64>> {
        let count = self.marks.len();
        let ends = |k: usize| [self.marks[k].point, self.marks[(k + 1) % count].point];
        let range = |k: usize, axis: usize| {
            let [a, b] = ends(k).map(|point| point[axis]);
            (a.min(b), a.max(b))
        };
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| range(a, 0).0.total_cmp(&range(b, 0).0));
        let mut open: Vec<usize> = Vec::new();
        for &k in &order {
            let (left, _) = range(k, 0);
            open.retain(|&other| range(other, 0).1 >= left);
            let (low, high) = range(k, 1);
            for &other in &open {
                let (below, above) = range(other, 1);
                let beside = (k + 1) % count == other || (other + 1) % count == k;
                if !beside && below <= high && above >= low && cross(ends(k), ends(other)) {
                    return Some(ends(k)[0]);
                }
            }
            open.push(k);
        }
        None
    }
}

/// Whether two chords cross in their insides.
fn cross([a, b]: [Point2<f64>; 2], [c, d]: [Point2<f64>; 2]) -> bool {
    let side = |from: Point2<f64>, to: Point2<f64>, of: Point2<f64>| (to - from).perp(&(of - from));
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// Parameters at which a part is cut into chords, its start first, its end left out. Of a line also the point nearest to the centre.
fn cuts(curve: &PartCurve, [from, to]: [f64; 2]) -> Vec<f64> {
    if let PartCurve::Line(_) = curve {
        let (start, normal) = curve.at(from);
        // Along the line, `i n`.
        let foot = from - (start.y * normal.x - start.x * normal.y);
        return match foot > from && foot < to {
            true => vec![from, foot],
            false => vec![from],
        };
    }
    let (_, half_turn) = curve.spread(from.min(to), from.max(to));
    let count = (2.0 * half_turn / CHORD_TURN)
        .ceil()
        .clamp(1.0, MOST_CHORDS);
    let at = |k: u32| from + (to - from) * f64::from(k) / count;
    (0..count as u32).map(at).collect()
}

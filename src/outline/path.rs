//! Paths: the segments of a drawing, and the closed path about a centre that they make.

use super::polygon;
use crate::error::OutlineError;
use crate::gear::{Circle, Cubic, Line, PartCurve};
use crate::numeric::{bisect, rank};
use nalgebra::{Point2, Vector2};

/// Most chords of one segment: a limit for pictures of curves far outside the drawing.
const MOST_CHORDS: f64 = 1e6;

/// A segment of a drawn path, mm, from its start to its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PathSegment {
    /// Straight between two points.
    Line([Point2<f64>; 2]),
    /// An arc of a circle.
    Arc {
        /// Its centre.
        centre: Point2<f64>,
        /// Its radius.
        radius: f64,
        /// Direction from the centre to its start, rad.
        start: f64,
        /// The angle to its end, rad, counter-clockwise positive; at most a whole turn.
        sweep: f64,
    },
    /// Cubic Bézier curve of four control points.
    Cubic([Point2<f64>; 4]),
}

impl PathSegment {
    /// This segment as a curve with the metal on its left, and the parameters of start and end.
    pub(super) fn part(&self) -> (PartCurve, [f64; 2]) {
        match *self {
            PathSegment::Line([from, to]) => (
                PartCurve::Line(Line::new(from, to)),
                [0.0, (to - from).norm()],
            ),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => (
                PartCurve::Circle(Circle::new(centre, radius, sweep > 0.0)),
                [start, start + sweep],
            ),
            PathSegment::Cubic(points) => (PartCurve::Cubic(Cubic::new(points)), [0.0, 1.0]),
        }
    }

    /// The point at the share `u`, 0 to 1, of the parameter.
    pub fn at(&self, u: f64) -> Point2<f64> {
        let (curve, [from, to]) = self.part();
        curve.point(from + (to - from) * u)
    }

    /// The start point.
    pub fn start(&self) -> Point2<f64> {
        match self {
            PathSegment::Line([start, _]) | PathSegment::Cubic([start, ..]) => *start,
            PathSegment::Arc { .. } => self.at(0.0),
        }
    }

    /// The end point.
    pub fn end(&self) -> Point2<f64> {
        match self {
            PathSegment::Line([_, end]) | PathSegment::Cubic([.., end]) => *end,
            PathSegment::Arc { .. } => self.at(1.0),
        }
    }

    /// This segment in reverse direction.
    pub fn reversed(&self) -> PathSegment {
        match *self {
            PathSegment::Line([from, to]) => PathSegment::Line([to, from]),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => PathSegment::Arc {
                centre,
                radius,
                start: start + sweep,
                sweep: -sweep,
            },
            PathSegment::Cubic([a, b, c, d]) => PathSegment::Cubic([d, c, b, a]),
        }
    }

    /// This segment moved by `by`, mm.
    pub fn moved(&self, by: Vector2<f64>) -> PathSegment {
        self.mapped(|point| point + by, |start, sweep| (start, sweep))
    }

    /// This segment mirrored in the y axis, as seen from the other side.
    pub fn mirrored(&self) -> PathSegment {
        self.mapped(
            |point| Point2::new(-point.x, point.y),
            |start, sweep| (std::f64::consts::PI - start, -sweep),
        )
    }

    /// This segment with mapped points, and mapped start and sweep of an arc.
    fn mapped(
        &self,
        place: impl Fn(Point2<f64>) -> Point2<f64>,
        turn: impl Fn(f64, f64) -> (f64, f64),
    ) -> PathSegment {
        match *self {
            PathSegment::Line(points) => PathSegment::Line(points.map(place)),
            PathSegment::Cubic(points) => PathSegment::Cubic(points.map(place)),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => {
                let (start, sweep) = turn(start, sweep);
                PathSegment::Arc {
                    centre: place(centre),
                    radius,
                    start,
                    sweep,
                }
            }
        }
    }

    /// An upper bound of the length, mm: for a cubic curve, that of its control polygon.
    pub fn length(&self) -> f64 {
        match *self {
            PathSegment::Line([from, to]) => (to - from).norm(),
            PathSegment::Arc { radius, sweep, .. } => radius * sweep.abs(),
            PathSegment::Cubic(points) => {
                let steps = points.windows(2).map(|pair| (pair[1] - pair[0]).norm());
                steps.sum()
            }
        }
    }

    /// Whether all numbers are finite.
    pub fn is_finite(&self) -> bool {
        let finite = |point: &Point2<f64>| point.x.is_finite() && point.y.is_finite();
        match self {
            PathSegment::Line(points) => points.iter().all(finite),
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => finite(centre) && (radius + start + sweep).is_finite() && *radius > 0.0,
            PathSegment::Cubic(points) => points.iter().all(finite),
        }
    }

    /// Points from the start, without the end, whose chords are within `chordal_error` mm (> 0) of the segment.
    pub fn chords(&self, chordal_error: f64) -> impl Iterator<Item = Point2<f64>> {
        let pieces = match *self {
            PathSegment::Line(_) => 1.0,
            // The height of an arc above its chord is 2 r sin²(angle / 4).
            PathSegment::Arc { radius, sweep, .. } => {
                let half_sine = (chordal_error / (2.0 * radius)).sqrt().min(1.0);
                sweep.abs() / (4.0 * half_sine.asin())
            }
            // |P''| Δ²/8, with the greater second derivative of both ends.
            PathSegment::Cubic([a, b, c, d]) => {
                let bends = [(a - b) + (c - b), (b - c) + (d - c)];
                let bend = bends.map(|bend| 6.0 * bend.norm());
                (bend[0].max(bend[1]) / (8.0 * chordal_error)).sqrt()
            }
        };
        let pieces = pieces.ceil().clamp(1.0, MOST_CHORDS) as u32;
        (0..pieces).map(move |i| self.at(f64::from(i) / f64::from(pieces)))
    }
}

/// Ends of neighbouring segments within this share of the outline's length are equal: rounding of decimals in a file.
const CLOSED: f64 = 1e-9;

/// Greatest turn of a curve per chord, rad. Tuned: chords of a fillet stay within 0.05 % of its radius.
const CHORD_TURN: f64 = 0.06;

/// Most chords of one segment in the search for teeth.
const MOST_SEARCH_CHORDS: f64 = 512.0;

/// A segment of the path about its centre, the metal on its left.
#[derive(Debug, Clone)]
pub(super) struct PathPart {
    pub curve: PartCurve,
    /// Parameters of start and end.
    pub ends: [f64; 2],
}

/// A point of the path with its part and parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct PathPoint {
    pub part: usize,
    pub t: f64,
    pub point: Point2<f64>,
}

/// The path, its centre at the origin.
#[derive(Debug, Clone)]
pub(super) struct ClosedPath {
    pub parts: Vec<PathPart>,
    /// Points along the path. Each chord from a point to the next (cyclically) lies on the part of its first point.
    pub marks: Vec<PathPoint>,
}

impl ClosedPath {
    /// The path of `segments` about `centre`: in order, in either direction, each starting at the end of the one before.
    pub fn new(segments: &[PathSegment], centre: Point2<f64>) -> Result<ClosedPath, OutlineError> {
        if let Some(index) = segments.iter().position(|segment| !segment.is_finite()) {
            return Err(OutlineError::NotFinite { index });
        }
        let size = segments.iter().map(PathSegment::length).sum::<f64>();
        // Segments without length are ignored.
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
            // Each ignored segment may have bridged as much.
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
                path.marks.push(PathPoint { part, t, point });
            }
            path.parts.push(PathPart { curve, ends });
        }
        path
    }

    /// The chord from a mark to the next: the parameters of its ends.
    pub fn chord(&self, mark: usize) -> [f64; 2] {
        let PathPoint { part, t, .. } = self.marks[mark];
        match self.marks.get(mark + 1) {
            Some(next) if next.part == part => [t, next.t],
            _ => [t, self.parts[part].ends[1]],
        }
    }

    /// Least and greatest radius of the path, mm.
    pub fn radii(&self) -> (f64, f64) {
        let mut radii = (f64::INFINITY, 0.0f64);
        for chord in 0..self.marks.len() {
            let [from, to] = self.chord(chord);
            let curve = &self.parts[self.marks[chord].part].curve;
            let (least, most) = radius_range(curve, from, to);
            radii = (radii.0.min(least), radii.1.max(most));
        }
        radii
    }

    /// The points as corners of a polygon.
    fn corners(&self) -> Vec<Point2<f64>> {
        self.marks.iter().map(|mark| mark.point).collect()
    }

    /// A point near the crossing of two chords without a common end. Chords are compared if their ranges of x overlap.
    fn crossing(&self) -> Option<Point2<f64>> {
        let count = self.marks.len();
        let ends = |k: usize| [self.marks[k].point, self.marks[(k + 1) % count].point];
        let range = |k: usize, axis: usize| {
            let [a, b] = ends(k).map(|point| point[axis]);
            (a.min(b), a.max(b))
        };
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_cached_key(|&k| rank(range(k, 0).0));
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

/// Least and greatest radius of a curve between two parameters, mm.
fn radius_range(curve: &PartCurve, from: f64, to: f64) -> (f64, f64) {
    let ends = [curve.radius(from), curve.radius(to)];
    let (least, most) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    // A chord of a line ends at the point nearest to the centre.
    if let PartCurve::Line(_) = curve {
        return (least, most);
    }
    // The radius is stationary where the normal is radial: at most once in a short chord.
    let across = |t: f64| {
        let (point, normal) = curve.at(t);
        point.coords.perp(&normal)
    };
    let start = across(from);
    if start * across(to) >= 0.0 {
        return (least, most);
    }
    let [low, high] = bisect(from, to, 0.0, |t| across(t) * start > 0.0);
    let there = curve.radius(0.5 * (low + high));
    (least.min(there), most.max(there))
}

/// Whether two chords cross between their ends.
fn cross([a, b]: [Point2<f64>; 2], [c, d]: [Point2<f64>; 2]) -> bool {
    let side = |from: Point2<f64>, to: Point2<f64>, of: Point2<f64>| (to - from).perp(&(of - from));
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// Parameters at which a part is cut into chords, from its start, without its end. A line is also cut at the point nearest to the centre.
fn cuts(curve: &PartCurve, [from, to]: [f64; 2]) -> Vec<f64> {
    if let PartCurve::Line(_) = curve {
        let (start, normal) = curve.at(from);
        // Along the line, `i n`.
        let foot = from - (start.y * normal.x - start.x * normal.y);
        return if foot > from && foot < to {
            vec![from, foot]
        } else {
            vec![from]
        };
    }
    let (_, half_turn) = curve.spread(from.min(to), from.max(to));
    let count = (2.0 * half_turn / CHORD_TURN)
        .ceil()
        .clamp(1.0, MOST_SEARCH_CHORDS);
    let at = |k: u32| from + (to - from) * f64::from(k) / count;
    (0..count as u32).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: points of the segment itself, 50 to a chord, against the chord between the points on both sides of them.
    #[test]
    fn chords_of_arcs_and_cubics_are_within_their_error() {
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, -1.0], [4.0, 1.0]];
        let arc = |sweep| PathSegment::Arc {
            centre: Point2::new(1.0, -2.0),
            radius: 5.0,
            start: 0.3,
            sweep,
        };
        let cubic = PathSegment::Cubic(points.map(Point2::from));
        for (part, least_share) in [(arc(2.9), 0.9), (arc(-0.7), 0.9), (cubic, 0.5)] {
            for error in [1e-1, 1e-3, 1e-6] {
                let mut points: Vec<Point2<f64>> = part.chords(error).collect();
                assert_eq!(points[0], part.start());
                points.push(part.end());
                let count = points.len() - 1;
                let mut most: f64 = 0.0;
                for i in 0..50 * count {
                    let at = part.at(i as f64 / (50 * count) as f64);
                    let chord = points[i / 50 + 1] - points[i / 50];
                    most = most.max((at - points[i / 50]).perp(&chord).abs() / chord.norm());
                }
                assert!(most <= error * (1.0 + 1e-6), "{most} of {error}");
                assert!(
                    most > least_share * error || count < 20,
                    "{most} of {error}"
                );
            }
        }
    }
}

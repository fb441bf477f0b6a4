//! Outlines moved along their normals, as a kerf, a nozzle or a burn moves them.
//!
//! A region that is moved out by `d` gains the points within `d` of it. A region that is moved in by `d` keeps the points that are
//! more than `d` from its outside. Lines stay lines, and arcs stay arcs. A corner on the growing side becomes an arc of radius `d`. Other
//! joints are trimmed. Parts that are too small vanish. `cavalier_contours` does this for paths of lines and arcs. Cubic curves are
//! replaced by arcs first.
//!
//! Both operations preserve the distance of two regions: a path within `ε` of another is within `ε` of it when both are moved.

use super::path::PathSegment;
use crate::gear::{Cubic, PartCurve};
use crate::numeric::bisect;
use cavalier_contours::polyline::{
    PlineOffsetOptions, PlineSource, PlineSourceMut, PlineVertex, Polyline,
    seg_arc_radius_and_center,
};
use nalgebra::{Point2, Vector2};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Greatest distance of a cubic curve from the arcs in its place, mm. Four flanks of two gears leave 0.01 µm open, of the 0.05 µm within which
/// extremes are proven.
const ARCS: f64 = 2e-6;

/// Positions nearer than this are one, mm: above the rounding of most drawings, a tenth of what results show.
const SAME: f64 = 1e-7;

/// The closed path of `segments` about the origin moved out by `by`, mm (negative: in), and the error that it adds, mm. `None` if not exactly
/// one path remains.
pub(super) fn offset_path(segments: &[PathSegment], by: f64) -> Option<(Vec<PathSegment>, f64)> {
    if by == 0.0 {
        return Some((segments.to_vec(), 0.0));
    }
    let mut path = Polyline::new_closed();
    let mut error = 0.0f64;
    for segment in segments {
        match *segment {
            PathSegment::Line([start, _]) => path.add(start.x, start.y, 0.0),
            PathSegment::Arc { sweep, .. } => {
                let parts = (sweep.abs() / FRAC_PI_2).ceil().max(1.0);
                for k in 0..parts as u32 {
                    let start = segment.at(f64::from(k) / parts);
                    path.add(start.x, start.y, (0.25 * sweep / parts).tan());
                }
            }
            PathSegment::Cubic(points) => error = error.max(add_arcs(&mut path, points)),
        }
    }
    let path = path.remove_repeat_pos(SAME).unwrap_or(path);
    // Positive is to the left.
    let left = if path.area() > 0.0 { -by } else { by };
    let options = PlineOffsetOptions {
        pos_equal_eps: SAME,
        offset_dist_eps: SAME,
        ..PlineOffsetOptions::default()
    };
    match &path.parallel_offset_opt(left, &options)[..] {
        [moved] => Some((
            moved.iter_segments().map(segment_of).collect(),
            error + SAME,
        )),
        _ => None,
    }
}

/// The segment from a vertex to the next.
fn segment_of((from, to): (PlineVertex<f64>, PlineVertex<f64>)) -> PathSegment {
    let point = |vertex: &PlineVertex<f64>| Point2::new(vertex.x, vertex.y);
    if from.bulge_is_zero() {
        return PathSegment::Line([point(&from), point(&to)]);
    }
    let (radius, centre) = seg_arc_radius_and_center(from, to);
    let mut centre = Point2::new(centre.x, centre.y);
    // Lands stay arcs about the centre of the gear.
    if centre.coords.norm() < SAME {
        centre = Point2::origin();
    }
    let start = point(&from) - centre;
    PathSegment::Arc {
        centre,
        radius,
        start: start.y.atan2(start.x).rem_euclid(TAU),
        sweep: 4.0 * from.bulge.atan(),
    }
}

/// Adds two arcs in place of a cubic curve, or of each half of it, and so on. Returns their greatest distance from it, mm.
fn add_arcs(path: &mut Polyline, points: [Point2<f64>; 4]) -> f64 {
    let [start, .., end] = points;
    let size = points.map(|point| (point - start).norm());
    let size = size.into_iter().fold(0.0, f64::max);
    if size < ARCS {
        path.add(start.x, start.y, 0.0);
        return size;
    }
    let curve = PartCurve::Cubic(Cubic::new(points));
    let along = [0.0, 1.0].map(|t| {
        let normal = curve.normal(t);
        Vector2::new(-normal.y, normal.x)
    });
    // The joint of two arcs whose tangents at the ends are those of the curve and have one length `reach` to the joint's tangent:
    // `chord² = 2 reach chord · (along_0 + along_1) + 2 reach² (1 − along_0 · along_1)`.
    let chord = end - start;
    let sum = chord.dot(&(along[0] + along[1]));
    let bent = 2.0 * (1.0 - along[0].dot(&along[1]));
    let reach = chord.norm_squared() / (sum + (sum * sum + bent * chord.norm_squared()).sqrt());
    let joint = start + (chord + (along[0] - along[1]) * reach) * 0.5;
    // The tangent there; the curve is divided where it passes the normal.
    let across = chord - (along[0] + along[1]) * reach;
    let [passes, _] = bisect(0.0, 1.0, 0.0, |t| {
        (curve.point(t) - joint).dot(&across) < 0.0
    });
    let [before, [a, b, c, d]] = divided(points, passes);
    let arcs = [
        FittedArc::new(start, along[0], joint),
        FittedArc::new(end, -along[1], joint),
    ];
    let error = arcs[0].distance(before).max(arcs[1].distance([d, c, b, a]));
    if sum > 0.0 && error <= ARCS {
        path.add(start.x, start.y, arcs[0].bulge);
        path.add(joint.x, joint.y, -arcs[1].bulge);
        return error;
    }
    let halves = divided(points, 0.5).map(|half| add_arcs(path, half));
    halves[0].max(halves[1])
}

/// The control points of a cubic curve before and after a parameter (de Casteljau).
fn divided([a, b, c, d]: [Point2<f64>; 4], t: f64) -> [[Point2<f64>; 4]; 2] {
    let mix = |from: Point2<f64>, to: Point2<f64>| from + (to - from) * t;
    let (e, f, g) = (mix(a, b), mix(b, c), mix(c, d));
    let (h, i) = (mix(e, f), mix(f, g));
    let at = mix(h, i);
    [[a, e, h, at], [at, i, g, d]]
}

/// An arc from a point, with its tangent there, to another point.
struct FittedArc {
    start: Point2<f64>,
    /// The unit normal at the start, to the left.
    normal: Vector2<f64>,
    /// 1/mm, positive to the left.
    curvature: f64,
    /// Tangent of a quarter of its angle.
    bulge: f64,
}

impl FittedArc {
    fn new(start: Point2<f64>, along: Vector2<f64>, end: Point2<f64>) -> FittedArc {
        let chord = end - start;
        let turn = along.perp(&chord);
        FittedArc {
            start,
            normal: Vector2::new(-along.y, along.x),
            curvature: 2.0 * turn / chord.norm_squared(),
            bulge: (0.5 * turn.atan2(along.dot(&chord))).tan(),
        }
    }

    /// An upper bound of the distance of a cubic curve, which starts at the same point, from the circle of this arc, mm.
    ///
    /// `F = n · v − κ/2 v²` of `v` from the start is 0 on the circle. Twice `F` is `(ρ² − r²)/r`, so the distance `|ρ − r|` is at most `2 |F|`,
    /// and with that at most `|F| / (1 − |κ F|)`. On the curve `F` has degree 6 and lies between its Bernstein coefficients.
    fn distance(&self, points: [Point2<f64>; 4]) -> f64 {
        const CHOOSE_3: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
        const CHOOSE_6: [f64; 7] = [1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0];
        let from_start = points.map(|point| point - self.start);
        let mut coefficients = [0.0; 7];
        for (i, u) in from_start.iter().enumerate() {
            for (j, v) in from_start.iter().enumerate() {
                let form = self.normal.dot(&(u + v)) - self.curvature * u.dot(v);
                coefficients[i + j] += 0.5 * CHOOSE_3[i] * CHOOSE_3[j] / CHOOSE_6[i + j] * form;
            }
        }
        let most = coefficients.iter().map(|f| f.abs()).fold(0.0, f64::max);
        let share = self.curvature.abs() * most;
        if share < 1.0 {
            most / (1.0 - share)
        } else {
            f64::INFINITY
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::polygon::Boundary;
    use super::*;

    /// Three lobes of cubic curves, with inflections: every point moved along its normal lies on the moved path, within the bound. Source: a polygon of
    /// its chords.
    #[test]
    fn cubic_curves_are_followed_within_the_bound() {
        let at = |k: u32| {
            let (sin, cos) = (f64::from(k) * TAU / 6.0).sin_cos();
            let radius = if k.is_multiple_of(2) { 14.0 } else { 10.0 };
            Point2::new(radius * cos, radius * sin)
        };
        // Tangents across the radius.
        let across = |at: Point2<f64>, by: f64| at + Vector2::new(-at.y, at.x) * by;
        let curve = |k: u32| {
            let (from, to) = (at(k), at(k + 1));
            PathSegment::Cubic([from, across(from, 0.3), across(to, -0.3), to])
        };
        let path: Vec<PathSegment> = (0..6).map(curve).collect();
        for by in [0.3, -0.3] {
            let (moved, error) = offset_path(&path, by).unwrap();
            assert!((1e-7..=ARCS + SAME).contains(&error), "{error}");
            assert!(moved.len() < 900, "{}", moved.len());
            let chords = moved.iter().flat_map(|segment| segment.chords(1e-7));
            let boundary = Boundary::new(chords.collect());
            for (segment, k) in path.iter().flat_map(|s| (0..=200).map(move |k| (s, k))) {
                let (point, normal) = segment.part().0.at(f64::from(k) / 200.0);
                let off = boundary.nearest(point + normal * by).signed;
                assert!(off.abs() <= error + 1e-7, "{by} {k}: {off}");
            }
        }
    }

    /// A cubic curve that runs back on itself, and one shorter than the tolerance, end in lines.
    #[test]
    fn a_cusp_ends() {
        let cusp = [[0.0, 0.0], [1.0, 0.0], [0.0, 1e-3], [1e-3, 1.0]].map(Point2::from);
        let mut path = Polyline::new_closed();
        assert!(add_arcs(&mut path, cusp) <= ARCS);
        assert!(path.vertex_count() < 300, "{}", path.vertex_count());
        let short = cusp.map(|point| point * 1e-6);
        assert!(add_arcs(&mut path, short) < ARCS);
    }
}

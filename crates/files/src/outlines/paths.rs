//! Which of the closed paths of a drawing is the gear.

use crate::drawing::{Drawing, Loop};
use crate::numbers::ascii;
use gearlash::outline::{PathSegment, polygon};
use nalgebra::Point2;

/// The outline of a drawing among its loops.
pub(super) struct Path {
    pub outline: Loop,
    pub inside: Vec<Loop>,
    /// Length of a unit of the drawing, mm.
    pub unit_mm: f64,
    pub remarks: Vec<String>,
}

/// Points of a path, so many of each segment.
fn corners(path: &Loop, each: u32) -> Vec<Point2<f64>> {
    let points = |segment: &PathSegment| {
        let segment = *segment;
        (0..each).map(move |k| segment.at(f64::from(k) / f64::from(each)))
    };
    path.segments.iter().flat_map(points).collect()
}

/// The loop that holds all others.
pub(super) fn outermost(drawing: Drawing) -> Result<Path, String> {
    let sized = |path: Loop| (polygon::area(&corners(&path, 2)).abs(), path);
    let mut loops: Vec<(f64, Loop)> = drawing.loops.into_iter().map(sized).collect();
    loops.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut loops = loops.into_iter().map(|(_, path)| path);
    let Some(outline) = loops.next() else {
        return Err("holds no closed path".to_owned());
    };
    let inside: Vec<Loop> = loops.collect();
    if let Some(beside) = inside.iter().find(|path| !holds(&outline, path)) {
        let at = |path: &Loop| {
            let point = path
                .segments
                .first()
                .map_or(Point2::origin(), PathSegment::start);
            format!("{} ({})", coordinates(&point), path.place)
        };
        return Err(format!(
            "holds several closed paths side by side: one from {}, another from {}",
            at(&outline),
            at(beside)
        ));
    }
    let (unit_mm, mut remarks) = (drawing.unit_mm, drawing.remarks);
    if !inside.is_empty() {
        remarks.push(format!(
            "closed paths inside that are not its outline: {}",
            inside.len()
        ));
    }
    Ok(Path {
        outline,
        inside,
        unit_mm,
        remarks,
    })
}

/// Whether the outer path winds round a point of the inner one.
fn holds(outer: &Loop, inner: &Loop) -> bool {
    let Some(point) = inner.segments.first().map(PathSegment::start) else {
        return true;
    };
    polygon::winding(&corners(outer, 8), point) != 0
}

/// The centre of a path that is one circle.
pub(super) fn whole_circle(path: &Loop) -> Option<Point2<f64>> {
    let mut centres = path.segments.iter().map(|segment| match segment {
        PathSegment::Arc { centre, radius, .. } => Some((*centre, *radius)),
        _ => None,
    });
    let (first, radius) = centres.next()??;
    // As the same circle is printed twice.
    let same = |found: Option<(Point2<f64>, f64)>| {
        found.is_some_and(|(centre, other)| {
            (centre - first).norm() <= 1e-6 * radius && (other - radius).abs() <= 1e-6 * radius
        })
    };
    centres.all(same).then_some(first)
}

/// A place of a drawing, mm.
pub(super) fn coordinates(point: &Point2<f64>) -> String {
    // As messages of faults have them, to be copied into a file.
    format!("({}, {})", ascii(point.x, 4), ascii(point.y, 4))
}

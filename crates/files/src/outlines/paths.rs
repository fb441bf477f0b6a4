//! Which of the closed paths of a drawing is the gear.

use crate::drawing::{Drawing, Loop};
use gearlash::outline::PathSegment;
use nalgebra::Point2;
use std::f64::consts::TAU;

/// The outline of a drawing among its loops.
pub(super) struct Path {
    pub outline: Loop,
    pub inside: Vec<Loop>,
    pub remarks: Vec<String>,
}

/// Twice the area a path encloses, by its ends and middles, mm²; without sign.
fn size(path: &Loop) -> f64 {
    let points: Vec<Point2<f64>> = path
        .segments
        .iter()
        .flat_map(|segment| [segment.start(), segment.at(0.5)])
        .collect();
    let next = points.iter().cycle().skip(1);
    let sum: f64 = points
        .iter()
        .zip(next)
        .map(|(a, b)| a.coords.perp(&b.coords))
        .sum();
    sum.abs()
}

/// The loop that holds all others.
pub(super) fn outermost(drawing: Drawing) -> Result<Path, String> {
    let mut loops = drawing.loops;
    loops.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let mut loops = loops.into_iter();
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
            format!("({:.4}, {:.4}) ({})", point.x, point.y, path.place)
        };
        return Err(format!(
            "holds several closed paths side by side: one from {}, another from {}",
            at(&outline),
            at(beside)
        ));
    }
    let mut remarks = drawing.remarks;
    if !inside.is_empty() {
        remarks.push(format!(
            "closed paths inside that are not its outline: {}",
            inside.len()
        ));
    }
    Ok(Path {
        outline,
        inside,
        remarks,
    })
}

/// Whether the outer path winds round a point of the inner one.
fn holds(outer: &Loop, inner: &Loop) -> bool {
    let Some(point) = inner.segments.first().map(PathSegment::start) else {
        return true;
    };
    let mut turns = 0.0;
    for segment in &outer.segments {
        for step in 0..8 {
            let [from, to] = [step, step + 1].map(|step| segment.at(f64::from(step) / 8.0) - point);
            turns += from.perp(&to).atan2(from.dot(&to));
        }
    }
    (turns / TAU).round() != 0.0
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

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

/// Which of several outlines of a drawing is the gear.
#[derive(Debug, Clone, Copy)]
pub(super) enum Choice {
    /// By its number, from 1 in the order of the file.
    Number(u32),
    /// The one round a point of the drawing, mm.
    At(Point2<f64>),
    /// The only one, or the one round the centre, mm, where that is stated.
    Centre(Option<Point2<f64>>),
}

/// The outline of a drawing by `choice`, with the paths inside it.
pub(super) fn chosen(drawing: Drawing, choice: Choice) -> Result<Path, String> {
    let (loops, unit_mm, mut remarks) = (drawing.loops, drawing.unit_mm, drawing.remarks);
    let outlines = outlines(&loops);
    let round = |point: Point2<f64>| {
        let mut round = outlines
            .iter()
            .filter(|&&one| winds_round(&loops[one], point));
        round.next().copied()
    };
    let listed = || list(&loops, &outlines);
    let outline = match (choice, &outlines[..]) {
        (_, []) => return Err("holds no closed path".to_owned()),
        (Choice::Number(number), _) => {
            let one = outlines.get(number as usize - 1);
            *one.ok_or_else(|| format!("has no outline {number}: {}", listed()))?
        }
        (Choice::At(point), _) => round(point)
            .ok_or_else(|| format!("has no outline round {}: {}", coordinates(&point), listed()))?,
        (Choice::Centre(_), [one]) => *one,
        (Choice::Centre(centre), _) => centre
            .and_then(round)
            .ok_or_else(|| format!("holds several outlines side by side: {}", listed()))?,
    };
    if let (position, true) = (
        outlines.iter().position(|&one| one == outline),
        outlines.len() > 1,
    ) {
        remarks.push(format!(
            "outline {} of {} is read, from {} ({})",
            position.unwrap_or_default() + 1,
            outlines.len(),
            start(&loops[outline]),
            loops[outline].place
        ));
    }
    let inside: Vec<Loop> = (0..loops.len())
        .filter(|&one| one != outline && !outlines.contains(&one))
        .filter(|&one| holds(&loops[outline], &loops[one]))
        .map(|one| loops[one].clone())
        .collect();
    if !inside.is_empty() {
        remarks.push(format!(
            "closed paths inside that are not its outline: {}",
            inside.len()
        ));
    }
    Ok(Path {
        outline: loops[outline].clone(),
        inside,
        unit_mm,
        remarks,
    })
}

/// The closed paths that lie inside no other, in the order of the file.
pub(super) fn outlines(loops: &[Loop]) -> Vec<usize> {
    let areas: Vec<f64> = loops.iter().map(area).collect();
    let is_inside = |inner: usize| {
        let mut others = (0..loops.len()).filter(|&other| areas[other] > areas[inner]);
        others.any(|other| holds(&loops[other], &loops[inner]))
    };
    (0..loops.len()).filter(|&one| !is_inside(one)).collect()
}

/// Outlines by number and place, a few of them.
fn list(loops: &[Loop], outlines: &[usize]) -> String {
    const FEW: usize = 6;
    let named = outlines.iter().take(FEW).enumerate().map(|(index, &one)| {
        let path = &loops[one];
        format!("{} from {} ({})", index + 1, start(path), path.place)
    });
    let named: Vec<String> = named.collect();
    let more = match outlines.len() {
        count if count > FEW => format!(" and {} more", count - FEW),
        _ => String::new(),
    };
    format!("{}{more}", named.join(", "))
}

/// Where a path begins.
pub(super) fn start(path: &Loop) -> String {
    let first = path.segments.first();
    coordinates(&first.map_or(Point2::origin(), PathSegment::start))
}

/// Area of a path by a polygon of its points, mm².
pub(super) fn area(path: &Loop) -> f64 {
    polygon::area(&corners(path, 2)).abs()
}

/// Whether the outer path winds round a point of the inner one.
pub(super) fn holds(outer: &Loop, inner: &Loop) -> bool {
    let Some(point) = inner.segments.first().map(PathSegment::start) else {
        return true;
    };
    winds_round(outer, point)
}

/// Whether a path winds round a point.
fn winds_round(path: &Loop, point: Point2<f64>) -> bool {
    polygon::winding(&corners(path, 8), point) != 0
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

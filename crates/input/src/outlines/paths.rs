//! Selects the gear among the closed paths of a drawing.

use gearlash::outline::{PathSegment, polygon};
use gearlash_drawing::{Drawing, DrawnPath, JOIN_MM};
use gearlash_text::characters::first_of;
use gearlash_text::numbers::ascii;
use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// The outline of a gear, chosen among the paths of a drawing.
pub(super) struct ChosenOutline {
    pub path: DrawnPath,
    /// Number of closed paths inside it.
    pub inside: usize,
    /// Centres of circles inside it.
    pub centres: Vec<Point2<f64>>,
    /// Length of a unit of the drawing, mm.
    pub unit_mm: f64,
    pub remarks: Vec<String>,
}

/// Points of a path, `each` per segment.
fn corners(path: &DrawnPath, each: u32) -> Vec<Point2<f64>> {
    let points = |segment: &PathSegment| {
        let segment = *segment;
        (0..each).map(move |k| segment.at(f64::from(k) / f64::from(each)))
    };
    path.segments.iter().flat_map(points).collect()
}

/// How the gear is selected among several outlines.
#[derive(Debug, Clone, Copy)]
pub(super) enum Choice {
    /// By its number, from 1 in the order of the file.
    Number(u32),
    /// The one that encloses a point of the drawing, mm.
    At(Point2<f64>),
    /// The only one, or the one that encloses the centre, mm, where that is stated.
    Centre(Option<Point2<f64>>),
}

/// Most outlines of a drawing: each path is compared with all of them.
const MAX_OUTLINES: usize = 10_000;

/// A closed path that lies inside no other.
pub(super) struct Outline {
    /// Its index among the paths of the drawing.
    pub index: usize,
    pub inside: Vec<usize>,
    /// Least and greatest coordinates of its points, mm.
    pub ends: [Point2<f64>; 2],
    /// Whether it is no gear, but a frame where others are inside.
    is_frame: bool,
    area: f64,
    corners: Vec<Point2<f64>>,
}

impl Outline {
    fn new(index: usize, area: f64, path: &DrawnPath) -> Outline {
        let corners = corners(path, 8);
        let far = Point2::new(f64::INFINITY, f64::INFINITY);
        let ends = corners.iter().fold([far, -far], |[low, high], corner| {
            [low.inf(corner), high.sup(corner)]
        });
        Outline {
            index,
            inside: Vec::new(),
            ends,
            is_frame: is_convex(&corners, ends) && !is_round(&corners, ends),
            area,
            corners,
        }
    }

    fn winds_round(&self, point: Point2<f64>) -> bool {
        let [low, high] = self.ends;
        low <= point && point <= high && polygon::winding(&self.corners, point) != 0
    }
}

/// Whether a closed path turns by little more than a whole turn. A gear turns back by a quarter turn and more in each of its spaces.
fn is_convex(corners: &[Point2<f64>], [low, high]: [Point2<f64>; 2]) -> bool {
    let steps = corners.iter().zip(corners.iter().cycle().skip(1));
    let steps = steps.map(|(from, to)| to - from);
    // Shorter ones are rounding.
    let least = 1e-6 * (high - low).norm();
    let steps: Vec<Vector2<f64>> = steps.filter(|step| step.norm() > least).collect();
    let next = steps.iter().cycle().skip(1);
    let turns = steps.iter().zip(next).map(|(a, b)| a.angle(b));
    turns.sum::<f64>() < 1.25 * TAU
}

/// Whether a path is nearly a circle, as the rim of a ring gear is.
fn is_round(corners: &[Point2<f64>], [low, high]: [Point2<f64>; 2]) -> bool {
    let radii = corners
        .iter()
        .map(|corner| (corner - nalgebra::center(&low, &high)).norm());
    let (near, far) = radii.fold((f64::INFINITY, 0.0_f64), |(near, far), radius| {
        (near.min(radius), far.max(radius))
    });
    near > 0.95 * far
}

/// The outlines of a drawing, in the order of the file. A frame round others is left out, and `remarks` count it.
pub(super) fn outlines(
    loops: &[DrawnPath],
    remarks: &mut Vec<String>,
) -> Result<Vec<Outline>, String> {
    let areas = loops
        .iter()
        .map(|path| polygon::area(&corners(path, 2)).abs());
    let mut by_area: Vec<(usize, f64)> = areas.enumerate().collect();
    // The largest first. Numbers that are not negative have the order of their bits.
    by_area.sort_by_cached_key(|(_, area)| !area.to_bits());
    let mut outlines: Vec<Outline> = Vec::new();
    let mut frames = 0;
    for (index, area) in by_area {
        let path = &loops[index];
        let first = path.segments.first().map(PathSegment::start);
        let holds = |outline: &Outline| {
            outline.area > area && first.is_some_and(|first| outline.winds_round(first))
        };
        let mut outer = outlines.iter().position(holds);
        while let Some(frame) = outer.filter(|&outer| outlines[outer].is_frame) {
            outlines.remove(frame);
            frames += 1;
            outer = outlines.iter().position(holds);
        }
        match outer {
            Some(outer) => outlines[outer].inside.push(index),
            None if outlines.len() == MAX_OUTLINES => {
                return Err(format!("holds more than {MAX_OUTLINES} outlines"));
            }
            None => outlines.push(Outline::new(index, area, path)),
        }
    }
    if frames > 0 {
        remarks.push(format!("frames without teeth that are not read: {frames}"));
    }
    outlines.sort_by_cached_key(|outline| outline.index as u64);
    Ok(outlines)
}

/// The outline of a drawing by `choice`, with the paths inside it.
pub(super) fn choose(drawing: Drawing, choice: Choice) -> Result<ChosenOutline, String> {
    let (loops, unit_mm, mut remarks) = (drawing.loops, drawing.unit_mm, drawing.remarks);
    let outlines = outlines(&loops, &mut remarks)?;
    let round = |point: Point2<f64>| outlines.iter().position(|one| one.winds_round(point));
    let listed = || list(&loops, &outlines);
    let index = match choice {
        _ if outlines.is_empty() => return Err("holds no closed path".to_owned()),
        Choice::Number(number) => {
            let index = number as usize - 1;
            let index = (index < outlines.len()).then_some(index);
            index.ok_or_else(|| format!("has no outline {number}: {}", listed()))?
        }
        Choice::At(point) => round(point)
            .ok_or_else(|| format!("has no outline round {}: {}", coordinates(&point), listed()))?,
        Choice::Centre(_) if outlines.len() == 1 => 0,
        Choice::Centre(centre) => centre
            .and_then(round)
            .ok_or_else(|| format!("holds several outlines side by side: {}", listed()))?,
    };
    let chosen = &outlines[index];
    let outline = loops[chosen.index].clone();
    if outline.circle().is_some() {
        let place = &outline.place;
        return Err(format!(
            "has no teeth on its outline {}, a circle ({place})",
            index + 1
        ));
    }
    if outlines.len() > 1 {
        remarks.push(format!(
            "outline {} of {} is read, from {} ({})",
            index + 1,
            outlines.len(),
            start(&outline),
            outline.place
        ));
    }
    if !chosen.inside.is_empty() {
        remarks.push(format!(
            "closed paths inside that are not its outline: {}",
            chosen.inside.len()
        ));
    }
    let circles = chosen.inside.iter().map(|&one| &loops[one]);
    Ok(ChosenOutline {
        centres: centres_inside(&outline, circles),
        inside: chosen.inside.len(),
        path: outline,
        unit_mm,
        remarks,
    })
}

/// Outlines by number and place, at most a few.
fn list(loops: &[DrawnPath], outlines: &[Outline]) -> String {
    const FEW: usize = 6;
    let named = outlines.iter().enumerate().map(|(index, one)| {
        let path = &loops[one.index];
        format!("{} from {} ({})", index + 1, start(path), path.place)
    });
    first_of(named, FEW)
}

/// The start of a path, in words.
pub(super) fn start(path: &DrawnPath) -> String {
    let first = path.segments.first();
    coordinates(&first.map_or(Point2::origin(), PathSegment::start))
}

/// The centres of the circles among `loops` whose centre is inside `outline`; those nearer than [`JOIN_MM`] are one.
pub(super) fn centres_inside<'a>(
    outline: &DrawnPath,
    loops: impl IntoIterator<Item = &'a DrawnPath>,
) -> Vec<Point2<f64>> {
    let mut centres: Vec<Point2<f64>> = Vec::new();
    for centre in loops.into_iter().filter_map(DrawnPath::circle) {
        let is_new = |other: &Point2<f64>| (other - centre).norm() > JOIN_MM;
        if centres.iter().all(is_new) {
            centres.push(centre);
        }
    }
    if !centres.is_empty() {
        let corners = corners(outline, 8);
        centres.retain(|centre| polygon::winding(&corners, *centre) != 0);
    }
    centres
}

/// A place of a drawing, mm.
pub(super) fn coordinates(point: &Point2<f64>) -> String {
    // In the format of error messages, so that users can copy them into a file.
    format!("({}, {})", ascii(point.x, 4), ascii(point.y, 4))
}

//! The teeth of a closed path, found by its radius, and their halves.
//!
//! A tooth is a stretch that rises from the lower third of the depth into the upper third and falls back. Its tip region lies within a
//! twentieth of the depth of its top; a root region likewise. A half tooth runs from the far end of the tip region to the middle,
//! along the path, of the root region. It contains the whole tip land, because its far end may touch a mate.

use super::half::{HalfOutline, HalfPiece};
use super::path::{ClosedPath, PathPart};
use crate::error::OutlineError;
use crate::gear::Side;
use crate::numeric::bisect;
use nalgebra::{Complex, Point2};

/// Share of the depth of a tip or root region.
const REGION_SHARE: f64 = 0.05;

/// Share of the depth in which a contact counts as on the tip or root.
const TIP_OR_ROOT_SHARE: f64 = 0.01;

/// Least turn of an edge, rad. Tuned: decimals of a file turn tangent curves by less.
const LEAST_EDGE_TURN: f64 = 1e-6;

/// A tooth's two halves, in the frame of the path.
#[derive(Debug)]
pub(super) struct FoundTooth {
    /// The middle of its tip region, mm.
    pub tip: Point2<f64>,
    pub halves: [HalfOutline; 2],
}

/// A place on the path: chord and parameter.
#[derive(Debug, Clone, Copy)]
struct Place {
    chord: usize,
    t: f64,
}

/// The teeth of `path`, counter-clockwise.
pub(super) fn find_teeth(path: &ClosedPath) -> Result<Vec<FoundTooth>, OutlineError> {
    let radii = path.marks.iter().map(|mark| mark.point.coords.norm());
    let radii: Vec<f64> = radii.collect();
    let least = radii.iter().copied().fold(f64::INFINITY, f64::min);
    let most = radii.iter().copied().fold(0.0, f64::max);
    let third = (most - least) / 3.0;
    let start = radii.iter().position(|&radius| radius == least);
    let start = start.unwrap_or(0);
    let count = radii.len();
    // Runs below and above alternate, the first one below.
    let mut runs: Vec<Vec<usize>> = vec![vec![]];
    for k in (start..start + count).map(|k| k % count) {
        let above = runs.len().is_multiple_of(2);
        let changes = if above {
            radii[k] <= least + third
        } else {
            radii[k] >= most - third
        };
        if changes {
            runs.push(vec![]);
        }
        if let Some(run) = runs.last_mut() {
            run.push(k);
        }
    }
    // The path ends as it started, below.
    if !runs.len().is_multiple_of(2)
        && runs.len() > 1
        && let Some(last) = runs.pop()
    {
        runs[0] = [last, std::mem::take(&mut runs[0])].concat();
    }
    let found = runs.len() / 2;
    if found < 3 || third <= 0.0 {
        return Err(OutlineError::TooFewTeeth {
            found: if third > 0.0 { found } else { 0 },
            root_diameter_mm: 2.0 * least,
            tip_diameter_mm: 2.0 * most,
        });
    }
    let path_radii = PathRadii { path, radii };
    let region = |(k, run): (usize, &Vec<usize>)| {
        path_radii.region(run, k % 2 == 1, REGION_SHARE * 3.0 * third)
    };
    let regions: Vec<Region> = runs.iter().enumerate().map(region).collect();
    let region = |k: usize| &regions[k % regions.len()];
    let tips = (1..regions.len()).step_by(2);
    let teeth = tips.map(|tip| path_radii.tooth(region(tip - 1), region(tip), region(tip + 1)));
    Ok(teeth.collect())
}

/// A tip or a root region.
#[derive(Debug)]
struct Region {
    from: Place,
    to: Place,
    middle: Place,
    /// Radius from which a contact counts as in the region, mm.
    limit: f64,
}

struct PathRadii<'a> {
    path: &'a ClosedPath,
    radii: Vec<f64>,
}

impl PathRadii<'_> {
    fn region(&self, run: &[usize], is_tip: bool, height: f64) -> Region {
        let sign = if is_tip { 1.0 } else { -1.0 };
        let heights = run.iter().map(|&k| sign * self.radii[k]);
        let top = heights.fold(f64::NEG_INFINITY, f64::max);
        let limit = sign * (top - height);
        let inside = |k: &&usize| sign * self.radii[**k] >= sign * limit;
        let first = run.iter().find(inside).copied().unwrap_or(run[0]);
        let last = run.iter().rev().find(inside).copied().unwrap_or(run[0]);
        let count = self.radii.len();
        let from = self.passes((first + count - 1) % count, limit);
        let to = self.passes(last, limit);
        Region {
            middle: self.halfway(from, to),
            from,
            to,
            limit: sign * (top - TIP_OR_ROOT_SHARE / REGION_SHARE * height),
        }
    }

    /// The place where a chord passes `radius`, which lies between the radii of its ends.
    fn passes(&self, chord: usize, radius: f64) -> Place {
        let [from, to] = self.path.chord(chord);
        let curve = &self.path.parts[self.path.marks[chord].part].curve;
        let beyond = |t: f64| curve.radius(t) >= radius;
        let start = beyond(from);
        let [t, _] = bisect(from, to, 0.0, |t| beyond(t) == start);
        Place { chord, t }
    }

    /// The stretches of chords from one place to another, counter-clockwise: chord and parameters.
    fn stretches(&self, from: Place, to: Place) -> Vec<(usize, [f64; 2])> {
        let count = self.radii.len();
        let steps = (to.chord + count - from.chord) % count;
        let stretch = |step: usize| {
            let chord = (from.chord + step) % count;
            let [mut start, mut end] = self.path.chord(chord);
            if step == 0 {
                start = from.t;
            }
            if step == steps {
                end = to.t;
            }
            (chord, [start, end])
        };
        (0..=steps).map(stretch).collect()
    }

    /// The place halfway along the path's chords.
    fn halfway(&self, from: Place, to: Place) -> Place {
        let stretches = self.stretches(from, to);
        let length = |&(chord, [start, end]): &(usize, [f64; 2])| {
            let curve = &self.path.parts[self.path.marks[chord].part].curve;
            (curve.point(end) - curve.point(start)).norm()
        };
        let mut to_go = 0.5 * stretches.iter().map(length).sum::<f64>();
        for stretch in &stretches {
            let there = length(stretch);
            let &(chord, [start, end]) = stretch;
            if to_go <= there && there > 0.0 {
                let t = start + (end - start) * to_go / there;
                return Place { chord, t };
            }
            to_go -= there;
        }
        from
    }

    fn tooth(&self, before: &Region, tip: &Region, after: &Region) -> FoundTooth {
        let halves = Side::BOTH.map(|side| {
            let (from, to, root) = match side {
                Side::Right => (before.middle, tip.to, before),
                Side::Left => (tip.from, after.middle, after),
            };
            let mut pieces: Vec<HalfPiece> = Vec::new();
            let mut last = None;
            for (chord, [start, end]) in self.stretches(from, to) {
                if start == end {
                    continue;
                }
                let part = self.path.marks[chord].part;
                match pieces.last_mut().filter(|_| last == Some(part)) {
                    Some(piece) => piece.ends[1] = end,
                    None => pieces.push(piece(&self.path.parts[part], [start, end], side)),
                }
                last = Some(part);
            }
            if side == Side::Right {
                pieces.reverse();
                for piece in &mut pieces {
                    piece.ends.reverse();
                }
            }
            let mut half = HalfOutline {
                pieces,
                tip_limit: tip.limit,
                root_limit: root.limit,
            };
            half.mark_corners(LEAST_EDGE_TURN);
            half
        });
        let Place { chord, t } = tip.middle;
        let top = &self.path.parts[self.path.marks[chord].part].curve;
        FoundTooth {
            tip: top.point(t),
            halves,
        }
    }
}

fn piece(part: &PathPart, ends: [f64; 2], side: Side) -> HalfPiece {
    HalfPiece {
        curve: part.curve.clone(),
        ends,
        turn: Complex::ONE,
        mirrored: side == Side::Left,
        corners: [false; 2],
    }
}

//! All pieces of a file, and the loops that they form.

use super::chain::{Chains, DrawnPath, Open, chain};
use super::error::{LONGEST_NAME, at};
use super::limits::{FARTHEST_MM, MAX_NAMED, MAX_SEGMENTS};
use super::{DrawingError, Options};
use gearlash::outline::PathSegment;
use gearlash_text::characters::cut;
use indexmap::IndexMap;
use nalgebra::Point2;
use std::collections::HashSet;

/// Ends nearer than this part of a path's length are the ends of a gap (tuned: a dashed line has gaps of half a dash and is a helper line).
const GAP: f64 = 0.25;
/// Open paths beside an outline that are compared with each other.
const MAX_HELPERS: usize = 2000;

/// The content of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// Length of one of its units, mm.
    pub unit_mm: f64,
    /// At least one, in the order of the file.
    pub loops: Vec<DrawnPath>,
    /// Ignored elements, and why.
    pub remarks: Vec<String>,
}

/// All pieces of a file, by the layers whose ends may meet.
#[derive(Debug, Default)]
pub struct Pieces {
    /// Length of a unit of the drawing, mm.
    pub unit_mm: f64,
    layers: IndexMap<String, Vec<DrawnPath>>,
    segments: usize,
    /// Ignored elements by kind: the place of the first, and how many there are.
    left_out: IndexMap<String, (String, usize)>,
}

impl Pieces {
    /// Adds a piece to the layer `layer`, without its segments of length 0. A piece with no other segments is ignored.
    pub fn add(&mut self, layer: &str, mut piece: DrawnPath) -> Result<(), DrawingError> {
        for segment in &piece.segments {
            check(segment, &piece.place)?;
        }
        piece.segments.retain(|segment| segment.length() > 0.0);
        self.segments += piece.segments.len();
        if self.segments > MAX_SEGMENTS {
            return Err(DrawingError::too_large("segments", MAX_SEGMENTS));
        }
        if piece.segments.is_empty() {
            self.leave_out("zero length", &piece.place);
            return Ok(());
        }
        match self.layers.get_mut(layer) {
            Some(pieces) => pieces.push(piece),
            None => {
                self.layers.insert(layer.to_owned(), vec![piece]);
            }
        }
        Ok(())
    }

    /// Counts an ignored element at `place`; `what` is one of a few kinds.
    pub fn leave_out(&mut self, what: &str, place: &str) {
        let known = self.left_out.entry(what.to_owned());
        known.or_insert_with(|| (place.to_owned(), 0)).1 += 1;
    }

    /// The loops. Pieces drawn twice count once. A layer whose paths are all open is ignored beside one with loops. An open path
    /// beside loops of its layer is ignored if it is a helper line; else it is an error.
    pub fn drawing(mut self, options: &Options) -> Result<Drawing, DrawingError> {
        let (mut loops, mut all_open) = (Vec::new(), Vec::new());
        for (layer, mut pieces) in std::mem::take(&mut self.layers) {
            let mut drawn = HashSet::with_capacity(pieces.len());
            pieces.retain(|piece| {
                let new = drawn.insert(piece.trace());
                if !new {
                    self.leave_out("drawn twice", &piece.place);
                }
                new
            });
            let Chains {
                found,
                mut open,
                specks,
            } = chain(pieces, options.join_mm)?;
            if !found.is_empty() {
                let (helper, broken) = helpers(open);
                for path in helper {
                    self.leave_out("open line beside the outline", &path.path.place);
                }
                if let Some(path) = broken.first() {
                    return Err(path.error(&broken));
                }
                open = broken;
            }
            if !open.is_empty() {
                all_open.push((layer, open));
            }
            loops.extend(found);
            for place in specks {
                self.leave_out("loop shorter than four times join_mm", &place);
            }
        }
        let mut remarks = Vec::new();
        // A bore is no outline of a gear.
        if loops.iter().all(|path| path.circle().is_some())
            && let Some(repeat) = &options.repeat
            && let [(_, open)] = &all_open[..]
            && let [tooth] = &open[..]
        {
            loops.push(repeat.outline(tooth)?);
            remarks.push(format!(
                "one tooth is drawn: repeated {} times about the centre",
                repeat.teeth
            ));
            all_open.clear();
        }
        if loops.is_empty() {
            return Err(match all_open.first() {
                Some((_, open)) => open[0].error(open),
                None => DrawingError::no_loop("no line and no curve is drawn".to_owned()),
            });
        }
        let left_out = self.left_out.iter().map(|(what, (first, count))| {
            format!("left out: {what} ({count}, the first in {first})")
        });
        let layers = all_open.iter().map(|(layer, open)| open_layer(layer, open));
        remarks.extend(left_out.chain(layers.take(MAX_NAMED)));
        Ok(Drawing {
            unit_mm: self.unit_mm,
            loops,
            remarks,
        })
    }
}

/// The open paths that are helper lines, such as centre lines, and those that are broken outlines.
///
/// A helper line ends far from every other open end. The ends at a gap of an outline are near each other.
fn helpers(open: Vec<Open>) -> (Vec<Open>, Vec<Open>) {
    if open.len() > MAX_HELPERS {
        return (Vec::new(), open);
    }
    let ends: Vec<[Point2<f64>; 2]> = open.iter().map(|path| path.ends).collect();
    let mut index = 0;
    open.into_iter().partition(|path| {
        let others = ends.iter().enumerate().filter(|(other, _)| *other != index);
        let others: Vec<Point2<f64>> = others.flat_map(|(_, ends)| *ends).collect();
        index += 1;
        let gap = |end: usize| {
            let own = [path.ends[1 - end]];
            let gaps = others
                .iter()
                .chain(&own)
                .map(|other| (other - path.ends[end]).norm());
            gaps.fold(f64::INFINITY, f64::min)
        };
        gap(0).min(gap(1)) > GAP * path.path.length()
    })
}

fn open_layer(layer: &str, open: &[Open]) -> String {
    format!(
        "left out: layer \"{}\", on which all {} paths are open, the first from {} to {}",
        cut(layer, LONGEST_NAME),
        open.len(),
        at(&open[0].ends[0]),
        at(&open[0].ends[1])
    )
}

/// Rejects numbers that are not finite or too large for a gear.
fn check(segment: &PathSegment, place: &str) -> Result<(), DrawingError> {
    let near = |point: &Point2<f64>| point.x.abs().max(point.y.abs()) <= FARTHEST_MM;
    let good = segment.is_finite()
        && match segment {
            PathSegment::Line(points) => points.iter().all(near),
            PathSegment::Arc { centre, radius, .. } => near(centre) && *radius <= FARTHEST_MM,
            PathSegment::Cubic(points) => points.iter().all(near),
        };
    if good {
        return Ok(());
    }
    let reason =
        format!("a coordinate or radius is not a number, or greater than {FARTHEST_MM:e} mm");
    Err(DrawingError::number(place, reason))
}

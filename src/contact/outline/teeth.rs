//! The teeth of one side of an outline, and their positions in a frame.

use crate::contact::gap::{Arc, Boxes, C, PlacedCurve, Rectangle};
use crate::gear::Side;
use crate::outline::{HalfOutline, HalfPiece, OutlineGear};

/// One side of a gear's teeth, in the frame of the side.
#[derive(Debug)]
pub(super) struct SideTeeth<'a> {
    pub gear: &'a OutlineGear,
    side: Side,
    pub displacement: C,
    /// Sign with which tooth numbers increase in this frame.
    ascending: i64,
    /// Rectangles around the pieces of each half tooth.
    boxes: Vec<Boxes>,
}

impl<'a> SideTeeth<'a> {
    pub fn new(gear: &'a OutlineGear, side: Side) -> SideTeeth<'a> {
        let mirror = -side.sense();
        let displacement = gear.displacement();
        let boxes = (1..=gear.teeth()).map(|tooth| {
            let pieces = gear.half(side, tooth).pieces.iter();
            let round =
                |piece: &HalfPiece| Rectangle::new(&piece.curve, piece.range(), |t| piece.point(t));
            Boxes::new(&pieces.map(round).collect::<Vec<Rectangle>>())
        });
        SideTeeth {
            gear,
            side,
            displacement: if mirror > 0.0 {
                displacement
            } else {
                displacement.conj()
            },
            ascending: (mirror * gear.face().ascending()) as i64,
            boxes: boxes.collect(),
        }
    }

    pub fn half(&self, tooth: u32) -> &'a HalfOutline {
        self.gear.half(self.side, tooth)
    }

    /// Rectangles around the pieces of a half tooth.
    pub fn boxes(&self, tooth: u32) -> &Boxes {
        &self.boxes[tooth as usize - 1]
    }

    /// The number of the tooth `steps` counter-clockwise of `tooth` in this frame.
    pub fn beside(&self, tooth: u32, steps: i64) -> u32 {
        let index = i64::from(tooth) - 1 + self.ascending * steps;
        index.rem_euclid(i64::from(self.gear.teeth())) as u32 + 1
    }
}

/// A frame of a gear: `centre + direction · P`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub centre: C,
    pub direction: C,
}

impl Frame {
    pub fn placed<'a>(&self, piece: &'a HalfPiece) -> PlacedCurve<'a> {
        PlacedCurve {
            curve: &piece.curve,
            mirrored: piece.mirrored,
            centre: self.centre,
            direction: self.direction * piece.turn,
        }
    }

    pub fn arc<'a>(&self, piece: &'a HalfPiece, name: usize) -> Arc<'a> {
        let (low, high) = piece.range();
        Arc::new(self.placed(piece), name, low, high)
    }

    /// The arc of the free gear. About the axis an arc has one radius, so only its clockwise end, the one nearer the root, can touch.
    pub fn free_arc<'a>(&self, piece: &'a HalfPiece, name: usize) -> Arc<'a> {
        if self.centre == C::ZERO && piece.curve.is_about_the_origin() {
            Arc::new(self.placed(piece), name, piece.ends[1], piece.ends[1])
        } else {
            self.arc(piece, name)
        }
    }
}

/// Whether a curve comes within `radius`, mm, of the origin between two parameters: found at a point, or ruled out by its reach.
pub(super) fn nearest(placed: &PlacedCurve, low: f64, high: f64, radius: f64) -> bool {
    let middle = 0.5 * (low + high);
    let there = placed.at(middle).point.norm();
    let (reach, _) = placed.curve.spread(low, high);
    if there < radius {
        return true;
    }
    // A distance equal within rounding is not within.
    if there - reach >= radius
        || reach <= 16.0 * f64::EPSILON * there
        || !(low < middle && middle < high)
    {
        return false;
    }
    nearest(placed, low, middle, radius) || nearest(placed, middle, high, radius)
}

//! Half a tooth of an outline: the pieces of its curves from the tip region down to the middle of the space.

use crate::gear::PartCurve;
use nalgebra::{Complex, Point2};

/// Share of a piece within which a point is at its end: far above rounding, far below what an edge could be rounded by.
const AT_END: f64 = 1e-9;

/// A piece of a curve in the frame of its half tooth's side: the gear's own, its tooth 1 on +x, mirrored in the x axis on the left side.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfPiece {
    pub(crate) curve: PartCurve,
    /// Parameters of its two ends, the one nearer the tip first.
    pub(crate) ends: [f64; 2],
    /// How the curve's frame is turned.
    pub(crate) turn: Complex<f64>,
    pub(crate) mirrored: bool,
    /// Whether the outline has an edge at each end.
    pub(crate) corners: [bool; 2],
}

impl HalfPiece {
    /// The point at parameter `t`, mm.
    pub(crate) fn point(&self, t: f64) -> Complex<f64> {
        let Point2 { coords } = self.curve.point(t);
        let point = Complex::new(coords.x, coords.y);
        self.turn * if self.mirrored { point.conj() } else { point }
    }

    /// The unit normal at parameter `t`, out of the metal.
    pub(crate) fn normal(&self, t: f64) -> Complex<f64> {
        let normal = self.curve.normal(t);
        let normal = Complex::new(normal.x, normal.y);
        self.turn * if self.mirrored { normal.conj() } else { normal }
    }

    /// Parameters of its ends, the lesser first.
    pub(crate) fn range(&self) -> (f64, f64) {
        let [from, to] = self.ends;
        (from.min(to), from.max(to))
    }

    /// Whether it has an edge at `t`: at an end, or as near to it as a search ends.
    pub(crate) fn is_corner(&self, t: f64) -> bool {
        let (low, high) = self.range();
        let near = AT_END * (high - low);
        (0..2).any(|end| self.corners[end] && (t - self.ends[end]).abs() <= near)
    }
}

/// Half a tooth on one side.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfOutline {
    /// From the tip to the root.
    pub(crate) pieces: Vec<HalfPiece>,
    /// Radius above which it is tip, mm.
    pub(crate) tip_limit: f64,
    /// Radius below which it is root, mm.
    pub(crate) root_limit: f64,
}

/// Steps into which a piece is divided to find where it passes a radius (tuned: a flank has no two such places within a 32nd of it).
const STEPS: u32 = 32;

/// Halvings of such a step, to the last bit.
const HALVINGS: u32 = 60;

impl HalfOutline {
    /// Least and greatest radius, mm, of the ends of its pieces.
    pub(super) fn end_radii(&self) -> [f64; 2] {
        let ends = self
            .pieces
            .iter()
            .flat_map(|piece| piece.ends.map(|t| piece.point(t).norm()));
        ends.fold([f64::INFINITY, 0.0], |[least, most], radius| {
            [least.min(radius), most.max(radius)]
        })
    }

    /// Angle, rad, in the frame of its side, of the place nearest the tip at which it passes `radius`, mm, inwards.
    pub(super) fn angle_at(&self, radius: f64) -> Option<f64> {
        let (piece, t) = self.passes(radius)?;
        Some(self.pieces[piece].point(t).arg())
    }

    /// Its pieces from the tip down to where it first passes `radius`, mm, inwards; all where it does not.
    pub(crate) fn down_to(&self, radius: f64) -> Vec<HalfPiece> {
        let Some((last, t)) = self.passes(radius) else {
            return self.pieces.clone();
        };
        let mut pieces = self.pieces[..=last].to_vec();
        pieces[last].ends[1] = t;
        pieces
    }

    /// The piece and the parameter at which it first passes `radius`, mm, inwards.
    fn passes(&self, radius: f64) -> Option<(usize, f64)> {
        let mut reached = false;
        for (index, piece) in self.pieces.iter().enumerate() {
            let [from, to] = piece.ends;
            let mut before = from;
            for step in 0..=STEPS {
                let t = from + (to - from) * f64::from(step) / f64::from(STEPS);
                if piece.point(t).norm() >= radius {
                    (reached, before) = (true, t);
                } else if reached {
                    let (mut above, mut below) = (before, t);
                    for _ in 0..HALVINGS {
                        let middle = 0.5 * (above + below);
                        match piece.point(middle).norm() >= radius {
                            true => above = middle,
                            false => below = middle,
                        }
                    }
                    return Some((index, above));
                }
            }
        }
        None
    }

    /// Marks the ends at which neighbouring pieces do not continue each other's direction within `tolerance`, rad.
    pub(super) fn mark_corners(&mut self, tolerance: f64) {
        for k in 1..self.pieces.len() {
            let (before, after) = (&self.pieces[k - 1], &self.pieces[k]);
            let turned = before.normal(before.ends[1]) * after.normal(after.ends[0]).conj();
            let edge = turned.arg().abs() > tolerance;
            self.pieces[k - 1].corners[1] = edge;
            self.pieces[k].corners[0] = edge;
        }
    }
}

//! A half tooth of an outline: its curves from the tip region down to the middle of the space.

use crate::gear::PartCurve;
use crate::numeric::bisect;
use nalgebra::{Complex, Point2};

/// Share of a piece within which a point counts as its end: far above rounding, far below a rounded edge.
const AT_END: f64 = 1e-9;

/// A piece of a curve in the frame of its side: the gear's frame with tooth 1 on +x, mirrored in the x axis on the left side.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfPiece {
    pub(crate) curve: PartCurve,
    /// Parameters of its two ends, the one nearer the tip first.
    pub(crate) ends: [f64; 2],
    /// Rotation of the curve's frame.
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

    /// Parameters of the ends, the lesser first.
    pub(crate) fn range(&self) -> (f64, f64) {
        let [from, to] = self.ends;
        (from.min(to), from.max(to))
    }

    /// Bounds of the square of the radius on a straight piece or an arc, mm²; `None` for other curves.
    fn squared_radius_bounds(&self) -> Option<[f64; 2]> {
        if let PartCurve::Circle(circle) = &self.curve {
            return Some(circle.radii().map(|radius| radius * radius));
        }
        let PartCurve::Line(_) = self.curve else {
            return None;
        };
        let [near_tip, near_root] = self.ends.map(|end| self.point(end));
        let along = near_root - near_tip;
        let foot = -(near_tip * along.conj()).re / along.norm_sqr();
        // Without a foot on the piece it is nearest at an end.
        let foot = near_tip + along * foot.clamp(0.0, 1.0);
        let ends = [near_tip.norm_sqr(), near_root.norm_sqr()];
        let least = foot.norm_sqr().min(ends[0]).min(ends[1]);
        Some([least, ends[0].max(ends[1])])
    }

    /// Whether there is an edge at `t`: at an end, or within the tolerance of a search.
    pub(crate) fn is_corner(&self, t: f64) -> bool {
        let (low, high) = self.range();
        let near = AT_END * (high - low);
        (0..2).any(|end| self.corners[end] && (t - self.ends[end]).abs() <= near)
    }
}

/// A half tooth on one side.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfOutline {
    /// The pieces from the tip to the root.
    pub(crate) pieces: Vec<HalfPiece>,
    /// Radius above which the half tooth counts as tip, mm.
    pub(crate) tip_limit: f64,
    /// Radius below which the half tooth counts as root, mm.
    pub(crate) root_limit: f64,
}

/// Steps per piece in the search for a radius. Tuned: a flank passes a radius at most once within a 32nd of it.
const STEPS: u32 = 32;

/// Relative rounding of the squares of radii: far above f64, far below any tolerance.
const ROUNDING: f64 = 1e-12;

impl HalfOutline {
    /// Least and greatest radius of the ends of the pieces, mm.
    pub(super) fn end_radii(&self) -> [f64; 2] {
        let radii = |piece: &HalfPiece| piece.ends.map(|t| piece.point(t).norm());
        let ends = self.pieces.iter().flat_map(radii);
        ends.fold([f64::INFINITY, 0.0], |[least, most], radius| {
            [least.min(radius), most.max(radius)]
        })
    }

    /// Angle at which the half tooth, from the tip, first passes `radius`, mm, inwards: rad, in the frame of its side.
    pub(super) fn angle_at(&self, radius: f64) -> Option<f64> {
        let (piece, t) = self.first_passage(radius)?;
        Some(self.pieces[piece].point(t).arg())
    }

    /// The pieces from the tip down to the first passage through `radius`, mm, inwards; all pieces without a passage.
    pub(crate) fn down_to(&self, radius: f64) -> Vec<HalfPiece> {
        let Some((last, t)) = self.first_passage(radius) else {
            return self.pieces.clone();
        };
        let mut pieces = self.pieces[..=last].to_vec();
        pieces[last].ends[1] = t;
        pieces
    }

    /// Piece and parameter of the first passage through `radius`, mm, inwards.
    fn first_passage(&self, radius: f64) -> Option<(usize, f64)> {
        let mut reached = false;
        for (index, piece) in self.pieces.iter().enumerate() {
            let [from, to] = piece.ends;
            if let Some([least, most]) = piece.squared_radius_bounds() {
                let square = radius * radius;
                if !reached && most < square * (1.0 - ROUNDING) {
                    continue;
                }
                if least > square * (1.0 + ROUNDING) {
                    reached = true;
                    continue;
                }
            }
            let mut before = from;
            for step in 0..=STEPS {
                let t = from + (to - from) * f64::from(step) / f64::from(STEPS);
                if piece.point(t).norm_sqr() >= radius * radius {
                    (reached, before) = (true, t);
                } else if reached {
                    let beyond = |t: f64| piece.point(t).norm() >= radius;
                    let [above, _] = bisect(before, t, 0.0, beyond);
                    return Some((index, above));
                }
            }
        }
        None
    }

    /// Marks as edges the joints at which the direction changes by more than `tolerance`, rad.
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

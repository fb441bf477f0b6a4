//! Linear maps with a shift: transforms of an SVG, blocks of a DXF.

use super::curve::{Curve, elliptic};
use gearlash::outline::PathSegment;
use nalgebra::{Matrix2, Point2, Vector2};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine {
    turn: Matrix2<f64>,
    shift: Vector2<f64>,
}

impl Affine {
    /// The map from a point `p` to `turn p + shift`.
    pub fn new(turn: Matrix2<f64>, shift: Vector2<f64>) -> Affine {
        Affine { turn, shift }
    }

    /// Scales by `scale` and reverses y.
    pub fn upright(scale: f64) -> Affine {
        Affine::new(Matrix2::new(scale, 0.0, 0.0, -scale), Vector2::zeros())
    }

    /// This map for lengths in mm; it is given for lengths in units of `scale` mm.
    pub fn in_units(&self, scale: f64) -> Affine {
        Affine::new(self.turn, self.shift * scale)
    }

    pub fn shift(x: f64, y: f64) -> Affine {
        Affine::new(Matrix2::identity(), Vector2::new(x, y))
    }

    /// The map of an SVG `transform`.
    pub fn of(transform: &svgtypes::Transform) -> Affine {
        let &svgtypes::Transform { a, b, c, d, e, f } = transform;
        Affine::new(Matrix2::new(a, c, b, d), Vector2::new(e, f))
    }

    /// The map that applies `inner` first, then this one.
    pub fn after(&self, inner: &Affine) -> Affine {
        Affine::new(self.turn * inner.turn, self.turn * inner.shift + self.shift)
    }

    pub fn point(&self, point: Point2<f64>) -> Point2<f64> {
        self.turn * point + self.shift
    }

    pub fn vector(&self, vector: Vector2<f64>) -> Vector2<f64> {
        self.turn * vector
    }

    /// The map does not lengthen a distance by more than this factor: the Frobenius norm.
    pub fn stretch(&self) -> f64 {
        self.turn.norm()
    }

    /// The image of a segment. Arcs stay arcs unless the map is oblique.
    pub fn segment(&self, segment: &PathSegment) -> Curve {
        match *segment {
            PathSegment::Line(ends) => {
                Curve::exact(PathSegment::Line(ends.map(|end| self.point(end))))
            }
            PathSegment::Cubic(points) => {
                Curve::exact(PathSegment::Cubic(points.map(|point| self.point(point))))
            }
            PathSegment::Arc {
                centre,
                radius,
                start,
                sweep,
            } => {
                let axes = [Vector2::new(radius, 0.0), Vector2::new(0.0, radius)];
                let axes = axes.map(|axis| self.vector(axis));
                elliptic(self.point(centre), axes, start, sweep)
            }
        }
    }
}

//! The parts of a half tooth: curves with one common set of methods.
//!
//! Parts belong to the right-hand half tooth (clockwise side), its centre line on +x. A part covers an interval of its parameter.
//! Its unit normal points out of the metal, and `dP/dt = i n · speed` with the sign of `speed`. A new kind of curve is a new type
//! and a new variant of [`PartCurve`]. Methods for involutes alone (contact in closed form) match the variant.

mod closed_form;
mod cubic;
mod modified;

use super::DeviationCurve;
pub use super::fillet::Fillet;
pub use closed_form::{Arc, Circle, InvoluteFlank, Line};
pub use cubic::Cubic;
pub use modified::ModifiedFlank;

use nalgebra::{Point2, Vector2};

/// One of the four parts of a half tooth. Parameters are those of the usual curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ProfilePart {
    /// Tip land or its corner. Parameter: angle past the tooth's centre line, rad.
    Tip,
    /// The flank, an involute. Parameter: roll `ξ`, rad.
    Involute,
    /// Generated fillet. Parameter: `γ`, see [`super::Fillet`], rad.
    Fillet,
    /// Root land. Parameter: angle past the tooth's centre line, rad.
    Root,
}

impl ProfilePart {
    /// In order from the tip to the root.
    pub const ALL: [ProfilePart; 4] = [
        ProfilePart::Tip,
        ProfilePart::Involute,
        ProfilePart::Fillet,
        ProfilePart::Root,
    ];

    /// Whether the part is a tip land or a root land.
    pub fn is_land(self) -> bool {
        matches!(self, ProfilePart::Tip | ProfilePart::Root)
    }

    /// `tip`, `involute`, `fillet` or `root`, as results name it.
    pub fn name(self) -> &'static str {
        match self {
            ProfilePart::Tip => "tip",
            ProfilePart::Involute => "involute",
            ProfilePart::Fillet => "fillet",
            ProfilePart::Root => "root",
        }
    }
}

/// The curve of a part.
#[derive(Debug, Clone, PartialEq)]
pub enum PartCurve {
    /// An arc about the gear's centre. Parameter: angle past the tooth's centre line, rad.
    Arc(Arc),
    /// An involute. Parameter: roll `ξ`, rad.
    Involute(InvoluteFlank),
    /// An involute with a profile deviation. Parameter: roll `ξ` of the involute, rad.
    Modified(ModifiedFlank),
    /// A generated fillet. Parameter: `γ`, see [`Fillet`], rad.
    Trochoid(Fillet),
    /// A straight line. Parameter: distance from its end at the root, mm.
    Line(Line),
    /// An arc about any point. Parameter: angle at its centre, rad.
    Circle(Circle),
    /// A cubic Bézier curve. Parameter: 0 to 1.
    Cubic(Cubic),
}

/// Point, normal, speed and curvature of a curve at one parameter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Osculating {
    /// The point, mm.
    pub point: Point2<f64>,
    /// The unit normal, out of the metal.
    pub normal: Vector2<f64>,
    /// `dP/dt = i n · speed`, mm per unit of the parameter.
    pub speed: f64,
    /// The curvature, 1/mm, positive where the metal is convex.
    pub curvature: f64,
}

/// Calls a method of the curve of any variant.
macro_rules! call {
    ($curve:expr, $method:ident($($argument:expr),*)) => {
        match $curve {
            PartCurve::Arc(curve) => curve.$method($($argument),*),
            PartCurve::Involute(curve) => curve.$method($($argument),*),
            PartCurve::Modified(curve) => curve.$method($($argument),*),
            PartCurve::Trochoid(curve) => curve.$method($($argument),*),
            PartCurve::Line(curve) => curve.$method($($argument),*),
            PartCurve::Circle(curve) => curve.$method($($argument),*),
            PartCurve::Cubic(curve) => curve.$method($($argument),*),
        }
    };
}

impl PartCurve {
    /// The point at `t`, mm.
    #[inline]
    pub fn point(&self, t: f64) -> Point2<f64> {
        call!(self, point(t))
    }

    /// The unit normal at `t`, out of the metal.
    #[inline]
    pub fn normal(&self, t: f64) -> Vector2<f64> {
        call!(self, normal(t))
    }

    /// Point and normal at `t`, computed together. The last digit may differ from [`PartCurve::point`] and [`PartCurve::normal`].
    #[inline]
    pub fn at(&self, t: f64) -> (Point2<f64>, Vector2<f64>) {
        call!(self, at(t))
    }

    /// Radius about the gear's centre at `t`, mm.
    pub fn radius(&self, t: f64) -> f64 {
        call!(self, radius(t))
    }

    /// `dP/dt = i n · speed`, mm per unit of the parameter.
    #[inline]
    pub fn speed(&self, t: f64) -> f64 {
        call!(self, speed(t))
    }

    /// Bounds `(d, w)` over `[low, high]`: every point lies within `d` mm of the middle point, and its normal within `w` rad of the
    /// middle normal.
    pub fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        call!(self, spread(low, high))
    }

    /// Bounds `(A, B)` of the second derivative across the chord of a piece of length `Δ`: at most `A + B Δ`.
    ///
    /// `t` is the greater end of the piece.
    pub fn bend(&self, t: f64) -> (f64, f64) {
        call!(self, bend(t))
    }

    /// Bounds of the normal's turn along `i n`, 1/mm, between two parameters, positive where the metal is convex; `None` if unknown.
    pub fn convexity(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        call!(self, convexity(low, high))
    }

    /// Whether the curve is an arc about the origin.
    pub(crate) fn is_about_the_origin(&self) -> bool {
        match self {
            PartCurve::Arc(_) => true,
            // Within the rounding of the centre in a drawing.
            PartCurve::Circle(circle) => {
                circle.centre().coords.norm() <= 256.0 * f64::EPSILON * circle.radius(0.0)
            }
            _ => false,
        }
    }

    /// Points, mm, and a radius, mm. Two curves of one kind between near ends are apart by no more than the differences of both together. `None` for
    /// curves that are not given by points.
    pub(crate) fn moved_by(&self) -> Option<(Vec<Point2<f64>>, f64)> {
        match self {
            PartCurve::Line(_) => Some((Vec::new(), 0.0)),
            PartCurve::Circle(circle) => Some((vec![circle.centre()], circle.speed(0.0).abs())),
            PartCurve::Cubic(cubic) => Some((cubic.points().to_vec(), 0.0)),
            _ => None,
        }
    }

    /// Further lengths, mm, whose rounding enters a point at `t`: for a circle the radius, and the radius times the angle.
    pub(crate) fn rounded_lengths(&self, t: f64) -> f64 {
        match self {
            PartCurve::Circle(circle) => circle.speed(t).abs() * (1.0 + t.abs()),
            _ => 0.0,
        }
    }

    /// Point, normal, speed and curvature of an involute, with or without deviation, at a roll; `None` for other curves.
    #[inline]
    pub(crate) fn osculating(&self, xi: f64) -> Option<Osculating> {
        match self {
            PartCurve::Involute(flank) => {
                let (point, normal) = flank.at(xi);
                let speed = flank.speed(xi);
                Some(Osculating {
                    point,
                    normal,
                    speed,
                    curvature: 1.0 / speed,
                })
            }
            PartCurve::Modified(flank) => Some(flank.osculating(xi)),
            _ => None,
        }
    }

    /// The profile deviation over the roll, if the curve has one.
    pub fn deviation(&self) -> Option<&DeviationCurve> {
        match self {
            PartCurve::Modified(flank) => Some(flank.deviation()),
            _ => None,
        }
    }

    /// Parameters at which the curve has an edge, ascending.
    pub fn edges(&self) -> &[f64] {
        self.deviation().map_or(&[], DeviationCurve::edges)
    }

    /// The stretches between two parameters, in order, cut at the edges: no bound holds for a chord across an edge.
    pub(crate) fn between_edges(&self, from: f64, to: f64) -> Vec<[f64; 2]> {
        let (low, high) = (from.min(to), from.max(to));
        let inside = self.edges().iter().copied();
        let inside = inside.filter(|edge| *edge > low && *edge < high);
        let mut places: Vec<f64> = [low].into_iter().chain(inside).chain([high]).collect();
        if from > to {
            places.reverse();
        }
        places.windows(2).map(|ends| [ends[0], ends[1]]).collect()
    }

    /// Greatest curvature between two parameters, 1/mm, where it is known.
    pub fn curvature(&self, from: f64, to: f64) -> Option<f64> {
        call!(self, curvature(from, to))
    }
}

/// A stretch of a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The curve.
    pub curve: PartCurve,
    /// Parameters of the two ends, the one nearer the tip first. A part with equal ends has no length.
    pub ends: [f64; 2],
    /// Whether the outline has an edge at each end. The ends of lands depend on the tooth.
    pub corners: [bool; 2],
}

impl Part {
    /// Parameters of the two ends, the lesser first.
    pub fn range(&self) -> (f64, f64) {
        let [from, to] = self.ends;
        (from.min(to), from.max(to))
    }

    /// Whether the outline has an edge at `t`, which may lie beyond an end.
    pub fn is_corner(&self, t: f64) -> bool {
        let [from, to] = self.ends;
        let at = if from > to {
            [t >= from, t <= to]
        } else {
            [t <= from, t >= to]
        };
        // The last point before an edge counts as the edge.
        let inside = |edges: &[f64]| edges.iter().any(|edge| t == *edge || t == edge.next_down());
        at[0] && self.corners[0] || at[1] && self.corners[1] || inside(self.curve.edges())
    }

    /// The stretches without an edge inside, by the parameters of their ends, the lesser first. Ends at an edge lie on their own side.
    pub fn stretches(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let (low, high) = self.range();
        smooth(self.curve.edges(), low, high)
    }
}

/// Splits an interval of a curve's parameter at the edges inside it. Ends at an edge lie on their own side.
pub(crate) fn smooth(edges: &[f64], low: f64, high: f64) -> impl Iterator<Item = (f64, f64)> + '_ {
    let inside = edges
        .iter()
        .copied()
        .filter(move |edge| *edge > low && *edge < high);
    let starts = std::iter::once(low).chain(inside.clone());
    let ends = inside.map(f64::next_down).chain(std::iter::once(high));
    starts.zip(ends)
}

#[cfg(test)]
mod tests;

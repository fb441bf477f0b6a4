//! The parts a half tooth is made of: what every method asks of a curve, answered by each kind of curve in a file of its own.
//!
//! All for the right-hand half tooth (clockwise side), its centre line on +x. A part runs over an interval of its parameter; its
//! unit normal points out of the metal, and `dP/dt = i n · speed` with the sign of `speed`. Another kind of curve is another
//! file beside these and another variant of [`PartCurve`]; what only involutes can do (contact in closed form) asks for
//! the variant.

mod arc;
mod circle;
mod cubic;
mod involute;
mod line;
mod modified;

pub use super::fillet::Fillet;
pub use arc::Arc;
pub use circle::Circle;
pub use cubic::Cubic;
pub use involute::InvoluteFlank;
pub use line::Line;
pub use modified::ModifiedFlank;

use nalgebra::{Point2, Vector2};

/// One of the four parts of a half tooth, by the place it has in it. Parameters are those of the usual curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ProfilePart {
    /// Tip land or its corner. Parameter: angle past the tooth's centre line, rad.
    Tip,
    /// The flank, an involute. Parameter: roll `ξ`, rad. (A straight flank has its place and its name.)
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

    /// Whether it is a tip land or a root land.
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
    /// About the gear's centre. Parameter: angle past the tooth's centre line, rad.
    Arc(Arc),
    /// Parameter: roll `ξ`, rad.
    Involute(InvoluteFlank),
    /// With a profile deviation. Parameter: roll `ξ` of its involute, rad.
    Modified(ModifiedFlank),
    /// A generated fillet. Parameter: `γ`, see [`Fillet`], rad.
    Trochoid(Fillet),
    /// Parameter: distance from its end at the root, mm.
    Line(Line),
    /// About any point. Parameter: angle at its centre, rad.
    Circle(Circle),
    /// Parameter: 0 to 1.
    Cubic(Cubic),
}

/// A curve at one parameter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Osculating {
    /// mm.
    pub point: Point2<f64>,
    /// Out of the metal.
    pub normal: Vector2<f64>,
    /// `dP/dt = i n · speed`, mm a unit of the parameter.
    pub speed: f64,
    /// 1/mm, above 0 where the metal bulges.
    pub curvature: f64,
}

/// What a curve is asked, by the variant that answers.
macro_rules! ask {
    ($curve:expr, $question:ident($($argument:expr),*)) => {
        match $curve {
            PartCurve::Arc(curve) => curve.$question($($argument),*),
            PartCurve::Involute(curve) => curve.$question($($argument),*),
            PartCurve::Modified(curve) => curve.$question($($argument),*),
            PartCurve::Trochoid(curve) => curve.$question($($argument),*),
            PartCurve::Line(curve) => curve.$question($($argument),*),
            PartCurve::Circle(curve) => curve.$question($($argument),*),
            PartCurve::Cubic(curve) => curve.$question($($argument),*),
        }
    };
}

impl PartCurve {
    /// The point at `t`, mm.
    #[inline]
    pub fn point(&self, t: f64) -> Point2<f64> {
        ask!(self, point(t))
    }

    /// The unit normal at `t`, out of the metal.
    #[inline]
    pub fn normal(&self, t: f64) -> Vector2<f64> {
        ask!(self, normal(t))
    }

    /// Point and normal at `t` at the price of one; the last digit may be another than that of either by itself.
    #[inline]
    pub fn at(&self, t: f64) -> (Point2<f64>, Vector2<f64>) {
        ask!(self, at(t))
    }

    /// Radius about the gear's centre at `t`, mm.
    pub fn radius(&self, t: f64) -> f64 {
        ask!(self, radius(t))
    }

    /// `dP/dt = i n · speed`, mm a unit of the parameter.
    #[inline]
    pub fn speed(&self, t: f64) -> f64 {
        ask!(self, speed(t))
    }

    /// `(d, w)`: every point with parameter in `[low, high]` lies within `d` mm of the middle one, and its normal within the angle
    /// `w`, rad, of the middle one's.
    pub fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        ask!(self, spread(low, high))
    }

    /// `(A, B)` such that over a piece of length `Δ` on the near side of `t` the part of the second derivative across the chord is at
    /// most `A + B Δ`; `t` is the piece's greater end.
    pub fn bend(&self, t: f64) -> (f64, f64) {
        ask!(self, bend(t))
    }

    /// Least and greatest turn of the normal along `i n`, 1/mm, between two parameters: above 0 where the metal bulges; where it is known.
    pub fn convexity(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        ask!(self, convexity(low, high))
    }

    /// Whether it is an arc about the origin.
    pub(crate) fn is_about_the_origin(&self) -> bool {
        match self {
            PartCurve::Arc(_) => true,
            // To the rounding of where a drawing puts its centre.
            PartCurve::Circle(circle) => {
                circle.centre().coords.norm() <= 256.0 * f64::EPSILON * circle.radius(0.0)
            }
            _ => false,
        }
    }

    /// Lengths, mm, whose rounding a point at `t` has beside that of its own coordinates: of a circle its radius, and that times the angle.
    pub(crate) fn rounded_lengths(&self, t: f64) -> f64 {
        match self {
            PartCurve::Circle(circle) => circle.speed(t).abs() * (1.0 + t.abs()),
            _ => 0.0,
        }
    }

    /// What an involute, deviating or not, is at a roll.
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

    /// Parameters at which the curve has an edge, ascending.
    pub fn edges(&self) -> &[f64] {
        match self {
            PartCurve::Modified(flank) => flank.deviation().edges(),
            _ => &[],
        }
    }

    /// The stretches between two parameters, in order, cut at the edges between them: a chord over one would be bounded by nothing.
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
        ask!(self, curvature(from, to))
    }
}

/// A stretch of a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The curve.
    pub curve: PartCurve,
    /// Parameters of its two ends, the one nearer the tip first. Equal ends: the part has no length.
    pub ends: [f64; 2],
    /// Whether the outline has an edge at each end. (Where a land ends is one tooth's to know.)
    pub corners: [bool; 2],
}

impl Part {
    /// Parameters of the two ends, the lesser first.
    pub fn range(&self) -> (f64, f64) {
        let [from, to] = self.ends;
        (from.min(to), from.max(to))
    }

    /// Whether the outline has an edge at `t`: an end, or beyond it, that is one.
    pub fn is_corner(&self, t: f64) -> bool {
        let [from, to] = self.ends;
        let at = match from > to {
            true => [t >= from, t <= to],
            false => [t <= from, t >= to],
        };
        // The last point before an edge stands for it on its side.
        let inside = |edges: &[f64]| edges.iter().any(|edge| t == *edge || t == edge.next_down());
        at[0] && self.corners[0] || at[1] && self.corners[1] || inside(self.curve.edges())
    }

    /// The stretches without an edge inside, the lesser first: parameters of their ends, those at an edge on their own side of it.
    pub fn stretches(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let (low, high) = self.range();
        smooth(self.curve.edges(), low, high)
    }
}

/// An interval of a curve's parameter, cut at the edges inside it: both sides of an edge end on their own side.
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

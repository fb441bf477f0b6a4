//! B-splines as cubic Bézier curves: exact up to degree 3 without weights, else with a proven bound.

use super::curve::Curve;
use super::limits::{FIT_MM, MAX_SEGMENTS};
use gearlash::outline::PathSegment;
use nalgebra::{Point2, Vector2, Vector3};

/// The highest degree: CAD programs use 11 at most, and the cost grows with its square.
const HIGHEST_DEGREE: usize = 15;
/// Halvings of a piece: one that needs more than 4096 cubic curves is refused. A circle of a metre takes some 300.
const MAX_HALVINGS: u32 = 12;

/// A B-spline, rational by its weights.
#[derive(Debug, Clone, PartialEq)]
pub struct BSpline {
    pub degree: usize,
    /// Ascending, `degree + 1` more than points.
    pub knots: Vec<f64>,
    /// Its control points, mm.
    pub points: Vec<Point2<f64>>,
    pub weights: Vec<f64>,
}

impl BSpline {
    /// The fault of the spline, in words.
    pub fn fault(&self) -> Option<String> {
        let (degree, count) = (self.degree, self.points.len());
        if !(1..=HIGHEST_DEGREE).contains(&degree) {
            return Some(format!(
                "a spline of degree {degree}, allowed is 1 … {HIGHEST_DEGREE}"
            ));
        }
        if count <= degree || self.knots.len() != count + degree + 1 {
            let knots = self.knots.len();
            return Some(format!(
                "a spline of degree {degree} with {count} control points and {knots} knots, expected more than {degree} points and {} knots",
                count + degree + 1
            ));
        }
        if self.knots.windows(2).any(|pair| !(pair[0] <= pair[1])) {
            return Some("a spline whose knots do not ascend".to_owned());
        }
        if !self.weights.is_empty() && self.weights.len() != count {
            return Some(format!(
                "a spline with {} weights of {count} control points",
                self.weights.len()
            ));
        }
        if self
            .weights
            .iter()
            .any(|&weight| !(1e-6..=1e6).contains(&weight))
        {
            return Some("a spline with a weight outside 1e-6 … 1e6".to_owned());
        }
        // A knot of more than `degree` inside tears the curve.
        let inside = &self.knots[1..self.knots.len() - 1];
        let torn = |run: &[f64]| run[0] == run[degree];
        if inside.windows(degree + 1).any(torn) {
            return Some(format!(
                "a spline of degree {degree} with an inner knot of higher multiplicity"
            ));
        }
        None
    }

    /// Its segments; `None` where their bound exceeds 0.01 µm. The spline must have no [`fault`](BSpline::fault).
    pub fn curve(&self) -> Option<Curve> {
        let equal = self.weights.windows(2).all(|pair| pair[0] == pair[1]);
        let mut curve = Curve::default();
        for span in self.degree..self.points.len() {
            if self.knots[span] == self.knots[span + 1] {
                continue;
            }
            let piece = self.piece(span, equal);
            match exact(&piece).filter(|_| equal) {
                Some(segment) => curve.segments.push(segment),
                None => fit_cubics(&piece, MAX_HALVINGS, &mut curve)?,
            }
        }
        Some(curve)
    }

    /// Bézier points of the part between two knots, by the blossom (Ramshaw; Prautzsch, Boehm, Paluszny: Bézier and B-Spline
    /// Techniques, ch. 5): point k has `degree − k` arguments at the first knot and k at the second.
    fn piece(&self, span: usize, equal: bool) -> Vec<Vector3<f64>> {
        let degree = self.degree;
        let ends = [self.knots[span], self.knots[span + 1]];
        let point = |count: usize| {
            let mut at: Vec<Vector3<f64>> = (span - degree..=span)
                .map(|index| {
                    let weight = if equal { 1.0 } else { self.weights[index] };
                    (self.points[index].coords * weight).push(weight)
                })
                .collect();
            for round in 1..=degree {
                let argument = ends[usize::from(round <= count)];
                for index in (round..=degree).rev() {
                    let low = self.knots[span - degree + index];
                    let high = self.knots[span + 1 + index - round];
                    let share = (argument - low) / (high - low);
                    at[index] = at[index - 1] * (1.0 - share) + at[index] * share;
                }
            }
            at[degree]
        };
        (0..=degree).map(point).collect()
    }
}

/// The point of the plane for homogeneous coordinates.
fn plane(point: &Vector3<f64>) -> Point2<f64> {
    Point2::from(point.xy() / point.z)
}

/// The piece without its weights, exact: a line, or a cubic curve with raised degree; `None` above degree 3.
fn exact(piece: &[Vector3<f64>]) -> Option<PathSegment> {
    let points: Vec<Point2<f64>> = piece.iter().map(plane).collect();
    match points[..] {
        [a, b] => Some(PathSegment::Line([a, b])),
        [a, b, c] => Some(PathSegment::Cubic(raised([a, b, c]))),
        [a, b, c, d] => Some(PathSegment::Cubic([a, b, c, d])),
        _ => None,
    }
}

/// The control points of a quadratic Bézier curve as a cubic one.
pub fn raised([a, b, c]: [Point2<f64>; 3]) -> [Point2<f64>; 4] {
    [a, a + (b - a) * (2.0 / 3.0), c + (b - c) * (2.0 / 3.0), c]
}

/// Adds cubic curves that follow a rational Bézier curve, halved as often as needed.
fn fit_cubics(piece: &[Vector3<f64>], halvings: u32, curve: &mut Curve) -> Option<()> {
    let cubic = hermite(piece);
    let bound = distance(piece, &cubic);
    if bound <= FIT_MM {
        curve.add(Curve {
            bound,
            ..Curve::exact(PathSegment::Cubic(cubic))
        });
        return Some(());
    }
    let halvings = halvings
        .checked_sub(1)
        .filter(|_| curve.segments.len() <= MAX_SEGMENTS)?;
    let [left, right] = halves(piece);
    fit_cubics(&left, halvings, curve)?;
    fit_cubics(&right, halvings, curve)
}

/// The cubic curve with the ends and the end derivatives of a rational Bézier curve.
fn hermite(piece: &[Vector3<f64>]) -> [Point2<f64>; 4] {
    let last = piece.len() - 1;
    let third = |from: &Vector3<f64>, to: &Vector3<f64>| -> Vector2<f64> {
        (plane(to) - plane(from)) * (last as f64 * to.z / from.z / 3.0)
    };
    let (start, end) = (plane(&piece[0]), plane(&piece[last]));
    [
        start,
        start + third(&piece[0], &piece[1]),
        end + third(&piece[last], &piece[last - 1]),
        end,
    ]
}

/// A bound on the distance of points with equal parameter on the rational curve N/w and on the cubic q.
///
/// (N − w q) is a Bézier curve of degree n + 3, within the hull of its control points; w is no less than its least one.
fn distance(piece: &[Vector3<f64>], curve: &[Point2<f64>; 4]) -> f64 {
    let degree = piece.len() - 1;
    let least = piece.iter().map(|point| point.z).fold(f64::MAX, f64::min);
    let control = |index: usize| {
        // The product of both: Σ C(n,i) C(3,j) / C(n+3,i+j) a_i b_j over i + j = index.
        let pairs = (index.saturating_sub(3)..=index.min(degree)).map(|i| (i, index - i));
        let terms = pairs.map(|(i, j)| {
            let share = binomial(degree, i) * binomial(3, j) / binomial(degree + 3, index);
            (piece[i].xy() - curve[j].coords * piece[i].z) * share
        });
        terms.sum::<Vector2<f64>>().norm()
    };
    (0..=degree + 3).map(control).fold(0.0, f64::max) / least
}

fn binomial(of: usize, count: usize) -> f64 {
    (0..count).fold(1.0, |product, index| {
        product * (of - index) as f64 / (index + 1) as f64
    })
}

/// Both halves of a Bézier curve (de Casteljau).
fn halves(piece: &[Vector3<f64>]) -> [Vec<Vector3<f64>>; 2] {
    let mut row = piece.to_vec();
    let (mut left, mut right) = (vec![row[0]], vec![row[row.len() - 1]]);
    while row.len() > 1 {
        row = row
            .windows(2)
            .map(|pair| 0.5 * (pair[0] + pair[1]))
            .collect();
        left.push(row[0]);
        right.push(row[row.len() - 1]);
    }
    right.reverse();
    [left, right]
}

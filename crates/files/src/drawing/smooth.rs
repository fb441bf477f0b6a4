//! A closed curve of continuous curvature through points.

use gearlash::outline::PathSegment;
use nalgebra::{Point2, Vector2};

/// The periodic cubic spline through `points`, at least three and each apart from the next, with the chord as parameter: the first
/// and second derivatives are continuous all around (de Boor: A Practical Guide to Splines, ch. IV).
pub fn closed_spline(points: &[Point2<f64>]) -> Vec<PathSegment> {
    let count = points.len();
    let chord = |index: usize| points[(index + 1) % count] - points[index % count];
    let lengths: Vec<f64> = (0..count).map(|index| chord(index).norm()).collect();
    // h_i m_{i−1} + 2 (h_{i−1} + h_i) m_i + h_{i−1} m_{i+1} = 3 (h_i d_{i−1} + h_{i−1} d_i), of the slopes m and d = chord/h.
    let rows: Vec<[f64; 3]> = (0..count)
        .map(|index| {
            let (before, here) = (lengths[(index + count - 1) % count], lengths[index]);
            [here, 2.0 * (before + here), before]
        })
        .collect();
    let right: Vec<Vector2<f64>> = (0..count)
        .map(|index| {
            let previous = (index + count - 1) % count;
            let (before, here) = (lengths[previous], lengths[index]);
            3.0 * (chord(previous) * (here / before) + chord(index) * (before / here))
        })
        .collect();
    let slopes = cyclic(&rows, right);
    let segment = |index: usize| {
        let (next, third) = ((index + 1) % count, lengths[index] / 3.0);
        PathSegment::Cubic([
            points[index],
            points[index] + slopes[index] * third,
            points[next] - slopes[next] * third,
            points[next],
        ])
    };
    (0..count).map(segment).collect()
}

/// Solves a cyclic tridiagonal system with a dominant diagonal: its corners are a matrix of rank one (Sherman, Morrison).
///
/// A row holds the elements before, on and behind the diagonal.
fn cyclic(rows: &[[f64; 3]], right: Vec<Vector2<f64>>) -> Vec<Vector2<f64>> {
    let last = rows.len() - 1;
    let (upper, lower) = (rows[0][0], rows[last][2]);
    let pivot = -rows[0][1];
    let mut inner = rows.to_vec();
    inner[0][1] -= pivot;
    inner[last][1] -= upper * lower / pivot;
    let mut corner = vec![Vector2::zeros(); rows.len()];
    corner[0].x = pivot;
    corner[last].x = lower;
    let (solved, corner) = (tridiagonal(&inner, right), tridiagonal(&inner, corner));
    let corner: Vec<f64> = corner.iter().map(|value| value.x).collect();
    let share = upper / pivot;
    let factor = (solved[0] + solved[last] * share) / (1.0 + corner[0] + corner[last] * share);
    let corrected = |(value, along): (&Vector2<f64>, &f64)| value - factor * *along;
    solved.iter().zip(&corner).map(corrected).collect()
}

/// Solves a tridiagonal system with a dominant diagonal (Thomas).
fn tridiagonal(rows: &[[f64; 3]], mut right: Vec<Vector2<f64>>) -> Vec<Vector2<f64>> {
    let mut behind = vec![0.0; rows.len()];
    for index in 0..rows.len() {
        let [before, on, after] = rows[index];
        let (known, value) = match index {
            0 => (0.0, Vector2::zeros()),
            _ => (behind[index - 1], right[index - 1]),
        };
        let pivot = if index == 0 { on } else { on - before * known };
        behind[index] = after / pivot;
        right[index] = match index {
            0 => right[0] / pivot,
            _ => (right[index] - value * before) / pivot,
        };
    }
    for index in (0..rows.len() - 1).rev() {
        let next = right[index + 1];
        right[index] -= next * behind[index];
    }
    right
}

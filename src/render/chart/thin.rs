//! Thinning a line that has more points than a chart has columns, without losing an extreme.

use super::panel::Point;

/// `points` in runs without gaps; where a column holds more than four of a run, its first, least, greatest
/// and last point stand for it, in their order. `column` is a column's width in data.
pub(super) fn runs(points: &[Point], column: f64) -> Vec<Vec<(f64, f64)>> {
    let whole = points.split(|(_, y)| y.is_none());
    let runs = whole.filter(|run| !run.is_empty());
    runs.map(|run| {
        let known: Vec<(f64, f64)> = run.iter().filter_map(|&(x, y)| Some((x, y?))).collect();
        let columns = known.chunk_by(|a, b| (a.0 / column).floor() == (b.0 / column).floor());
        columns.flat_map(representatives).collect()
    })
    .collect()
}

fn representatives(column: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if column.len() <= 4 {
        return column.to_vec();
    }
    let by = |better: fn(f64, f64) -> bool| {
        let indices = 0..column.len();
        indices.reduce(|best, next| match better(column[next].1, column[best].1) {
            true => next,
            false => best,
        })
    };
    let mut kept: Vec<usize> = [
        Some(0),
        by(|a, b| a < b),
        by(|a, b| a > b),
        Some(column.len() - 1),
    ]
    .into_iter()
    .flatten()
    .collect();
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|index| column[index]).collect()
}

//! Thinning a line that has more points than a chart has columns, without losing an extreme.

use super::panel::Point;

/// `points` in runs without gaps. Where a column holds more than four points of a run, it keeps the first, least, greatest and
/// last in their order. `column` is a column's width in data.
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

/// Both edges of a band where it has both, thinned like [`runs`]. They can have points at different places.
pub(super) fn bands(low: &[Point], high: &[Point], column: f64) -> Vec<[Vec<(f64, f64)>; 2]> {
    let (lows, highs) = (runs(low, column), runs(high, column));
    let ends = |run: &[(f64, f64)]| {
        let [one, other] = [run[0].0, run[run.len() - 1].0];
        [one.min(other), one.max(other)]
    };
    let pairs = lows
        .iter()
        .flat_map(|low| highs.iter().map(move |high| [low, high]));
    let common = pairs.filter_map(|edges| {
        let [one, other] = edges.map(|run| ends(run));
        let (from, to) = (one[0].max(other[0]), one[1].min(other[1]));
        let within = |run: &Vec<(f64, f64)>| -> Vec<(f64, f64)> {
            let inside = run.iter().filter(|point| (from..=to).contains(&point.0));
            inside.copied().collect()
        };
        let edges = edges.map(within);
        edges.iter().all(|edge| !edge.is_empty()).then_some(edges)
    });
    common.collect()
}

fn representatives(column: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if column.len() <= 4 {
        return column.to_vec();
    }
    let by = |better: fn(f64, f64) -> bool| {
        let indices = 0..column.len();
        indices.reduce(|best, next| {
            if better(column[next].1, column[best].1) {
                next
            } else {
                best
            }
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// A thinned line has the outline of the line: every column keeps its ends and extremes.
        #[test]
        fn no_column_loses_an_extreme(values in prop::collection::vec(-9.0..9.0f64, 1..400), column in 0.5..50.0f64) {
            let points: Vec<Point> = values.iter().enumerate().map(|(x, y)| (x as f64, Some(*y))).collect();
            let thinned = runs(&points, column).concat();
            prop_assert!(thinned.is_sorted_by(|a, b| a.0 < b.0));
            for (x, _) in &points {
                let here = |x: &f64| (x / column).floor();
                let of = |(a, y): (f64, f64)| (here(&a) == here(x)).then_some(y);
                let all: Vec<f64> = points.iter().filter_map(|&(a, y)| of((a, y?))).collect();
                let kept: Vec<f64> = thinned.iter().filter_map(|&point| of(point)).collect();
                prop_assert!(kept.len() <= 4);
                for pick in [f64::min, f64::max] {
                    let end = |list: &[f64]| list.iter().copied().reduce(pick);
                    prop_assert_eq!(end(&all), end(&kept));
                }
                prop_assert_eq!((all.first(), all.last()), (kept.first(), kept.last()));
            }
        }
    }

    #[test]
    fn a_gap_parts_a_line_and_both_edges_of_a_band() {
        let low = [
            (0.0, Some(1.0)),
            (1.0, None),
            (2.0, Some(1.0)),
            (3.0, Some(2.0)),
        ];
        let high = [
            (0.0, Some(3.0)),
            (1.0, Some(3.0)),
            (2.0, None),
            (3.0, Some(4.0)),
        ];
        assert_eq!(
            runs(&low, 1.0),
            [vec![(0.0, 1.0)], vec![(2.0, 1.0), (3.0, 2.0)]]
        );
        let bands = bands(&low, &high, 1.0);
        assert_eq!(
            bands,
            [[[(0.0, 1.0)], [(0.0, 3.0)]], [[(3.0, 2.0)], [(3.0, 4.0)]]]
        );
    }
}

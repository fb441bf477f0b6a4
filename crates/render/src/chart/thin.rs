//! Lines that have more points than a chart has columns, or that oscillate so often that they would be a solid block.

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

/// Density of a line on the sheet.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Overplotting {
    /// The line can be followed.
    Clear,
    /// A thin line can be followed.
    Dense,
    /// The line cannot be followed: the envelope of its least and greatest values, each within about one swing.
    Solid([Vec<(f64, f64)>; 2]),
}

/// Length per width from which a line is dense (tuned: a rig's difference with its 45 spikes, 9 times its width, is easier to
/// read thin).
const DENSE: f64 = 4.0;
/// Mean width of a swing below which a line is solid, units (tuned: 8.2 are a block in two lines, 14.7 are not).
const NARROW: f64 = 10.0;
/// Rises below this height are no swing, units: a stroke's width, so that rounding on a plateau does not count.
const LOW: f64 = 1.5;
pub(super) const FINE: f64 = 0.6;
/// Opacity between the edges.
pub(super) const FILL: f64 = 0.25;
/// Distance of neighbouring points of an edge, units.
const STEP: f64 = 1.0;

/// Classifies `run`, a line without gaps, at `scale` (units of the sheet per unit of data, across and up).
pub(super) fn overplotting(run: &[(f64, f64)], scale: [f64; 2]) -> Overplotting {
    let (Some(first), Some(last)) = (run.first(), run.last()) else {
        return Overplotting::Clear;
    };
    let width = (last.0 - first.0) * scale[0];
    let rises = run.windows(2).map(|pair| pair[1].1 - pair[0].1);
    let length = rises.map(f64::abs).sum::<f64>() * scale[1];
    if length < DENSE * width {
        return Overplotting::Clear;
    }
    let swing = width / swings(run, LOW / scale[1]);
    // At least one swing, or the edges would swing with the line. In whole units of data, which are pitches or teeth wherever
    // lines swing: whole periods.
    let window = (f64::max(swing, 2.0 * STEP) / scale[0]).ceil();
    // A window that covers much of the line would draw a box.
    if swing < NARROW && window < 0.25 * (last.0 - first.0) {
        Overplotting::Solid(edges(run, window, STEP / scale[0]))
    } else {
        Overplotting::Dense
    }
}

/// The number of times that `run` goes up and down again, by more than `least`.
fn swings(run: &[(f64, f64)], least: f64) -> f64 {
    let (mut turns, mut up) = (0_u32, None);
    let [mut low, mut high] = [run[0].1; 2];
    for &(_, value) in run {
        (low, high) = (low.min(value), high.max(value));
        let turned = match up {
            Some(true) | None if high - value > least => Some(false),
            Some(false) | None if value - low > least => Some(true),
            _ => None,
        };
        if turned.is_some() {
            (up, low, high) = (turned, value, value);
            turns += 1;
        }
    }
    0.5 * f64::from(turns.max(1))
}

/// The least and the greatest value of `run` within a `window` that slides from end to end, each at its middle, both in data.
/// They are level for a periodic line, and never outside the line's own nearby range.
fn edges(run: &[(f64, f64)], window: f64, step: f64) -> [Vec<(f64, f64)>; 2] {
    let ends = [run[0].0, run[run.len() - 1].0];
    let places = ((ends[1] - ends[0]) / step).ceil() as u32;
    let place = |number: u32| {
        let part = f64::from(number) / f64::from(places);
        ends[0] + part * (ends[1] - ends[0])
    };
    [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| {
        let values = (0..=places).filter_map(|number| {
            let from = (place(number) - 0.5 * window).clamp(ends[0], ends[1] - window);
            let inside = &run[run.partition_point(|point| point.0 < from)..];
            let inside = inside.iter().take_while(|point| point.0 <= from + window);
            Some((place(number), inside.map(|point| point.1).reduce(pick)?))
        });
        corners(values.collect())
    })
}

/// Removes the points between equal neighbours.
fn corners(edge: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let last = edge.len() - 1;
    let level = |i: usize| edge[i - 1].1 == edge[i].1 && edge[i].1 == edge[i + 1].1;
    let kept = (0..edge.len()).filter(|&i| i == 0 || i == last || !level(i));
    kept.map(|i| edge[i]).collect()
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
        let at = |values: [Option<f64>; 4]| [0.0, 1.0, 2.0, 3.0].into_iter().zip(values).collect();
        let low: Vec<Point> = at([Some(1.0), None, Some(1.0), Some(2.0)]);
        let high: Vec<Point> = at([Some(3.0), Some(3.0), None, Some(4.0)]);
        let expected = [vec![(0.0, 1.0)], vec![(2.0, 1.0), (3.0, 2.0)]];
        assert_eq!(runs(&low, 1.0), expected);
        let expected = [[[(0.0, 1.0)], [(0.0, 3.0)]], [[(3.0, 2.0)], [(3.0, 4.0)]]];
        assert_eq!(bands(&low, &high, 1.0), expected);
    }

    fn swings(count: u32, height: f64) -> Vec<(f64, f64)> {
        let point = |i: u32| {
            let x = 700.0 * f64::from(i) / f64::from(8 * count);
            let angle = std::f64::consts::TAU * f64::from(i) / 8.0;
            (x, height * angle.sin())
        };
        (0..=8 * count).map(point).collect()
    }

    #[test]
    fn a_few_swings_are_a_line_and_many_are_their_edges() {
        assert_eq!(
            overplotting(&swings(3, 100.0), [1.0, 1.0]),
            Overplotting::Clear
        );
        assert_eq!(
            overplotting(&swings(60, 100.0), [1.0, 1.0]),
            Overplotting::Dense
        );
        let Overplotting::Solid([low, high]) = overplotting(&swings(172, 100.0), [1.0, 1.0]) else {
            panic!("172 swings over 700 units are 4 units wide");
        };
        for (edge, value) in [(low, -100.0), (high, 100.0)] {
            assert_eq!(edge.len(), 2, "{edge:?}");
            assert_eq!((edge[0].0, edge[1].0), (0.0, 700.0));
            assert!(edge.iter().all(|point| (point.1 - value).abs() < 1e-9));
        }
    }

    /// Rounding on a plateau between swings is no swing.
    #[test]
    fn noise_on_a_plateau_is_no_swing() {
        let mut run = swings(15, 100.0);
        for pair in run.chunks_mut(2) {
            pair[0].1 += 1e-6;
        }
        let plain = super::swings(&swings(15, 100.0), 1.5);
        assert_eq!(super::swings(&run, 1.5), plain);
        assert_eq!(overplotting(&run, [1.0, 1.0]), Overplotting::Dense);
    }

    #[test]
    fn no_edge_loses_the_extreme() {
        let mut run = swings(172, 100.0);
        run[333].1 = 500.0;
        let Overplotting::Solid([_, high]) = overplotting(&run, [1.0, 1.0]) else {
            panic!("as above");
        };
        let highest = high.iter().map(|point| point.1).reduce(f64::max);
        assert_eq!(highest, Some(500.0));
    }
}

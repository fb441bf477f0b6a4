//! Lines that oscillate so often that they would be a solid block.

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
/// Mean width of a swing below which a line is solid, units: dashes and strokes of two lines are no longer separate.
const NARROW: f64 = 7.0;
/// Rises below this height are no swing, units: a stroke's width, so that rounding on a plateau does not count.
const LOW: f64 = 1.5;
/// Width of a dense line, as a share of a normal one.
pub(super) const FINE: f64 = 0.6;
/// Opacity between the edges.
pub(super) const FILL: f64 = 0.25;
/// Distance of neighbouring points of an edge, units.
const STEP: f64 = 1.0;

/// Classifies `run`, a line without gaps, at `scale` (units of the sheet per unit of data, across and up).
pub(super) fn of(run: &[(f64, f64)], scale: [f64; 2]) -> Overplotting {
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

    fn swings(count: u32, height: f64) -> Vec<(f64, f64)> {
        let point = |i: u32| {
            let x = 700.0 * f64::from(i) / f64::from(8 * count);
            (
                x,
                height * (std::f64::consts::TAU * f64::from(i) / 8.0).sin(),
            )
        };
        (0..=8 * count).map(point).collect()
    }

    #[test]
    fn a_few_swings_are_a_line_and_many_are_their_edges() {
        assert_eq!(of(&swings(3, 100.0), [1.0, 1.0]), Overplotting::Clear);
        assert_eq!(of(&swings(86, 100.0), [1.0, 1.0]), Overplotting::Dense);
        let Overplotting::Solid([low, high]) = of(&swings(172, 100.0), [1.0, 1.0]) else {
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
        assert_eq!(
            super::swings(&run, 1.5),
            super::swings(&swings(15, 100.0), 1.5)
        );
        assert_eq!(of(&run, [1.0, 1.0]), Overplotting::Dense);
    }

    #[test]
    fn no_edge_loses_the_extreme() {
        let mut run = swings(172, 100.0);
        run[333].1 = 500.0;
        let Overplotting::Solid([_, high]) = of(&run, [1.0, 1.0]) else {
            panic!("as above");
        };
        let highest = high.iter().map(|point| point.1).reduce(f64::max);
        assert_eq!(highest, Some(500.0));
    }
}

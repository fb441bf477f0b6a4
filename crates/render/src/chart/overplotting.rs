//! Lines that go up and down so often that they would be a solid block.

/// How dense a line is on the sheet.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Overplotting {
    /// Can be followed.
    Clear,
    /// Can be followed where it is thin.
    Dense,
    /// Cannot be followed: its lower and its upper edge, each swing within them.
    Solid([Vec<(f64, f64)>; 2]),
}

/// Length over width from which a line is dense, and from which it is solid (tuned: a rig's difference with its
/// 45 spikes, 9 times its width, can be read; a swing a tooth over 86 teeth, 30 times, cannot).
const DENSE: f64 = 4.0;
const SOLID: f64 = 14.0;
/// Width of a dense line, as a part of its own.
pub(super) const FINE: f64 = 0.6;
/// Fill between the edges.
pub(super) const FILL: f64 = 0.25;
/// Least width of a window of which the edges are taken, units, and swings in it.
const LEAST: f64 = 12.0;
const SWINGS: f64 = 1.5;
/// Windows a line must have to be drawn by its edges.
const FEWEST: f64 = 6.0;

/// What `run`, a line without gaps, is at `scale` (units of the sheet a unit of data, across and up).
pub(super) fn of(run: &[(f64, f64)], scale: [f64; 2]) -> Overplotting {
    let (Some(first), Some(last)) = (run.first(), run.last()) else {
        return Overplotting::Clear;
    };
    let width = (last.0 - first.0) * scale[0];
    let rises = || {
        run.windows(2)
            .map(|pair| (pair[1].1 - pair[0].1) * scale[1])
    };
    let length = rises().map(f64::abs).sum::<f64>();
    if length < DENSE * width {
        return Overplotting::Clear;
    }
    let ways: Vec<bool> = rises()
        .filter(|rise| *rise != 0.0)
        .map(|rise| rise > 0.0)
        .collect();
    let turns = ways.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let window = f64::max(LEAST, SWINGS * 2.0 * width / turns.max(1) as f64);
    if length < SOLID * width || width < FEWEST * window {
        return Overplotting::Dense;
    }
    Overplotting::Solid(edges(run, window / scale[0]))
}

/// The least and the greatest value of each `window` (data) of `run`, at its middle, from end to end.
fn edges(run: &[(f64, f64)], window: f64) -> [Vec<(f64, f64)>; 2] {
    let ends = [run.first(), run.last()].map(|end| end.map_or(0.0, |end| end.0));
    let windows = ((ends[1] - ends[0]) / window).round().max(1.0);
    let window = (ends[1] - ends[0]) / windows;
    let place = |x: f64| (((x - ends[0]) / window).floor()).min(windows - 1.0);
    [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| {
        let chunks = run.chunk_by(|a, b| place(a.0) == place(b.0));
        let middles = chunks.filter_map(|chunk| {
            let value = chunk.iter().map(|point| point.1).reduce(pick)?;
            Some((ends[0] + (place(chunk[0].0) + 0.5) * window, value))
        });
        let mut edge: Vec<(f64, f64)> = middles.collect();
        if let (Some(&first), Some(&last)) = (edge.first(), edge.last()) {
            edge.insert(0, (ends[0], first.1));
            edge.push((ends[1], last.1));
        }
        edge
    })
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
        assert_eq!(of(&swings(15, 100.0), [1.0, 1.0]), Overplotting::Dense);
        let Overplotting::Solid([low, high]) = of(&swings(86, 100.0), [1.0, 1.0]) else {
            panic!("86 swings of 200 units over 700 are 49 times its width");
        };
        for (edge, value) in [(&low, -100.0), (&high, 100.0)] {
            assert!(
                edge.iter().all(|point| (point.1 - value).abs() < 1e-9),
                "{edge:?}"
            );
            assert_eq!((edge[0].0, edge[edge.len() - 1].0), (0.0, 700.0));
        }
    }

    #[test]
    fn no_edge_loses_the_extreme() {
        let mut run = swings(86, 100.0);
        run[333].1 = 500.0;
        let Overplotting::Solid([_, high]) = of(&run, [1.0, 1.0]) else {
            panic!("as above");
        };
        assert_eq!(
            high.iter().map(|point| point.1).reduce(f64::max),
            Some(500.0)
        );
    }
}

//! Stretches of a line in which a condition holds, from samples.

use crate::numeric::bisect;

/// Accuracy of the ends of a stretch, mm along the face.
pub const STRETCH_END: f64 = 1e-6;

/// The stretches in which `holds`, ascending. `looks` are samples at ascending places. Bisection between two of them
/// finds each end to within [`STRETCH_END`]. A stretch between two samples is missed.
pub(super) fn stretches(looks: &[(f64, bool)], holds: impl Fn(f64) -> bool) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    let mut begin = looks.first().filter(|look| look.1).map(|look| look.0);
    for pair in looks.windows(2) {
        let [(from, before), (to, after)] = [pair[0], pair[1]];
        match (before, after) {
            (false, true) => begin = Some(bisect(to, from, STRETCH_END, &holds)[0]),
            (true, false) => {
                let [end, _] = bisect(from, to, STRETCH_END, &holds);
                found.extend(begin.take().map(|begin| [begin, end]));
            }
            _ => {}
        }
    }
    let end = looks.last().map(|look| look.0);
    found.extend(begin.zip(end).map(|(begin, end)| [begin, end]));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Closed form: sin x > 0.5 between π/6 and 5π/6, and again a turn later, limited by the last sample.
    #[test]
    fn stretches_end_where_the_sine_crosses() {
        use std::f64::consts::PI;
        let holds = |x: f64| x.sin() > 0.5;
        let last = 2.5 * PI;
        let looks: Vec<(f64, bool)> = (0..=40)
            .map(|k| last * f64::from(k) / 40.0)
            .map(|x| (x, holds(x)))
            .collect();
        let found = stretches(&looks, holds);
        let expected = [[PI / 6.0, 5.0 * PI / 6.0], [13.0 * PI / 6.0, last]];
        assert_eq!(found.len(), 2);
        for (found, expected) in found.iter().zip(expected) {
            for (end, at) in found.iter().zip(expected) {
                assert!((end - at).abs() <= STRETCH_END, "{end} {at}");
            }
        }
        assert!(stretches(&[(0.0, false), (1.0, false)], holds).is_empty());
        assert_eq!(stretches(&[(0.6, true), (0.9, true)], holds), [[0.6, 0.9]]);
    }
}

//! The numbers along an axis.

use gearlash_files::numbers::{decimals_of, fixed};
use plotters::coord::ranged1d::{BoldPoints, Ranged};
use plotters::coord::types::RangedCoordf64;

/// Decimals beyond which a tick is no longer told from its neighbour by f64.
const MOST_DECIMALS: usize = 15;
/// How far a tick's number may lie off the tick, parts of the step: rounding of the ticks, far below what is seen.
const OFF: f64 = 1e-6;

/// Ticks of an axis of values.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ticks {
    /// Where they stand, ascending.
    pub at: Vec<f64>,
    decimals: usize,
}

impl Ticks {
    /// At most `most` over `range`, as `plotters` sets them, with as many decimals as the step has.
    pub fn new(range: [f64; 2], most: usize) -> Ticks {
        let axis = RangedCoordf64::from(range[0]..range[1]);
        let at = axis.key_points(BoldPoints(most));
        let step = match at[..] {
            [first, second, ..] => second - first,
            _ => range[1] - range[0],
        };
        let decimals = decimals_of(&at, OFF * step.abs(), MOST_DECIMALS);
        Ticks { at, decimals }
    }

    /// The number of the tick at `value`.
    pub fn number(&self, value: f64) -> String {
        fixed(value, self.decimals)
    }
}

#[cfg(test)]
mod tests {
    use super::Ticks;
    use proptest::prelude::*;
    use std::collections::HashSet;

    /// Every tick reads as what it is, none as its neighbour.
    fn assert_told(range: [f64; 2], most: usize) {
        let ticks = Ticks::new(range, most);
        let step = ticks.at.windows(2).map(|pair| pair[1] - pair[0]);
        let step = step.fold(f64::INFINITY, f64::min);
        let mut seen = HashSet::new();
        for value in &ticks.at {
            let text = ticks.number(*value);
            let read: f64 = text.replace('−', "-").parse().unwrap();
            let decimals = text.split_once('.').map_or(0, |(_, digits)| digits.len());
            let last = 10f64.powi(-(decimals as i32));
            assert!((read - value).abs() <= 0.5 * last, "{text} at {value}");
            assert!(
                (read - value).abs() <= 1e-3 * step,
                "{text} at {value}, step {step}"
            );
            assert!(seen.insert(text.clone()), "{text} twice: {:?}", ticks.at);
        }
    }

    /// Review of issue 6: half micrometres without a decimal read 0, 0, −1, −1, −2, −2, −3.
    #[test]
    fn half_micrometres_have_a_decimal() {
        assert_told([-3.36, 0.3], 7);
        let ticks = Ticks::new([-3.36, 0.3], 7);
        let read = ticks.at.iter().map(|value| ticks.number(*value));
        assert!(read.into_iter().any(|text| text == "−0.5"));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn numbers_are_distinct_and_those_of_their_ticks(
            middle in -1000.0..1000.0f64, digits in 1.0..9.99f64, power in -4..4i32, most in 2..15usize,
        ) {
            let half = 0.5 * digits * 10f64.powi(power);
            assert_told([middle - half, middle + half], most);
            // Zero in sight, as in a chart of differences.
            assert_told([-1.8 * half, 0.2 * half], most);
        }
    }
}

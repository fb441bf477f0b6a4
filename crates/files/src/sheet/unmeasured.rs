//! Numbers that stand for a value that was not measured.

use super::number::Written;

/// What such machines print, whatever the preamble says.
const KNOWN: [f64; 2] = [-2147483.648, -9999.0];

/// Those of one file.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unmeasured {
    /// `UNDEFINED` of the preamble.
    said: Option<f64>,
}

impl Unmeasured {
    /// With the number that a preamble names.
    pub fn said(number: f64) -> Unmeasured {
        Unmeasured { said: Some(number) }
    }

    /// What `value` is where it is one of them, in words.
    pub fn words(self, value: &Written) -> &'static str {
        match Unmeasured::default().is(value) {
            true => "stands for a value that was not measured",
            false => "stands for a value that was not measured, as UNDEFINED of the preamble says",
        }
    }

    /// Whether `value` is one of them, as far as its digits say; never by its size.
    pub fn is(self, value: &Written) -> bool {
        // Whole numbers at most: 1e7 has its last digit seven places above them.
        let rounding = value.rounding.min(0.5);
        let mut numbers = KNOWN.into_iter().chain(self.said);
        numbers.any(|number| (value.value - number).abs() <= rounding + 1e-12 * number.abs())
    }
}

//! The distribution of one length over a population, in integer sums that do not depend on order.

use std::collections::BTreeMap;

/// Whole tenths of a nanometre in a millimetre.
pub const TENTHS_NM_PER_MM: f64 = 1e7;

/// `mm` in whole tenths of a nanometre. A length that `i64` cannot hold becomes the nearest that it can.
pub(super) fn tenths(mm: f64) -> i64 {
    (mm * TENTHS_NM_PER_MM).round() as i64
}

/// Width of a bin of the histogram, tenths of a nanometre.
pub const BIN_TENTHS_NM: i64 = 100;

/// Overflow of 128-bit sums: lengths of metres, or far too many assemblies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the sums over the population do not fit 128 bits")]
pub struct Overflow;

/// One length over a population, in whole tenths of a nanometre.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Spread {
    /// Number of assemblies that have the length.
    pub count: u64,
    /// Sum of the lengths.
    pub sum: i128,
    /// Sum of their squares.
    pub squares: i128,
    /// Count of each bin of [`BIN_TENTHS_NM`] that is not empty: bin `b` reaches from `b` widths up to, not including, `b + 1`.
    pub histogram: BTreeMap<i64, u64>,
    /// The least length, and the first assembly that has it.
    pub least: Option<(i64, u64)>,
    /// The greatest length, and the first assembly that has it.
    pub greatest: Option<(i64, u64)>,
}

impl Spread {
    /// Adds the `length` of assembly `number`.
    ///
    /// # Errors
    /// [`Overflow`].
    pub fn add(&mut self, length: i64, number: u64) -> Result<(), Overflow> {
        let wide = i128::from(length);
        self.count += 1;
        self.sum = self.sum.checked_add(wide).ok_or(Overflow)?;
        self.squares = self.squares.checked_add(wide * wide).ok_or(Overflow)?;
        *self
            .histogram
            .entry(length.div_euclid(BIN_TENTHS_NM))
            .or_default() += 1;
        let one = (length, number);
        self.least = Some(self.least.map_or(one, |least| least.min(one)));
        self.greatest = Some(self.greatest.map_or(one, |greatest| {
            // The first assembly among equals.
            let is_greater = (length, greatest.1) > (greatest.0, number);
            if is_greater { one } else { greatest }
        }));
        Ok(())
    }
}

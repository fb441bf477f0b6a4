//! How one length is spread over a population, in sums of integers: the order in which they are added does not matter.

use std::collections::BTreeMap;

/// Lengths are counted in tenths of a nanometre: a tenth of the bracket that a proven extreme has.
pub const TENTHS_NM_PER_MM: f64 = 1e7;

/// Width of a bin of the histogram.
pub const BIN_TENTHS_NM: i64 = 100;

/// Sums that no longer fit: lengths of metres, or more assemblies than anyone draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the sums over the population do not fit 128 bits")]
pub struct Overflow;

/// One length over a population. Lengths inside are whole tenths of a nanometre.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Spread {
    /// How many have a length.
    pub count: u64,
    /// Sums of its first to fourth powers.
    pub sums: [i128; 4],
    /// How many in each bin of [`BIN_TENTHS_NM`] that has any: bin `b` is from `b` widths up to, not including, `b + 1`.
    pub histogram: BTreeMap<i64, u64>,
    /// The least, and the first assembly that has it.
    pub least: Option<(i64, u64)>,
    /// The greatest, and the first assembly that has it.
    pub greatest: Option<(i64, u64)>,
}

/// `mm` in whole tenths of a nanometre.
pub(super) fn tenths(mm: f64) -> i64 {
    // Beyond what i64 holds the cast saturates, and the fourth power overflows.
    (mm * TENTHS_NM_PER_MM).round() as i64
}

impl Spread {
    /// The spread of the length `mm` of assembly `number` alone.
    pub(super) fn of_one(mm: f64, number: u64) -> Result<Spread, Overflow> {
        let length = tenths(mm);
        let wide = i128::from(length);
        let power = |n| wide.checked_pow(n).ok_or(Overflow);
        Ok(Spread {
            count: 1,
            sums: [wide, power(2)?, power(3)?, power(4)?],
            histogram: BTreeMap::from([(length.div_euclid(BIN_TENTHS_NM), 1)]),
            least: Some((length, number)),
            greatest: Some((length, number)),
        })
    }

    /// Adds the spread of other assemblies.
    ///
    /// # Errors
    /// [`Overflow`].
    pub fn add(&mut self, other: &Spread) -> Result<(), Overflow> {
        self.count = self.count.checked_add(other.count).ok_or(Overflow)?;
        for (sum, other) in self.sums.iter_mut().zip(other.sums) {
            *sum = sum.checked_add(other).ok_or(Overflow)?;
        }
        for (&bin, count) in &other.histogram {
            *self.histogram.entry(bin).or_default() += count;
        }
        self.least = [self.least, other.least].into_iter().flatten().min();
        // Of equals the first assembly.
        let key = |&(length, number): &(i64, u64)| (length, std::cmp::Reverse(number));
        self.greatest = [self.greatest, other.greatest]
            .into_iter()
            .flatten()
            .max_by_key(key);
        Ok(())
    }
}

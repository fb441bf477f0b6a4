//! Mean and range of readings.

/// Arithmetic mean; NaN of none, which no gear has.
pub(super) fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len();
    values.sum::<f64>() / count as f64
}

/// Greatest less least, 0 of none.
pub(super) fn range(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let most = values.clone().fold(f64::NEG_INFINITY, f64::max);
    let least = values.fold(f64::INFINITY, f64::min);
    (most - least).max(0.0)
}

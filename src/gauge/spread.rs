//! Mean and range of readings.

/// Arithmetic mean; NaN without values, which no gear has.
pub(super) fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len();
    values.sum::<f64>() / count as f64
}

/// Least and greatest; infinities without values, which no gear has.
pub(super) fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    )
}

/// Greatest less least; 0 without values.
pub(super) fn range(values: impl Iterator<Item = f64>) -> f64 {
    let [least, most] = ends(values);
    (most - least).max(0.0)
}

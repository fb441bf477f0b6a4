//! Deviations as a test needs them.

/// Reproducible values between −1 and 1, with mean zero.
pub fn made_up(count: u32, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let values = (0..count).map(|_| {
        // Knuth's MMIX generator.
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    });
    let values: Vec<f64> = values.collect();
    let mean = values.iter().sum::<f64>() / f64::from(count);
    values.into_iter().map(|value| value - mean).collect()
}

/// Each of `values` times `by`.
pub fn scaled(values: &[f64], by: f64) -> Vec<f64> {
    values.iter().map(|value| value * by).collect()
}

//! Limits of the size of a study, and ranges in words.

use std::ops::RangeInclusive;

/// "a whole number, 3 … 10 000".
pub fn whole_in(range: &RangeInclusive<u32>) -> String {
    let (low, high) = (range.start(), range.end());
    if *high < 10_000 {
        format!("a whole number, {low} … {high}")
    } else {
        format!("a whole number, {low} … {} {:03}", high / 1000, high % 1000)
    }
}

/// Poses of a study, over all centre distances and materials: their result fills 27 GB.
pub const MOST_POSES: u64 = 10_000_000;

/// Bytes that a pose takes in a result as JSON, about: 900 where a pair is jammed to 2250 with tip corners.
pub const POSE_BYTES_JSON: u64 = 2250;

/// Bytes that a pose takes in a result as CSV, about.
pub const POSE_BYTES_CSV: u64 = 450;

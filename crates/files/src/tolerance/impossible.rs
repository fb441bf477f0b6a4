//! Draws that give no gear, where there are more of them than allowed.

use gearlash::population::Tally;

/// More draws than allowed give no gear or no pair.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "tolerance: {count} of the first {done} draws are of no gear, more than the share of {share} of all {total} that tolerance.max_impossible allows; assembly {first}: {why}; narrow what scatters"
)]
pub struct TooManyImpossible {
    count: u64,
    done: u64,
    total: u64,
    share: f64,
    first: u64,
    why: String,
}

impl TooManyImpossible {
    /// The error where impossible draws exceed a `share` of `total`. `why` is the reason for an assembly.
    pub(super) fn find(
        tally: &Tally,
        total: u64,
        share: f64,
        why: impl FnOnce(u64) -> Option<String>,
    ) -> Option<TooManyImpossible> {
        let count = tally.counts.impossible;
        let first = tally
            .first_impossible
            .filter(|_| count as f64 > share * total as f64)?;
        Some(TooManyImpossible {
            count,
            done: tally.counts.total(),
            total,
            share,
            first,
            why: why(first).unwrap_or_default(),
        })
    }
}

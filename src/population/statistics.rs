//! Statistics of a population from its sums: shares, spread, capability.

use super::assembly::OutcomeKind;
use super::requirement::AssemblyLimits;
use super::spread::{BIN_TENTHS_NM, Spread, TENTHS_NM_PER_MM};
use super::tally::Tally;
use crate::numeric::bisect;
use statrs::function::beta::beta_reg;

/// Confidence of the intervals of shares.
pub const CONFIDENCE: f64 = 0.95;

/// Shares of the population below the quantiles that are reported: of a normal one its mean ± 3 σ, ± 2 σ, and the mean.
pub const QUANTILES: [f64; 5] = [0.00135, 0.02275, 0.5, 0.97725, 0.99865];

/// A share of a population, estimated from a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// Number in the sample.
    pub count: u64,
    /// Share of the sample.
    pub share: f64,
    /// Lower end of the confidence interval, with [`CONFIDENCE`].
    pub low: f64,
    /// Upper end of the confidence interval.
    pub high: f64,
}

impl Share {
    /// `count` of `total`, with the interval of Clopper and Pearson. At its lower end, `count` or more are drawn with
    /// the probability `(1 − confidence)/2`; at its upper end, `count` or fewer. Sums of the binomial distribution are
    /// quantiles of the beta distribution: Beta(k, n − k + 1) below, Beta(k + 1, n − k) above.
    pub fn of(count: u64, total: u64) -> Share {
        let (k, n) = (count as f64, total as f64);
        let tail = 0.5 * (1.0 - CONFIDENCE);
        Share {
            count,
            share: if total == 0 { 0.0 } else { k / n },
            low: if count == 0 {
                0.0
            } else {
                beta_quantile([k, n - k + 1.0], tail, [0.0, k / n])
            },
            high: if count == total {
                1.0
            } else {
                beta_quantile([k + 1.0, n - k], 1.0 - tail, [k / n, 1.0])
            },
        }
    }
}

/// The quantile `p` of the beta distribution between `ends`, by halving: the crate's own inverse does not end for a million and more.
fn beta_quantile([a, b]: [f64; 2], p: f64, ends: [f64; 2]) -> f64 {
    let [low, high] = bisect(ends[0], ends[1], 0.0, |x| beta_reg(a, b, x) < p);
    0.5 * (low + high)
}

/// One extreme over the population; lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct SpreadStatistics {
    /// Number of assemblies with this extreme; mean and standard deviation are theirs alone. Jammed assemblies have no
    /// least, those out of mesh no greatest, and for both the other extreme may be missing.
    pub count: u64,
    /// Mean of these; `None` without any.
    pub mean: Option<f64>,
    /// Standard deviation of these in the population, estimated with `n − 1`; `None` for less than two.
    pub sigma: Option<f64>,
    /// The [`QUANTILES`], to the width of a bin of the histogram; `None` if assemblies without the extreme reach that far.
    pub quantiles: [Option<f64>; 5],
    /// The lowest value, and its assembly.
    pub least: Option<(f64, u64)>,
    /// The highest value, and its assembly.
    pub greatest: Option<(f64, u64)>,
}

/// The reported statistics of a population.
#[derive(Debug, Clone, PartialEq)]
pub struct Statistics {
    /// Number of assemblies.
    pub total: u64,
    /// Assemblies below a lower limit.
    pub below: Share,
    /// Assemblies above an upper limit.
    pub above: Share,
    /// Assemblies that do not meet the requirement.
    pub outside: Share,
    /// Least `j_wt`. Jammed assemblies count as lower than any value.
    pub least: SpreadStatistics,
    /// Greatest `j_wt`. Assemblies out of mesh count as higher than any value.
    pub greatest: SpreadStatistics,
    /// `(max − min − d)/(6 σ)`, the greater σ of both, where the mean of the greatest is `d` above that of the least: [`Statistics::cpk`] of
    /// centred assemblies with that σ. `None` without both limits. It implies shares only for normal populations of assemblies that have both
    /// extremes.
    pub cp: Option<f64>,
    /// The lesser of `(mean of the least − min)/(3 σ)` and `(max − mean of the greatest)/(3 σ)`, of the existing limits.
    pub cpk: Option<f64>,
}

impl Statistics {
    /// The statistics of `tally`, whose rows were compared with `requirement`.
    pub fn of(tally: &Tally, requirement: &AssemblyLimits) -> Statistics {
        let total = tally.counts.total();
        let [jammed, no_contact] =
            [OutcomeKind::Jammed, OutcomeKind::NoContact].map(|kind| tally.counts.of(kind));
        let least = SpreadStatistics::of(&tally.least, jammed, 0);
        let greatest = SpreadStatistics::of(&tally.greatest, 0, no_contact);
        let positive = |sigma: Option<f64>| sigma.filter(|sigma| *sigma > 0.0);
        let sigmas = [positive(least.sigma), positive(greatest.sigma)];
        let [low, high] = [requirement.min(), requirement.max()];
        let one = |distance: Option<f64>, sigma: Option<f64>| Some(distance? / (3.0 * sigma?));
        let below = one(least.mean.zip(low).map(|(mean, min)| mean - min), sigmas[0]);
        let above = one(
            greatest.mean.zip(high).map(|(mean, max)| max - mean),
            sigmas[1],
        );
        let widest = sigmas.into_iter().flatten().reduce(f64::max);
        let room = low.zip(high).map(|(min, max)| max - min);
        let means = least.mean.zip(greatest.mean);
        let room = room.zip(means.map(|(least, greatest)| greatest - least));
        Statistics {
            total,
            below: Share::of(tally.below, total),
            above: Share::of(tally.above, total),
            outside: Share::of(tally.outside, total),
            cp: room
                .zip(widest)
                .map(|((limits, means), sigma)| (limits - means) / (6.0 * sigma)),
            cpk: below.into_iter().chain(above).reduce(f64::min),
            least,
            greatest,
        }
    }
}

impl SpreadStatistics {
    /// The statistics of `spread`, where `lower` assemblies count as less than any length and `higher` as more.
    fn of(spread: &Spread, lower: u64, higher: u64) -> SpreadStatistics {
        let mm = |length: f64| length / TENTHS_NM_PER_MM;
        let n = spread.count as f64;
        let (sum, squares) = (spread.sum, spread.squares);
        let mean = (spread.count > 0).then(|| mm(sum as f64 / n));
        // n Σx² − (Σx)², exact where it fits.
        let deviations = i128::from(spread.count)
            .checked_mul(squares)
            .zip(sum.checked_mul(sum))
            .map_or_else(
                || n * squares as f64 - (sum as f64).powi(2),
                |(squares, square)| (squares - square) as f64,
            );
        let sigma = (spread.count > 1).then(|| mm((deviations / (n * (n - 1.0))).max(0.0).sqrt()));
        let all = spread.count + lower + higher;
        let end = |end: Option<(i64, u64)>| end.map(|(length, number)| (mm(length as f64), number));
        SpreadStatistics {
            count: spread.count,
            mean,
            sigma,
            quantiles: QUANTILES.map(|p| quantile(spread, p, lower, all)),
            least: end(spread.least),
            greatest: end(spread.greatest),
        }
    }
}

/// The middle of the bin in which the share `p` of `all` is reached, `lower` of them before the first; mm.
fn quantile(spread: &Spread, p: f64, lower: u64, all: u64) -> Option<f64> {
    let wanted = ((p * all as f64).ceil() as u64).max(1);
    if wanted <= lower {
        return None;
    }
    let mut below = lower;
    for (&bin, count) in &spread.histogram {
        below += count;
        if below >= wanted {
            let middle = (bin as f64 + 0.5) * BIN_TENTHS_NM as f64;
            return Some(middle / TENTHS_NM_PER_MM);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: both ends by the binomial distribution itself, summed. At the lower end `count` or more are drawn with
    /// 2.5 %, at the upper end `count` or fewer. None and all: 1 − 0.025^(1/n) (Clopper and Pearson 1934).
    ///
    /// For large samples the interval is k ± 1.96 √(k (1 − k/n)) + O(1) (normal approximation; Wilson's shift is below 4).
    #[test]
    fn intervals_are_those_of_the_binomial_distribution() {
        let up_to = |k: u64, n: u64, p: f64| -> f64 {
            let mut term = (n as f64 * (-p).ln_1p()).exp();
            let mut sum = term;
            for i in 1..=k {
                term *= (n - i + 1) as f64 / i as f64 * p / (1.0 - p);
                sum += term;
            }
            sum
        };
        for (k, n) in [(1, 10), (31, 100_000), (7, 20), (310, 10_000), (19, 20)] {
            let share = Share::of(k, n);
            for drawn in [1.0 - up_to(k - 1, n, share.low), up_to(k, n, share.high)] {
                assert!((drawn - 0.025).abs() < 1e-8, "{k} of {n}: {drawn}");
            }
        }
        let (none, all) = (Share::of(0, 100), Share::of(100, 100));
        assert!(none.low == 0.0 && (none.high - (1.0 - 0.025f64.powf(0.01))).abs() < 1e-10);
        assert!(all.high == 1.0 && (all.low - 0.025f64.powf(0.01)).abs() < 1e-10);
        for (n, k) in [1_000_000u64, 1_000_000_000]
            .into_iter()
            .flat_map(|n| [1, 10, 1000, n / 1000, n / 2, n - 1000, n - 1].map(|k| (n, k)))
        {
            let share = Share::of(k, n);
            assert!(share.low < share.share && share.share < share.high);
            let (all, count) = (n as f64, k as f64);
            let reach = 1.959964 * (count * (1.0 - count / all)).sqrt();
            for end in [share.low, share.high] {
                let apart = ((end - share.share) * all).abs();
                assert!((apart - reach).abs() < 5.0, "{k} of {n}: {apart} {reach}");
            }
        }
    }

    /// 1, 2, … 1000 µm: mean 500.5, n − 1 variance n (n + 1)/12, the median the 500th.
    #[test]
    fn moments_and_quantiles_of_whole_numbers() {
        let mut spread = Spread::default();
        for k in 1..=1000 {
            spread.add(10_000 * k as i64, k).unwrap();
        }
        let found = SpreadStatistics::of(&spread, 0, 0);
        assert!((found.mean.unwrap() - 0.5005).abs() < 1e-15);
        assert!((found.sigma.unwrap() - (1000.0f64 * 1001.0 / 12.0).sqrt() / 1000.0).abs() < 1e-15);
        assert!((found.quantiles[2].unwrap() - 0.5).abs() <= 1e-5);
        assert_eq!(
            (found.least, found.greatest),
            (Some((0.001, 1)), Some((1.0, 1000)))
        );
        // The median is the first value when half of all jam.
        let jammed = SpreadStatistics::of(&spread, 1000, 0);
        assert_eq!(jammed.quantiles[2], None);
        assert!((jammed.quantiles[3].unwrap() - 0.955).abs() <= 1e-5);
    }
}

//! The result of a run.

use super::limit::Limit;
use super::worst::Worst;
use gearlash::population::{Contributions, Share, Statistics, Tally};

/// Description of the population of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct About {
    /// Title of the pair file.
    pub title: String,
    /// Least `j_wt` required, mm.
    pub min_mm: Option<f64>,
    /// Greatest `j_wt` allowed, mm.
    pub max_mm: Option<f64>,
    /// Limits of other quantities.
    pub others: Vec<Limit>,
    /// Share of a million that may miss the requirement.
    pub max_ppm: Option<f64>,
    /// Names of the quantities that scatter.
    pub quantities: Vec<&'static str>,
    /// Names of the unbounded quantities. The worst case cuts them at their limits.
    pub without_end: Vec<&'static str>,
    /// `j_wt`, mm, at the mean, in the worst case and by the root sum of squares, least and greatest each; `None` for whole
    /// gears.
    pub limit_cases: Option<[[Option<f64>; 2]; 3]>,
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct ToleranceResult {
    /// The population.
    pub about: About,
    /// Version of gearlash.
    pub version: &'static str,
    /// SHA-256 of the pair as understood, and of all drawn gears.
    pub input_sha256: String,
    /// Seed.
    pub seed: u64,
    /// Number of assemblies.
    pub assemblies: u64,
    /// Sums over their rows.
    pub tally: Tally,
    /// Shares, spread, capability.
    pub statistics: Statistics,
    /// Contributions to the least and to the greatest `j_wt`.
    pub contributions: [Contributions; 2],
    /// The worst assemblies, the worst first.
    pub worst: Vec<Worst>,
}

/// The share of the first assemblies that misses the requirement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    /// Number of assemblies, from the first on.
    pub assemblies: u64,
    /// The share of them.
    pub share: Share,
}

impl ToleranceResult {
    /// Whether no more assemblies than allowed miss the requirement; `None` where no share is stated.
    pub fn is_met(&self) -> Option<bool> {
        let most = self.about.max_ppm?;
        Some(1e6 * self.statistics.outside.share <= most)
    }

    /// The share that misses the requirement after each of equal stretches.
    pub fn convergence(&self) -> Vec<Convergence> {
        let total = u128::from(self.assemblies);
        let stretches = &self.tally.outside_by_stretch;
        let count = stretches.len() as u128;
        let mut outside = 0;
        let mut all: Vec<Convergence> = Vec::new();
        for (index, one) in stretches.iter().enumerate() {
            outside += one;
            // Assembly n is in stretch ⌊(n − 1) 64/total⌋.
            let assemblies = ((index as u128 + 1) * total).div_ceil(count) as u64;
            let share = Share::of(outside, assemblies);
            match all.last_mut() {
                Some(last) if last.assemblies == assemblies => last.share = share,
                _ => all.push(Convergence { assemblies, share }),
            }
        }
        all
    }
}

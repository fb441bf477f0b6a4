//! What a whole run comes to.

use super::part::Part;
use gearlash::population::{Contributions, Share, Statistics};

/// What a whole run says.
#[derive(Debug, Clone, PartialEq)]
pub struct ToleranceResult {
    /// The run: all its parts as one.
    pub part: Part,
    /// Shares, spread, capability.
    pub statistics: Statistics,
    /// Contributions to the least and to the greatest `j_wt`.
    pub contributions: [Contributions; 2],
}

/// The share that does not meet the requirement, as it comes out of the first so many assemblies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    /// Assemblies, from the first on.
    pub assemblies: u64,
    /// The share of them.
    pub share: Share,
}

/// Ends of equal stretches of the assemblies, each with the share up to there.
pub fn convergence(part: &Part) -> Vec<Convergence> {
    let total = u128::from(part.head.assemblies);
    let stretches = &part.tally.outside_by_stretch;
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

impl ToleranceResult {
    /// What `part`, which is a whole run, says.
    pub fn of(part: Part) -> ToleranceResult {
        ToleranceResult {
            statistics: Statistics::of(&part.tally, &part.requirement()),
            contributions: part.sums.contributions(&part.factors()),
            part,
        }
    }

    /// Whether no more miss the requirement than may; `None` where nothing says how many may.
    pub fn is_met(&self) -> Option<bool> {
        let most = self.part.about.max_ppm?;
        Some(1e6 * self.statistics.outside.share <= most)
    }
}

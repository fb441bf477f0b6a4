//! The result of a run.

use super::worst::Worst;
use gearlash::population::AssemblyLimits;
use gearlash::population::{Contributions, Share, Statistics, Tally};
use gearlash_text::numbers::{rounded, shortest, unit_of};
use serde::Serialize;

/// Description of the population of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct PopulationSummary {
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
    pub unbounded: Vec<&'static str>,
    /// `j_wt`, mm, at the mean, in the worst case and by the root sum of squares, least and greatest each; `None` for whole
    /// gears.
    pub limit_cases: Option<[[Option<f64>; 2]; 3]>,
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct ToleranceResult {
    /// The population.
    pub about: PopulationSummary,
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

/// A quantity that is limited, with its limits in its unit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Limit {
    /// Name, such as `j_bn`.
    pub quantity: String,
    /// Its unit.
    pub unit: String,
    /// No less than this.
    pub min: Option<f64>,
    /// No more than this.
    pub max: Option<f64>,
}

/// The limits of `requirement` on other quantities than `j_wt`.
pub fn limits(requirement: &AssemblyLimits) -> Vec<Limit> {
    let each = requirement.others().map(|(quantity, limits)| {
        let (name, unit, per, _) = unit_of(quantity);
        let in_unit = |value: Option<f64>| value.map(|value| rounded(value * per, 9));
        Limit {
            quantity: name.to_owned(),
            unit: unit.to_owned(),
            min: in_unit(limits.min),
            max: in_unit(limits.max),
        }
    });
    each.collect()
}

/// The required ends (`is_max`: the upper ones), such as "40 µm", "40 µm or j_bn 38 µm", "radial clearance 0.3 mm"; `None`
/// without any. `j_wt` is in mm.
pub fn required_ends(j_wt: Option<f64>, others: &[Limit], is_max: bool) -> Option<String> {
    let own = j_wt.map(|mm| format!("{} µm", shortest(rounded(1e3 * mm, 6))));
    let others = others.iter().filter_map(|limit| {
        let value = if is_max { limit.max } else { limit.min }?;
        Some(format!(
            "{} {} {}",
            limit.quantity,
            shortest(value),
            limit.unit
        ))
    });
    let each: Vec<String> = own.into_iter().chain(others).collect();
    (!each.is_empty()).then(|| each.join(" or "))
}

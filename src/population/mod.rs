//! A population of gear pairs: the scatter between assemblies, and the statistics of many assemblies.
//!
//! A [`Population`] is a pair and the [`Scatter`] of its numbers. [`Population::assembly`] draws one assembly, whose
//! proven extremes over the whole mesh cycle are its [`Outcome`]. [`Sample::rows`] draws any range of them, one [`Row`]
//! each. A [`Tally`] sums rows in integers, in any order, and gives the [`Statistics`]. [`limit_cases`] computes the
//! worst case and the root sum of squares. The [`contributions`] of each scatter use separate samples.
//!
//! An assembly is a function of seed and number alone (`stream`). Its extremes are compared with [`AssemblyLimits`], by the
//! quantities of [`crate::analysis::requirement`]. `gearlash-input` (`tolerance`) reads a population and files of rows, and writes results.
//!
//! Nothing here knows a file: a measured gear is an [`AsBuilt`](crate::gear::AsBuilt) like any other.
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! # use gearlash::pair::GearPair;
//! # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! # let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! use gearlash::population::{AssemblyLimits, Population, Sample, Scatter, Scatters, Statistics, Tally};
//! use gearlash::error::go_on;
//!
//! let pair = GearPair::new(wheel, pinion, 40.1)?;
//! let center_distance = Some(Scatter::normal(0.0, 0.01)?);
//! let population = Population::new(pair, Scatters { center_distance, ..Scatters::default() })?;
//! // At least 60 µm.
//! let requirement = AssemblyLimits::new(Some(0.06), None);
//! let sample = Sample { population: &population, requirement, seed: 1 };
//! let mut tally = Tally::default();
//! for row in sample.rows(1..201, &go_on)? {
//!     tally.add(&row, 200)?;
//! }
//! let statistics = Statistics::of(&tally, &requirement);
//! assert!(statistics.below.share > 0.0 && statistics.below.high < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembly;
mod contributions;
mod factor;
mod limit_cases;
mod members;
mod requirement;
mod sample;
mod scatter;
mod scatters;
mod spread;
mod statistics;
mod stream;
mod tally;

pub use assembly::{Assembly, Outcome, OutcomeKind};
pub use contributions::{
    Contribution, Contributions, ContributionsError, Estimate, JACKKNIFE_GROUPS, ROWS_PER_TICK,
    contributions,
};
pub use factor::Factor;
pub use limit_cases::{LimitCases, PITCH_LIMIT_SIGMAS, limit_cases};
pub use members::Population;
pub use requirement::{AssemblyLimits, Standing};
pub use sample::{ASSEMBLIES_PER_TICK, Sample};
pub use scatter::{LIMIT_SHARE, LIMIT_SIGMAS, Scatter, ScatterError};
pub use scatters::{GearScatter, LeadScatter, PopulationError, Scatters};
pub use spread::{BIN_TENTHS_NM, Overflow, Spread, TENTHS_NM_PER_MM};
pub use statistics::{CONFIDENCE, QUANTILES, Share, SpreadStatistics, Statistics};
pub use stream::{Draw, SampleKind};
pub use tally::{Counts, Row, STRETCHES, Tally, WORST_KEPT};

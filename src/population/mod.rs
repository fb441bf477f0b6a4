//! A population of gear pairs: what scatters from one assembly to the next, and what comes of it.
//!
//! A [`Population`] is a pair and the [`Scatter`] of its numbers; [`Population::assembly`] draws one, whose proven extremes over the whole
//! mesh cycle are its [`Outcome`]. [`sample`] draws many and adds them up in a [`Tally`] of integers: whichever way the
//! numbers of the assemblies are cut and put together again, the sums are the same. [`Statistics`] are read off it. Beside it stand
//! the worst case and the root sum of squares ([`limit_cases`]), and what each scatter contributes ([`contribution_sums`]).
//!
//! An assembly is a function of seed and number alone (`stream`). Its extremes are compared with what is required ([`Requirement`], by the
//! quantities of [`crate::analysis::requirement`]). `gearlash-files` (`tolerance`) reads a population, does a part block by block, keeps parts,
//! checks and merges them, and writes the result of the whole.
//!
//! Nothing here knows a file: a measured gear is an [`AsBuilt`](crate::gear::AsBuilt) as any other.
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! # use gearlash::pair::GearPair;
//! # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! # let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! use gearlash::population::{Population, Requirement, Sample, Scatter, Scatters, Statistics, sample};
//! use std::ops::ControlFlow;
//!
//! let pair = GearPair::new(wheel, pinion, 40.1)?;
//! let center_distance = Some(Scatter::normal(0.0, 0.01)?);
//! let population = Population::new(pair, Scatters { center_distance, ..Scatters::default() })?;
//! // At least 60 µm.
//! let requirement = Requirement::new(Some(0.06), None);
//! let all = Sample { population: &population, requirement, seed: 1, total: 200 };
//! let tally = sample(&all, 1..201, &|| ControlFlow::Continue(()))?;
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
    Contribution, ContributionSums, Contributions, Estimate, GROUPS, GroupSums, contribution_sums,
};
pub use factor::Factor;
pub use limit_cases::{LimitCases, PITCH_LIMIT_SIGMAS, limit_cases};
pub use members::Population;
pub use requirement::{Requirement, Standing};
pub use sample::{CHUNK, Sample, SampleError, outcomes, sample};
pub use scatter::{LIMIT_SHARE, LIMIT_SIGMAS, Scatter, ScatterError};
pub use scatters::{GearScatter, PopulationError, Scatters};
pub use spread::{BIN_TENTHS_NM, Overflow, Spread, TENTHS_NM_PER_MM};
pub use statistics::{CONFIDENCE, QUANTILES, Share, SpreadStatistics, Statistics};
pub use stream::{Draw, Run};
pub use tally::{Counts, STRETCHES, Tally, WORST};

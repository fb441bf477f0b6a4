//! One part of a population's run, block by block.

use super::limit::limits;
use super::part::{About, Part, cases};
use super::part_head::{PartHead, Progress};
use super::population::ToleranceFile;
use crate::shards::sha256;
use gearlash::error::Error;
use gearlash::population::{
    Factor, Outcome, Sample, SampleError, Scatter, Standing, Tally, contribution_sums, limit_cases,
    outcomes, sample,
};
use serde_json::json;
use std::ops::{ControlFlow, Range};

/// Assemblies of a block, after which a part can be kept.
const BLOCK: u64 = 2048;

/// Rows of a block.
const ROWS: u64 = 256;

/// Takes what came of each assembly of a block, in order.
pub type Rows<'a> = &'a mut dyn FnMut(&[(u64, Outcome, Standing)]) -> std::io::Result<()>;

/// Why a block was not done.
#[derive(Debug, thiserror::Error)]
pub enum BlockError {
    /// As the library says.
    #[error(transparent)]
    Sample(#[from] SampleError),
    /// What came of the assemblies cannot be written.
    #[error(transparent)]
    Rows(#[from] std::io::Error),
}

impl ToleranceFile {
    /// Part `shard` (`k` of `n`) of a run of so many `assemblies`, nothing of it done.
    ///
    /// # Errors
    /// As [`limit_cases`].
    pub fn part(&self, assemblies: u64, seed: u64, shard: [u64; 2]) -> Result<Part, Error> {
        let whole = Progress {
            assemblies,
            rows: u64::from(self.tolerance.contribution_rows),
        };
        let factors = self.population.factors();
        let without_end = factors.iter().filter(|factor| self.has_no_end(**factor));
        let about = About {
            title: self.pair.spec.title.clone(),
            min_mm: self.requirement.min(),
            max_mm: self.requirement.max(),
            others: limits(&self.requirement),
            max_ppm: self.tolerance.max_ppm,
            max_impossible: self.tolerance.max_impossible,
            quantities: factors
                .iter()
                .map(|factor| factor.name().to_owned())
                .collect(),
            without_end: without_end.map(|factor| factor.name().to_owned()).collect(),
            limit_cases: cases(limit_cases(&self.population)?),
        };
        let head = PartHead::new(self.sha256(), seed, whole, shard);
        Ok(Part::new(head, about))
    }

    /// Whether a quantity has no limits of its own.
    fn has_no_end(&self, factor: Factor) -> bool {
        let scatters = self.population.scatters();
        let open = |scatter: &Option<Scatter>| {
            scatter
                .as_ref()
                .is_some_and(|scatter| !scatter.is_bounded())
        };
        match factor {
            Factor::Thickness(member) => open(&scatters.of(member).thickness),
            Factor::Thicknesses => {
                open(&scatters.wheel.thickness) || open(&scatters.pinion.thickness)
            }
            Factor::Runout(member) => open(&scatters.of(member).runout),
            Factor::Pitch(_) => true,
            Factor::PerTooth(member) => open(&scatters.of(member).per_tooth),
            Factor::CenterDistance => open(&scatters.center_distance),
            Factor::BearingPlay => open(&scatters.bearing_play),
            Factor::Gear(_) | Factor::Phase => false,
        }
    }

    /// The hash of what the run is about: the pair as understood but for how much of it is drawn, and each whole gear.
    fn sha256(&self) -> String {
        let mut spec = self.pair.spec.clone();
        if let Some(tolerance) = &mut spec.tolerance {
            (tolerance.assemblies, tolerance.seed) = (0, 0);
        }
        let gears = self.measured.each_ref();
        let gears = gears.map(|gears| gears.iter().map(|one| &one.spec).collect::<Vec<_>>());
        sha256(&json!({ "pair": spec, "gears": gears }).to_string())
    }

    /// Does the next block of `part`, and says whether there was one. `rows` takes what comes of each assembly; `tick` is called once every
    /// [`CHUNK`](gearlash::population::CHUNK) assemblies, and once every eight rows of the contributions.
    ///
    /// # Errors
    /// [`BlockError`]; `part` is then as it was.
    pub fn go_on(
        &self,
        part: &mut Part,
        rows: Option<Rows<'_>>,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<bool, BlockError> {
        let of = self.sample(part);
        if let Some(numbers) = next(part.head.numbers(), part.done.assemblies, BLOCK) {
            let count = numbers.end - numbers.start;
            let tally = match rows {
                None => sample(&of, numbers, tick)?,
                Some(rows) => {
                    let each = outcomes(&of, numbers, tick)?;
                    rows(&each)?;
                    let mut tally = Tally::default();
                    for (number, outcome, standing) in &each {
                        let counted = tally.count(outcome, standing, *number, of.total);
                        counted.map_err(SampleError::from)?;
                    }
                    tally
                }
            };
            part.tally.add(&tally).map_err(SampleError::from)?;
            part.done.assemblies += count;
            return Ok(true);
        }
        if let Some(rows) = next(part.head.rows(), part.done.rows, ROWS) {
            let count = rows.end - rows.start;
            let sums = contribution_sums(&self.population, of.seed, rows, tick)?;
            part.sums.add(&sums).map_err(SampleError::from)?;
            part.done.rows += count;
            return Ok(true);
        }
        if part.worst.len() < part.tally.worst.len() {
            let each = part.tally.worst.iter().map(|&one| self.worst(&of, one));
            part.worst = each
                .collect::<Result<_, Error>>()
                .map_err(SampleError::from)?;
            return Ok(true);
        }
        Ok(false)
    }

    /// What `part` is a part of.
    pub(super) fn sample(&self, part: &Part) -> Sample<'_> {
        Sample {
            population: &self.population,
            requirement: self.requirement,
            seed: part.head.seed,
            total: part.head.assemblies,
        }
    }
}

/// The next `length` of `range`, of which so many are done.
fn next(range: Range<u64>, done: u64, length: u64) -> Option<Range<u64>> {
    let start = range.start + done;
    (start < range.end).then(|| start..(start + length).min(range.end))
}

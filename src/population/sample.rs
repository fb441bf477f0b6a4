//! Many assemblies of a population, on all cores.

use super::assembly::{Outcome, OutcomeKind};
use super::members::Population;
use super::requirement::{Requirement, Standing};
use super::spread::Overflow;
use super::stream::{Draw, Run};
use super::tally::Tally;
use crate::error::Error;
use crate::parallel;
use std::ops::{ControlFlow, Range};

/// Assemblies that one core takes at a time: of a tick.
pub const CHUNK: u64 = 32;

/// What is drawn from a population.
#[derive(Debug, Clone, Copy)]
pub struct Sample<'a> {
    /// From which.
    pub population: &'a Population,
    /// What each assembly must keep.
    pub requirement: Requirement,
    /// Another seed, other assemblies.
    pub seed: u64,
    /// How many assemblies there are in all, numbered from 1.
    pub total: u64,
}

/// Why a sample has no sums.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SampleError {
    /// A calculation failed, or was interrupted.
    #[error(transparent)]
    Error(#[from] Error),
    /// The sums are too large.
    #[error(transparent)]
    Overflow(#[from] Overflow),
}

impl Sample<'_> {
    /// The draw of assembly `number`.
    pub fn draw(&self, number: u64) -> Draw {
        Draw {
            seed: self.seed,
            run: Run::Population,
            number,
        }
    }

    /// What comes of assembly `number`, and how it stands to what is required.
    ///
    /// # Errors
    /// As [`super::Assembly::outcome`]; numbers that no gear has are an outcome.
    pub fn outcome(&self, number: u64) -> Result<(Outcome, Standing), Error> {
        match self.population.assembly(self.draw(number)) {
            Ok(assembly) => {
                let outcome = assembly.outcome()?;
                let standing = self.requirement.standing(&assembly, &outcome);
                Ok((outcome, standing))
            }
            Err(_) => {
                let outcome = Outcome::without(OutcomeKind::Impossible);
                Ok((outcome, self.requirement.standing_of(&outcome, || None)))
            }
        }
    }
}

/// What comes of the assemblies `numbers` of `sample`, each by itself and in their order. `tick` as in [`sample()`].
///
/// # Errors
/// As [`sample()`].
pub fn outcomes(
    sample: &Sample<'_>,
    numbers: Range<u64>,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<(u64, Outcome, Standing)>, SampleError> {
    let chunks = parallel::map(in_chunks(&numbers, CHUNK), |chunk| {
        Error::if_stopped(tick())?;
        let each = chunk.map(|number| {
            let (outcome, standing) = sample.outcome(number)?;
            Ok((number, outcome, standing))
        });
        each.collect::<Result<Vec<_>, SampleError>>()
    });
    let mut all = Vec::new();
    for chunk in chunks {
        all.extend(chunk?);
    }
    Ok(all)
}

/// The sums over the assemblies `numbers` of `sample`, the same on any number of cores. `tick` is called every few assemblies, from any
/// thread; where it breaks, there are none.
///
/// # Errors
/// [`SampleError`].
pub fn sample(
    sample: &Sample<'_>,
    numbers: Range<u64>,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Tally, SampleError> {
    let chunks = parallel::map(
        in_chunks(&numbers, CHUNK),
        |chunk| -> Result<_, SampleError> {
            Error::if_stopped(tick())?;
            let mut tally = Tally::default();
            for number in chunk {
                let (outcome, standing) = sample.outcome(number)?;
                tally.count(&outcome, &standing, number, sample.total)?;
            }
            Ok(tally)
        },
    );
    let mut sums = Tally::default();
    for tally in chunks {
        sums.add(&tally?)?;
    }
    Ok(sums)
}

/// `numbers` in runs of `length`, the last one shorter.
pub(super) fn in_chunks(numbers: &Range<u64>, length: u64) -> Vec<Range<u64>> {
    let starts = numbers.clone().step_by(length as usize);
    let chunk = |start: u64| start..(start + length).min(numbers.end);
    starts.map(chunk).collect()
}

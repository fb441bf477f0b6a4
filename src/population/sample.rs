//! Many assemblies of a population, on all cores.

use super::assembly::{Outcome, OutcomeKind};
use super::members::Population;
use super::requirement::{AssemblyLimits, Standing};
use super::stream::{Draw, SampleKind};
use super::tally::Row;
use crate::error::{Error, Tick};
use crate::parallel;
use std::ops::Range;

/// Assemblies per core and tick.
pub const ASSEMBLIES_PER_TICK: u64 = 32;

/// A population with the limits and the seed of a sample.
#[derive(Debug, Clone, Copy)]
pub struct Sample<'a> {
    /// The population.
    pub population: &'a Population,
    /// The limits on each assembly.
    pub requirement: AssemblyLimits,
    /// The seed; another one draws other assemblies.
    pub seed: u64,
}

impl Sample<'_> {
    /// The draw of assembly `number`.
    pub fn draw(&self, number: u64) -> Draw {
        Draw {
            seed: self.seed,
            sample: SampleKind::Population,
            number,
        }
    }

    /// The outcome of assembly `number`, and its evaluation against the requirement.
    ///
    /// # Errors
    /// As [`super::Assembly::outcome`]. Values of an impossible gear are an outcome.
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

    /// The rows of the assemblies `numbers`, in order. `tick` is called once every [`ASSEMBLIES_PER_TICK`] assemblies, from any
    /// thread; a break ends the work.
    ///
    /// # Errors
    /// As [`Sample::outcome`]; [`Error::Interrupted`].
    pub fn rows(&self, numbers: Range<u64>, tick: &Tick) -> Result<Vec<Row>, Error> {
        let chunks = parallel::map(chunks(&numbers, ASSEMBLIES_PER_TICK), |chunk| {
            Error::if_stopped(tick(1))?;
            let rows = chunk.map(|number| {
                let (outcome, standing) = self.outcome(number)?;
                Ok(Row::new(number, &outcome, &standing))
            });
            rows.collect::<Result<Vec<Row>, Error>>()
        });
        let chunks: Vec<Vec<Row>> = chunks.into_iter().collect::<Result<_, Error>>()?;
        Ok(chunks.concat())
    }
}

/// `numbers` in ranges of `length`; the last one may be shorter.
pub(super) fn chunks(numbers: &Range<u64>, length: u64) -> Vec<Range<u64>> {
    let starts = numbers.clone().step_by(length as usize);
    let chunk = |start: u64| start..(start + length).min(numbers.end);
    starts.map(chunk).collect()
}

//! A run: a population, a seed and a number of assemblies.

use super::population::ToleranceFile;
use super::result::{PopulationSummary, ToleranceResult, limits};
use super::worst::sha256;
use gearlash::error::Error;
use gearlash::population::{
    ContributionsError, Factor, JACKKNIFE_GROUPS, OutcomeKind, Row, Sample, Scatter, Statistics,
    Tally, contributions, limit_cases,
};
use gearlash_text::characters::shell_word;
use serde_json::json;
use std::ops::Range;
use std::path::Path;

/// Assemblies per step; the rows are written after each step (tuned: some seconds on two cores, and enough for many threads).
pub const BLOCK: u64 = 2048;

/// Called when a step of the work begins; a break ends the work.
pub type Tick<'a> = &'a gearlash::error::Tick<'a>;

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

/// A population of a pair file with the seed and the number of assemblies of a run.
#[derive(Debug)]
pub struct ToleranceRun<'a> {
    file: &'a ToleranceFile,
    path: &'a Path,
    seed: u64,
    assemblies: u64,
    input_sha256: String,
    about: PopulationSummary,
}

impl<'a> ToleranceRun<'a> {
    /// The run of the `file` read from `path`. Seed and number of assemblies default to those of the file.
    ///
    /// # Errors
    /// As [`limit_cases`].
    pub fn new(
        file: &'a ToleranceFile,
        path: &'a Path,
        assemblies: Option<u64>,
        seed: Option<u64>,
    ) -> Result<ToleranceRun<'a>, Error> {
        let factors = file.population.factors();
        let unbounded = factors.iter().filter(|factor| is_unbounded(file, **factor));
        let cases = limit_cases(&file.population)?;
        let about = PopulationSummary {
            title: file.pair.spec.title.clone(),
            min_mm: file.requirement.min(),
            max_mm: file.requirement.max(),
            others: limits(&file.requirement),
            max_ppm: file.tolerance.max_ppm,
            quantities: factors.iter().map(|factor| factor.name()).collect(),
            unbounded: unbounded.map(|factor| factor.name()).collect(),
            limit_cases: cases.map(|found| [found.mean, found.worst, found.root_sum_of_squares]),
        };
        Ok(ToleranceRun {
            path,
            seed: seed.unwrap_or(file.tolerance.seed.into()),
            assemblies: assemblies.unwrap_or(file.tolerance.assemblies.into()),
            input_sha256: input_sha256(file),
            about,
            file,
        })
    }

    /// Number of assemblies, from 1 on.
    pub fn assemblies(&self) -> u64 {
        self.assemblies
    }

    pub(super) fn path(&self) -> &Path {
        self.path
    }

    /// Rows of the samples for contributions: no more than assemblies, except for two in each of the [`JACKKNIFE_GROUPS`].
    pub fn contribution_rows(&self) -> u64 {
        let least = 2 * JACKKNIFE_GROUPS as u64;
        u64::from(self.file.tolerance.contribution_rows).min(self.assemblies.max(least))
    }

    /// SHA-256 of the input, and the seed.
    pub(super) fn identity(&self) -> (&str, u64) {
        (&self.input_sha256, self.seed)
    }

    /// The command that writes the rows of the assemblies `numbers` to `file`.
    pub fn rows_command(&self, numbers: Range<u64>, file: &Path) -> String {
        let (first, count) = (numbers.start, numbers.end - numbers.start);
        let file = shell_word(file);
        format!(
            "{} --first {first} --assemblies {count} --rows {file}",
            self.command()
        )
    }

    /// The command for the statistics of the rows in `files`, words of a shell.
    pub fn statistics_command(&self, files: &str) -> String {
        let own = u64::from(self.file.tolerance.assemblies);
        let mut command = self.command();
        if self.assemblies != own {
            command += &format!(" --assemblies {}", self.assemblies);
        }
        format!("{command} --from-rows {files}")
    }

    fn command(&self) -> String {
        let path = shell_word(self.path);
        let own = u64::from(self.file.tolerance.seed);
        if self.seed == own {
            format!("gearlash tolerance {path}")
        } else {
            format!("gearlash tolerance {path} --seed {}", self.seed)
        }
    }

    /// The rows of the assemblies `numbers`. `tick` is called once every
    /// [`ASSEMBLIES_PER_TICK`](gearlash::population::ASSEMBLIES_PER_TICK) assemblies.
    ///
    /// # Errors
    /// As [`Sample::rows`].
    pub fn rows(&self, numbers: Range<u64>, tick: Tick) -> Result<Vec<Row>, Error> {
        self.sample().rows(numbers, tick)
    }

    /// The error where more assemblies than allowed give no gear, in the rows summed in `tally`.
    pub fn too_many_impossible(&self, tally: &Tally) -> Option<TooManyImpossible> {
        let (count, share) = (
            tally.counts.of(OutcomeKind::Impossible),
            self.file.tolerance.max_impossible,
        );
        let is_allowed = count as f64 <= share * self.assemblies as f64;
        let first = tally.first_impossible.filter(|_| !is_allowed)?;
        let drawn = self.file.population.assembly(self.sample().draw(first));
        Some(TooManyImpossible {
            count,
            done: tally.counts.total(),
            total: self.assemblies,
            share,
            first,
            why: drawn.err().map_or(String::new(), |error| error.to_string()),
        })
    }

    /// The result of the run with the rows summed in `tally`. The contributions come from samples of their own. `tick` is called
    /// once every [`ROWS_PER_TICK`](gearlash::population::ROWS_PER_TICK) rows of these.
    ///
    /// # Errors
    /// [`ContributionsError`].
    pub fn result(self, tally: Tally, tick: Tick) -> Result<ToleranceResult, ContributionsError> {
        let population = &self.file.population;
        let found = contributions(population, self.seed, self.contribution_rows(), tick)?;
        let sample = self.sample();
        let worst = tally.worst.iter().map(|&(_, number)| {
            let worst = self.file.worst(&sample, number)?;
            Ok(worst)
        });
        Ok(ToleranceResult {
            worst: worst.collect::<Result<_, Error>>()?,
            statistics: Statistics::of(&tally, &self.file.requirement),
            contributions: found,
            tally,
            about: self.about,
            version: env!("CARGO_PKG_VERSION"),
            input_sha256: self.input_sha256,
            seed: self.seed,
            assemblies: self.assemblies,
        })
    }

    fn sample(&self) -> Sample<'a> {
        Sample {
            population: &self.file.population,
            requirement: self.file.requirement,
            seed: self.seed,
        }
    }
}

/// Whether the scatter of `factor` has no limits of its own.
fn is_unbounded(file: &ToleranceFile, factor: Factor) -> bool {
    let scatters = file.population.scatters();
    let unbounded = |scatter: &Option<Scatter>| {
        scatter
            .as_ref()
            .is_some_and(|scatter| !scatter.is_bounded())
    };
    match factor {
        Factor::Thickness(member) => unbounded(&scatters.of(member).thickness),
        Factor::Thicknesses => {
            unbounded(&scatters.wheel.thickness) || unbounded(&scatters.pinion.thickness)
        }
        Factor::Runout(member) => unbounded(&scatters.of(member).runout),
        Factor::Pitch(_) => true,
        Factor::PerTooth(member) => unbounded(&scatters.of(member).per_tooth),
        Factor::Lead(_) | Factor::Wobble(_) | Factor::Misalignment => true,
        Factor::CenterDistance => unbounded(&scatters.center_distance),
        Factor::BearingClearance => unbounded(&scatters.bearing_clearance),
        Factor::Gear(_) | Factor::Phase => false,
    }
}

/// The hash of the pair as understood, without seed and number of assemblies, and of each whole gear.
fn input_sha256(file: &ToleranceFile) -> String {
    let mut spec = file.pair.spec.clone();
    if let Some(tolerance) = &mut spec.tolerance {
        (tolerance.assemblies, tolerance.seed) = (0, 0);
    }
    let gears = file.measured.each_ref();
    let gears = gears.map(|gears| gears.iter().map(|one| &one.spec).collect::<Vec<_>>());
    sha256(&json!({ "pair": spec, "gears": gears }).to_string())
}

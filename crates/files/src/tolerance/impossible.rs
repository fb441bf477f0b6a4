//! Draws of no gear, where there are more of them than may be.

use super::part::Part;
use super::population::ToleranceFile;

/// More draws are of no gear, or of no pair, than the share that may be.
#[derive(Debug, Clone, PartialEq)]
pub struct TooManyImpossible {
    /// How many.
    count: u64,
    /// Of the first so many.
    done: u64,
    /// Of so many in all.
    total: u64,
    /// The share that may be.
    share: f64,
    /// The first of them, and why it is none where that is known.
    first: Option<(u64, Option<String>)>,
}

impl std::error::Error for TooManyImpossible {}

impl std::fmt::Display for TooManyImpossible {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (count, done, total, share) = (self.count, self.done, self.total, self.share);
        write!(
            f,
            "tolerance: {count} of the first {done} draws are of no gear, more than the share of {share} of all {total} that tolerance.max_impossible allows"
        )?;
        match &self.first {
            Some((number, Some(why))) => write!(f, "; assembly {number}: {why}")?,
            Some((number, None)) => write!(f, "; the first is assembly {number}")?,
            None => (),
        }
        write!(f, "; narrow what scatters")
    }
}

impl Part {
    /// More draws of no gear than may be, where there are; with the number of the first.
    pub fn too_many_impossible(&self) -> Option<TooManyImpossible> {
        let (count, share) = (self.tally.counts.impossible, self.about.max_impossible);
        let most = share * self.head.assemblies as f64;
        (count as f64 > most).then(|| TooManyImpossible {
            count,
            done: self.done.assemblies,
            total: self.head.assemblies,
            share,
            first: self.tally.first_impossible.map(|number| (number, None)),
        })
    }
}

impl ToleranceFile {
    /// More draws of no gear in `part` than may be, where there are; with the reason of the first.
    pub fn too_many_impossible(&self, part: &Part) -> Option<TooManyImpossible> {
        let found = part.too_many_impossible()?;
        let first = found.first.map(|(number, _)| {
            let drawn = self.population.assembly(self.sample(part).draw(number));
            (number, drawn.err().map(|error| error.to_string()))
        });
        Some(TooManyImpossible { first, ..found })
    }
}

//! A part of a population's run: what one machine found, in a file that others are added to.

use super::records::{ContributionsRecord, TallyRecord};
use super::worst::Worst;
use gearlash::population::{
    ContributionSums, Factor, LimitCases, Overflow, Requirement, Tally, WORST,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What a part's file begins with.
const FORMAT: &str = "gearlash tolerance part 1";

/// Which part of which run it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PartHead {
    pub(super) format: String,
    /// Version of gearlash.
    pub gearlash: String,
    /// SHA-256 of the pair as understood, and of all gears that are drawn.
    pub input_sha256: String,
    /// Seed.
    pub seed: u64,
    /// Assemblies of the whole run.
    pub assemblies: u64,
    /// Rows of the samples for contributions, of the whole run.
    pub contribution_rows: u64,
    /// `k` of `n` parts.
    pub shard: [u64; 2],
}

/// What all parts of a run have in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct About {
    /// Title of the pair file.
    pub title: String,
    /// Least `j_wt` required, mm.
    pub min_mm: Option<f64>,
    /// Greatest `j_wt` allowed, mm.
    pub max_mm: Option<f64>,
    /// How many of a million may miss it.
    pub max_ppm: Option<f64>,
    /// The share of draws that may be of no gear.
    pub max_impossible: f64,
    /// What scatters, in words.
    pub quantities: Vec<String>,
    /// Of them those without an end: the worst case cuts them at their limits.
    pub without_end: Vec<String>,
    /// `j_wt`, mm, at the mean, in the worst case and by the root sum of squares, least and greatest each; `None` of whole gears.
    pub limit_cases: Option<[[Option<f64>; 2]; 3]>,
}

/// How much of a part is done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Progress {
    /// Assemblies from the part's first on.
    pub assemblies: u64,
    /// Rows from the part's first on.
    pub rows: u64,
}

/// A part of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Which.
    pub head: PartHead,
    /// Of what.
    pub about: About,
    /// How far it is.
    pub done: Progress,
    /// Its sums.
    pub tally: Tally,
    /// And those for the contributions.
    pub sums: ContributionSums,
    /// Its worst assemblies, once it is done.
    pub worst: Vec<Worst>,
}

#[derive(Serialize, Deserialize)]
struct Record {
    #[serde(flatten)]
    head: PartHead,
    about: About,
    done: Progress,
    tally: TallyRecord,
    contributions: ContributionsRecord,
    worst: Vec<Worst>,
}

/// Parts that make no whole.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PartError {
    /// A file that is no part.
    #[error(
        "{file}: this is no part of a run of gearlash tolerance: {reason}; name files that gearlash tolerance --shard wrote"
    )]
    Invalid {
        /// The file.
        file: String,
        /// Why.
        reason: String,
    },
    /// A part of another run.
    #[error(
        "{file}: is of another run than {first}: {what} {found}, not {wanted}; name the parts of one run"
    )]
    Foreign {
        /// The file.
        file: String,
        /// The one it is compared with.
        first: String,
        /// What differs.
        what: &'static str,
        /// What it has.
        found: String,
        /// What the first has.
        wanted: String,
    },
    /// A part that was not finished.
    #[error(
        "{file}: part {shard} was interrupted; run its command again, which goes on from there"
    )]
    Unfinished {
        /// The file.
        file: String,
        /// Its number.
        shard: u64,
    },
    /// A part given twice.
    #[error("{file}: is part {shard}, as {first} is; name each part once")]
    Double {
        /// The file.
        file: String,
        /// The one before.
        first: String,
        /// Its number.
        shard: u64,
    },
    /// Parts that are not there.
    #[error("{} of {of} missing: {}; run gearlash tolerance --shard K/{of} for each", parts(.shards), listed(.shards))]
    Missing {
        /// Their numbers.
        shards: Vec<u64>,
        /// How many there are in all.
        of: u64,
    },
    /// No part at all.
    #[error("no part of a run; name the files that gearlash tolerance --shard wrote")]
    None,
    /// Sums beyond all bounds.
    #[error(transparent)]
    Overflow(#[from] Overflow),
}

fn parts(shards: &[u64]) -> String {
    match shards.len() {
        1 => "1 part".to_owned(),
        count => format!("{count} parts"),
    }
}

/// The first dozen of them.
fn listed(shards: &[u64]) -> String {
    let first = shards.iter().take(12).map(u64::to_string);
    let mut text = first.collect::<Vec<_>>().join(", ");
    if shards.len() > 12 {
        text += " …";
    }
    text
}

impl PartHead {
    /// Part `k` of `n` of a run.
    pub(super) fn new(
        input_sha256: String,
        seed: u64,
        whole: Progress,
        shard: [u64; 2],
    ) -> PartHead {
        PartHead {
            format: FORMAT.to_owned(),
            gearlash: env!("CARGO_PKG_VERSION").to_owned(),
            input_sha256,
            seed,
            assemblies: whole.assemblies,
            contribution_rows: whole.rows,
            shard,
        }
    }

    /// The numbers, from 1, of what it has of `total`: equal parts, but for one.
    fn range(&self, total: u64) -> std::ops::Range<u64> {
        let [k, n] = self.shard.map(u128::from);
        let end = |k: u128| (u128::from(total) * k / n.max(1)) as u64 + 1;
        end(k.saturating_sub(1))..end(k)
    }

    /// Its assemblies.
    pub fn numbers(&self) -> std::ops::Range<u64> {
        self.range(self.assemblies)
    }

    /// Its rows of the samples for contributions.
    pub fn rows(&self) -> std::ops::Range<u64> {
        self.range(self.contribution_rows)
    }
}

impl Part {
    /// Nothing done yet.
    pub(super) fn new(head: PartHead, about: About) -> Part {
        Part {
            sums: ContributionSums::new(about.quantities.len()),
            head,
            about,
            done: Progress::default(),
            tally: Tally::default(),
            worst: Vec::new(),
        }
    }

    /// Whether all of it is done.
    pub fn is_done(&self) -> bool {
        let length = |range: std::ops::Range<u64>| range.end - range.start;
        let whole = Progress {
            assemblies: length(self.head.numbers()),
            rows: length(self.head.rows()),
        };
        self.done == whole && self.worst.len() == self.tally.worst.len()
    }

    /// What each assembly must keep.
    pub fn requirement(&self) -> Requirement {
        Requirement::new(self.about.min_mm, self.about.max_mm)
    }

    /// What scatters.
    pub fn factors(&self) -> Vec<Factor> {
        let all = Factor::ALL.into_iter();
        let by_name: BTreeMap<&str, Factor> = all.map(|one| (one.name(), one)).collect();
        let names = self.about.quantities.iter();
        names
            .filter_map(|name| by_name.get(name.as_str()).copied())
            .collect()
    }

    /// Whether more draws are of no gear than may be.
    pub fn is_impossible(&self) -> bool {
        let most = self.about.max_impossible * self.head.assemblies as f64;
        self.tally.counts.impossible as f64 > most
    }

    /// Its file, which ends in a line end.
    pub fn to_json(&self) -> String {
        let record = Record {
            head: self.head.clone(),
            about: self.about.clone(),
            done: self.done,
            tally: TallyRecord::of(&self.tally),
            contributions: ContributionsRecord::of(&self.sums),
            worst: self.worst.clone(),
        };
        // Plain structs with text keys: nothing of it can fail.
        serde_json::to_string(&record).unwrap_or_default() + "\n"
    }

    /// The part in the `text` of `file`.
    ///
    /// # Errors
    /// [`PartError::Invalid`].
    pub fn from_json(file: &str, text: &str) -> Result<Part, PartError> {
        let invalid = |reason: String| PartError::Invalid {
            file: file.to_owned(),
            reason,
        };
        let record: Record =
            serde_json::from_str(text).map_err(|error| invalid(error.to_string()))?;
        let part = Part {
            tally: record.tally.tally().map_err(&invalid)?,
            sums: record
                .contributions
                .sums(record.about.quantities.len())
                .map_err(&invalid)?,
            head: record.head,
            about: record.about,
            done: record.done,
            worst: record.worst,
        };
        let head = &part.head;
        let [k, n] = head.shard;
        let wrong = if head.format != FORMAT {
            "it is of another format"
        } else if !(1 <= k && k <= n && n <= head.assemblies.max(1)) {
            "its number is none of its run's parts"
        } else if part.tally.counts.total() != part.done.assemblies {
            "its sums are not over the assemblies that it says are done"
        } else if part.factors().len() != part.about.quantities.len() {
            "it names quantities that do not scatter"
        } else {
            return Ok(part);
        };
        Err(invalid(wrong.to_owned()))
    }

    /// All parts of a run, each with the name of its file, as one.
    ///
    /// # Errors
    /// [`PartError`].
    pub fn merged(parts: Vec<(String, Part)>) -> Result<Part, PartError> {
        let mut given = parts.into_iter();
        let (first, mut whole) = given.next().ok_or(PartError::None)?;
        unfinished(&first, &whole)?;
        let mut seen = BTreeMap::from([(whole.head.shard[0], first.clone())]);
        for (file, part) in given {
            same(&file, &part, &first, &whole)?;
            unfinished(&file, &part)?;
            let shard = part.head.shard[0];
            if let Some(before) = seen.insert(shard, file.clone()) {
                return Err(PartError::Double {
                    file,
                    first: before,
                    shard,
                });
            }
            whole.tally.add(&part.tally)?;
            whole.sums.add(&part.sums)?;
            whole.worst.extend(part.worst);
            whole.done.assemblies += part.done.assemblies;
            whole.done.rows += part.done.rows;
        }
        let of = whole.head.shard[1];
        let missing = (1..=of).filter(|shard| !seen.contains_key(shard));
        let shards: Vec<u64> = missing.collect();
        if !shards.is_empty() {
            return Err(PartError::Missing { shards, of });
        }
        whole.head.shard = [1, 1];
        whole
            .worst
            .sort_by_key(|worst| (worst.margin, worst.number));
        whole.worst.truncate(WORST);
        Ok(whole)
    }
}

fn unfinished(file: &str, part: &Part) -> Result<(), PartError> {
    match part.is_done() {
        true => Ok(()),
        false => Err(PartError::Unfinished {
            file: file.to_owned(),
            shard: part.head.shard[0],
        }),
    }
}

/// Whether `part` is of the run of `whole`, the first of whose parts is `first`.
fn same(file: &str, part: &Part, first: &str, whole: &Part) -> Result<(), PartError> {
    let (found, wanted) = (&part.head, &whole.head);
    let number = |head: &PartHead, of: fn(&PartHead) -> u64| of(head).to_string();
    let each: [(&'static str, String, String); 6] = [
        (
            "version of gearlash",
            found.gearlash.clone(),
            wanted.gearlash.clone(),
        ),
        (
            "input",
            found.input_sha256.clone(),
            wanted.input_sha256.clone(),
        ),
        (
            "seed",
            number(found, |head| head.seed),
            number(wanted, |head| head.seed),
        ),
        (
            "assemblies",
            number(found, |head| head.assemblies),
            number(wanted, |head| head.assemblies),
        ),
        (
            "rows for contributions",
            number(found, |head| head.contribution_rows),
            number(wanted, |head| head.contribution_rows),
        ),
        (
            "number of parts",
            number(found, |head| head.shard[1]),
            number(wanted, |head| head.shard[1]),
        ),
    ];
    let differs = each.into_iter().find(|(_, found, wanted)| found != wanted);
    let differs = differs.or_else(|| {
        let other = part.about != whole.about;
        other.then(|| ("statements", "others".to_owned(), "the same".to_owned()))
    });
    match differs {
        None => Ok(()),
        Some((what, found, wanted)) => Err(PartError::Foreign {
            file: file.to_owned(),
            first: first.to_owned(),
            what,
            found,
            wanted,
        }),
    }
}

/// The cases as a part keeps them.
pub(super) fn cases(found: Option<LimitCases>) -> Option<[[Option<f64>; 2]; 3]> {
    found.map(|found| [found.mean, found.worst, found.root_sum_of_squares])
}

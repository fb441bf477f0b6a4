//! A part of a population's run: what one machine found, in a file that others are added to.

use super::consistent::{fault, is_length};
use super::limit::Limit;
use super::part_head::{PartHead, Progress};
use super::records::{ContributionsRecord, TallyRecord};
use super::worst::Worst;
use crate::part_error::PartError;
use gearlash::population::{ContributionSums, Factor, LimitCases, Requirement, Tally};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What all parts of a run have in common: equal where each number is to its last bit, as one program works it out from one input on machines
/// that reckon alike. One that differs by a bit may draw others, and its sums are none of this run.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct About {
    /// Title of the pair file.
    pub title: String,
    /// Least `j_wt` required, mm.
    pub min_mm: Option<f64>,
    /// Greatest `j_wt` allowed, mm.
    pub max_mm: Option<f64>,
    /// What else is required.
    pub others: Vec<Limit>,
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

    /// What `j_wt` of each assembly must keep.
    pub fn requirement(&self) -> Requirement {
        Requirement::new(self.about.min_mm, self.about.max_mm)
    }

    /// What scatters.
    pub fn factors(&self) -> Vec<Factor> {
        self.about.factors()
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
        let wrong = fault(&part.head, part.done, &part.tally, &part.sums, &part.worst);
        let wrong = wrong.or_else(|| part.about.fault());
        match wrong {
            None => Ok(part),
            Some(wrong) => Err(invalid(wrong.to_owned())),
        }
    }
}

impl PartialEq for About {
    fn eq(&self, other: &About) -> bool {
        self.differs(other).is_none()
    }
}

impl Eq for About {}

impl About {
    /// What differs from `other`, if anything: numbers by their bits.
    pub(super) fn differs(&self, other: &About) -> Option<&'static str> {
        let bits = |number: Option<f64>| number.map(f64::to_bits);
        let share = |about: &About| about.max_impossible.to_bits();
        let require = |about: &About| [about.min_mm, about.max_mm, about.max_ppm].map(bits);
        let others = |about: &About| -> Vec<_> {
            let each = about.others.iter();
            let each = each.map(|one| {
                let names = (one.quantity.clone(), one.unit.clone());
                (names, [one.min, one.max].map(bits))
            });
            each.collect()
        };
        let quantities = |about: &About| (about.quantities.clone(), about.without_end.clone());
        let cases = |about: &About| {
            about
                .limit_cases
                .map(|cases| cases.map(|case| case.map(bits)))
        };
        let each = [
            ("title", self.title == other.title),
            (
                "requirement",
                require(self) == require(other) && others(self) == others(other),
            ),
            ("max_impossible", share(self) == share(other)),
            ("quantities", quantities(self) == quantities(other)),
            (
                "worst case and root sum of squares",
                cases(self) == cases(other),
            ),
        ];
        let differs = each.into_iter().find(|(_, is_same)| !is_same);
        differs.map(|(what, _)| what)
    }

    /// What no run has.
    fn fault(&self) -> Option<&'static str> {
        let limits = [self.min_mm, self.max_mm].into_iter().flatten();
        let cases = self.limit_cases.into_iter().flatten().flatten().flatten();
        let mut lengths = limits.chain(cases);
        let is_share = |share: f64| (0.0..=1.0).contains(&share);
        if self.factors().len() != self.quantities.len() {
            Some("it names quantities that do not scatter")
        } else if !lengths.all(is_length)
            || !self.others.iter().all(Limit::is_one)
            || !is_share(self.max_impossible)
            || !self.max_ppm.is_none_or(|ppm| is_share(1e-6 * ppm))
        {
            Some("it states a requirement that no pair file has")
        } else {
            None
        }
    }

    /// What scatters.
    fn factors(&self) -> Vec<Factor> {
        let all = Factor::ALL.into_iter();
        let by_name: BTreeMap<&str, Factor> = all.map(|one| (one.name(), one)).collect();
        let names = self.quantities.iter();
        names
            .filter_map(|name| by_name.get(name.as_str()).copied())
            .collect()
    }
}

/// The cases as a part keeps them.
pub(super) fn cases(found: Option<LimitCases>) -> Option<[[Option<f64>; 2]; 3]> {
    found.map(|found| [found.mean, found.worst, found.root_sum_of_squares])
}

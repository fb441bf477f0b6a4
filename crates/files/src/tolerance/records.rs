//! The sums of a part as they stand in its file: sums that JSON numbers cannot hold as text.

use super::part_head::MOST_ASSEMBLIES;
use gearlash::population::{ContributionSums, Counts, GROUPS, GroupSums, STRETCHES, Spread, Tally};
use serde::{Deserialize, Serialize};

/// A whole number of up to 128 bits.
type Wide = String;

fn narrow<const N: usize>(texts: &[Wide]) -> Result<[i128; N], String> {
    let numbers: Result<Vec<i128>, _> = texts.iter().map(|text| text.parse()).collect();
    let numbers = numbers.map_err(|_| "a sum is no whole number".to_owned())?;
    numbers
        .try_into()
        .map_err(|_| "it has another number of sums".to_owned())
}

fn wide(numbers: &[i128]) -> Vec<Wide> {
    numbers.iter().map(i128::to_string).collect()
}

#[derive(Serialize, Deserialize)]
struct SpreadRecord {
    count: u64,
    sums: Vec<Wide>,
    least: Option<(i64, u64)>,
    greatest: Option<(i64, u64)>,
    histogram: Vec<(i64, u64)>,
}

#[derive(Serialize, Deserialize)]
pub struct TallyRecord {
    clear: u64,
    interference: u64,
    jammed: u64,
    out_of_mesh: u64,
    unproven: u64,
    impossible: u64,
    first_impossible: Option<u64>,
    doubtful: u64,
    below: u64,
    above: u64,
    outside: u64,
    outside_by_stretch: Vec<u64>,
    worst: Vec<(i64, u64)>,
    least: SpreadRecord,
    greatest: SpreadRecord,
}

#[derive(Serialize, Deserialize)]
struct GroupRecord {
    rows: u64,
    left_out: u64,
    samples: Vec<Wide>,
    factors: Vec<Vec<Wide>>,
}

#[derive(Serialize, Deserialize)]
pub struct ContributionsRecord {
    least: Vec<GroupRecord>,
    greatest: Vec<GroupRecord>,
}

impl SpreadRecord {
    fn of(spread: &Spread) -> SpreadRecord {
        SpreadRecord {
            count: spread.count,
            sums: wide(&spread.sums),
            least: spread.least,
            greatest: spread.greatest,
            histogram: spread
                .histogram
                .iter()
                .map(|(&bin, &count)| (bin, count))
                .collect(),
        }
    }

    fn spread(&self) -> Result<Spread, String> {
        let counts = self.histogram.iter().map(|(_, count)| u128::from(*count));
        let ascending = self
            .histogram
            .is_sorted_by(|(bin, _), (next, _)| bin < next);
        let filled = self.histogram.iter().all(|(_, count)| *count > 0);
        if counts.sum::<u128>() != u128::from(self.count) || !ascending || !filled {
            return Err("a histogram does not hold as many as it says".to_owned());
        }
        Ok(Spread {
            count: self.count,
            sums: narrow(&self.sums)?,
            histogram: self.histogram.iter().copied().collect(),
            least: self.least,
            greatest: self.greatest,
        })
    }
}

impl TallyRecord {
    pub fn of(tally: &Tally) -> TallyRecord {
        let counts = &tally.counts;
        TallyRecord {
            clear: counts.clear,
            interference: counts.interference,
            jammed: counts.jammed,
            out_of_mesh: counts.out_of_mesh,
            unproven: counts.unproven,
            impossible: counts.impossible,
            first_impossible: tally.first_impossible,
            doubtful: tally.doubtful,
            below: tally.below,
            above: tally.above,
            outside: tally.outside,
            outside_by_stretch: tally.outside_by_stretch.clone(),
            worst: tally.worst.iter().copied().collect(),
            least: SpreadRecord::of(&tally.least),
            greatest: SpreadRecord::of(&tally.greatest),
        }
    }

    pub fn tally(&self) -> Result<Tally, String> {
        let counts = [
            self.clear,
            self.interference,
            self.jammed,
            self.out_of_mesh,
            self.unproven,
            self.impossible,
        ];
        let others = [self.doubtful, self.below, self.above, self.outside];
        // No more than any run has: sums of them cannot overflow.
        let stretches = &self.outside_by_stretch;
        let spreads = [&self.least.count, &self.greatest.count];
        let most = counts.iter().chain(&others).chain(stretches).chain(spreads);
        if most.max().is_some_and(|most| *most > MOST_ASSEMBLIES) || stretches.len() != STRETCHES {
            return Err("a count is beyond what a run has".to_owned());
        }
        Ok(Tally {
            counts: Counts {
                clear: self.clear,
                interference: self.interference,
                jammed: self.jammed,
                out_of_mesh: self.out_of_mesh,
                unproven: self.unproven,
                impossible: self.impossible,
            },
            doubtful: self.doubtful,
            below: self.below,
            above: self.above,
            outside: self.outside,
            outside_by_stretch: stretches.clone(),
            least: self.least.spread()?,
            greatest: self.greatest.spread()?,
            worst: self.worst.iter().copied().collect(),
            first_impossible: self.first_impossible,
        })
    }
}

impl ContributionsRecord {
    pub fn of(sums: &ContributionSums) -> ContributionsRecord {
        let record = |group: &GroupSums| GroupRecord {
            rows: group.rows,
            left_out: group.left_out,
            samples: wide(&group.samples),
            factors: group.factors.iter().map(|sums| wide(sums)).collect(),
        };
        ContributionsRecord {
            least: sums.least.iter().map(record).collect(),
            greatest: sums.greatest.iter().map(record).collect(),
        }
    }

    /// Of so many quantities.
    pub fn sums(&self, quantities: usize) -> Result<ContributionSums, String> {
        let group = |record: &GroupRecord| {
            if record.factors.len() != quantities || record.rows > u64::from(u32::MAX) {
                return Err("it has sums of other quantities".to_owned());
            }
            let factors = record.factors.iter().map(|sums| narrow(sums));
            Ok(GroupSums {
                rows: record.rows,
                left_out: record.left_out,
                samples: narrow(&record.samples)?,
                factors: factors.collect::<Result<_, String>>()?,
            })
        };
        let groups = |records: &[GroupRecord]| match records.len() == GROUPS {
            true => records.iter().map(group).collect(),
            false => Err("it has another number of groups".to_owned()),
        };
        Ok(ContributionSums {
            least: groups(&self.least)?,
            greatest: groups(&self.greatest)?,
        })
    }
}

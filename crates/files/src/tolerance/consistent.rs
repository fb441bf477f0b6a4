//! Whether the sums of a part can be those of its assemblies: its file may have been edited, and what is added up and drawn relies on them.

use super::part_head::{MOST_ASSEMBLIES, PartHead, Progress};
use super::worst::Worst;
use crate::limits::CONTRIBUTION_ROWS;
use crate::shards::is_share;
use gearlash::population::{
    BIN_TENTHS_NM, ContributionSums, GROUPS, GroupSums, STRETCHES, Spread, Tally, WORST,
};
use std::ops::Range;

/// What is wrong with a part of which so much is `done`; `None`: nothing.
pub fn fault(
    head: &PartHead,
    done: Progress,
    tally: &Tally,
    sums: &ContributionSums,
    worst: &[Worst],
) -> Option<&'static str> {
    let fault = of_head(head);
    if fault.is_some() {
        return fault;
    }
    let (numbers, rows) = (head.numbers(), head.rows());
    if done.assemblies > numbers.end - numbers.start || done.rows > rows.end - rows.start {
        return Some("it says that more is done than it is to do");
    }
    let numbers = numbers.start..numbers.start + done.assemblies;
    let rows = rows.start..rows.start + done.rows;
    let fault = of_tally(tally, numbers, head.assemblies);
    let fault = fault.or_else(|| of_sums(sums, rows));
    fault.or_else(|| of_worst(worst, tally))
}

fn of_head(head: &PartHead) -> Option<&'static str> {
    if !head.is_of_this_format() {
        Some("it is of another format")
    } else if !(1..=MOST_ASSEMBLIES).contains(&head.assemblies)
        || head.contribution_rows > u64::from(*CONTRIBUTION_ROWS.end())
    {
        Some("its run has more than any run has, or nothing")
    } else if !is_share(head.assemblies, head.shard) {
        Some("its number is none of its run's parts")
    } else {
        None
    }
}

/// Sums over the assemblies `numbers` of `all`.
fn of_tally(tally: &Tally, numbers: Range<u64>, all: u64) -> Option<&'static str> {
    let counts = &tally.counts;
    let total = numbers.end - numbers.start;
    if counts.total() != total {
        return Some("its sums are not over the assemblies that it says are done");
    }
    let nothing = counts.unproven + counts.impossible;
    let (below, above, outside) = (tally.below, tally.above, tally.outside);
    if outside.max(tally.doubtful) > total {
        return Some("it counts more outside or in doubt than it has assemblies");
    }
    if !(below.max(above).max(nothing)..=below + above + nothing).contains(&outside) {
        return Some("what is outside is not what is below, above or without a result");
    }
    if tally.outside_by_stretch.iter().sum::<u64>() != tally.outside {
        return Some("its stretches do not add up to what is outside");
    }
    // Assembly n is in stretch ⌊(n − 1) 64/all⌋.
    let first = |stretch: usize| {
        let start = (stretch as u128 * u128::from(all)).div_ceil(STRETCHES as u128);
        start as u64 + 1
    };
    let length = |stretch: usize| {
        let (from, to) = (first(stretch), first(stretch + 1));
        to.min(numbers.end).saturating_sub(from.max(numbers.start))
    };
    let mut stretches = tally.outside_by_stretch.iter().enumerate();
    if stretches.any(|(stretch, count)| *count > length(stretch)) {
        return Some("a stretch counts more than it has assemblies");
    }
    let is_one = |number: &u64| numbers.contains(number);
    let first = tally.first_impossible.as_ref();
    if first.is_some() != (counts.impossible > 0) || !first.is_none_or(is_one) {
        return Some("its first impossible assembly is none of it");
    }
    let mut each: Vec<u64> = tally.worst.iter().map(|(_, number)| *number).collect();
    each.sort_unstable();
    each.dedup();
    if each.len() != tally.worst.len().min(WORST) || !each.iter().all(is_one) {
        return Some("its worst assemblies are none of it");
    }
    let fault = of_spread(&tally.least, &numbers);
    fault.or_else(|| of_spread(&tally.greatest, &numbers))
}

/// One extreme of those of the assemblies `numbers` that have it.
fn of_spread(spread: &Spread, numbers: &Range<u64>) -> Option<&'static str> {
    const NOT_ITS_SUMS: Option<&str> = Some("sums over lengths are none of such lengths");
    if spread.count > numbers.end - numbers.start {
        return Some("it has more lengths than assemblies");
    }
    let (Some(least), Some(greatest)) = (spread.least, spread.greatest) else {
        let is_empty = *spread == Spread::default();
        return if is_empty { None } else { NOT_ITS_SUMS };
    };
    let bins = [least, greatest].map(|(length, _)| Some(length.div_euclid(BIN_TENTHS_NM)));
    let ends = [
        spread.histogram.first_key_value(),
        spread.histogram.last_key_value(),
    ];
    let ordered = least.0 <= greatest.0;
    let known = numbers.contains(&least.1) && numbers.contains(&greatest.1);
    if !ordered || !known || ends.map(|end| end.map(|(bin, _)| *bin)) != bins {
        return Some("its least or its greatest length is none of its histogram");
    }
    // Between those of as many of the least and of the greatest; even powers no less than of the longest alone.
    let count = i128::from(spread.count);
    let longest = i128::from(least.0.unsigned_abs().max(greatest.0.unsigned_abs()));
    let fits = spread.sums.iter().zip(1u32..).all(|(sum, power)| {
        let one = longest.checked_pow(power);
        let even = power % 2 == 0;
        // Where so many times the longest does not fit, any sum is no more.
        one.is_some_and(|one| {
            let most = count.checked_mul(one).unwrap_or(i128::MAX);
            let low = if even { one } else { -most };
            (low..=most).contains(sum)
        })
    });
    let [sum, squares, ..] = spread.sums;
    let mean = count * i128::from(least.0)..=count * i128::from(greatest.0);
    // n Σx² is no less than (Σx)².
    let spreads = count.checked_mul(squares).zip(sum.checked_mul(sum));
    let spreads = spreads.is_none_or(|(squares, square)| squares >= square);
    match fits && mean.contains(&sum) && spreads {
        true => None,
        false => NOT_ITS_SUMS,
    }
}

/// Sums over `rows` of the samples for contributions.
fn of_sums(sums: &ContributionSums, rows: Range<u64>) -> Option<&'static str> {
    let groups = GROUPS as u64;
    // Row j is of group j modulo 32.
    let up_to = |end: u64, group: u64| (end + groups - 1 - group) / groups;
    for each in [&sums.least, &sums.greatest] {
        for (group, sums) in (0u64..).zip(each) {
            let length = up_to(rows.end, group) - up_to(rows.start, group);
            if sums.rows.checked_add(sums.left_out) != Some(length) {
                return Some("its groups do not add up to the rows that it says are done");
            }
            if !is_of_lengths(sums) {
                return Some("sums for contributions are none of lengths");
            }
        }
    }
    None
}

/// Whether no sum of a group is more than its rows can have, and no sum of squares below 0.
fn is_of_lengths(group: &GroupSums) -> bool {
    let rows = i128::from(group.rows);
    let length = i128::from(i64::MAX);
    let once = rows.saturating_mul(length);
    let twice = rows.saturating_mul(length * length);
    let [a, b, aa, bb, ab] = group.samples;
    let plain = |sum: i128| (-once..=once).contains(&sum);
    let square = |sum: i128| (0..=twice).contains(&sum);
    let product = |sum: i128| (-twice..=twice).contains(&sum);
    let samples = plain(a) && plain(b) && square(aa) && square(bb) && product(ab);
    let mut factors = group.factors.iter();
    samples
        && factors.all(|[mixed, squares, b_mixed, a_mixed]| {
            plain(*mixed) && square(*squares) && product(*b_mixed) && product(*a_mixed)
        })
}

/// Pair files of the worst assemblies: none yet, or those of `tally`.
fn of_worst(worst: &[Worst], tally: &Tally) -> Option<&'static str> {
    let kept = worst.iter().map(|worst| (worst.margin, worst.number));
    let is_theirs = worst.is_empty() || kept.eq(tally.worst.iter().copied());
    let lengths = worst
        .iter()
        .flat_map(|worst| [worst.least_mm, worst.greatest_mm]);
    let known = lengths.flatten().all(is_length);
    match is_theirs && known {
        true => None,
        false => Some("the pair files of its worst assemblies are not theirs"),
    }
}

/// Whether so many mm are a backlash, of gears of whatever size.
pub fn is_length(mm: f64) -> bool {
    mm.abs() <= 1e5
}

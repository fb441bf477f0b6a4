//! One decimal sign for the whole table.

use super::number::{Decimal, Written};
use super::wanted::Wanted;
use crate::data_file::DataFile;
use crate::problems::Problems;

/// A line whose cells are numbers.
pub struct Numbers<'a, const N: usize> {
    /// Its number.
    pub line: u64,
    /// The tooth.
    pub tooth: u32,
    /// As written.
    pub values: [Written<'a>; N],
}

/// Reports every number whose decimal sign is not that of the table, and once that nothing tells which it is; `stated`: the sign
/// by the pair file, `by_format`: the one the format settles.
pub fn check<const N: usize>(
    file: &DataFile,
    lines: &[Numbers<'_, N>],
    wanted: &Wanted<N>,
    (stated, by_format): (Option<Decimal>, Option<Decimal>),
    problems: &mut Problems,
) -> Option<()> {
    let with_sign = || {
        lines.iter().flat_map(|numbers| {
            let values = numbers.values.iter().zip(wanted.columns);
            values.filter_map(|(value, column)| {
                value
                    .decimal
                    .map(|decimal| (numbers.line, column, value, decimal))
            })
        })
    };
    let by_format = by_format.filter(|settled| with_sign().any(|(.., sign)| sign == *settled));
    let settled = stated.or(by_format);
    let Some(sign) = settled.or_else(|| with_sign().next().map(|(.., sign)| sign)) else {
        return Some(());
    };
    let proven = settled.is_some()
        || with_sign().any(|(_, _, value, found)| found == sign && !value.may_be_thousands);
    let mut good = Some(());
    for (line, column, value, found) in with_sign().filter(|(.., found)| *found != sign) {
        let reason = format!(
            "{} {} has a decimal {}, the table's decimal sign is the {}{}",
            column.name(),
            file.bare(value.text),
            found.name(),
            sign.name(),
            stated.map_or("", |_| " by the key `decimal`"),
        );
        let help = "write all numbers with one decimal sign and without thousands separators";
        problems.add(file.problem_at(line, reason, help));
        good = None;
    }
    let mut unsure = with_sign().filter(|(.., found)| *found == sign && !proven);
    if let Some((line, column, value, _)) = unsure.next() {
        let more = match unsure.count() {
            0 => String::new(),
            more => format!(" (as {more} more in the table)"),
        };
        let reason = format!(
            "{} {} may have a decimal {} or a thousands separator{more}: nothing in the table shows which",
            column.name(),
            file.bare(value.text),
            sign.name(),
        );
        let help = format!(
            "state the decimal sign beside the file: decimal = \"{}\", and write numbers without thousands separators",
            sign.sign()
        );
        problems.add(file.problem_at(line, reason, help));
        good = None;
    }
    good
}

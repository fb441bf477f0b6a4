//! One decimal sign for the whole table.

use super::Wanted;
use super::number::{Decimal, Written};
use crate::input::data_file::DataFile;
use crate::input::problems::Problems;

/// A line whose cells are numbers.
pub struct Numbers<'a, const N: usize> {
    /// Its number.
    pub line: u64,
    /// The tooth.
    pub tooth: u32,
    /// As written.
    pub values: [Written<'a>; N],
}

/// Reports every number whose decimal sign is not that of the table, or may be none; `by_format`: the sign the format settles.
pub fn check<const N: usize>(
    file: &DataFile,
    lines: &[Numbers<'_, N>],
    wanted: &Wanted<N>,
    by_format: Option<Decimal>,
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
    let settled = by_format.filter(|settled| with_sign().any(|(.., sign)| sign == *settled));
    let Some(sign) = settled.or_else(|| with_sign().next().map(|(.., sign)| sign)) else {
        return Some(());
    };
    let proven = settled.is_some()
        || with_sign().any(|(_, _, value, found)| found == sign && !value.may_be_thousands);
    let mut good = Some(());
    for (line, column, value, found) in with_sign() {
        let name = column.names()[0];
        let (reason, way_out) = if found != sign {
            (
                format!(
                    "{name} {} has a decimal {}, the table's decimal sign is the {}",
                    value.text,
                    found.name(),
                    sign.name()
                ),
                "write all numbers with one decimal sign and without thousands separators",
            )
        } else if !proven && value.may_be_thousands {
            (
                format!(
                    "{name} {} may have a decimal {} or a thousands separator: nothing in the table tells",
                    value.text,
                    sign.name()
                ),
                "write one digit more or less behind the decimal sign, or save as CSV separated by semicolons (decimal comma) or commas (decimal point)",
            )
        } else {
            continue;
        };
        problems.add(file.problem_at(line, reason, way_out));
        good = None;
    }
    good
}

//! One decimal sign per table: a decimal point or a decimal comma, never both.
//!
//! `1,234` can be one and a bit, or a thousand and a bit. One decimal sign therefore holds for the whole table. Its separator can
//! determine it: a comma between columns leaves the point, and German Excel writes `;` because its decimal sign is the comma. So
//! can a number that cannot have thousands separators, such as `0,5`, `12.34` or a span of `19,230` mm. Otherwise the number is a
//! problem.

use crate::column::{Column, Quantity};
use crate::data_file::DataFile;
use gearlash_text::file_numbers::{Decimal, FileNumber};
use std::cmp::Ordering;

/// No span, dimension over pins or centre distance reaches this length, mm.
const MAX_MM: f64 = 10_000.0;

/// A number of a table: its line, its column, and its text.
pub type Placed<'a> = (u64, Column, FileNumber<'a>);

/// Checks that all `numbers` have one decimal sign, and that the table determines which one.
///
/// `stated` is the sign in the pair file, `by_format` the sign that the format implies.
pub fn check_decimal_sign(
    file: &DataFile,
    numbers: &[Placed],
    [stated, by_format]: [Option<Decimal>; 2],
) -> Option<()> {
    let with = |sign| {
        let all = numbers.iter();
        all.filter(move |(.., number)| number.decimal == Some(sign))
    };
    let [points, commas] = [Decimal::Point, Decimal::Comma].map(|sign| with(sign).count());
    let more = |count: usize| match count - 1 {
        0 => String::new(),
        more => format!(" (as {more} more in the table)"),
    };
    // The rarer sign is the slip.
    let settled = stated.or(match points.cmp(&commas) {
        _ if points == 0 || commas == 0 => by_format.filter(|sign| with(*sign).count() > 0),
        Ordering::Less => Some(Decimal::Comma),
        Ordering::Greater => Some(Decimal::Point),
        Ordering::Equal => by_format,
    });
    let Some(sign) = settled.or_else(|| numbers.iter().find_map(|(.., number)| number.decimal))
    else {
        return Some(());
    };
    let other = match sign {
        Decimal::Point => Decimal::Comma,
        Decimal::Comma => Decimal::Point,
    };
    if let Some((line, column, number)) = with(other).next() {
        let reason = format!(
            "{} {} has a decimal {}{}, the table's decimal sign is the {}{}",
            column.name(),
            file.bare(number.text),
            other.name(),
            more(with(other).count()),
            sign.name(),
            stated.map_or("", |_| " by the key `decimal`"),
        );
        let help = "write all numbers with one decimal sign and without thousands separators";
        file.add_at(*line, reason, help);
        return None;
    }
    let is_proven = settled.is_some()
        || with(sign).any(|(_, column, number)| !may_be_thousands(*column, number));
    if let Some((line, column, number)) = with(sign).next().filter(|_| !is_proven) {
        let reason = format!(
            "{} {} may have a decimal {} or a thousands separator{}: nothing in the table shows which",
            column.name(),
            file.bare(number.text),
            sign.name(),
            more(with(sign).count()),
        );
        let help = format!(
            "state the decimal sign beside the file: decimal = \"{}\", and write numbers without thousands separators",
            sign.sign()
        );
        file.add_at(*line, reason, help);
        return None;
    }
    Some(())
}

/// Whether the sign of `number` can separate thousands. In a length it can only where a thousand times its value is possible.
fn may_be_thousands(column: Column, number: &FileNumber) -> bool {
    let is_length = matches!(
        column.quantity,
        Quantity::Span | Quantity::OverPins | Quantity::CenterDistance
    );
    number.may_be_thousands && !(is_length && 1000.0 * number.value >= MAX_MM)
}

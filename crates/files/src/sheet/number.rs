//! Numbers in tables: with a decimal point or a decimal comma, never both; and one decimal sign per table.
//!
//! `1,234` can be one and a bit, or a thousand and a bit. One decimal sign therefore holds for the whole table. Its separator can
//! determine it: a comma between columns leaves the point, and German Excel writes `;` because its decimal sign is the comma. So
//! can a number that cannot have thousands separators, such as `0,5`, `12.34` or a span of `19,230` mm. Otherwise the number is a
//! problem.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;

use super::column::{Column, Quantity};
use crate::data_file::DataFile;

/// Word processors turn a hyphen before a number into this sign.
const MINUS: char = '\u{2212}';
/// No span, dimension over pins or centre distance reaches this length, mm.
const MAX_MM: f64 = 10_000.0;

/// A sign between whole part and fraction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub enum Decimal {
    /// A point.
    #[serde(rename = ".")]
    Point,
    /// A comma.
    #[serde(rename = ",")]
    Comma,
}

impl Decimal {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Decimal::Point => "point",
            Decimal::Comma => "comma",
        }
    }

    /// The sign itself.
    pub fn sign(self) -> char {
        match self {
            Decimal::Point => '.',
            Decimal::Comma => ',',
        }
    }
}

/// A well-formed number.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Written<'a> {
    /// As written.
    pub text: &'a str,
    /// The number, if its sign is a decimal one.
    pub value: f64,
    /// Its decimal sign; `None` without one.
    pub decimal: Option<Decimal>,
    /// Whether that sign could separate thousands: one to three digits before, three behind.
    pub may_be_thousands: bool,
    /// Half a unit of the last digit written.
    pub rounding: f64,
}

/// Reads `text` as a number: a sign (a hyphen or the true minus U+2212), digits, at most one decimal sign between digits, an exponent.
///
/// `None` for anything else, including `nan`, `inf` and numbers that overflow to it.
pub fn written(text: &str) -> Option<Written<'_>> {
    let (mantissa, exponent) = match unsigned(text).split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (unsigned(text), None),
    };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let power: i32 = match exponent {
        Some(exponent) if digits(exponent.strip_prefix(['-', '+']).unwrap_or(exponent)) => {
            exponent.parse().ok()?
        }
        Some(_) => return None,
        None => 0,
    };
    let decimal = match mantissa.find(['.', ',']).map(|at| mantissa.as_bytes()[at]) {
        Some(b'.') => Some(Decimal::Point),
        Some(_) => Some(Decimal::Comma),
        None => None,
    };
    let (whole, fraction) = match decimal {
        Some(decimal) => mantissa.split_once(decimal.sign())?,
        None => (mantissa, ""),
    };
    if !digits(whole) || decimal.is_some() && !digits(fraction) {
        return None;
    }
    let value: f64 = text.replace(',', ".").replace(MINUS, "-").parse().ok()?;
    value.is_finite().then_some(Written {
        text,
        value,
        decimal,
        may_be_thousands: fraction.len() == 3
            && whole.len() <= 3
            && !whole.starts_with('0')
            && exponent.is_none(),
        rounding: 0.5 * 10f64.powi(power.saturating_sub(fraction.len() as i32)),
    })
}

/// Reads `word` as [`written`] with a decimal point. The 0 before the point can be missing, as in the files of P40.
pub fn without_zero(word: &str) -> Option<Written<'_>> {
    let at = usize::from(word.starts_with(['-', '+']));
    if !word[at..].starts_with('.') {
        let found = written(word)?;
        return (found.decimal != Some(Decimal::Comma) && !zero_first(word)).then_some(found);
    }
    let full = format!("{}0{}", &word[..at], &word[at..]);
    let Written {
        value,
        decimal,
        may_be_thousands,
        rounding,
        ..
    } = written(&full)?;
    Some(Written {
        text: word,
        value,
        decimal,
        may_be_thousands,
        rounding,
    })
}

/// Whether the whole part begins with 0 and has more digits, such as `05`: its decimal sign is lost. No table writes such a cell.
pub fn zero_first(text: &str) -> bool {
    let mut signs = unsigned(text).bytes();
    signs.next() == Some(b'0') && signs.next().is_some_and(|b| b.is_ascii_digit())
}

/// `text` without its sign.
fn unsigned(text: &str) -> &str {
    text.strip_prefix(['-', '+', MINUS]).unwrap_or(text)
}

/// The tooth number `text`: digits only.
pub fn tooth(text: &str) -> Option<u32> {
    let digits = text.bytes().all(|b| b.is_ascii_digit());
    digits.then(|| text.parse().ok())?
}

/// A number of a table: its line, its column, and its text.
pub type Placed<'a> = (u64, Column, Written<'a>);

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
fn may_be_thousands(column: Column, number: &Written) -> bool {
    let is_length = matches!(
        column.quantity,
        Quantity::Span | Quantity::OverPins | Quantity::CenterDistance
    );
    number.may_be_thousands && !(is_length && 1000.0 * number.value >= MAX_MM)
}

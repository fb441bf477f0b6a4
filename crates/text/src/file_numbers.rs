//! Numbers as files write them: with a decimal point or a decimal comma.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Word processors turn a hyphen before a number into this sign.
const MINUS: char = '\u{2212}';

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
pub struct FileNumber<'a> {
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
pub fn number(text: &str) -> Option<FileNumber<'_>> {
    read(text, text)
}

/// The number `text`, which the file has as `written`.
fn read<'a>(text: &str, written: &'a str) -> Option<FileNumber<'a>> {
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
    value.is_finite().then_some(FileNumber {
        text: written,
        value,
        decimal,
        may_be_thousands: fraction.len() == 3
            && whole.len() <= 3
            && !whole.starts_with('0')
            && exponent.is_none(),
        rounding: 0.5 * 10f64.powi(power.saturating_sub(fraction.len() as i32)),
    })
}

/// Reads `word` as [`number`] with a decimal point. The 0 before the point can be missing, as in the files of P40.
pub fn point_number(word: &str) -> Option<FileNumber<'_>> {
    let at = usize::from(word.starts_with(['-', '+']));
    if !word[at..].starts_with('.') {
        let found = number(word)?;
        return (found.decimal != Some(Decimal::Comma) && !has_leading_zero(word)).then_some(found);
    }
    read(&format!("{}0{}", &word[..at], &word[at..]), word)
}

/// Whether the whole part begins with 0 and has more digits, such as `05`: its decimal sign is lost. No table writes such a cell.
pub fn has_leading_zero(text: &str) -> bool {
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

//! Numbers as tables write them: with a decimal point or a decimal comma, never both.
//!
//! `1,234` may be one and a bit, or a thousand and a bit. Which sign is the
//! decimal one is therefore settled for the whole table: by its delimiter (a
//! comma between columns leaves the point; German Excel writes `;` between
//! columns because its decimal sign is the comma), or by a number that cannot
//! have thousands separators, such as `0,5` or `12.34`. Where neither settles
//! it, the number is a problem.

/// What word processors make of a hyphen before a number.
const MINUS: char = '\u{2212}';

/// A sign that may stand between whole and fraction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Decimal {
    /// `1.5`
    Point,
    /// `1,5`
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

    /// As written.
    pub fn sign(self) -> char {
        match self {
            Decimal::Point => '.',
            Decimal::Comma => ',',
        }
    }
}

/// A number that is written well.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Written<'a> {
    /// As written.
    pub text: &'a str,
    /// The number, if its decimal sign is one.
    pub value: f64,
    /// Its decimal sign; `None` without one.
    pub decimal: Option<Decimal>,
    /// Whether that sign could separate thousands: one to three digits before, three behind.
    pub may_be_thousands: bool,
    /// Half a unit of the last digit written.
    pub rounding: f64,
}

/// `text` as a number: a sign (a hyphen or the true minus U+2212), digits, at most one decimal sign between digits,
/// an exponent.
///
/// `None` for anything else, `nan`, `inf` and what overflows to it included.
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

/// Whether the whole part has several digits, of which the first is 0, such as `05`: its decimal sign is lost, or its
/// digits are. No cell of a deviation or a length is written so.
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

/// As [`written`], and without the 0 before the point, as the machines of P40 leave it out.
pub fn without_zero(word: &str) -> Option<Written<'_>> {
    let at = usize::from(word.starts_with(['-', '+']));
    if !word[at..].starts_with('.') {
        let found = written(word)?;
        return (found.decimal != Some(Decimal::Comma) && !zero_first(word)).then_some(found);
    }
    let full = format!("{}0{}", &word[..at], &word[at..]);
    let found = written(&full)?;
    Some(Written {
        text: word,
        value: found.value,
        decimal: found.decimal,
        may_be_thousands: found.may_be_thousands,
        rounding: found.rounding,
    })
}

/// Numbers that stand for a value that was not measured: what machines print, whatever the preamble says.
const KNOWN: [f64; 2] = [-2147483.648, -9999.0];

/// The numbers that stand for a value that was not measured in one file.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unmeasured {
    /// `UNDEFINED` of the preamble.
    said: Option<f64>,
}

impl Unmeasured {
    /// With the number that a preamble names.
    pub fn said(number: f64) -> Unmeasured {
        Unmeasured { said: Some(number) }
    }

    /// What `value` is where it is one of them, in words.
    pub fn words(self, value: &Written) -> &'static str {
        match Unmeasured::default().is(value) {
            true => "stands for a value that was not measured",
            false => "stands for a value that was not measured, as UNDEFINED of the preamble says",
        }
    }

    /// Whether `value` is one of them, as far as its digits say; never by its size.
    pub fn is(self, value: &Written) -> bool {
        // Whole numbers at most: 1e7 has its last digit seven places above them.
        let rounding = value.rounding.min(0.5);
        let mut numbers = KNOWN.into_iter().chain(self.said);
        numbers.any(|number| (value.value - number).abs() <= rounding + 1e-12 * number.abs())
    }
}

//! Rows that sum up a table, known by their label.

use super::cell::{Cell, Line};
use super::heading;

/// Labels as [`heading::plain`] leaves them.
const LABELS: &[&str] = &[
    "max",
    "maximum",
    "maximal",
    "größtwert",
    "min",
    "minimum",
    "minimal",
    "kleinstwert",
    "mean",
    "meanvalue",
    "average",
    "avg",
    "mittel",
    "mittelwert",
    "mw",
    "median",
    "range",
    "spannweite",
    "spanne",
    "sum",
    "summe",
    "total",
    "std",
    "stddev",
    "stdev",
    "sd",
    "standarddeviation",
    "standardabweichung",
    "stabw",
    "sigma",
    "σ",
    "x̄",
    "x̅",
    "ø",
    "⌀",
    "count",
    "anzahl",
    "tolerance",
    "toleranz",
    "tol",
    "limit",
    "grenzwert",
    "grade",
    "qualität",
    "class",
    "klasse",
    "n1",
    "n−1",
];

/// Deviations that a line of statistics is of, as they are written.
const SYMBOLS: &[&str] = &[
    "fp", "Fp", "fpt", "fu", "fr", "Fr", "Fpz/8", "Rp", "Rs", "fHα", "fHa", "ffα", "ffa", "Fα",
    "Fa", "Ws", "Wk", "Mdk", "MdK",
];

/// The label of a line that is a statistic: the first cell with content, in the column of teeth or with none there.
pub fn label(line: &Line, tooth: usize) -> Option<&str> {
    let Some(Cell::Text(text)) = line.first() else {
        return None;
    };
    let at_tooth = line.cell(tooth);
    let is_free = *at_tooth == Cell::Empty || *at_tooth == Cell::Text(text.clone());
    (is_free && says(text)).then_some(text)
}

/// Whether `text` is a label: `max`, `Fp max`, `σ (n−1)`, `Klasse 6`; a number alone is none.
fn says(text: &str) -> bool {
    let (name, _) = heading::name_and_unit(text);
    let separators = |c: char| c.is_whitespace() || "=()[]:".contains(c);
    let words = name.split(separators).filter(|word| !word.is_empty());
    let is_label = |word: &str| {
        let plain = heading::plain(word);
        SYMBOLS.contains(&word.trim_end_matches('.')) || LABELS.contains(&plain.as_str())
    };
    let is_known = |word: &str| {
        is_label(word)
            || word.split(['-', '–', '/']).all(is_label)
            || word.bytes().all(|b| b.is_ascii_digit())
    };
    let whole = heading::plain(name);
    LABELS.contains(&whole.as_str())
        || (words.clone().all(is_known)
            && words
                .clone()
                .any(|word| !word.starts_with(|c: char| c.is_ascii_digit())))
}

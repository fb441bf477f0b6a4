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
    "max-min",
    "maxmin",
];

/// The label of a line that is a statistic: the first cell with content, in the column of teeth or with none there.
pub fn label(line: &Line, tooth: usize) -> Option<&str> {
    let Some(Cell::Text(text)) = line.first() else {
        return None;
    };
    let at_tooth = line.cell(tooth);
    let is_free = *at_tooth == Cell::Empty || *at_tooth == Cell::Text(text.clone());
    let (name, _) = heading::name_and_unit(text);
    let name = heading::plain(name.trim_end_matches(['=', ' ']));
    (is_free && LABELS.contains(&name.as_str())).then_some(text)
}

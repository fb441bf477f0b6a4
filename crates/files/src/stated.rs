//! One value, or one at least and one at most material.

use super::entry::Limits;
use super::problems::Problems;
use super::spec::{BandSpec, Either};
use super::table::Table;
use gearlash::metrology::Toleranced;

/// The three keys under which a value may be stated.
pub struct Keys {
    /// The single value; `None` where it stands without a table.
    pub single: Option<&'static str>,
    /// The least value.
    pub min: &'static str,
    /// The greatest value.
    pub max: &'static str,
}

/// Reads a single value, or min and max together, from `table`.
pub fn read(
    table: &Table,
    keys: &Keys,
    limits: &Limits,
    problems: &mut Problems,
) -> Option<Toleranced<f64>> {
    let &Keys { single, min, max } = keys;
    let either = match single {
        Some(single) => format!("`{single}` alone, or `{min}` and `{max}`"),
        None => format!("`{min}` and `{max}`"),
    };
    if let Some(single) = single.filter(|single| table.has(single)) {
        table.alone(single, &[min, max], &either, problems)?;
        return table
            .number(single, limits, problems)
            .map(Toleranced::Single);
    }
    for (given, absent) in [(min, max), (max, min)] {
        if table.has(given) && !table.has(absent) {
            problems.add(table.problem(
                given,
                format!("given without {absent}, allowed is {either}"),
                format!("add `{absent}`, or give a single value"),
            ));
            return None;
        }
    }
    if !table.has(min) {
        // Names the single value where there is one: the commonest case.
        table.need(single.unwrap_or(min), &either, problems);
        return None;
    }
    let least = table.number(min, limits, problems);
    let most = table.number(max, limits, problems);
    let (least, most) = (least?, most?);
    if least > most {
        problems.add(table.problem(
            min,
            format!("greater than {max} = {most:?}, allowed is up to {max}"),
            "swap the two",
        ));
        return None;
    }
    Some(Toleranced::Band { least, most })
}

/// `value` as a pair file writes it, a single one without a table.
pub fn spec(value: &Toleranced<f64>) -> Either<f64, BandSpec> {
    match *value {
        Toleranced::Single(value) => Either::One(value),
        Toleranced::Band { least, most } => Either::Other(BandSpec {
            min: least,
            max: most,
        }),
    }
}

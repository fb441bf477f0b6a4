//! One value, or one at least and one at most material.

use super::entry::Limits;
use super::problems::Problems;
use super::spec::{BandSpec, Either};
use super::table::Table;
use gearlash::metrology::Toleranced;

/// What a pair file states about a toleranced quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stated<T> {
    /// A single value.
    Single(T),
    /// `min` and `max`: thinnest and thickest teeth.
    Band {
        /// At least material.
        least: T,
        /// At most material.
        most: T,
    },
}

impl Stated<f64> {
    /// Whether it has two values.
    pub fn is_band(&self) -> bool {
        matches!(self, Stated::Band { .. })
    }

    /// What was measured.
    pub fn measured(&self) -> Toleranced<f64> {
        match *self {
            Stated::Single(value) => Toleranced::Single(value),
            Stated::Band { least, most } => Toleranced::Band { least, most },
        }
    }
}

/// The three keys under which a value may be stated.
pub struct Keys {
    /// The single value; `None` where it stands without a table.
    pub single: Option<&'static str>,
    /// The least value.
    pub min: &'static str,
    /// The greatest value.
    pub max: &'static str,
}

impl Stated<f64> {
    /// Reads a single value, or min and max together, from `table`.
    pub fn read(
        table: &Table,
        keys: &Keys,
        limits: &Limits,
        problems: &mut Problems,
    ) -> Option<Stated<f64>> {
        let &Keys { single, min, max } = keys;
        let either = match single {
            Some(single) => format!("`{single}` alone, or `{min}` and `{max}`"),
            None => format!("`{min}` and `{max}`"),
        };
        if let Some(single) = single.filter(|single| table.has(single)) {
            if let Some(second) = [min, max].into_iter().find(|name| table.has(name)) {
                problems.add(table.problem(
                    single,
                    format!("stands beside {second}, allowed is {either}"),
                    "remove one or the other",
                ));
                return None;
            }
            return table.number(single, limits, problems).map(Stated::Single);
        }
        for (given, absent) in [(min, max), (max, min)] {
            if table.has(given) && !table.has(absent) {
                problems.add(table.problem(
                    given,
                    format!("stands without {absent}, allowed is {either}"),
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
        Some(Stated::Band { least, most })
    }

    /// As a pair file writes it, a single value without a table.
    pub fn spec(&self) -> Either<f64, BandSpec> {
        match *self {
            Stated::Single(value) => Either::One(value),
            Stated::Band { least, most } => Either::Other(BandSpec {
                min: least,
                max: most,
            }),
        }
    }
}

//! A table as cells, and the step from cells to numbers.

use super::column::{self, Named};
use super::number::{self, Decimal, Written};
use super::{Row, Wanted};
use crate::error::Problem;
use crate::input::data_file::DataFile;
use crate::input::entry::whole_in;
use crate::input::node::Node;
use crate::input::problems::Problems;

/// One cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing, or only white space.
    Empty,
    /// Text without white space around it; in a text file numbers are text too.
    Text(String),
    /// A number of a workbook.
    Number(f64),
    /// Anything else of a workbook, in words.
    Other(String),
}

/// One line of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Its number in the file, from 1.
    pub number: u64,
    /// From the first column on.
    pub cells: Vec<Cell>,
}

/// A header and what stands below it.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// The names of the columns.
    pub header: Line,
    /// Without blank ones.
    pub lines: Vec<Line>,
    /// The decimal sign where the format settles it.
    pub decimal: Option<Decimal>,
}

/// Where the columns stand.
struct Places<const N: usize> {
    tooth: usize,
    wanted: [usize; N],
}

/// A line whose cells are numbers.
struct Numbers<'a, const N: usize> {
    line: u64,
    tooth: u32,
    values: [Written<'a>; N],
}

impl Line {
    /// Whether every cell is empty.
    pub fn is_blank(&self) -> bool {
        self.cells.iter().all(|cell| *cell == Cell::Empty)
    }
}

impl Grid {
    /// `lines`, of which the first is the header; `None` when there are none.
    pub fn of(lines: Vec<Line>, decimal: Option<Decimal>) -> Option<Grid> {
        let mut lines = lines.into_iter();
        Some(Grid {
            header: lines.next()?,
            lines: lines.collect(),
            decimal,
        })
    }

    /// The rows as numbers, in the order of the lines.
    pub fn rows<const N: usize>(
        &self,
        file: &DataFile,
        wanted: &Wanted<N>,
        problems: &mut Problems,
    ) -> Option<Vec<Row<N>>> {
        let places = self.places(file, wanted, problems)?;
        // All lines are read before the first bad one ends it.
        let mut numbers = Vec::new();
        for line in &self.lines {
            numbers.push(self.numbers(file, line, &places, wanted, problems));
        }
        let numbers: Vec<Numbers<'_, N>> = numbers.into_iter().collect::<Option<_>>()?;
        self.check_decimal_signs(file, &numbers, wanted, problems)?;
        let rows = numbers.iter().map(|numbers| Row {
            line: numbers.line,
            tooth: numbers.tooth,
            values: numbers.values.map(|written| written.value),
        });
        Some(rows.collect())
    }

    fn places<const N: usize>(
        &self,
        file: &DataFile,
        wanted: &Wanted<N>,
        problems: &mut Problems,
    ) -> Option<Places<N>> {
        let way_out = format!(
            "name the columns {} there",
            column::headings(&wanted.columns)
        );
        let line = self.header.number;
        let mut tooth = None;
        let mut places = [None; N];
        let mut good = Some(());
        let mut wrong = |reason: String, way_out: String| {
            problems.add(file.problem_at(line, reason, way_out));
            good = None;
        };
        for (place, cell) in self.header.cells.iter().enumerate() {
            if *cell == Cell::Empty {
                continue;
            }
            let text = cell.name();
            let slot = match column::named(&text, &wanted.columns) {
                Named::Tooth => &mut tooth,
                Named::Wanted(index) => &mut places[index],
                Named::Wrong(reason, way_out) => {
                    wrong(reason, way_out);
                    continue;
                }
            };
            if slot.is_some() {
                wrong(
                    format!("column {text:?} is the second of its kind"),
                    "remove one".to_owned(),
                );
            }
            *slot = Some(place);
        }
        // A name that is not understood may be the one that is missing.
        good?;
        let names = wanted.columns.map(|column| column.names()[0]);
        for (name, place) in [("tooth", tooth)]
            .into_iter()
            .chain(names.into_iter().zip(places))
        {
            if place.is_none() {
                problems.add(file.problem_at(
                    line,
                    format!("column {name} is missing"),
                    way_out.clone(),
                ));
            }
        }
        let mut found = [0; N];
        for (found, place) in found.iter_mut().zip(places) {
            *found = place?;
        }
        Some(Places {
            tooth: tooth?,
            wanted: found,
        })
    }

    fn numbers<'a, const N: usize>(
        &self,
        file: &DataFile,
        line: &'a Line,
        places: &Places<N>,
        wanted: &Wanted<N>,
        problems: &mut Problems,
    ) -> Option<Numbers<'a, N>> {
        let (columns, found) = (self.header.cells.len(), line.cells.len());
        if found != columns {
            problems.add(file.problem_at(
                line.number,
                format!("{found} values, the header names {columns} columns"),
                "give every column one value; in a file separated by commas numbers need a point",
            ));
            return None;
        }
        let mut good = Some(());
        let unnamed = self.header.cells.iter().zip(&line.cells);
        for (_, cell) in
            unnamed.filter(|(name, cell)| **name == Cell::Empty && **cell != Cell::Empty)
        {
            problems.add(file.problem_at(
                line.number,
                format!("{} stands in a column without a name", cell.shown()),
                "remove it, or name its column",
            ));
            good = None;
        }
        let teeth = 1..=wanted.teeth.unwrap_or(10_000);
        let tooth = line.cells.get(places.tooth).and_then(Cell::tooth);
        let tooth = tooth.filter(|tooth| teeth.contains(tooth));
        if tooth.is_none() {
            let cell = &line.cells[places.tooth];
            let allowed = whole_in(&teeth);
            problems.add(wrong_cell(file, line.number, "tooth", cell, &allowed));
        }
        let mut values = [None; N];
        for (index, column) in wanted.columns.iter().enumerate() {
            let cell = &line.cells[places.wanted[index]];
            let limits = column.limits();
            values[index] = cell
                .number()
                .filter(|written| (limits.holds)(written.value));
            if values[index].is_none() {
                let name = column.names()[0];
                problems.add(wrong_cell(file, line.number, name, cell, limits.allowed));
            }
        }
        good?;
        let mut numbers = [Written::default(); N];
        for (number, value) in numbers.iter_mut().zip(values) {
            *number = value?;
        }
        Some(Numbers {
            line: line.number,
            tooth: tooth?,
            values: numbers,
        })
    }

    /// Reports every number whose decimal sign is not that of the table, or may be none.
    fn check_decimal_signs<const N: usize>(
        &self,
        file: &DataFile,
        lines: &[Numbers<'_, N>],
        wanted: &Wanted<N>,
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
        let settled = self
            .decimal
            .filter(|settled| with_sign().any(|(.., sign)| sign == *settled));
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
}

impl Cell {
    /// As it stands there, for a message; long ones cut.
    fn shown(&self) -> String {
        match self {
            Cell::Empty => "empty".to_owned(),
            Cell::Text(text) => Node::Text(text.clone()).shown(),
            Cell::Number(number) => number.to_string(),
            Cell::Other(words) => words.clone(),
        }
    }

    /// As a column's name.
    fn name(&self) -> String {
        match self {
            Cell::Text(text) => text.clone(),
            other => other.shown(),
        }
    }

    fn tooth(&self) -> Option<u32> {
        match self {
            Cell::Text(text) => number::tooth(text),
            // The cast saturates.
            Cell::Number(number) => (number.fract() == 0.0).then_some(*number as u32),
            Cell::Empty | Cell::Other(_) => None,
        }
    }

    fn number(&self) -> Option<Written<'_>> {
        match self {
            Cell::Text(text) => number::written(text),
            Cell::Number(number) => number.is_finite().then_some(Written {
                value: *number,
                ..Written::default()
            }),
            Cell::Empty | Cell::Other(_) => None,
        }
    }
}

fn wrong_cell(file: &DataFile, line: u64, name: &str, cell: &Cell, allowed: &str) -> Problem {
    let reason = format!("{name} is {}, allowed is {allowed}", cell.shown());
    file.problem_at(line, reason, "correct the line")
}

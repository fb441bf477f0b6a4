//! A table as cells, and the step from cells to numbers.

use super::cell::{Cell, Line};
use super::decimal::{self, Numbers};
use super::number::{self, Decimal, Written};
use super::places::{self, Places};
use super::wanted::{Row, Wanted};
use crate::data_file::DataFile;
use crate::entry::whole_in;
use crate::error::Problem;
use crate::problems::Problems;
use std::ops::RangeBounds;

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

    /// The rows as numbers, in the order of the lines; `stated`: the decimal sign by the pair file.
    pub fn rows<const N: usize>(
        &self,
        file: &DataFile,
        wanted: &Wanted<N>,
        stated: Option<Decimal>,
        problems: &mut Problems,
    ) -> Option<Vec<Row<N>>> {
        let places = places::places(&self.header, file, wanted, problems)?;
        // All lines are read before the first bad one ends it.
        let mut numbers = Vec::new();
        for line in &self.lines {
            numbers.push(self.numbers(file, line, &places, wanted, problems));
        }
        let numbers: Vec<Numbers<'_, N>> = numbers.into_iter().collect::<Option<_>>()?;
        let settled = (stated, self.decimal);
        decimal::check(file, &numbers, wanted, settled, problems)?;
        let rows = numbers.iter().map(|numbers| Row {
            line: numbers.line,
            tooth: numbers.tooth,
            values: numbers.values.map(|written| written.value),
        });
        Some(rows.collect())
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
                match self.decimal {
                    Some(Decimal::Point) => {
                        "give every column one value; in a file separated by commas numbers need a point"
                    }
                    _ => "give every column one value, and nothing else",
                },
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
                format!("{} is in a column without a name", cell.shown(file)),
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
                .filter(|written| limits.range.contains(&written.value));
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
}

/// The problem of a cell that is not what its column allows.
pub fn wrong_cell(file: &DataFile, line: u64, name: &str, cell: &Cell, allowed: &str) -> Problem {
    let lost = match cell {
        Cell::Text(text) if number::zero_first(text) => ", as if its decimal sign were lost",
        _ => "",
    };
    let reason = format!("{name} is {}{lost}, allowed is {allowed}", cell.shown(file));
    file.problem_at(line, reason, "correct the line")
}

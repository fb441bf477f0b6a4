//! A table as cells: the part of a text or a sheet that is the table, and the step from its cells to numbers.

use super::cell::{Cell, Line};
use super::choice::Choice;
use super::column::Column;
use super::decimal::{self, Numbers};
use super::head::{Head, letter};
use super::left_out::LeftOut;
use super::limits::MOST_NAMED;
use super::number::{self, Decimal, Written};
use super::places::{Places, places};
use super::statistic;
use super::wanted::{Row, Wanted};
use crate::data_file::DataFile;
use crate::entry::whole_in;
use crate::error::Problem;
use crate::problems::Problems;
use std::ops::RangeBounds;

/// What one sheet holds, or a text by one separator.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Of a sheet, its name.
    pub sheet: Option<String>,
    /// At least one, without blank ones.
    pub lines: Vec<Line>,
    /// The decimal sign where the format settles it.
    pub decimal: Option<Decimal>,
}

/// A table in a grid.
#[derive(Debug)]
pub struct FoundTable<'a> {
    pub grid: &'a Grid,
    pub head: Head,
    /// The lines of its rows.
    pub rows: Vec<&'a Line>,
    /// What stands beside the table.
    pub left_out: LeftOut,
}

impl<'a> FoundTable<'a> {
    /// The table below `head`, with numbers in the columns `used`, that of the teeth first, and words in those `beside`.
    ///
    /// Comments, statistics, what stands above the header and what is no row below the last one is left out.
    pub fn below(
        grid: &'a Grid,
        head: Head,
        [used, beside]: [&[usize]; 2],
        file: &DataFile,
        problems: &mut Problems,
    ) -> Option<FoundTable<'a>> {
        let begin = head.at + 1 + usize::from(head.has_units);
        let mut left_out = LeftOut::default();
        for (at, line) in grid.lines[..head.at].iter().enumerate() {
            let is_number = |place: &usize| line.cell(*place).number().is_some();
            if used.first().is_some_and(is_number) && used.iter().skip(1).any(is_number) {
                problems.add(file.problem_at(
                    line.number,
                    format!("has numbers like a row of the table, but stands above its header in line {}", head.line),
                    "move it below the header, or remove it",
                ));
                return None;
            }
            if !(head.has_groups && at + 1 == head.at) {
                left_out.line(line.number);
            }
        }
        let mut rows = Vec::new();
        for line in &grid.lines[begin..] {
            if grid.sheet.is_none() && line.cells.iter().any(Cell::is_torn) {
                problems.add(file.problem_at(
                    line.number,
                    "a cell of several lines that hold separators, as if a quotation mark were missing or left over",
                    "correct the quotation marks",
                ));
                return None;
            }
            match statistic::label(line, used[0]) {
                Some(label) => left_out.labelled(line.number, label),
                None if line.is_comment() => left_out.line(line.number),
                None => rows.push(line),
            }
        }
        let last = rows.iter().rposition(|line| is_row(line, used));
        for line in rows.drain(last.map_or(0, |last| last + 1)..) {
            match line.first() {
                Some(Cell::Text(text)) => left_out.labelled(line.number, text),
                _ => left_out.line(line.number),
            }
        }
        for (place, heading) in head.headings.iter().enumerate() {
            let holds = |line: &&Line| *line.cell(place) != Cell::Empty;
            if ![used, beside].concat().contains(&place)
                && (!heading.shown.is_empty() || rows.iter().any(holds))
            {
                left_out.columns.push(place);
            }
        }
        Some(FoundTable {
            grid,
            head,
            rows,
            left_out,
        })
    }

    /// The rows as numbers, in the order of the lines, and what they are read from.
    pub fn numbers<const N: usize>(
        &self,
        file: &DataFile,
        places: &Places<N>,
        wanted: &Wanted<N>,
        choice: &Choice,
        problems: &mut Problems,
    ) -> Option<Vec<Row<N>>> {
        // All lines are read before the first bad one ends it.
        let mut numbers = Vec::new();
        for line in &self.rows {
            numbers.push(self.line(file, line, places, wanted, problems));
        }
        let numbers: Vec<Numbers<'_, N>> = numbers.into_iter().collect::<Option<_>>()?;
        let settled = (choice.decimal, self.grid.decimal);
        decimal::check(file, &numbers, wanted, settled, problems)?;
        let rows = numbers.iter().map(|numbers| Row {
            line: numbers.line,
            tooth: numbers.tooth,
            values: numbers.values.map(|written| written.value),
        });
        Some(rows.collect())
    }

    /// Checks that a row is as wide as the header, as a text's must be, and has no number that slipped out of its column.
    pub fn check_width(&self, file: &DataFile, line: &Line, problems: &mut Problems) -> Option<()> {
        let (columns, found) = (self.head.headings.len(), line.cells.len());
        if self.grid.sheet.is_none() && found != columns {
            problems.add(file.problem_at(
                line.number,
                format!("{found} values, the header names {columns} columns"),
                match self.grid.decimal {
                    Some(Decimal::Point) => {
                        "give every column one value; in a file separated by commas numbers need a point"
                    }
                    _ => "give every column one value, and nothing else",
                },
            ));
            return None;
        }
        let is_named = |place: usize| {
            let heading = self.head.headings.get(place);
            heading.is_some_and(|heading| !heading.shown.is_empty())
        };
        let mut good = Some(());
        for (place, cell) in line.cells.iter().enumerate().skip(1) {
            if cell.number().is_some() && !is_named(place) && is_named(place - 1) {
                problems.add(file.problem_at(
                    line.number,
                    format!(
                        "{} is in column {}, which has no name",
                        cell.shown(file),
                        letter(place)
                    ),
                    "remove it, or name its column",
                ));
                good = None;
            }
        }
        good
    }

    fn line<const N: usize>(
        &self,
        file: &DataFile,
        line: &'a Line,
        places: &Places<N>,
        wanted: &Wanted<N>,
        problems: &mut Problems,
    ) -> Option<Numbers<'a, N>> {
        self.check_width(file, line, problems)?;
        let teeth = 1..=wanted.teeth.unwrap_or(10_000);
        let tooth = line.cell(places.tooth).tooth();
        let tooth = tooth.filter(|tooth| teeth.contains(tooth));
        if tooth.is_none() {
            let cell = line.cell(places.tooth);
            let allowed = whole_in(&teeth);
            let problem = wrong_cell(file, line.number, "tooth", cell, &allowed);
            problems.add(match cell {
                Cell::Empty => Problem {
                    help: "correct the line; one of statistics is left out where its first cell says so, such as max".to_owned(),
                    ..problem
                },
                _ => problem,
            });
        }
        let mut values = [None; N];
        for (index, column) in wanted.columns.iter().enumerate() {
            let cell = line.cell(places.wanted[index]);
            let limits = column.limits();
            values[index] = cell
                .number()
                .filter(|written| limits.range.contains(&written.value));
            if values[index].is_none() {
                let name = column.name();
                problems.add(wrong_cell(file, line.number, name, cell, limits.allowed));
            }
        }
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

/// Whether a line may be a row of numbers in the columns `used`: a footer's words or its date are none.
fn is_row(line: &Line, used: &[usize]) -> bool {
    let mut cells = used.iter().map(|place| line.cell(*place));
    let first = cells.next();
    let is_empty = cells.clone().all(|cell| *cell == Cell::Empty);
    match first {
        Some(Cell::Empty) => !is_empty,
        Some(Cell::Text(text)) if is_empty => !(is_words(text) || is_date(text)),
        Some(Cell::Text(text)) if !text.contains(|c: char| c.is_ascii_digit()) => {
            cells.all(|cell| cell.number().is_some())
        }
        _ => true,
    }
}

/// Whether `text` begins with a word.
fn is_words(text: &str) -> bool {
    text.chars().take(2).all(char::is_alphabetic) && text.chars().count() > 1
}

/// Whether `text` is a date such as 12.03.2024 or 2024-03-12.
fn is_date(text: &str) -> bool {
    let parts: Vec<&str> = text.split(['.', '-', '/']).collect();
    let is_number = |part: &&str| part.bytes().all(|b| b.is_ascii_digit());
    let lengths: Vec<usize> = parts.iter().map(|part| part.len()).collect();
    parts.iter().all(is_number) && (lengths == [2, 2, 4] || lengths == [4, 2, 2])
}

/// The table of `wanted` columns in one of `grids`: the one that has a header of a tooth column and one of them.
pub fn find<'a, const N: usize>(
    grids: &'a [Grid],
    file: &DataFile,
    wanted: &Wanted<N>,
    choice: &Choice,
    problems: &mut Problems,
) -> Option<(FoundTable<'a>, Places<N>)> {
    // Where only pitch of the other kind is there, that is reported.
    let strict = |head: &Head| is_head(head, &wanted.columns, choice);
    let there = |grid: &Grid| Head::find(&grid.lines, choice, strict).is_some();
    let others = match grids.iter().any(there) {
        true => wanted.columns,
        false => wanted.columns.map(Column::of_other_kind),
    };
    let is_head = |head: &Head| strict(head) || is_head(head, &others, choice);
    let (grid, head) = one_of(grids, file, choice, is_head, &wanted.columns, problems)?;
    let places = places(&head, &grid.lines, file, wanted, choice, problems)?;
    let used: Vec<usize> = std::iter::once(places.tooth).chain(places.wanted).collect();
    let found = FoundTable::below(grid, head, [&used, &[]], file, problems)?;
    Some((found, places))
}

/// Whether `head` names a tooth column and one that is wanted.
pub fn is_head(head: &Head, wanted: &[Column], choice: &Choice) -> bool {
    let any = |column: &Column| !head.places_of(*column, choice).is_empty();
    !head.teeth(wanted, choice).is_empty() && wanted.iter().any(any)
}

/// Whether a line below `head` has numbers in its columns.
fn has_rows(grid: &Grid, head: &Head, wanted: &[Column], choice: &Choice) -> bool {
    let first = |places: Vec<usize>| places.first().copied();
    let tooth = first(head.teeth(wanted, choice));
    let values: Vec<usize> = wanted
        .iter()
        .filter_map(|column| first(head.places_of(*column, choice)))
        .collect();
    let is_row = |line: &Line| {
        tooth.is_none_or(|tooth| line.cell(tooth).tooth().is_some())
            && values
                .iter()
                .all(|place| line.cell(*place).number().is_some())
    };
    grid.lines[head.at + 1..].iter().any(is_row)
}

/// Whether `head` has several headings, of which one is of teeth or of a wanted column: what it lacks is better told than that there is none.
fn is_nearly_head(head: &Head, wanted: &[Column], choice: &Choice) -> bool {
    let any = |column: &Column| !head.places_of(*column, choice).is_empty();
    head.all().len() > 1 && (!head.teeth(wanted, choice).is_empty() || wanted.iter().any(any))
}

/// The one grid that has a header, and that.
pub fn one_of<'a>(
    grids: &'a [Grid],
    file: &DataFile,
    choice: &Choice,
    is_head: impl Fn(&Head) -> bool,
    wanted: &[Column],
    problems: &mut Problems,
) -> Option<(&'a Grid, Head)> {
    let in_grid = |grid: &'a Grid| Some((grid, Head::find(&grid.lines, choice, &is_head)?));
    let mut found: Vec<_> = grids.iter().filter_map(in_grid).collect();
    if found.is_empty()
        && let ([grid], Some(row)) = (grids, choice.header_row)
        && let Some(at) = grid.lines.iter().position(|line| line.number == row)
    {
        // What it lacks is reported.
        return Some((grid, Head::of(&grid.lines, at)));
    }
    if found.is_empty() && choice.header_row.is_none() {
        let in_grid = |grid: &'a Grid| {
            let nearly = |head: &Head| is_nearly_head(head, wanted, choice);
            Some((grid, Head::find(&grid.lines, choice, nearly)?))
        };
        let mut nearly = grids.iter().filter_map(in_grid);
        if let (Some(only), None) = (nearly.next(), nearly.next()) {
            return Some(only);
        }
    }
    if found.len() > 1 && grids[0].sheet.is_none() {
        // Of several separators that whose lines are rows.
        found.retain(|(grid, head)| has_rows(grid, head, wanted, choice));
        if found.is_empty() {
            found = grids.iter().filter_map(in_grid).collect();
        }
    }
    if found.len() == 1 {
        return found.pop();
    }
    let names = |grids: &mut dyn Iterator<Item = &'a Grid>| {
        let names = grids
            .filter_map(|grid| grid.sheet.as_ref())
            .take(MOST_NAMED);
        let names: Vec<String> = names.map(|name| file.quote(name)).collect();
        names.join(", ")
    };
    let columns = super::column::headings(wanted);
    problems.add(match (found.first(), &grids[0].sheet) {
        (Some((grid, _)), Some(_)) => file.problem(
            format!("has {} sheets with a table of {columns}: {}", found.len(), names(&mut found.iter().map(|found| found.0))),
            format!(
                "say which one: sheet = {}",
                file.quote(grid.sheet.as_deref().unwrap_or_default())
            ),
        ),
        (Some((_, head)), None) => file.problem_at(
            head.line,
            "can be the header with more than one separator, allowed is one of comma, semicolon and tab",
            "separate all columns alike",
        ),
        (None, sheet) => {
            let (what, row) = match choice.header_row {
                Some(row) => (format!("line {row} does not name"), row),
                None => ("no line names".to_owned(), 1),
            };
            let place = match (sheet, grids.len()) {
                (Some(_), 2..) => format!(" in sheets {}", names(&mut grids.iter())),
                _ => String::new(),
            };
            let keys = wanted.iter().zip('B'..).map(|(column, letter)| format!("{} = \"{letter}\"", column.key()));
            let keys: Vec<String> = keys.collect();
            let help = match wanted.contains(&Column::Deviation) {
                true => format!("name the columns {columns}"),
                false => format!(
                    "say where they are, by letter or heading: header_row = {row}, tooth_column = \"A\", {}",
                    keys.join(", ")
                ),
            };
            file.problem(format!("{what} the columns {columns}{place}"), help)
        }
    });
    None
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

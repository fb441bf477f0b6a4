//! CSV, as machines and spreadsheets write it: separated by commas, semicolons or tabs.

use super::cell::{Cell, Line};
use super::grid::Grid;
use super::limits::MOST_CELLS;
use super::number::Decimal;
use crate::data_file::{DataFile, line_of};
use crate::problems::Problems;

/// What may stand between columns, and the decimal sign that this settles.
///
/// A comma leaves only the point; a spreadsheet writes semicolons where the comma is its decimal sign.
const DELIMITERS: [(char, &str, Option<Decimal>); 3] = [
    (',', "commas", Some(Decimal::Point)),
    (';', "semicolons", Some(Decimal::Comma)),
    ('\t', "tabs", None),
];

/// The cells of `text`; the first line that is not blank is the header, or before it `sep=;` as it tells a spreadsheet
/// the separator.
pub fn read(file: &DataFile, text: &str, problems: &mut Problems) -> Option<Grid> {
    let broken = text.split_inclusive('\n').position(|line| {
        let line = line.strip_suffix('\n').unwrap_or(line);
        line.strip_suffix('\r').unwrap_or(line).contains('\r')
    });
    if let Some(index) = broken {
        problems.add(file.problem_at(
            index as u64 + 1,
            "a carriage return within the line",
            "save the file with line ends of Windows or Unix",
        ));
        return None;
    }
    let (delimiter, decimal) = delimiter(file, text, problems)?;
    // Before they are cells; one in quotes counts, too.
    let most = text
        .bytes()
        .filter(|b| *b == delimiter as u8 || *b == b'\n')
        .count();
    if most > MOST_CELLS {
        problems.add(file.problem(
            format!("has some {most} cells, allowed are up to {MOST_CELLS}: those of 10 000 teeth in 20 columns"),
            "name the table of one gear, and leave out other columns",
        ));
        return None;
    }
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(delimiter as u8)
        .from_reader(text.as_bytes());
    let mut lines = Vec::new();
    for record in reader.records() {
        let record = match record {
            Ok(record) => record,
            Err(error) => {
                problems.add(file.problem(error, "correct the line"));
                return None;
            }
        };
        let line = Line {
            number: record.position().map_or(0, |start| line_of(text, start)),
            cells: record.iter().map(cell).collect(),
        };
        if !line.is_blank() {
            lines.push(line);
        }
    }
    if separator(text).is_some() {
        lines.remove(0);
    }
    let grid = Grid::of(lines, decimal);
    if grid.is_none() {
        problems.add(file.problem("is empty", "give a header and a row for each tooth"));
    }
    grid
}

/// What separates the columns of the header.
fn delimiter(
    file: &DataFile,
    text: &str,
    problems: &mut Problems,
) -> Option<(char, Option<Decimal>)> {
    let Some((index, header)) = first_line(text) else {
        problems.add(file.problem("is empty", "give a header and a row for each tooth"));
        return None;
    };
    if let Some(said) = separator(text) {
        return Some(said);
    }
    let outside_quotes: String = header.split('"').step_by(2).collect();
    let found: Vec<_> = DELIMITERS
        .iter()
        .filter(|(delimiter, ..)| outside_quotes.contains(*delimiter))
        .collect();
    if let [(delimiter, _, decimal)] = found[..] {
        return Some((*delimiter, *decimal));
    }
    let names: Vec<&str> = found.iter().map(|(_, name, _)| *name).collect();
    let reason = match names.join(" and ") {
        none if none.is_empty() => "the header has no comma, semicolon or tab".to_owned(),
        several => format!("the header has {several}"),
    };
    problems.add(file.problem_at(
        index as u64 + 1,
        format!("{reason}, expected one of them between its columns"),
        "name the columns there, such as tooth;left (µm);right (µm)",
    ));
    None
}

fn first_line(text: &str) -> Option<(usize, &str)> {
    let mut lines = text.lines().enumerate();
    lines.find(|(_, line)| !line.trim().is_empty())
}

/// What a line `sep=;` before the header says; `None` without one.
fn separator(text: &str) -> Option<(char, Option<Decimal>)> {
    let said = first_line(text)?
        .1
        .trim_end_matches(['\r', ' '])
        .strip_prefix("sep=")?;
    let mut known = DELIMITERS.into_iter();
    let (delimiter, _, decimal) = known.find(|(delimiter, ..)| said.chars().eq([*delimiter]))?;
    Some((delimiter, decimal))
}

fn cell(text: &str) -> Cell {
    match text.trim_matches([' ', '\t', '\u{a0}']) {
        "" => Cell::Empty,
        text => Cell::Text(text.to_owned()),
    }
}

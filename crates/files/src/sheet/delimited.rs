//! CSV, as machines and spreadsheets write it: separated by commas, semicolons or tabs.

use super::cell::{Cell, Line};
use super::grid::Grid;
use super::limits::MOST_CELLS;
use super::number::Decimal;
use crate::data_file::{DataFile, line_of};
use crate::error::Problem;
use crate::problems::Problems;

/// What may stand between columns, and the decimal sign that this settles.
///
/// A comma leaves only the point; a spreadsheet writes semicolons where the comma is its decimal sign.
const DELIMITERS: [(char, Option<Decimal>); 3] = [
    (',', Some(Decimal::Point)),
    (';', Some(Decimal::Comma)),
    ('\t', None),
];

/// The cells of `text` by each separator that it has, or by the one that its first line `sep=;` names, as it tells a spreadsheet.
pub fn read(file: &DataFile, text: &str, problems: &mut Problems) -> Option<Vec<Grid>> {
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
    let Some((first, _)) = first_line(text) else {
        problems.add(file.problem("is empty", "give a header and a row for each tooth"));
        return None;
    };
    let said = separator(text);
    let there = DELIMITERS
        .into_iter()
        .filter(|(sign, _)| text.contains(*sign));
    let delimiters = match said {
        Some(said) => vec![said],
        None => there.collect(),
    };
    if delimiters.is_empty() {
        problems.add(file.problem_at(
            first as u64 + 1,
            "the file has no comma, semicolon or tab, expected one of them between its columns",
            "name the columns there, such as tooth;left (µm);right (µm)",
        ));
        return None;
    }
    // Before they are cells; one in quotes counts, too.
    let count = |sign: char| {
        text.bytes()
            .filter(|b| *b == sign as u8 || *b == b'\n')
            .count()
    };
    let mut grids = Vec::new();
    for (sign, decimal) in &delimiters {
        if count(*sign) <= MOST_CELLS {
            let lines = problems.keep(lines(file, text, *sign))?;
            grids.push(Grid {
                sheet: None,
                lines: lines
                    .into_iter()
                    .skip(usize::from(said.is_some()))
                    .collect(),
                decimal: *decimal,
            });
        }
    }
    grids.retain(|grid| !grid.lines.is_empty());
    if grids.is_empty() {
        let most = delimiters.iter().map(|(sign, _)| count(*sign)).min();
        problems.add(match most.filter(|most| *most > MOST_CELLS) {
            Some(most) => file.problem(
                format!("has some {most} cells, allowed are up to {MOST_CELLS}: those of 10 000 teeth in 20 columns"),
                "name the table of one gear, and leave out other columns",
            ),
            None => file.problem("is empty", "give a header and a row for each tooth"),
        });
        return None;
    }
    Some(grids)
}

/// The lines of `text` that are not blank, its cells separated by `sign`.
fn lines(file: &DataFile, text: &str, sign: char) -> Result<Vec<Line>, Problem> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(sign as u8)
        .from_reader(text.as_bytes());
    let mut lines = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| file.problem(error, "correct the line"))?;
        let line = Line {
            number: record.position().map_or(0, |start| line_of(text, start)),
            cells: record.iter().map(cell).collect(),
        };
        if !line.is_blank() {
            lines.push(line);
        }
    }
    Ok(lines)
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
    known.find(|(delimiter, _)| said.chars().eq([*delimiter]))
}

fn cell(text: &str) -> Cell {
    match text.trim_matches([' ', '\t', '\u{a0}']) {
        "" => Cell::Empty,
        text => Cell::Text(text.to_owned()),
    }
}

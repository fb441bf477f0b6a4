//! Text files: from bytes to text, and from CSV to cells, as machines and spreadsheets write it.

use super::grid::{Cell, Grid, Line};
use crate::data_file::{DataFile, line_of};
use gearlash_text::Problem;
use gearlash_text::encoding::{utf_16, windows_1252};
use gearlash_text::file_numbers::{self, Decimal};
use std::borrow::Cow;

/// Separators of columns, and the decimal sign that each implies.
///
/// A comma leaves only the point. A spreadsheet writes semicolons where the comma is its decimal sign.
const SEPARATORS: [(char, Option<Decimal>); 3] = [
    (',', Some(Decimal::Point)),
    (';', Some(Decimal::Comma)),
    ('\t', None),
];

/// Decodes UTF-8, UTF-16 with its byte order mark, or Windows-1252, as German Excel writes CSV.
///
/// Windows-1252 has a character for nearly every byte. Text in another encoding gets other characters; none is part of a number
/// or of a known name.
pub fn decode<'a>(file: &DataFile, bytes: &'a [u8]) -> Option<Cow<'a, str>> {
    let (name, text) = match bytes {
        [0xef, 0xbb, 0xbf, text @ ..] => {
            let lossy = |_| String::from_utf8_lossy(text).into_owned();
            (
                "UTF-8",
                std::str::from_utf8(text).map(Cow::Borrowed).map_err(lossy),
            )
        }
        [0xff, 0xfe, text @ ..] => ("UTF-16LE", utf_16(text, u16::from_le_bytes).map(Cow::Owned)),
        [0xfe, 0xff, text @ ..] => ("UTF-16BE", utf_16(text, u16::from_be_bytes).map(Cow::Owned)),
        _ => {
            return Some(match std::str::from_utf8(bytes) {
                Ok(text) => Cow::Borrowed(text),
                Err(_) => Cow::Owned(windows_1252(bytes)),
            });
        }
    };
    let text = text.map_err(|readable| {
        let before = readable.split(char::REPLACEMENT_CHARACTER).next();
        let line = 1 + before.unwrap_or_default().matches('\n').count() as u64;
        let reason = format!("not the {name} text that the byte order mark announces");
        file.add_at(line, reason, "save it as UTF-8");
    });
    text.ok()
}

/// The cells of `text` by each separator that it has, or by the one in its first line `sep=;`. At most `most` cells are allowed.
pub fn read(file: &DataFile, text: &str, most: usize) -> Option<Vec<Grid>> {
    file.reading().keep(grids(file, text, most))
}

fn grids(file: &DataFile, text: &str, most: usize) -> Result<Vec<Grid>, Problem> {
    let broken = text.split_inclusive('\n').position(|line| {
        let line = line.strip_suffix('\n').unwrap_or(line);
        line.strip_suffix('\r').unwrap_or(line).contains('\r')
    });
    if let Some(index) = broken {
        let reason = "a carriage return within the line";
        let help = "save the file with line ends of Windows or Unix";
        return Err(file.problem_at(index as u64 + 1, reason, help));
    }
    let empty = || file.problem("is empty", "give a header and a row for each tooth");
    let mut lines_of_text = (1..).zip(text.lines());
    let first = lines_of_text.find(|(_, line)| !line.trim().is_empty());
    let (first, line) = first.ok_or_else(empty)?;
    if is_of_fixed_widths(text) {
        let reason = "columns at fixed widths are not read";
        return Err(file.problem_at(first, reason, "save as CSV"));
    }
    let stated = stated_separator(line);
    let mut separators = SEPARATORS.to_vec();
    separators.retain(|(separator, _)| match stated {
        Some(stated) => *separator == stated,
        None => text.contains(*separator),
    });
    if separators.is_empty() {
        return Err(file.problem_at(
            first,
            "the file has no comma, semicolon or tab, expected one of them between its columns",
            "name the columns there, such as tooth;left (µm);right (µm)",
        ));
    }
    // Counts the cells before they are made. A separator in quotes counts, too.
    let count = |separator: char| {
        let ends_cell = [separator as u8, b'\n'];
        text.bytes().filter(|b| ends_cell.contains(b)).count()
    };
    let least = separators.iter().map(|(one, _)| count(*one)).min();
    separators.retain(|(separator, _)| count(*separator) <= most);
    let mut grids = Vec::new();
    for (separator, decimal) in separators {
        let mut lines = lines(file, text, separator)?;
        lines.drain(..lines.len().min(usize::from(stated.is_some())));
        let sheet = None;
        grids.push(Grid {
            sheet,
            lines,
            decimal,
        });
    }
    grids.retain(|grid| !grid.lines.is_empty());
    match least {
        _ if !grids.is_empty() => Ok(grids),
        Some(least) if least > most => Err(file.problem(
            format!("has some {least} cells, allowed are up to {most}"),
            "name the table of one gear, and leave out other columns",
        )),
        _ => Err(empty()),
    }
}

/// The lines of `text` that are not blank, its cells separated by `separator`.
fn lines(file: &DataFile, text: &str, separator: char) -> Result<Vec<Line>, Problem> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(separator as u8)
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

/// Whether most lines of `text` are numbers with only blanks between them.
fn is_of_fixed_widths(text: &str) -> bool {
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    let are_numbers = |line: &&str| {
        let mut words = line.split_whitespace();
        line.trim().contains(' ') && words.all(|word| file_numbers::number(word).is_some())
    };
    !text.contains([';', '\t']) && 2 * lines.clone().filter(are_numbers).count() > lines.count()
}

/// The separator that a line `sep=;` states.
fn stated_separator(line: &str) -> Option<char> {
    let stated = line.trim_end_matches(['\r', ' ']).strip_prefix("sep=")?;
    let mut known = SEPARATORS.into_iter().map(|(separator, _)| separator);
    known.find(|separator| stated.chars().eq([*separator]))
}

fn cell(text: &str) -> Cell {
    match text.trim_matches([' ', '\t', '\u{a0}']) {
        "" => Cell::Empty,
        text => Cell::Text(text.to_owned()),
    }
}

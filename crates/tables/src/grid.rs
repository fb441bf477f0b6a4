//! Cells of a sheet or a text, before any has a meaning; and limits of the size of a table.
//!
//! A file is rejected before it takes more than some 300 MB or some seconds. A table of the largest gear has 10 000 rows of a few
//! columns. A file has at most 64 MiB, but packed it can hold a thousand times as much, and 64 million commas are 64 million
//! cells of 32 bytes each.

use super::heading;
use crate::data_file::DataFile;
use gearlash_text::file_numbers::{self, Decimal, FileNumber};

/// Most cells of a table: those of 10 000 teeth in 20 columns.
pub const MAX_CELLS: usize = 200_000;
/// Most rows of a protocol: those of both flanks of 10 000 teeth.
pub const MAX_ROWS: usize = 20_000;
/// Sheets that a message lists by name.
pub const MAX_NAMED: usize = 10;

#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing, or only white space.
    Empty,
    /// Text without white space around it. In a text file numbers are text too; in a workbook they can be.
    Text(String),
    Number(f64),
    /// Other content of a workbook, described without its value.
    Other(String),
}

#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Its number in the file, from 1.
    pub number: u64,
    /// From the first column on.
    pub cells: Vec<Cell>,
}

/// The lines of a sheet, or of a text by one separator.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Name of the sheet; none of a text.
    pub sheet: Option<String>,
    /// At least one; blank lines are left out.
    pub lines: Vec<Line>,
    /// The decimal sign, where the format determines it.
    pub decimal: Option<Decimal>,
}

impl Cell {
    pub fn shown(&self, file: &DataFile) -> String {
        match self {
            Cell::Empty => "empty".to_owned(),
            Cell::Text(text) => file.quote(text),
            Cell::Number(number) => file.bare(&number.to_string()),
            Cell::Other(words) => words.clone(),
        }
    }

    /// Its text; empty where it is no text.
    pub fn text(&self) -> &str {
        match self {
            Cell::Text(text) => text,
            _ => "",
        }
    }

    /// Whether it contains several lines and separators: a quotation mark is missing or extra.
    pub fn has_unbalanced_quote(&self) -> bool {
        self.text().contains('\n') && self.text().contains([',', ';', '\t'])
    }

    /// The unit after its number.
    pub fn unit(&self) -> Option<&'static str> {
        number_and_unit(self.text()).1
    }

    pub fn tooth(&self) -> Option<u32> {
        match self {
            Cell::Text(text) => file_numbers::tooth(heading::tooth_number(text)),
            // The cast saturates.
            Cell::Number(number) => (number.fract() == 0.0).then_some(*number as u32),
            Cell::Empty | Cell::Other(_) => None,
        }
    }

    pub fn number(&self) -> Option<FileNumber<'_>> {
        match self {
            Cell::Text(text) => {
                let (number, _) = number_and_unit(text);
                file_numbers::number(number).filter(|_| !file_numbers::has_leading_zero(number))
            }
            Cell::Number(number) => number.is_finite().then_some(FileNumber {
                value: *number,
                ..FileNumber::default()
            }),
            Cell::Empty | Cell::Other(_) => None,
        }
    }
}

impl Line {
    /// The cell in column `place`, empty beyond the last.
    pub fn cell(&self, place: usize) -> &Cell {
        self.cells.get(place).unwrap_or(&Cell::Empty)
    }

    /// The first cell that is not empty.
    pub fn first(&self) -> &Cell {
        let mut cells = self.cells.iter();
        cells
            .find(|cell| **cell != Cell::Empty)
            .unwrap_or(&Cell::Empty)
    }

    pub fn is_comment(&self) -> bool {
        self.first().text().starts_with('#')
    }

    pub fn is_blank(&self) -> bool {
        *self.first() == Cell::Empty
    }

    /// Whether a cell is a number: no header has one.
    pub fn has_number(&self) -> bool {
        self.cells.iter().any(|cell| cell.number().is_some())
    }
}

/// Splits the unit off a number: `2,4 µm` has one.
fn number_and_unit(text: &str) -> (&str, Option<&'static str>) {
    let number = text.trim_end_matches(char::is_alphabetic);
    if number.len() == text.len() {
        return (text, None);
    }
    match heading::unit(&text[number.len()..]) {
        Some(unit) => (number.trim_end(), Some(unit)),
        None => (text, None),
    }
}

/// The letter that a spreadsheet gives the column at `place`.
pub fn letter(place: usize) -> String {
    let last = char::from(b'A' + (place % 26) as u8);
    match place / 26 {
        0 => last.to_string(),
        before => letter(before - 1) + &last.to_string(),
    }
}

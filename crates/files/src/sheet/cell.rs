//! One cell of a table, and what it may be read as.

use super::number::{self, Written};
use crate::data_file::DataFile;

/// One cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing, or only white space.
    Empty,
    /// Text without white space around it; in a text file numbers are text too.
    Text(String),
    /// A number of a workbook.
    Number(f64),
    /// Text of a workbook where a number must be.
    TextBelow(String),
    /// Anything else of a workbook, in words that say nothing of what it holds.
    Other(String),
}

impl Cell {
    /// As it stands in `file`, for a message.
    pub fn shown(&self, file: &DataFile) -> String {
        match self {
            Cell::Empty => "empty".to_owned(),
            Cell::Text(text) => file.quote(text),
            Cell::Number(number) => file.bare(&number.to_string()),
            Cell::TextBelow(text) => {
                format!(
                    "the text {} (convert it to a number there)",
                    file.quote(text)
                )
            }
            Cell::Other(words) => words.clone(),
        }
    }

    /// As a tooth number.
    pub fn tooth(&self) -> Option<u32> {
        match self {
            Cell::Text(text) => number::tooth(text),
            // The cast saturates.
            Cell::Number(number) => (number.fract() == 0.0).then_some(*number as u32),
            Cell::Empty | Cell::TextBelow(_) | Cell::Other(_) => None,
        }
    }

    /// As a number.
    pub fn number(&self) -> Option<Written<'_>> {
        match self {
            Cell::Text(text) => number::written(text).filter(|_| !number::zero_first(text)),
            Cell::Number(number) => number.is_finite().then_some(Written {
                value: *number,
                ..Written::default()
            }),
            Cell::Empty | Cell::TextBelow(_) | Cell::Other(_) => None,
        }
    }
}

/// One line of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Its number in the file, from 1.
    pub number: u64,
    /// From the first column on.
    pub cells: Vec<Cell>,
}

impl Line {
    /// Whether every cell is empty.
    pub fn is_blank(&self) -> bool {
        self.cells.iter().all(|cell| *cell == Cell::Empty)
    }
}

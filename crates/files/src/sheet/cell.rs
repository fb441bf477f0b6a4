//! One cell of a table, and what it may be read as.

use super::number::{self, Written};
use crate::data_file::DataFile;

/// One cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing, or only white space.
    Empty,
    /// Text without white space around it; in a text file numbers are text too, and in a workbook they may be.
    Text(String),
    /// A number of a workbook.
    Number(f64),
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
            Cell::Other(words) => words.clone(),
        }
    }

    /// Whether it has several lines and separators in them: lines of a text that a quotation mark put into one.
    pub fn is_torn(&self) -> bool {
        matches!(self, Cell::Text(text) if text.contains('\n') && text.contains([',', ';', '\t']))
    }

    /// As a tooth number.
    pub fn tooth(&self) -> Option<u32> {
        match self {
            Cell::Text(text) => number::tooth(text),
            // The cast saturates.
            Cell::Number(number) => (number.fract() == 0.0).then_some(*number as u32),
            Cell::Empty | Cell::Other(_) => None,
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
            Cell::Empty | Cell::Other(_) => None,
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
    /// The cell in column `place`, empty beyond the last.
    pub fn cell(&self, place: usize) -> &Cell {
        self.cells.get(place).unwrap_or(&Cell::Empty)
    }

    /// The first cell that is not empty.
    pub fn first(&self) -> Option<&Cell> {
        self.cells.iter().find(|cell| **cell != Cell::Empty)
    }

    /// Whether it is a comment.
    pub fn is_comment(&self) -> bool {
        matches!(self.first(), Some(Cell::Text(text)) if text.starts_with('#'))
    }

    /// Whether every cell is empty.
    pub fn is_blank(&self) -> bool {
        self.cells.iter().all(|cell| *cell == Cell::Empty)
    }
}

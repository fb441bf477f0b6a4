//! One cell of a table, and what it may be read as.

use super::number::{self, Written};
use crate::input::node::Node;

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

impl Cell {
    /// As it stands there, for a message; long ones cut.
    pub fn shown(&self) -> String {
        match self {
            Cell::Empty => "empty".to_owned(),
            Cell::Text(text) => Node::Text(text.clone()).shown(),
            Cell::Number(number) => number.to_string(),
            Cell::Other(words) => words.clone(),
        }
    }

    /// As a column's name.
    pub fn name(&self) -> String {
        match self {
            Cell::Text(text) => text.clone(),
            other => other.shown(),
        }
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

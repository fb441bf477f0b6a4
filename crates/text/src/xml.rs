//! XML trees within limits. No entity and no other file is read.

use roxmltree::{Document, Error, ParsingOptions};

/// Most elements and texts of a file.
const MAX_NODES: u32 = 4_000_000;
/// Most attributes of an element: the parser compares each with all others of it. Drawing programs write some fifty.
const MAX_ATTRIBUTES: usize = 10_000;

/// A text that is not XML, or beyond the limits.
pub struct XmlError {
    /// From 1.
    pub line: u32,
    /// From 1.
    pub column: u32,
    /// The fault.
    pub reason: String,
    /// Whether the text has a document type, which is not read.
    pub has_dtd: bool,
}

/// Parses `text`.
pub fn parse(text: &str) -> Result<Document<'_>, XmlError> {
    if let Some((line, column)) = crowded(text) {
        return Err(XmlError {
            line,
            column,
            reason: format!("an element with more than {MAX_ATTRIBUTES} attributes"),
            has_dtd: false,
        });
    }
    let settings = ParsingOptions {
        nodes_limit: MAX_NODES,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, settings).map_err(|error| XmlError {
        line: error.pos().row,
        column: error.pos().col,
        has_dtd: matches!(error, Error::DtdDetected),
        reason: error.to_string(),
    })
}

/// Line and column of an element with too many attributes. No value contains a `<`, so each begins a tag.
fn crowded(text: &str) -> Option<(u32, u32)> {
    let mut from = 0;
    for tag in text.split_inclusive('<') {
        let attributes = tag.matches("=\"").count() + tag.matches("='").count();
        if attributes > MAX_ATTRIBUTES {
            let before = &text[..from];
            let line = before.matches('\n').count() as u32 + 1;
            let column = before.chars().rev().take_while(|&c| c != '\n').count() as u32;
            return Some((line, column.max(1)));
        }
        from += tag.len();
    }
    None
}

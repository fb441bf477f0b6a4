//! The pairs of a DXF file: a group code and a value, one per line.

use crate::drawing::DrawingError;

/// First bytes of a binary DXF.
const BINARY: &[u8] = b"AutoCAD Binary DXF";
/// First bytes of a DWG.
const DWG: &[u8] = b"AC10";
/// The remedy for a file that is not whole.
pub const EXPORT: &str = "export it again as DXF";

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair<'a> {
    /// The code: what the value means.
    pub code: u16,
    /// The value without the white space around it.
    pub value: &'a str,
    pub line: usize,
}

impl Pair<'_> {
    /// "line 12", the place of its value.
    pub fn place(&self) -> String {
        format!("line {}", self.line + 1)
    }
}

/// The pairs of a text, comments left out.
pub struct Pairs<'a> {
    lines: std::str::Split<'a, char>,
    line: usize,
}

/// Rejects files that are not ASCII DXF.
pub fn check_format(bytes: &[u8]) -> Result<(), DrawingError> {
    let kind = match bytes {
        _ if bytes.starts_with(BINARY) => "a binary DXF",
        _ if bytes.starts_with(DWG) => "a DWG",
        _ => return Ok(()),
    };
    Err(DrawingError::refused(
        "byte 1",
        kind,
        "save it as DXF in ASCII",
    ))
}

impl<'a> Pairs<'a> {
    /// The pairs of `text`.
    pub fn of(text: &'a str) -> Pairs<'a> {
        Pairs {
            lines: text.split('\n'),
            line: 0,
        }
    }

    /// The next, which must be there: a DXF ends with a pair of its own.
    pub fn next(&mut self) -> Result<Pair<'a>, DrawingError> {
        loop {
            let line = self.line + 1;
            let (Some(code), Some(value)) = (self.lines.next(), self.lines.next()) else {
                return Err(DrawingError::at(
                    format!("line {line}"),
                    "the file ends without EOF: it is truncated",
                    EXPORT,
                ));
            };
            self.line += 2;
            let value = value.trim();
            let known = code.trim().parse::<u16>().ok().filter(|code| *code <= 1071);
            let Some(code) = known else {
                let reason = "not a group code, expected a whole number from 0 to 1071";
                return Err(DrawingError::at(format!("line {line}"), reason, EXPORT));
            };
            // 999 is a comment.
            if code != 999 {
                return Ok(Pair { code, value, line });
            }
        }
    }
}

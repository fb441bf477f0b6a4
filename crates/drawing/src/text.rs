//! Decodes the bytes of a drawing, and finds the line of a byte.

use super::DrawingError;
use gearlash_text::encoding::windows_1252;
use gearlash_text::without_mark;
use std::borrow::Cow;

/// UTF-8, or Windows-1252, which old programs write. A byte order mark is left out.
pub fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, DrawingError> {
    let bytes = without_mark(bytes);
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(DrawingError::at("line 1", "UTF-16", "save it as UTF-8"));
    }
    Ok(match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(windows_1252(bytes)),
    })
}

pub struct Lines(Vec<usize>);

impl Lines {
    pub fn of(text: &str) -> Lines {
        Lines(text.match_indices('\n').map(|(at, _)| at).collect())
    }

    /// "line 12", the line of byte `at`.
    pub fn place(&self, at: usize) -> String {
        format!("line {}", self.0.partition_point(|&end| end < at) + 1)
    }
}

//! From the bytes of a text file to text.

use crate::data_file::DataFile;
use crate::problems::Problems;
use encoding_rs::{Encoding, WINDOWS_1252};
use std::borrow::Cow;

/// UTF-8, UTF-16 with its byte order mark, or Windows-1252, as German Excel writes CSV.
///
/// Windows-1252 has a character for nearly every byte: what is none of the three becomes other characters, none of
/// which is part of a number or of a known name.
pub fn decode<'a>(
    file: &DataFile,
    bytes: &'a [u8],
    problems: &mut Problems,
) -> Option<Cow<'a, str>> {
    if let Some((encoding, mark)) = Encoding::for_bom(bytes) {
        let text = encoding.decode_without_bom_handling_and_without_replacement(&bytes[mark..]);
        if text.is_none() {
            let readable = encoding.decode_without_bom_handling(&bytes[mark..]).0;
            let before = readable.split(char::REPLACEMENT_CHARACTER).next();
            let line = 1 + before.unwrap_or_default().matches('\n').count() as u64;
            problems.add(file.problem_at(
                line,
                format!(
                    "not the {} text that the byte order mark announces",
                    encoding.name()
                ),
                "save it as UTF-8",
            ));
        }
        return text;
    }
    Some(match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => WINDOWS_1252.decode_without_bom_handling(bytes).0,
    })
}

//! The zip archive that an `.xlsx` workbook is, checked before its cells are read.
//!
//! A damaged archive is found by its own checksums, at the end of each part. A reference beyond a spreadsheet's last cell,
//! XFD1048576, has too many letters or digits for the reader behind, whose integers would come round to another cell; and that
//! reader takes the room for as many texts as the archive says it has.

use super::limits::{MOST_PART, MOST_TAG, MOST_UNPACKED};
use crate::data_file::DataFile;
use quick_xml::Reader;
use quick_xml::events::Event;
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Letters and digits of the last cell, XFD1048576.
const MOST_LETTERS: usize = 3;
const MOST_DIGITS: usize = 7;
/// Bytes of the shortest text in the list of texts, `<si/>`.
const SHORTEST_TEXT: u64 = 5;

/// Checks every part of the archive that `file` is.
///
/// # Errors
/// What is wrong, in words.
pub fn check(file: &DataFile, bytes: &[u8]) -> Result<(), String> {
    let shown = |error: &dyn std::error::Error| file.bare(&error.to_string());
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| shown(&error))?;
    let mut left = MOST_UNPACKED;
    for index in 0..archive.len() {
        let part = archive.by_index(index).map_err(|error| shown(&error))?;
        let name = part.name().map_err(|error| shown(&error))?.into_owned();
        let in_part = |reason: String| format!("{}: {reason}", file.bare(&name));
        let mut content = Vec::new();
        let read = part
            .take(left.min(MOST_PART) + 1)
            .read_to_end(&mut content)
            .map_err(|error| in_part(shown(&error)))? as u64;
        if read > MOST_PART {
            return Err(in_part(format!(
                "more than {} MiB unpacked, the most a part may have",
                MOST_PART >> 20
            )));
        }
        left = left.checked_sub(read).ok_or_else(|| {
            format!(
                "its parts have more than {} MiB unpacked, the most they may have",
                MOST_UNPACKED >> 20
            )
        })?;
        let is_sheet = name.starts_with("xl/worksheets/") && name.ends_with(".xml");
        xml(file, &content, is_sheet).map_err(in_part)?;
    }
    Ok(())
}

/// Checks the places of rows and cells (`r`), the ranges (`ref`) and the number of texts (`uniqueCount`).
///
/// A reference between the parts may make any of them a sheet. What is no XML ends this check where it ends the reader behind, too;
/// of a sheet it is an error here.
fn xml(file: &DataFile, content: &[u8], is_sheet: bool) -> Result<(), String> {
    let mut reader = Reader::from_reader(content);
    // As the reader behind has it, so that nothing is passed over here that is read there.
    reader.config_mut().check_end_names = is_sheet;
    let mut buffer = Vec::new();
    loop {
        let tag = match reader.read_event_into(&mut buffer) {
            Ok(Event::Eof) => return Ok(()),
            Ok(Event::Start(tag) | Event::Empty(tag)) => tag,
            Ok(_) => {
                buffer.clear();
                continue;
            }
            Err(error) if is_sheet => return Err(file.bare(&error.to_string())),
            Err(_) => return Ok(()),
        };
        if tag.len() > MOST_TAG {
            return Err(format!(
                "a tag of {} bytes, the most is {MOST_TAG}",
                tag.len()
            ));
        }
        // Whether a name stands twice is not asked: the time would grow with the square of their number.
        for attribute in tag.attributes().with_checks(false) {
            let attribute = match attribute {
                Ok(attribute) => attribute,
                Err(error) if is_sheet => return Err(file.bare(&error.to_string())),
                Err(_) => break,
            };
            match attribute.key.into_inner() {
                "r" | "ref" => place(file, &attribute.value)?,
                "uniqueCount" => {
                    let most = content.len() as u64 / SHORTEST_TEXT;
                    let said: Option<u64> = attribute.value.trim().parse().ok();
                    if said.is_none_or(|said| said > most) {
                        return Err(format!(
                            "says that it has {} texts in {} bytes",
                            file.bare(&attribute.value),
                            content.len()
                        ));
                    }
                }
                _ => {}
            }
        }
        buffer.clear();
    }
}

/// Checks a row `7`, a cell `B7` or a range `B7:C9`.
fn place(file: &DataFile, text: &str) -> Result<(), String> {
    let within = |part: &str| {
        let letters = part.bytes().filter(u8::is_ascii_alphabetic).count();
        let digits = part.bytes().filter(u8::is_ascii_digit).count();
        letters <= MOST_LETTERS && digits <= MOST_DIGITS
    };
    match text.split(':').all(within) {
        true => Ok(()),
        false => Err(format!("no spreadsheet has a cell {}", file.quote(text))),
    }
}

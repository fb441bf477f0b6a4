//! The zip archive that an `.xlsx` workbook is, checked before its cells are read.
//!
//! A damaged archive is found by its own checksums, at the end of each part. A reference beyond a spreadsheet's last cell,
//! XFD1048576, has too many letters or digits for the reader behind, whose integers would come round to another cell.

use quick_xml::Reader;
use quick_xml::events::Event;
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Bytes of all parts unpacked: some hundred for each of a million cells, and what bounds the memory of a zip bomb.
const MOST_BYTES: u64 = 1 << 28;
/// Letters and digits of the last cell, XFD1048576.
const MOST_LETTERS: usize = 3;
const MOST_DIGITS: usize = 7;

/// Checks every part of the archive, and the references in its sheets.
///
/// # Errors
/// What is wrong, in words.
pub fn check(bytes: &[u8]) -> Result<(), String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let mut left = MOST_BYTES;
    for index in 0..archive.len() {
        let part = archive.by_index(index).map_err(|error| error.to_string())?;
        let name = part.name().map_err(|error| error.to_string())?.into_owned();
        let mut content = Vec::new();
        let read = part.take(left + 1).read_to_end(&mut content);
        let read = read.map_err(|error| format!("{name}: {error}"))? as u64;
        left = left
            .checked_sub(read)
            .ok_or("its parts are larger than any table")?;
        if name.starts_with("xl/worksheets/") && name.ends_with(".xml") {
            references(&content).map_err(|reason| format!("{name}: {reason}"))?;
        }
    }
    Ok(())
}

/// Checks the places of rows and cells (`r`) and the ranges (`ref`) of a sheet.
fn references(sheet: &[u8]) -> Result<(), String> {
    let mut reader = Reader::from_reader(sheet);
    let mut buffer = Vec::new();
    loop {
        let event = reader.read_event_into(&mut buffer);
        match event.map_err(|error| error.to_string())? {
            Event::Eof => return Ok(()),
            Event::Start(tag) | Event::Empty(tag) => {
                for attribute in tag.attributes() {
                    let attribute = attribute.map_err(|error| error.to_string())?;
                    if [&b"r"[..], b"ref"].contains(&attribute.key.as_ref()) {
                        place(&String::from_utf8_lossy(&attribute.value))?;
                    }
                }
            }
            _ => {}
        }
        buffer.clear();
    }
}

/// Checks a row `7`, a cell `B7` or a range `B7:C9`.
fn place(text: &str) -> Result<(), String> {
    let within = |part: &str| {
        let letters = part.bytes().filter(u8::is_ascii_alphabetic).count();
        let digits = part.bytes().filter(u8::is_ascii_digit).count();
        letters <= MOST_LETTERS && digits <= MOST_DIGITS
    };
    match text.split(':').all(within) {
        true => Ok(()),
        false => Err(format!("no spreadsheet has a cell {text:?}")),
    }
}

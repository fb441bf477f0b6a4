//! `.xlsx` workbooks: the sheets with content, or the one that is named.
//!
//! The whole zip archive is unpacked before its cells are read: checksums at the end of each part reveal damage.
//!
//! Text that is a number is read as in a text file. A date can be a mistyped number (`1.2` in a German Excel): it is a problem
//! with help.

use super::grid::{Cell, Grid, Line, MAX_CELLS, MAX_NAMED};
use super::xlsx::{Content, Parts, Workbook};
use crate::data_file::DataFile;
use gearlash_text::Node;
use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Most columns of a table: far more than the few it has.
const MAX_COLUMNS: usize = 100;
/// Most bytes of text in all cells: the limit of a text file.
const MAX_TEXT: usize = 16 << 20;
/// Most characters of one cell: the limit of spreadsheets.
const MAX_CHARACTERS: usize = 32_767;
/// Most unpacked bytes of one part with cells: some hundred for each cell, and a few other sheets.
const MAX_PART: u64 = 32 << 20;
/// Most unpacked bytes of all parts, pictures included; they are only skipped.
const MAX_UNPACKED: u64 = 64 << 20;
/// By row and column, from 0.
type Cells = BTreeMap<u32, BTreeMap<u32, Cell>>;

/// Whether the file is a workbook: by its name, or because it begins as a zip archive does.
pub fn is_workbook(file: &DataFile, bytes: &[u8]) -> bool {
    let extension = file.path().extension().unwrap_or_default();
    extension.eq_ignore_ascii_case("xlsx") || bytes.starts_with(b"PK\x03\x04")
}

/// The cells of the sheet called `name`, or of all sheets with content.
pub fn read(file: &DataFile, bytes: Vec<u8>, name: Option<&str>) -> Option<Vec<Grid>> {
    let unreadable = |error: String| {
        file.problem(
            format!("cannot be read as an .xlsx workbook: {error}"),
            "open it in a spreadsheet and save it again as .xlsx or CSV",
        )
    };
    let workbook = unpacked(file, &bytes).and_then(|parts| {
        let workbook = Workbook::new(parts);
        workbook.map_err(|error| file.bare(&error))
    });
    let workbook = file.reading().keep(workbook.map_err(unreadable))?;
    let names: Vec<String> = workbook.sheets().map(str::to_owned).collect();
    if let Some(name) = name.filter(|name| !names.iter().any(|known| known == name)) {
        let shown = Node::Text(name.to_owned()).shown();
        let quoted = names.iter().take(MAX_NAMED).map(|name| file.quote(name));
        let listed = quoted.collect::<Vec<_>>().join(", ");
        let more = if names.len() > MAX_NAMED { ", …" } else { "" };
        let reason = format!("has no sheet {shown}, its sheets are {listed}{more}");
        return file.refuse(reason, "correct the name");
    }
    let mut filled = Vec::new();
    let mut reader = CellReader {
        file,
        cells: 0,
        text: 0,
    };
    for sheet in names {
        if name.is_none_or(|name| name == sheet) {
            let cells = reader.cells(&workbook, &sheet).map_err(unreadable);
            filled.extend(grid(sheet, file.reading().keep(cells)?));
        }
    }
    if filled.is_empty() {
        return file.refuse("is empty", "give a header and a row for each tooth");
    }
    Some(filled)
}

/// Reads sheet after sheet, all of them within the limits of one table.
struct CellReader<'a> {
    file: &'a DataFile,
    cells: usize,
    text: usize,
}

impl CellReader<'_> {
    /// The cells of a sheet that have content.
    fn cells(&mut self, workbook: &Workbook, sheet: &str) -> Result<Cells, String> {
        let file = self.file;
        let found = workbook.cells(sheet).map_err(|error| file.bare(&error))?;
        let mut cells = Cells::new();
        for (row, column, content) in found {
            let place = || {
                let sheet = file.quote(sheet);
                format!("row {} column {} of sheet {sheet}", row + 1, column + 1)
            };
            let content = match content {
                Content::Number(number) => Cell::Number(number),
                Content::Text(text) => {
                    let cell = self.text_cell(&text);
                    cell.map_err(|reason| format!("{}: {reason}", place()))?
                }
                Content::Flag(flag) => {
                    Cell::Other(format!("the boolean {}", file.bare(&flag.to_string())))
                }
                Content::Error(error) => Cell::Other(format!("the error {}", file.bare(&error))),
                Content::Date => Cell::Other(
                    "a date or time (format the cells as numbers before entering them)".to_owned(),
                ),
            };
            if content == Cell::Empty {
                continue;
            }
            self.cells += 1;
            if column as usize >= MAX_COLUMNS || self.cells > MAX_CELLS {
                return Err(format!(
                    "{} is outside the table limits: up to {MAX_COLUMNS} columns and {MAX_CELLS} cells are read",
                    place()
                ));
            }
            let before = cells.entry(row).or_default().insert(column, content);
            if before.is_some() {
                return Err(format!("{} has two values", place()));
            }
        }
        Ok(cells)
    }

    /// A cell of text. The bytes of a shared text count in each cell.
    fn text_cell(&mut self, text: &str) -> Result<Cell, String> {
        let text = text.trim();
        if text.is_empty() {
            return Ok(Cell::Empty);
        }
        if text.chars().nth(MAX_CHARACTERS).is_some() {
            return Err(format!(
                "has more than {MAX_CHARACTERS} characters, the most a cell may have"
            ));
        }
        self.text += text.len();
        if self.text > MAX_TEXT {
            return Err(format!(
                "the text of the cells up to here has more than {} MiB, the most a table may have",
                MAX_TEXT >> 20
            ));
        }
        Ok(Cell::Text(text.to_owned()))
    }
}

/// The grid of a sheet; `None` without cells.
fn grid(sheet: String, cells: Cells) -> Option<Grid> {
    let lines = cells.into_iter().map(|(row, mut cells)| {
        let width = cells.last_key_value().map_or(0, |(last, _)| last + 1);
        let take = |column| cells.remove(&column).unwrap_or(Cell::Empty);
        let cells = (0..width).map(take).collect();
        Line {
            number: u64::from(row) + 1,
            cells,
        }
    });
    let lines: Vec<Line> = lines.collect();
    let grid = |lines| Grid {
        sheet: Some(sheet),
        lines,
        decimal: None,
    };
    (!lines.is_empty()).then(|| grid(lines))
}

/// The parts of the archive that `file` is; an error in words. All are unpacked, but only XML is kept.
fn unpacked(file: &DataFile, bytes: &[u8]) -> Result<Parts, String> {
    let shown = |error: &dyn std::error::Error| file.bare(&error.to_string());
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| shown(&error))?;
    let mut left = MAX_UNPACKED;
    let mut parts = Parts::new();
    for index in 0..archive.len() {
        let part = archive.by_index(index).map_err(|error| shown(&error))?;
        let name = part.name().map_err(|error| shown(&error))?.into_owned();
        let in_part = |reason: String| format!("{}: {reason}", file.bare(&name));
        let mut content = Vec::new();
        let mut part = part.take(left.min(MAX_PART) + 1);
        let read = part
            .read_to_end(&mut content)
            .map_err(|error| in_part(shown(&error)))? as u64;
        if read > MAX_PART {
            let most = MAX_PART >> 20;
            return Err(in_part(format!(
                "more than {most} MiB unpacked, the most a part may have"
            )));
        }
        left = left.checked_sub(read).ok_or_else(|| {
            let most = MAX_UNPACKED >> 20;
            format!("its parts have more than {most} MiB unpacked, the most they may have")
        })?;
        let name = name.to_lowercase();
        if name.ends_with(".xml") || name.ends_with(".rels") {
            parts.insert(name, content);
        }
    }
    Ok(parts)
}

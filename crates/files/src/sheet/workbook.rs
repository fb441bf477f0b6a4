//! `.xlsx` workbooks: the sheets with content, or the one that is named.
//!
//! Text that is a number is read as in a text file, its decimal sign settled by the table. A date may have been a number
//! (`1.2` to a German Excel): where one must be, it is a problem with help.

use super::cell::{Cell, Line};
use super::container;
use super::grid::Grid;
use super::limits::{MOST_CELLS, MOST_CHARACTERS, MOST_COLUMNS, MOST_NAMED, MOST_TEXT};
use crate::data_file::DataFile;
use crate::node::Node;
use crate::problems::Problems;
use calamine::{DataRef, Reader, SheetType, Xlsx};
use std::collections::BTreeMap;
use std::io::Cursor;

type Workbook = Xlsx<Cursor<Vec<u8>>>;
/// By row and column, from 0.
type Cells = BTreeMap<u32, BTreeMap<u32, Cell>>;

/// Whether it is one: by its name, or because it begins as a zip archive does.
pub fn is_one(file: &DataFile, bytes: &[u8]) -> bool {
    let extension = file.path().extension().unwrap_or_default();
    extension.eq_ignore_ascii_case("xlsx") || bytes.starts_with(b"PK\x03\x04")
}

/// The cells of the sheet called `name`, or of all with content.
pub fn read(
    file: &DataFile,
    bytes: Vec<u8>,
    name: Option<&str>,
    problems: &mut Problems,
) -> Option<Vec<Grid>> {
    let unreadable = |error: String| {
        file.problem(
            format!("cannot be read as an .xlsx workbook: {error}"),
            "open it in a spreadsheet and save it again as .xlsx or CSV",
        )
    };
    problems.keep(container::check(file, &bytes).map_err(unreadable))?;
    let workbook = Workbook::new(Cursor::new(bytes));
    let mut workbook =
        problems.keep(workbook.map_err(|error| unreadable(file.bare(&error.to_string()))))?;
    // Charts on sheets of their own hold no cells.
    let sheets = workbook.sheets_metadata().iter();
    let sheets = sheets.filter(|sheet| sheet.typ == SheetType::WorkSheet);
    let names: Vec<String> = sheets.map(|sheet| sheet.name.clone()).collect();
    let listed = |names: &[String]| {
        let quoted = names.iter().take(MOST_NAMED).map(|name| file.quote(name));
        let quoted: Vec<String> = quoted.collect();
        let more = if names.len() > MOST_NAMED {
            ", …"
        } else {
            ""
        };
        quoted.join(", ") + more
    };
    if let Some(name) = name.filter(|name| !names.iter().any(|known| known == name)) {
        problems.add(file.problem(
            format!(
                "has no sheet {}, its sheets are {}",
                Node::Text(name.to_owned()).shown(),
                listed(&names)
            ),
            "correct the name",
        ));
        return None;
    }
    let mut filled = Vec::new();
    let mut read = CellReader {
        file,
        cells: 0,
        text: 0,
    };
    for sheet in names
        .into_iter()
        .filter(|sheet| name.is_none_or(|name| name == sheet))
    {
        let cells = read.cells(&mut workbook, &sheet).map_err(unreadable);
        let cells = problems.keep(cells)?;
        filled.extend(grid(sheet, cells));
    }
    if filled.is_empty() {
        problems.add(file.problem("is empty", "give a header and a row for each tooth"));
        return None;
    }
    Some(filled)
}

/// Reads sheet after sheet, all of them within the limits of one table.
struct CellReader<'a> {
    file: &'a DataFile,
    /// Read so far.
    cells: usize,
    /// Bytes of text in them.
    text: usize,
}

impl CellReader<'_> {
    /// The cells of a sheet that have content.
    fn cells(&mut self, workbook: &mut Workbook, sheet: &str) -> Result<Cells, String> {
        let file = self.file;
        let place = |row: u32, column: u32| {
            format!(
                "row {} column {} of sheet {}",
                row + 1,
                column + 1,
                file.quote(sheet)
            )
        };
        let shown = |error: calamine::XlsxError| file.bare(&error.to_string());
        let mut reader = workbook.worksheet_cells_reader(sheet).map_err(shown)?;
        let mut cells = Cells::new();
        while let Some(cell) = reader.next_cell().map_err(shown)? {
            let (row, column) = cell.get_position();
            let content = match cell.get_value() {
                DataRef::Empty => continue,
                DataRef::Float(number) => Cell::Number(*number),
                DataRef::Int(number) => Cell::Number(*number as f64),
                DataRef::String(text) => self
                    .text_cell(text)
                    .map_err(|reason| format!("{}: {reason}", place(row, column)))?,
                DataRef::SharedString(text) => self
                    .text_cell(text)
                    .map_err(|reason| format!("{}: {reason}", place(row, column)))?,
                DataRef::Bool(flag) => {
                    Cell::Other(format!("the boolean {}", file.bare(&flag.to_string())))
                }
                DataRef::Error(error) => {
                    Cell::Other(format!("the error {}", file.bare(&error.to_string())))
                }
                _ => Cell::Other(
                    "a date or time (format the cells as numbers before entering them)".to_owned(),
                ),
            };
            if content == Cell::Empty {
                continue;
            }
            self.cells += 1;
            if column as usize >= MOST_COLUMNS || self.cells > MOST_CELLS {
                return Err(format!(
                    "{} is outside the table limits: up to {MOST_COLUMNS} columns and {MOST_CELLS} cells are read",
                    place(row, column)
                ));
            }
            if cells
                .entry(row)
                .or_default()
                .insert(column, content)
                .is_some()
            {
                return Err(format!("{} has two values", place(row, column)));
            }
        }
        Ok(cells)
    }

    /// A cell of text; one text may stand in any number of cells, so what they take is counted cell by cell.
    fn text_cell(&mut self, text: &str) -> Result<Cell, String> {
        let text = text.trim();
        if text.is_empty() {
            return Ok(Cell::Empty);
        }
        if text.chars().nth(MOST_CHARACTERS).is_some() {
            return Err(format!(
                "has more than {MOST_CHARACTERS} characters, the most a cell may have"
            ));
        }
        self.text += text.len();
        if self.text > MOST_TEXT {
            return Err(format!(
                "the text of the cells up to here has more than {} MiB, the most a table may have",
                MOST_TEXT >> 20
            ));
        }
        Ok(Cell::Text(text.to_owned()))
    }
}

/// `None` where there are no cells.
fn grid(sheet: String, cells: Cells) -> Option<Grid> {
    let lines = cells.into_iter().map(|(row, mut cells)| {
        let width = cells.last_key_value().map_or(0, |(last, _)| last + 1);
        let mut take = |column| cells.remove(&column).unwrap_or(Cell::Empty);
        Line {
            number: u64::from(row) + 1,
            cells: (0..width).map(&mut take).collect(),
        }
    });
    let lines: Vec<Line> = lines.collect();
    (!lines.is_empty()).then_some(Grid {
        sheet: Some(sheet),
        lines,
        decimal: None,
    })
}

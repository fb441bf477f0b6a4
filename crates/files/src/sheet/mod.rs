//! Inspection tables in files of their own: CSV, `.xlsx`, or a measuring machine's protocol.
//!
//! A file becomes a grid of cells ([`delimited`], [`workbook`]; a [`protocol`] has its own rows); the header names the columns
//! ([`column`]); the cells become numbers ([`number`]); the rows are put in
//! order of the teeth ([`by_tooth`]). Nothing is padded, replaced, guessed or
//! passed over: whatever is not understood is a problem with its line.

mod block;
mod by_tooth;
mod cell;
mod column;
mod container;
mod decimal;
mod delimited;
mod grid;
mod header;
mod limits;
pub mod number;
mod places;
mod protocol;
mod story;
mod text;
mod trace;
mod wanted;
mod workbook;

use super::data_file::DataFile;
use super::problems::Problems;
use super::table::Table;
pub use column::Column;
use grid::Grid;
pub use header::{Drawn, Header};
use number::Decimal;
pub use trace::TraceSheet;
pub use wanted::{Coverage, Row, Wanted};

/// Keys that name a table; others may stand beside them.
pub const KEYS: &[&str] = &["file", "sheet", "decimal"];

/// The decimal signs as the pair file states them.
const DECIMALS: [(&str, Decimal); 2] = [(".", Decimal::Point), (",", Decimal::Comma)];

/// How the container of `.xls` files begins: what CSV cannot.
const OLD_WORKBOOK: &[u8] = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";

/// A table as read, its rows by ascending tooth.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet<const N: usize> {
    /// What it says of the gear beside the rows.
    pub header: Header,
    /// At least one.
    pub rows: Vec<Row<N>>,
}

impl<const N: usize> Sheet<N> {
    /// Reads the file that `table` names under `file`, a relative path from the pair file's folder.
    ///
    /// All that is wrong is added to `problems`, under the key of `file` and with line numbers.
    pub fn read(table: &Table, wanted: &Wanted<N>, problems: &mut Problems) -> Option<Sheet<N>> {
        let file = DataFile::of(
            table,
            "the name of a table, such as \"pitch.csv\"",
            problems,
        )?;
        let mut bad = Problems::of_list();
        let read = read(&file, table, wanted, &mut bad);
        let good = bad.is_empty();
        problems.add_list(file.key(), bad);
        let (rows, header) = read.filter(|_| good)?;
        Some(Sheet { header, rows })
    }

    /// The values of one column, by ascending tooth.
    pub fn values(&self, column: usize) -> Vec<f64> {
        let value = |row: &Row<N>| row.values.get(column).copied();
        self.rows.iter().filter_map(value).collect()
    }
}

/// Checks that nothing is said of a file that `table` does not name.
pub fn without_file(table: &Table, problems: &mut Problems) -> Option<()> {
    let Some(name) = KEYS.iter().find(|name| table.has(name)) else {
        return Some(());
    };
    problems.add(table.problem(name, "given without `file`", "add the file, or remove it"));
    None
}

/// What a file holds.
enum Content {
    Cells(Grid),
    /// The text of a measuring machine's protocol.
    Protocol(String),
}

/// What `file` holds, and the decimal sign that the pair file states for it.
fn content(
    file: &DataFile,
    table: &Table,
    problems: &mut Problems,
) -> Option<(Content, Option<Decimal>)> {
    let bytes = problems.keep(file.bytes())?;
    let sheet = match table.get("sheet") {
        Some(entry) => Some(problems.keep(entry.text("give the name of the sheet"))?),
        None => None,
    };
    let stated = match table.get("decimal") {
        Some(entry) => Some(problems.keep(entry.choice(&DECIMALS))?),
        None => None,
    };
    if bytes.starts_with(OLD_WORKBOOK) {
        let help = "save it as .xlsx or CSV";
        problems.add(file.problem("is an old Excel workbook, .xls", help));
        return None;
    }
    if workbook::is_one(file, &bytes) {
        let grid = workbook::read(file, bytes, sheet, problems)?;
        return Some((Content::Cells(grid), stated));
    }
    if sheet.is_some() {
        problems.add(table.problem(
            "sheet",
            "the file is not a workbook, sheet is allowed only with .xlsx",
            "remove it",
        ));
    }
    let text = text::decode(file, &bytes, problems)?;
    if protocol::is_one(&text) {
        if stated == Some(Decimal::Comma) {
            problems.add(table.problem(
                "decimal",
                "the file is a protocol, whose decimal sign is the point",
                "remove it",
            ));
        }
        return Some((Content::Protocol(text.into()), stated));
    }
    Some((
        Content::Cells(delimited::read(file, &text, problems)?),
        stated,
    ))
}

/// The rows by ascending tooth, and the header lines of a protocol.
fn read<const N: usize>(
    file: &DataFile,
    table: &Table,
    wanted: &Wanted<N>,
    problems: &mut Problems,
) -> Option<(Vec<Row<N>>, Header)> {
    let (grid, stated) = match content(file, table, problems)? {
        (Content::Cells(grid), stated) => (grid, stated),
        (Content::Protocol(text), _) => return protocol::read(file, &text, wanted, problems),
    };
    let rows = grid.rows(file, wanted, stated, problems)?;
    let rows = by_tooth::ordered(file, rows, wanted, problems)?;
    Some((rows, Header::default()))
}

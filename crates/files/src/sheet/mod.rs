//! Inspection tables in files of their own: CSV, `.xlsx`, or a measuring machine's protocol.
//!
//! A file becomes grids of cells, one a sheet or separator ([`delimited`], [`workbook`]; a [`protocol`] has its own rows); the
//! header is found in one of them ([`head`], [`heading`]) and names the columns ([`places`]); the cells become numbers
//! ([`number`]); the rows are put in order of the teeth ([`by_tooth`]). What is no part of the table is reported ([`left_out`]).
//! No number is padded, replaced or guessed: whatever is not understood is a problem with its line.

mod block;
mod by_tooth;
mod cell;
mod choice;
mod column;
mod container;
mod decimal;
mod delimited;
mod grid;
mod head;
mod header;
mod heading;
mod left_out;
mod limits;
pub mod number;
mod p40;
mod places;
mod protocol;
mod statistic;
mod text;
mod trace;
mod wanted;
mod workbook;

use super::data_file::DataFile;
use super::problems::Problems;
use super::table::Table;
use cell::{Cell, Line};
pub use choice::{Choice, KEYS, keys_beside, without_file};
pub use column::Column;
use gearlash::metrology::PitchKind;
use grid::{FoundTable, Grid};
use head::Head;
pub use header::{Header, StatedGear};
use heading::Quantity;
use number::Decimal;
pub use trace::TraceSheet;
pub use wanted::{Coverage, Row, Wanted};

/// How the container of `.xls` files begins: what CSV cannot.
const OLD_WORKBOOK: &[u8] = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";

/// A table as read, its rows by ascending tooth.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet<const N: usize> {
    /// What it says of the gear beside the rows.
    pub header: Header,
    /// At least one.
    pub rows: Vec<Row<N>>,
    /// Where it stands in the file; `None`: in a protocol.
    pub origin: Option<Origin>,
}

/// Where a table stands in its file.
#[derive(Debug, Clone, PartialEq)]
pub struct Origin {
    pub sheet: Option<String>,
    /// The line of its header.
    pub header_row: u64,
    /// The columns it is read from, that of the teeth first: heading and letter.
    pub columns: Vec<(String, String)>,
    /// Of the columns of pitch, the kind that their headings say.
    pub kind: Option<PitchKind>,
    /// What of the file is no part of it, in words.
    pub left_out: Option<String>,
}

impl<const N: usize> Sheet<N> {
    /// Reads the file that `table` names under `file`, a relative path from the pair file's folder.
    ///
    /// All that is wrong is added to `problems`, under the key of `file` and with line numbers.
    pub fn read(table: &Table, wanted: &Wanted<N>, problems: &mut Problems) -> Option<Sheet<N>> {
        read_with(
            table,
            "pitch.csv",
            problems,
            |content, file, choice, bad| {
                Sheet::with_remarks(table, content, file, choice, wanted, bad)
            },
        )
    }

    /// The `wanted` table of what the file that `table` names holds, with the remarks.
    pub fn with_remarks(
        table: &Table,
        content: &Content,
        file: &DataFile,
        choice: &Choice,
        wanted: &Wanted<N>,
        problems: &mut Problems,
    ) -> Option<Sheet<N>> {
        let sheet = Sheet::of(content, file, choice, wanted, problems)?;
        if problems.is_empty() {
            table.place().add_remark(sheet.header.remark());
            if let Some(origin) = &sheet.origin {
                table.place().add_remark(origin.remark(file));
            }
        }
        Some(sheet)
    }

    /// The `wanted` table of what a file holds.
    pub fn of(
        content: &Content,
        file: &DataFile,
        choice: &Choice,
        wanted: &Wanted<N>,
        problems: &mut Problems,
    ) -> Option<Sheet<N>> {
        let (rows, header) = match content {
            Content::Cells(grids) => {
                let (found, places) = grid::find(grids, file, wanted, choice, problems)?;
                let rows = found.numbers(file, &places, wanted, choice, problems)?;
                let used: Vec<usize> = std::iter::once(places.tooth).chain(places.wanted).collect();
                return Some(Sheet {
                    header: Header::default(),
                    rows: by_tooth::ordered(file, rows, wanted, problems)?,
                    origin: Some(Origin::of(&found, grids, &used, file)),
                });
            }
            Content::Protocol(text) => protocol::read(file, text, wanted, problems)?,
            Content::P40(text) => {
                let p40 = p40::parse(file, text, problems)?;
                p40.refuse_values(file, problems)?;
                if wanted.columns.contains(&Column::Thickness) {
                    problems.add(file.problem(
                        "is a curve file: thickness is not taken from the probe's positions",
                        "name a table of the thickness of each tooth, or state the thickness by span or over_pins",
                    ));
                    return None;
                }
                let wanted = Wanted {
                    teeth: wanted.teeth.or(p40.header.teeth()),
                    ..*wanted
                };
                let rows = protocol::of_blocks(file, &p40.blocks, &wanted, problems)?;
                let mut header = p40.header.clone();
                header.left_unused(file, &p40.unused(p40::PITCH));
                (rows, header)
            }
        };
        Some(Sheet {
            header,
            rows,
            origin: None,
        })
    }

    /// The values of one column, by ascending tooth.
    pub fn values(&self, column: usize) -> Vec<f64> {
        let value = |row: &Row<N>| row.values.get(column).copied();
        self.rows.iter().filter_map(value).collect()
    }
}

/// Reads the file that `table` names, such as `example`, once, and hands over what it holds; a problem in it leaves nothing.
pub fn read_with<'a, T>(
    table: &Table<'a>,
    example: &str,
    problems: &mut Problems,
    take: impl FnOnce(&Content, &DataFile, &Choice<'a>, &mut Problems) -> Option<T>,
) -> Option<T> {
    let needed = format!("the name of a table, such as \"{example}\"");
    let file = DataFile::of(table, &needed, problems)?;
    problems.of_list_at(file.key(), |bad| {
        let choice = Choice::read(table, bad)?;
        let bytes = bad.keep(file.bytes())?;
        let content = content(&file, bytes, table, &choice, bad)?;
        take(&content, &file, &choice, bad)
    })
}

impl Origin {
    /// That of a table found in one of `grids`, read from the columns `used`.
    fn of(found: &FoundTable, grids: &[Grid], used: &[usize], file: &DataFile) -> Origin {
        let headings = used
            .iter()
            .map(|place| (&found.head.headings[*place], head::letter(*place)));
        let mut kinds =
            headings
                .clone()
                .filter_map(|(heading, _)| match heading.meaning?.quantity {
                    Quantity::Pitch(kind) => kind,
                    _ => None,
                });
        Origin {
            sheet: found.grid.sheet.clone().filter(|_| grids.len() > 1),
            header_row: found.head.line,
            kind: kinds.next_back(),
            columns: headings
                .map(|(heading, letter)| (heading.shown.clone(), letter))
                .collect(),
            left_out: found.left_out.words(&found.head, file),
        }
    }

    /// A remark on it; `None` where the whole file is the table.
    fn remark(&self, file: &DataFile) -> Option<String> {
        let sheet = self
            .sheet
            .as_ref()
            .map(|name| format!("sheet {}, ", file.quote(name)));
        if sheet.is_none() && self.left_out.is_none() {
            return None;
        }
        let columns = self
            .columns
            .iter()
            .map(|(name, letter)| format!("{} ({letter})", file.quote(name)));
        let columns: Vec<String> = columns.collect();
        let rest = self
            .left_out
            .as_ref()
            .map(|words| format!("; left out: {words}"));
        Some(format!(
            "{}: {}: read from {}line {} on, columns {}{}",
            file.key(),
            file.name(),
            sheet.unwrap_or_default(),
            self.header_row,
            columns.join(", "),
            rest.unwrap_or_default()
        ))
    }
}

/// What a file holds.
pub enum Content {
    /// Cells: one grid or more.
    Cells(Vec<Grid>),
    /// The text of a measuring machine's protocol.
    Protocol(String),
    /// That of a P40's curve file or value file.
    P40(String),
}

impl Content {
    /// Whether there is a table of teeth with one of the `columns`.
    pub fn has(&self, columns: &[Column], choice: &Choice) -> bool {
        match self {
            Content::Cells(grids) => {
                has_head(grids, choice, |head| grid::is_head(head, columns, choice))
            }
            Content::Protocol(text) | Content::P40(text) => {
                columns.iter().any(|column| protocol::has(text, *column))
            }
        }
    }

    /// Whether there is one column for each that is wanted.
    pub fn has_each<const N: usize>(
        &self,
        file: &DataFile,
        wanted: &Wanted<N>,
        choice: &Choice,
    ) -> bool {
        match self {
            Content::Cells(grids) => {
                let mut unheard = Problems::of_list();
                grid::find(grids, file, wanted, choice, &mut unheard).is_some()
            }
            Content::Protocol(_) | Content::P40(_) => true,
        }
    }

    /// Whether it is a file of a P40, of curves or values.
    pub fn is_p40(&self) -> bool {
        matches!(self, Content::P40(_))
    }

    /// Refuses a value file of a P40, and whatever is wrong with a file of one.
    pub fn check_p40(&self, file: &DataFile, problems: &mut Problems) -> Option<()> {
        match self {
            Content::P40(text) => p40::parse(file, text, problems)?.refuse_values(file, problems),
            Content::Cells(_) | Content::Protocol(_) => Some(()),
        }
    }

    /// Whether there is a table of traces.
    pub fn has_trace(&self, choice: &Choice) -> bool {
        match self {
            Content::Cells(grids) => has_head(grids, choice, |head| trace::is_head(head, choice)),
            Content::P40(text) => text.lines().any(|line| line.trim().starts_with("Profil:")),
            Content::Protocol(_) => false,
        }
    }
}

/// Whether one of `grids` has a header that is wanted.
fn has_head(grids: &[Grid], choice: &Choice, is_wanted: impl Fn(&Head) -> bool) -> bool {
    let mut grids = grids.iter();
    grids.any(|grid| Head::find(&grid.lines, choice, &is_wanted).is_some())
}

/// What `file` of these `bytes` holds.
pub fn content(
    file: &DataFile,
    bytes: Vec<u8>,
    table: &Table,
    choice: &Choice,
    problems: &mut Problems,
) -> Option<Content> {
    if bytes.starts_with(OLD_WORKBOOK) {
        let help = "save it as .xlsx or CSV";
        problems.add(file.problem("is an old Excel workbook, .xls", help));
        return None;
    }
    if workbook::is_one(file, &bytes) {
        let grids = workbook::read(file, bytes, choice.sheet, problems)?;
        return Some(Content::Cells(below_header(grids, choice)));
    }
    if choice.sheet.is_some() {
        let words = "the file is not a workbook, sheet is allowed only with .xlsx";
        problems.add(table.problem("sheet", words, "remove it"));
    }
    let text = text::decode(file, &bytes, problems)?;
    let is_p40 = p40::is_one(&text);
    if !is_p40 && !protocol::is_one(&text) {
        let grids = delimited::read(file, &text, problems)?;
        return Some(Content::Cells(below_header(grids, choice)));
    }
    if choice.decimal == Some(Decimal::Comma) {
        let words = "the file is a protocol, whose decimal sign is the point";
        problems.add(table.problem("decimal", words, "remove it"));
    }
    if let Some(key) = choice.of_cells() {
        let words = format!("the file is a protocol, {key} is allowed only with CSV and .xlsx");
        problems.add(table.problem(key, words, "remove it"));
    }
    Some(match is_p40 {
        true => Content::P40(text.into()),
        false => Content::Protocol(text.into()),
    })
}

/// The grids, below a blank header where the file is said to have none: letters name its columns.
fn below_header(mut grids: Vec<Grid>, choice: &Choice) -> Vec<Grid> {
    if choice.header_row == Some(0) {
        for grid in &mut grids {
            let width = grid.lines.iter().map(|line| line.cells.len()).max();
            let cells = vec![Cell::Empty; width.unwrap_or(0)];
            grid.lines.insert(0, Line { number: 0, cells });
        }
    }
    grids
}

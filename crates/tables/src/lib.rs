//! Inspection tables in files of their own: CSV, `.xlsx`, or a measuring machine's protocol.
//!
//! A file becomes grids of cells, one for each sheet or separator (`delimited`, `workbook`). The header is found in one of
//! them (`request`, `column_header`, `heading`) and names the columns (`places`). The cells become numbers, in the order of the
//! teeth (`rows`, `decimal_sign`). A `protocol` has rows of its own. Parts of the file that are not part of the table are
//! reported. No number is padded, replaced or guessed: an unknown line is a problem with its line number.

mod choice;
mod column;
mod column_header;
mod data_file;
mod decimal_sign;
mod delimited;
mod grid;
mod heading;
mod p40;
mod protocol;
mod protocol_header;
mod request;
mod rows;
mod workbook;
mod xlsx;

pub use choice::{Choice, TableFileSpec};
pub use column::{Column, Quantity};
use column_header::ColumnHeader;
pub use data_file::DataFile;
use gearlash::metrology::PitchKind;
use gearlash_text::characters::first_of;
use gearlash_text::file_numbers::Decimal;
use gearlash_text::{Problem, Table};
pub use grid::MAX_CELLS;
use grid::{Cell, Grid, Line, letter};
pub use protocol_header::{ExpectedGear, ProtocolHeader};
pub use request::{Coverage, Request, Wanted};
use rows::Found;
pub use rows::{Row, Unread};

/// Extensions of files with tables; `.xls` is refused with a remedy.
pub const EXTENSIONS: [&str; 7] = ["csv", "tsv", "xlsx", "xlsm", "xls", "mka", "mew"];

/// Formats that are not read: their first bytes and names.
const NOT_READ: [(&[u8], &str); 2] = [
    (
        b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
        "an old Excel workbook, .xls",
    ),
    (b"%PDF-", "a PDF"),
];
/// An OpenDocument archive holds this text uncompressed in its first part.
const OPEN_DOCUMENT: &[u8] = b"mimetypeapplication/vnd.oasis.opendocument";

/// Headings that a message lists. Tuned: a sentence of some 25 words.
const MAX_HEADINGS: usize = 4;

/// A table that was read.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// Statements on the gear beside the rows.
    pub header: ProtocolHeader,
    /// At least one: by ascending tooth, or points in the order of their lines.
    pub rows: Vec<Row>,
    /// The columns beside the tooth, in the order of the values.
    pub columns: Vec<Column>,
    /// Where each row comes from, in words; empty where the table does not say.
    pub sources: Vec<String>,
    /// Place of the table in its file; `None` in a protocol.
    pub origin: Option<Origin>,
}

/// Place of a table in its file.
#[derive(Debug, Clone, PartialEq)]
pub struct Origin {
    /// The sheet, where a workbook has several.
    pub sheet: Option<String>,
    /// The line of its header.
    pub header_row: u64,
    /// The columns it is read from, the teeth first: heading and letter.
    pub columns: Vec<(String, String)>,
    /// Kind of the columns of pitch by their headings.
    pub kind: Option<PitchKind>,
    /// Whether the rows are numbered by spaces.
    pub by_space: bool,
    /// Diameter of the ball or pins by the headings, mm.
    pub ball_mm: Option<f64>,
    /// Parts of the file that are not part of the table.
    pub unread: Unread,
}

impl Sheet {
    /// Reads the file that `table` names under `file`, a relative path from the pair file's folder.
    ///
    /// Problems have the key of `file`, and line numbers.
    pub fn read(table: &Table, wanted: &Wanted) -> Option<(DataFile, Sheet)> {
        let file = DataFile::of(table)?;
        let choice = Choice::of(table);
        let sheet = file.list(|| {
            let content =
                Content::read(&file, (file.bytes()?, wanted.most_cells()), table, &choice)?;
            let request = Request {
                file: &file,
                choice: &choice,
                wanted: *wanted,
            };
            Sheet::of(&content, &request)
        })?;
        let origin = sheet
            .origin
            .as_ref()
            .and_then(|origin| origin.remark(&file));
        table.reading().add_remark(sheet.header.remark().or(origin));
        Some((file, sheet))
    }

    /// Reads the `quantity` of every tooth from the file that `table` names.
    pub fn of_one_quantity(table: &Table, quantity: Quantity, teeth: Option<u32>) -> Option<Sheet> {
        Sheet::of_every_tooth(table, &[Column::of(quantity)], teeth)
    }

    /// Reads the `columns` of every tooth from the file that `table` names.
    pub fn of_every_tooth(table: &Table, columns: &[Column], teeth: Option<u32>) -> Option<Sheet> {
        let wanted = Wanted {
            columns,
            teeth,
            coverage: Coverage::EveryTooth,
        };
        Sheet::read(table, &wanted).map(|(_, sheet)| sheet)
    }

    /// Reads the table that `request` asks for.
    pub fn of(content: &Content, request: &Request) -> Option<Sheet> {
        let (rows, header) = match content {
            Content::Cells(grids) => {
                let found = Found::find(request, grids)?;
                let columns = found.places.values.iter();
                return Some(Sheet {
                    header: ProtocolHeader::default(),
                    rows: found.rows(request)?,
                    columns: columns.map(|(column, _)| *column).collect(),
                    sources: found.sources(request.file),
                    origin: Some(Origin::of(found, grids)),
                });
            }
            Content::Protocol(_) | Content::P40(_) if request.wanted.is_results() => {
                let help = "name a table of the rig's results";
                return request.file.refuse("is a protocol", help);
            }
            Content::Protocol(_) if request.wanted.is_points() => {
                return request.file.refuse(
                    "is a protocol of pitch, expected is a table of traces",
                    "name a table with a row a point",
                );
            }
            Content::Protocol(text) => protocol::read(request, text)?,
            Content::P40(text) => p40::read(request, text)?,
        };
        Some(Sheet {
            header,
            rows,
            columns: request.wanted.columns.to_vec(),
            sources: Vec::new(),
            origin: None,
        })
    }

    /// The values of one column, in the order of the rows.
    pub fn values(&self, column: usize) -> Vec<f64> {
        let value = |row: &Row| row.values.get(column).copied();
        self.rows.iter().filter_map(value).collect()
    }

    /// The teeth, in the order of the rows.
    pub fn teeth(&self) -> Vec<u32> {
        self.rows.iter().filter_map(|row| row.tooth).collect()
    }
}

impl Origin {
    fn of(found: Found, grids: &[Grid]) -> Origin {
        let places = found.places.numbers().into_iter();
        let headings = places.map(|place| (&found.head.headings[place], letter(place)));
        let headings: Vec<_> = headings.collect();
        let quantities = || {
            headings
                .iter()
                .filter_map(|(heading, _)| heading.quantity())
        };
        Origin {
            sheet: found.grid.sheet.clone().filter(|_| grids.len() > 1),
            header_row: found.head.line,
            kind: quantities().filter_map(Quantity::pitch_kind).next_back(),
            by_space: headings
                .iter()
                .any(|(heading, _)| heading::has_space(&heading.shown)),
            ball_mm: headings.iter().find_map(|(heading, _)| heading.ball_mm),
            columns: headings
                .iter()
                .map(|(heading, letter)| (heading.shown.clone(), letter.clone()))
                .collect(),
            unread: found.unread,
        }
    }

    /// A remark on it; `None` where the table is the whole file.
    fn remark(&self, file: &DataFile) -> Option<String> {
        let unread = self.unread.words(&[]);
        if self.sheet.is_none() && unread.is_none() {
            return None;
        }
        let sheet = self
            .sheet
            .as_ref()
            .map(|name| format!("sheet {}, ", file.quote(name)));
        let columns = self.columns.iter();
        let columns = columns.map(|(name, letter)| format!("{} ({letter})", file.quote(name)));
        let rest = unread.map(|words| format!("; left out: {words}"));
        Some(format!(
            "{}: {}: read from {}line {} on, columns {}{}",
            file.key(),
            file.name(),
            sheet.unwrap_or_default(),
            self.header_row,
            columns.collect::<Vec<_>>().join(", "),
            rest.unwrap_or_default()
        ))
    }
}

/// The content of a file with a table.
pub enum Content {
    /// Cells: one grid or more.
    Cells(Vec<Grid>),
    /// The text of a measuring machine's protocol.
    Protocol(String),
    /// The text of a P40's curve file.
    P40(String),
}

impl Content {
    /// Reads the `bytes` of `file`. A CSV file may have at most `most` cells.
    pub fn read(
        file: &DataFile,
        (bytes, most): (Vec<u8>, usize),
        table: &Table,
        choice: &Choice,
    ) -> Option<Content> {
        let mut not_read = NOT_READ
            .iter()
            .filter(|(begin, _)| bytes.starts_with(begin));
        let start = &bytes[..bytes.len().min(100)];
        let is_open_document = start
            .windows(OPEN_DOCUMENT.len())
            .any(|part| part == OPEN_DOCUMENT);
        let name = not_read.next().map(|(_, name)| *name);
        if let Some(name) =
            name.or(is_open_document.then_some("an OpenDocument file, such as .ods"))
        {
            return file.refuse(format!("is {name}"), "save it as .xlsx or CSV");
        }
        if workbook::is_workbook(file, &bytes) {
            let grids = workbook::read(file, bytes, choice.table.sheet.as_deref())?;
            return Some(Content::Cells(below_header(grids, choice)));
        }
        let remove = |key: &str, words: &str| table.add(key, words, "remove it");
        if choice.table.sheet.is_some() {
            remove(
                "sheet",
                "the file is not a workbook, sheet is allowed only with .xlsx",
            );
        }
        let text = delimited::decode(file, &bytes)?;
        if p40::is_value_file(&text) {
            return file.refuse(
                "is a value file (.mew): results by number, of which none is known for certain to be a span or a dimension over pins",
                "name the curve file of the same measurement (.mka), or write the values into the pair file",
            );
        }
        let is_p40 = p40::is_curve_file(&text);
        if !is_p40 && !protocol::is_protocol(&text) {
            let grids = delimited::read(file, &text, most)?;
            return Some(Content::Cells(below_header(grids, choice)));
        }
        if choice.table.decimal == Some(Decimal::Comma) {
            remove(
                "decimal",
                "the file is a protocol, whose decimal sign is the point",
            );
        }
        if let Some(key) = choice.of_cells() {
            remove(
                key,
                &format!("the file is a protocol, {key} is allowed only with CSV and .xlsx"),
            );
        }
        Some(if is_p40 {
            Content::P40(text.into())
        } else {
            Content::Protocol(text.into())
        })
    }

    /// Whether there is a table with one of the wanted columns.
    pub fn has(&self, request: &Request) -> bool {
        match self {
            Content::Cells(grids) => request.is_there(grids),
            Content::P40(text) if request.wanted.is_points() => {
                if request.wanted.has(Quantity::Height) {
                    p40::has_leads(text)
                } else {
                    p40::has_profiles(text)
                }
            }
            Content::Protocol(text) | Content::P40(text) => {
                let mut columns = request.wanted.columns.iter();
                columns.any(|column| protocol::has(text, *column))
            }
        }
    }

    /// The columns that a line above numbers names, where none has what `request` wants; `None` without such a line.
    pub fn heading_without(&self, request: &Request, wanted: &str) -> Option<String> {
        let Content::Cells(grids) = self else {
            return None;
        };
        let mut heads = grids
            .iter()
            .filter_map(|grid| ColumnHeader::likely(&grid.lines));
        let head = heads.next()?;
        let has_tooth = !head
            .teeth(request.wanted.columns, request.choice)
            .is_empty();
        let names = head
            .all()
            .into_iter()
            .map(|place| head.shown_one(request.file, place));
        Some(format!(
            "line {} looks like a heading, but no column of {} is among these: {}",
            head.line,
            if has_tooth { wanted } else { "teeth" },
            first_of(names, MAX_HEADINGS)
        ))
    }

    /// Why the columns of pitch that `request` wants are not read where their rows are numbered by spaces.
    pub fn pitch_by_spaces(&self, request: &Request) -> Option<Problem> {
        match self {
            Content::Cells(grids) => request.by_spaces(grids),
            Content::Protocol(_) | Content::P40(_) => None,
        }
    }

    /// Whether there is one column for each wanted one.
    pub fn has_each(&self, request: &Request) -> bool {
        match self {
            Content::Cells(grids) => {
                let reading = request.file.reading();
                reading
                    .capture_problems(|| Found::find(request, grids))
                    .0
                    .is_some()
            }
            Content::Protocol(_) | Content::P40(_) => true,
        }
    }

    /// Whether it is a curve file of a P40.
    pub fn is_p40(&self) -> bool {
        matches!(self, Content::P40(_))
    }

    /// Reports the problems of a curve file of a P40.
    pub fn check_p40(&self, file: &DataFile) -> Option<()> {
        match self {
            Content::P40(text) => p40::parse(file, text).map(|_| ()),
            Content::Cells(_) | Content::Protocol(_) => Some(()),
        }
    }
}

/// The grids, with a blank header added where the pair file states that there is none. Letters then name the columns.
fn below_header(mut grids: Vec<Grid>, choice: &Choice) -> Vec<Grid> {
    if choice.table.header_row == Some(0) {
        for grid in &mut grids {
            let width = grid.lines.iter().map(|line| line.cells.len()).max();
            let cells = vec![Cell::Empty; width.unwrap_or(0)];
            grid.lines.insert(0, Line { number: 0, cells });
        }
    }
    grids
}

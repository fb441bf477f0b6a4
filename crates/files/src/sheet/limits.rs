//! How large a table may be. Whatever a file holds, it is refused before it takes more than some 300 MB or some seconds.
//!
//! A table of the largest gear has 10 000 rows of a few columns. A file has at most 64 MiB, but packed it can hold a thousand times
//! as much, and 64 million commas are 64 million cells of 32 bytes each.

/// Cells of a table: those of 10 000 teeth in 20 columns.
pub const MOST_CELLS: usize = 200_000;
/// Columns that a table may reach: far beyond its few own.
pub const MOST_COLUMNS: usize = 100;
/// Rows of a protocol: those of both flanks of 10 000 teeth.
pub const MOST_ROWS: usize = 20_000;
/// Bytes of the text of all cells of a workbook: as many as a text file may have.
pub const MOST_TEXT: usize = 16 << 20;
/// Characters of one cell: as many as a spreadsheet takes.
pub const MOST_CHARACTERS: usize = 32_767;
/// Bytes of one part of a workbook that holds cells, unpacked: some hundred for each cell, and a few other sheets.
pub const MOST_PART: u64 = 32 << 20;
/// Bytes of all parts of a workbook, pictures included, unpacked; they are only read through.
pub const MOST_UNPACKED: u64 = 64 << 20;
/// Bytes of one tag: the text of a cell is not in it, and a name has no more than 255 characters.
pub const MOST_TAG: usize = 1 << 16;
/// Sheets of which a message names each.
pub const MOST_NAMED: usize = 10;

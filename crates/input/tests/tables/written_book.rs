//! A workbook of one sheet, cell by cell.

use rust_xlsxwriter::{Workbook, Worksheet};

/// The content of a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    Nothing,
    Number(f64),
    Text(String),
    Flag(bool),
}

use Cell::{Flag, Nothing, Number, Text};

/// From the first row and column on.
pub type Cells = Vec<Vec<Cell>>;

/// A row of texts; an empty one is no cell.
pub fn texts(words: &[&str]) -> Vec<Cell> {
    let cell = |word: &&str| match *word {
        "" => Nothing,
        word => Text(word.to_owned()),
    };
    words.iter().map(cell).collect()
}

/// Columns of numbers below their headings.
pub fn columns<const N: usize>(headings: [&str; N], rows: &[[f64; N]]) -> Cells {
    let rows = rows.iter().map(|row| row.map(Number).to_vec());
    [texts(&headings)].into_iter().chain(rows).collect()
}

pub fn write(sheet: &mut Worksheet, row: u32, column: u16, content: &Cell) {
    match content {
        Nothing => return,
        Number(number) => sheet.write(row, column, *number),
        Text(text) => sheet.write(row, column, text.as_str()),
        Flag(flag) => sheet.write(row, column, *flag),
    }
    .unwrap();
}

pub fn fill(sheet: &mut Worksheet, cells: &Cells) {
    for (row, cells) in (0..).zip(cells) {
        for (column, content) in (0..).zip(cells) {
            write(sheet, row, column, content);
        }
    }
}

pub fn written(cells: &Cells) -> Vec<u8> {
    let mut workbook = Workbook::new();
    fill(workbook.add_worksheet(), cells);
    workbook.save_to_buffer().unwrap()
}

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

pub fn write(sheet: &mut Worksheet, row: u32, column: u16, content: &Cell) {
    match content {
        Nothing => return,
        Number(number) => sheet.write(row, column, *number),
        Text(text) => sheet.write(row, column, text.as_str()),
        Flag(flag) => sheet.write(row, column, *flag),
    }
    .unwrap();
}

pub fn written(cells: &Cells) -> Vec<u8> {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    for (row, cells) in (0..).zip(cells) {
        for (column, content) in (0..).zip(cells) {
            write(sheet, row, column, content);
        }
    }
    workbook.save_to_buffer().unwrap()
}

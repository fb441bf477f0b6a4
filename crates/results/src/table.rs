//! A table that text, CSV and JSON writers take: columns of cells under names.

use serde::Serialize;
use serde_json::{Map, Value};
use std::borrow::Cow;

/// A table: its name, and columns of the same height.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// What it is called, as a file of its own is.
    pub name: &'static str,
    /// The columns, in the order shown.
    pub columns: Vec<Column>,
}

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name as data.
    pub name: &'static str,
    /// The unit of its numbers.
    pub unit: Unit,
    /// A value a row, from the top; missing ones at the end are left empty.
    pub cells: Vec<Cell>,
}

/// What a column's numbers count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Millimetres.
    Mm,
    /// Micrometres.
    Um,
    /// Radians.
    Rad,
    /// Numbers of teeth, fractions, words.
    None,
}

impl Unit {
    /// Decimals in a table for people: a nanometre, in either unit of length.
    pub fn decimals(self) -> usize {
        match self {
            Unit::Mm | Unit::Rad => 6,
            Unit::Um => 3,
            Unit::None => 0,
        }
    }
}

/// One value. Numbers are written so that they read back to the same f64.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Cell {
    /// No value: null, or nothing between two commas.
    Empty,
    /// A count or a number of a tooth.
    Count(u32),
    /// A measure in the column's unit.
    Number(f64),
    /// A word.
    Word(Cow<'static, str>),
    /// More than a table for people can show: in JSON alone.
    Json(Value),
}

impl Cell {
    /// As it stands in CSV.
    fn csv(&self) -> String {
        match self {
            Cell::Empty | Cell::Json(_) => String::new(),
            Cell::Count(count) => count.to_string(),
            Cell::Number(number) => number.to_string(),
            Cell::Word(word) => word.to_string(),
        }
    }

    /// The measure, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Cell::Number(number) => Some(*number),
            _ => None,
        }
    }
}

impl From<u32> for Cell {
    fn from(count: u32) -> Cell {
        Cell::Count(count)
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Cell {
        Cell::Number(number)
    }
}

impl From<&'static str> for Cell {
    fn from(word: &'static str) -> Cell {
        Cell::Word(word.into())
    }
}

impl From<String> for Cell {
    fn from(word: String) -> Cell {
        Cell::Word(word.into())
    }
}

impl From<Value> for Cell {
    fn from(value: Value) -> Cell {
        Cell::Json(value)
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Cell {
        value.map_or(Cell::Empty, T::into)
    }
}

impl Column {
    /// A column of anything that a cell can be.
    pub fn new<T: Into<Cell>>(
        name: &'static str,
        unit: Unit,
        cells: impl IntoIterator<Item = T>,
    ) -> Column {
        Column {
            name,
            unit,
            cells: cells.into_iter().map(T::into).collect(),
        }
    }

    /// The value in a row, from 0.
    pub fn cell(&self, row: usize) -> &Cell {
        self.cells.get(row).unwrap_or(&Cell::Empty)
    }

    /// Its measures.
    pub fn numbers(&self) -> Vec<f64> {
        self.cells.iter().filter_map(Cell::number).collect()
    }

    fn is_data(&self) -> bool {
        !matches!(self.cells.first(), Some(Cell::Json(_)))
    }
}

impl Table {
    /// How many rows it has.
    pub fn rows(&self) -> usize {
        let heights = self.columns.iter().map(|column| column.cells.len());
        heights.max().unwrap_or(0)
    }

    /// The column called so.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// The columns called so, in that order.
    pub fn of(&self, names: &[&str]) -> Table {
        let columns = names.iter().filter_map(|name| self.column(name)).cloned();
        Table {
            name: self.name,
            columns: columns.collect(),
        }
    }

    /// As CSV under the columns' names; what only JSON can hold is left out.
    ///
    /// # Errors
    /// None that a table can cause; the writer's otherwise.
    pub fn to_csv(&self) -> Result<String, csv::Error> {
        Table::all_to_csv(std::slice::from_ref(self))
    }

    /// Tables of the same columns one below the other, under the first one's names.
    ///
    /// # Errors
    /// As [`Table::to_csv`].
    pub fn all_to_csv(tables: &[Table]) -> Result<String, csv::Error> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for (number, table) in tables.iter().enumerate() {
            let columns = || table.columns.iter().filter(|column| column.is_data());
            if number == 0 {
                writer.write_record(columns().map(|column| column.name))?;
            }
            for row in 0..table.rows() {
                writer.write_record(columns().map(|column| column.cell(row).csv()))?;
            }
        }
        gearlash_files::characters::csv_text(writer)
    }

    /// As JSON: an object a row, each column's value under its key in `keys`.
    pub fn to_json(&self, keys: &[&str]) -> Value {
        let row = |row: usize| {
            let cells = keys.iter().zip(&self.columns);
            let cells = cells.map(|(key, column)| {
                let value = match column.cell(row) {
                    Cell::Empty => Value::Null,
                    Cell::Count(count) => (*count).into(),
                    Cell::Number(number) => (*number).into(),
                    Cell::Word(word) => word.as_ref().into(),
                    Cell::Json(value) => value.clone(),
                };
                ((*key).to_owned(), value)
            });
            Value::Object(cells.collect::<Map<_, _>>())
        };
        (0..self.rows()).map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn table() -> Table {
        let touched = [json!([1]), json!([2])];
        Table {
            name: "spans",
            columns: vec![
                Column::new("tooth", Unit::None, [1u32, 2]),
                Column::new("span", Unit::Mm, [Some(50.5), None]),
                Column::new("touched", Unit::None, touched),
            ],
        }
    }

    #[test]
    fn a_table_is_csv_and_json_alike() {
        assert_eq!(table().to_csv().unwrap(), "tooth,span\n1,50.5\n2,\n");
        let expected = json!([
            { "tooth": 1, "mm": 50.5, "touched": [1] },
            { "tooth": 2, "mm": null, "touched": [2] },
        ]);
        assert_eq!(table().to_json(&["tooth", "mm", "touched"]), expected);
        assert_eq!(
            table().of(&["span"]).to_json(&["mm"]),
            json!([{ "mm": 50.5 }, { "mm": null }])
        );
    }

    #[test]
    fn tables_of_the_same_columns_share_a_heading() {
        let both = [table().of(&["tooth"]), table().of(&["tooth"])];
        assert_eq!(Table::all_to_csv(&both).unwrap(), "tooth\n1\n2\n1\n2\n");
    }
}

//! Keys beside `file`: they locate the table in the file where the file alone does not.

use super::number::Decimal;
use crate::table::Table;
use serde::Deserialize;
use serde::de::value::{Error, MapDeserializer};

/// The key that names the column of tooth numbers.
pub const TOOTH: &str = "tooth_column";

/// Values of those keys.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
pub struct Choice {
    pub sheet: Option<String>,
    /// The line of the header, from 1; 0 where the file has none.
    pub header_row: Option<u64>,
    pub decimal: Option<Decimal>,
    tooth_column: Option<String>,
    left: Option<String>,
    right: Option<String>,
    column: Option<String>,
}

impl Choice {
    /// The keys of `table`.
    pub fn of(table: &Table) -> Choice {
        let entries = table
            .entries()
            .iter()
            .map(|(key, node)| (key.as_str(), node));
        let choice: Result<Choice, Error> = Choice::deserialize(MapDeserializer::new(entries));
        // The schema allows nothing that serde refuses.
        choice.unwrap_or_default()
    }

    fn columns(&self) -> [(&'static str, Option<&str>); 4] {
        [
            (TOOTH, self.tooth_column.as_deref()),
            ("left", self.left.as_deref()),
            ("right", self.right.as_deref()),
            ("column", self.column.as_deref()),
        ]
    }

    /// The column that `key` names.
    pub fn column(&self, key: &str) -> Option<&str> {
        let mut columns = self.columns().into_iter();
        columns
            .find(|(known, _)| *known == key)
            .and_then(|(_, name)| name)
    }

    /// A given key that applies to tables of cells alone.
    pub fn of_cells(&self) -> Option<&'static str> {
        let row = self.header_row.map(|_| "header_row");
        let mut columns = self.columns().into_iter();
        row.or(columns.find(|(_, name)| name.is_some()).map(|(key, _)| key))
    }
}

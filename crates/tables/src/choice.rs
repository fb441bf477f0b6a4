//! The keys of a table in a pair file: where it is, and its columns.

use gearlash_text::file_numbers::Decimal;
use gearlash_text::{Node, Table};
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_json::{Map, json};
use serde_with::skip_serializing_none;

/// The key that names the column of tooth numbers.
pub const TOOTH: &str = "tooth_column";

/// A table of readings, one row a tooth.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = table_file_keys)]
pub struct TableFileSpec {
    /// A table.
    pub file: String,
    /// Sheet of any .xlsx file that has several such tables.
    pub sheet: Option<String>,
    /// Line of the header of any table, where its names do not tell; 0 where there is none.
    #[schemars(range(min = 0, max = 1_048_576))]
    pub header_row: Option<u32>,
    /// Column of the tooth numbers of any table, by heading or letter, where it is not found.
    pub tooth_column: Option<String>,
    /// Column of the values of any table but pitch, by heading or letter, where it is not found.
    pub column: Option<String>,
    /// Decimal sign of any text table, "." or ",", where nothing in it tells.
    pub decimal: Option<Decimal>,
}

/// A table of any kind, by itself.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "AnyTableSpec")]
pub struct Choice {
    /// Which table.
    #[serde(flatten)]
    pub table: TableFileSpec,
    /// Column of the left flanks.
    pub left: Option<String>,
    /// Column of the right flanks.
    pub right: Option<String>,
}

/// Each key beside `file` requires it.
fn table_file_keys(schema: &mut Schema) {
    let keys = ["sheet", "header_row", TOOTH, "column", "decimal"];
    let needs_file = keys.map(|key| (key.to_owned(), json!({ "required": ["file"] })));
    let needs_file: Map<_, _> = needs_file.into_iter().collect();
    schema.insert("dependencies".to_owned(), needs_file.into());
}

impl Choice {
    /// The keys of `table`.
    pub fn of(table: &Table) -> Choice {
        // The schema allows nothing that serde refuses.
        let choice = Node::Table(table.entries().to_vec()).to();
        choice.unwrap_or_default()
    }

    fn columns(&self) -> [(&'static str, Option<&str>); 4] {
        [
            (TOOTH, self.table.tooth_column.as_deref()),
            ("left", self.left.as_deref()),
            ("right", self.right.as_deref()),
            ("column", self.table.column.as_deref()),
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
        let row = self.table.header_row.map(|_| "header_row");
        let mut columns = self.columns().into_iter();
        row.or(columns.find(|(_, name)| name.is_some()).map(|(key, _)| key))
    }
}

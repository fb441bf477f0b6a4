//! Keys that stand beside `file`: they say where in the file the table is, if the file alone does not.

use super::number::Decimal;
use crate::problems::Problems;
use crate::table::Table;

/// Lines of a file, as many as a spreadsheet has; 0: none names the columns.
const LINES: std::ops::RangeInclusive<u32> = 0..=1_048_576;
/// The decimal signs as the pair file states them.
const DECIMALS: [(&str, Decimal); 2] = [(".", Decimal::Point), (",", Decimal::Comma)];
/// The keys that name a column.
const COLUMNS: [&str; 4] = [TOOTH, "left", "right", "column"];
/// The key that names the column of tooth numbers.
pub const TOOTH: &str = "tooth_column";

/// Values of those keys.
#[derive(Debug, Clone, Default)]
pub struct Choice<'a> {
    pub sheet: Option<&'a str>,
    /// The line of the header, from 1; 0 where the file has none.
    pub header_row: Option<u64>,
    pub decimal: Option<Decimal>,
    columns: Vec<(&'static str, &'a str)>,
}

impl<'a> Choice<'a> {
    /// Reads the keys of `table`; `None` where one is wrong.
    pub fn read(table: &Table<'a>, problems: &mut Problems) -> Option<Choice<'a>> {
        let sheet = table.optional_as("sheet", problems, |entry| {
            entry.text("give the name of the sheet")
        });
        let help = "give the line that names the columns, from 1; 0: none does";
        let header_row =
            table.optional_as("header_row", problems, |entry| entry.whole(LINES, help));
        let decimal = table.optional_as("decimal", problems, |entry| entry.choice(&DECIMALS));
        let help = "give the heading of the column in quotes, or its letter";
        let columns = COLUMNS.map(|key| {
            let named = table.optional_as(key, problems, |entry| entry.text(help))?;
            Some(named.map(|name| (key, name)))
        });
        let columns: Option<Vec<_>> = columns.into_iter().collect();
        Some(Choice {
            sheet: sheet?,
            header_row: header_row?.map(u64::from),
            decimal: decimal?,
            columns: columns?.into_iter().flatten().collect(),
        })
    }

    /// The column that `key` names.
    pub fn column(&self, key: &str) -> Option<&'a str> {
        let mut columns = self.columns.iter();
        columns
            .find(|(known, _)| *known == key)
            .map(|(_, name)| *name)
    }

    /// A given key that only a table of cells can have.
    pub fn of_cells(&self) -> Option<&'static str> {
        let row = self.header_row.map(|_| "header_row");
        row.or(self.columns.first().map(|(key, _)| *key))
    }
}

/// Keys that name a table; others may stand beside them.
pub const KEYS: &[&str] = &[
    "file",
    "sheet",
    "header_row",
    "tooth_column",
    "column",
    "decimal",
];

/// The keys of a table that has its `own` ones beside [`KEYS`].
pub const fn keys_beside<const OWN: usize, const ALL: usize>(
    own: [&'static str; OWN],
) -> [&'static str; ALL] {
    assert!(OWN + KEYS.len() == ALL);
    let mut all = [""; ALL];
    let mut at = 0;
    while at < ALL {
        all[at] = if at < OWN { own[at] } else { KEYS[at - OWN] };
        at += 1;
    }
    all
}

/// Checks that no key describes a file that `table` does not name.
pub fn without_file(table: &Table, problems: &mut Problems) -> Option<()> {
    let mut keys = KEYS.iter().chain(&["left", "right"]);
    let Some(name) = keys.find(|name| table.has(name)) else {
        return Some(());
    };
    problems.add(table.problem(name, "given without `file`", "add the file, or remove it"));
    None
}

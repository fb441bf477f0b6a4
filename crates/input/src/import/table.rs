//! One table of a file: its content, place and columns.

use crate::unit_slips;
use gearlash_tables::{Origin, Quantity, Row, Sheet};
use serde::Serialize;

/// The content of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Pitch deviation of both flanks.
    Pitch,
    /// Radial runout readings.
    Runout,
    /// Thickness of each tooth.
    Thickness,
    /// Spans all round.
    Span,
    /// Dimensions over pins all round.
    OverPins,
    /// Profile traces.
    Trace,
    /// Lead traces.
    Lead,
}

impl Kind {
    /// All, each by its name on a command line.
    pub const NAMED: [(&'static str, Kind); 7] = [
        ("pitch", Kind::Pitch),
        ("runout", Kind::Runout),
        ("thickness", Kind::Thickness),
        ("span", Kind::Span),
        ("over-pins", Kind::OverPins),
        ("trace", Kind::Trace),
        ("lead", Kind::Lead),
    ];
}

/// One table.
#[derive(Debug, Clone, Serialize)]
pub struct ImportedTable {
    /// Its content.
    pub kind: Kind,
    /// Its name in words.
    pub title: String,
    /// "single" or "cumulative" for pitch, where the table states it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_kind: Option<&'static str>,
    /// Its place in the file, and what the file states of it; none in a protocol.
    #[serde(skip)]
    pub(super) origin: Option<Origin>,
    /// Its sheet, where a workbook has several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<String>,
    /// The line of its header; none in a protocol.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub header_row: Option<u64>,
    /// The parts of the file outside the table, in words for people.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_out: Option<String>,
    /// The letter of the first column of numbers that is left out.
    #[serde(skip)]
    pub left_out_numbers: Option<String>,
    /// Columns that are part of another table of the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub in_other_table: Option<String>,
    /// Its columns, all with the same number of values.
    pub columns: Vec<ImportedColumn>,
}

/// One column.
#[derive(Debug, Clone, Serialize)]
pub struct ImportedColumn {
    /// Its quantity, with its unit: `tooth`, `right_um`.
    pub name: &'static str,
    /// Its heading in the file, and its letter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<(String, String)>,
    /// One value per row.
    pub values: Vec<Value>,
}

/// A value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A tooth.
    Whole(u32),
    /// A deviation or a length.
    Number(f64),
    /// A flank.
    Word(&'static str),
    /// Nothing.
    None,
}

impl ImportedTable {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// The warning of a column whose numbers look like another unit than µm.
    pub fn unit_slip(&self) -> Option<String> {
        let columns = self.columns.iter();
        let columns = columns.filter(|column| column.name.ends_with("_um"));
        let numbers = columns.flat_map(|column| {
            let numbers = column.values.iter().filter_map(|value| match value {
                Value::Number(number) => Some(*number),
                _ => None,
            });
            numbers.map(|number| (column.name, number))
        });
        let (name, value) = numbers.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()))?;
        unit_slips::in_unit(name, "um", value)
    }

    /// The one number in the heading of its values, such as the teeth in "Wk 3 [mm]" or "Zahnweite über 3 Zähne".
    pub(super) fn spanned(&self) -> Option<u32> {
        let (heading, _) = self.columns.get(1)?.heading.as_ref()?;
        let numbers = heading.split(|c: char| !c.is_ascii_digit());
        let mut numbers = numbers.filter_map(|digits| digits.parse().ok());
        numbers.next().filter(|_| numbers.next().is_none())
    }

    /// The table of `sheet`, its value columns called `names`.
    pub(super) fn of(
        kind: Kind,
        title: String,
        names: &[&'static str],
        sheet: &Sheet,
    ) -> ImportedTable {
        let heading = |place: usize| Some(sheet.origin.as_ref()?.columns.get(place)?.clone());
        let tooth = sheet.teeth().into_iter().map(Value::Whole).collect();
        let numbers = |place| sheet.values(place).into_iter().map(Value::Number).collect();
        let values = names.iter().enumerate();
        let values = values.map(|(place, name)| (*name, numbers(place)));
        let columns = [("tooth", tooth)].into_iter().chain(values).enumerate();
        let columns = columns.map(|(place, (name, values))| ImportedColumn {
            name,
            heading: heading(place),
            values,
        });
        ImportedTable::with_columns(kind, title, columns.collect(), sheet)
    }

    pub(super) fn of_traces(kind: Kind, sheet: &Sheet) -> ImportedTable {
        let tooth = |row: &Row| row.tooth.map_or(Value::None, Value::Whole);
        let flank = |row: &Row| {
            row.flank
                .map_or(Value::None, |flank| Value::Word(flank.name()))
        };
        let numbers = |place| sheet.values(place).into_iter().map(Value::Number).collect();
        let at = match sheet.columns.first().map(|column| column.quantity) {
            Some(Quantity::Diameter) => "diameter_mm",
            Some(Quantity::Height) => "from_reference_face_mm",
            _ => "roll_length_mm",
        };
        let columns: [(&str, Vec<Value>); 4] = [
            ("tooth", sheet.rows.iter().map(tooth).collect()),
            ("flank", sheet.rows.iter().map(flank).collect()),
            (at, numbers(0)),
            ("deviation_um", numbers(1)),
        ];
        let is_there =
            |(_, values): &(&str, Vec<Value>)| values.iter().any(|value| *value != Value::None);
        let columns = columns.into_iter().filter(is_there);
        let columns = columns.map(|(name, values)| ImportedColumn {
            name,
            heading: None,
            values,
        });
        let title = match kind {
            Kind::Lead => "Lead traces, mm and µm",
            _ => "Profile traces, mm and µm",
        };
        ImportedTable::with_columns(kind, title.to_owned(), columns.collect(), sheet)
    }

    fn with_columns(
        kind: Kind,
        title: String,
        columns: Vec<ImportedColumn>,
        sheet: &Sheet,
    ) -> ImportedTable {
        let origin = sheet.origin.clone();
        ImportedTable {
            kind,
            title,
            pitch_kind: None,
            sheet: origin.as_ref().and_then(|origin| origin.sheet.clone()),
            header_row: origin.as_ref().map(|origin| origin.header_row),
            origin,
            left_out: sheet.header.unread().map(str::to_owned),
            left_out_numbers: None,
            in_other_table: None,
            columns,
        }
    }

    /// Tells columns of other `tables` from those that are left out; a protocol has none.
    pub(super) fn exclude_columns_of(&mut self, tables: &[ImportedTable]) {
        let Some(Origin { unread, .. }) = &self.origin else {
            return;
        };
        let place = |table: &ImportedTable| (table.sheet.clone(), table.header_row);
        let own = place(self);
        let same = tables.iter().filter(|table| place(table) == own);
        let headings = same.flat_map(|table| &table.columns);
        let letters = headings.filter_map(|column| Some(&column.heading.as_ref()?.1[..]));
        let letters: Vec<&str> = letters.collect();
        self.left_out = unread.words(&letters);
        self.left_out_numbers = unread.first_number_column(&letters);
        self.in_other_table = unread.elsewhere(&letters);
    }
}

//! One table of a file: what it holds, where it stands, and its columns.

use crate::sheet::{Column, Header, Origin, Sheet, TraceSheet};
use serde::Serialize;

/// What a table holds.
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
}

/// One table.
#[derive(Debug, Clone, Serialize)]
pub struct ImportedTable {
    /// What it holds.
    pub kind: Kind,
    /// Its name in words.
    pub title: String,
    /// Of pitch, "single" or "cumulative" where the table says it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_kind: Option<&'static str>,
    /// Of a workbook that has several, its sheet.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<String>,
    /// The line of its header; none in a protocol.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub header_row: Option<u64>,
    /// What of the file is no part of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_out: Option<String>,
    /// Its columns, as many values in each.
    pub columns: Vec<ImportedColumn>,
}

/// One column.
#[derive(Debug, Clone, Serialize)]
pub struct ImportedColumn {
    /// What it is, with its unit: `tooth`, `right_um`.
    pub name: &'static str,
    /// Its heading in the file, and its letter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<(String, String)>,
    /// A value a row.
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
    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    pub(super) fn of<const N: usize>(
        kind: Kind,
        title: String,
        names: [&'static str; N],
        sheet: &Sheet<N>,
    ) -> ImportedTable {
        let heading = |place: usize| Some(sheet.origin.as_ref()?.columns.get(place)?.clone());
        let tooth = sheet.rows.iter().map(|row| Value::Whole(row.tooth));
        let mut columns = vec![ImportedColumn {
            name: "tooth",
            heading: heading(0),
            values: tooth.collect(),
        }];
        for (place, name) in names.into_iter().enumerate() {
            columns.push(ImportedColumn {
                name,
                heading: heading(place + 1),
                values: sheet.values(place).into_iter().map(Value::Number).collect(),
            });
        }
        ImportedTable {
            kind,
            title,
            pitch_kind: None,
            sheet: sheet
                .origin
                .as_ref()
                .and_then(|origin| origin.sheet.clone()),
            header_row: sheet.origin.as_ref().map(|origin| origin.header_row),
            left_out: left_out(sheet.origin.as_ref(), &sheet.header),
            columns,
        }
    }
}

/// What of the file is no part of a table, in words.
fn left_out(origin: Option<&Origin>, header: &Header) -> Option<String> {
    match origin {
        Some(origin) => origin.left_out.clone(),
        None => header.unused().map(str::to_owned),
    }
}

pub(super) fn traced(traces: &TraceSheet) -> ImportedTable {
    let rows = &traces.rows;
    let origin = traces.origin.as_ref();
    let tooth = rows
        .iter()
        .map(|row| row.tooth.map_or(Value::None, Value::Whole));
    let flank = rows.iter().map(|row| {
        row.flank
            .map_or(Value::None, |flank| Value::Word(flank.name()))
    });
    let at = match traces.by {
        Column::Diameter => "diameter_mm",
        _ => "roll_length_mm",
    };
    let columns: [(&str, Vec<Value>); 4] = [
        ("tooth", tooth.collect()),
        ("flank", flank.collect()),
        (
            at,
            rows.iter().map(|row| Value::Number(row.at_mm)).collect(),
        ),
        (
            "deviation_um",
            rows.iter()
                .map(|row| Value::Number(row.deviation_um))
                .collect(),
        ),
    ];
    let there = columns
        .into_iter()
        .filter(|(_, values)| values.iter().any(|value| *value != Value::None));
    ImportedTable {
        kind: Kind::Trace,
        title: "Profile traces, mm and µm".to_owned(),
        pitch_kind: None,
        sheet: origin.and_then(|origin| origin.sheet.clone()),
        header_row: origin.map(|origin| origin.header_row),
        left_out: left_out(origin, &traces.header),
        columns: there
            .map(|(name, values)| ImportedColumn {
                name,
                heading: None,
                values,
            })
            .collect(),
    }
}

//! The understood content of a file, as text.

use crate::layout::{Column, Screen, Table};
use gearlash_files::characters::line;
use gearlash_files::import::{Imported, ImportedTable, Value};
use gearlash_files::numbers::rounded;
use std::fmt::Write;

/// The tables of a file, and the lines of a pair file that name them.
pub fn imported(imported: &Imported, screen: &Screen) -> String {
    let mut text = String::new();
    for table in &imported.tables {
        text += &screen.fold(&origin(table));
        text += &values(table).text(screen);
        text.push('\n');
    }
    for reason in &imported.not_read {
        text += &screen.fold(&format!("Not read: {}\n\n", line(reason)));
    }
    let _ = writeln!(text, "For a pair file beside {}:", line(&imported.file));
    // Not folded, because users copy it.
    text + "\n" + &imported.toml
}

/// The name and place of a table, and the parts that were left out.
fn origin(table: &ImportedTable) -> String {
    let sheet = table.sheet.as_ref();
    let sheet = sheet.map(|name| format!(", sheet {:?}", line(name)));
    let row = table.header_row.map(|row| match row {
        0 => ", no header".to_owned(),
        row => format!(", header in line {row}"),
    });
    let mut text = format!(
        "{}: {} rows{}{}\n",
        table.title,
        table.rows(),
        sheet.unwrap_or_default(),
        row.unwrap_or_default()
    );
    let named = table.columns.iter().filter_map(|column| {
        let (heading, letter) = column.heading.as_ref()?;
        Some(match &heading[..] {
            "" => format!("{} = {letter}", column.name),
            heading => format!("{} = {:?} ({letter})", column.name, line(heading)),
        })
    });
    let named: Vec<String> = named.collect();
    if !named.is_empty() {
        let _ = writeln!(text, "  read: {}", named.join(", "));
    }
    if let Some(words) = &table.left_out {
        let _ = writeln!(text, "  left out: {}", line(words));
    }
    if let Some(words) = &table.in_other_table {
        let _ = writeln!(text, "  in another table: {}", line(words));
    }
    text
}

fn values(table: &ImportedTable) -> Table {
    let headings = table.columns.iter().map(|column| Column::new(column.name));
    let mut shown = Table::new(headings);
    for row in 0..table.rows() {
        let cell = |value: Option<&Value>| match value {
            Some(Value::Whole(tooth)) => tooth.to_string(),
            // Rounded to a thousandth of a nanometre, without the sign of zero.
            Some(Value::Number(number)) => rounded(*number, 6).to_string(),
            Some(Value::Word(word)) => (*word).to_owned(),
            Some(Value::None) | None => String::new(),
        };
        let cells = table.columns.iter();
        shown.add(cells.map(|column| cell(column.values.get(row))).collect());
    }
    shown
}

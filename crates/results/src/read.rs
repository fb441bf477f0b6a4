//! The understood content of a file of measurements, a drawing or a gearbox model, as text.

use crate::column::{Row, row_type, shown};
use crate::layout::{Column, Screen, Table};
use gearlash_input::import::{Imported, ImportedTable, Value};
use gearlash_input::outlines::{ListedOutline, ListedOutlines};
use gearlash_rexs::{RexsFile, RexsPair, RexsStage};
use gearlash_text::characters::{line, plain};
use gearlash_text::numbers::rounded;
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
    let mut tables = imported.tables.iter();
    let left_out = |table: &ImportedTable| {
        let (_, teeth) = table.columns.first()?.heading.clone()?;
        Some([teeth, table.left_out_numbers.clone()?])
    };
    if let Some([teeth, letter]) = tables.find_map(left_out) {
        text += &screen.fold(&format!(
            "To read a column that is left out, name it: --only runout --column {letter}. Pitch has two: --only pitch --tooth-column {teeth} --left {letter} --right …\n\n"
        ));
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
    if let Some(words) = table.unit_slip() {
        let _ = writeln!(text, "  warning: {words}; or write the unit in its heading");
    }
    if let Some(words) = &table.left_out {
        let _ = writeln!(text, "  left out: {}", line(words));
    }
    if let Some(words) = &table.in_other_table {
        let _ = writeln!(text, "  read into another table: {}", line(words));
    }
    text
}

fn values(table: &ImportedTable) -> Table {
    let cell = |value: Option<&Value>| match value {
        Some(Value::Whole(tooth)) => tooth.to_string(),
        // Rounded to a thousandth of a nanometre, without the sign of zero.
        Some(Value::Number(number)) => rounded(*number, 6).to_string(),
        Some(Value::Word(word)) => (*word).to_owned(),
        Some(Value::None) | None => String::new(),
    };
    let columns = table.columns.iter().map(|column| {
        let cells = (0..table.rows()).map(|row| cell(column.values.get(row)));
        (Column::new(column.name), cells.collect())
    });
    Table(columns.collect())
}

row_type!(row: (usize, ListedOutline) {
    "" Plain [heading(shown("number"))] => row.0;
    "" Name [heading(shown("layer or id").left())] => row.1.name.clone();
    "" Name [heading(shown("from, mm").left())] => row.1.start.clone();
    "" Plain [heading(shown("size, mm").left())] => format!("{:.3} x {:.3}", row.1.size_mm.x, row.1.size_mm.y);
    "" Plain [heading(shown("parts"))] => row.1.parts;
    "" Plain [heading(shown("inside"))] => row.1.inside;
    "" Name [heading(shown("at").left().spare(1))] => row.1.place.clone();
});

/// The outlines of the drawing called `name`, and the table of the gear `gear` that names one of them; of the wheel and one more, both gears.
pub fn listed_outlines(
    name: &str,
    drawing: &ListedOutlines,
    gear: &str,
    screen: &Screen,
) -> String {
    let rows: Vec<(usize, ListedOutline)> = (1..).zip(drawing.outlines.clone()).collect();
    let mut text = format!(
        "{}: {} {}, 1 unit is {} mm\n\n{}",
        plain(name),
        rows.len(),
        if rows.len() == 1 {
            "outline"
        } else {
            "outlines"
        },
        drawing.unit_mm,
        Row::columns().text(&rows, screen)
    );
    for remark in &drawing.remarks {
        text += &format!("\n{}\n", plain(remark));
    }
    let gears = match (gear, rows.len()) {
        ("wheel", 2) => vec![gear, "pinion"],
        _ => vec![gear],
    };
    for ((number, outline), gear) in rows.iter().zip(gears) {
        text += &format!("\n[{gear}.outline]\nfile = {name:?}\n");
        if let Some(units) = &drawing.units {
            text += &format!("units = {units:?}\n");
        }
        if rows.len() > 1 {
            text += &format!("number = {number}  # of {}\n", rows.len());
        }
        if rows.len() > 1 || !outline.is_centred {
            text += "center_mm = \"fit\"\n";
        }
    }
    if let Some(mm) = drawing.mesh_distance_mm {
        text += &format!("\n[assembly]\ncenter_distance_mm = {mm:.4}  # as drawn\n");
    }
    text
}

row_type!(row: RexsStage {
    "" Plain [heading(shown("stage"))] => row.id.to_string();
    "" Name [heading(shown("kind").left().spare(1))] => row.kind.clone();
    "" Name [heading(shown("name").left().spare(2))] => row.name.clone();
    "" Plain [heading(shown("").left())] => if row.pair.is_ok() { "pair file" } else { "left out" };
    "" Name [heading(shown("became").left().below())] => row.pair.as_ref().map_or_else(String::clone, |pair| pair.summary.clone());
});

/// The stages of the gearbox model called `name` with their results, and the parts that were left out.
pub fn gearbox(name: &str, file: &RexsFile, screen: &Screen) -> String {
    let pairs = file.stages.iter().filter(|stage| stage.pair.is_ok());
    let mut text = format!(
        "{}: REXS {} of {}, {} of {} stages can be read\n\n",
        plain(name),
        plain(&file.version),
        plain(&file.application),
        pairs.count(),
        file.stages.len()
    );
    if !file.stages.is_empty() {
        text += &RexsStage::columns().text(&file.stages, screen);
    }
    if !file.left_out.is_empty() {
        let each = file.left_out.iter();
        let each = each.map(|(kind, count)| format!("{count} {}", plain(kind)));
        text += &format!("\nLeft out: {}\n", each.collect::<Vec<_>>().join(", "));
    }
    screen.fold(&text)
}

/// The used and unused data of a stage.
pub fn gearbox_pair(pair: &RexsPair, screen: &Screen) -> String {
    let mut text = String::new();
    for (component, ids) in &pair.unused {
        text += &format!("Not used of {component}: {}\n", ids.join(", "));
    }
    for remark in &pair.remarks {
        text += &format!("Note: {remark}\n");
    }
    screen.fold(&text)
}

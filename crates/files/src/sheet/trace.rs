//! Profile traces in a table: roll length or diameter and deviation, a row a point, perhaps with the tooth and the flank.

use super::cell::{Cell, Line};
use super::column::{self, Column, Named};
use super::decimal::{self, Numbers};
use super::grid::{Grid, wrong_cell};
use super::places::slots;
use super::wanted::{Coverage, Wanted};
use super::{Content, content};
use crate::data_file::DataFile;
use crate::entry::whole_in;
use crate::problems::Problems;
use crate::table::Table;
use gearlash::gear::Flank;
use std::ops::RangeBounds;

/// Names of the column that says which flank.
const FLANK: &[&str] = &["flank", "flanke"];
/// What stands in it.
const FLANKS: [(&str, Flank); 4] = [
    ("right", Flank::Right),
    ("left", Flank::Left),
    ("rechts", Flank::Right),
    ("links", Flank::Left),
];
const HELP: &str = "name the columns roll_length_mm or diameter_mm, deviation_um, and tooth and flank where needed";

/// A point of a trace.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceRow {
    /// The line it stands in.
    pub line: u64,
    pub tooth: Option<u32>,
    pub flank: Option<Flank>,
    /// Roll length or diameter, mm.
    pub at_mm: f64,
    pub deviation_um: f64,
}

/// A table of traces.
#[derive(Debug)]
pub struct TraceSheet {
    pub file: DataFile,
    pub rows: Vec<TraceRow>,
    /// What the rows say where they are: [`Column::RollLength`] or [`Column::Diameter`].
    pub by: Column,
}

/// Where the columns stand.
struct Places {
    tooth: Option<usize>,
    flank: Option<usize>,
    at: usize,
    deviation: usize,
    by: Column,
}

impl TraceSheet {
    /// Reads the file that `table` names under `file`; all that is wrong with its cells is added to `problems`, with line numbers.
    pub fn read(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<TraceSheet> {
        let needed = "the name of a table, such as \"trace.csv\"";
        let file = DataFile::of(table, needed, problems)?;
        let mut bad = Problems::of_list();
        let read = rows(&file, table, teeth, &mut bad);
        let good = bad.is_empty();
        problems.add_list(file.key(), bad);
        let (rows, by) = read.filter(|_| good)?;
        Some(TraceSheet { file, rows, by })
    }
}

fn rows(
    file: &DataFile,
    table: &Table,
    teeth: Option<u32>,
    problems: &mut Problems,
) -> Option<(Vec<TraceRow>, Column)> {
    let (content, stated) = content(file, table, problems)?;
    let Content::Cells(grid) = content else {
        problems.add(file.problem(
            "is a protocol of pitch, expected is a table of traces",
            HELP,
        ));
        return None;
    };
    let places = places(&grid.header, file, problems)?;
    let wanted = Wanted {
        columns: [places.by, Column::Deviation],
        teeth,
        coverage: Coverage::SomeTeeth,
    };
    let mut all = Some(Vec::new());
    for line in &grid.lines {
        // All lines are read before the first bad one ends it.
        match (row(&grid, line, file, &places, &wanted, problems), &mut all) {
            (Some(row), Some(rows)) => rows.push(row),
            _ => all = None,
        }
    }
    let (rows, numbers): (Vec<TraceRow>, Vec<Numbers<'_, 2>>) = all?.into_iter().unzip();
    decimal::check(file, &numbers, &wanted, (stated, grid.decimal), problems)?;
    if rows.is_empty() {
        problems.add(file.problem("no rows below the header", "add a row for each point"));
        return None;
    }
    Some((rows, places.by))
}

/// One line: the point, and its numbers as written.
fn row<'a>(
    grid: &Grid,
    line: &'a Line,
    file: &DataFile,
    places: &Places,
    wanted: &Wanted<2>,
    problems: &mut Problems,
) -> Option<(TraceRow, Numbers<'a, 2>)> {
    let (columns, found) = (grid.header.cells.len(), line.cells.len());
    if found != columns {
        let reason = format!("{found} values, the header names {columns} columns");
        problems.add(file.problem_at(line.number, reason, "give every column one value"));
        return None;
    }
    let mut good = Some(());
    let mut wrong = |name: &str, cell: &Cell, allowed: &str| {
        problems.add(wrong_cell(file, line.number, name, cell, allowed));
        good = None;
    };
    let teeth = 1..=wanted.teeth.unwrap_or(10_000);
    let tooth = places.tooth.map(|place| {
        let cell = &line.cells[place];
        let tooth = cell.tooth().filter(|tooth| teeth.contains(tooth));
        if tooth.is_none() {
            wrong("tooth", cell, &whole_in(&teeth));
        }
        tooth
    });
    let flank = places.flank.map(|place| {
        let cell = &line.cells[place];
        let text = match cell {
            Cell::Text(text) | Cell::TextBelow(text) => text.trim().to_lowercase(),
            _ => String::new(),
        };
        let found = FLANKS.into_iter().find(|(name, _)| *name == text);
        if found.is_none() {
            wrong("flank", cell, "right or left");
        }
        found.map(|(_, flank)| flank)
    });
    let [at, deviation] = [places.at, places.deviation].map(|place| &line.cells[place]);
    let [at, deviation] =
        [(at, wanted.columns[0]), (deviation, wanted.columns[1])].map(|(cell, column)| {
            let limits = column.limits();
            let number = cell.number();
            let number = number.filter(|number| limits.range.contains(&number.value));
            if number.is_none() {
                wrong(column.names()[0], cell, limits.allowed);
            }
            number
        });
    good?;
    let (at, deviation) = (at?, deviation?);
    let row = TraceRow {
        line: line.number,
        tooth: tooth.flatten(),
        flank: flank.flatten(),
        at_mm: at.value,
        deviation_um: deviation.value,
    };
    let numbers = Numbers {
        line: line.number,
        tooth: row.tooth.unwrap_or(1),
        values: [at, deviation],
    };
    Some((row, numbers))
}

fn places(header: &Line, file: &DataFile, problems: &mut Problems) -> Option<Places> {
    const COLUMNS: [Column; 3] = [Column::RollLength, Column::Diameter, Column::Deviation];
    // The tooth, the flank, and behind them those.
    let slot = |text: &str| {
        if FLANK.contains(&text.trim().to_lowercase().as_str()) {
            return Ok(1);
        }
        match column::named(file, text, &COLUMNS) {
            Named::Tooth => Ok(0),
            Named::Wanted(index) => Ok(2 + index),
            Named::Wrong(reason, help) => Err((reason, help)),
        }
    };
    let (found, good) = slots(header, file, HELP, 2 + COLUMNS.len(), slot, problems);
    let [tooth, flank, roll, diameter, deviation] = found[..] else {
        return None;
    };
    let is_both = roll.is_some() && diameter.is_some();
    if is_both {
        let reason = "columns roll length and diameter, allowed is one of them";
        let help = "remove one: they say the same";
        problems.add(file.problem_at(header.number, reason, help));
    }
    if is_both || !good {
        return None;
    }
    let at = roll.or(diameter);
    for (name, place) in [("roll length or diameter", at), ("deviation", deviation)] {
        if place.is_none() {
            let reason = format!("column {name} is missing");
            problems.add(file.problem_at(header.number, reason, HELP));
        }
    }
    Some(Places {
        tooth,
        flank,
        at: at?,
        deviation: deviation?,
        by: match roll {
            Some(_) => Column::RollLength,
            None => Column::Diameter,
        },
    })
}

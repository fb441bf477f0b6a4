//! Profile traces in a table: roll length or diameter and deviation, a row a point, perhaps with the tooth and the flank.

use super::cell::{Cell, Line};
use super::column::Column;
use super::decimal::{self, Numbers};
use super::grid::{FoundTable, one_of, wrong_cell};
use super::head::Head;
use super::heading::{self, Quantity};
use super::places::{one, several};
use super::wanted::{Coverage, TraceRow, Wanted};
use super::{Choice, Content, Header, Origin, p40, read_with};
use crate::data_file::DataFile;
use crate::entry::whole_in;
use crate::problems::Problems;
use crate::table::Table;
use gearlash::gear::{Flank, Side};
use std::ops::RangeBounds;

const HELP: &str = "name the columns roll_length_mm or diameter_mm, deviation_um, and tooth and flank where needed";

/// A table of traces.
#[derive(Debug)]
pub struct TraceSheet {
    pub file: DataFile,
    pub rows: Vec<TraceRow>,
    /// What the rows say where they are: [`Column::RollLength`] or [`Column::Diameter`].
    pub by: Column,
    /// What it says of the gear.
    pub header: Header,
    /// Where the table stands; `None`: in a curve file.
    pub origin: Option<Origin>,
}

/// Where the columns stand.
#[derive(Clone, Copy)]
struct Places {
    tooth: Option<usize>,
    flank: Option<usize>,
    at: usize,
    deviation: usize,
    by: Column,
}

impl TraceSheet {
    /// Reads the file that `table` names under `file`; all that is wrong with its cells is added to `problems`, with line numbers.
    pub fn read(
        table: &Table,
        teeth: Option<u32>,
        base: Option<f64>,
        problems: &mut Problems,
    ) -> Option<TraceSheet> {
        let read = read_with(
            table,
            "trace.csv",
            problems,
            |content, file, choice, bad| TraceSheet::of(content, file, choice, (teeth, base), bad),
        );
        let sheet = read?;
        match &sheet.origin {
            Some(origin) => table.place().add_remark(origin.remark(&sheet.file)),
            None => table.place().add_remark(sheet.header.remark()),
        }
        Some(sheet)
    }

    /// The traces of what a file holds.
    pub fn of(
        content: &Content,
        file: &DataFile,
        choice: &Choice,
        (teeth, base): (Option<u32>, Option<f64>),
        problems: &mut Problems,
    ) -> Option<TraceSheet> {
        if let Content::P40(text) = content {
            let (rows, header) = p40::profiles(file, text, (teeth, base), problems)?;
            return Some(TraceSheet {
                file: file.clone(),
                rows,
                by: Column::RollLength,
                header,
                origin: None,
            });
        }
        let Content::Cells(grids) = content else {
            problems.add(file.problem(
                "is a protocol of pitch, expected is a table of traces",
                HELP,
            ));
            return None;
        };
        let columns = [Column::RollLength, Column::Deviation];
        let is_head = |head: &Head| is_head(head, choice);
        let (grid, head) = one_of(grids, file, choice, is_head, &columns, problems)?;
        let places = places(&head, file, choice, problems)?;
        let used = [places.tooth, Some(places.at), Some(places.deviation)];
        let used: Vec<usize> = used.into_iter().flatten().collect();
        let beside: Vec<usize> = places.flank.into_iter().collect();
        let found = FoundTable::below(grid, head, [&used, &beside], file, problems)?;
        let wanted = Wanted {
            columns: [places.by, Column::Deviation],
            teeth,
            coverage: Coverage::SomeTeeth,
        };
        let mut all = Some(Vec::new());
        for line in &found.rows {
            // All lines are read before the first bad one ends it.
            match (
                row(&found, line, file, &places, &wanted, problems),
                &mut all,
            ) {
                (Some(row), Some(rows)) => rows.push(row),
                _ => all = None,
            }
        }
        let (rows, numbers): (Vec<TraceRow>, Vec<Numbers<'_, 2>>) = all?.into_iter().unzip();
        decimal::check(
            file,
            &numbers,
            &wanted,
            (choice.decimal, grid.decimal),
            problems,
        )?;
        if rows.is_empty() {
            problems.add(file.problem("no rows below the header", "add a row for each point"));
            return None;
        }
        Some(TraceSheet {
            file: file.clone(),
            rows,
            by: places.by,
            origin: Some(Origin::of(&found, grids, &used, file)),
            header: Header::default(),
        })
    }
}

/// Whether `head` names where and how much.
pub fn is_head(head: &Head, choice: &Choice) -> bool {
    let has = |column| !head.places_of(column, choice).is_empty();
    has(Column::Deviation) && (has(Column::RollLength) || has(Column::Diameter))
}

/// One line: the point, and its numbers as written.
fn row<'a>(
    found: &FoundTable,
    line: &'a Line,
    file: &DataFile,
    places: &Places,
    wanted: &Wanted<2>,
    problems: &mut Problems,
) -> Option<(TraceRow, Numbers<'a, 2>)> {
    found.check_width(file, line, problems)?;
    let mut good = Some(());
    let mut wrong = |name: &str, cell: &Cell, allowed: &str| {
        problems.add(wrong_cell(file, line.number, name, cell, allowed));
        good = None;
    };
    let teeth = 1..=wanted.teeth.unwrap_or(10_000);
    let tooth = places.tooth.map(|place| {
        let cell = line.cell(place);
        let tooth = cell.tooth().filter(|tooth| teeth.contains(tooth));
        if tooth.is_none() {
            wrong("tooth", cell, &whole_in(&teeth));
        }
        tooth
    });
    let flank = places.flank.map(|place| {
        let cell = line.cell(place);
        let found = match cell {
            Cell::Text(text) => heading::side(text),
            _ => None,
        };
        if found.is_none() {
            wrong("flank", cell, "right or left");
        }
        found.map(|side| match side {
            Side::Right => Flank::Right,
            Side::Left => Flank::Left,
        })
    });
    let [at, deviation] = [places.at, places.deviation].map(|place| line.cell(place));
    let [at, deviation] =
        [(at, wanted.columns[0]), (deviation, wanted.columns[1])].map(|(cell, column)| {
            let limits = column.limits();
            let number = cell.number();
            let number = number.filter(|number| limits.range.contains(&number.value));
            if number.is_none() {
                wrong(column.name(), cell, limits.allowed);
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

fn places(
    head: &Head,
    file: &DataFile,
    choice: &Choice,
    problems: &mut Problems,
) -> Option<Places> {
    let mut optional = |name: &str, places: Vec<usize>| match *places {
        [] => Some(None),
        [place] => Some(Some(place)),
        _ => {
            problems.add(several(head, file, name, "tooth_column", &places));
            None
        }
    };
    let tooth = optional("tooth", head.teeth(&[], choice));
    let is_flank = |place: &usize| {
        let meaning = head.headings[*place].meaning;
        meaning.is_some_and(|meaning| meaning.quantity == Quantity::Flank)
    };
    let flank = optional("flank", head.all().into_iter().filter(is_flank).collect());
    let [roll, diameter] =
        [Column::RollLength, Column::Diameter].map(|column| head.places_of(column, choice));
    if !roll.is_empty() && !diameter.is_empty() {
        let reason = "columns roll length and diameter, allowed is one of them";
        let help = "remove one: they say the same";
        problems.add(file.problem_at(head.line, reason, help));
        return None;
    }
    let (by, at) = match diameter.is_empty() {
        true => (Column::RollLength, roll),
        false => (Column::Diameter, diameter),
    };
    let at = problems.keep(one(head, file, by, &at, choice));
    let deviation = head.places_of(Column::Deviation, choice);
    let deviation = problems.keep(one(head, file, Column::Deviation, &deviation, choice));
    Some(Places {
        tooth: tooth?,
        flank: flank?,
        at: at?,
        deviation: deviation?,
        by,
    })
}

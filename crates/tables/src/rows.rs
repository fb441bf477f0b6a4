//! Rows of a table: from its lines to numbers, in the order of the teeth; and the parts of the file that are left out.

use super::column::Quantity;
use super::column_header::ColumnHeader;
use super::decimal_sign::{Placed, check_decimal_sign};
use super::grid::{Cell, Grid, Line, letter};
use super::heading;
use super::request::{Coverage, Places, Request, Wanted, names_columns};
use crate::data_file::DataFile;
use gearlash::gear::{Flank, Side};
use gearlash_text::characters::first_of;
use gearlash_text::file_numbers::{Decimal, has_leading_zero};
use std::cell::LazyCell;
use std::ops::{RangeBounds, RangeInclusive};

/// Most lines, columns or teeth that a message lists. Tuned: a message of a few lines.
const MAX_LISTED: usize = 8;
const MAX_TEETH_LISTED: usize = 10;

/// A row: one tooth, or one point of a trace.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Its line in the file.
    pub line: u64,
    /// The tooth; optional for points of traces, `None` for results of a rig.
    pub tooth: Option<u32>,
    /// The flank of a point, where it is named.
    pub flank: Option<Flank>,
    /// The values, in the order of [`Wanted::columns`] and in their units.
    pub values: Vec<f64>,
}

#[derive(Debug)]
pub struct Found<'a> {
    pub grid: &'a Grid,
    pub head: ColumnHeader,
    pub places: Places,
    lines: Vec<&'a Line>,
    /// The parts of the file that are not part of the table.
    pub unread: Unread,
}

impl<'a> Found<'a> {
    /// Finds the table that `request` asks for in `grids`.
    ///
    /// Comments, statistics, lines above the header and remarks below the last row are left out.
    pub fn find(request: &Request, grids: &'a [Grid]) -> Option<Found<'a>> {
        let file = request.file;
        let (grid, head) = request.head(grids)?;
        let places = request.places(&head, &grid.lines)?;
        let used = places.numbers();
        let mut unread = Vec::new();
        // Numbers below another header are of a table of their own.
        let other = LazyCell::new(|| (0..head.at).find(|above| names_columns(&grid.lines, *above)));
        for (at, line) in grid.lines[..head.at].iter().enumerate() {
            let is_number = |place: &usize| line.cell(*place).number().is_some();
            let has_row = used.first().is_some_and(is_number) && used.iter().skip(1).any(is_number);
            if has_row && other.is_none_or(|other| at < other) {
                return file.refuse_at(
                    line.number,
                    format!("has numbers like a row of the table, but stands above its header in line {}", head.line),
                    "move it below the header, or remove it",
                );
            }
            if !(head.has_groups && at + 1 == head.at) {
                unread.push((line.number, ""));
            }
        }
        let mut rows = Vec::new();
        let (from, end) = (head.at + 1 + usize::from(head.has_units), grid.lines.len());
        let next = (from..end).find(|at| request.begins_other_table(&grid.lines, *at));
        let next = next.unwrap_or(end);
        unread.extend(grid.lines[next..].iter().map(|line| (line.number, "")));
        for line in &grid.lines[from..next] {
            if grid.sheet.is_none() && line.cells.iter().any(Cell::has_unbalanced_quote) {
                return file.refuse_at(
                    line.number,
                    "a cell of several lines that hold separators, as if a quotation mark were missing or left over",
                    "correct the quotation marks",
                );
            }
            if is_statistic(line, &used) {
                unread.push((line.number, line.first().text()));
            } else if line.is_comment() {
                unread.push((line.number, ""));
            } else {
                rows.push(line);
            }
        }
        let last = rows.iter().rposition(|line| is_row(line, &used));
        for line in rows.drain(last.map_or(0, |last| last + 1)..) {
            unread.push((line.number, line.first().text()));
        }
        // Whether each column has content, and numbers. One pass reads each cell once.
        let mut filled = vec![[false; 2]; head.headings.len()];
        for line in &rows {
            for (of, cell) in filled.iter_mut().zip(&line.cells) {
                of[0] |= *cell != Cell::Empty;
                of[1] |= cell.number().is_some();
            }
        }
        let beside = [places.flank, places.source];
        let headings = head.headings.iter().enumerate().zip(filled);
        let columns = headings.filter(|((place, heading), [has_content, _])| {
            let is_there = !heading.shown.is_empty() || *has_content;
            is_there && !used.contains(place) && !beside.contains(&Some(*place))
        });
        let columns = columns.map(|((place, _), [_, has_numbers])| UnreadColumn {
            letter: letter(place),
            name: head.shown_one(file, place),
            has_numbers,
        });
        let unread = Unread {
            lines: lines_in_words(file, unread),
            columns: columns.collect(),
        };
        Some(Found {
            grid,
            head,
            places,
            lines: rows,
            unread,
        })
    }

    /// The rows as numbers: by ascending tooth, or points in the order of their lines.
    pub fn rows(&self, request: &Request) -> Option<Vec<Row>> {
        let mut numbers = Vec::new();
        // All lines are read, so that every problem is reported.
        let rows = self
            .lines
            .iter()
            .map(|line| self.row(request, line, &mut numbers));
        let rows: Vec<Option<Row>> = rows.collect();
        let rows: Vec<Row> = rows.into_iter().collect::<Option<_>>()?;
        let signs = [request.choice.table.decimal, self.grid.decimal];
        check_decimal_sign(request.file, &numbers, signs)?;
        ordered(request.file, rows, request.wanted)
    }

    /// The sources of the rows, where the table names them.
    pub fn sources(&self, file: &DataFile) -> Vec<String> {
        let source = |line: &&Line| match self.places.source.map(|place| line.cell(place)) {
            None | Some(Cell::Empty) => String::new(),
            Some(Cell::Text(text)) => text.clone(),
            Some(cell) => cell.shown(file),
        };
        self.lines.iter().map(source).collect()
    }

    /// Checks that a text's row is as wide as the header, and that no number is outside its column.
    fn check_width(&self, file: &DataFile, line: &Line) -> Option<()> {
        let (columns, found) = (self.head.headings.len(), line.cells.len());
        if self.grid.sheet.is_none() && found != columns {
            let help = if self.grid.decimal == Some(Decimal::Point) {
                "give every column one value; in a file separated by commas numbers need a point"
            } else {
                "give every column one value, and nothing else"
            };
            let reason = format!("{found} values, the header names {columns} columns");
            return file.refuse_at(line.number, reason, help);
        }
        let is_named = |place: usize| {
            let heading = self.head.headings.get(place);
            heading.is_some_and(|heading| !heading.shown.is_empty())
        };
        let mut good = Some(());
        for (place, cell) in line.cells.iter().enumerate().skip(1) {
            if cell.number().is_some() && !is_named(place) && is_named(place - 1) {
                let (shown, letter) = (cell.shown(file), letter(place));
                let reason = format!("{shown} is in column {letter}, which has no name");
                file.add_at(line.number, reason, "remove it, or name its column");
                good = None;
            }
        }
        good
    }

    /// One line as a row. Its numbers as written are added to `numbers`.
    fn row(&self, request: &Request, line: &'a Line, numbers: &mut Vec<Placed<'a>>) -> Option<Row> {
        let file = request.file;
        self.check_width(file, line)?;
        let mut good = Some(());
        let mut wrong = |name: &str, cell: &Cell, allowed: &str| {
            let lost = match cell {
                Cell::Text(text) if has_leading_zero(text) => ", as if its decimal sign were lost",
                _ => "",
            };
            let help = if name == "tooth" && *cell == Cell::Empty {
                "correct the line; one of statistics is left out where its first cell says so, such as max"
            } else {
                "correct the line"
            };
            let reason = format!("{name} is {}{lost}, allowed is {allowed}", cell.shown(file));
            file.add_at(line.number, reason, help);
            good = None;
        };
        let teeth = 1..=request.wanted.teeth.unwrap_or(10_000);
        let tooth = self.places.tooth.and_then(|place| {
            let cell = line.cell(place);
            let tooth = cell.tooth().filter(|tooth| teeth.contains(tooth));
            if tooth.is_none() {
                wrong("tooth", cell, &whole_in(&teeth));
            }
            tooth
        });
        let flank = self.places.flank.and_then(|place| {
            let side = heading::side(line.cell(place).text());
            if side.is_none() {
                wrong("flank", line.cell(place), "right or left");
            }
            side
        });
        let mut values = Vec::new();
        for (column, place) in &self.places.values {
            let (cell, limits) = (line.cell(*place), column.limits());
            let teeth = match (request.wanted.coverage, column.quantity) {
                (Coverage::Results { teeth }, Quantity::WheelTooth) => Some(teeth[0]),
                (Coverage::Results { teeth }, Quantity::PinionTooth) => Some(teeth[1]),
                _ => None,
            };
            if let Some(teeth) = teeth {
                let teeth = 1..=teeth.unwrap_or(10_000);
                match cell.tooth().filter(|tooth| teeth.contains(tooth)) {
                    Some(tooth) => values.push(f64::from(tooth)),
                    None => wrong(column.name(), cell, &whole_in(&teeth)),
                }
                continue;
            }
            let factor = self.head.to_unit_of(*column, *place, cell);
            let number = cell.number().zip(factor);
            let number = number.map(|(number, factor)| (number, factor * number.value));
            match number.filter(|(_, value)| limits.range.contains(value)) {
                Some((number, value)) => {
                    values.push(value);
                    numbers.push((line.number, *column, number));
                }
                None if factor.is_none() => {
                    wrong(column.name(), cell, "a number in the unit of its heading")
                }
                None => wrong(column.name(), cell, limits.allowed),
            }
            if let (Quantity::PredictedMax, [_, _, _, _, _, min, max]) =
                (column.quantity, &values[..])
                && min > max
            {
                wrong(column.name(), cell, "predicted_min_um or above");
            }
        }
        good?;
        let flank = flank.map(|side| match side {
            Side::Right => Flank::Right,
            Side::Left => Flank::Left,
        });
        Some(Row {
            line: line.number,
            tooth,
            flank,
            values,
        })
    }
}

/// Lines with their labels: "lines 1–3, 50 (\"max\")"; `None` for none.
fn lines_in_words(file: &DataFile, mut lines: Vec<(u64, &str)>) -> Option<String> {
    lines.sort_by_cached_key(|(line, _)| *line);
    let mut runs: Vec<[u64; 2]> = Vec::new();
    for (line, _) in &lines {
        match runs.last_mut() {
            Some([_, last]) if *last + 1 == *line => *last = *line,
            _ => runs.push([*line; 2]),
        }
    }
    let run = |[first, last]: [u64; 2]| {
        if first == last {
            first.to_string()
        } else {
            format!("{first}–{last}")
        }
    };
    let labels = lines.iter().filter(|(_, label)| !label.is_empty());
    let mut labels = first_of(labels.map(|(_, label)| file.quote(label)), MAX_LISTED);
    if !labels.is_empty() {
        labels = format!(" ({labels})");
    }
    let shown = first_of(runs.into_iter().map(run), MAX_LISTED);
    (!lines.is_empty()).then(|| format!("line{} {shown}{labels}", plural(lines.len())))
}

/// The parts of a file that are not part of a table, in words.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Unread {
    lines: Option<String>,
    columns: Vec<UnreadColumn>,
}

#[derive(Debug, Clone, PartialEq)]
struct UnreadColumn {
    letter: String,
    /// Heading and letter.
    name: String,
    has_numbers: bool,
}

impl Unread {
    /// "lines 1–3, 50 (\"max\"); columns \"fu\" (D)", without the columns with the letters `elsewhere`; `None` for nothing.
    pub fn words(&self, elsewhere: &[&str]) -> Option<String> {
        let is_left = |letter: &str| !elsewhere.contains(&letter);
        let words: Vec<String> = self
            .lines
            .clone()
            .into_iter()
            .chain(self.list(is_left))
            .collect();
        (!words.is_empty()).then(|| words.join("; "))
    }

    /// The letter of the first column of numbers; those with the letters `elsewhere` do not count.
    pub fn first_number_column(&self, elsewhere: &[&str]) -> Option<String> {
        let mut columns = self.columns.iter();
        let found =
            columns.find(|column| column.has_numbers && !elsewhere.contains(&&column.letter[..]));
        found.map(|column| column.letter.clone())
    }

    /// The columns with the letters `elsewhere`, as [`Unread::words`].
    pub fn elsewhere(&self, elsewhere: &[&str]) -> Option<String> {
        self.list(|letter| elsewhere.contains(&letter))
    }

    fn list(&self, is_listed: impl Fn(&str) -> bool) -> Option<String> {
        let names = self.columns.iter().filter(|one| is_listed(&one.letter));
        let names: Vec<String> = names.map(|one| one.name.clone()).collect();
        let column = format!("column{}", plural(names.len()));
        (!names.is_empty()).then(|| format!("{column} {}", first_of(names, MAX_LISTED)))
    }
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// Whether a line is a statistic: its first cell names one, in the column of teeth or with an empty tooth.
fn is_statistic(line: &Line, used: &[usize]) -> bool {
    let at_tooth = used.first().map_or(&Cell::Empty, |place| line.cell(*place));
    let first = line.first();
    (*at_tooth == Cell::Empty || at_tooth == first) && heading::is_statistic(first.text())
}

/// Whether a line can be a row of numbers in the columns `used`. Remarks and dates are not.
fn is_row(line: &Line, used: &[usize]) -> bool {
    let mut cells = used.iter().map(|place| line.cell(*place));
    let first = cells.next().unwrap_or(&Cell::Empty);
    let is_empty = cells.clone().all(|cell| *cell == Cell::Empty);
    match first {
        Cell::Empty => !is_empty && !heading::is_remark(line.first().text(), false),
        Cell::Text(text) if heading::is_remark(text, !is_empty) => false,
        Cell::Text(text) if !is_empty && !text.contains(|c: char| c.is_ascii_digit()) => {
            cells.all(|cell| cell.number().is_some())
        }
        _ => true,
    }
}

/// `rows` by ascending tooth. A tooth that the gear does not have, or that is duplicate or missing, is a problem.
pub fn ordered(file: &DataFile, mut rows: Vec<Row>, wanted: Wanted) -> Option<Vec<Row>> {
    let Some(last) = rows.iter().map(|row| row.line).max() else {
        let each = match wanted.coverage {
            Coverage::Points { .. } => "point",
            Coverage::Results { .. } => "result",
            Coverage::EveryTooth | Coverage::SomeTeeth => "tooth",
        };
        return file.refuse(
            "no rows below the header",
            format!("add a row for each {each}"),
        );
    };
    if !wanted.is_by_tooth() {
        return Some(rows);
    }
    // Stable: the first of two rows stays the first.
    rows.sort_by_cached_key(|row| row.tooth.map_or(0, |tooth| 1 + u64::from(tooth)));
    let mut good = Some(());
    let mut wrong = |line: u64, reason: String, help: &str| {
        file.add_at(line, reason, help);
        good = None;
    };
    let teeth = wanted.teeth.unwrap_or(u32::MAX);
    let number = |row: &Row| row.tooth.unwrap_or(0);
    for row in rows.iter().filter(|row| number(row) > teeth) {
        let tooth = file.bare(&number(row).to_string());
        let reason = format!("tooth {tooth}, allowed is 1 … {teeth}");
        wrong(
            row.line,
            reason,
            "remove the line, or correct its number or teeth",
        );
    }
    for pair in rows
        .windows(2)
        .filter(|pair| pair[0].tooth == pair[1].tooth)
    {
        let reason = format!(
            "duplicate tooth {}, already given in line {}",
            number(&pair[1]),
            pair[0].line
        );
        wrong(
            pair[1].line,
            reason,
            "remove one of the two, or correct its number",
        );
    }
    if let (Coverage::EveryTooth, Some(teeth)) = (wanted.coverage, wanted.teeth) {
        let mut there = rows.iter().map(number).peekable();
        let mut missing = Vec::new();
        for tooth in 1..=teeth {
            if there.peek() != Some(&tooth) {
                missing.push(tooth);
            }
            while there.next_if_eq(&tooth).is_some() {}
        }
        if !missing.is_empty() {
            let reason = format!("the table ends here without {}", teeth_named(&missing));
            wrong(last, reason, &format!("give all {teeth} teeth, each once"));
        }
    }
    good.map(|()| rows)
}

/// "tooth 3", "teeth 3, 5", "teeth 3, 5, … (20 in all)".
fn teeth_named(teeth: &[u32]) -> String {
    let named: Vec<String> = teeth
        .iter()
        .take(MAX_TEETH_LISTED)
        .map(u32::to_string)
        .collect();
    let named = named.join(", ");
    match teeth.len() {
        1 => format!("tooth {named}"),
        count if count <= MAX_TEETH_LISTED => format!("teeth {named}"),
        count => format!("teeth {named}, … ({count} in all)"),
    }
}

/// "a whole number, 3 … 10 000".
fn whole_in(range: &RangeInclusive<u32>) -> String {
    let (low, high) = (range.start(), range.end());
    if *high < 10_000 {
        format!("a whole number, {low} … {high}")
    } else {
        format!("a whole number, {low} … {} {:03}", high / 1000, high % 1000)
    }
}

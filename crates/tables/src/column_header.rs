//! The header of a table: the line that names its columns, with the group headings above and the units below.

use super::choice::{Choice, TOOTH};
use super::column::{Column, Quantity};
use super::grid::{Cell, Line, letter};
use super::heading;
use crate::data_file::DataFile;
use gearlash_text::Problem;
use gearlash_text::characters::listed;
use std::fmt::Display;

/// Lines in which a header is searched, and most cells of such a line. Each cell takes some µs.
const MAX_SEARCHED: usize = 1_000;

#[derive(Debug, Clone, PartialEq)]
pub struct Heading {
    /// Its own cell; empty without one.
    own: String,
    /// Its own cell, preceded by that of its group.
    pub shown: String,
    /// `None` where the words are not known.
    pub meaning: Option<Column>,
    pub unit: Option<&'static str>,
    /// Diameter of a ball or pin, mm.
    pub ball_mm: Option<f64>,
}

impl Heading {
    /// The quantity, where the words are known.
    pub fn quantity(&self) -> Option<Quantity> {
        self.meaning.map(|meaning| meaning.quantity)
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct ColumnHeader {
    /// Its line in the file, from 1.
    pub line: u64,
    pub at: usize,
    /// Whether the line above holds the headings of groups.
    pub has_groups: bool,
    /// Whether the line below holds units.
    pub has_units: bool,
    pub headings: Vec<Heading>,
}

impl ColumnHeader {
    /// Factor from `cell` at `place`, in its own unit or that of its heading, to the unit of `column`; `None` where the units do not fit.
    pub fn to_unit_of(&self, column: Column, place: usize, cell: &Cell) -> Option<f64> {
        let stated = self.headings.get(place).and_then(|heading| heading.unit);
        let own = cell.unit();
        if own.is_some_and(|own| stated.is_some_and(|stated| stated != own)) {
            return None;
        }
        column.from_unit(own.or(stated))
    }

    /// The line at place `at` of `lines`, read as a header.
    pub fn of(lines: &[Line], at: usize) -> ColumnHeader {
        let line = &lines[at];
        let groups = at.checked_sub(1).map(|above| &lines[above]);
        let groups = groups.filter(|above| !above.is_comment() && !above.has_number());
        let units = lines.get(at + 1).filter(|below| is_units(below));
        let width = line
            .cells
            .len()
            .max(groups.map_or(0, |above| above.cells.len()));
        let (mut filled, mut has_groups) = ("", false);
        let headings = (0..width).map(|place| {
            let own = line.cell(place).text().trim_start_matches(['#', ' ']);
            let direct = groups.map_or("", |above| above.cell(place).text());
            if !direct.is_empty() {
                filled = direct;
            }
            // The text of a merged cell is in its upper line, and in its first column.
            let group = if own.is_empty() { direct } else { filled };
            let group = Some(group).filter(|group| is_group(group, direct == *group));
            let named = heading::named(own);
            let of_group = heading::named(group.unwrap_or_default());
            let meaning = if named.name.is_empty() {
                heading::meaning(&of_group.name, None)
            } else {
                heading::meaning(&named.name, group.map(|_| &*of_group.name))
            };
            has_groups |= group.is_some();
            let below = units.and_then(|units| heading::unit(units.cell(place).text()));
            let unit = match [named.unit, below] {
                [Some(unit), Some(below)] if unit != below => Some("two units"),
                [unit, below] => unit.or(below).or(of_group.unit),
            };
            Heading {
                own: own.to_owned(),
                shown: format!("{} {own}", group.unwrap_or_default())
                    .trim()
                    .to_owned(),
                meaning,
                unit,
                ball_mm: named.ball_mm.or(of_group.ball_mm),
            }
        });
        let mut headings: Vec<Heading> = headings.collect();
        // A title may be wider than the table.
        if !has_groups {
            headings.truncate(line.cells.len());
        }
        let rows = lines[at + 1..].iter().filter_map(|row| row.cell(0).tooth());
        if let Some(first) = headings.first_mut()
            && heading::is_counting(&first.shown)
            && rows.take(3).eq(1..=3)
        {
            first.meaning = Some(Column::of(Quantity::Number));
        }
        // A pitch of an unstated kind is the single one if a cumulative one of the same flank is there.
        let meanings: Vec<Column> = headings.iter().filter_map(|one| one.meaning).collect();
        for Column { side, quantity } in headings.iter_mut().filter_map(|one| one.meaning.as_mut())
        {
            let has = |quantity| {
                meanings.contains(&Column {
                    side: *side,
                    quantity,
                })
            };
            let is_single = has(Quantity::CumulativePitch) && !has(Quantity::SinglePitch);
            if *quantity == Quantity::Pitch && is_single {
                *quantity = Quantity::SinglePitch;
            }
        }
        ColumnHeader {
            line: line.number,
            at,
            has_groups,
            has_units: units.is_some(),
            headings,
        }
    }

    /// The first line of `lines` that is a header by `is_one`; or the line below, where that is a header with the first as its
    /// groups. A line that the pair file names takes precedence.
    pub fn find(
        lines: &[Line],
        choice: &Choice,
        is_one: impl Fn(&ColumnHeader) -> bool,
    ) -> Option<ColumnHeader> {
        let good = |at: usize| Some(ColumnHeader::of(lines, at)).filter(|head| is_one(head));
        if let Some(row) = choice.table.header_row {
            return good(
                lines
                    .iter()
                    .position(|line| line.number == u64::from(row))?,
            );
        }
        let searched = lines.len().min(MAX_SEARCHED);
        let mut places = (0..searched).filter(|at| {
            let line = &lines[*at];
            !line.is_comment() && line.cells.len() <= MAX_SEARCHED
        });
        let first = places.find_map(good)?;
        let next = lines.get(first.at + 1);
        if first.has_units || next.is_none_or(|next| next.is_comment() || next.has_number()) {
            return Some(first);
        }
        // Words that have a meaning with those above belong to the header, even if it then lacks a wanted column.
        let below = ColumnHeader::of(lines, first.at + 1);
        let means = |heading: &Heading| {
            let quantity = heading.quantity();
            !heading.own.is_empty()
                && quantity.is_some_and(|quantity| quantity != Quantity::Unstated)
        };
        if is_one(&below) || (below.has_groups && below.headings.iter().any(means)) {
            Some(below).filter(|below| is_one(below))
        } else {
            Some(first)
        }
    }

    /// The first line of words above a line of numbers; both may have other cells, but fewer.
    pub fn likely(lines: &[Line]) -> Option<ColumnHeader> {
        let is_most = |line: &Line, is_one: fn(&Cell) -> bool| {
            let all = line
                .cells
                .iter()
                .filter(|cell| **cell != Cell::Empty)
                .count();
            let count = line.cells.iter().filter(|cell| is_one(cell)).count();
            count > 1 && 2 * count > all
        };
        let mut heads = (0..lines.len().min(MAX_SEARCHED)).filter(|at| {
            let is_word = |cell: &Cell| !cell.text().is_empty() && cell.number().is_none();
            is_most(&lines[*at], is_word)
        });
        heads.find_map(|at| {
            let head = ColumnHeader::of(lines, at);
            let below = lines.get(at + 1 + usize::from(head.has_units))?;
            is_most(below, |cell| cell.number().is_some()).then_some(head)
        })
    }

    /// The columns whose heading `fits`.
    pub fn places(&self, fits: impl Fn(&Heading) -> bool) -> Vec<usize> {
        let headings = self.headings.iter().enumerate();
        headings
            .filter(|(_, heading)| fits(heading))
            .map(|(place, _)| place)
            .collect()
    }

    pub fn all(&self) -> Vec<usize> {
        self.places(|heading| !heading.shown.is_empty())
    }

    /// The columns that `name` can mean: by their heading, or else by their letter.
    fn columns_called(&self, name: &str) -> Vec<usize> {
        let name = name.trim();
        let is = |text: &str| text == name || heading::named(text).name == name;
        let places =
            self.places(|heading| !name.is_empty() && (is(&heading.own) || is(&heading.shown)));
        if !places.is_empty() {
            return places;
        }
        let by_letter = (0..self.headings.len()).filter(|place| letter(*place) == name);
        by_letter.collect()
    }

    /// The columns that can be `wanted`, by `choice` or by their headings.
    pub fn places_of(&self, wanted: Column, choice: &Choice) -> Vec<usize> {
        let may_be = |heading: &Heading| heading.meaning.is_some_and(|it| wanted.may_be(it));
        match choice.column(wanted.key()) {
            Some(name) => self.columns_called(name),
            None => self.places(may_be),
        }
    }

    /// The columns that can hold tooth numbers of a table with `wanted` columns.
    pub fn teeth(&self, wanted: &[Column], choice: &Choice) -> Vec<usize> {
        if let Some(name) = choice.column(TOOTH) {
            return self.columns_called(name);
        }
        let wants = |quantity| wanted.iter().any(|column| column.quantity == quantity);
        let teeth = self.places(|heading| match heading.quantity() {
            Some(Quantity::Tooth) => true,
            Some(Quantity::FirstTooth) => wants(Quantity::Span),
            Some(Quantity::Space) => wants(Quantity::OverPins) || wants(Quantity::Runout),
            _ => false,
        });
        if !teeth.is_empty() {
            return teeth;
        }
        // An unspecified number in the first column is the tooth's.
        let first = self.headings.first().and_then(Heading::quantity);
        let is_number = first == Some(Quantity::Number);
        if is_number { vec![0] } else { Vec::new() }
    }

    /// The column of numbers of spaces.
    pub fn space(&self) -> Option<usize> {
        let is_space = |heading: &Heading| heading.quantity() == Some(Quantity::Space);
        self.places(is_space).first().copied()
    }

    /// The column at `place` for a message: "\"Fp links\" (C)".
    pub fn shown_one(&self, file: &DataFile, place: usize) -> String {
        match self.headings.get(place).map(|heading| &heading.shown) {
            Some(name) if !name.is_empty() => format!("{} ({})", file.quote(name), letter(place)),
            _ => letter(place),
        }
    }

    /// The columns at `places` for a message: "\"Fp links\" (C) and \"Fp left\" (G)".
    pub fn shown(&self, file: &DataFile, places: &[usize]) -> String {
        let shown = places.iter().map(|place| self.shown_one(file, *place));
        listed(&shown.collect::<Vec<_>>(), "and")
    }

    pub fn problem(&self, file: &DataFile, reason: String, help: impl Display) -> Problem {
        file.problem_at(self.line, reason, help)
    }
}

/// Whether `text` heads a group of columns: a pitch or a flank. Directly above its column any known heading does.
fn is_group(text: &str, is_above: bool) -> bool {
    let meaning = heading::meaning(&heading::named(text).name, None);
    meaning.is_some_and(|Column { quantity, .. }| {
        is_above || quantity == Quantity::Unstated || quantity.is_pitch()
    })
}

fn is_units(line: &Line) -> bool {
    let unit = |cell: &Cell| heading::unit(cell.text()).is_some();
    let is_none = |cell: &Cell| *cell == Cell::Empty || heading::is_no_unit(cell.text());
    line.cells.iter().any(unit) && line.cells.iter().all(|cell| unit(cell) || is_none(cell))
}

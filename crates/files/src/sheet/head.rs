//! The header of a table: the line that names its columns, wherever it stands, with the group headings above and the units below it.

use super::cell::{Cell, Line};
use super::choice::{Choice, TOOTH};
use super::column::Column;
use super::heading::{self, Meaning, Quantity};
use crate::data_file::DataFile;

/// One column's heading.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading {
    /// Its own cell; empty without one.
    own: String,
    /// With that of its group before it.
    pub shown: String,
    /// What they say; `None`: nothing that is known.
    pub meaning: Option<Meaning>,
    /// The unit, as meant.
    pub unit: Option<&'static str>,
}

/// A header.
#[derive(Debug, Clone, PartialEq)]
pub struct Head {
    /// Its line in the file, from 1.
    pub line: u64,
    /// Its place among the lines.
    pub at: usize,
    /// Whether the line above holds the headings of groups.
    pub has_groups: bool,
    /// Whether the line below holds units.
    pub has_units: bool,
    /// A column each.
    pub headings: Vec<Heading>,
}

impl Head {
    /// The line at place `at` of `lines`, read as a header.
    pub fn of(lines: &[Line], at: usize) -> Head {
        let line = &lines[at];
        let groups = at.checked_sub(1).map(|above| &lines[above]);
        let groups = groups.filter(|above| !above.is_comment() && !is_data(above));
        let units = lines.get(at + 1).filter(|below| is_units(below));
        let width = line
            .cells
            .len()
            .max(groups.map_or(0, |above| above.cells.len()));
        let (mut filled, mut has_groups) = ("", false);
        let headings = (0..width).map(|place| {
            let own = words(line.cell(place)).trim_start_matches(['#', ' ']);
            let direct = groups.map_or("", |above| words(above.cell(place)));
            if !direct.is_empty() {
                filled = direct;
            }
            // A merged cell of two lines stands in the upper one; one of several columns in the first.
            let group = match own.is_empty() || direct == filled {
                true => direct,
                false => filled,
            };
            let group = Some(group).filter(|group| is_group(group, direct == *group));
            let (name, unit) = heading::name_and_unit(own);
            let (group_name, group_unit) = heading::name_and_unit(group.unwrap_or_default());
            let meaning = match name.is_empty() {
                true => heading::meaning(group_name, None),
                false => heading::meaning(name, group.map(|_| group_name)),
            };
            has_groups |= group.is_some();
            let below = units.and_then(|units| heading::unit(words(units.cell(place))));
            let differ = |one: Option<&str>, other: Option<&str>| {
                one.is_some() && other.is_some() && one != other
            };
            Heading {
                own: own.to_owned(),
                shown: format!("{} {own}", group.unwrap_or_default())
                    .trim()
                    .to_owned(),
                meaning,
                unit: match differ(unit, below) {
                    true => Some("two units"),
                    false => unit.or(below).or(group_unit),
                },
            }
        });
        let headings = headings.collect();
        Head {
            line: line.number,
            at,
            has_groups,
            has_units: units.is_some(),
            headings,
        }
    }

    /// The first line of `lines` that is a header by `is_one`, or the one below it where that says more with it as its groups;
    /// the line that the pair file names, where it names one.
    pub fn find(lines: &[Line], choice: &Choice, is_one: impl Fn(&Head) -> bool) -> Option<Head> {
        let good = |at: usize| Some(Head::of(lines, at)).filter(|head| is_one(head));
        if let Some(row) = choice.header_row {
            return good(lines.iter().position(|line| line.number == row)?);
        }
        let mut places = (0..lines.len()).filter(|at| !lines[*at].is_comment());
        let first = places.find_map(good)?;
        let next = lines.get(first.at + 1);
        let is_group =
            !first.has_units && next.is_some_and(|next| !next.is_comment() && !is_data(next));
        if !is_group {
            return Some(first);
        }
        // Words that mean something with those above belong to the header, even where it is then no header of what is looked for.
        let below = Head::of(lines, first.at + 1);
        let means = |heading: &Heading| {
            let quantity = heading.meaning.map(|meaning| meaning.quantity);
            !heading.own.is_empty() && quantity.is_some_and(|quantity| quantity != Quantity::Unsaid)
        };
        match is_one(&below) || (below.has_groups && below.headings.iter().any(means)) {
            true => Some(below).filter(|below| is_one(below)),
            false => Some(first),
        }
    }

    /// The columns that `name` may be: by their heading, or else by their letter.
    pub fn named(&self, name: &str) -> Vec<usize> {
        let name = name.trim();
        let is = |heading: &Heading| {
            let names = [&heading.own, &heading.shown];
            let is_it = |text: &String| text == name || heading::name_and_unit(text).0 == name;
            !name.is_empty() && names.into_iter().any(is_it)
        };
        let places = (0..self.headings.len()).filter(|place| is(&self.headings[*place]));
        let places: Vec<usize> = places.collect();
        match places.is_empty() {
            true => (0..self.headings.len())
                .filter(|place| letter(*place) == name)
                .collect(),
            false => places,
        }
    }

    /// The columns that may be `wanted`, by `choice` or by what their headings say.
    pub fn places_of(&self, wanted: Column, choice: &Choice) -> Vec<usize> {
        self.places(choice.column(wanted.key()), |meaning| {
            wanted.may_be(meaning)
        })
    }

    /// The columns that may be of tooth numbers beside those of `wanted`.
    pub fn teeth(&self, wanted: &[Column], choice: &Choice) -> Vec<usize> {
        let named = choice.column(TOOTH);
        let teeth = self.places(named, |meaning| match meaning.quantity {
            Quantity::Tooth => true,
            Quantity::FirstTooth => wanted.contains(&Column::Span),
            Quantity::Space => wanted.contains(&Column::OverPins),
            _ => false,
        });
        // Without any, the numbers of the first column are the teeth's.
        let number = self.places(named, |meaning| meaning.quantity == Quantity::Number);
        match teeth.is_empty() {
            true => number.into_iter().filter(|place| *place == 0).collect(),
            false => teeth,
        }
    }

    fn places(&self, named: Option<&str>, may_be: impl Fn(Meaning) -> bool) -> Vec<usize> {
        let means = |place: &usize| self.headings[*place].meaning.is_some_and(&may_be);
        match named {
            Some(name) => self.named(name),
            None => (0..self.headings.len()).filter(means).collect(),
        }
    }

    /// The columns at `places` for a message: "\"Fp links\" (C) and \"Fp left\" (G)".
    pub fn shown(&self, file: &DataFile, places: &[usize]) -> String {
        let shown = |place: &usize| match self.headings.get(*place).map(|heading| &heading.shown) {
            Some(name) if !name.is_empty() => format!("{} ({})", file.quote(name), letter(*place)),
            _ => letter(*place),
        };
        let shown: Vec<String> = places.iter().map(shown).collect();
        match shown.split_last() {
            Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
            _ => shown.concat(),
        }
    }

    /// The columns that have a heading.
    pub fn all(&self) -> Vec<usize> {
        let places = 0..self.headings.len();
        places
            .filter(|place| !self.headings[*place].shown.is_empty())
            .collect()
    }
}

/// The letter that a spreadsheet gives the column at `place`.
pub fn letter(place: usize) -> String {
    let last = char::from(b'A' + (place % 26) as u8);
    match place / 26 {
        0 => last.to_string(),
        before => letter(before - 1) + &last.to_string(),
    }
}

fn words(cell: &Cell) -> &str {
    match cell {
        Cell::Text(text) => text,
        _ => "",
    }
}

/// Whether `text` is the heading of a group of columns, of pitch or of a flank, or, standing above its own column, any that is known.
fn is_group(text: &str, is_above: bool) -> bool {
    let said = heading::meaning(heading::name_and_unit(text).0, None);
    said.is_some_and(|said| {
        is_above || matches!(said.quantity, Quantity::Unsaid | Quantity::Pitch(_))
    })
}

/// Whether a cell of the line is a number: no header has one.
fn is_data(line: &Line) -> bool {
    line.cells.iter().any(|cell| cell.number().is_some())
}

/// Whether the line holds nothing but units.
fn is_units(line: &Line) -> bool {
    let unit = |cell: &Cell| heading::unit(words(cell)).is_some();
    let filled = line.cells.iter().filter(|cell| **cell != Cell::Empty);
    line.cells.iter().any(unit)
        && filled
            .into_iter()
            .all(|cell| unit(cell) || heading::is_no_unit(words(cell)))
}

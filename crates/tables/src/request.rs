//! A request for a table: its file and columns; the header that it finds in one of the file's grids, and the places of the columns there:
//! one each, or an error that lists the candidates.

use super::choice::{Choice, TOOTH};
use super::column::{self, Column, Quantity};
use super::column_header::{ColumnHeader, Heading};
use super::grid::{Grid, Line, MAX_CELLS, MAX_NAMED, MAX_ROWS, letter};
use crate::data_file::DataFile;
use gearlash::metrology::PitchKind;
use gearlash_text::{Node, Problem};
use std::fmt::Display;

/// Columns and rows that a reader needs.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'a> {
    /// The columns beside the tooth, in the order of the values.
    pub columns: &'a [Column],
    /// `z`, where it is known.
    pub teeth: Option<u32>,
    /// The rows.
    pub coverage: Coverage,
}

/// The rows that a table must have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Coverage {
    /// Every tooth, exactly once.
    EveryTooth,
    /// Some teeth, each at most once.
    SomeTeeth,
    /// Points of traces. Tooth and flank are optional; [`Quantity::RollLength`] also accepts a diameter.
    Points {
        /// Radius of the base circle, mm: a curve file of profiles needs it where its header does not state the gear.
        base_radius: Option<f64>,
    },
    /// Results of a rig, in the order of their lines.
    Results {
        /// The teeth of wheel and pinion, where known.
        teeth: [Option<u32>; 2],
    },
}

impl Wanted<'_> {
    /// Whether the rows are points of traces.
    pub fn is_points(&self) -> bool {
        matches!(self.coverage, Coverage::Points { .. })
    }

    /// The columns that can state the place of a point.
    pub fn places_of_points(&self) -> &'static [Quantity] {
        if self.has(Quantity::Height) {
            &[Quantity::Height]
        } else {
            &[Quantity::RollLength, Quantity::Diameter]
        }
    }

    /// Whether a column of the `quantity` is wanted.
    pub fn has(&self, quantity: Quantity) -> bool {
        self.columns
            .iter()
            .any(|column| column.quantity == quantity)
    }

    /// Whether the rows are results of a rig.
    pub fn is_results(&self) -> bool {
        matches!(self.coverage, Coverage::Results { .. })
    }

    /// Most cells of a CSV file; those of results have up to 250 000 rows.
    pub fn most_cells(&self) -> usize {
        if self.is_results() {
            10 * MAX_CELLS
        } else {
            MAX_CELLS
        }
    }

    /// Whether each row is of one tooth.
    pub fn is_by_tooth(&self) -> bool {
        matches!(self.coverage, Coverage::EveryTooth | Coverage::SomeTeeth)
    }
}

/// Places of the columns in a header.
#[derive(Debug, Clone, PartialEq)]
pub struct Places {
    pub tooth: Option<usize>,
    /// The name of the flank, beside points of traces.
    pub flank: Option<usize>,
    /// Where a result of a rig comes from.
    pub source: Option<usize>,
    /// The wanted columns, in their order.
    pub values: Vec<(Column, usize)>,
}

impl Places {
    /// The columns that hold numbers, the tooth first.
    pub fn numbers(&self) -> Vec<usize> {
        let values = self.values.iter().map(|(_, place)| *place);
        self.tooth.into_iter().chain(values).collect()
    }
}

/// A request for the table of a file.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// The file.
    pub file: &'a DataFile,
    /// The keys of the pair file that say where the table is.
    pub choice: &'a Choice,
    /// Columns and rows.
    pub wanted: Wanted<'a>,
}

impl Request<'_> {
    /// This request for a gear with `teeth` teeth.
    pub fn with_teeth(self, teeth: Option<u32>) -> Self {
        let wanted = Wanted {
            teeth,
            ..self.wanted
        };
        Request { wanted, ..self }
    }

    /// Finds the header in `grids`: the line that names a tooth column and a wanted one.
    pub fn head<'g>(&self, grids: &'g [Grid]) -> Option<(&'g Grid, ColumnHeader)> {
        let has_wanted = self.is_there(grids);
        let columns = self.wanted.columns.iter();
        let others: Vec<Column> = columns.map(|column| column.of_other_kind()).collect();
        // Where only pitch of the other kind is present, that is reported.
        let is_head = |head: &ColumnHeader| {
            self.is_head(head, self.wanted.columns) || (!has_wanted && self.is_head(head, &others))
        };
        self.find_header(grids, is_head)
    }

    /// Whether one of `grids` has a header of a tooth column and a wanted one.
    pub fn is_there(&self, grids: &[Grid]) -> bool {
        let is_head = |head: &ColumnHeader| self.is_head(head, self.wanted.columns);
        let mut grids = grids.iter();
        grids.any(|grid| ColumnHeader::find(&grid.lines, self.choice, is_head).is_some())
    }

    /// Why the wanted columns are not read where their rows are numbered by spaces.
    pub fn by_spaces(&self, grids: &[Grid]) -> Option<Problem> {
        let columns = self.wanted.columns.iter();
        let places = |head: &ColumnHeader| {
            let all = columns
                .clone()
                .map(|of| (head.places_of(*of, self.choice), of.key()));
            let mut all: Vec<_> = all.filter(|(at, _)| at.len() == 1).collect();
            all.sort_by_cached_key(|(at, _)| at[0] as u64);
            all
        };
        let is_one = |head: &ColumnHeader| {
            let no_tooth = head.teeth(self.wanted.columns, self.choice).is_empty();
            no_tooth && head.space().is_some() && places(head).len() == columns.len()
        };
        let mut grids = grids.iter();
        let head = grids.find_map(|grid| ColumnHeader::find(&grid.lines, self.choice, is_one))?;
        let places = places(&head);
        let open = places.iter();
        let open = open.filter(|(_, key)| self.choice.column(key).is_none());
        let options = open.map(|(at, key)| format!(" --{key} {}", letter(at[0])));
        let options: Vec<String> = options.collect();
        let read = if options.len() < places.len() {
            "add"
        } else {
            "read them by --only pitch"
        };
        let help = format!(
            "where pitch k ends at tooth k, {read} --tooth-column {}{}",
            head.space().map(letter).unwrap_or_default(),
            options.concat()
        );
        let places: Vec<usize> = places.into_iter().flat_map(|(at, _)| at).collect();
        let reason = format!(
            "columns {} have rows numbered by spaces; pitch belongs to teeth",
            head.shown(self.file, &places)
        );
        Some(head.problem(self.file, reason, help))
    }

    fn is_head(&self, head: &ColumnHeader, wanted: &[Column]) -> bool {
        let has = |column: Column| !head.places_of(column, self.choice).is_empty();
        if self.wanted.is_points() {
            let mut places = self.wanted.places_of_points().iter();
            let has = |quantity| has(Column::of(quantity));
            return has(Quantity::Deviation) && places.any(|quantity| has(*quantity));
        }
        if self.wanted.is_results() {
            return wanted.iter().filter(|column| has(**column)).count() > 1;
        }
        !head.teeth(wanted, self.choice).is_empty() && wanted.iter().any(|column| has(*column))
    }

    /// Whether `head` has several headings, one of them of teeth or of a wanted column.
    fn is_nearly_head(&self, head: &ColumnHeader) -> bool {
        let wanted = self.wanted.columns;
        let has = |column: &Column| !head.places_of(*column, self.choice).is_empty();
        head.all().len() > 1
            && (!head.teeth(wanted, self.choice).is_empty() || wanted.iter().any(has))
    }

    /// Whether a line below `head` has numbers in its columns.
    fn has_rows(&self, grid: &Grid, head: &ColumnHeader) -> bool {
        let first = |places: Vec<usize>| places.first().copied();
        let tooth = first(head.teeth(self.wanted.columns, self.choice));
        let wanted = self.wanted.columns.iter();
        let values = wanted.filter_map(|column| first(head.places_of(*column, self.choice)));
        let values: Vec<usize> = values.collect();
        grid.lines[head.at + 1..].iter().any(|line| {
            tooth.is_none_or(|tooth| line.cell(tooth).tooth().is_some())
                && values
                    .iter()
                    .all(|place| line.cell(*place).number().is_some())
        })
    }

    fn find_header<'g>(
        &self,
        grids: &'g [Grid],
        is_head: impl Fn(&ColumnHeader) -> bool,
    ) -> Option<(&'g Grid, ColumnHeader)> {
        let choice = self.choice;
        let in_grid =
            |grid: &'g Grid| Some((grid, ColumnHeader::find(&grid.lines, choice, &is_head)?));
        let mut found: Vec<_> = grids.iter().filter_map(in_grid).collect();
        if found.is_empty()
            && let ([grid], Some(row)) = (grids, choice.table.header_row)
            && let Some(at) = grid
                .lines
                .iter()
                .position(|line| line.number == u64::from(row))
        {
            // The columns that it lacks are reported.
            return Some((grid, ColumnHeader::of(&grid.lines, at)));
        }
        if found.is_empty() && choice.table.header_row.is_none() {
            // To report the missing columns is better than "no header".
            let nearly = |head: &ColumnHeader| self.is_nearly_head(head);
            let in_grid =
                |grid: &'g Grid| Some((grid, ColumnHeader::find(&grid.lines, choice, nearly)?));
            let mut nearly: Vec<_> = grids.iter().filter_map(in_grid).collect();
            // Columns named by letters are in every line: known words tell the header from other lines.
            if nearly.len() > 1 {
                nearly.retain(|(grid, head)| names_columns(&grid.lines, head.at));
            }
            if nearly.len() == 1 {
                return nearly.pop();
            }
        }
        let is_text = grids.first().is_some_and(|grid| grid.sheet.is_none());
        if found.len() > 1 && is_text {
            // The separator that makes the lines rows of the table.
            let rows = found
                .iter()
                .filter(|(grid, head)| self.has_rows(grid, head));
            let rows: Vec<_> = rows.cloned().collect();
            if !rows.is_empty() {
                found = rows;
            }
        }
        if found.len() == 1 {
            return found.pop();
        }
        self.file.reading().refuse(self.wrong_header(grids, &found))
    }

    /// The problem of no grid, or several, with a header.
    fn wrong_header(&self, grids: &[Grid], found: &[(&Grid, ColumnHeader)]) -> Problem {
        let Request {
            file,
            choice,
            wanted,
        } = self;
        let names = |grids: &mut dyn Iterator<Item = &Grid>| {
            let names = grids.filter_map(|grid| grid.sheet.as_ref()).take(MAX_NAMED);
            names
                .map(|name| file.quote(name))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let columns = column::headings(wanted.columns);
        match found.first() {
            Some((Grid { sheet: Some(first), .. }, _)) => file.problem(
                format!(
                    "has {} sheets with a table of {columns}: {}",
                    found.len(),
                    names(&mut found.iter().map(|(grid, _)| *grid))
                ),
                format!("say which one: sheet = {}", file.quote(first)),
            ),
            Some((_, head)) => head.problem(
                file,
                "can be the header with more than one separator, allowed is one of comma, semicolon and tab".to_owned(),
                "use one separator for all columns",
            ),
            None => {
                let (what, row) = match choice.table.header_row {
                    Some(row) => (format!("line {row} does not name"), row),
                    None => {
                        let mut likely = grids.iter().map(|grid| ColumnHeader::likely(&grid.lines));
                        let row = likely.find_map(|head| u32::try_from(head?.line).ok());
                        ("no line names".to_owned(), row.unwrap_or(1))
                    }
                };
                let is_book = grids.len() > 1 && grids.iter().any(|grid| grid.sheet.is_some());
                let place = if is_book {
                    format!(" in sheets {}", names(&mut grids.iter()))
                } else {
                    String::new()
                };
                let help = if !wanted.is_by_tooth() {
                    format!("name the columns {columns}")
                } else {
                    let columns = wanted.columns.iter().map(|column| column.key());
                    let keys = [TOOTH].into_iter().chain(columns).zip('A'..);
                    let open = keys.filter(|(key, _)| choice.column(key).is_none());
                    let open: String =
                        open.map(|(key, letter)| format!(", {key} = \"{letter}\"")).collect();
                    format!("say where they are, by letter or heading: header_row = {row}{open}")
                };
                file.problem(format!("{what} the columns {columns}{place}"), help)
            }
        }
    }

    /// The places of the tooth and the wanted columns in `head`, one of `lines`.
    pub fn places(&self, head: &ColumnHeader, lines: &[Line]) -> Option<Places> {
        if self.wanted.is_points() {
            return self.places_of_points(head);
        }
        let tooth = if self.wanted.is_by_tooth() {
            self.keep(self.tooth(head, lines).map(Some))
        } else {
            Some(None)
        };
        let is_source = |heading: &Heading| heading.quantity() == Some(Quantity::Source);
        let source = head.places(is_source).first().copied();
        let is_missing = |column: &&Column| self.is_missing(head, **column);
        let (optional, mut columns): (Vec<Column>, Vec<Column>) =
            (self.wanted.columns.iter()).partition(|column| column.quantity.is_optional());
        if !optional.iter().all(|column| is_missing(&column)) {
            columns.extend(optional);
        }
        let missing = columns.iter().filter(is_missing).count();
        let again = (missing > 0)
            .then(|| repeated_header(head, lines))
            .flatten();
        if let Some(line) = again {
            return self.file.refuse_at(
                line,
                format!(
                    "names columns again, as line {} does: a table in two blocks, one below the other, is not read",
                    head.line
                ),
                "put the blocks side by side: a row a tooth, with a column for each flank",
            );
        }
        if columns.len() > 1 && missing == columns.len() {
            let names: Vec<&str> = columns.iter().map(|column| column.name()).collect();
            let keys = columns.iter();
            let keys: Vec<String> = keys
                .map(|column| format!("{} = \"…\"", column.key()))
                .collect();
            let reason = format!(
                "columns {} are missing; the columns are {}",
                names.join(" and "),
                head.shown(self.file, &head.all())
            );
            let help = format!(
                "name them there, or say which they are, by heading or letter: {}",
                keys.join(", ")
            );
            return self.refuse(head, reason, help);
        }
        let values = columns.iter().map(|column| {
            let places = dedup_equal(head, lines, head.places_of(*column, self.choice));
            let place = self.one(head, *column, &in_unit(head, *column, places));
            Some((*column, self.keep(place)?))
        });
        // All problems are reported, not only the first.
        let values: Vec<Option<_>> = values.collect();
        let values = values.into_iter().collect::<Option<Vec<_>>>()?;
        let places = Places {
            tooth: tooth?,
            flank: None,
            source: source.filter(|_| self.wanted.is_results()),
            values,
        };
        self.keep(self.check_same_kind(head, &places))?;
        self.keep(self.check_distinct(head, &places))?;
        Some(places)
    }

    fn keep<T>(&self, result: Result<T, Problem>) -> Option<T> {
        self.file.reading().keep(result)
    }

    fn refuse<T>(&self, head: &ColumnHeader, reason: String, help: impl Display) -> Option<T> {
        let problem = head.problem(self.file, reason, help);
        self.file.reading().refuse(problem)
    }

    /// Points can have a tooth and a flank, and have one column of their place.
    fn places_of_points(&self, head: &ColumnHeader) -> Option<Places> {
        let optional = |name: &str, places: Vec<usize>| match *places {
            [] => Some(None),
            [place] => Some(Some(place)),
            _ => {
                let several = self.several(head, name, TOOTH, &places);
                self.file.reading().refuse(several)
            }
        };
        let tooth = optional("tooth", head.teeth(&[], self.choice));
        let is_flank = |heading: &Heading| heading.quantity() == Some(Quantity::Flank);
        let flank = optional("flank", head.places(is_flank));
        let columns = self
            .wanted
            .places_of_points()
            .iter()
            .copied()
            .map(Column::of);
        let places = columns.map(|column| (column, head.places_of(column, self.choice)));
        let places: Vec<(Column, Vec<usize>)> = places.collect();
        let there = || places.iter().filter(|(_, at)| !at.is_empty());
        if there().count() > 1 {
            let reason = "columns roll length and diameter, allowed is one of them".to_owned();
            return self.refuse(head, reason, "remove one: they say the same");
        }
        let (by, at) = there().next().or(places.first())?;
        let column = Column::of(Quantity::Deviation);
        let deviation = head.places_of(column, self.choice);
        let at = self.keep(self.one(head, *by, at));
        let deviation = self.keep(self.one(head, column, &deviation));
        let values = vec![(*by, at?), (column, deviation?)];
        Some(Places {
            tooth: tooth?,
            flank: flank?,
            source: None,
            values,
        })
    }

    fn tooth(&self, head: &ColumnHeader, lines: &[Line]) -> Result<usize, Problem> {
        let places = head.teeth(self.wanted.columns, self.choice);
        let places = dedup_equal(head, lines, places);
        match places[..] {
            [] => Err(self.missing(head, "tooth", TOOTH)),
            [place] => self.check_unit(head, place, None).map(|()| place),
            _ => Err(self.several(head, "tooth", TOOTH, &places)),
        }
    }

    fn one(&self, head: &ColumnHeader, column: Column, places: &[usize]) -> Result<usize, Problem> {
        let place = match *places {
            [place] => place,
            [] => {
                let is_named = self.choice.column(column.key()).is_some();
                let other = head.places_of(column.of_other_kind(), self.choice);
                return Err(match (column.kind(), other.first()) {
                    (Some(kind), Some(place)) if !is_named => self.contradicts(head, *place, kind),
                    _ => self.missing(head, column.name(), column.key()),
                });
            }
            _ => return Err(self.several(head, column.name(), column.key(), places)),
        };
        let heading = &head.headings[place];
        if heading
            .meaning
            .is_some_and(|meaning| !column.may_be_named(meaning))
        {
            let reason = format!(
                "the heading of column {} says something else than {}",
                head.shown_one(self.file, place),
                column.name()
            );
            let help = match column.kind() {
                Some(_) => {
                    "name the column of that flank; where the gear was seen from its other face, say so with reference_face"
                }
                None => "name the column that holds it, or correct the heading",
            };
            return Err(head.problem(self.file, reason, help));
        }
        let stated = heading.quantity().and_then(Quantity::pitch_kind);
        match column.kind() {
            Some(kind) if stated.is_some_and(|stated| stated != kind) => {
                Err(self.contradicts(head, place, kind))
            }
            _ => self.check_unit(head, place, Some(column)).map(|()| place),
        }
    }

    /// Whether `head` has no column that can be `column` or its other kind, and none is named.
    fn is_missing(&self, head: &ColumnHeader, column: Column) -> bool {
        let none = |column| head.places_of(column, self.choice).is_empty();
        let is_named = self.choice.column(column.key()).is_some();
        !is_named && none(column) && none(column.of_other_kind())
    }

    /// Whether the line `at` is the header of a table without any of the wanted columns. A row of numbers is none.
    pub fn begins_other_table(&self, lines: &[Line], at: usize) -> bool {
        let is_missing = |head: &ColumnHeader| {
            let mut columns = self.wanted.columns.iter();
            columns.all(|column| self.is_missing(head, *column))
        };
        lines[at].first().number().is_none()
            && names_columns(lines, at)
            && is_missing(&ColumnHeader::of(lines, at))
    }

    /// Checks that no column is read as two quantities.
    fn check_distinct(&self, head: &ColumnHeader, places: &Places) -> Result<(), Problem> {
        let tooth = places.tooth.map(|place| ("tooth", TOOTH, place));
        let mut read: Vec<_> = tooth.into_iter().collect();
        for (column, place) in &places.values {
            let (name, key) = (column.name(), column.key());
            if let Some((other, other_key, _)) = read.iter().find(|(.., taken)| taken == place) {
                let shown = head.shown_one(self.file, *place);
                let reason = format!("column {shown} is read as {other} and as {name}");
                let help = format!("name two columns: {other_key} = \"…\", {key} = \"…\"");
                return Err(head.problem(self.file, reason, help));
            }
            read.push((name, key, *place));
        }
        Ok(())
    }

    /// Checks that all columns of pitch state their kind or none does. A column without a kind beside one with it can be of the
    /// other kind, unless the pair file names it.
    fn check_same_kind(&self, head: &ColumnHeader, places: &Places) -> Result<(), Problem> {
        let states = |place: usize| {
            let quantity = head.headings[place].quantity();
            quantity.and_then(Quantity::pitch_kind).is_some()
        };
        let mut values = places.values.iter();
        let unsaid = values.find(|(column, place)| {
            column.kind().is_some() && self.choice.column(column.key()).is_none() && !states(*place)
        });
        let Some((column, place)) =
            unsaid.filter(|_| places.values.iter().any(|(_, place)| states(*place)))
        else {
            return Ok(());
        };
        let shown = head.shown_one(self.file, *place);
        let (key, letter) = (column.key(), letter(*place));
        let reason =
            format!("column {shown} does not say whether it is fp or Fp, the other flank's does");
        let help = format!("say so in its heading, or name it: {key} = \"{letter}\"");
        Err(head.problem(self.file, reason, help))
    }

    /// The problem of a column of the other kind than `kind`.
    fn contradicts(&self, head: &ColumnHeader, place: usize, kind: PitchKind) -> Problem {
        let (stated, other_kind, key) = match kind {
            PitchKind::Single => ("single", "cumulative pitch deviations, Fp", "cumulative"),
            PitchKind::Cumulative => ("cumulative", "single pitch deviations, fp", "single"),
        };
        let shown = head.shown_one(self.file, place);
        let reason = format!("column {shown} is of {other_kind}, wanted is kind = \"{stated}\"");
        let help = format!(
            "write kind = \"{key}\", or name the column of the other kind: left = \"…\", right = \"…\""
        );
        head.problem(self.file, reason, help)
    }

    fn missing(&self, head: &ColumnHeader, name: &str, key: &str) -> Problem {
        let of_three = |heading: &Heading| heading.quantity() == Some(Quantity::OverThreePins);
        if let Some(place) = head.places(of_three).first()
            && name == Column::of(Quantity::OverPins).name()
        {
            let shown = head.shown_one(self.file, *place);
            return head.problem(
                self.file,
                format!("column {shown} is a dimension over three pins, allowed is one over two"),
                "give the dimensions over two pins (gearlash gauge writes them beside those over three), or the span",
            );
        }
        let columns = head.shown(self.file, &head.all());
        let reason = match self.choice.column(key) {
            Some(column) => {
                let column = Node::Text(column.to_owned()).shown();
                format!("there is no column {key} = {column}; the columns are {columns}")
            }
            None => format!("column {name} is missing; the columns are {columns}"),
        };
        let help = match key {
            "" => "name it there".to_owned(),
            _ => {
                let space = head.space().filter(|_| key == TOOTH).map(letter);
                let column = space.as_deref().unwrap_or("…");
                format!(
                    "name it there, or say which it is, by heading or letter: {key} = \"{column}\""
                )
            }
        };
        head.problem(self.file, reason, help)
    }

    fn several(&self, head: &ColumnHeader, name: &str, key: &str, places: &[usize]) -> Problem {
        let letters = places
            .iter()
            .map(|place| format!("{key} = \"{}\"", letter(*place)));
        let letters: Vec<String> = letters.collect();
        let (count, shown) = (places.len(), head.shown(self.file, places));
        let reason = format!("{count} columns may be {name}: {shown}");
        let help = match key {
            "" => "keep one of them".to_owned(),
            _ => format!("say which, by letter or heading: {}", letters.join(" or ")),
        };
        head.problem(self.file, reason, help)
    }

    /// Checks that the unit at `place`, where one is stated, can be converted to that of `column`; a tooth has none.
    fn check_unit(
        &self,
        head: &ColumnHeader,
        place: usize,
        column: Option<Column>,
    ) -> Result<(), Problem> {
        let needed = column.map(Column::unit);
        let is_wrong = |unit: &&str| column.is_none_or(|of| of.from_unit(Some(unit)).is_none());
        let Some(unit) = head.headings[place].unit.filter(is_wrong) else {
            return Ok(());
        };
        let shown = head.shown_one(self.file, place);
        let (reason, help) = match needed {
            Some(needed) => (
                format!("column {shown} is in {unit}, allowed is {needed}"),
                format!("convert its values to {needed} and write that unit in its heading"),
            ),
            None => (
                format!("column {shown} has a unit, a tooth number has none"),
                "remove the unit from its heading".to_owned(),
            ),
        };
        Err(head.problem(self.file, reason, help))
    }
}

/// The first of `places` where all have equal cells, else all.
fn dedup_equal(head: &ColumnHeader, lines: &[Line], mut places: Vec<usize>) -> Vec<usize> {
    let rows = &lines[head.at + 1..];
    let is_equal = |place: &usize| {
        rows.iter()
            .all(|row| row.cell(*place) == row.cell(places[0]))
    };
    if places.iter().all(is_equal) {
        places.truncate(1);
    }
    places
}

/// The one of `places` with the unit of `column`, where all others have a different unit.
fn in_unit(head: &ColumnHeader, column: Column, places: Vec<usize>) -> Vec<usize> {
    let unit = |place: &usize| head.headings[*place].unit;
    let good = |place: &&usize| unit(place) == Some(column.unit());
    let all_say = places.iter().all(|place| unit(place).is_some());
    match places.iter().filter(good).collect::<Vec<_>>()[..] {
        [only] if all_say => vec![*only],
        _ => places,
    }
}

/// The line below `head` that repeats the header.
fn repeated_header(head: &ColumnHeader, lines: &[Line]) -> Option<u64> {
    let mut below = (head.at + 2..lines.len()).take(MAX_ROWS);
    below
        .find(|at| names_columns(lines, *at))
        .map(|at| lines[at].number)
}

/// Whether a line knows more than one of its headings.
pub fn names_columns(lines: &[Line], at: usize) -> bool {
    let known = || ColumnHeader::of(lines, at).places(|heading| heading.meaning.is_some());
    !lines[at].is_comment() && known().len() > 1
}

//! A request for a table: its file and columns; and the header that it finds in one of the file's grids.

use super::choice::Choice;
use super::column::{self, Column, Quantity};
use super::grid::{Grid, MAX_CELLS, MAX_NAMED};
use super::head::Head;
use crate::data_file::DataFile;
use gearlash_text::Problem;

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

/// A request for the table of a file.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// The file.
    pub file: &'a DataFile,
    /// What the pair file says of its place.
    pub choice: &'a Choice,
    /// Columns and rows.
    pub wanted: Wanted<'a>,
}

impl Request<'_> {
    /// Finds the header in `grids`: the line that names a tooth column and a wanted one.
    pub fn head<'g>(&self, grids: &'g [Grid]) -> Option<(&'g Grid, Head)> {
        let has_wanted = self.is_there(grids);
        let columns = self.wanted.columns.iter();
        let others: Vec<Column> = columns.map(|column| column.of_other_kind()).collect();
        // Where only pitch of the other kind is present, that is reported.
        let is_head = |head: &Head| {
            self.is_head(head, self.wanted.columns) || (!has_wanted && self.is_head(head, &others))
        };
        self.one_of(grids, is_head)
    }

    /// Whether one of `grids` has a header of a tooth column and a wanted one.
    pub fn is_there(&self, grids: &[Grid]) -> bool {
        let is_head = |head: &Head| self.is_head(head, self.wanted.columns);
        let mut grids = grids.iter();
        grids.any(|grid| Head::find(&grid.lines, self.choice, is_head).is_some())
    }

    fn is_head(&self, head: &Head, wanted: &[Column]) -> bool {
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
    fn is_nearly_head(&self, head: &Head) -> bool {
        let wanted = self.wanted.columns;
        let has = |column: &Column| !head.places_of(*column, self.choice).is_empty();
        head.all().len() > 1
            && (!head.teeth(wanted, self.choice).is_empty() || wanted.iter().any(has))
    }

    /// Whether a line below `head` has numbers in its columns.
    fn has_rows(&self, grid: &Grid, head: &Head) -> bool {
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

    fn one_of<'g>(
        &self,
        grids: &'g [Grid],
        is_head: impl Fn(&Head) -> bool,
    ) -> Option<(&'g Grid, Head)> {
        let choice = self.choice;
        let in_grid = |grid: &'g Grid| Some((grid, Head::find(&grid.lines, choice, &is_head)?));
        let mut found: Vec<_> = grids.iter().filter_map(in_grid).collect();
        if found.is_empty()
            && let ([grid], Some(row)) = (grids, choice.table.header_row)
            && let Some(at) = grid
                .lines
                .iter()
                .position(|line| line.number == u64::from(row))
        {
            // The columns that it lacks are reported.
            return Some((grid, Head::of(&grid.lines, at)));
        }
        if found.is_empty() && choice.table.header_row.is_none() {
            // To report the missing columns is better than "no header".
            let nearly = |head: &Head| self.is_nearly_head(head);
            let in_grid = |grid: &'g Grid| Some((grid, Head::find(&grid.lines, choice, nearly)?));
            let mut nearly = grids.iter().filter_map(in_grid);
            if let (Some(only), None) = (nearly.next(), nearly.next()) {
                return Some(only);
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
        self.file.reading().refuse(self.not_one(grids, &found))
    }

    /// The problem of no grid, or several, with a header.
    fn not_one(&self, grids: &[Grid], found: &[(&Grid, Head)]) -> Problem {
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
                    None => ("no line names".to_owned(), 1),
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
                    let keys = wanted.columns.iter().zip('B'..);
                    let keys = keys.map(|(column, letter)| format!("{} = \"{letter}\"", column.key()));
                    let keys = keys.collect::<Vec<_>>().join(", ");
                    format!("say where they are, by letter or heading: header_row = {row}, tooth_column = \"A\", {keys}")
                };
                file.problem(format!("{what} the columns {columns}{place}"), help)
            }
        }
    }
}

//! `[measured]`: what a rig measured, in a CSV file beside the pair file.

use super::data_file::{DataFile, line_of};
use super::measured_row::{COLUMNS, Fields};
use super::nearest::{is_slip, nearest};
use super::problems::Problems;
use super::spec::MeasuredSpec;
use super::table::Table;
use crate::error::Problem;
use gearlash::analysis::study::MeasuredRow;
use std::collections::{HashMap, HashSet};

pub const KEYS: &[&str] = &["file"];

/// Cells of the file: a million rows of all columns. A file of commas alone would take ten times its size.
const MOST_CELLS: usize = 8_000_000;
/// Columns of which each is asked for its name.
const MOST_COLUMNS: usize = 100;

/// The file and its rows, each with its line.
#[derive(Debug)]
pub struct Measured {
    file: DataFile,
    pub rows: Vec<(u64, MeasuredRow)>,
}

impl Measured {
    /// Reads the file named in `[measured]`.
    pub fn read(
        table: &Table,
        teeth: (Option<u32>, Option<u32>),
        problems: &mut Problems,
    ) -> Option<Measured> {
        let mut measured = Measured {
            file: DataFile::of(table, "the name of a CSV file", problems)?,
            rows: Vec::new(),
        };
        let text = problems.keep(measured.file.text())?;
        let mut bad = Problems::of_list();
        measured.rows = measured.parse(&text, teeth, &mut bad).unwrap_or_default();
        let good = bad.is_empty();
        problems.add_list("measured.file", bad);
        good.then_some(measured)
    }

    /// Each centre distance once, in order of first appearance, with its first line.
    pub fn distances(&self) -> Vec<(u64, f64)> {
        let mut seen = HashSet::new();
        let firsts = self
            .rows
            .iter()
            .map(|(line, row)| (*line, row.center_distance));
        firsts.filter(|(_, mm)| seen.insert(mm.to_bits())).collect()
    }

    /// A warning where two rows say the same of the same mating at the same distance.
    pub fn equal_rows(&self) -> Option<String> {
        let mut seen = HashMap::new();
        let equal = self.rows.iter().filter_map(|(line, row)| {
            let numbers = [row.center_distance, row.right_um, row.left_um].map(f64::to_bits);
            let first = *seen
                .entry((numbers, row.wheel_tooth, row.pinion_tooth))
                .or_insert(*line);
            (first != *line).then_some((first, *line))
        });
        let equal: Vec<(u64, u64)> = equal.collect();
        let (first, second) = *equal.first()?;
        let more = match equal.len() {
            1 => String::new(),
            count => format!(" (and {} more such rows)", count - 1),
        };
        Some(format!(
            "measured.file: lines {first} and {second} have the same values for one mating at one distance{more}: both are used; if a row was copied, remove one"
        ))
    }

    /// The rows.
    pub fn into_rows(self) -> Vec<MeasuredRow> {
        self.rows.into_iter().map(|(_, row)| row).collect()
    }

    /// As in the pair file.
    pub fn spec(&self) -> MeasuredSpec {
        MeasuredSpec {
            file: self.file.name().to_owned(),
        }
    }

    /// A problem of one line.
    pub fn problem_at(&self, line: u64, reason: &str, help: &str) -> Problem {
        self.file.problem_at(line, reason, help)
    }

    fn parse(
        &self,
        text: &str,
        teeth: (Option<u32>, Option<u32>),
        problems: &mut Problems,
    ) -> Option<Vec<(u64, MeasuredRow)>> {
        // Before they are cells; one in quotes counts, too.
        let cells = text.bytes().filter(|b| matches!(b, b',' | b'\n')).count();
        if cells > MOST_CELLS {
            problems.add(self.file.problem(
                format!("has some {cells} cells, allowed are up to {MOST_CELLS}: those of a million rows"),
                "split the file",
            ));
            return None;
        }
        let mut reader = csv::ReaderBuilder::new()
            .flexible(true)
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let headers = problems.keep(reader.headers().cloned().map_err(|error| {
            self.problem_at(
                1,
                &error.to_string(),
                "write the names of the columns there",
            )
        }))?;
        let columns = self.columns(&headers, problems)?;
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = match record {
                Ok(record) => record,
                Err(error) => {
                    problems.add(self.file.problem(error, "correct the line"));
                    break;
                }
            };
            let line = record.position().map_or(0, |start| line_of(text, start));
            if record.len() != headers.len() {
                problems.add(self.problem_at(
                    line,
                    &format!(
                        "{} values, the header names {} columns",
                        record.len(),
                        headers.len()
                    ),
                    "separate values by commas and write numbers with a point",
                ));
                continue;
            }
            let fields = Fields {
                file: &self.file,
                line,
                values: columns.map(|column| record.get(column).unwrap_or_default()),
            };
            rows.extend(fields.row(teeth, problems).map(|row| (line, row)));
        }
        if rows.is_empty() && problems.is_empty() {
            problems.add(
                self.file
                    .problem("no rows, expected at least one", "add what was measured"),
            );
        }
        Some(rows)
    }

    /// Where each of [`COLUMNS`] stands.
    fn columns(&self, headers: &csv::StringRecord, problems: &mut Problems) -> Option<[usize; 8]> {
        let help = "name the columns in line 1, separated by commas, in any order";
        if headers.len() > MOST_COLUMNS {
            problems.add(self.problem_at(
                1,
                &format!(
                    "{} columns, allowed are up to {MOST_COLUMNS}",
                    headers.len()
                ),
                help,
            ));
            return None;
        }
        let headers: Vec<&str> = headers
            .iter()
            .map(|name| match name {
                "centre_distance_mm" => COLUMNS[0],
                name => name,
            })
            .collect();
        for (place, &name) in headers.iter().enumerate() {
            if !COLUMNS.contains(&name) {
                let near = nearest(name, &COLUMNS).filter(|(_, distance)| is_slip(name, *distance));
                let near = near.map_or(String::new(), |(near, _)| format!("did you mean {near}? "));
                problems.add(self.problem_at(
                    1,
                    &format!(
                        "unknown column {}, allowed are {}",
                        self.file.quote(name),
                        COLUMNS.join(", ")
                    ),
                    &format!("{near}{help}"),
                ));
            } else if headers[..place].contains(&name) {
                problems.add(self.problem_at(1, &format!("duplicate column {name}"), "remove one"));
            }
        }
        let places = COLUMNS.map(|name| headers.iter().position(|header| *header == name));
        for (name, _) in COLUMNS
            .iter()
            .zip(places)
            .filter(|(_, place)| place.is_none())
        {
            problems.add(self.problem_at(1, &format!("column {name} is missing"), help));
        }
        let mut columns = [0; 8];
        for (column, place) in columns.iter_mut().zip(places) {
            *column = place?;
        }
        problems.is_empty().then_some(columns)
    }
}

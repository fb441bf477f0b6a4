//! `[measured]`: results of a rig, in a table beside the pair file.

use super::check::Checked;
use super::data_file::DataFile;
use super::sheet::{Choice, Column, Content, Coverage, Found, Quantity, Request, Wanted};
use super::spec::MeasuredSpec;
use super::table::Table;
use gearlash::analysis::study::MeasuredRow;
use std::collections::{HashMap, HashSet};

/// Most cells of a CSV file: those of 250 000 rows.
const MOST_CELLS: usize = 2_000_000;

/// The columns, in any order; a column of sources is allowed, too.
const QUANTITIES: [Quantity; 7] = [
    Quantity::CenterDistance,
    Quantity::WheelTooth,
    Quantity::PinionTooth,
    Quantity::MeasuredRight,
    Quantity::MeasuredLeft,
    Quantity::PredictedMin,
    Quantity::PredictedMax,
];

/// The file and its rows, each with its line.
#[derive(Debug)]
pub struct Measured {
    pub file: DataFile,
    pub rows: Vec<(u64, MeasuredRow)>,
}

impl Measured {
    /// Reads the file named in `[measured]`.
    pub fn read(checked: &Checked, teeth: (Option<u32>, Option<u32>)) -> Option<Measured> {
        checked.is_good("measured").then_some(())?;
        let table = &checked.table().below("measured");
        let file = DataFile::of(table)?;
        let rows = file.list(|| {
            let bytes = file.bytes()?;
            let choice = Choice::default();
            let content = Content::read(&file, (bytes, MOST_CELLS), table, &choice)?;
            let request = Request {
                file: &file,
                choice: &choice,
                wanted: Wanted {
                    columns: &QUANTITIES.map(Column::of),
                    teeth: None,
                    coverage: Coverage::Results {
                        teeth: [teeth.0, teeth.1],
                    },
                },
            };
            rows(table, &content, &request)
        })?;
        Some(Measured { file, rows })
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

    /// A warning where two rows state the same mating at the same distance.
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

    pub fn into_rows(self) -> Vec<MeasuredRow> {
        self.rows.into_iter().map(|(_, row)| row).collect()
    }

    pub fn spec(&self) -> MeasuredSpec {
        MeasuredSpec {
            file: self.file.name().to_owned(),
        }
    }
}

/// The rows of the file, with their lines.
fn rows(table: &Table, content: &Content, request: &Request) -> Option<Vec<(u64, MeasuredRow)>> {
    let file = request.file;
    let Content::Cells(grids) = content else {
        return file.refuse("is a protocol", "name a table of the rig's results");
    };
    let found = Found::find(request, grids)?;
    let rows = found.rows(request)?;
    let remark = |words| format!("{}: {}: left out: {words}", file.key(), file.name());
    let left_out = found.left_out.words(&[]);
    table.reading().add_remark(left_out.map(remark));
    let sources = found.sources(file).into_iter();
    let measured = rows.into_iter().zip(sources).map(|(row, source)| {
        let [
            center_distance,
            wheel_tooth,
            pinion_tooth,
            right_um,
            left_um,
            predicted_min_um,
            predicted_max_um,
        ] = row.values[..]
        else {
            return None;
        };
        let measured = MeasuredRow {
            center_distance,
            wheel_tooth: wheel_tooth as u32,
            pinion_tooth: pinion_tooth as u32,
            right_um,
            left_um,
            predicted_min_um,
            predicted_max_um,
            source,
        };
        Some((row.line, measured))
    });
    measured.collect()
}

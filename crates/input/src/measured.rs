//! `[measured]`: results of a rig, in a table beside the pair file.

use super::spec::MeasuredSpec;
use gearlash::analysis::study::MeasuredRow;
use gearlash_tables::DataFile;
use gearlash_tables::{Column, Coverage, Quantity, Row, Sheet, Wanted};
use gearlash_text::Table;
use std::collections::{HashMap, HashSet};

/// The columns, in any order. The prediction may be absent; a column of sources is allowed, too.
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
pub struct RigResults {
    pub file: DataFile,
    pub rows: Vec<(u64, MeasuredRow)>,
    /// Letter of the first column of numbers that is left out.
    left_out: Option<String>,
}

impl RigResults {
    /// Reads the file named in `[measured]`.
    pub fn read(table: &Table, teeth: (Option<u32>, Option<u32>)) -> Option<RigResults> {
        table.is_good("measured").then_some(())?;
        let columns = QUANTITIES.map(Column::of);
        let wanted = Wanted {
            columns: &columns,
            teeth: None,
            coverage: Coverage::Results {
                teeth: [teeth.0, teeth.1],
            },
        };
        let (file, sheet) = Sheet::read(&table.below("measured"), &wanted)?;
        let unread = sheet.origin.as_ref().map(|origin| &origin.unread);
        let left_out = unread.and_then(|unread| unread.first_number_column(&[]));
        let rows = sheet.rows.into_iter().zip(sheet.sources).map(row);
        let rows = rows.collect::<Option<_>>()?;
        Some(RigResults {
            file,
            rows,
            left_out,
        })
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

    /// A warning where columns may be a prediction by other names.
    pub fn unpredicted(&self) -> Option<String> {
        let is_predicted = |(_, row): &(u64, MeasuredRow)| row.predicted_min_um.is_some();
        let left_out = self
            .left_out
            .as_ref()
            .filter(|_| !self.rows.iter().any(is_predicted))?;
        Some(format!(
            "measured.file: column {left_out} is left out; a predicted band of j_wt is in the columns predicted_min_um and predicted_max_um"
        ))
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

/// A row of the file with its source, and its line.
fn row((row, source): (Row, String)) -> Option<(u64, MeasuredRow)> {
    let [
        center_distance,
        wheel_tooth,
        pinion_tooth,
        right_um,
        left_um,
        ref predicted @ ..,
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
        predicted_min_um: predicted.first().copied(),
        predicted_max_um: predicted.get(1).copied(),
        source,
    };
    Some((row.line, measured))
}

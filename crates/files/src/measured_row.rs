//! One line of a measured file, from text to numbers.

use super::data_file::DataFile;
use super::entry::whole_in;
use super::problems::Problems;
use crate::error::Problem;
use gearlash::analysis::study::MeasuredRow;
use std::ops::RangeInclusive;

/// The columns, all needed, in any order.
pub const COLUMNS: [&str; 8] = [
    "center_distance_mm",
    "wheel_tooth",
    "pinion_tooth",
    "measured_right_um",
    "measured_left_um",
    "predicted_min_um",
    "predicted_max_um",
    "source",
];

/// The values of one line, in the order of [`COLUMNS`].
pub struct Fields<'a> {
    /// The file.
    pub file: &'a DataFile,
    /// The line.
    pub line: u64,
    /// As they stand there.
    pub values: [&'a str; 8],
}

impl Fields<'_> {
    /// The row, each value checked.
    pub fn row(
        &self,
        (wheel, pinion): (Option<u32>, Option<u32>),
        problems: &mut Problems,
    ) -> Option<MeasuredRow> {
        let center_distance = self.number(0, problems).and_then(|mm| {
            let good = (mm > 0.0 && mm <= 1e9).then_some(mm);
            if good.is_none() {
                problems.add(self.problem(0, "a number of mm above 0 and up to 1e9"));
            }
            good
        });
        let wheel_tooth = self.tooth(1, wheel, problems);
        let pinion_tooth = self.tooth(2, pinion, problems);
        let [right, left, min, max] = [3, 4, 5, 6].map(|column| self.number(column, problems));
        let row = MeasuredRow {
            center_distance: center_distance?,
            wheel_tooth: wheel_tooth?,
            pinion_tooth: pinion_tooth?,
            right_um: right?,
            left_um: left?,
            predicted_min_um: min?,
            predicted_max_um: max?,
            source: self.values[7].to_owned(),
        };
        if row.predicted_min_um > row.predicted_max_um {
            problems.add(self.problem(5, "up to predicted_max_um"));
            return None;
        }
        Some(row)
    }

    fn number(&self, column: usize, problems: &mut Problems) -> Option<f64> {
        let number = self.values[column]
            .parse()
            .ok()
            .filter(|n: &f64| n.is_finite());
        if number.is_none() {
            problems.add(self.problem(column, "a finite number"));
        }
        number
    }

    fn tooth(&self, column: usize, teeth: Option<u32>, problems: &mut Problems) -> Option<u32> {
        let range: RangeInclusive<u32> = 1..=teeth.unwrap_or(10_000);
        let tooth = self.values[column].parse().ok();
        let tooth = tooth.filter(|tooth| range.contains(tooth));
        if tooth.is_none() {
            problems.add(self.problem(column, &whole_in(&range)));
        }
        tooth
    }

    fn problem(&self, column: usize, allowed: &str) -> Problem {
        let value = self.file.quote(self.values[column]);
        self.file.problem_at(
            self.line,
            format!("{} is {value}, allowed is {allowed}", COLUMNS[column]),
            "correct the line, or remove it",
        )
    }
}

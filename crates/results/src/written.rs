//! Writes a result: JSON and CSV grow pose by pose, and nothing is kept in memory.

use crate::column::{Row, Value};
use crate::extreme::{extremes, verdict_record};
use crate::fitted;
use crate::json::Json;
use crate::notes;
use crate::pose::PoseRow;
use crate::run::RunRow;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::tally::{Piece, RunTally};
use gearlash::analysis::verdict::Verdict;
use gearlash_files::PairFile;
#[cfg(feature = "rayon")]
use rayon::prelude::*;
use std::io::{Error, Result, Write};

/// The target of a result; it is flushed at the end.
type Out<'w> = Box<dyn Write + 'w>;

/// Writes a result as JSON, as CSV or both, piece by piece.
///
/// JSON ends with a line end; its numbers read back to the same f64. CSV has one row per pose and columns named like the JSON
/// keys; null values are empty.
pub struct ResultWriter<'w> {
    json: Option<Json<Out<'w>>>,
    csv: Option<csv::Writer<Out<'w>>>,
    /// Whether CSV has the columns of pairs that deviate along the face.
    along_face: bool,
}

impl<'w> ResultWriter<'w> {
    /// Begins the result of `file`.
    ///
    /// # Errors
    /// A writer failed, as in all methods of this type.
    pub fn begin(
        file: &PairFile,
        json: Option<Out<'w>>,
        csv: Option<Out<'w>>,
    ) -> Result<ResultWriter<'w>> {
        let mut json = json.map(Json::new);
        if let Some(json) = &mut json {
            json.open_object()?;
            json.entry("gearlash", &env!("CARGO_PKG_VERSION"))?;
            json.entry("pair", &file.spec)?;
            if let Some(notes) = notes::notes(&file.study) {
                json.entry("notes", &notes)?;
            }
            let fitted = fitted::records(file);
            if !fitted.is_empty() {
                json.entry("fitted_involutes", &fitted)?;
            }
            for (key, messages) in [("warnings", &file.warnings), ("remarks", &file.remarks)] {
                if !messages.is_empty() {
                    json.entry(key, &messages)?;
                }
            }
            json.key("runs")?;
            json.open_list()?;
        }
        let along_face = file.study.binds_anywhere();
        let mut csv = csv.map(csv::Writer::from_writer);
        if let Some(csv) = &mut csv {
            let names = PoseRow::columns().csv_names(along_face);
            csv.write_record(names).map_err(of_csv)?;
        }
        Ok(ResultWriter {
            json,
            csv,
            along_face,
        })
    }

    /// Writes the next piece; the poses of a block are converted to text on all cores.
    ///
    /// # Errors
    /// A writer failed.
    pub fn take(&mut self, piece: Piece) -> Result<()> {
        match (piece, &mut self.json) {
            (Piece::Begin(run), Some(json)) => {
                json.element()?;
                json.open_object()?;
                let head = RunRow::columns().object(&RunRow::new(run, 0.0));
                for (key, value) in head.entries().filter(|(key, _)| *key != SUMMARY) {
                    json.entry(key, &value)?;
                }
                json.key("poses")?;
                json.open_list()
            }
            (Piece::End(run), Some(json)) => {
                json.close_list()?;
                let run = RunRow::columns().object(&RunRow::new(run, 0.0));
                json.entry(SUMMARY, &run.get(SUMMARY))?;
                json.close_object()
            }
            (Piece::Begin(_) | Piece::End(_), None) => Ok(()),
            (Piece::Poses(run, poses), _) => self.poses(run, poses),
        }
    }

    fn poses(&mut self, run: &RunTally, poses: &[ComparedPose]) -> Result<()> {
        let layout = self.json.as_ref().map(Json::layout);
        let with_csv = self.csv.is_some();
        let columns = PoseRow::columns();
        #[cfg(feature = "rayon")]
        let each = poses.par_iter();
        #[cfg(not(feature = "rayon"))]
        let each = poses.iter();
        let written: Result<Vec<(Option<String>, Vec<Value>)>> = each
            .map(|pose| {
                let row = PoseRow::of_run(run, pose);
                let json = layout
                    .as_ref()
                    .map(|layout| layout.text(&columns.object(&row)));
                let csv = if with_csv {
                    columns.csv_values(&row, self.along_face)
                } else {
                    Vec::new()
                };
                Ok((json.transpose()?, csv))
            })
            .collect();
        for (text, values) in written? {
            if let (Some(json), Some(text)) = (&mut self.json, text) {
                json.text_element(&text)?;
            }
            if let Some(csv) = &mut self.csv {
                csv.serialize(values).map_err(of_csv)?;
            }
        }
        Ok(())
    }

    /// Ends the result with its verdict and flushes the writers.
    ///
    /// # Errors
    /// A writer failed.
    pub fn finish(self, verdict: &Verdict) -> Result<()> {
        if let Some(mut json) = self.json {
            json.close_list()?;
            json.entry("verdict", &verdict_record(verdict))?;
            json.entry("extremes", &extremes(verdict))?;
            json.close_object()?;
            json.finish()?.flush()?;
        }
        match self.csv {
            Some(mut csv) => csv.flush(),
            None => Ok(()),
        }
    }
}

/// The key of a run's summary.
const SUMMARY: &str = "summary";

/// The writer's own error, where `error` wraps it.
fn of_csv(error: csv::Error) -> Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => Error::other(format!("{other:?}")),
    }
}

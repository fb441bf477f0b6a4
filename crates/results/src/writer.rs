//! Writes a result: JSON and CSV grow pose by pose, and nothing is kept in memory.
//!
//! The JSON is byte for byte the output of `serde_json::to_string_pretty` for the whole.

use crate::column::{Row, Value};
use crate::notes;
use crate::pose::PoseRow;
use crate::run::{RunRow, extremes, verdict_record};
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::tally::{Piece, RunTally};
use gearlash::analysis::verdict::Verdict;
use gearlash_input::PairFile;
use gearlash_text::characters;
#[cfg(feature = "rayon")]
use rayon::prelude::*;
use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::{Formatter, PrettyFormatter};
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
            json.open('{')?;
            json.entry("gearlash", &env!("CARGO_PKG_VERSION"))?;
            json.entry("pair", &file.spec)?;
            if let Some(notes) = notes::notes(&file.study) {
                json.entry("notes", &notes)?;
            }
            for (key, notes) in notes::entries(file) {
                json.entry(key, &notes)?;
            }
            json.begin(Some("runs"))?;
            json.open('[')?;
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
    pub fn take(&mut self, piece: Piece) -> Result<()> {
        match (piece, &mut self.json) {
            (Piece::Begin(run), Some(json)) => {
                json.begin(None)?;
                json.open('{')?;
                let run = RunRow::new(run, 0.0).json();
                let entries = run.as_object().into_iter().flatten();
                for (key, value) in entries.filter(|(key, _)| *key != SUMMARY) {
                    json.entry(key, value)?;
                }
                json.begin(Some("poses"))?;
                json.open('[')
            }
            (Piece::End(run), Some(json)) => {
                json.close(']')?;
                json.entry(SUMMARY, &RunRow::new(run, 0.0).json()[SUMMARY])?;
                json.close('}')
            }
            (Piece::Begin(_) | Piece::End(_), None) => Ok(()),
            (Piece::Poses(run, poses), _) => self.poses(run, poses),
        }
    }

    fn poses(&mut self, run: &RunTally, poses: &[ComparedPose]) -> Result<()> {
        let depth = self.json.as_ref().map(|json| json.empty.len());
        let with_csv = self.csv.is_some();
        let columns = PoseRow::columns();
        #[cfg(feature = "rayon")]
        let each = poses.par_iter();
        #[cfg(not(feature = "rayon"))]
        let each = poses.iter();
        let written: Result<Vec<(Option<String>, Vec<Value>)>> = each
            .map(|pose| {
                let row = PoseRow::of_run(run, pose);
                let json = depth.map(|depth| json_at(depth, &row.object()));
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
    pub fn finish(self, verdict: &Verdict) -> Result<()> {
        if let Some(mut json) = self.json {
            json.close(']')?;
            json.entry("verdict", &verdict_record(verdict))?;
            json.entry("extremes", &extremes(verdict))?;
            json.close('}')?;
            json.out.write_all(b"\n")?;
            json.out.flush()?;
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

/// JSON as it grows. The caller closes every object and list that it opens.
struct Json<W: Write> {
    out: W,
    /// For every open object and list: whether it is still empty.
    empty: Vec<bool>,
}

impl<W: Write> Json<W> {
    fn new(out: W) -> Json<W> {
        let empty = Vec::new();
        Json { out, empty }
    }

    /// Begins an element of a list, or the value of a key.
    fn begin(&mut self, key: Option<&str>) -> Result<()> {
        let depth = self.empty.len();
        let is_first = self.empty.last_mut().map(std::mem::take);
        let comma = if is_first == Some(true) { "" } else { "," };
        write!(self.out, "{comma}\n{:1$}", "", 2 * depth)?;
        key.map_or(Ok(()), |key| write!(self.out, "\"{key}\": "))
    }

    /// Opens an object or a list with its `bracket`.
    fn open(&mut self, bracket: char) -> Result<()> {
        self.empty.push(true);
        write!(self.out, "{bracket}")
    }

    /// Closes it.
    fn close(&mut self, bracket: char) -> Result<()> {
        if self.empty.pop() == Some(false) {
            write!(self.out, "\n{:1$}", "", 2 * self.empty.len())?;
        }
        write!(self.out, "{bracket}")
    }

    /// Writes `key` and its complete value.
    fn entry(&mut self, key: &str, value: &impl Serialize) -> Result<()> {
        self.begin(Some(key))?;
        let text = json_at(self.empty.len(), value)?;
        self.out.write_all(text.as_bytes())
    }

    /// Writes an element whose text [`json_at`] produced.
    fn text_element(&mut self, text: &str) -> Result<()> {
        self.begin(None)?;
        self.out.write_all(text.as_bytes())
    }
}

/// `value` as JSON inside `depth` objects and lists. Unsafe characters occur only inside strings, so each piece can be escaped alone.
fn json_at(depth: usize, value: &impl Serialize) -> Result<String> {
    let mut format = PrettyFormatter::new();
    for _ in 0..depth {
        format.begin_array(&mut std::io::sink())?;
    }
    let mut bytes = Vec::new();
    value.serialize(&mut Serializer::with_formatter(&mut bytes, format))?;
    let text = String::from_utf8(bytes).map_err(Error::other)?;
    Ok(characters::json(text))
}

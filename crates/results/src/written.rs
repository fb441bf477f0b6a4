//! A result on its way out: JSON and CSV grow pose by pose, and nothing of them is kept.

use super::csv_row::Csv;
use super::json::Json;
use super::notes;
use super::records::{PoseRecord, RunHead, pose_record};
use super::summary::summary_record;
use super::verdict_json::{extremes_records, verdict_record};
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::tally::{Piece, whole};
use gearlash::analysis::verdict::Verdict;
use gearlash_files::PairFile;
use rayon::prelude::*;
use std::io::{Error, Result, Write};

/// Where a result goes; it is flushed at the end.
type Out<'w> = Box<dyn Write + 'w>;

/// Writes a result as JSON, as CSV or as both, as its pieces come.
///
/// JSON ends in a line end; numbers read back to the same f64. CSV has a row a pose, columns named like the JSON keys; empty
/// where a value is null.
pub struct ResultWriter<'w> {
    json: Option<Json<Out<'w>>>,
    csv: Option<Csv<Out<'w>>>,
}

impl<'w> ResultWriter<'w> {
    /// Begins the result of `file`.
    ///
    /// # Errors
    /// Of the writers, in all that this type does.
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
            for (key, messages) in [("warnings", &file.warnings), ("remarks", &file.remarks)] {
                if !messages.is_empty() {
                    json.entry(key, messages)?;
                }
            }
            json.key("runs")?;
            json.open_list()?;
        }
        Ok(ResultWriter {
            json,
            csv: csv.map(Csv::new),
        })
    }

    /// Writes the next piece, `Poses` with the text of each made on all cores.
    ///
    /// # Errors
    /// Of the writers.
    pub fn take(&mut self, piece: Piece) -> Result<()> {
        match piece {
            Piece::Begin(run) => match &mut self.json {
                Some(json) => begin_run(json, &RunHead::of(run)),
                None => Ok(()),
            },
            Piece::Poses(run, poses) => {
                let (head, layout) = (RunHead::of(run), self.json.as_ref().map(Json::layout));
                let written: Result<Vec<(PoseRecord, Option<String>)>> = poses
                    .par_iter()
                    .map(|pose| {
                        let record = pose_record(&run.assembly, pose);
                        let text = layout.as_ref().map(|layout| layout.text(&record));
                        Ok((record, text.transpose()?))
                    })
                    .collect();
                for (record, text) in written? {
                    if let (Some(json), Some(text)) = (&mut self.json, text) {
                        json.text_element(&text)?;
                    }
                    if let Some(csv) = &mut self.csv {
                        csv.row(&head, &record)?;
                    }
                }
                Ok(())
            }
            Piece::End(run) => match &mut self.json {
                Some(json) => {
                    json.close_list()?;
                    json.entry("summary", &summary_record(run))?;
                    json.close_object()
                }
                None => Ok(()),
            },
        }
    }

    /// Ends the result with its verdict and flushes the writers.
    ///
    /// # Errors
    /// Of the writers.
    pub fn finish(self, verdict: &Verdict) -> Result<()> {
        if let Some(mut json) = self.json {
            json.close_list()?;
            json.entry("verdict", &verdict_record(verdict))?;
            json.entry("extremes", &extremes_records(verdict))?;
            json.close_object()?;
            json.finish()?.flush()?;
        }
        match self.csv {
            Some(csv) => csv.finish(),
            None => Ok(()),
        }
    }
}

fn begin_run<W: Write>(json: &mut Json<W>, head: &RunHead) -> Result<()> {
    json.element()?;
    json.open_object()?;
    json.entry("center_distance_mm", &head.center_distance_mm)?;
    json.entry("material", &head.material)?;
    if let Some(phase) = &head.phase {
        json.entry("phase", phase)?;
    }
    let angle = head.operating_pressure_angle_deg;
    json.entry("operating_pressure_angle_deg", &angle)?;
    json.key("poses")?;
    json.open_list()
}

/// The whole result of a study whose poses are there already.
#[derive(Debug)]
pub struct ResultFile<'a> {
    file: &'a PairFile,
    runs: &'a [ComparedRun],
    verdict: &'a Verdict<'a>,
}

/// The result of `file` as it is written.
pub fn result_file<'a>(
    file: &'a PairFile,
    runs: &'a [ComparedRun],
    verdict: &'a Verdict<'a>,
) -> ResultFile<'a> {
    ResultFile {
        file,
        runs,
        verdict,
    }
}

impl ResultFile<'_> {
    /// As JSON, one line end at the end. Numbers read back to the same f64.
    ///
    /// # Errors
    /// None: it is written to memory.
    pub fn to_json(&self) -> Result<String> {
        let mut json = Vec::new();
        self.write(Some(Box::new(&mut json)), None)?;
        String::from_utf8(json).map_err(Error::other)
    }

    /// As CSV: a row a pose, columns named like the JSON keys; empty where a value is null.
    ///
    /// # Errors
    /// None: it is written to memory.
    pub fn to_csv(&self) -> Result<String> {
        let mut csv = Vec::new();
        self.write(None, Some(Box::new(&mut csv)))?;
        String::from_utf8(csv).map_err(Error::other)
    }

    fn write(&self, json: Option<Out>, csv: Option<Out>) -> Result<()> {
        let mut writer = ResultWriter::begin(self.file, json, csv)?;
        whole(self.runs, &mut |piece| writer.take(piece))?;
        writer.finish(self.verdict)
    }
}

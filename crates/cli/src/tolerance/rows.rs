//! Each assembly of a run as a row of CSV or Parquet.

use super::parquet::ParquetRows;
use super::results::is_own;
use crate::error::Error;
use crate::output::{NewFile, OutputFolder};
use gearlash::population::{Outcome, OutcomeKind};
use gearlash_files::Sources;
use gearlash_files::numbers::rounded;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Bytes written at a time (tuned).
const PIECE: usize = 1 << 16;

/// The rows so far; nobody sees them until all are there.
pub(super) struct RowsFile {
    /// Of its own; `None` where it goes to the folder of the results.
    folder: Option<OutputFolder>,
    file: RowsWriter,
}

enum RowsWriter {
    Csv(BufWriter<NewFile>),
    Parquet(Box<ParquetRows<NewFile>>),
}

impl RowsFile {
    /// Begins the file at `path`: in the folder of the `results`, or in one that no other run writes to.
    pub fn begin(
        path: &Path,
        sources: &Sources,
        results: Option<(&Path, &mut OutputFolder)>,
    ) -> Result<RowsFile, Error> {
        let name = path.file_name().and_then(|name| name.to_str());
        let is_parquet = |name: &str| name.ends_with(".parquet");
        let Some(name) = name.filter(|name| name.ends_with(".csv") || is_parquet(name)) else {
            return Err(Error::Usage(format!(
                "--rows {}: rows are written as CSV or Parquet; name a file that ends in .csv or .parquet",
                path.display()
            )));
        };
        let parent = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let real = |path: &Path| path.canonicalize().ok();
        let (folder, file, failed) = match results {
            Some((folder, results)) if real(folder).is_some() && real(folder) == real(parent) => {
                // Some file systems know no capital letters.
                if is_own(&name.to_ascii_lowercase()) {
                    return Err(Error::Usage(format!(
                        "--rows {}: the results themselves have a file called {name} there; take another name",
                        path.display()
                    )));
                }
                let file = results.create(name)?;
                (None, file, results.failed(name))
            }
            _ => {
                let own = name.to_owned();
                let mut folder = OutputFolder::prepare(parent, sources, move |name| name == own)?;
                let file = folder.create(name)?;
                let failed = folder.failed(name);
                (Some(folder), file, failed)
            }
        };
        let file = match is_parquet(name) {
            true => ParquetRows::new(file).map(|rows| RowsWriter::Parquet(Box::new(rows))),
            false => {
                let mut file = BufWriter::with_capacity(PIECE, file);
                let begun = file.write_all(b"assembly,outcome,least_um,greatest_um,proven\n");
                begun.map(|()| RowsWriter::Csv(file))
            }
        };
        Ok(RowsFile {
            folder,
            file: file.map_err(failed)?,
        })
    }

    /// Adds a row each.
    pub fn take(&mut self, each: &[(u64, Outcome)]) -> std::io::Result<()> {
        let um = |mm: Option<f64>| mm.map(|mm| rounded(1e3 * mm, 4));
        let text = |um: Option<f64>| um.map_or(String::new(), |um| um.to_string());
        for (number, outcome) in each {
            let word = word(outcome.kind);
            let both = [outcome.least, outcome.greatest].map(um);
            match &mut self.file {
                RowsWriter::Parquet(rows) => rows.add(*number, word, both, outcome)?,
                RowsWriter::Csv(file) => {
                    let [least, greatest] = both.map(text);
                    let proven = outcome.is_proven;
                    writeln!(file, "{number},{word},{least},{greatest},{proven}")?;
                }
            }
        }
        Ok(())
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), Error> {
        match self.file {
            RowsWriter::Csv(mut file) => file.flush(),
            RowsWriter::Parquet(rows) => rows.finish().and_then(|mut file| file.flush()),
        }
        .map_err(Error::Printing)?;
        match self.folder {
            Some(folder) => folder.write(&[]).map(|_| ()),
            None => Ok(()),
        }
    }
}

fn word(kind: OutcomeKind) -> &'static str {
    match kind {
        OutcomeKind::Clear => "clear",
        OutcomeKind::Interference => "interference",
        OutcomeKind::Jammed => "jammed",
        OutcomeKind::OutOfMesh => "out_of_mesh",
        OutcomeKind::Unproven => "unproven",
        OutcomeKind::Impossible => "impossible",
    }
}

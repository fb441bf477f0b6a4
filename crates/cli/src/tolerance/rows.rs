//! Each assembly of a run as a row of CSV or Parquet, and what a file that may be one of rows holds.

use super::parquet::ParquetRows;
use super::results::is_own;
use crate::error::Error;
use crate::output::{GrowingFile, NewFile, OutputFile, OutputFolder};
use gearlash::population::{Outcome, OutcomeKind, Standing};
use gearlash_files::Sources;
use gearlash_files::numbers::rounded;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Bytes written at a time (tuned).
const PIECE: usize = 1 << 16;
/// The first line of a longer file of rows is not looked for (tuned: the headings and a row).
const LONGEST_LINE: u64 = 256;

/// The columns.
const HEADINGS: &str = "assembly,outcome,least_um,greatest_um,proven";

/// The rows so far; nobody sees them until all are there.
pub(super) struct RowsFile {
    /// As the user calls it.
    path: PathBuf,
    /// The number of the first assembly.
    first: u64,
    /// `None` where they go to the folder of the results.
    own: Option<GrowingFile>,
    file: RowsWriter,
}

enum RowsWriter {
    Csv(BufWriter<NewFile>),
    Parquet(Box<ParquetRows<NewFile>>),
}

impl RowsFile {
    /// Begins the file at `path` with the assemblies from number `first` on: in the folder of the `results`, or by itself, beside the files of
    /// other parts.
    pub fn begin(
        path: &Path,
        first: u64,
        sources: &Sources,
        results: Option<(&Path, &mut OutputFolder)>,
    ) -> Result<RowsFile, Error> {
        let wrong = |reason: &str| Error::Usage(format!("--rows {}: {reason}", path.display()));
        let is = |ending| path.extension().is_some_and(|found| found == ending);
        if !(is("csv") || is("parquet")) {
            return Err(wrong(
                "rows are written as CSV or Parquet; name a file that ends in .csv or .parquet",
            ));
        }
        let parent = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let real = |path: &Path| path.canonicalize().ok();
        let results =
            results.filter(|(folder, _)| real(folder).is_some() && real(folder) == real(parent));
        let (own, file) = match results {
            Some((_, results)) => {
                let name = path.file_name().and_then(|name| name.to_str());
                let name = name.ok_or_else(|| {
                    wrong("in the folder of the results a name is UTF-8; take another name, or another folder")
                })?;
                // Some file systems know no capital letters.
                if is_own(&name.to_ascii_lowercase()) {
                    return Err(wrong(&format!(
                        "the results themselves have a file called {name} there; take another name"
                    )));
                }
                replaceable(path, first)?;
                (None, results.create(name)?)
            }
            None => {
                let prepared = OutputFile::prepare(path, sources)?;
                replaceable(path, first)?;
                let (file, own) = prepared.begin()?;
                (Some(own), file)
            }
        };
        let failed = |source| Error::Output {
            path: path.to_path_buf(),
            source,
        };
        let file = match is("parquet") {
            true => ParquetRows::new(file).map(|rows| RowsWriter::Parquet(Box::new(rows))),
            false => {
                let mut file = BufWriter::with_capacity(PIECE, file);
                let begun = writeln!(file, "{HEADINGS}");
                begun.map(|()| RowsWriter::Csv(file))
            }
        };
        Ok(RowsFile {
            path: path.to_path_buf(),
            first,
            own,
            file: file.map_err(failed)?,
        })
    }

    /// Adds a row each.
    pub fn take(&mut self, each: &[(u64, Outcome, Standing)]) -> std::io::Result<()> {
        let um = |mm: Option<f64>| mm.map(|mm| rounded(1e3 * mm, 4));
        let text = |um: Option<f64>| um.map_or(String::new(), |um| um.to_string());
        for (number, outcome, _) in each {
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
        match self.own {
            Some(own) => {
                // Another part may have been done meanwhile.
                replaceable(&self.path, self.first)?;
                own.finish()
            }
            None => Ok(()),
        }
    }
}

/// An error where the file at `path` holds something else than rows from number `first` on.
fn replaceable(path: &Path, first: u64) -> Result<(), Error> {
    let wrong = |reason: String| Err(Error::Usage(format!("--rows {}: {reason}", path.display())));
    match rows_at(path) {
        RowsAt::Rows(number) if number != first && number != 0 => wrong(format!(
            "holds the rows of another part, from assembly {number} on, and this one begins with {first}; name a file of its own for each part"
        )),
        RowsAt::Other => {
            wrong("holds no rows of gearlash, and would be lost; name another file".to_owned())
        }
        RowsAt::Nothing | RowsAt::Rows(_) => Ok(()),
    }
}

/// What a file that may be one of rows holds.
pub(super) enum RowsAt {
    /// There is none.
    Nothing,
    /// Rows of assemblies, the first of which has this number; 0: of none.
    Rows(u64),
    /// Something else.
    Other,
}

/// What the file at `path` holds.
pub(super) fn rows_at(path: &Path) -> RowsAt {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == ErrorKind::NotFound => return RowsAt::Nothing,
        Err(_) => return RowsAt::Other,
    };
    let is = |ending| path.extension().is_some_and(|found| found == ending);
    let first = match (is("csv"), is("parquet")) {
        (true, _) => of_csv(file),
        (_, true) => of_parquet(file),
        _ => None,
    };
    first.map_or(RowsAt::Other, RowsAt::Rows)
}

fn of_csv(file: File) -> Option<u64> {
    let mut lines = BufReader::new(std::io::Read::take(file, LONGEST_LINE)).lines();
    let headings = lines.next()?.ok()?;
    if headings != HEADINGS {
        return None;
    }
    match lines.next() {
        None => Some(0),
        Some(row) => row.ok()?.split(',').next()?.parse().ok(),
    }
}

fn of_parquet(file: File) -> Option<u64> {
    let read = SerializedFileReader::new(file).ok()?;
    let schema = read.metadata().file_metadata().schema_descr_ptr();
    let names: Vec<&str> = schema.columns().iter().map(|one| one.name()).collect();
    if names.join(",") != HEADINGS {
        return None;
    }
    match read.get_row_iter(None).ok()?.next() {
        None => Some(0),
        Some(row) => u64::try_from(row.ok()?.get_long(0).ok()?).ok(),
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

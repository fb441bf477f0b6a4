//! What stands already where a run is going to write, and must not be lost or taken for this run's: pair files that somebody else
//! wrote, rows of another run.

use super::rows::HEADINGS;
use crate::error::Error;
use gearlash::population::WORST;
use gearlash_files::tolerance::{PartHead, is_worst_file, worst_name};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use serde_json::Value;
use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind};
use std::path::{Path, PathBuf};

/// The first line of a longer file of rows is not looked for (tuned: the headings and a row).
const LONGEST_LINE: u64 = 256;

/// What a file that may be one of rows holds.
pub(super) enum Found {
    /// There is none.
    Nothing,
    /// Rows of assemblies, the first of which has this number; 0: of none.
    Rows(u64),
    /// Something else.
    Other,
}

/// An error where results in `folder` would take the place of pair files that no run has written, or stand beside rows of another run than
/// that of `head`; `rows` are replaced.
pub(crate) fn guard(folder: &Path, head: &PartHead, rows: Option<&Path>) -> Result<(), Error> {
    for path in (0..WORST).map(|index| folder.join(worst_name(index))) {
        let is_own = match std::fs::read_to_string(&path) {
            Ok(text) => is_worst_file(&text),
            Err(error) => error.kind() == ErrorKind::NotFound,
        };
        if !is_own {
            return Err(Error::Usage(format!(
                "{}: would be replaced, and is not as gearlash tolerance wrote it; rename it, or name another folder with -o",
                path.display()
            )));
        }
    }
    if is_result_of(folder, head) != Some(false) {
        return Ok(());
    }
    match stale_rows(folder, rows) {
        None => Ok(()),
        Some(path) => Err(Error::Usage(format!(
            "{}: these are the rows of an earlier run, and would stand beside the results of this one; remove them, replace them with --rows, or name another folder with -o",
            path.display()
        ))),
    }
}

/// Whether the result in `folder` is of the run of `head`; `None` where there is none.
fn is_result_of(folder: &Path, head: &PartHead) -> Option<bool> {
    let text = std::fs::read_to_string(folder.join("result.json")).ok()?;
    let result: Value = serde_json::from_str(&text).unwrap_or_default();
    let texts = [
        ("gearlash", &head.gearlash),
        ("input_sha256", &head.input_sha256),
    ];
    let numbers = [("seed", head.seed), ("assemblies", head.assemblies)];
    let same = texts.iter().all(|(key, text)| result[key] == text.as_str())
        && numbers.iter().all(|(key, number)| result[key] == *number);
    Some(same)
}

/// The first file of rows in `folder` that is not `replaced`.
fn stale_rows(folder: &Path, replaced: Option<&Path>) -> Option<PathBuf> {
    let real = |path: &Path| path.canonicalize().ok();
    let replaced = replaced.and_then(real);
    let entries = std::fs::read_dir(folder).ok()?.flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    files.sort();
    files.into_iter().find(|path| {
        let is_replaced = replaced.is_some() && real(path) == replaced;
        !is_replaced && path.is_file() && matches!(found(path), Found::Rows(_))
    })
}

/// What the file at `path` holds.
pub(super) fn found(path: &Path) -> Found {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == ErrorKind::NotFound => return Found::Nothing,
        Err(_) => return Found::Other,
    };
    let is = |ending| path.extension().is_some_and(|found| found == ending);
    let first = match (is("csv"), is("parquet")) {
        (true, _) => of_csv(file),
        (_, true) => of_parquet(file),
        _ => None,
    };
    first.map_or(Found::Other, Found::Rows)
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

//! What stands already where a run is going to write, and must not be lost or taken for this run's: pair files that somebody else
//! wrote, rows of another run.

use super::rows::{RowsAt, rows_at};
use crate::error::Error;
use gearlash::population::WORST;
use gearlash_files::tolerance::{PartHead, is_worst_file, worst_name};
use serde_json::Value;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

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
        !is_replaced && path.is_file() && matches!(rows_at(path), RowsAt::Rows(_))
    })
}

//! Inspection tables in files: each layout gives the study of the same lists written inline, each fault has its line.

pub mod formats;
mod good;
pub mod mutations;
mod oracle;
mod profiles;
mod sheets;
mod shop_books;
mod workbooks;
mod written_book;

use crate::pair_with_table::pair;
use crate::{echo, is_same, mutant};
use gearlash_input::{PairFile, read};
use gearlash_text::Problem;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Reads the pair with `table` as the file `name` beside it.
fn read_with(name: &str, table: &[u8], pair: &str) -> Result<PairFile, Vec<Problem>> {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), table).unwrap();
    let path = folder.path().join("pair.toml");
    fs::write(&path, pair).unwrap();
    read_pair(&path)
}

fn read_pair(path: &Path) -> Result<PairFile, Vec<Problem>> {
    read(path).map_err(|error| {
        assert!(!error.problems.is_empty());
        error.problems
    })
}

/// Reads a good pair with `table` as the file `name` beside it.
fn good(name: &str, table: &[u8], pair: &str) -> PairFile {
    read_with(name, table, pair).unwrap_or_else(|problems| panic!("{problems:#?}"))
}

/// The values of a list of the wheel as understood.
fn echoed(study: &PairFile, table: &str, list: &str) -> Vec<f64> {
    let echo = echo(study);
    let list = echo["wheel"][table][list].as_array().unwrap();
    list.iter().map(|value| value.as_f64().unwrap()).collect()
}

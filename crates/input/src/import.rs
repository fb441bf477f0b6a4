//! The content of a file of a measuring machine, a workbook or a CSV: every table that gearlash reads, its numbers, and the lines
//! of a pair file that name it.
//!
//! Each kind of table is read as for a pair file, so that the lines give the same numbers.

mod read;
mod table;
mod toml;

use gearlash_text::{InputError, Node, Problem, Reading, Sources, Table, characters, source};
use serde::Serialize;
use std::path::Path;
use std::rc::Rc;

pub use table::{ImportedColumn, ImportedTable, Kind, Value};

/// The remedy for a table that no heading explains.
pub const NAME_COLUMNS: &str = "say what it holds and where, by heading or letter: tooth_column, and left and right of a pitch, column of other data";

/// The bytes of the file at `path`.
///
/// # Errors
/// [`InputError`] where it cannot be read.
pub fn bytes(path: &Path) -> Result<Vec<u8>, InputError> {
    source::bytes(path).map_err(|problem| InputError::of(path, vec![problem]))
}

/// Options of an import.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options<'a> {
    /// Only tables of this kind.
    pub only: Option<Kind>,
    /// Keys of the pair file, and their text or whole number.
    pub keys: &'a [(&'static str, String)],
    /// The table of the gear in the file to be written: `wheel`, `pinion` or `gear`.
    pub gear: &'a str,
}

/// The tables of a file.
#[derive(Debug, Clone, Serialize)]
pub struct Imported {
    /// The file's name.
    pub file: String,
    /// At least one.
    pub tables: Vec<ImportedTable>,
    /// Tables that are not read, and why.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_read: Vec<String>,
    /// Lines for a pair file or gear file beside the file.
    pub toml: String,
    /// The files that were read.
    #[serde(skip)]
    pub sources: Sources,
}

impl Imported {
    /// As JSON.
    pub fn to_json(&self) -> String {
        // Names are strings and numbers are finite: nothing that JSON cannot hold.
        characters::json(serde_json::to_string_pretty(self).unwrap_or_default()) + "\n"
    }
}

/// The tables in the `bytes` of the file at `path`: CSV, a workbook, or a text protocol.
///
/// # Errors
/// [`InputError`] with all problems of its tables; keys are those of a pair file.
pub fn tables(path: &Path, bytes: Vec<u8>, options: &Options) -> Result<Imported, InputError> {
    let reading = Rc::new(Reading::of_named());
    let name = path.display().to_string();
    let mut entries = vec![("file".to_owned(), Node::Text(name.clone()))];
    for (key, text) in options.keys {
        let node = match (*key, text.parse()) {
            ("header_row", Ok(row)) => Node::Whole(row),
            _ => Node::Text(text.clone()),
        };
        entries.push(((*key).to_owned(), node));
    }
    let mut not_read = Vec::new();
    let table = Table::new("", &reading, &entries);
    let tables =
        || read::tables(&table, bytes, options.only, &mut not_read).filter(|_| reading.is_good());
    let (tables, problems) = reading.capture_problems(tables);
    let of_file = |problem| of_file(problem, &name);
    match tables {
        Some(tables) if !tables.is_empty() => Ok(Imported {
            not_read: not_read
                .into_iter()
                .map(|problem| of_file(problem).to_string())
                .collect(),
            file: name.clone(),
            toml: toml::lines(&tables, path, options.gear, options.keys),
            tables,
            sources: reading.sources(),
        }),
        _ => {
            // Without a table, the reasons for tables that are not read are the problems. Columns of neither kind of pitch are
            // read as both.
            let mut distinct: Vec<Problem> = Vec::new();
            for problem in problems.into_list().into_iter().chain(not_read) {
                let problem = of_file(problem);
                if !distinct.contains(&problem) {
                    distinct.push(problem);
                }
            }
            Err(InputError::of(path, distinct))
        }
    }
}

/// A problem without key and path, which would name the file again.
fn of_file(problem: Problem, name: &str) -> Problem {
    let reason = problem.reason.strip_prefix(&format!("{name}: "));
    Problem {
        key: problem
            .key
            .strip_prefix("file")
            .unwrap_or(&problem.key)
            .to_owned(),
        value: None,
        reason: reason.unwrap_or(&problem.reason).to_owned(),
        ..problem
    }
}

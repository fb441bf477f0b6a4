//! From a pair file to a [`Study`]: every key of the interface, every problem at once.
//!
//! A file becomes a tree of values (`source`, `node`); each table is read by
//! type and range (`table`, `entry`); what is good goes on to the geometry,
//! whose refusals are traced back to the keys they come from (`faults`).
//! Nothing here computes what a gear is.

mod assembly;
mod entry;
mod faults;
mod gear;
mod measured;
mod measured_row;
mod nearest;
mod node;
mod options;
mod pair_file;
mod per_tooth;
mod pitch;
mod problems;
mod runout;
mod source;
mod stated;
mod sweep;
mod table;
mod thickness;

use crate::error::Error;
use crate::study::Study;
use pair_file::PairFile;
use problems::Problems;
use std::path::Path;

/// The JSON Schema (draft 07) of pair files: every key, its type and range. [`read`] checks more than it can say.
pub const PAIR_SCHEMA: &str = include_str!("pair_schema.json");

/// Reads the pair file at `path`: TOML, or JSON with the same keys.
///
/// # Errors
/// [`Error::Input`] with all problems of the file, each with key, value, what is allowed and what to do.
pub fn read(path: &Path) -> Result<Study, Error> {
    let mut problems = Problems::new();
    let entries = source::text(path).and_then(|text| source::parse(path, &text));
    let study = problems
        .keep(entries)
        .and_then(|entries| PairFile::read(path, &entries, &mut problems).study(&mut problems));
    match study {
        Some(study) if problems.is_empty() => Ok(study),
        _ => Err(Error::Input {
            file: path.to_owned(),
            problems: problems.into_list(),
        }),
    }
}

//! Reading what a command works on.

use super::console::{guard, warn};
use crate::error::Error;
use gearlash_files::{GearsFile, PairFile};
use std::path::Path;

/// The pair file at `path`; its warnings are told.
///
/// # Errors
/// As [`gearlash_files::read`]; [`Error::OverInput`] where what is printed would go into a file that was read.
pub(super) fn pair(path: &Path) -> Result<PairFile, Error> {
    let file = gearlash_files::read(path)?;
    guard(&file.sources)?;
    warn(path, &file.warnings, &file.remarks);
    Ok(file)
}

/// The gears of the file at `path`; its warnings are told.
///
/// # Errors
/// As [`pair`].
pub(super) fn gears(path: &Path) -> Result<GearsFile, Error> {
    let file = gearlash_files::read_gears(path)?;
    guard(&file.sources)?;
    warn(path, &file.warnings, &file.remarks);
    Ok(file)
}

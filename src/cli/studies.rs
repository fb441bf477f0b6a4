//! Reading what a command works on.

use super::console::{guard, warn};
use crate::error::Error;
use crate::input;
use crate::study::{GearsStudy, Study};
use std::path::Path;

/// The pair file at `path`; its warnings are told.
///
/// # Errors
/// As [`input::read`]; [`Error::OverInput`] where what is printed would go into a file that was read.
pub(super) fn pair(path: &Path) -> Result<Study, Error> {
    let study = input::read(path)?;
    guard(&study.sources)?;
    warn(path, &study.warnings, &study.remarks);
    Ok(study)
}

/// The gears of the file at `path`; its warnings are told.
///
/// # Errors
/// As [`pair`].
pub(super) fn gears(path: &Path) -> Result<GearsStudy, Error> {
    let study = input::read_gears(path)?;
    guard(&study.sources)?;
    warn(path, &study.warnings, &study.remarks);
    Ok(study)
}

//! Reads the input of a command.

use super::console::{check_not_input, print, warn};
use crate::error::Error;
use gearlash_files::characters::plain;
use gearlash_files::outlines::{Drawings, OutlineOptions};
use gearlash_files::{GearsFile, InputError, PairFile};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The pair file at `path`; its warnings are reported.
///
/// # Errors
/// As [`gearlash_files::read`]; [`Error::OverInput`] where standard output or error is a file that was read.
pub(super) fn pair(path: &Path) -> Result<PairFile, Error> {
    reported(path, gearlash_files::read(path)?)
}

/// The pair file at `path`, whose gears must be given by their data; its warnings are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn pair_by_data(path: &Path) -> Result<PairFile, Error> {
    reported(path, gearlash_files::read_by_data(path)?)
}

/// The pair of two drawings at a centre distance; its warnings, `warning` first, and notes are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn drawings(drawings: &Drawings, warning: Option<String>) -> Result<PairFile, Error> {
    let mut file = gearlash_files::read_drawings(drawings)?;
    file.warnings.splice(..0, warning);
    let name = PathBuf::from(&file.stem);
    reported(&name, file)
}

/// Checks that standard input is not read twice.
///
/// # Errors
/// [`Error::Usage`].
pub(super) fn check_stdin_once(paths: &[PathBuf]) -> Result<(), Error> {
    let from_stdin = |path: &&PathBuf| path.as_path() == Path::new("-");
    if paths.iter().filter(from_stdin).count() > 1 {
        return Err(Error::usage(
            "- stands for standard input, which holds one pair file: name it once",
        ));
    }
    Ok(())
}

/// Prints the names of the files that were read for `pairs`, one a line.
///
/// # Errors
/// As [`pair`]; [`Error::Usage`] for a name that cannot be printed unchanged.
pub(super) fn print_inputs(
    pairs: impl IntoIterator<Item = Result<PairFile, InputError>>,
) -> Result<ExitCode, Error> {
    let mut lines = String::new();
    for pair in pairs {
        for name in pair?.sources.names() {
            let text = name.to_str().filter(|text| plain(text) == **text);
            let Some(text) = text else {
                let name = plain(&name.to_string_lossy()).to_string();
                let reason = "this name cannot be printed as it is; rename the file";
                return Err(Error::Usage(format!("{name}: {reason}")));
            };
            lines += &format!("{text}\n");
        }
    }
    print(&lines)?;
    Ok(ExitCode::SUCCESS)
}

/// The gears of the file at `path`; its warnings are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn gears(path: &Path) -> Result<GearsFile, Error> {
    reported_gears(path, gearlash_files::read_gears(path)?)
}

/// The gears of the file at `path`, which must be given by their data; its warnings are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn gears_by_data(path: &Path) -> Result<GearsFile, Error> {
    reported_gears(path, gearlash_files::read_gears_by_data(path)?)
}

/// The gear of a drawing; warnings and notes are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn drawing(path: &Path, options: &OutlineOptions) -> Result<GearsFile, Error> {
    reported_gears(path, gearlash_files::read_drawing(path, options)?)
}

/// Reports warnings and notes on the pair `file` at `path`.
fn reported(path: &Path, file: PairFile) -> Result<PairFile, Error> {
    check_not_input(&file.sources)?;
    warn(path, &file.warnings, &file.remarks);
    Ok(file)
}

/// Reports warnings and notes on the gears of the `file` at `path`.
fn reported_gears(path: &Path, file: GearsFile) -> Result<GearsFile, Error> {
    check_not_input(&file.sources)?;
    warn(path, &file.warnings, &file.remarks);
    Ok(file)
}

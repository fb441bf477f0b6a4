//! Reads the input of a command.

use super::console::{check_not_input, print, warn};
use crate::error::Error;
use gearlash_files::characters::plain;
use gearlash_files::outlines::{Drawings, OutlineOptions};
use gearlash_files::{AnyGears, AnyPair, GearsFile, InputError, PairFile, Sources};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The pair file at `path`; its warnings are reported.
///
/// # Errors
/// As [`gearlash_files::read`]; [`Error::OverInput`] where standard output or error is a file that was read.
pub(super) fn pair(path: &Path) -> Result<PairFile, Error> {
    let file = gearlash_files::read(path)?;
    print_error_line(path, &file.sources, &file.warnings, &file.remarks)?;
    Ok(file)
}

/// The pair file at `path`, with gears by data or by outlines; its warnings are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn any(path: &Path) -> Result<AnyPair, Error> {
    let file = gearlash_files::read_any(path)?;
    print_error_line(path, &file.sources, &file.warnings, &file.remarks)?;
    Ok(file)
}

/// The pair of two drawings at a centre distance; its warnings, `warning` first, and notes are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn drawings(drawings: &Drawings, warning: Option<String>) -> Result<AnyPair, Error> {
    let mut file = gearlash_files::read_drawings(drawings)?;
    file.warnings.splice(..0, warning);
    let name = Path::new(&file.stem);
    print_error_line(name, &file.sources, &file.warnings, &file.remarks)?;
    Ok(file)
}

/// Checks that standard input is not read twice.
///
/// # Errors
/// [`Error::Usage`].
pub(super) fn check_stdin_once(paths: &[PathBuf]) -> Result<(), Error> {
    let from_stdin = |path: &&PathBuf| path.as_path() == Path::new("-");
    if paths.iter().filter(from_stdin).count() > 1 {
        return Err(Error::Usage(
            "- stands for standard input, which holds one pair file: name it once".to_owned(),
        ));
    }
    Ok(())
}

/// Prints the names of the files that were read for `pairs`, one a line.
///
/// # Errors
/// As [`pair`]; [`Error::Usage`] for a name that cannot be printed unchanged.
pub(super) fn print_inputs(
    pairs: impl IntoIterator<Item = Result<AnyPair, InputError>>,
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
    let file = gearlash_files::read_gears(path)?;
    print_error_line(path, &file.sources, &file.warnings, &file.remarks)?;
    Ok(file)
}

/// The gears of the file at `path`, by data or by outlines; its warnings are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn any_gears(path: &Path) -> Result<AnyGears, Error> {
    let file = gearlash_files::read_any_gears(path)?;
    print_error_line(path, &file.sources, &file.warnings, &file.remarks)?;
    Ok(file)
}

/// The gear of a drawing; warnings and notes are reported.
///
/// # Errors
/// As [`pair`].
pub(super) fn drawing(path: &Path, options: &OutlineOptions) -> Result<AnyGears, Error> {
    let file = gearlash_files::read_drawing(path, options)?;
    print_error_line(path, &file.sources, &file.warnings, &file.remarks)?;
    Ok(file)
}

/// Reports warnings and notes on the file at `path`; `sources` are the files read.
fn print_error_line(
    path: &Path,
    sources: &Sources,
    warnings: &[String],
    remarks: &[String],
) -> Result<(), Error> {
    check_not_input(sources)?;
    warn(path, warnings, remarks);
    Ok(())
}

//! Reads the input of a command, and limits its poses, in number and bytes, before it begins.

use crate::console::{check_streams_not_input, print, print_note_line, warn};
use crate::error::Error;
use gearlash_input::outlines::Drawings;
use gearlash_input::{MAX_POSES, POSE_BYTES_CSV, POSE_BYTES_JSON, PairFile};
use gearlash_text::characters::plain;
use gearlash_text::{InputError, Problem, Sources, numbers};
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Reports the warnings and notes of the file at `path`. Standard output and error may not be one of its `sources`.
pub(super) fn report(
    path: &Path,
    sources: &Sources,
    warnings: &[String],
    remarks: &[String],
) -> Result<(), Error> {
    check_streams_not_input(sources)?;
    warn(path, warnings, remarks);
    Ok(())
}

/// The `pair` that was read at `path`; its warnings and notes are reported.
pub(super) fn reported(path: &Path, pair: Result<PairFile, InputError>) -> Result<PairFile, Error> {
    let pair = pair?;
    report(path, &pair.sources, &pair.warnings, &pair.remarks)?;
    Ok(pair)
}

/// The pair file at `path`; its warnings and notes are reported.
pub(super) fn pair(path: &Path) -> Result<PairFile, Error> {
    reported(path, gearlash_input::read(path))
}

/// The pair of two drawings at a centre distance; its warnings, `warning` first, and notes are reported.
pub(super) fn drawings(drawings: &Drawings, warning: Option<String>) -> Result<PairFile, Error> {
    let mut file = gearlash_input::read_drawings(drawings)?;
    file.warnings.splice(..0, warning);
    reported(&PathBuf::from(&file.stem), Ok(file))
}

/// Checks that standard input is not read twice.
pub(super) fn check_stdin_once(paths: &[PathBuf]) -> Result<(), Error> {
    let from_stdin = |path: &&PathBuf| path.as_path() == Path::new("-");
    if paths.iter().filter(from_stdin).count() > 1 {
        return Err(Error::usage(
            "- stands for standard input, which holds one pair file: name it once",
        ));
    }
    Ok(())
}

/// Prints the names of the files that were read for `pairs`, each once and one per line. The first pair that cannot be read is the error, after the others.
pub(super) fn print_inputs(
    pairs: impl IntoIterator<Item = Result<PairFile, InputError>>,
) -> Result<u8, Error> {
    let (mut lines, mut names, mut failed) = (String::new(), HashSet::new(), None);
    for pair in pairs {
        let pair = match pair {
            Ok(pair) => pair,
            Err(error) => {
                failed = failed.or(Some(error));
                continue;
            }
        };
        for name in pair.sources.names() {
            let text = name.to_str().filter(|text| plain(text) == **text);
            let Some(text) = text else {
                let name = plain(&name.to_string_lossy()).to_string();
                let reason = "this name cannot be printed as it is; rename the file";
                return Err(Error::Usage(format!("{name}: {reason}")));
            };
            if names.insert(text.to_owned()) {
                lines += &format!("{text}\n");
            }
        }
    }
    print(&lines)?;
    failed.map_or(Ok(0), |error| Err(error.into()))
}

/// Limit of the poses of a command.
pub(super) struct Bound {
    /// Most poses.
    most: u64,
    /// Bytes per pose, and their kind.
    bytes: u64,
    of: &'static str,
    help: &'static str,
}

/// Poses are written and dropped: they take disk space.
pub(super) const STREAMED: Bound = Bound {
    most: MAX_POSES,
    bytes: POSE_BYTES_JSON + POSE_BYTES_CSV,
    of: "result",
    help: "take fewer steps_per_pitch or fractions, or fewer centre distances at a time",
};

/// Poses are held until the command ends, with contacts and formulas: they take memory.
pub(super) const HELD: Bound = Bound {
    most: 2_000_000,
    bytes: 1000,
    of: "memory",
    help: "take fewer steps_per_pitch, fractions or centre distances in a file for this command; simulate and compare go up to 10 million poses",
};

/// An error where `file` asks for more `poses` than `bound` allows.
pub(super) fn allow(file: &Path, poses: u64, bound: &Bound) -> Result<(), Error> {
    if poses <= bound.most {
        return Ok(());
    }
    let Bound {
        most, bytes, of, ..
    } = bound;
    let problem = Problem {
        key: "sweep".to_owned(),
        value: None,
        reason: format!(
            "{poses} poses over all centre distances and materials, about {} of {of}; allowed here are up to {} million, {}",
            numbers::bytes(poses.saturating_mul(*bytes)),
            most / 1_000_000,
            numbers::bytes(most * bytes),
        ),
        help: bound.help.to_owned(),
    };
    Err(InputError::of(file, vec![problem]).into())
}

/// Number of poses from which on number and size are reported (tuned: gigabytes, and minutes of work).
const MANY: u64 = 1_000_000;

/// Reports the size of the result for many `poses`, each of `bytes`; 0 for none.
pub(super) fn report_size(poses: u64, bytes: u64) {
    if poses >= MANY && bytes > 0 {
        let bytes = numbers::bytes(poses.saturating_mul(bytes));
        print_note_line(&format!("note: {poses} poses, about {bytes} of result"));
    }
}

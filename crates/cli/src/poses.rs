//! Limits of the number of poses of a command, in poses and bytes, checked before it begins.

use super::console::print_error_line;
use crate::error::Error;
use gearlash_files::{InputError, MAX_POSES, POSE_BYTES_CSV, POSE_BYTES_JSON, Problem, numbers};
use std::path::Path;

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
    Err(Error::Input(InputError {
        file: file.to_path_buf(),
        problems: vec![Problem {
            key: "sweep".to_owned(),
            value: None,
            reason: format!(
                "{poses} poses over all centre distances and materials, about {} of {of}; allowed here are up to {} million, {}",
                numbers::bytes(poses.saturating_mul(*bytes)),
                most / 1_000_000,
                numbers::bytes(most * bytes),
            ),
            help: bound.help.to_owned(),
        }],
        text: String::new(),
    }))
}

/// Number of poses from which on number and size are reported (tuned: gigabytes, and minutes of work).
const MANY: u64 = 1_000_000;

/// Reports the size of the result for many `poses`, each of `bytes`; 0 for none.
pub(super) fn report_size(poses: u64, bytes: u64) {
    if poses >= MANY && bytes > 0 {
        let bytes = numbers::bytes(poses.saturating_mul(bytes));
        print_error_line(&format!("note: {poses} poses, about {bytes} of result"));
    }
}

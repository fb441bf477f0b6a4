//! The command `gearlash`.

use pyo3::prelude::*;
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the program with its command line `words`, its name first, and returns the exit code. Signals end the process from here
/// on, as with the binary.
#[pyfunction]
pub fn run(py: Python<'_>, words: Vec<OsString>) -> u8 {
    let code = py.detach(|| gearlash_cli::run(words));
    // The standard library can compare exit codes but does not return their number.
    let mut numbers = 0..u8::MAX;
    numbers
        .find(|number| ExitCode::from(*number) == code)
        .unwrap_or(u8::MAX)
}
